//! Accelerated steps use single precision. This must not be noticeable for any unit of the mesh,
//! any weights, or in the final shape.

use crate::support::grid::grid;
use shape_up::mesh::{Mesh, Point};
use shape_up::scene::{Accelerator, Scene};
use shape_up::session::Session;

/// A bumpy square of quads around the origin, so that powers of two scale it without rounding.
fn bumpy(n: u32) -> Mesh {
    grid(n, n, |i, j| {
        let bump = f64::from((i * 31 + j * 17) % 23) / 64.0;
        let at = |i: u32| f64::from(2 * i) - f64::from(n);
        [at(i) + 0.25 * bump, at(j) - 0.375 * bump, 0.125 * at(i) * at(j) + bump]
    })
}

const ACCELERATORS: [Accelerator; 2] = [Accelerator::QuasiNewton, Accelerator::Anderson];

fn session(scene: &str, accelerator: Accelerator, mesh: Mesh) -> Session {
    let text = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }}, {scene},
              "solver": {{ "tolerance": 0 }} }}"#
    );
    let mut scene = Scene::from_json(&text).expect("the scene is valid");
    scene.solver.accelerator = accelerator;
    Session::open(scene, mesh).expect("the scene fits the grid")
}

fn stepped(mut session: Session, steps: u32) -> Session {
    for _ in 0..steps {
        session.step().expect("positions stay finite");
    }
    session
}

/// Planes, a handle that pulls a corner by `by`, and weights, all multiplied by `weight`.
fn pulled(weight: f64, by: Point) -> String {
    let [x, y, z] = by;
    format!(
        r#""constraints": [{{ "kind": "plane", "on": "faces" }}],
           "weights": {{ "shape": {}, "close": {}, "smooth": {} }},
           "closeness": {{ "to": "rest" }},
           "handles": [{{ "vertices": [0], "fixed": true }},
                       {{ "vertices": [80], "targets": [[{x}, {y}, {z}]], "weight": {} }}]"#,
        4.0 * weight,
        0.5 * weight,
        weight,
        32.0 * weight,
    )
}

#[test]
fn units_and_weights_that_are_powers_of_two_change_no_digit() {
    for accelerator in ACCELERATORS {
        let target = [9.0, 10.0, 11.0];
        let expected =
            stepped(session(&pulled(1.0, target), accelerator, bumpy(8)), 20).positions();
        for (unit, weight) in [(40, 0), (-40, 0), (0, 60), (0, -60), (-70, 50), (60, -80)] {
            let (unit, weight) = (f64::powi(2.0, unit), f64::powi(2.0, weight));
            let mut mesh = bumpy(8);
            mesh.positions.as_flattened_mut().iter_mut().for_each(|x| *x *= unit);
            let scene = pulled(weight, target.map(|x| x * unit));
            let found = stepped(session(&scene, accelerator, mesh), 20).positions();
            for (found, expected) in found.iter().zip(&expected) {
                assert_eq!(found.map(|x| x / unit), *expected, "{unit} {weight}");
            }
        }
    }
}

#[test]
fn what_is_far_from_the_origin_moves_as_it_does_near_it() {
    for accelerator in ACCELERATORS {
        let target = [9.0, 10.0, 11.0];
        let near = stepped(session(&pulled(1.0, target), accelerator, bumpy(8)), 20).positions();
        let offset = [2_650_000.0, 1_180_000.0, 430.0];
        let moved = |p: Point| [0, 1, 2].map(|i| p[i] + offset[i]);
        let mut mesh = bumpy(8);
        mesh.positions.iter_mut().for_each(|p| *p = moved(*p));
        let scene = pulled(1.0, moved(target));
        let far = stepped(session(&scene, accelerator, mesh), 20).positions();
        for (far, near) in far.iter().zip(&near) {
            let moved = moved(*near);
            assert!((0..3).all(|i| (far[i] - moved[i]).abs() < 1e-7), "{far:?} is not {moved:?}");
        }
    }
}

