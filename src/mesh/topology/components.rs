//! Connected components.

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
