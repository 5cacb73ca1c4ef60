//! Lengths, areas, angles and volumes that constraints keep or establish while handles move.

use crate::session::asked::{new, scene};
use crate::session::stories::{PLANES, run};
use crate::support::grid::{bumpy, grid};
use shape_up::mesh::Mesh;
use shape_up::scene::Accelerator;
use shape_up::session::Session;

/// Squared lengths of the edges and diagonals of the faces.
fn lengths(mesh: &Mesh, positions: &[[f64; 3]]) -> Vec<f64> {
    let mut lengths = Vec::new();
    for face in mesh.faces.iter() {
        for (k, &a) in face.iter().enumerate() {
            for &b in &face[k + 1..] {
                let (a, b) = (positions[a as usize], positions[b as usize]);
                lengths.push((0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt());
            }
        }
    }
    lengths
}

/// A strip of four panels, hinged at its cross edges: its last two vertices are moved away and fold
/// it.
const FOLD: &str = r#", "constraints": [{ "kind": "rigid", "on": "faces" }],
    "handles": [{ "vertices": [0, 5], "fixed": true },
                { "vertices": [4, 9], "targets": [[2.5, 0, 0.5], [2.5, 1, 0.5]], "weight": 1 }]"#;

fn strip() -> Mesh {
    grid(4, 1, |i, j| [f64::from(i), f64::from(j), f64::from(i % 2) / 4.0])
}

#[test]
fn rigid_faces_keep_their_lengths_while_handles_move() {
    let mesh = strip();
    let mut scene = scene(FOLD);
    scene.solver.iterations = 2000;
    scene.solver.tolerance = 0.0;
    let mut session = Session::open(scene, mesh.clone()).expect("it is regular");
    session.solve(false).expect("positions stay finite");
    let moved = session.positions()[4][0];
    assert!((moved - 4.0).abs() > 1.0, "the handle has moved: {moved}");
    let rest = lengths(&mesh, &mesh.positions);
    for (found, rest) in lengths(&mesh, &session.positions()).iter().zip(rest) {
        assert!((found / rest - 1.0).abs() <= 1e-6, "{rest} has become {found}");
    }
}

#[test]
fn relative_shapes_never_raise_the_energy_of_the_plain_iteration() {
    for (id, limits) in [("rigid", ""), ("similar", ""), ("similar", r#", "scale": [0.9, 1.1]"#)] {
        let constraints = format!(
            r#", "constraints": [{{ "kind": "{id}", "on": "faces"{limits} }},
            {{ "kind": "{id}", "on": {{ "each": "ring", "radius": 1 }} }}],
            "handles": [{{ "vertices": [0, 1, 5, 6], "fixed": true }},
                        {{ "vertices": [24], "targets": [[1, 1, 5]] }}]"#
        );
        let mut scene = scene(&constraints);
        scene.solver.accelerator = Accelerator::None;
        let mut session = Session::open(scene, bumpy(4)).expect("it is regular");
        let mut before = f64::INFINITY;
        session.begin_run();
        for step in 0..200 {
            session.step().expect("positions stay finite");
            let total = session.solver().energy().total;
            assert!(
                total <= before * (1.0 + 1e-13),
                "{id}{limits}, step {step}: {before} to {total}"
            );
            before = total;
        }
        session.end_run();
        assert!(before > 1e-3, "the handles contradict the shapes: {before}");
    }
}

/// Lengths of the edges between `vertices`.
fn edge_lengths(session: &Session, vertices: &[u32]) -> Vec<f64> {
    let positions = session.positions();
    let among = |v: &u32| vertices.contains(v);
    let edges = session.topology().edges().iter().filter(|ends| ends.iter().all(among));
    edges
        .map(|ends| {
            let [a, b] = ends.map(|v| positions[v as usize]);
            (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt()
        })
        .collect()
}

/// Greatest length divided by the least, minus one.
fn spread(lengths: &[f64]) -> f64 {
    let greatest = lengths.iter().fold(0.0, |m: f64, x| m.max(*x));
    greatest / lengths.iter().fold(f64::INFINITY, |m, x| m.min(*x)) - 1.0
}

fn solved(rest: &str, mesh: Mesh) -> Session {
    let mut scene = scene(rest);
    (scene.solver.iterations, scene.solver.tolerance) = (1000, 1e-14);
    let mut session = Session::open(scene, mesh).expect("it is regular");
    session.solve(false).expect("positions stay finite");
    session
}

#[test]
fn the_sides_of_faces_sets_and_curves_become_equally_long() {
    let separate = || {
        let mut mesh = bumpy(1);
        mesh.positions.extend([[5.0, 0.0, 0.0], [6.0, 0.2, 0.0], [8.0, 3.0, 1.0]]);
        mesh.faces.push(&[4, 5, 6]);
        mesh
    };
    // Each face has its own length.
    let on_faces = r#", "constraints": [{ "kind": "equal-length", "on": "faces" }]"#;
    let session = solved(on_faces, separate());
    assert!(spread(&edge_lengths(&session, &[0, 1, 2, 3])) <= 1e-6);
    assert!(spread(&edge_lengths(&session, &[4, 5, 6])) <= 1e-6);
    assert!(spread(&edge_lengths(&session, &[0, 1, 2, 3, 4, 5, 6])) > 0.1);

    // A set has one length, for exactly the edges between its vertices.
    let on_set = r#", "constraints": [{ "kind": "equal-length", "on": { "set": "corner" } }],
                      "sets": { "corner": { "vertices": "0-2,5-7,10-12" } }"#;
    let session = solved(on_set, bumpy(4));
    let corner = [0, 1, 2, 5, 6, 7, 10, 11, 12];
    assert_eq!(edge_lengths(&session, &corner).len(), 12);
    assert!(spread(&edge_lengths(&session, &corner)) <= 1e-6);
    assert!(spread(&edge_lengths(&session, &[20, 21, 22, 23, 24])) > 1e-3, "others are free");

    // A path between fixed ends whose segments share vertices.
    let mut path = Mesh {
        positions: [0.0, 0.1, 0.5, 2.0, 2.1, 4.0].map(|x: f64| [x, x * x / 4.0, 0.0]).to_vec(),
        ..Mesh::default()
    };
    path.curves.push(&[0, 1, 2, 3, 4, 5]);
    let on_curves = r#", "constraints": [{ "kind": "equal-length", "on": "curves" }],
                         "handles": [{ "vertices": [0, 5], "fixed": true }]"#;
    let session = solved(on_curves, path.clone());
    let lengths = edge_lengths(&session, &[0, 1, 2, 3, 4, 5]);
    assert_eq!(lengths.len(), 5);
    assert!(spread(&lengths) <= 1e-6, "{lengths:?}");
    assert_eq!(session.positions()[5], path.positions[5]);
}

#[test]
fn elements_without_two_edges_are_misfits_of_equal_lengths() {
    let mut session = Session::open(scene(PLANES), bumpy(2)).expect("it is regular");
    for (on, selected) in [("\"edges\"", "12"), (r#"{ "vertices": [0, 4, 8] }"#, "1")] {
        let error = session.edit(new("equal-length", on)).expect_err("one edge has but one length");
        let words = format!("2 or more edges, and none of the {selected} selected elements");
        assert!(error.to_string().contains(&words), "{error}");
    }
    let error = session.edit(new("angle", "\"faces\"")).expect_err("a quad has four corners");
    assert!(error.to_string().contains("exactly 3 vertices"), "{error}");
}

#[test]
fn thousands_of_equal_edges_couple_only_their_ends() {
    let n = 50;
    let all = r#", "constraints": [{ "kind": "equal-length", "on": { "vertices": "0-2600" } }]"#;
    let mesh = bumpy(n);
    let start = std::time::Instant::now();
    let mut session = Session::open(scene(all), mesh.clone()).expect("it is regular");
    let edges = 2 * n * (n + 1);
    assert_eq!(session.rows()[0].constraints.members.row(0).len(), 2 * edges as usize);
    let before = session.solver().energy().total;
    run(&mut session, 10);
    assert!(session.solver().energy().total < 0.5 * before);
    // No extra unknowns, and a factor as sparse as the factor of smoothness on the same mesh.
    let report = session.report();
    assert_eq!(report.unknowns, mesh.positions.len() - 1, "one vertex is pinned");
    let smooth = r#", "weights": { "shape": 1, "smooth": 1 }"#;
    let smooth = Session::open(scene(smooth), mesh).expect("it is regular").report();
    assert!(report.factor_nonzeros < smooth.factor_nonzeros, "{}", report.factor_nonzeros);
    let seconds = start.elapsed().as_secs_f64();
    assert!(seconds < 5.0, "took {seconds} s");
}

#[test]
fn corners_areas_and_hinges_of_a_mesh_come_to_what_is_asked() {
    // Two triangles per quad.
    let quads = bumpy(3);
    let mut mesh = Mesh { positions: quads.positions.clone(), ..Mesh::default() };
    for quad in quads.faces.iter() {
        mesh.faces.push(&[quad[0], quad[1], quad[2]]);
        mesh.faces.push(&[quad[0], quad[2], quad[3]]);
    }
    let on_hinges = r#", "constraints": [{ "kind": "bending", "on": "hinges" }]"#;
    let flat = solved(on_hinges, mesh.clone());
    assert!(flat.solver().energy().shape <= 1e-12, "{:?}", flat.solver().energy());
    let heights = lengths(&quads, &flat.positions());
    assert!(heights.iter().all(|length| *length > 0.1), "it is flat, not a point");
    let quad = |v: u32| flat.positions()[v as usize];
    let edge = |v| (0..3).map(|i| quad(v)[i] - quad(0)[i]).collect::<Vec<f64>>();
    let (a, b, c) = (edge(3), edge(12), edge(15));
    let volume: f64 = (0..3)
        .map(|i| a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]))
        .sum();
    assert!(volume.abs() <= 1e-5, "{volume}");

    let on_corners =
        r#", "constraints": [{ "kind": "angle", "on": "corners", "angle": [80, 100] }]"#;
    let right = solved(on_corners, grid(3, 3, |i, j| [f64::from(i + j), f64::from(j), 0.0]));
    assert!(right.solver().energy().shape <= 1e-10, "{:?}", right.solver().energy());

    let on_faces = r#", "constraints": [{ "kind": "area", "on": "faces", "area": 0.5 }]"#;
    let even = solved(on_faces, mesh);
    assert!(even.solver().energy().shape <= 1e-10, "{:?}", even.solver().energy());
}

#[test]
fn a_tetrahedron_that_is_inside_out_turns_back() {
    let mut mesh = Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        ..Mesh::default()
    };
    mesh.tets.push([0, 1, 2, 3]);
    let on_tets = r#", "constraints": [{ "kind": "volume", "on": "tets" }],
        "current": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, -0.5]]"#;
    let p = solved(on_tets, mesh).positions();
    let edge = |k: usize| [0, 1, 2].map(|i| p[k][i] - p[0][i]);
    let (a, b, c) = (edge(1), edge(2), edge(3));
    let volume: f64 = (0..3)
        .map(|i| a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]))
        .sum();
    assert!((volume - 1.0).abs() <= 1e-9, "{volume}");
}
