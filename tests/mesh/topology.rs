//! Edges, neighbours, boundary loops, components, edge lines and Laplacian weights.

use crate::support::meshes::{mixed, triangles, wavy};
use proptest::prelude::*;
use shape_up::mesh::{Laplacian, Mesh, Point, Ragged, Topology, components, edge_lines};

fn with_faces<const N: usize>(n_vertices: usize, faces: &[[u32; N]]) -> Mesh {
    Mesh {
        positions: (0..n_vertices).map(|i| [i as f64, (i * i) as f64, 1.0]).collect(),
        faces: faces.iter().collect(),
        ..Mesh::default()
    }
}

fn rows(ragged: &Ragged) -> Vec<Vec<u32>> {
    ragged.iter().map(<[u32]>::to_vec).collect()
}

/// Edges of a closed row of vertices.
fn edges_around(row: &[u32]) -> Vec<[u32; 2]> {
    let next = row.iter().cycle().skip(1);
    row.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)]).collect()
}

fn edges_along(row: &[u32]) -> Vec<[u32; 2]> {
    row.windows(2).map(|ends| [ends[0].min(ends[1]), ends[0].max(ends[1])]).collect()
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(128))]

    #[test]
    fn neighbours_edges_and_faces_agree(mesh in mixed()) {
        let topology = Topology::new(&mesh);
        prop_assert!(topology.edges().is_sorted() && topology.edges().iter().all(|[a, b]| a < b));
        for (&[a, b], e) in topology.edges().iter().zip(0..) {
            prop_assert_eq!(topology.edge(b, a), Some(e));
            let faces: Vec<u32> = (0..mesh.faces.len() as u32)
                .filter(|&f| edges_around(mesh.faces.row(f as usize)).contains(&[a, b]))
                .collect();
            prop_assert_eq!(topology.edge_faces().row(e as usize), faces);
        }
        for v in 0..mesh.positions.len() as u32 {
            let neighbours = topology.neighbours().row(v as usize);
            let brute_force: Vec<u32> = (0..mesh.positions.len() as u32)
                .filter(|&w| mesh.faces.iter().any(|face| edges_around(face).contains(&[v.min(w), v.max(w)])))
                .collect();
            prop_assert_eq!(neighbours, brute_force);
            for (&e, &w) in topology.vertex_edges().row(v as usize).iter().zip(neighbours) {
                prop_assert_eq!(topology.edges()[e as usize], [v.min(w), v.max(w)]);
            }
            let faces: Vec<u32> = (0..mesh.faces.len() as u32)
                .filter(|&f| mesh.faces.row(f as usize).contains(&v))
                .collect();
            prop_assert_eq!(topology.vertex_faces().row(v as usize), faces);
        }
    }

    #[test]
    fn boundary_loops_take_each_boundary_edge_once(mesh in mixed()) {
        let topology = Topology::new(&mesh);
        let mut walked: Vec<[u32; 2]> = Vec::new();
        for one in topology.boundary_loops().iter() {
            let mut distinct = one.to_vec();
            distinct.sort_unstable();
            distinct.dedup();
            prop_assert_eq!(distinct.len(), one.len(), "a loop meets itself");
            walked.extend(edges_around(one));
        }
        walked.sort_unstable();
        let boundary: Vec<[u32; 2]> = (0..topology.edges().len() as u32)
            .filter(|&e| topology.is_boundary_edge(e))
            .map(|e| topology.edges()[e as usize])
            .collect();
        prop_assert_eq!(walked, boundary);
    }

    #[test]
    fn rings_are_what_breadth_first_search_finds(mesh in mixed(), radius in 0_u32..5) {
        let topology = Topology::new(&mesh);
        for v in 0..mesh.positions.len() as u32 {
            let mut distance = vec![u32::MAX; mesh.positions.len()];
            distance[v as usize] = 0;
            let mut queue = std::collections::VecDeque::from([v]);
            while let Some(at) = queue.pop_front() {
                for &w in topology.neighbours().row(at as usize) {
                    if distance[w as usize] == u32::MAX {
                        distance[w as usize] = distance[at as usize] + 1;
                        queue.push_back(w);
                    }
                }
            }
            let mut expected: Vec<u32> =
                (0..distance.len() as u32).filter(|&w| distance[w as usize] <= radius).collect();
            expected.sort_by_key(|&w| (distance[w as usize], w));
            prop_assert_eq!(topology.ring(v, radius), expected);
        }
    }

    #[test]
    fn edge_lines_take_each_side_of_a_face_once(mesh in mixed()) {
        let topology = Topology::new(&mesh);
        let lines = edge_lines(&topology);
        let mut walked: Vec<[u32; 2]> = lines.iter().flat_map(edges_along).collect();
        walked.sort_unstable();
        let expected = if topology.is_quad_dominant() { topology.edges() } else { &[] };
        prop_assert_eq!(walked, expected);
    }

    #[test]
    fn components_are_what_the_edges_connect(mesh in mixed()) {
        let topology = Topology::new(&mesh);
        let n = mesh.positions.len();
        let by_faces = components(n, mesh.faces.iter());
        prop_assert_eq!(&by_faces, &components(n, topology.edges().iter().map(|ends| &ends[..])));
        for v in 0..n {
            let reached = topology.ring(v as u32, n as u32);
            for w in 0..n {
                prop_assert_eq!(by_faces[v] == by_faces[w], reached.contains(&(w as u32)));
            }
        }
        let mut next = 0;
        for &label in &by_faces {
            prop_assert!(label <= next);
            next = next.max(label + 1);
        }
    }

    #[test]
    fn cotangent_weights_are_symmetric_and_leave_linear_functions_alone(
        mesh in triangles(),
        scale in prop::sample::select(vec![1e-3, 1.0, 1e3]),
    ) {
        prop_assume!(!mesh.faces.is_empty());
        let topology = Topology::new(&mesh);
        let laplacian = Laplacian::cotangent(&mesh, &topology);
        let mut scaled = mesh.clone();
        scaled.positions.iter_mut().flatten().for_each(|x| *x *= scale);
        let other = Laplacian::cotangent(&scaled, &topology);
        for (i, (neighbours, weights)) in laplacian.rows().enumerate() {
            prop_assert_eq!(neighbours, topology.neighbours().row(i));
            for ((&j, &w), &scaled) in neighbours.iter().zip(weights).zip(other.row(i).1) {
                prop_assert!(w.is_finite());
                prop_assert!((w - scaled).abs() <= 1e-9 * w.abs().max(1.0));
                let (back, of_j) = laplacian.row(j as usize);
                let place = back.binary_search(&(i as u32)).expect("neighbours of each other");
                prop_assert_eq!(of_j[place], w);
            }
        }
        // On a flat mesh without folds the Laplacian of a linear function is 0 at interior
        // vertices.
        let mut flat = mesh;
        for p in &mut flat.positions {
            *p = [0.5 * (p[0] + p[0].round()), 0.5 * (p[1] + p[1].round()), 0.0];
        }
        let laplacian = Laplacian::cotangent(&flat, &topology);
        let on_boundary: Vec<u32> = topology.boundary_loops().indices().to_vec();
        for v in (0..flat.positions.len()).filter(|&v| !on_boundary.contains(&(v as u32))) {
            let (neighbours, weights) = laplacian.row(v);
            let total: f64 = weights.iter().map(|w| w.abs()).sum();
            for axis in 0..2 {
                let at = |v: usize| flat.positions[v][axis];
                let change: f64 =
                    neighbours.iter().zip(weights).map(|(&j, w)| w * (at(j as usize) - at(v))).sum();
                prop_assert!(change.abs() <= 1e-12 * total);
            }
        }
    }
}

