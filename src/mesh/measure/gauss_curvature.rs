//! Gauss curvature at vertices by angle defects; zero inside a developable surface.

use crate::math::{Vec3, angle, polygon_corners};
use crate::mesh::{Mesh, Point, Topology};
use std::f64::consts::TAU;

/// Returns the Gauss curvature at each vertex (`#V`) of `mesh` at `positions` (`#V by 3`), in one
/// over squared length: the angle defect of the vertex divided by its share of the area. NaN where
/// it is undefined: on the boundary, without faces, and at edges of zero length.
///
/// Faces of four or more corners count as triangles around the mean of the corners, which includes
/// the curvature of non-planar faces; the corners share the defect at that centre and the area
/// equally. Faces should be convex. [`crate::mesh::curvatures`] gives the curvature of a smooth
/// surface through the vertices.
pub fn gauss_curvature(positions: &[Point], mesh: &Mesh, topology: &Topology) -> Vec<f64> {
    let n = positions.len();
    let (mut defects, mut areas) = (vec![TAU; n], vec![0.0; n]);
    let at = |v: u32| Vec3::from(positions[v as usize]);
    let between = |a: Vec3<f64>, b: Vec3<f64>| angle(a.dot(b), a.cross(b).length());
    for face in mesh.faces.iter() {
        let share = 1.0 / face.len() as f64;
        let centre = face.iter().fold(Vec3::zero(), |sum, &v| sum + at(v)) * share;
        let (mut at_centre, mut area) = (TAU, 0.0);
        for [before, v, after] in polygon_corners(face) {
            let [back, on, inward] = [at(before), at(after), centre].map(|p| p - at(v));
            let around = match face.len() {
                3 => between(back, on),
                _ => between(back, inward) + between(inward, on),
            };
            defects[v as usize] -= around;
            at_centre -= between(-inward, on - inward);
            area += 0.5 * inward.cross(on).length();
        }
        for &v in face {
            areas[v as usize] += area * share;
            defects[v as usize] += if face.len() > 3 { at_centre * share } else { 0.0 };
        }
    }
    for (e, ends) in (0..).zip(topology.edges()) {
        if topology.edge_faces().row(e).len() != 2 {
            ends.iter().for_each(|&v| areas[v as usize] = 0.0);
        }
    }
    let curvature = |(defect, area): (f64, f64)| if area > 0.0 { defect / area } else { f64::NAN };
    defects.into_iter().zip(areas).map(curvature).collect()
}
