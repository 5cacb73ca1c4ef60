//! Strips of quads, which continue across opposite edges, such as the lamellas of a roof or the
//! developable strips of a facade.

use crate::mesh::{Mesh, Ragged, Topology};

/// Returns the strips of quads of a quad-dominant mesh; no rows for other meshes. Each quad is
/// crossed in both directions, so it is in two strips, or twice in one.
///
/// A row has two vertices per crossed edge, `l0 r0 l1 r1 ...`, with all left vertices on the same
/// side of the strip. A strip ends at the boundary, at a face that is not a quad, and at an edge
/// with three or more faces. A closed strip does not repeat its first edge. A strip that meets
/// itself repeats vertices.
///
/// Strips are in the order of their first faces; for each face, the strip through its first side
/// comes before the one through its second. The direction is through that side into that face. An
/// open strip begins at its end, a closed one in that face.
pub fn strips(mesh: &Mesh, topology: &Topology) -> Ragged {
    let mut strips = Ragged::new();
    if !topology.is_quad_dominant() {
        return strips;
    }
    let mut crossed = vec![[false; 2]; mesh.faces.len()];
    for (f, face) in mesh.faces.iter().enumerate().filter(|(_, face)| face.len() == 4) {
        for side in 0..2 {
            if std::mem::replace(&mut crossed[f][side], true) {
                continue;
            }
            let (into, out) =
                ([face[side], face[side + 1]], [face[(side + 3) % 4], face[side + 2]]);
            let mut walk = Walk { mesh, topology, crossed: &mut crossed };
            let (ahead, closed) = walk.from(f as u32, out);
            let mut edges = Vec::new();
            if !closed {
                edges = walk.from(f as u32, into).0;
                edges.reverse();
            }
            edges.extend([into, out]);
            edges.extend(ahead);
            if closed {
                // The last edge is the first one again.
                edges.pop();
            }
            strips.push(edges.as_flattened());
        }
    }
    strips
}

struct Walk<'a> {
    mesh: &'a Mesh,
    topology: &'a Topology,
    /// For each quad, whether it was crossed through its first and through its second side.
    crossed: &'a mut [[bool; 2]],
}

impl Walk<'_> {
    /// Returns the edges that a strip crosses after leaving `face` through the edge `at`, and
    /// whether it ended in a quad already crossed in that direction.
    fn from(&mut self, mut face: u32, mut at: [u32; 2]) -> (Vec<[u32; 2]>, bool) {
        let mut edges = Vec::new();
        while let Some((next, side)) = self.beyond(face, at) {
            if std::mem::replace(&mut self.crossed[next as usize][side % 2], true) {
                return (edges, true);
            }
            let corner = |k: usize| self.mesh.faces.row(next as usize)[(side + k) % 4];
            at = if corner(0) == at[0] { [corner(3), corner(2)] } else { [corner(2), corner(3)] };
            edges.push(at);
            face = next;
        }
        (edges, false)
    }

    /// Returns the quad across an edge of `face`, and the index of the edge among its sides.
    fn beyond(&self, face: u32, [l, r]: [u32; 2]) -> Option<(u32, usize)> {
        let faces = self.topology.edge_faces().row(self.topology.edge(l, r)? as usize);
        let next = match *faces {
            [a, b] if a == face && b != face => b,
            [a, b] if b == face && a != face => a,
            _ => return None,
        };
        let corners = self.mesh.faces.row(next as usize);
        if corners.len() != 4 {
            return None;
        }
        let is_side = |&side: &usize| {
            let ends = [corners[side], corners[(side + 1) % 4]];
            ends == [l, r] || ends == [r, l]
        };
        Some((next, (0..4).find(is_side)?))
    }
}
