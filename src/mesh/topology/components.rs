//! Connected components, and the consistent orientation of their faces.

use crate::math::{Vec3, polygon_sides, twice_vector_area};
use crate::mesh::{Point, Ragged, Topology};

/// Returns the connected component of each of `n_vertices` vertices. The vertices of a clique are
/// connected: an edge, a face, or the vertices of a constraint. Components are numbered from 0 in
/// the order of their lowest vertices.
pub fn components<'a>(n_vertices: usize, cliques: impl Iterator<Item = &'a [u32]>) -> Vec<u32> {
    let mut parents: Vec<u32> = (0..n_vertices as u32).collect();
    for clique in cliques {
        for pair in clique.windows(2) {
            let (a, b) = (root(&mut parents, pair[0]), root(&mut parents, pair[1]));
            // The root of a tree remains its lowest vertex.
            parents[a.max(b) as usize] = a.min(b);
        }
    }
    let mut labels = vec![0; n_vertices];
    let mut count = 0;
    for v in 0..n_vertices {
        let parent = parents[v] as usize;
        labels[v] = if parent == v {
            count += 1;
            count - 1
        } else {
            labels[parent]
        };
    }
    labels
}

/// Returns the root of the tree of `v`, halving the path to it.
fn root(parents: &mut [u32], mut v: u32) -> u32 {
    while parents[v as usize] != v {
        parents[v as usize] = parents[parents[v as usize] as usize];
        v = parents[v as usize];
    }
    v
}

/// Returns for each face whether to turn it so that neighbours traverse their common edge in opposite
/// directions, and the edges where that is impossible, as on a Moebius strip. In each component,
/// connected over edges of two faces, the fewer faces are turned.
pub fn orientation(faces: &Ragged, topology: &Topology) -> (Vec<bool>, Vec<u32>) {
    let mut is_turned: Vec<Option<bool>> = vec![None; faces.len()];
    let mut contradictions = Vec::new();
    for first in 0..faces.len() as u32 {
        if is_turned[first as usize].is_some() {
            continue;
        }
        is_turned[first as usize] = Some(false);
        let mut component = vec![first];
        let mut next = 0;
        while let Some(&f) = component.get(next) {
            next += 1;
            let own = is_turned[f as usize] == Some(true);
            for [a, b] in polygon_sides(faces.row(f as usize)) {
                let Some(e) = topology.edge(a, b) else { continue };
                let &[g, h] = topology.edge_faces().row(e as usize) else { continue };
                let other = if g == f { h } else { g };
                let needed = own ^ (topology.agreement(e) < 0.0);
                match is_turned[other as usize] {
                    _ if other == f => {}
                    None => {
                        is_turned[other as usize] = Some(needed);
                        component.push(other);
                    }
                    Some(found) if found != needed => contradictions.push(e),
                    Some(_) => {}
                }
            }
        }
        let turned = component.iter().filter(|&&f| is_turned[f as usize] == Some(true)).count();
        if 2 * turned > component.len() {
            let turn = |&f: &u32| is_turned[f as usize] = is_turned[f as usize].map(|own| !own);
            component.iter().for_each(turn);
        }
    }
    (is_turned.into_iter().map(|turned| turned == Some(true)).collect(), contradictions)
}

/// Returns twice the vector area of each face at `positions` (`#V by 3`), `#F`, as if neighbours agreed:
/// of faces to be turned (see [`orientation`]) the negative one.
pub(crate) fn oriented_areas(
    positions: &[Point],
    faces: &Ragged,
    topology: &Topology,
) -> Vec<Vec3<f64>> {
    let (turned, _) = orientation(faces, topology);
    let area = |(face, turned): (&[u32], bool)| {
        let area = twice_vector_area(face.iter().map(|&v| Vec3::from(positions[v as usize])));
        if turned { -area } else { area }
    };
    faces.iter().zip(turned).map(area).collect()
}
