//! Other uses from paper section 6, with a second file: closeness to another surface, which
//! attracts the panels (registration), and the shapes of another pose (deformation transfer).

use crate::support::meshes::grid;
use shape_up::math::{cosine, sine};
use shape_up::mesh::{Mesh, Point, Ragged, Surface, write_obj};
use shape_up::scene::{BoundaryRequire, ClosenessTo, Scene, SceneError};
use shape_up::session::{Edit, Session};

/// A wave over the square from -1 to 1, of triangles that are unrelated to the panels.
fn wave() -> Mesh {
    let quads = grid(37, 31, |i, j| {
        let [x, y] = [f64::from(i) / 18.5 - 1.0, f64::from(j) / 15.5 - 1.0];
        [x, y, 0.25 * x * y + 0.2 * x * x]
    });
    let triangles = quads.faces.iter().flat_map(|f| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]);
    Mesh { faces: Ragged::from_iter(triangles.collect::<Vec<_>>()), ..quads }
}

fn panels() -> Mesh {
    grid(12, 12, |i, j| [f64::from(i) / 6.7 - 0.9, f64::from(j) / 6.7 - 0.9, 0.4])
}

/// Greatest distance from the surface, by a separate search.
fn off(surface: &Mesh, positions: &[Point]) -> f64 {
    let surface = Surface::new(&surface.positions, surface);
    let distance = |p: &Point| {
        let q = surface.closest(*p, &mut { Surface::NO_HINT });
        (0..3).map(|i| (p[i] - q[i]).powi(2)).sum::<f64>().sqrt()
    };
    positions.iter().map(distance).fold(0.0, f64::max)
}

fn scene(to: &str) -> Result<Scene, SceneError> {
    Scene::from_json(&format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "panels.obj" }},
            "constraints": [{{ "kind": "plane", "on": "faces" }}],
            "weights": {{ "shape": 1, "close": 1, "smooth": 0.001 }},
            "closeness": {{ "to": {to} }} }}"#
    ))
}