#[test]
fn a_regular_grid_has_its_rows_and_columns_for_edge_lines() {
    let (columns, rows) = (4_u32, 3_u32);
    let topology = Topology::new(&wavy(columns, rows));
    let mut expected: Vec<Vec<u32>> = Vec::new();
    let width = columns + 1;
    expected.extend((0..=rows).map(|j| (0..width).map(|i| j * width + i).collect()));
    expected.extend((0..width).map(|i| (0..=rows).map(|j| j * width + i).collect()));
    expected.sort();
    let mut found: Vec<Vec<u32>> = edge_lines(&topology).iter().map(<[u32]>::to_vec).collect();
    for line in &mut found {
        if line.first() > line.last() {
            line.reverse();
        }
    }
    found.sort();
    assert_eq!(found, expected);
}

#[test]
fn a_tube_has_closed_edge_lines_that_repeat_their_first_vertex() {
    let (around, along) = (6_u32, 3_u32);
    let mut tube =
        Mesh { positions: vec![[0.0; 3]; (around * (along + 1)) as usize], ..Mesh::default() };
    for j in 0..along {
        for i in 0..around {
            let (a, b) = (j * around + i, j * around + (i + 1) % around);
            tube.faces.push(&[a, b, b + around, a + around]);
        }
    }
    let lines = edge_lines(&Topology::new(&tube));
    let closed: Vec<&[u32]> = lines.iter().filter(|line| line.first() == line.last()).collect();
    assert_eq!(closed.len() as u32, along + 1);
    assert!(closed.iter().all(|line| line.len() as u32 == around + 1));
    let open: Vec<&[u32]> = lines.iter().filter(|line| line.first() != line.last()).collect();
    assert_eq!(open.len() as u32, around);
    assert!(open.iter().all(|line| line.len() as u32 == along + 1));
}

