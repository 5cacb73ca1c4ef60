//! Curves that run along each other: polylines that somebody drew over the edge lines of a mesh.

use crate::mesh::{Ragged, Topology};

/// Which curves run along another one, so that both together say no more than the longer does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repeated {
    /// Per polyline whether all its segments are edges of one line, and there are more of these.
    pub polylines: Vec<bool>,
    /// Per line whether all its edges are segments of one polyline.
    pub lines: Vec<bool>,
}

/// Finds the polylines that run along one of the edge lines `lines`, and the lines that one of the
/// polylines covers. Of two that are the same it is the line. Each edge is in one line at most, as
/// [`crate::mesh::edge_lines`] makes them.
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
        // As it was, for the next one.
        own.iter().filter_map(line).for_each(|line| shared[line] = 0);
        own.iter().flatten().for_each(|&edge| walked[edge as usize] = false);
    }
    repeated
}
