//! Single panels: laid flat in their least-squares plane, counterclockwise seen from outside; with
//! the joint subtracted, named, sorted into types, cut into pieces, and the order in which they are assembled.

mod alike;
mod assembly;
mod bend;
mod inset;
mod name;
mod polygon;
mod splice;

pub(super) use crate::math::{ears as triangles, triangles_in_space, turn};
pub use alike::panel_types;
pub use assembly::{Stand, assembly_of_nodes, assembly_rows};
pub(super) use bend::{bent_panels, halved};
pub(super) use inset::alike_in_line;
pub use inset::{inset, inset_sides};
pub use name::panel_names;
pub(super) use polygon::{
    are_apart, check_size, direction_of, distance_to_outline, distinct_corners,
    roomiest_point_beside, sides, smallest_box_within,
};
pub use polygon::{hull, is_simple, perimeter, roomiest_point, smallest_box};
pub(super) use splice::{PieceSide, SplicePlate, Spliced, corners, spliced};

use crate::fabricate::surface::PanelSurface;
use crate::math::plane::{Point2, distance};
use crate::math::{PrincipalAxes, Vec3};

/// A panel in its plane. All lengths are in the unit of the mesh.
#[derive(Clone, Debug)]
pub struct FlatPanel {
    /// Its corners, in the order of the surface: with holes, over bridges and back.
    pub corners: Vec<Point2>,
    /// Origin of the plane, near the centre of the box. A corner `(x, y)` is at
    /// `origin + x axes[0] + y axes[1]` in space.
    pub origin: Vec3<f64>,
    /// The axes of the plane.
    pub axes: [Vec3<f64>; 2],
    /// Largest distance of a corner from the plane.
    pub flatness: f64,
    /// Largest change of a distance between two corners.
    pub flattening_error: f64,
}

/// With more pairs of corners than this, only some of the distances around the panel are compared.
const MOST_PAIRS: usize = 1_000_000;

/// Lays a panel flat; none if it has no area.
pub fn lay_flat(surface: &PanelSurface, panel: u32) -> Option<FlatPanel> {
    let outside = surface.normal(panel);
    if outside == Vec3::zero() {
        return None;
    }
    let face = surface.faces.row(panel as usize);
    let points: Vec<Vec3<f64>> = face.iter().map(|&v| surface.at(v)).collect();
    // Each corner once, also at the ends of a bridge.
    let own: Vec<_> = surface.rings(panel).into_iter().flatten().map(|k| points[k]).collect();
    let plane = Plane::of(&own);
    let normal = if plane.normal.dot(outside) < 0.0 { -plane.normal } else { plane.normal };
    // x runs along the first edge.
    let mut along = (1..points.len()).map(|k| points[k] - points[0]);
    let x = along.find_map(|step| (step - normal * step.dot(normal)).length_and_direction().1)?;
    let axes = [x, normal.cross(x)];
    let flat = |point: &Vec3<f64>| {
        let step = *point - plane.centre;
        [step.dot(axes[0]), step.dot(axes[1])]
    };
    let corners: Vec<Point2> = points.iter().map(flat).collect();
    let flattening_error = largest_change(&points, &corners);
    Some(FlatPanel {
        corners,
        origin: plane.centre,
        axes,
        flatness: plane.distance,
        flattening_error,
    })
}

fn largest_change(points: &[Vec3<f64>], corners: &[Point2]) -> f64 {
    let n = points.len();
    let change = |i: usize, j: usize| {
        ((points[i] - points[j]).length() - distance(corners[i], corners[j])).abs()
    };
    let step = (n * (n / 2)).div_ceil(MOST_PAIRS).max(1);
    let around = (1..=n / 2).step_by(step);
    let pairs = around.flat_map(|apart| (0..n).map(move |i| (i, (i + apart) % n)));
    pairs.map(|(i, j)| change(i, j)).fold(0.0, f64::max)
}

/// The least-squares plane of some points.
#[derive(Clone, Copy, Debug)]
struct Plane {
    /// The mean of the points.
    centre: Vec3<f64>,
    /// Unit normal, of either sign.
    normal: Vec3<f64>,
    /// Largest distance of a point from the plane.
    distance: f64,
}

impl Plane {
    /// Fits a plane to at least one point. Collinear points get some plane through them.
    fn of(points: &[Vec3<f64>]) -> Plane {
        let mut own = points.to_vec();
        let centre = crate::math::centre(&mut own);
        let axes = PrincipalAxes::rotate(&mut own);
        let distance = own.iter().map(|point| point.z.abs()).fold(0.0, f64::max) * axes.scale;
        Plane { centre, normal: axes.axes[2], distance }
    }
}

/// The largest distance of some points from their least-squares plane.
pub(in crate::fabricate) fn plane_distance(points: &[Vec3<f64>]) -> f64 {
    Plane::of(points).distance
}
