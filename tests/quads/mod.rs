//! Quads along the lines of curvature: properties of the result on surfaces of all kinds
//! (`reference/quads.md`, section 7), and refusals.

mod boundary;
mod followed;
mod fuzzed;
mod map;
mod openings;
mod parts;
mod prepare;
mod surfaces;

pub(crate) use surfaces::{hypar, parametric, tube};

use shape_up::mesh::Mesh;
use shape_up::quads::{MapOptions, PanelSize, RemeshError, Remeshed, remesh};
use std::collections::BTreeMap;

/// Remeshes with all defaults and this number of panels.
fn panels(mesh: &Mesh, count: usize) -> Result<Remeshed, RemeshError> {
    with(mesh, MapOptions::of_size(PanelSize::Count(count)))
}

fn with(mesh: &Mesh, options: MapOptions) -> Result<Remeshed, RemeshError> {
    remesh(mesh, &options, "m", &mut |_| ())
}

/// The Euler characteristic and the number of boundary loops, by another way than that of the crate.
/// Where parts touch in a vertex, it counts once for each part.
fn shape(mesh: &Mesh) -> (i64, usize) {
    // At each corner, the corner of the side that begins there and of the one that ends there.
    let mut sides: BTreeMap<[u32; 2], [usize; 2]> = BTreeMap::new();
    let mut count = 0;
    for face in mesh.faces.iter() {
        for k in 0..face.len() {
            let ends = [face[k], face[(k + 1) % face.len()]];
            sides.insert(ends, [count + k, count + (k + 1) % face.len()]);
        }
        count += face.len();
    }
    // Corners are at one vertex if they share a side there.
    let mut vertex: Vec<u32> = (0..count as u32).collect();
    let across = |&[a, b]: &[u32; 2]| sides.get(&[b, a]).copied();
    let shared = || sides.iter().filter_map(|(ends, own)| Some((own, across(ends)?)));
    loop {
        let before = vertex.clone();
        for (own, other) in shared() {
            for (i, j) in [(own[0], other[1]), (own[1], other[0])] {
                let lower = vertex[i].min(vertex[j]);
                (vertex[i], vertex[j]) = (lower, lower);
            }
        }
        if vertex == before {
            break;
        }
    }
    let edges = (sides.len() + sides.keys().filter(|ends| across(ends).is_none()).count()) / 2;
    let next: BTreeMap<u32, u32> = sides
        .iter()
        .filter(|(ends, _)| across(ends).is_none())
        .map(|(_, &[from, to])| (vertex[from], vertex[to]))
        .collect();
    let (mut loops, mut left) = (0, next.clone());
    while let Some((&start, _)) = left.first_key_value() {
        let mut at = start;
        while let Some(to) = left.remove(&at) {
            at = to;
        }
        loops += 1;
    }
    let mut vertices = vertex.clone();
    vertices.sort_unstable();
    vertices.dedup();
    (vertices.len() as i64 - edges as i64 + mesh.faces.len() as i64, loops)
}

/// Checks that a mesh is a surface without stray vertices: each side once, and the faces at each
/// vertex one fan.
fn check_manifold(mesh: &Mesh) {
    let mut after: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    let mut corners = vec![0; mesh.positions.len()];
    for face in mesh.faces.iter() {
        for k in 0..face.len() {
            let [before, at, next] = [0, 1, 2].map(|j| face[(k + j) % face.len()]);
            // The face at a corner comes after the side from `before`, and ends at that to `next`.
            assert!(after.insert([at, next], before).is_none(), "side {at} {next} is there twice");
            corners[at as usize] += 1;
        }
    }
    for &[at, next] in after.keys() {
        // Around the vertex clockwise from this side, over all corners, to the boundary or back.
        let (mut side, mut walked) = (next, 0);
        let mut first = side;
        while let Some(&before) = after.get(&[at, side]) {
            walked += 1;
            side = before;
            if side == first || walked > corners[at as usize] {
                break;
            }
        }
        if side != first {
            // An open fan: count from its other end.
            first = side;
            walked = 0;
            let ends: BTreeMap<u32, u32> = after
                .range([at, 0]..=[at, u32::MAX])
                .map(|(&[_, next], &before)| (before, next))
                .collect();
            let mut side = first;
            while let Some(&next) = ends.get(&side) {
                walked += 1;
                side = next;
            }
        }
        assert_eq!(walked, corners[at as usize], "the faces at vertex {at} are one fan");
    }
    assert!(corners.iter().all(|&count| count > 0), "there are no stray vertices");
    assert!(mesh.positions.as_flattened().iter().all(|x| x.is_finite()));
}

/// Checks that a result is a surface of quads with the shape of its input, as its measures say.
fn check(input: &Mesh, found: &Remeshed) {
    check_manifold(&found.mesh);
    assert!(found.mesh.faces.iter().all(|face| face.len() == 4), "all are quads");
    let measures = &found.measures;
    assert_eq!(shape(&found.mesh), shape(input));
    assert_eq!((measures.euler, measures.loops), shape(input));
    assert_eq!((measures.quads, measures.other_faces), (found.mesh.faces.len(), 0));
    assert!(measures.distance.to_input < 0.01 * measures.edge.mean);
}
