//! The surface inside a closed curve: a Coons patch between four corners.

use super::loft::turn_up;
use super::{SpanCurve, SpanError, evenly, length_of};
use crate::generate::quads::{check_face_count, quads};
use crate::generate::sides::coons_patch;
use crate::math::{Vec3, argsort, key_of_number, twice_vector_area};
use crate::mesh::{Mesh, Point, Topology};

/// Quads of about `size` inside a closed curve, counterclockwise seen from `up`. Corners of the
/// patch are its four sharpest corners; if it has fewer, points at quarters of its length from its
/// first corner. The boundary has equal steps, and keeps further corners.
///
/// # Errors
/// A size that is not a positive length, an open curve, too many faces, or a folded surface.
pub fn fill(curve: &SpanCurve, size: f64, up: Point) -> Result<Mesh, SpanError> {
    if !(size > 0.0 && size.is_finite()) {
        return Err(SpanError::Size(size));
    }
    if !curve.closed {
        return Err(SpanError::Open);
    }
    let sides = four_sides(curve);
    let lengths = sides.each_ref().map(|side| length_of(&side.0));
    let count = |a: f64, b: f64| (0.5 * (a + b) / size).round().max(1.0);
    let [along, across] = [count(lengths[0], lengths[2]), count(lengths[1], lengths[3])];
    check_face_count(along * across).map_err(SpanError::TooManyFaces)?;
    let counts = [along as usize, across as usize];
    let [south, east, north, west] = [0, 1, 2, 3].map(|k| {
        let (points, corners) = &sides[k];
        let (points, _) = evenly(points, corners, counts[k % 2]);
        points.into_iter().map(Point::from).collect::<Vec<_>>()
    });
    let positions = coons_patch(&south, &east, &north, &west);
    let mut mesh = Mesh { positions, faces: quads(counts, false).collect(), ..Mesh::default() };
    turn_up(&mut mesh, up);
    if is_folded(&mesh) { Err(SpanError::Folded) } else { Ok(mesh) }
}

/// The points of the four sides from corner to corner, and the indices of further corners on each.
fn four_sides(curve: &SpanCurve) -> [(Vec<Vec3<f64>>, Vec<usize>); 4] {
    let sharp = curve.corners();
    let n = curve.points.len();
    // Sharpest first; ties in the order of the curve.
    let order = argsort(sharp.iter().map(|&(_, turn)| !key_of_number(turn)));
    let mut ends: Vec<usize> = order.iter().take(4).map(|&k| sharp[k as usize].0).collect();
    let mut points = curve.points.clone();
    let mut corners: Vec<usize> = sharp.iter().map(|&(k, _)| k).collect();
    if ends.len() < 4 {
        let first = corners.first().copied().unwrap_or(0);
        points.rotate_left(first);
        let mut ring = points.clone();
        ring.push(points[0]);
        corners.iter_mut().for_each(|k| *k = (*k + n - first) % n);
        corners.sort_unstable();
        // At least as many points as before, with the quarters among them.
        let quarter = n.div_ceil(4);
        (points, corners) = evenly(&ring, &corners, 4 * quarter);
        points.pop();
        ends = (0..4).map(|k| k * quarter).collect();
    }
    ends.sort_unstable();
    let n = points.len();
    let mut is_corner = vec![false; n];
    corners.iter().for_each(|&k| is_corner[k] = true);
    [0, 1, 2, 3].map(|k| {
        let (from, to) = (ends[k], ends[(k + 1) % 4]);
        let steps = (to + n - from) % n;
        let side = (0..=steps).map(|step| points[(from + step) % n]).collect();
        (side, (1..steps).filter(|step| is_corner[(from + step) % n]).collect())
    })
}

/// Whether the two faces at some edge face opposite ways.
fn is_folded(mesh: &Mesh) -> bool {
    let area = |face: u32| {
        let corners = mesh.faces.row(face as usize).iter();
        twice_vector_area(corners.map(|&v| Vec3::from(mesh.positions[v as usize])))
    };
    let topology = Topology::new(mesh);
    topology.edge_faces().iter().any(|faces| match *faces {
        [a, b] => area(a).dot(area(b)) <= 0.0,
        _ => false,
    })
}
