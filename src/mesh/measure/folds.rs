//! Faces that a deformation has folded over.

use super::dihedral::{Neighbours, unit_normals};
use crate::math::Vec3;
use crate::mesh::{Mesh, Point, Topology};

/// Cosine of the least angle between the normals of two faces folded onto each other: 120 degrees.
const FOLDED: f64 = -0.5;
/// Cosine of the greatest angle between them before: 80 degrees. Sharper edges are intended.
const SMOOTH: f64 = 0.17;
/// Least sine of the turn at a corner, before and after, for a change of its sign to count.
const TURN: f64 = 0.1;

/// Returns the faces, ascending, that are folded over at `now` (`#V by 3`) and not at the positions
/// of the mesh: both faces of an edge whose normals are more than 120 degrees apart, and faces with
/// a corner that turns the other way, so that the outline crosses itself or has a dent.
pub fn folded_faces(mesh: &Mesh, topology: &Topology, now: &[Point]) -> Vec<u32> {
    let [before, after] = [&mesh.positions[..], now].map(|at| unit_normals(&mesh.faces, at));
    let mut is_folded: Vec<bool> = (0..mesh.faces.len())
        .map(|f| {
            let corners = mesh.faces.row(f);
            let turned = |at, normal| turns(corners, at, normal);
            let pairs = turned(&mesh.positions, before[f]).zip(turned(now, after[f]));
            let mut reversed = pairs.filter(|(was, is)| was * is < 0.0);
            reversed.any(|(was, is)| was.abs() > TURN && is.abs() > TURN)
        })
        .collect();
    for pair in Neighbours::all(mesh, topology) {
        if pair.cosine(&before) > SMOOTH && pair.cosine(&after) < FOLDED {
            pair.faces.iter().for_each(|&face| is_folded[face as usize] = true);
        }
    }
    (0..).zip(is_folded).filter(|(_, is_folded)| *is_folded).map(|(face, _)| face).collect()
}

/// Returns the sine of the turn at each corner, positive for a left turn seen from the tip of the
/// normal.
fn turns(corners: &[u32], at: &[Point], normal: Vec3<f64>) -> impl Iterator<Item = f64> {
    let n = corners.len();
    let place = move |k: usize| Vec3::from(at[corners[k % n] as usize]);
    (0..n).map(move |k| {
        let [into, out] = [place(k) - place(k + n - 1), place(k + 1) - place(k)];
        let lengths = into.length() * out.length();
        if lengths > 0.0 { into.cross(out).dot(normal) / lengths } else { 0.0 }
    })
}