#[test]
fn weights_far_apart_neither_stop_nor_mislead_it() {
    // The weak point of an f32 factor: a stiff part that moves as a whole against a weak one.
    for (shape, close, handle) in
        [(1.0, 1e-6, 1e4), (1e6, 1e-6, 1.0), (1e-6, 1e-9, 1e6), (1e3, 1e-7, 1e-4)]
    {
        let scene = format!(
            r#""constraints": [{{ "kind": "rigid", "on": "faces" }}],
               "weights": {{ "shape": {shape}, "close": {close} }}, "closeness": {{ "to": "rest" }},
               "handles": [{{ "vertices": [0], "targets": [[-9, -8, 7]], "weight": {handle} }}]"#
        );
        let plain = stepped(session(&scene, Accelerator::None, bumpy(8)), 200);
        for accelerator in ACCELERATORS {
            let mut session = session(&scene, accelerator, bumpy(8));
            let mut before = session.solver().energy().total;
            for _ in 0..200 {
                session.step().expect("positions stay finite");
                let total = session.solver().energy().total;
                assert!(total <= before * (1.0 + 1e-9), "{total} after {before}: {scene}");
                before = total;
            }
            let plain = plain.solver().energy().total;
            assert!(before <= plain * (1.0 + 1e-3), "{accelerator:?} {before} {plain} {scene}");
        }
    }
}

#[test]
fn it_converges_to_the_last_digits_of_double_precision() {
    for accelerator in ACCELERATORS {
        let scene = pulled(1.0, [9.0, 10.0, 11.0]);
        let accelerated = stepped(session(&scene, accelerator, bumpy(8)), 600);
        assert_eq!(accelerated.positions()[0], bumpy(8).positions[0], "it is fixed");
        // Plain steps from there gain nothing.
        let mut scene = accelerated.scene();
        scene.solver.accelerator = Accelerator::None;
        let on = Session::open(scene, bumpy(8)).expect("it was open before");
        let further = stepped(on, 50).solver().energy().total;
        let total = accelerated.solver().energy().total;
        assert!(further >= total * (1.0 - 1e-12), "{accelerator:?}: {further} is below {total}");
    }
}

#[test]
fn plain_steps_on_a_large_mesh_are_those_of_its_parts() {
    // Large factors are in single precision for plain steps too, small ones in double. Many
    // disconnected copies of one part make a large factor: each must move in the same direction and
    // as far as alone.
    const COPIES: usize = 50;
    let one = bumpy(20);
    let n = one.positions.len();
    let mut many = Mesh::default();
    for k in 0..COPIES {
        many.positions.extend(&one.positions);
        for face in one.faces.iter() {
            many.faces.push(&face.iter().map(|v| v + (k * n) as u32).collect::<Vec<_>>());
        }
    }
    let scene = r#""constraints": [{ "kind": "circle", "on": "faces" }], "closeness": { "to": "rest" },
                   "weights": { "shape": 5, "close": 10, "smooth": 2 }"#;
    for steps in [1, 20] {
        let alone = stepped(session(scene, Accelerator::None, one.clone()), steps);
        let together = stepped(session(scene, Accelerator::None, many.clone()), steps);
        let factor = together.report().factor_nonzeros;
        assert!(factor > 1 << 19, "{factor}: the test needs a larger mesh");
        let energies = [&together, &alone].map(|session| session.solver().energy().total);
        let ratio = energies[0] / (COPIES as f64 * energies[1]);
        assert!((ratio - 1.0).abs() < 1e-9, "{steps} steps: {energies:?}");
        let places = alone.positions();
        for (v, place) in together.positions().iter().enumerate() {
            let apart = (0..3).map(|i| (place[i] - places[v % n][i]).abs()).fold(0.0, f64::max);
            assert!(apart < 1e-6, "{steps} steps: vertex {v} is {apart} off");
        }
    }
}
