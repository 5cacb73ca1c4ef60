//! Guess of the axis of a mesh that points up, from its extents and the normals of its faces.
//!
//! A surface with a boundary is mostly a roof: the area that it covers along the axis decides. A
//! closed shape stands on flat faces, or is a figure, which is narrowest from front to back.

use super::frame::Extent;
use super::{UnitsAndUp, Up};
use crate::math::{Vec3, marked, twice_vector_area};
use crate::mesh::{Mesh, Point};
use std::borrow::Cow;

/// Least area that a roof covers along the up axis, as a fraction of its own area.
const COVERS: f64 = 0.05;
/// Least ratio of the areas along the two axes that decides between them.
const CLEARLY: f64 = 2.0;
/// Least component of a unit normal for the face to be perpendicular to the axis.
const ALONG: f64 = 0.9;
/// Largest height of a face on the ground, as a fraction of the total height.
const GROUND: f64 = 0.03;
/// Least fraction of its area that a closed building has on the ground, with z up.
const BUILT: f64 = 0.03;
/// The same for a closed shape that stands with y up.
const STANDS: f64 = 0.015;
/// Largest height of a vertex on the ground, as a fraction of the total height.
const TOUCHES: f64 = 1e-3;
/// A shape lies flat if its height is at most this fraction of both its other extents.
const LYING: f64 = 0.5;
/// A figure's extent from front to back is at most this fraction of both its other extents.
const ACROSS: f64 = 0.8;

impl UnitsAndUp {
    /// Guesses the axis that points up: z, unless the mesh suggests otherwise.
    pub fn guess_up(mesh: &Mesh) -> Up {
        let points = points(mesh);
        let [x, y, z] = [0, 1, 2].map(|axis| Extent::of(points.iter().copied(), axis));
        let surface = Areas::of(mesh, [&y, &z]);
        let [covers_y, covers_z] = surface.net.map(f64::abs);
        if covers_y.max(covers_z) > COVERS * surface.total {
            if covers_z > CLEARLY * covers_y {
                return Up::Z;
            }
            if covers_y > CLEARLY * covers_z {
                return Up::Y;
            }
        }
        let [x, y, z] = [&x, &y, &z].map(Extent::length);
        let within = |part: f64, height: f64, others: [f64; 2]| {
            others.iter().all(|side| height <= part * side)
        };
        let is_tower = within(LYING, x, [z, z]) && within(LYING, y, [z, z]);
        if within(LYING, z, [x, y]) || is_tower {
            return Up::Z;
        }
        if within(LYING, y, [x, z]) {
            return Up::Y;
        }
        let [on_y, on_z] = surface.on_ground;
        let is_closed =
            surface.total > 0.0 && surface.net.iter().all(|net| net.abs() < 1e-6 * surface.total);
        if is_closed {
            let stands = on_y > CLEARLY * on_z && on_y > STANDS * surface.total;
            let figure = within(ACROSS, z, [x, y]);
            return if on_z < BUILT * surface.total && (stands || figure) { Up::Y } else { Up::Z };
        }
        let [touch_y, touch_z] = [1, 2].map(|axis| touching(&points, axis));
        if touch_y >= 2 * touch_z { Up::Y } else { Up::Z }
    }
}

#[derive(Default)]
struct Areas {
    total: f64,
    /// The area that the surface covers, signed; 0 if it is closed.
    net: [f64; 2],
    /// Area of the faces perpendicular to the axis at the lower end of the extent.
    on_ground: [f64; 2],
}

impl Areas {
    fn of(mesh: &Mesh, extents: [&Extent; 2]) -> Areas {
        let mut areas = Areas::default();
        for face in mesh.faces.iter() {
            let corners = || face.iter().map(|&v| Vec3::from(mesh.positions[v as usize]));
            let area = twice_vector_area(corners()) * 0.5;
            let size = area.length();
            areas.total += size;
            for (k, (along, extent)) in [area.y, area.z].into_iter().zip(extents).enumerate() {
                areas.net[k] += along;
                let heights = corners().map(|corner| [corner.y, corner.z][k]);
                let highest = heights.fold(f64::NEG_INFINITY, f64::max);
                let is_low = highest <= extent.low + GROUND * extent.length();
                if along.abs() > ALONG * size && is_low {
                    areas.on_ground[k] += size;
                }
            }
        }
        areas
    }
}

