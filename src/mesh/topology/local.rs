//! Local neighbourhoods for constraints: corners of faces, stars of vertices, hinges between
//! triangles.

use crate::math::polygon_corners;
use crate::mesh::{Mesh, Ragged, Topology};

/// Returns each corner of each face with its face: the vertex before, the corner, the vertex after.
pub fn corners(mesh: &Mesh) -> impl Iterator<Item = (usize, [u32; 3])> {
    mesh.faces
        .iter()
        .enumerate()
        .flat_map(|(f, face)| polygon_corners(face).map(move |corner| (f, corner)))
}

/// Returns a row for each interior vertex surrounded by a single fan of faces: the vertex, then its
/// neighbours in cyclic order, from the lowest one towards the lower of the two adjacent to it.
pub fn stars(mesh: &Mesh, topology: &Topology) -> Ragged {
    let mut stars = Ragged::new();
    for v in 0..mesh.positions.len() as u32 {
        // Two neighbours are adjacent if a face has a corner between them.
        let mut next_to = Vec::new();
        for &f in topology.vertex_faces().row(v as usize) {
            let corners = polygon_corners(mesh.faces.row(f as usize));
            for [before, _, after] in corners.filter(|&[_, here, _]| here == v) {
                next_to.extend([[before, after], [after, before]]);
            }
        }
        next_to.sort_unstable();
        let neighbours: Vec<u32> = topology.body_neighbours(v).collect();
        let two_each = next_to.len() == 2 * neighbours.len()
            && next_to.chunks(2).zip(&neighbours).all(|(two, &u)| two[0][0] == u && two[1][0] == u);
        if !two_each || neighbours.is_empty() {
            continue;
        }
        let beside = |u: u32| {
            let k = 2 * neighbours.binary_search(&u).expect("every neighbour is listed");
            [next_to[k][1], next_to[k + 1][1]]
        };
        let mut star = vec![v, neighbours[0]];
        let mut here = beside(neighbours[0])[0];
        while here != neighbours[0] {
            let [a, b] = beside(here);
            let next = if star[star.len() - 1] == a { b } else { a };
            star.push(here);
            here = next;
        }
        if star.len() == neighbours.len() + 1 {
            stars.push(&star);
        }
    }
    stars
}

/// Returns for each edge between exactly two triangles its two ends, then the opposite corners.
pub fn hinges(mesh: &Mesh, topology: &Topology) -> Vec<[u32; 4]> {
    let opposite = |f: u32, [a, b]: [u32; 2]| match *mesh.faces.row(f as usize) {
        [p, q, r] => [p, q, r].into_iter().find(|&corner| corner != a && corner != b),
        _ => None,
    };
    let edges = topology.edges().iter().zip(topology.edge_faces().iter());
    edges
        .filter_map(|(&[a, b], faces)| match *faces {
            [f, g] => {
                let (c, d) = (opposite(f, [a, b])?, opposite(g, [a, b])?);
                (c != d).then_some([a, b, c, d])
            }
            _ => None,
        })
        .collect()
}
