//! A boundary that is held exactly: on its curve after every iteration, gliding along it, with
//! fixed corners and energies that never rise.

use crate::support::drag;
use crate::support::meshes::grid;
use shape_up::math::{Vec3, cosine};
use shape_up::mesh::{BoundaryCurves, Mesh, Point, Topology};
use shape_up::scene::Scene;
use shape_up::session::{Edit, Session};

/// Meshes with a boundary.
const MESHES: [&str; 9] = [
    "M2_eq_quad2.obj",
    "botanic-garden-bubble-0.obj",
    "cmc1.obj",
    "compas_faces_big.obj",
    "compas_hypar.obj",
    "compas_tubemesh.obj",
    "halftunnel.off",
    "hemisphere.obj",
    "pillow_1.obj",
];

fn opened(mesh: &Mesh, rest: &str) -> Session {
    let scene = Scene::from_json(&format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "a.obj" }}, {rest} }}"#
    ));
    Session::open(scene.expect("the scene is valid"), mesh.clone()).expect("it is regular")
}

/// Greatest distance of a boundary vertex from its own loop, by brute force over the segments, and
/// greatest displacement of a corner.
fn off_curve(mesh: &Mesh, positions: &[Point]) -> [f64; 2] {
    let topology = Topology::new(mesh);
    let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
    let mut off = 0.0f64;
    for one in topology.boundary_loops().iter() {
        let n = one.len();
        for &v in one {
            let p = Vec3::from(positions[v as usize]);
            let distance = |k: usize| {
                let (a, b) = (at(one[k]), at(one[(k + 1) % n]));
                let t = (p - a).dot(b - a) / (b - a).length_squared().max(f64::MIN_POSITIVE);
                (p - (a + (b - a) * t.clamp(0.0, 1.0))).length()
            };
            off = off.max((0..n).map(distance).fold(f64::INFINITY, f64::min));
        }
    }
    let corners = BoundaryCurves::new(&mesh.positions, &topology, cosine(45.0 / 360.0)).corners;
    let moved = |v: &u32| (Vec3::from(positions[*v as usize]) - at(*v)).length();
    [off, corners.iter().map(moved).fold(0.0, f64::max)]
}

fn size(mesh: &Mesh) -> f64 {
    let bound = |pick: fn(f64, f64) -> f64| {
        let fold = |a: Point, b: &Point| std::array::from_fn(|i| pick(a[i], b[i]));
        Vec3::from(mesh.positions[1..].iter().fold(mesh.positions[0], fold))
    };
    (bound(f64::max) - bound(f64::min)).length()
}

const FIG_5: &str = r#""constraints": [{ "kind": "circle", "on": "faces" }],
    "weights": { "shape": 5, "close": 10, "smooth": 2 },
    "closeness": { "boundary": { "require": "exact" } }"#;
const OWN: &str = r#""constraints": [{ "kind": "plane", "on": "faces" }],
    "weights": { "shape": 1000, "close": 1, "smooth": 1 },
    "smoothness": { "of": "displacement", "weighting": "uniform" },
    "closeness": { "to": "rest", "boundary": { "require": "exact" } }"#;

/// Iterates; after every iteration the total must not have risen and the boundary must be on its
/// curve.
fn run_on_curve(session: &mut Session, mesh: &Mesh, iterations: u32, name: &str) {
    let mut before = session.solver().energy().total;
    for k in 0..iterations {
        session.step().expect("positions stay finite");
        let now = session.solver().energy().total;
        assert!(now <= before, "{name}: iteration {k}: {before} -> {now}");
        before = now;
        let [off, corner] = off_curve(mesh, &session.positions());
        assert!(off <= 1e-15 * size(mesh), "{name}: iteration {k}: {off}");
        assert_eq!(corner, 0.0, "{name}: iteration {k}");
        if session.solver().converged() {
            break;
        }
    }
}

