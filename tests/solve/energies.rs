//! The energies of Eq. 13, each against its definition as explicit sums over the mesh.

use crate::support::random::Random;
use shape_up::math::Vec3;
use shape_up::mesh::{Mesh, Point, Surface, Topology};
use shape_up::scene::{Accelerator, Scene, SmoothnessOf, Weighting};
use shape_up::session::{Edit, Session};

fn scene(rest: &str) -> Scene {
    let text = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }}{rest} }}"#
    );
    Scene::from_json(&text).expect("the scene is valid")
}

/// The wavy grid; with `triangles`, its quads are split.
fn grid(triangles: bool) -> Mesh {
    let mut mesh = crate::support::meshes::wavy(4, 3);
    if triangles {
        let halves = |f: &[u32]| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]];
        mesh.faces = mesh.faces.iter().flat_map(halves).collect();
    }
    mesh
}

fn disturbed(mesh: &Mesh) -> Vec<Point> {
    let mut random = Random::new(3);
    mesh.positions.iter().map(|&p| (Vec3::from(p) + random.vector() * 0.3).into()).collect()
}

fn squared(a: Point, b: Point) -> f64 {
    (Vec3::from(a) - Vec3::from(b)).length_squared()
}

fn assert_close(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() <= 1e-12 * expected.max(1.0), "{what}: {found}, {expected}");
}

/// A session that starts from the disturbed positions.
fn disturbed_session(rest: &str, mesh: &Mesh) -> Session {
    let mut scene = scene(rest);
    scene.current = Some(disturbed(mesh));
    Session::open(scene, mesh.clone()).expect("the scene fits the mesh")
}

/// Cotangent of the angle at `at`.
fn cotangent(at: Point, a: Point, b: Point) -> f64 {
    let (u, v) = (Vec3::from(a) - Vec3::from(at), Vec3::from(b) - Vec3::from(at));
    u.dot(v) / u.cross(v).length()
}

/// `sum_i |sum_j w_ij (l_j - l_i)|^2`, by face sides.
fn smooth(mesh: &Mesh, l: &[Vec3<f64>], cotangents: bool) -> f64 {
    let mut rows = vec![Vec3::zero(); l.len()];
    let topology = Topology::new(mesh);
    for (&[i, j], faces) in topology.edges().iter().zip(topology.edge_faces().iter()) {
        let mut weight = if cotangents { 0.0 } else { 1.0 };
        for &f in faces.iter().filter(|_| cotangents) {
            let face = mesh.faces.row(f as usize);
            let opposite = face.iter().find(|&&v| v != i && v != j).expect("a triangle");
            let [at, a, b] = [*opposite, i, j].map(|v| mesh.positions[v as usize]);
            weight += cotangent(at, a, b) / 2.0;
        }
        let difference = (l[j as usize] - l[i as usize]) * weight;
        rows[i as usize] += difference;
        rows[j as usize] += difference * -1.0;
    }
    rows.iter().map(|row| row.length_squared()).sum()
}

