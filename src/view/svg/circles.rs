//! The fitted circles of a line drawing.

use crate::view::state::{SHAPE_NUMBERS, ViewState};
use glam::Vec3;

/// A circle of the scene: centre, and two perpendicular radii.
pub(super) struct Circle {
    pub centre: Vec3,
    pub radii: [Vec3; 2],
}

/// Returns the fitted circles of the scene.
pub(super) fn fitted(state: &ViewState) -> impl Iterator<Item = Circle> + '_ {
    let shapes = state.shapes().chunks_exact(SHAPE_NUMBERS);
    shapes.filter(|shape| shape[0] == 0.0).map(|shape| {
        let normal = Vec3::from_slice(&shape[4..7]);
        let u = normal.any_orthonormal_vector() * shape[7];
        Circle { centre: Vec3::from_slice(&shape[1..4]), radii: [u, normal.cross(u)] }
    })
}