#[test]
fn on_real_meshes_the_boundary_is_on_its_curve_and_the_energy_never_rises() {
    for file in MESHES {
        let Some(mesh) = crate::support::shared::mesh(file) else { continue };
        for scene in [FIG_5, OWN] {
            for accelerator in ["quasi-newton", "none", "anderson"] {
                let solver = format!(r#""solver": {{ "accelerator": "{accelerator}" }}"#);
                let mut session = opened(&mesh, &format!("{scene}, {solver}"));
                run_on_curve(&mut session, &mesh, 40, &format!("{file} {accelerator}"));
            }
        }
    }
}

/// The limit of a soft boundary for increasing weight: the exact result has no higher energy.
#[test]
fn its_energy_is_the_limit_of_soft_boundaries() {
    for file in ["M2_eq_quad2.obj", "compas_tubemesh.obj", "halftunnel.off"] {
        let Some(mesh) = crate::support::shared::mesh(file) else { continue };
        let solved = |boundary: &str, iterations: u32| {
            let scene = FIG_5.replace(r#""require": "exact""#, boundary);
            let mut session = opened(&mesh, &scene);
            for _ in 0..iterations {
                session.step().expect("positions stay finite");
            }
            (session.solver().energy().total, off_curve(&mesh, &session.positions())[0])
        };
        let [loose, near, exact] = [
            solved(r#""weight": 1"#, 300),
            solved(r#""weight": 1000"#, 2000),
            solved(r#""require": "exact""#, 300),
        ];
        assert!(loose.0 < exact.0 && loose.1 > 1e-3 * size(&mesh), "{file}: {loose:?}");
        assert!((exact.0 - near.0).abs() < 2e-3 * exact.0, "{file}: {exact:?}, {near:?}");
    }
}

fn graded() -> Mesh {
    let at = |k: u32| f64::from(k * (k + 4)) / 12.0;
    grid(8, 8, |i, j| [at(i), at(j), 0.0])
}

#[test]
fn vertices_glide_along_straight_sides_to_where_a_squared_grid_has_them() {
    let mesh = graded();
    let mut session = opened(
        &mesh,
        r#""constraints": [{ "kind": "square", "on": "faces" }],
        "closeness": { "to": "none", "boundary": { "require": "exact" } }"#,
    );
    run_on_curve(&mut session, &mesh, 400, "graded");
    // Sides of equal length with fixed corners: the squares are the cells of a regular grid.
    let positions = session.positions();
    for (v, p) in positions.iter().enumerate() {
        let expected = [(v % 9) as f64, (v / 9) as f64];
        assert!((p[0] - expected[0]).abs() < 1e-3 && (p[1] - expected[1]).abs() < 1e-3, "{p:?}");
    }
    assert!(session.report().pinned.is_empty(), "the boundary holds it");
}

#[test]
fn a_soft_handle_pulls_along_the_curve_and_a_fixed_one_takes_its_vertex_off() {
    let mesh = graded();
    let mut session = opened(&mesh, OWN);
    session
        .edit(Edit::AddHandles { vertices: vec![4, 80], fixed: false })
        .expect("the vertices are there");
    let [x, _, _] = mesh.positions[4];
    session.begin_drag();
    drag(&mut session, [(4, [x + 0.3, -5.0, 2.0]), (80, [20.0, 20.0, 0.0])])
        .expect("they are near");
    run_on_curve(&mut session, &mesh, 50, "soft");
    assert!(session.positions()[4][0] > x + 0.1, "it glides: {:?}", session.positions()[4]);
    session.edit(Edit::RemoveHandles { vertices: vec![4, 80] }).expect("they are there");
    session.edit(Edit::AddHandles { vertices: vec![4], fixed: true }).expect("it is there");
    session.begin_drag();
    drag(&mut session, [(4, [x, -5.0, 2.0])]).expect("it is near");
    session.step().expect("positions stay finite");
    assert_eq!(session.positions()[4], [x, -5.0, 2.0], "a fixed handle says where it is");
    session.edit(Edit::RemoveHandles { vertices: vec![4] }).expect("it is there");
    assert_eq!(off_curve(&mesh, &session.positions()), [0.0; 2], "without it, it is back");
    session.undo().expect("undo works");
    assert_eq!(session.positions()[4], [x, -5.0, 2.0]);
}

#[test]
fn corners_hold_a_mesh_whatever_the_order_of_its_vertices() {
    // The apex of a tent was pinned if it came first in the file, and stayed up.
    let [apex, corners] = [[0.0, 0.0, 1.0], [-1.0, 1.0, 0.0]];
    let around =
        |low: f64, high: f64| [[low, low, 0.0], [high, low, 0.0], [high; 3], [low, high, 0.0]];
    for first in [true, false] {
        let mut positions = around(corners[0], corners[1]).map(|[x, y, _]| [x, y, 0.0]).to_vec();
        positions.insert(if first { 0 } else { 4 }, apex);
        let mut mesh = Mesh { positions, ..Mesh::default() };
        let place = |corner: u32| corner + u32::from(first);
        for k in 0..4 {
            mesh.faces.push(&[place(k), place((k + 1) % 4), if first { 0 } else { 4 }]);
        }
        let mut session = opened(
            &mesh,
            r#""constraints": [{ "kind": "plane", "on": { "vertices": "0-4" } }],
               "weights": { "shape": 1, "close": 0 },
               "closeness": { "boundary": { "require": "exact", "corners": 45 } }"#,
        );
        session.solve(false).expect("positions stay finite");
        let height = session.positions()[if first { 0 } else { 4 }][2];
        assert!(height.abs() < 1e-6, "{first}: {height}");
    }
}

#[test]
fn a_mesh_that_is_all_boundary_stays_on_it() {
    let strip = grid(6, 1, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * i)]);
    for close in [0, 1] {
        let mut session = opened(
            &strip,
            &format!(
                r#""constraints": [{{ "kind": "square", "on": "faces" }}],
                "weights": {{ "shape": 1, "close": {close} }},
                "closeness": {{ "boundary": {{ "require": "exact", "corners": 180 }} }}"#
            ),
        );
        let first = session.solver().energy().total;
        let mut off = 0.0f64;
        for _ in 0..60 {
            session.step().expect("positions stay finite");
            off = off.max(off_curve(&strip, &session.positions())[0]);
        }
        assert!(off <= 1e-15 * size(&strip), "{off}");
        assert!(session.solver().energy().total < 0.9 * first);
    }
}

#[test]
fn hard_constraints_are_met_with_the_boundary_on_its_curve() {
    let mesh = grid(8, 8, |i, j| {
        let [x, y] = [f64::from(i), f64::from(j)];
        [x, y, 0.05 * x * y + 0.1 * libm::sin(3.0 * x + y)]
    });
    let scene = OWN.replace(r#""on": "faces""#, r#""on": "faces", "require": "exact""#);
    let mut session = opened(&mesh, &scene);
    session.solve(false).expect("positions stay finite");
    let [off, _] = off_curve(&mesh, &session.positions());
    assert!(off <= 1e-12 * size(&mesh), "{off}");
    let exact = session.exact().expect("it was met");
    assert!(exact.met, "{exact:?}");
}

#[test]
fn hard_constraints_of_a_mesh_that_is_all_boundary_are_met_along_it() {
    // Nothing was tried: all of its vertices counted as fixed, though they glide.
    let strip = grid(6, 1, |i, j| {
        let along = f64::from(j) * 0.2 * libm::sin(std::f64::consts::PI * f64::from(i) / 6.0);
        let x = f64::from(i) + along;
        [x, f64::from(j), 0.05 * x * x]
    });
    let panels = r#""on": "faces", "require": { "within": 1e-3 }"#;
    let mut session = opened(&strip, &OWN.replace(r#""on": "faces""#, panels));
    session.solve(false).expect("positions stay finite");
    let exact = session.exact().expect("it was tried");
    assert!(exact.met && exact.iterations > 0, "{exact:?}");
    let [off, corner] = off_curve(&strip, &session.positions());
    assert!(off <= 1e-15 * size(&strip) && corner == 0.0, "{off} {corner}");
}