#[test]
fn smoothness_is_that_of_eq_12_for_every_choice() {
    use SmoothnessOf::{Displacement, Surface};
    use Weighting::{Auto, Cotangent, Uniform};
    for (triangles, weighting, cotangents) in [
        (false, Auto, false),
        (false, Uniform, false),
        (true, Auto, true),
        (true, Uniform, false),
        (true, Cotangent, true),
    ] {
        for of in [Surface, Displacement] {
            let mesh = grid(triangles);
            let mut scene = scene(r#", "weights": { "smooth": 3 }"#);
            scene.smoothness.of = of;
            scene.smoothness.weighting = weighting;
            scene.current = Some(disturbed(&mesh));
            let session = Session::open(scene, mesh.clone()).expect("the scene fits the mesh");
            let l = disturbed(&mesh).into_iter().zip(&mesh.positions).map(|(v, &rest)| match of {
                Surface => v.into(),
                Displacement => Vec3::from(v) - rest.into(),
            });
            let expected = smooth(&mesh, &l.collect::<Vec<_>>(), cotangents);
            let energy = session.solver().energy();
            assert_close(energy.smooth, expected, &format!("{triangles} {weighting:?} {of:?}"));
            assert_close(energy.total, 3.0 * expected, "total");
        }
    }
}

/// One guide line made the weights of the whole surface uniform.
#[test]
fn a_line_beside_triangles_leaves_their_weights_as_they_are() {
    let mut mesh = grid(true);
    let first = mesh.positions.len() as u32;
    mesh.positions.extend([[9.0, 0.0, 0.0], [9.0, 1.0, 0.0]]);
    mesh.curves.push(&[first, first + 1]);
    let [chosen, asked] = [Weighting::Auto, Weighting::Cotangent].map(|weighting| {
        let mut scene = scene(r#", "weights": { "smooth": 3 }"#);
        scene.smoothness.weighting = weighting;
        scene.current = Some(disturbed(&mesh));
        let session = Session::open(scene, mesh.clone()).expect("the scene fits the mesh");
        session.solver().energy().smooth
    });
    assert_eq!(chosen, asked);
}

/// For the grid of 4 by 3 quads: closeness of the first row times 5, of the first vertex times 0.
const WEIGHTS: &str = r#""weights": [{ "on": { "set": "row" }, "weight": 5 },
    { "on": { "vertices": [0] }, "weight": 0 }]"#;
const ROW: &str = r#", "sets": { "row": { "vertices": "0-4" } }, "weights": { "close": 2 }"#;

fn factor(v: usize) -> f64 {
    [0.0, 5.0, 5.0, 5.0, 5.0].get(v).copied().unwrap_or(1.0)
}

#[test]
fn closeness_is_the_sum_of_weighted_squared_distances() {
    let mesh = grid(false);
    let surface = Surface::new(&mesh.positions, &mesh);
    for to in ["surface", "rest", "none"] {
        let closeness = format!(r#"{ROW}, "closeness": {{ "to": "{to}", {WEIGHTS} }}"#);
        let energy = disturbed_session(&closeness, &mesh).solver().energy();
        let expected = disturbed(&mesh).into_iter().enumerate().map(|(v, p)| {
            let closest = match to {
                "surface" => surface.closest(p, &mut { Surface::NO_HINT }),
                "rest" => mesh.positions[v],
                _ => p,
            };
            factor(v) * squared(p, closest)
        });
        let expected = expected.sum();
        assert_close(energy.close, expected, to);
        assert_close(energy.total, 2.0 * expected, "total");
    }
}

#[test]
fn all_energies_add_up_to_the_total() {
    let mesh = grid(false);
    let energy = disturbed_session(
        r#", "constraints": [{ "kind": "plane", "on": "faces", "weight": 0.5 },
                             { "kind": "square", "on": "faces" }],
            "handles": [{ "vertices": [3], "weight": 7, "targets": [[9, 9, 9]] }],
            "weights": { "shape": 5, "close": 10, "smooth": 2 }"#,
        &mesh,
    );
    let energy = energy.solver().energy();
    assert_close(energy.handles, 7.0 * squared(disturbed(&mesh)[3], [9.0; 3]), "handles");
    let total = 5.0 * energy.shape + 10.0 * energy.close + 2.0 * energy.smooth + energy.handles;
    assert_close(energy.total, total, "total");
}

/// Vertices kept close with different weights, and one pulled away by a handle.
fn pulled(to: &str, accelerator: Accelerator) -> Scene {
    let rest = format!(
        r#"{ROW}, "closeness": {{ "to": "{to}", {WEIGHTS} }}, "smoothness": {{ "of": "displacement" }},
            "handles": [{{ "vertices": [7], "weight": 3, "targets": [[1, 1, 1]] }}]"#
    );
    let mut scene = scene(&rest);
    scene.weights.smooth = 0.3;
    scene.solver.accelerator = accelerator;
    scene
}

/// Checks that the energy of a session rises, whichever vertex moves in any direction.
fn assert_lowest(session: &Session, mut scene: Scene, mesh: &Mesh, what: &str) {
    let (least, lowest) = (session.solver().energy().total, session.positions());
    for v in 0..mesh.positions.len() {
        for i in 0..3 {
            for by in [-1e-3, 1e-3] {
                let mut moved = lowest.clone();
                moved[v][i] += by;
                scene.current = Some(moved);
                let session = Session::open(scene.clone(), mesh.clone()).expect("it fits");
                let energy = session.solver().energy().total;
                assert!(energy > least, "{what}, vertex {v}: {energy}, {least}");
            }
        }
    }
}

#[test]
fn the_step_minimises_what_the_energies_say() {
    // Every part is quadratic for given targets, and the targets of closeness to the rest positions
    // and of smoothness are fixed: one plain step reaches the minimum, from where the energy can
    // only rise, whichever vertex moves in any direction.
    let mesh = grid(true);
    let scene = pulled("rest", Accelerator::None);
    let mut session = Session::open(scene.clone(), mesh.clone()).expect("it fits");
    session.step().expect("positions stay finite");
    let least = session.solver().energy().total;
    assert!(least > 0.1, "the handle contradicts the rest: {least}");
    assert_lowest(&session, scene, &mesh, "a plain step");
}

#[test]
fn every_accelerator_ends_where_the_energies_are_least() {
    // Its steps follow the gradient, in which every vertex has its own weight.
    let mesh = grid(true);
    for (to, accelerator) in ["rest", "surface"]
        .into_iter()
        .flat_map(|to| [(to, Accelerator::QuasiNewton), (to, Accelerator::Anderson)])
    {
        let mut scene = pulled(to, accelerator);
        scene.solver.tolerance = 0.0;
        let mut session = Session::open(scene.clone(), mesh.clone()).expect("it fits");
        (0..400).for_each(|_| _ = session.step().expect("positions stay finite"));
        assert_lowest(&session, scene, &mesh, &format!("{to}, {accelerator:?}"));
    }
}

#[test]
fn without_mean_centring_the_energy_is_the_same_and_the_step_is_shorter() {
    let mesh = grid(false);
    let step = |mean_centring: bool| {
        let mut scene = scene(r#", "constraints": [{ "kind": "square", "on": "faces" }]"#);
        scene.solver.mean_centring = mean_centring;
        scene.solver.accelerator = Accelerator::None;
        scene.current = Some(disturbed(&mesh));
        let mut session = Session::open(scene, mesh.clone()).expect("it fits");
        let before = session.solver().energy().shape;
        session.step().expect("positions stay finite");
        (before, session.solver().energy().shape, session.report().pinned)
    };
    let (with, without) = (step(true), step(false));
    assert_close(with.0, without.0, "the projections are translated back");
    assert!(with.1 < 0.9 * without.1 && without.1 < without.0, "{with:?} {without:?}");
    assert_eq!((with.2, without.2), (vec![0], vec![]), "without, shapes hold their places");
}

#[test]
fn a_part_all_of_whose_weights_are_zero_is_pinned() {
    // Two grids; the second one has no closeness.
    let mut mesh = grid(false);
    let n = mesh.positions.len() as u32;
    let beside = mesh.positions.iter().map(|p| [p[0] + 9.0, p[1], p[2]]).collect::<Vec<_>>();
    mesh.positions.extend(beside);
    let faces: Vec<Vec<u32>> =
        mesh.faces.iter().map(|face| face.iter().map(|v| v + n).collect()).collect();
    faces.iter().for_each(|face| mesh.faces.push(face));
    let pinned = |weights: &str| {
        let rest = format!(
            r#", "constraints": [{{ "kind": "square", "on": "faces" }}], "weights": {{ "close": 1 }},
                "closeness": {{ "weights": [{weights}] }}"#
        );
        Session::open(scene(&rest), mesh.clone()).expect("pins make it regular").report().pinned
    };
    assert!(pinned("").is_empty());
    let second = format!(r#"{{ "vertices": "{n}-{}" }}"#, 2 * n - 1);
    assert_eq!(pinned(&format!(r#"{{ "on": {second}, "weight": 0 }}"#)), [n]);
    // One vertex is enough.
    let but_one = format!(r#"{{ "on": {{ "vertices": [{}] }}, "weight": 1e-3 }}"#, n + 2);
    assert!(pinned(&format!(r#"{{ "on": {second}, "weight": 0 }}, {but_one}"#)).is_empty());
    assert_eq!(pinned(r#"{ "on": "faces", "weight": 0 }"#), [0, n]);
}

#[test]
fn what_weighs_more_moves_less() {
    let mesh = grid(false);
    let moved = |weight: f64| {
        let closeness = format!(
            r#", "constraints": [{{ "kind": "plane", "on": {{ "vertices": "0-19" }} }}],
               "weights": {{ "shape": 1, "close": 1 }},
               "closeness": {{ "to": "rest", "weights": [{{ "on": "boundary", "weight": {weight} }}] }}"#
        );
        let mut session = Session::open(scene(&closeness), mesh.clone()).expect("it fits");
        session.solve(false).expect("positions stay finite");
        let positions = session.positions();
        let of = |v: usize| squared(positions[v], mesh.positions[v]);
        // Squared displacement of a corner, and the sum over the inner vertices.
        (of(4), [6, 7, 8, 11, 12, 13].map(of).iter().sum::<f64>())
    };
    let (some, more, none) = (moved(1.0), moved(100.0), moved(0.0));
    assert!(more.0 < 1e-2 * some.0 && more.1 > some.1, "{some:?} {more:?}");
    assert!(none.0 > 1.5 * some.0 && none.1 < 0.5 * some.1, "{some:?} {none:?}");
}

#[test]
fn edits_keep_the_weights_and_can_change_them() {
    let mesh = grid(false);
    let closeness = format!(r#"{ROW}, "closeness": {{ "to": "rest", {WEIGHTS} }}"#);
    let mut session = disturbed_session(&closeness, &mesh);
    let before = (session.scene(), session.solver().energy());
    session.edit(Edit::AddHandles { vertices: vec![9], fixed: true }).expect("it fits");
    session.edit(Edit::RemoveHandles { vertices: vec![9] }).expect("it fits");
    assert_eq!((session.scene(), session.solver().energy()), before);

    session.edit(Edit::HoldClose { vertices: None, weight: 1.0 }).expect("it fits");
    assert_eq!(session.scene().closeness.weights, []);
    assert!(session.solver().energy().close != before.1.close);
    session.undo().expect("the state before can be solved");
    assert_eq!((session.scene(), session.solver().energy()), before);

    let wrong = Edit::HoldClose { vertices: Some(vec![3]), weight: -1.0 };
    let error = session.edit(wrong).expect_err("it is negative").to_string();
    assert!(error.contains("closeness.weights[2].weight"), "{error}");
    assert_eq!((session.scene(), session.solver().energy()), before);
}
