//! The ghost of the mesh as it was opened and the ground grid, as lines between their own points.

use super::ground::Ground;
use glam::DVec3;

/// The ghost and the ground.
#[derive(Clone, Debug, Default)]
pub struct Surroundings {
    /// Positions of the mesh as it was opened, #V in file coordinates; empty if not known.
    pub(in crate::view) rest: Vec<DVec3>,
    pub(in crate::view) ghost: bool,
    pub(in crate::view) ground: bool,
    /// The grid, if it is shown and the rest positions are known.
    pub(in crate::view) grid: Ground,
    /// Whether lines or points have changed since the last picture.
    pub changed: bool,
}

impl Surroundings {
    /// Returns the rest positions, #V in file coordinates; empty if not known.
    pub fn rest(&self) -> &[DVec3] {
        &self.rest
    }

    /// Returns the spacing of the grid, in the unit of the file; none if it is not drawn.
    pub fn grid_step(&self) -> Option<f64> {
        (!self.grid.lines.is_empty()).then_some(self.grid.step)
    }
}
