//! The contents of a view: mesh, handles, shapes, projections, tape.

use super::parts::HandleMark;
use crate::view::model::{Checks, ProjectionMarks, RenderMesh};

/// The mesh and what is marked on it.
#[derive(Debug, Default)]
pub(super) struct Content {
    pub(super) mesh: RenderMesh,
    /// `#E by 2`: the edges that can be picked and selected.
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) handles: Vec<HandleMark>,
    /// In view coordinates, [`super::SHAPE_NUMBERS`] each.
    pub(super) shapes: Vec<f32>,
    pub(super) projections: ProjectionMarks,
    pub(super) checks: Checks,
    /// `#sides by 2`
    pub(super) flipped: Vec<[u32; 2]>,
    /// The ends of the measuring tape: none, the first, or both.
    pub(super) tape: Vec<u32>,
}
