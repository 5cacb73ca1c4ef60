//! The contents of a view (mesh, handles, shapes, projections, tape) and its look (colours, marks,
//! theme, switches).

use super::parts::{Display, HandleMark};
use crate::view::appearance::Appearance;
use crate::view::model::{Checks, ProjectionMarks, RenderMesh};

/// The mesh and the marks on it.
#[derive(Debug, Default)]
pub(super) struct Content {
    pub(super) mesh: RenderMesh,
    /// `#E by 2`: the edges that can be picked and selected.
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) handles: Vec<HandleMark>,
    /// Fitted shapes in view coordinates, [`super::SHAPE_NUMBERS`] numbers each.
    pub(super) shapes: Vec<f32>,
    pub(super) projections: ProjectionMarks,
    pub(super) checks: Checks,
    /// Sides of the faces that a flat map flips: `#sides by 2`.
    pub(super) flipped: Vec<[u32; 2]>,
    pub(super) tape: Vec<u32>,
}

/// Colours, marks, theme and switches.
#[derive(Debug)]
pub(super) struct Look {
    pub(super) appearance: Appearance,
    /// The colour of marked members of a constraint, three components from 0 to 1.
    pub(super) tint: [f32; 3],
    pub(super) display: Display,
    pub(super) dark: bool,
    /// A grey background for figures, instead of that of the theme.
    pub(super) ground: Option<f32>,
    /// Strength of the ambient occlusion, from 0 to 1.
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
