//! Boundary loops.
//!
//! The boundary edges form a graph. A manifold vertex has none or two of them, a vertex where loops
//! touch has four or more, and a vertex where edges with three or more faces end can have an odd
//! number. Walks through the graph are cut wherever they meet themselves, which always gives simple
//! loops.

use crate::mesh::Ragged;

/// See [`crate::mesh::Topology::boundary_loops`].
pub(crate) fn boundary_loops(
    n_vertices: usize,
    edges: &[[u32; 2]],
    vertex_edges: &Ragged,
    (edge_faces, ascends): (&Ragged, &[bool]),
) -> Ragged {
    let mut walk = Walk {
        edges,
        vertex_edges,
        // Edges that are not on the boundary count as walked.
        walked: edge_faces.iter().map(|faces| faces.len() != 1).collect(),
        from_first: edge_faces
            .offsets()
            .iter()
            .map(|&first| ascends.get(first as usize) == Some(&true))
            .collect(),
        path: Vec::new(),
        path_index: vec![None; n_vertices],
        loops: Ragged::new(),
    };
    // Open chains first: afterwards every vertex has an even number of edges left.
    let odd: Vec<u32> = (0..n_vertices as u32).filter(|&v| walk.degree(v) % 2 == 1).collect();
    for start in odd.into_iter().chain(0..n_vertices as u32) {
        while walk.degree(start) > 0 {
            walk.from(start);
        }
    }
    walk.loops
}

struct Walk<'a> {
    edges: &'a [[u32; 2]],
    vertex_edges: &'a Ragged,
    walked: Vec<bool>,
    /// Whether the face of a boundary edge traverses it from the lower to the higher end.
    from_first: Vec<bool>,
    path: Vec<u32>,
    path_index: Vec<Option<usize>>,
    loops: Ragged,
}

impl Walk<'_> {
    /// Counts the boundary edges at `v` still to be walked.
    fn degree(&self, v: u32) -> usize {
        self.vertex_edges.row(v as usize).iter().filter(|&&e| !self.walked[e as usize]).count()
    }

    /// Returns the next edge to walk at `v`, preferably one whose face traverses it away from `v`.
    fn leave(&self, v: u32) -> Option<u32> {
        self.vertex_edges
            .row(v as usize)
            .iter()
            .copied()
            .filter(|&e| !self.walked[e as usize])
            .min_by_key(|&e| self.from_first[e as usize] != (self.edges[e as usize][0] == v))
    }

    /// Walks from `start` until no edge is left, and collects each loop that closes.
    fn from(&mut self, start: u32) {
        self.push(start);
        let mut at = start;
        while let Some(e) = self.leave(at) {
            self.walked[e as usize] = true;
            let [a, b] = self.edges[e as usize];
            at = if at == a { b } else { a };
            match self.path_index[at as usize] {
                Some(path_index) => {
                    self.loops.push(&self.path[path_index..]);
                    for v in self.path.drain(path_index + 1..) {
                        self.path_index[v as usize] = None;
                    }
                }
                None => self.push(at),
            }
        }
        if self.path.len() > 1 {
            self.loops.push(&self.path);
        }
        for v in self.path.drain(..) {
            self.path_index[v as usize] = None;
        }
    }

    fn push(&mut self, v: u32) {
        self.path_index[v as usize] = Some(self.path.len());
        self.path.push(v);
    }
}