fn inline() -> String {
    let Mesh { positions, faces, .. } = wave();
    let faces: Vec<&[u32]> = faces.iter().collect();
    format!(r#"{{ "mesh": {{ "positions": {positions:?}, "faces": {faces:?} }} }}"#)
}

#[test]
fn panels_come_to_lie_on_the_other_surface_and_stay_flat() {
    let mut session =
        Session::open(scene(&inline()).expect("it is valid"), panels()).expect("it is regular");
    let before = off(&wave(), &session.positions());
    let mut energy = session.solver().energy();
    assert!(
        (energy.close
            - session.positions().iter().map(|p| off(&wave(), &[*p]).powi(2)).sum::<f64>())
        .abs()
            < 1e-12
    );
    for _ in 0..200 {
        session.step().expect("positions stay finite");
        assert!(session.solver().energy().total <= energy.total, "it never rises");
        energy = session.solver().energy();
    }
    let after = off(&wave(), &session.positions());
    assert!(before > 0.1 && after < 2e-3, "{before} {after}");
    assert!(session.report().planarity.max_distance < 1e-3);
}

#[test]
fn a_file_is_fitted_to_in_one_step_that_is_undone_and_shared() {
    let mut session =
        Session::open(scene(r#""rest""#).expect("it is valid"), panels()).expect("it is regular");
    let (first, file) = (session.scene(), write_obj(&wave(), &wave().positions));
    let fit = Edit::FitTo { name: "wave.obj".to_owned(), text: file };
    session.edit(fit.clone()).expect("it is a mesh");
    session.solve(false).expect("positions stay finite");
    assert!(off(&wave(), &session.positions()) < 5e-3);
    // A shared scene contains the surface.
    let shared = session.scene_with_mesh();
    let again = Scene::from_json(&shared).expect("it is valid");
    assert_eq!(again.closeness, session.scene().closeness);
    session.undo().expect("undo works");
    session.undo().expect("undo works");
    assert_eq!(session.scene(), first);
    // The file was ignored where nothing was kept near anything.
    session.edit(Edit::Preset { id: "fig-6".to_owned() }).expect("it is declared");
    assert_eq!(session.document().weights.close, 0.0);
    session.edit(fit.clone()).expect("it is a mesh");
    assert_eq!(session.document().weights.close, 1.0);
    session.undo().expect("undo works");
    session.undo().expect("undo works");
    // The rim was held on that of the original.
    session.edit(Edit::Preset { id: "fig-7".to_owned() }).expect("it is declared");
    let boundary = |session: &Session| session.document().closeness.boundary.require;
    assert_eq!(boundary(&session), BoundaryRequire::Exact);
    session.edit(fit).expect("it is a mesh");
    assert_eq!(boundary(&session), BoundaryRequire::Off);
    // What is held beside another surface is so by the user's choice, also with a newer file.
    let hold = r#"{ "set": { "id": "boundary", "value": "soft" } }"#;
    session.edit(Edit::from_json(hold).expect("it is an edit")).expect("it is declared");
    let raised: Vec<_> = wave().positions.iter().map(|[x, y, z]| [*x, *y, z + 1.0]).collect();
    let text = write_obj(&wave(), &raised);
    session.edit(Edit::FitTo { name: "newer.obj".to_owned(), text }).expect("it is a mesh");
    assert_eq!(boundary(&session), BoundaryRequire::Soft);
    session.undo().expect("undo works");
    session.undo().expect("undo works");
    session.undo().expect("undo works");
    session.undo().expect("undo works");
    let broken = Edit::FitTo { name: "wave.off".to_owned(), text: "OFF\n3".to_owned() };
    let refused = session.edit(broken).expect_err("it is no mesh").to_string();
    assert!(refused.contains("wave.off"), "{refused}");
    let points = Edit::FitTo { name: "points.obj".to_owned(), text: "v 0 0 0".to_owned() };
    let refused = session.edit(points).expect_err("it has no surface").to_string();
    assert!(refused.contains("neither faces nor curves"), "{refused}");
    assert_eq!(session.scene(), first);
}

#[test]
fn a_second_file_in_another_unit_or_with_another_axis_is_refused() {
    // A model in metres was pulled to a surface in millimetres, a thousand times too far.
    let scene = scene(r#""rest""#).expect("it is valid");
    let mut session = Session::open(scene, panels()).expect("it is regular");
    session.edit(Edit::SetUnits { units: "m".to_owned() }).expect("nothing is locked");
    for (stated, words) in [
        ("# units: mm\n", "a.obj states the unit mm, expected that of the model, m"),
        ("# up: y\n", "a.obj states the up axis y, expected that of the model, z"),
    ] {
        let mesh = panels();
        let text = stated.to_owned() + &write_obj(&mesh, &mesh.positions);
        let name = "a.obj".to_owned();
        for edit in
            [Edit::FitTo { name: name.clone(), text: text.clone() }, Edit::TakePose { name, text }]
        {
            let refused = session.edit(edit).expect_err("it does not fit").to_string();
            assert!(refused.starts_with(words), "{refused}");
        }
    }
    let text = "# units: m\n# up: z\n".to_owned() + &write_obj(&wave(), &wave().positions);
    session.edit(Edit::FitTo { name: "a.obj".to_owned(), text }).expect("it says the same");
}

#[test]
fn a_file_that_was_not_read_is_named_and_other_words_are_refused() {
    let named = scene(r#"{ "mesh": { "file": "wave.obj" } }"#).expect("it is valid");
    let refused = Session::open(named, panels()).err().expect("nobody has read it").to_string();
    assert!(refused.contains("closeness.to.mesh") && refused.contains("wave.obj"), "{refused}");
    let refused = scene(r#""target""#).expect_err("a target is a mesh");
    assert_eq!(refused.path, "closeness.to");
    let refused = scene(r#"{ "mesh": { "faces": [] } }"#).expect_err("it has no positions");
    assert!(refused.path.starts_with("closeness.to.mesh"), "{refused:?}");
}

#[test]
fn a_surface_that_nothing_stays_near_for_now_is_kept_in_the_file() {
    let target =
        r#"{ "mesh": { "positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "faces": [[0, 1, 2]] } }"#;
    for to in [ClosenessTo::Rest, ClosenessTo::Surface, ClosenessTo::Target] {
        let mut own = scene(target).expect("it is valid");
        own.closeness.to = to;
        let again = Scene::from_json(&own.to_json(&panels())).expect("it reads what it writes");
        assert_eq!(again.closeness, own.closeness);
    }

    // Until something is close to it, its file may be missing; and there is one surface.
    let closeness = |text: &str| {
        let text = format!(
            r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "panels.obj" }},
                "closeness": {text} }}"#
        );
        Scene::from_json(&text)
    };
    let unused = closeness(r#"{ "to": "rest", "target": { "mesh": "wave.obj" } }"#);
    let unused = unused.expect("it is valid");
    assert_eq!(unused.closeness.file_to_read(), None);
    unused.validate(&panels()).expect("nothing is close to it");
    let used = closeness(r#"{ "to": { "mesh": "wave.obj" } }"#).expect("it is valid");
    assert_eq!(used.closeness.file_to_read(), Some("wave.obj"));
    let both = closeness(r#"{ "to": { "mesh": "a.obj" }, "target": { "mesh": "b.obj" } }"#);
    assert!(both.expect_err("which one?").to_string().contains("expected one of them"));
}

#[test]
fn the_shapes_of_another_pose_are_taken_in_one_step_and_left_in_another() {
    // A sheet, and the same sheet rolled up: its first column stays.
    let flat = grid(6, 2, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let rolled = grid(6, 2, |i, j| {
        let turn = f64::from(i) / 24.0;
        let radius = 12.0 / std::f64::consts::PI;
        [radius * sine(turn), f64::from(j), radius * (1.0 - cosine(turn))]
    });
    let scene = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "flat.obj" },
        "constraints": [{ "kind": "rigid", "on": { "each": "ring", "radius": 1 } }],
        "handles": [{ "vertices": [0, 1, 7, 8, 14, 15], "fixed": true }],
        "weights": { "shape": 1 }, "solver": { "iterations": 3000, "tolerance": 1e-13 } }"#;
    let mut session = Session::open(Scene::from_json(scene).expect("it is valid"), flat.clone())
        .expect("it is regular");
    let first = session.scene();
    let take = |mesh: &Mesh| Edit::TakePose {
        name: "rolled.obj".to_owned(),
        text: write_obj(mesh, &mesh.positions),
    };
    session.edit(take(&rolled)).expect("it has the same faces");
    session.solve(false).expect("positions stay finite");
    // The distance between its ends is that of the rolled sheet; it is 6 for the flat one.
    let across = |positions: &[Point]| {
        let [a, b] = [positions[0], positions[6]];
        (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
    };
    let (found, wanted) = (across(&session.positions()), across(&rolled.positions));
    assert!((found - wanted).abs() < 0.2, "{found} {wanted}");
    // A shared scene contains the pose.
    let again = Scene::from_json(&session.scene_with_mesh()).expect("it is valid");
    assert_eq!(again.pose, session.scene().pose);
    session.edit(Edit::LeavePose).expect("there is one");
    session.solve(false).expect("positions stay finite");
    assert!((across(&session.positions()) - 6.0).abs() < 0.01, "it is flat again");
    for _ in 0..4 {
        session.undo().expect("undo works");
    }
    assert_eq!(session.scene(), first);
    let other = grid(4, 9, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let refused = session.edit(take(&other)).expect_err("it has other faces").to_string();
    assert!(refused.contains("rolled.obj is not a pose of the model"), "{refused}");
}