/// Returns the vertices of faces; all vertices if there are no faces.
fn points(mesh: &Mesh) -> Cow<'_, [Point]> {
    if mesh.faces.is_empty() {
        return Cow::Borrowed(&mesh.positions);
    }
    let is_corner = marked(mesh.positions.len(), mesh.faces.indices());
    let all = mesh.positions.iter().zip(is_corner);
    all.filter_map(|(&point, is_corner)| is_corner.then_some(point)).collect()
}

/// Counts the points on the ground if this axis points up.
fn touching(points: &[Point], axis: usize) -> usize {
    let extent = Extent::of(points.iter().copied(), axis);
    let limit = extent.low + TOUCHES * extent.length();
    points.iter().filter(|point| point[axis] <= limit).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(positions: Vec<Point>) -> Mesh {
        Mesh { positions, ..Mesh::default() }
    }

    fn corners(sides: Point) -> Vec<Point> {
        (0..8).map(|i| [0, 1, 2].map(|axis| sides[axis] * f64::from(i >> axis & 1))).collect()
    }

    fn solid(sides: Point) -> Mesh {
        let faces =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        Mesh { faces: faces.into_iter().collect(), ..points(corners(sides)) }
    }

    #[test]
    fn points_that_lie_and_points_that_stand() {
        assert_eq!(UnitsAndUp::guess_up(&points(corners([20.0, 15.0, 4.0]))), Up::Z);
        assert_eq!(UnitsAndUp::guess_up(&points(corners([20.0, 4.0, 15.0]))), Up::Y);
        assert_eq!(UnitsAndUp::guess_up(&points(corners([4.0, 4.0, 30.0]))), Up::Z);
        // A pyramid whose square lies in the plane of x and z.
        let mut tower = corners([4.0, 0.0, 4.0]);
        tower.push([2.0, 30.0, 2.0]);
        assert_eq!(UnitsAndUp::guess_up(&points(tower)), Up::Y);
        assert_eq!(UnitsAndUp::guess_up(&points(Vec::new())), Up::Z);
    }

    /// Below it, they decided between the axes, though its extent did not count them.
    #[test]
    fn points_beside_a_surface_do_not_turn_it() {
        // A roof at 45 degrees, whose areas and extents are the same along both axes.
        let roof = vec![[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [9.0, 6.0, 6.0], [0.0, 6.0, 6.0]];
        let mut roof = Mesh { faces: [[0, 1, 2, 3]].into_iter().collect(), ..points(roof) };
        assert_eq!(UnitsAndUp::guess_up(&roof), Up::Z);
        roof.positions.extend((0..5).map(|k| [f64::from(k), -1.0, 3.0]));
        assert_eq!(UnitsAndUp::guess_up(&roof), Up::Z);
    }

    #[test]
    fn a_roof_covers_the_ground_and_a_solid_stands_on_it() {
        // A box without one side, which is below.
        for (sides, open, up) in
            [([4.0, 4.0, 9.0], 0, Up::Z), ([9.0, 9.0, 4.0], 2, Up::Y), ([9.0, 4.0, 9.0], 2, Up::Y)]
        {
            let whole = solid(sides);
            let kept = whole.faces.iter().enumerate().filter(|(f, _)| *f != open);
            let house = Mesh { faces: kept.map(|(_, face)| face).collect(), ..whole.clone() };
            assert_eq!(UnitsAndUp::guess_up(&house), up, "{sides:?} {open}");
        }
        // A closed box is ambiguous: z is the default.
        for sides in [[20.0, 15.0, 9.0], [4.0, 4.0, 30.0], [1.0, 1.0, 1.0], [20.0, 15.0, 1.0]] {
            assert_eq!(UnitsAndUp::guess_up(&solid(sides)), Up::Z, "{sides:?}");
        }
    }
}
