//! Strips of quads laid flat.

use crate::math::Vec3;
use crate::mesh::{Point, Topology};

/// A strip of quads laid flat.
#[derive(Clone, Debug, PartialEq)]
pub struct UnrolledStrip {
    /// Its quads.
    pub quads: usize,
    /// Whether it goes round; it is cut open at its first edge then.
    pub closed: bool,
    /// Along its left side and back along its right one, counterclockwise or not.
    pub outline: Vec<[f64; 2]>,
}

impl UnrolledStrip {
    /// A strip of the mesh (`l0 r0 l1 r1 ...`, as [`strips`](crate::mesh::strips) gives them), at `positions`
    /// (`#V by 3`). Each quad is laid beside the one before, by the places of its corners over the edge that leads into
    /// it: nothing is stretched where the quads are flat. None where an edge that it crosses has no length.
    pub fn new(positions: &[Point], strip: &[u32], topology: &Topology) -> Option<UnrolledStrip> {
        let (edges, _) = strip.as_chunks::<2>();
        let (first, last) = (edges.first()?, edges.last()?);
        let meet = |v: u32| first.iter().any(|&w| topology.edge(v, w).is_some());
        let closed = edges.len() > 2 && last.iter().all(|&v| meet(v));
        let at = |v: u32| Vec3::from(positions[v as usize]);
        let mut around = edges.to_vec();
        if closed {
            // A band with a twist comes back the other way round.
            let twisted = topology.edge(first[0], last[0]).is_none();
            around.push(if twisted { [first[1], first[0]] } else { *first });
        }
        let mut flat = [[0.0, 0.0], [(at(first[1]) - at(first[0])).length(), 0.0]];
        let mut sides = flat.map(|corner| vec![corner]);
        for pair in around.windows(2) {
            let [before, after] = pair else { continue };
            let across = at(before[1]) - at(before[0]);
            let length = across.length();
            if length == 0.0 {
                return None;
            }
            let across = across * (1.0 / length);
            let [[x, y], [to_x, to_y]] = flat;
            let [c, s] = [(to_x - x) / length, (to_y - y) / length];
            flat = after.map(|v| {
                let way = at(v) - at(before[0]);
                let along = way.dot(across);
                let ahead = (way - across * along).length();
                [x + c * along - s * ahead, y + s * along + c * ahead]
            });
            sides.iter_mut().zip(flat).for_each(|(side, corner)| side.push(corner));
        }
        let [mut outline, right] = sides;
        outline.extend(right.into_iter().rev());
        Some(UnrolledStrip { quads: around.len() - 1, closed, outline })
    }
}
