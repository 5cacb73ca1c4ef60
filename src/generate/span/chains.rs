//! Polylines that together make a closed curve, as the four edges of a patch are drawn.

use crate::math::marked;
use crate::mesh::{Mesh, Point, diagonal, first_of_group};
use std::collections::BTreeMap;

/// Points nearer to each other than this fraction of their extent, of one curve or of the ends of all,
/// are at one place: their numbers were computed in two ways, or rounded.
const ONE_PLACE: f64 = 1e-6;

/// The distance within which points of a curve are at one place.
pub(super) fn one_place(mesh: &Mesh, curve: &[u32]) -> f64 {
    let points: Vec<Point> = curve.iter().map(|&v| mesh.positions[v as usize]).collect();
    ONE_PLACE * diagonal(&points)
}

/// Returns the vertices of the closed curves that several polylines of `mesh` make together, each
/// ending where the next one begins; the first vertex is repeated at the end. Where more than two
/// polylines meet, none goes on.
pub(super) fn closed_chains(mesh: &Mesh) -> Vec<Vec<u32>> {
    let curves: Vec<&[u32]> = mesh.curves.iter().collect();
    // Ends meet at a position: curves rarely share vertices.
    let all: Vec<u32> = curves
        .iter()
        .flat_map(|curve| curve.first().into_iter().chain(curve.last()))
        .copied()
        .collect();
    let near = one_place(mesh, &all);
    if near == 0.0 {
        return Vec::new();
    }
    let is_end = marked(mesh.positions.len(), &all);
    let first = first_of_group(mesh, |v| is_end[v as usize].then_some(0), near);
    let place = |vertex: u32| first[vertex as usize];
    let ends = |curve: &[u32]| Some([place(*curve.first()?), place(*curve.last()?)]);
    let mut meeting: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (k, curve) in curves.iter().enumerate() {
        if let Some([first, last]) = ends(curve).filter(|[first, last]| first != last) {
            meeting.entry(first).or_default().push(k);
            meeting.entry(last).or_default().push(k);
        }
    }
    let next = |at: u32, from: usize| match meeting.get(&at)?[..] {
        [a, b] if a != b => Some(if a == from { b } else { a }),
        _ => None,
    };
    let mut used = vec![false; curves.len()];
    let mut found = Vec::new();
    for start in 0..curves.len() {
        let Some([first, _]) = ends(curves[start]).filter(|[first, last]| first != last) else {
            continue;
        };
        let mut chain: Vec<u32> = Vec::new();
        let mut at = first;
        let mut current = Some(start).filter(|_| !used[start]);
        let mut is_closed = false;
        while let Some(k) = current {
            used[k] = true;
            let mut part = curves[k].to_vec();
            if place(part[0]) != at {
                part.reverse();
            }
            at = place(part[part.len() - 1]);
            chain.extend(part);
            let after = next(at, k);
            is_closed = after == Some(start);
            current = after.filter(|&next| !used[next]);
        }
        if is_closed {
            found.push(chain);
        }
    }
    found
}
