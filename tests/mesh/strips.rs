//! Face strips: quads that are adjacent across opposite edges.

use crate::support::meshes::{mixed, wavy};
use proptest::prelude::*;
use shape_up::generate::model::Dome;
use shape_up::mesh::{Mesh, Ragged, Topology, strips};
use std::collections::BTreeMap;

fn rows(mesh: &Mesh) -> Vec<Vec<u32>> {
    strips(mesh, &Topology::new(mesh)).iter().map(<[u32]>::to_vec).collect()
}

/// A mesh of these faces; the positions do not matter.
fn faces<const N: usize>(rows: impl IntoIterator<Item = [u32; N]>) -> Mesh {
    let faces: Ragged = rows.into_iter().collect();
    let n = faces.indices().iter().max().expect("there are faces") + 1;
    Mesh { positions: vec![[0.0; 3]; n as usize], faces, ..Mesh::default() }
}

#[test]
fn a_grid_has_its_columns_and_rows_of_faces() {
    // 4 5 6 7     The first side of a face runs to the right: strips through it go up.
    // 0 1 2 3
    let row = rows(&wavy(3, 1));
    assert_eq!(
        row,
        [
            vec![0, 1, 4, 5],
            // Strips through the second side, which runs up, go to the left, into the first face.
            vec![3, 7, 2, 6, 1, 5, 0, 4],
            vec![1, 2, 5, 6],
            vec![2, 3, 6, 7],
        ]
    );
    assert_eq!(rows(&wavy(5, 4)).len(), 5 + 4);
}

#[test]
fn a_closed_strip_comes_once_and_does_not_repeat_its_first_edge() {
    // A tube of six faces around and one up, and a band with one twist.
    let tube = faces((0..6).map(|i| [i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6]));
    let found = rows(&tube);
    assert_eq!(found.len(), 1 + 6, "{found:?}");
    let closed: Vec<_> = found.iter().filter(|strip| strip.len() > 4).collect();
    assert_eq!(closed, [&[1, 7, 0, 6, 5, 11, 4, 10, 3, 9, 2, 8]]);

    let twisted =
        faces((0..6).map(|i| if i < 5 { [i, i + 1, i + 7, i + 6] } else { [5, 6, 0, 11] }));
    let closed: Vec<_> = rows(&twisted).into_iter().filter(|strip| strip.len() > 4).collect();
    assert_eq!(closed.len(), 1);
    assert_eq!(closed[0].len(), 12);
}

#[test]
fn strips_end_at_faces_that_are_no_quads_and_at_edges_of_three_faces() {
    // The meridians of the dome end at its pentagons; its rows of quads are closed.
    let dome = Dome::default();
    let found = rows(&dome.mesh());
    let round: Vec<_> = found.iter().filter(|strip| strip.len() > 30).map(Vec::len).collect();
    assert_eq!(round, [vec![2 * 48; dome.rows[0]], vec![2 * 24; dome.rows[1]]].concat());
    let up: Vec<_> = found.iter().filter(|strip| strip.len() <= 30).map(Vec::len).collect();
    let [below, above] = dome.rows.map(|rows| 2 * (rows + 1));
    assert_eq!(up, [vec![below; 48], vec![above; 24]].concat());
    // Three quads at one edge: no strip continues across it.
    let fins = faces([[0, 1, 2, 3], [0, 1, 4, 5], [0, 1, 6, 7]]);
    assert!(rows(&fins).iter().all(|strip| strip.len() == 4));
    assert_eq!(rows(&fins).len(), 6);
    // A mesh of mostly triangles has none.
    assert!(rows(&faces([[0, 1, 2], [1, 2, 3]])).is_empty());
}

#[test]
fn faces_that_repeat_corners_are_survived() {
    for quad in [[0, 0, 1, 2], [0, 1, 0, 1], [0, 1, 1, 0], [3, 3, 3, 3]] {
        for strip in rows(&faces([quad, [0, 1, 2, 3], quad])) {
            assert!(strip.len() >= 4 && strip.len() % 2 == 0, "{quad:?}: {strip:?}");
        }
    }
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(64))]

    #[test]
    fn each_quad_is_crossed_once_in_each_direction(mesh in mixed()) {
        let topology = Topology::new(&mesh);
        let found = strips(&mesh, &topology);
        // A crossing: two opposite edges of a quad, given by their ends.
        let edge = |a: u32, b: u32| [a.min(b), a.max(b)];
        let crossing = |e: [u32; 2], f: [u32; 2]| [e.min(f), e.max(f)];
        let mut expected = BTreeMap::new();
        if topology.is_quad_dominant() {
            for face in mesh.faces.iter().filter(|face| face.len() == 4) {
                let e: [_; 4] = std::array::from_fn(|k| edge(face[k], face[(k + 1) % 4]));
                for k in 0..2 {
                    *expected.entry(crossing(e[k], e[k + 2])).or_insert(0) += 1;
                }
            }
        }
        let mut crossed = BTreeMap::new();
        for strip in found.iter() {
            let (pairs, rest) = strip.as_chunks::<2>();
            prop_assert!(rest.is_empty() && pairs.len() >= 2);
            // No strip of a height field is closed, and none can be extended at its ends.
            for next in pairs.windows(2) {
                let ([l, r], [m, s]) = (next[0], next[1]);
                // Left to left and right to right are sides too.
                prop_assert!(topology.edge(l, m).is_some() && topology.edge(r, s).is_some());
                *crossed.entry(crossing(edge(l, r), edge(m, s))).or_insert(0) += 1;
            }
            for [l, r] in [pairs[0], pairs[pairs.len() - 1]] {
                let e = topology.edge(l, r).expect("a strip crosses edges");
                let quads = topology.edge_faces().row(e as usize).iter();
                let quads = quads.filter(|&&f| mesh.faces.row(f as usize).len() == 4).count();
                prop_assert_eq!(quads, 1);
            }
        }
        prop_assert_eq!(crossed, expected);
    }
}
