//! What follows from the pattern of the normal matrix alone: the order of elimination and the symbolic
//! analysis. Other weights, handles and parameters leave all of it as it is.

use super::assemble::Pattern;
use super::order::{elimination_order, inverse};
use super::symbolic::Symbolic;
use crate::mesh::{Ragged, components};
use std::rc::Rc;

/// A pattern in its order of elimination.
pub(super) struct Ordered {
    /// The neighbours of each vertex and extra unknown, as they were numbered first.
    adjacency: Ragged,
    /// The vertex or extra unknown that is eliminated `k`-th.
    pub order: Vec<u32>,
    /// Its inverse: the node of each vertex, then of each extra unknown.
    pub node_of: Vec<u32>,
    /// The connected part of each node.
    pub parts: Vec<u32>,
    /// The upper triangle in terms of nodes.
    pub pattern: Rc<Pattern>,
    /// The supernodes of its factor.
    pub symbolic: Rc<Symbolic>,
}

impl Ordered {
    /// Orders and analyses a pattern; see [`super::assemble::adjacency`].
    pub(super) fn new(adjacency: Ragged) -> Ordered {
        let order = elimination_order(&adjacency);
        let node_of = inverse(&order);
        let pattern = Pattern::new(&renumbered(&adjacency, &order, &node_of));
        let cliques = (0..order.len()).map(|node| &pattern.rows[pattern.column(node)]);
        let parts = components(order.len(), cliques);
        let symbolic = Rc::new(Symbolic::new(&pattern));
        Ordered { adjacency, order, node_of, parts, pattern: Rc::new(pattern), symbolic }
    }

    /// Whether this is the order of that pattern.
    pub(super) fn fits(&self, adjacency: &Ragged) -> bool {
        self.adjacency == *adjacency
    }
}

/// The pattern with every node in its place in the order of elimination.
fn renumbered(adjacency: &Ragged, order: &[u32], node_of: &[u32]) -> Ragged {
    let mut row = Vec::new();
    let mut renumbered = Ragged::new();
    for &v in order {
        row.clear();
        row.extend(adjacency.row(v as usize).iter().map(|&u| node_of[u as usize]));
        row.sort_unstable();
        renumbered.push(&row);
    }
    renumbered
}
