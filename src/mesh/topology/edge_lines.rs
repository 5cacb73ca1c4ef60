//! Edge lines of quad-dominant meshes: the curves that can be made circular or planar as a whole
//! (paper section 4.1, Fig. 6); and which polylines are drawn along them.

use crate::mesh::{Ragged, Topology};

/// Returns the edge lines of a quad-dominant mesh; no rows for other meshes. Each side of a face is
/// in exactly one row.
///
/// A line continues at regular vertices: at an interior vertex with four edges and four faces along
/// the opposite edge, and at a boundary vertex with three edges and two faces along the boundary.
/// It ends at all other vertices, and where it meets the boundary. A closed line repeats its first
/// vertex at the end. Edges of curves only are ignored.
pub fn edge_lines(topology: &Topology) -> Ragged {
    let mut lines = Ragged::new();
    if !topology.is_quad_dominant() {
        return lines;
    }
    let edges = topology.edges();
    let mut walked = vec![false; edges.len()];
    for e in 0..edges.len() as u32 {
        if walked[e as usize] || topology.edge_faces().row(e as usize).is_empty() {
            continue;
        }
        let [a, b] = edges[e as usize];
        walked[e as usize] = true;
        let (mut line, closed) = follow(topology, e, a, &mut walked);
        line.reverse();
        if closed {
            line.insert(0, a);
        } else {
            line.extend(follow(topology, e, b, &mut walked).0);
        }
        lines.push(&line);
    }
    lines
}

/// Returns the vertices of the line along edge `first` from its end `v` on, and whether the line
/// returns to `first`. Since continuation is symmetric, it then returns at the other end, which is
/// the last of the vertices, and meets no other edge twice.
fn follow(topology: &Topology, first: u32, v: u32, walked: &mut [bool]) -> (Vec<u32>, bool) {
    let mut vertices = vec![v];
    let (mut edge, mut at) = (first, v);
    while let Some(next) = straight_on(topology, edge, at) {
        if next == first {
            return (vertices, true);
        }
        walked[next as usize] = true;
        (edge, at) = (next, topology.other_end(next, at));
        vertices.push(at);
    }
    (vertices, false)
}

/// Returns the edge that continues `edge` at its end `v`.
fn straight_on(topology: &Topology, edge: u32, v: u32) -> Option<u32> {
    let faces = |e: u32| topology.edge_faces().row(e as usize);
    let around = || {
        topology.vertex_edges().row(v as usize).iter().copied().filter(|&e| !faces(e).is_empty())
    };
    let inner = around().filter(|&e| faces(e).len() == 2).count();
    let boundary = around().filter(|&e| faces(e).len() == 1).count();
    let regular = (inner, boundary, topology.vertex_faces().row(v as usize).len());
    if regular != (4, 0, 4) && regular != (1, 2, 2) || around().count() != inner + boundary {
        return None;
    }
    let on_boundary = faces(edge).len() == 1;
    let mut opposite = around().filter(|&e| {
        e != edge
            && if boundary == 0 {
                !faces(e).iter().any(|face| faces(edge).contains(face))
            } else {
                on_boundary && faces(e).len() == 1
            }
    });
    // Four faces that are two closed fans, as of doubled faces, have two such edges.
    opposite.next().filter(|_| opposite.next().is_none())
}

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
