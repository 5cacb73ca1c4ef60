//! Repair of extracted cells: faces that are not quads become quads, without new vertices as far as
//! possible.
//!
//! Around flipped triangles lines of the grid are lost, and faces are larger there. Those of an even
//! number of sides are divided. The others come in pairs, since every edge has two sides: they are
//! joined with the quads between two of them, which gives an even one.

mod joined;
mod panels;
mod quadrangulate;
mod trim;

use super::extract::Node;
use joined::join_odd;
use panels::Panels;
use quadrangulate::quadrangulate;
pub(super) use trim::trim;

/// Faces after repair.
#[derive(Clone, Debug, Default)]
pub(super) struct Repaired {
    /// Counterclockwise, as indices of nodes.
    pub(super) faces: Vec<Vec<usize>>,
    /// The faces that were replaced, as they were before.
    pub(super) replaced: Vec<Vec<usize>>,
}

/// Replaces faces that are not quads. Those that cannot be replaced remain.
///
/// `is_trimmed` says of which faces any number of corners is right: those at a boundary that cuts
/// the grid. `nodes` receives a node on the boundary if its number of edges is odd.
pub(super) fn repair(
    nodes: &mut Vec<Node>,
    faces: Vec<Vec<usize>>,
    is_trimmed: impl Fn(&[usize]) -> bool,
) -> Repaired {
    let mut panels = Panels::of(faces);
    let mut replaced = Vec::new();
    let divide = |panels: &mut Panels, nodes: &[Node], replaced: &mut Vec<Vec<usize>>| {
        let odd_one = |panels: &Panels, index: usize| {
            let face = panels.face(index)?;
            (face.len() != 4 && !is_trimmed(face)).then_some(index)
        };
        let wrong: Vec<usize> = panels.indices().filter_map(|i| odd_one(panels, i)).collect();
        for index in wrong {
            replace(panels, nodes, index, replaced);
        }
    };
    divide(&mut panels, nodes, &mut replaced);
    join_odd(&mut panels, nodes, &is_trimmed);
    divide(&mut panels, nodes, &mut replaced);
    Repaired { faces: panels.into_faces(), replaced }
}

/// Replaces a face by quads, if that is possible.
fn replace(panels: &mut Panels, nodes: &[Node], index: usize, replaced: &mut Vec<Vec<usize>>) {
    let Some(face) = panels.take(index) else { return };
    let at = |node: usize| nodes[node].position;
    match quadrangulate(&face, at, |a, b| !panels.has_edge(a, b)) {
        Some(quads) => {
            quads.into_iter().for_each(|quad| {
                panels.add(quad.to_vec());
            });
            replaced.push(face);
        }
        None => {
            panels.add(face);
        }
    }
}
