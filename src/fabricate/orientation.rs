//! Which panels to reverse so that all face the same side.

use super::fault::Fault;
use crate::math::polygon_sides;
use crate::mesh::{Ragged, Topology};

/// The corners of a face backwards. Its first side stays the first one, to which arrows point and
/// from which rotations and strips are counted.
pub(super) fn reversed(face: &[u32]) -> Vec<u32> {
    let (first, rest) = face.split_at(face.len().min(2));
    first.iter().rev().chain(rest.iter().rev()).copied().collect()
}

/// The faces to reverse so that neighbours traverse their edge in opposite directions, and why that
/// is impossible. In each component the minority is reversed.
pub(super) fn orientation(faces: &Ragged, topology: &Topology) -> (Vec<bool>, Option<Fault>) {
    let mut state: Vec<Option<bool>> = vec![None; faces.len()];
    let mut contradiction = None;
    let crowded = topology.edge_faces().iter().filter(|faces| faces.len() > 2).count();
    for first in 0..faces.len() as u32 {
        if state[first as usize].is_some() {
            continue;
        }
        state[first as usize] = Some(false);
        let mut part = vec![first];
        let mut next = 0;
        while let Some(&f) = part.get(next) {
            next += 1;
            let turned = state[f as usize] == Some(true);
            for [a, b] in polygon_sides(faces.row(f as usize)) {
                let Some(e) = topology.edge(a, b) else { continue };
                let &[g, h] = topology.edge_faces().row(e as usize) else { continue };
                let other = if g == f { h } else { g };
                if other == f {
                    continue;
                }
                let ascends = topology.edge_ascends(e);
                let needed = turned ^ (ascends[0] == ascends[1]);
                match state[other as usize] {
                    None => {
                        state[other as usize] = Some(needed);
                        part.push(other);
                    }
                    Some(found) if found != needed => {
                        contradiction = Some(topology.edges()[e as usize]);
                    }
                    Some(_) => {}
                }
            }
        }
        let turned = part.iter().filter(|&&f| state[f as usize] == Some(true)).count();
        if 2 * turned > part.len() {
            part.iter().for_each(|&f| state[f as usize] = state[f as usize].map(|own| !own));
        }
    }
    let fault = match (contradiction, crowded) {
        (Some(ends), _) => Some(Fault::one_sided(ends)),
        (None, 0) => None,
        (None, edges) => Some(Fault::crowded_edges(edges)),
    };
    (state.into_iter().map(|turned| turned == Some(true)).collect(), fault)
}