#[test]
fn edge_lines_of_doubled_faces_end() {
    // The equators of an octahedron, each twice: a line went on for ever beside its first edge.
    let equators = [[0, 2, 1, 3], [2, 4, 3, 5], [4, 0, 5, 1]];
    let mut mesh = Mesh::default();
    for axis in 0..3 {
        for end in [1.0, -1.0] {
            let mut point = [0.0; 3];
            point[axis] = end;
            mesh.positions.push(point);
        }
    }
    equators.iter().for_each(|equator| [0, 1].iter().for_each(|_| mesh.faces.push(equator)));
    let topology = Topology::new(&mesh);
    assert_eq!(topology.edges().len(), 12);
    let sides: usize = edge_lines(&topology).iter().map(|line| line.len() - 1).sum();
    assert_eq!(sides, 12);
}

#[test]
fn edge_lines_end_at_irregular_vertices() {
    // A cube: every vertex has three edges, so every edge is a separate line.
    let cube = with_faces(
        8,
        &[[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
    );
    let lines = edge_lines(&Topology::new(&cube));
    assert_eq!(lines.len(), 12);
    assert!(lines.iter().all(|line| line.len() == 2));
}

#[test]
fn loops_that_touch_are_told_apart() {
    // Two triangles with one common vertex, then a ring of quads whose hole touches the outside.
    let bow_tie = Topology::new(&with_faces(5, &[[0, 1, 2], [2, 3, 4]]));
    assert_eq!(rows(bow_tie.boundary_loops()).len(), 2);

    let mut mesh = wavy(4, 4);
    let hole = [5, 6];
    mesh.faces =
        mesh.faces.iter().enumerate().filter(|(f, _)| !hole.contains(f)).map(|(_, f)| f).collect();
    // Vertex 6 of the hole is identified with the corner 0 of the outside.
    mesh.faces = mesh
        .faces
        .iter()
        .map(|face| face.iter().map(|&v| if v == 6 { 0 } else { v }).collect::<Vec<_>>())
        .collect();
    let topology = Topology::new(&mesh);
    let loops = rows(topology.boundary_loops());
    assert!(loops.len() >= 2);
    for one in &loops {
        assert!(one.iter().filter(|&&v| v == 0).count() <= 1);
    }
}

#[test]
fn a_loop_runs_as_its_faces_do() {
    let topology = Topology::new(&wavy(2, 2));
    assert_eq!(rows(topology.boundary_loops()), [[0, 1, 2, 5, 8, 7, 6, 3]]);
    let mut flipped = wavy(2, 2);
    flipped.faces =
        flipped.faces.iter().map(|face| face.iter().rev().copied().collect::<Vec<_>>()).collect();
    let topology = Topology::new(&flipped);
    assert_eq!(rows(topology.boundary_loops()), [[0, 3, 6, 7, 8, 5, 2, 1]]);
}

#[test]
fn edges_with_three_faces_are_not_boundary_and_break_nothing() {
    // Three triangles on the edge 0 1: the boundary is three chains from 0 to 1.
    let book = with_faces(5, &[[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
    let topology = Topology::new(&book);
    let e = topology.edge(0, 1).expect("the spine");
    assert_eq!(topology.edge_faces().row(e as usize), [0, 1, 2]);
    assert!(!topology.is_boundary_edge(e));
    let mut covered: Vec<[u32; 2]> = Vec::new();
    for row in topology.boundary_loops().iter() {
        let open = topology.edge(row[0], row[row.len() - 1]) == Some(e) && row.len() == 3;
        covered.extend(if open { edges_along(row) } else { edges_around(row) });
    }
    covered.sort_unstable();
    assert_eq!(covered, [[0, 2], [0, 3], [0, 4], [1, 2], [1, 3], [1, 4]]);
}

#[test]
fn repeated_corners_and_doubled_faces_are_survived() {
    let mesh = Mesh {
        positions: vec![[0.0; 3]; 4],
        faces: Ragged::from_iter([vec![0, 0, 1], vec![1, 1, 1], vec![0, 1, 2], vec![0, 1, 2]]),
        ..Mesh::default()
    };
    let topology = Topology::new(&mesh);
    assert_eq!(topology.edges(), [[0, 1], [0, 2], [1, 2]]);
    assert_eq!(topology.vertex_faces().row(1), [0, 1, 2, 3]);
    assert!(topology.boundary_loops().is_empty());
    let laplacian = Laplacian::cotangent(&mesh, &topology);
    assert!(laplacian.rows().flat_map(|(_, weights)| weights).all(|w| w.is_finite()));
}

#[test]
fn curves_and_tets_have_edges_too() {
    let mesh = Mesh {
        positions: vec![[0.0; 3]; 8],
        curves: Ragged::from_iter([vec![4, 5, 6, 4]]),
        tets: vec![[3, 2, 1, 0]],
        ..Mesh::default()
    };
    let topology = Topology::new(&mesh);
    let expected: [[u32; 2]; 9] =
        [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3], [4, 5], [4, 6], [5, 6]];
    assert_eq!(topology.edges(), expected);
    assert!(topology.neighbours().row(7).is_empty());
    assert!(topology.boundary_loops().is_empty());
    assert!(!topology.is_quad_dominant());
    let uniform = Laplacian::uniform(&topology);
    assert_eq!(uniform.row(0), (&[1, 2, 3][..], &[1.0; 3][..]));
}

#[test]
fn the_kind_of_mesh_is_told_by_its_faces() {
    let [triangle, quads, nothing] = [with_faces(3, &[[0, 1, 2]]), wavy(2, 2), Mesh::default()];
    let kind =
        |mesh: &Mesh| (Laplacian::has_cotangents(mesh), Topology::new(mesh).is_quad_dominant());
    assert_eq!(
        [&triangle, &quads, &nothing].map(kind),
        [(true, false), (false, true), (false, false)]
    );
}

#[test]
fn the_cotangents_of_a_regular_hexagon_are_equal() {
    let half = 0.5;
    let height = 0.75_f64.sqrt();
    let positions: Vec<Point> = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [half, height, 0.0],
        [-half, height, 0.0],
        [-1.0, 0.0, 0.0],
        [-half, -height, 0.0],
        [half, -height, 0.0],
    ];
    let faces = (1..7).map(|k| [0, k, k % 6 + 1]).collect();
    let mesh = Mesh { positions, faces, ..Mesh::default() };
    let laplacian = Laplacian::cotangent(&mesh, &Topology::new(&mesh));
    let cot_60 = (1.0_f64 / 3.0).sqrt();
    let (_, spokes) = laplacian.row(0);
    assert!(spokes.iter().all(|w| (w - cot_60).abs() < 1e-15));
    let (neighbours, weights) = laplacian.row(1);
    assert_eq!(neighbours, [0, 2, 6]);
    // An edge on the boundary has one term.
    assert!((weights[1] - 0.5 * cot_60).abs() < 1e-15);
}

#[test]
fn an_edge_of_no_face_has_weight_one_beside_cotangents() {
    // A guide curve across two triangles: this panicked.
    let mut mesh = with_faces(4, &[[0, 1, 2], [1, 3, 2]]);
    mesh.curves.push(&[0, 3]);
    let with_curve = Laplacian::cotangent(&mesh, &Topology::new(&mesh));
    mesh.curves = Ragged::new();
    let without = Laplacian::cotangent(&mesh, &Topology::new(&mesh));
    assert_eq!(with_curve.row(0), (&[1, 2, 3][..], &[without.row(0).1, &[1.0]].concat()[..]));
    assert_eq!(with_curve.row(1), without.row(1));
}

#[test]
fn closed_meshes_have_the_euler_characteristic_of_their_genus() {
    let known = [
        ("gc_dodecahedron_poly.obj", 2),
        ("bunny_poly.obj", 2),
        ("horse_quad.obj", 2),
        ("decimated-knight.off", 2),
        ("trimesh_quadknot.obj", 0),
    ];
    for (name, expected) in known {
        let Some(mesh) = crate::support::shared::mesh(name) else { continue };
        let topology = Topology::new(&mesh);
        assert!(topology.boundary_loops().is_empty(), "{name} is closed");
        let count = |n: usize| n as i64;
        let euler =
            count(mesh.positions.len()) - count(topology.edges().len()) + count(mesh.faces.len());
        assert_eq!(euler, expected, "{name}");
        let labels = components(mesh.positions.len(), mesh.faces.iter());
        assert!(labels.iter().all(|&label| label == 0), "{name} is connected");
    }
}

#[test]
fn open_meshes_have_the_boundary_loops_that_one_sees() {
    let known =
        [("halftunnel.off", 3), ("compas_hypar.obj", 1), ("camelhead.off", 1), ("cmc1.obj", 2)];
    for (name, loops) in known {
        let Some(mesh) = crate::support::shared::mesh(name) else { continue };
        assert_eq!(Topology::new(&mesh).boundary_loops().len(), loops, "{name}");
    }
}
