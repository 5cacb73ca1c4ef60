//! `E_close` (Eq. 11): every vertex is kept close to the reference surface or to where it was.

use crate::constraint::Row;
use crate::mesh::Surface;
use std::rc::Rc;

/// What vertices are kept close to.
pub(super) enum CloseEnergy {
    /// The closest point `c(v)` on the rest surface.
    Surface {
        /// The rest surface.
        surface: Rc<Surface>,
        /// The last closest triangle of each vertex, in the order of `nodes`.
        warm: Vec<u32>,
        /// The node of each vertex, ascending: neighbours in the elimination order are neighbours on
        /// the surface, so that the tree stays in the cache.
        nodes: Vec<u32>,
    },
    /// Their own rest positions.
    Rest {
        /// The rest position of each node.
        rest: Vec<Row>,
        /// The node of each vertex.
        nodes: Vec<u32>,
    },
}

impl CloseEnergy {
    /// Closeness to the surface, for the vertices at `nodes`.
    pub(super) fn to_surface(surface: Rc<Surface>, mut nodes: Vec<u32>) -> Self {
        nodes.sort_unstable();
        CloseEnergy::Surface { surface, warm: vec![u32::MAX; nodes.len()], nodes }
    }

    /// Adds half the gradient of `lambda * E_close` at `x`, and gives `E_close`.
    pub(super) fn step(&mut self, x: &[Row], gradient: &mut [Row], lambda: f64) -> f64 {
        let mut energy = 0.0;
        let mut pull = |node: u32, target: [f64; 3]| {
            let (row, gradient) = (x[node as usize], &mut gradient[node as usize]);
            for i in 0..3 {
                let away = row[i] - target[i];
                energy += away * away;
                gradient[i] += lambda * away;
            }
        };
        match self {
            CloseEnergy::Surface { surface, warm, nodes } => {
                for (&node, warm) in nodes.iter().zip(warm) {
                    let [px, py, pz, _] = x[node as usize];
                    pull(node, surface.closest([px, py, pz], warm));
                }
            }
            CloseEnergy::Rest { rest, nodes } => {
                for &node in &*nodes {
                    let [px, py, pz, _] = rest[node as usize];
                    pull(node, [px, py, pz]);
                }
            }
        }
        energy
    }
}
