//! How developable a surface is: its Gauss curvature at vertices, by angle defects, which is zero
//! inside a developable surface; and strips of quads unrolled into the plane.

use crate::math::{Vec3, angle_between, mean, polygon_corners};
use crate::mesh::{Mesh, Point, Topology};
use std::f64::consts::TAU;

/// A strip of quads unrolled into the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct UnrolledStrip {
    /// Number of quads.
    pub quads: usize,
    /// Whether the strip is closed; it is then cut open at its first edge.
    pub closed: bool,
    /// Outline: along the left side and back along the right side, in either orientation.
    pub outline: Vec<[f64; 2]>,
}

impl UnrolledStrip {
    /// Unrolls a strip (`l0 r0 l1 r1 ...`, as from [`strips`](crate::mesh::strips)) at `positions`
    /// (`#V by 3`). Each quad is placed beside the previous one, by the coordinates of its corners
    /// relative to the edge between them; planar quads are not stretched. `None` if a crossed edge
    /// has no length.
    pub fn new(positions: &[Point], strip: &[u32], topology: &Topology) -> Option<UnrolledStrip> {
        let (edges, _) = strip.as_chunks::<2>();
        let (first, last) = (edges.first()?, edges.last()?);
        let faces = |&[l, r]: &[u32; 2]| {
            topology.edge(l, r).map_or(&[][..], |e| topology.edge_faces().row(e as usize))
        };
        // The ends of an open strip can be joined by edges without a quad between them.
        let is_shared = faces(first).iter().any(|face| faces(last).contains(face));
        let meet = |v: &u32| {
            !first.contains(v) && first.iter().any(|&w| topology.body_edge(*v, w).is_some())
        };
        let closed = edges.len() > 2 && is_shared && last.iter().all(meet);
        let at = |v: u32| Vec3::from(positions[v as usize]);
        let mut around = edges.to_vec();
        if closed {
            // In a twisted band, the first edge comes back reversed.
            let twisted = topology.body_edge(first[0], last[0]).is_none();
            around.push(if twisted { [first[1], first[0]] } else { *first });
        }
        let mut flat = [[0.0, 0.0], [(at(first[1]) - at(first[0])).length(), 0.0]];
        let mut sides = flat.map(|corner| vec![corner]);
        for pair in around.windows(2) {
            let [before, after] = pair else { continue };
            let across = at(before[1]) - at(before[0]);
            let length = across.length();
            if length == 0.0 {
                return None;
            }
            let across = across * (1.0 / length);
            let [[x, y], [to_x, to_y]] = flat;
            let [c, s] = [(to_x - x) / length, (to_y - y) / length];
            flat = after.map(|v| {
                let way = at(v) - at(before[0]);
                let along = way.dot(across);
                let ahead = (way - across * along).length();
                [x + c * along - s * ahead, y + s * along + c * ahead]
            });
            sides.iter_mut().zip(flat).for_each(|(side, corner)| side.push(corner));
        }
        let [mut outline, right] = sides;
        outline.extend(right.into_iter().rev());
        Some(UnrolledStrip { quads: around.len() - 1, closed, outline })
    }
}

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
    let between = |a, b| angle_between(a, b).unwrap_or(f64::NAN);
    for face in mesh.faces.iter() {
        let share = 1.0 / face.len() as f64;
        let centre = mean(face.iter().map(|&v| at(v)));
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
        if topology.is_of_body(e) && topology.edge_faces().row(e as usize).len() != 2 {
            ends.iter().for_each(|&v| areas[v as usize] = 0.0);
        }
    }
    let curvature = |(defect, area): (f64, f64)| if area > 0.0 { defect / area } else { f64::NAN };
    defects.into_iter().zip(areas).map(curvature).collect()
}
