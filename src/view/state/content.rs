//! The contents of a view: mesh, handles, shapes, projections, tape; and how they look: colours and marks of faces,
//! theme, switches.

use super::parts::{Display, HandleMark};
use crate::view::appearance::Appearance;
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

/// Colours, marks, theme and switches.
#[derive(Debug)]
pub(super) struct Look {
    pub(super) appearance: Appearance,
    /// The colour of the members of a constraint, three parts from 0 to 1.
    pub(super) tint: [f32; 3],
    pub(super) display: Display,
    pub(super) dark: bool,
    /// A grey behind everything, for figures, instead of the colours of the theme.
    pub(super) ground: Option<f32>,
    /// How much of it is seen that what is near keeps light off, from 0 to 1.
    pub(super) occlusion: f32,
}

impl Default for Look {
    fn default() -> Self {
        Look {
            appearance: Appearance::default(),
            tint: [0.2, 0.7, 0.3],
            display: Display { edges: true, ..Display::default() },
            dark: false,
            ground: None,
            occlusion: 0.0,
        }
    }
}
