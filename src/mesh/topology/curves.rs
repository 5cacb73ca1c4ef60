//! Curves that duplicate each other, such as polylines drawn along the edge lines of a mesh.

use crate::mesh::{Ragged, Topology};

/// The curves contained in another curve, which are therefore redundant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repeated {
    /// For each polyline, whether all its segments are edges of one line that has further edges.
    pub polylines: Vec<bool>,
    /// For each line, whether all its edges are segments of one polyline.
    pub lines: Vec<bool>,
}

/// Finds the polylines contained in one of the edge lines `lines`, and the lines contained in one
/// of the polylines. If both have the same edges, the line counts as the contained one. Each edge
/// must be in at most one line, as [`crate::mesh::edge_lines`] guarantees.
pub fn repeated(polylines: &Ragged, lines: &Ragged, topology: &Topology) -> Repeated {
    let edges = |curve: &[u32]| {
        let edges = curve.windows(2).map(|ends| topology.edge(ends[0], ends[1]));
        edges.collect::<Vec<_>>()
    };
    let mut line_of = vec![None; topology.edges().len()];
    for (index, line) in lines.iter().enumerate() {
        edges(line).into_iter().flatten().for_each(|edge| line_of[edge as usize] = Some(index));
    }
    let mut repeated =
        Repeated { polylines: vec![false; polylines.len()], lines: vec![false; lines.len()] };
    let mut walked = vec![false; topology.edges().len()];
    let mut shared = vec![0; lines.len()];
    for (index, polyline) in polylines.iter().enumerate() {
        let mut own = edges(polyline);
        own.retain(|edge| edge.is_none_or(|e| !std::mem::replace(&mut walked[e as usize], true)));
        let line = |edge: &Option<u32>| edge.and_then(|edge| line_of[edge as usize]);
        own.iter().filter_map(line).for_each(|line| shared[line] += 1);
        let mut covers_one = false;
        for line in own.iter().filter_map(line) {
            let whole = shared[line] + 1 == lines.row(line).len();
            repeated.lines[line] |= whole;
            covers_one |= whole;
        }
        let first = own.first().and_then(line);
        let along = first.is_some() && own.iter().all(|edge| line(edge) == first);
        repeated.polylines[index] = along && !covers_one;
        // Reset the scratch arrays for the next polyline.
        own.iter().filter_map(line).for_each(|line| shared[line] = 0);
        own.iter().flatten().for_each(|&edge| walked[edge as usize] = false);
    }
    repeated
}
