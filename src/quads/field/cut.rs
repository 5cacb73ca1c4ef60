//! The cut graph: the sides along which the surface is opened to a disk without singular vertices
//! inside.

use super::comb::Combed;
use crate::quads::surface::Edges;
use crate::quads::{Side, Triangulation};

/// Returns the cut edges, each as its two sides, in order of edges: what the tree of the combed field
/// does not cross, without the branches that end at a regular inner vertex.
pub(crate) fn cut_sides(surface: &Triangulation, combed: &Combed) -> Vec<[Side; 2]> {
    let edges = Edges::new(&surface.triangles);
    let mut is_cut: Vec<bool> = edges
        .sides
        .iter()
        .map(|sides| sides.len() == 2 && !combed.tree[sides[0].triangle][sides[0].side])
        .collect();
    let mut at_vertex: Vec<Vec<usize>> = vec![Vec::new(); surface.positions.len()];
    for e in (0..is_cut.len()).filter(|&e| is_cut[e]) {
        edges.ends[e].iter().for_each(|&v| at_vertex[v].push(e));
    }
    let on_boundary = surface.boundary_vertices();
    let mut degree: Vec<usize> = at_vertex.iter().map(Vec::len).collect();
    let mut ends: Vec<usize> = (0..degree.len()).filter(|&v| degree[v] == 1).collect();
    while let Some(v) = ends.pop() {
        if degree[v] != 1 || combed.indices[v] != 0 || on_boundary[v] {
            continue;
        }
        let last = at_vertex[v].iter().copied().find(|&e| is_cut[e]);
        let e = last.expect("a vertex of degree one has an edge");
        is_cut[e] = false;
        for u in edges.ends[e] {
            degree[u] -= 1;
            if degree[u] == 1 {
                ends.push(u);
            }
        }
    }
    let cut = (0..is_cut.len()).filter(|&e| is_cut[e]);
    cut.map(|e| [edges.sides[e][0], edges.sides[e][1]]).collect()
}
