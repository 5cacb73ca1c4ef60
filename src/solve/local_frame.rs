//! The frame in which a problem is solved: coordinates relative to the centre of the bounding box
//! at rest, so that site coordinates, far from the origin, do not cost digits.

use crate::constraint::Row;
use crate::mesh::{Mesh, Point, Surface};

/// Returns a point relative to `centre`.
pub(super) fn relative(point: Point, centre: Point) -> Row {
    [point[0] - centre[0], point[1] - centre[1], point[2] - centre[2], 0.0]
}

/// Returns points relative to `centre`, a row for each.
pub(super) fn rows(points: &[Point], centre: Point) -> Vec<Row> {
    points.iter().map(|&point| relative(point, centre)).collect()
}

/// The rest surface, relative to `centre`.
pub(super) fn rest_surface(mesh: &Mesh, centre: Point) -> Surface {
    let around_centre = |p: &Point| std::array::from_fn(|i| p[i] - centre[i]);
    let positions: Vec<Point> = mesh.positions.iter().map(around_centre).collect();
    Surface::for_iterations(&positions, mesh)
}

/// Centre and diagonal of the bounding box, without unused vertices.
pub(super) fn centre_and_extent(mesh: &Mesh) -> (Point, f64) {
    let points = mesh.used_positions();
    let bound = |i: usize, pick: fn(f64, f64) -> f64| points.iter().map(|p| p[i]).reduce(pick);
    let (mut centre, mut squared) = ([0.0; 3], 0.0);
    for i in 0..3 {
        let low = bound(i, f64::min).unwrap_or(0.0);
        let high = bound(i, f64::max).unwrap_or(0.0);
        centre[i] = 0.5 * low + 0.5 * high;
        squared += (high - low) * (high - low);
    }
    (centre, squared.sqrt())
}
