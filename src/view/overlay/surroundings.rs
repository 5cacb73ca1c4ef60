//! The ghost of the model as it was opened and the grid on the ground: lines between points of their own.

use super::ground::Ground;
use glam::DVec3;

/// The ghost and the ground.
#[derive(Clone, Debug, Default)]
pub struct Surroundings {
    /// #V in file coordinates as the mesh was opened; empty where that is not known.
    pub(in crate::view) rest: Vec<DVec3>,
    pub(in crate::view) ghost: bool,
    pub(in crate::view) ground: bool,
    /// The grid, when it is shown and the rest is known.
    pub(in crate::view) grid: Ground,
    /// Lines or points have changed since the last picture.
    pub changed: bool,
}

impl Surroundings {
    /// #V in file coordinates; empty where it is not known.
    pub fn rest(&self) -> &[DVec3] {
        &self.rest
    }

    /// Whether anything is drawn.
    pub fn is_shown(&self) -> bool {
        !self.rest.is_empty() && (self.ghost || self.ground)
    }

    /// From one line of the grid to the next, in the unit of the file; none where none is drawn.
    pub fn grid_step(&self) -> Option<f64> {
        (!self.grid.lines.is_empty()).then_some(self.grid.step)
    }
}
