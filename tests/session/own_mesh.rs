//! Effect of the first "make panels" on an opened mesh: the real quad meshes of `../shared/meshes`,
//! and the changes of the document.

use shape_up::math::Vec3;
use shape_up::mesh::{Mesh, Point, ProblemKind, Topology};
use shape_up::scene::{
    ClosenessTo, ConstraintSpec, MeshSuggestion, Scene, UnitsAndUp, Up, offers_new_panels,
    panel_offers, panel_suggestion, problem_suggestion,
};
use shape_up::session::{Edit, LayoutSettings, PanelStart, Remeshing, Session};
use shape_up::solve::Require;

/// Largest and mean displacement, in per cent of the diagonal of the bounding box, and worst panel
/// as a fraction of it, for circular and flat panels: the results of these settings when they were
/// chosen.
#[rustfmt::skip]
const WANTED: &[(&str, [f64; 3], [f64; 3])] = &[
    ("M2_eq_quad2.obj", [3.41, 0.76, 3e-4], [2.64, 0.58, 2.3e-4]),
    ("botanic-garden-bubble-0.obj", [3.63, 1.03, 2e-4], [0.26, 0.06, 7.2e-5]),
    ("chebyshev_sphere.obj", [4.73, 1.94, 7.5e-5], [2.49, 0.53, 1.3e-4]),
    ("cmc1.obj", [4.57, 2.11, 4e-4], [4.31, 2.17, 3.1e-4]),
    ("compas_faces_big.obj", [0.0, 0.0, 1e-9], [0.0, 0.0, 1e-9]),
    ("compas_hypar.obj", [15.68, 4.62, 9.5e-4], [15.04, 4.64, 1.3e-3]),
    ("compas_tubemesh.obj", [2.18, 0.80, 2e-4], [1.80, 0.51, 1.6e-4]),
    ("gc_dodecahedron_poly.obj", [0.0, 0.0, 1e-9], [0.0, 0.0, 1e-9]),
    ("halftunnel.off", [0.63, 0.08, 2.2e-4], [0.0, 0.0, 1e-8]),
    ("horse_quad.obj", [2.36, 0.57, 2.3e-4], [1.51, 0.31, 1.9e-4]),
    ("pillow_1.obj", [2.06, 0.80, 3.5e-4], [2.00, 0.62, 2.4e-4]),
    ("rhombitruncated_cubeoctahedron.off", [1.88, 0.21, 1.25e-4], [0.0, 0.0, 1e-9]),
    ("trimesh_quadknot.obj", [2.50, 0.78, 2.2e-4], [1.43, 0.54, 2e-4]),
];

/// A session after the request for panels of `kind`.
fn pressed(mesh: Mesh, kind: &str) -> Session {
    let mut session = Session::open(Scene::opened("own.obj"), mesh).unwrap();
    session
        .edit(Edit::MakePanels { kind: kind.to_owned(), within: None, from: PanelStart::Now })
        .unwrap();
    session
}

fn diagonal(points: &[Point]) -> f64 {
    let corner = |pick: fn(f64, f64) -> f64| {
        points.iter().copied().reduce(|a, b| [0, 1, 2].map(|i| pick(a[i], b[i]))).unwrap()
    };
    (Vec3::from(corner(f64::max)) - Vec3::from(corner(f64::min))).length()
}

#[test]
fn real_meshes_stay_whole_while_their_panels_become_circular_or_flat() {
    // With the defaults of a scene file, 20 of 28 such meshes moved by 20 to 60 per cent.
    for (file, circular, flat) in WANTED {
        let Some(mesh) = crate::support::shared::mesh(file) else { return };
        let size = diagonal(&mesh.positions);
        for (kind, [max, mean, worst]) in [("circle", circular), ("plane", flat)] {
            let mut session = pressed(mesh.clone(), kind);
            session.solve(false).unwrap();
            let verdict = session.verdict(1e-3 * size).unwrap();
            assert_eq!((verdict.kind, verdict.of), (kind, mesh.faces.len()), "{file}");
            let found = [100.0 * verdict.moved.max, 100.0 * verdict.moved.mean, verdict.worst]
                .map(|length| length / size);
            let limits = [1.05 * max + 0.02, 1.05 * mean + 0.02, 1.05 * worst];
            for (found, limit) in found.iter().zip(limits) {
                assert!(*found <= limit, "{file} {kind}: {found:?}, at most {limits:?}");
            }
            assert_eq!(session.report().stopped_by, "tolerance", "{file} {kind}");
        }
    }
}

#[test]
fn the_press_is_one_step_and_a_choice_between_shapes() {
    let mut session = pressed(crate::support::grid::bumpy(4), "plane");
    let rows = |session: &Session| -> Vec<(&str, bool)> {
        let rows = session.document().constraints.iter();
        rows.map(|row| (row.kind.info().id, row.enabled)).collect::<Vec<_>>()
    };
    assert_eq!(rows(&session), [("plane", true)]);
    session
        .edit(Edit::MakePanels { kind: "circle".to_owned(), within: None, from: PanelStart::Now })
        .unwrap();
    assert_eq!(rows(&session), [("plane", false), ("circle", true)]);
    assert_eq!(session.verdict(1.0).unwrap().adjective, "circular");
    session
        .edit(Edit::MakePanels { kind: "plane".to_owned(), within: None, from: PanelStart::Now })
        .unwrap();
    assert_eq!(rows(&session), [("plane", true), ("circle", false)]);
    // Rows of kinds other than circular and flat stay.
    session
        .edit(Edit::MakePanels {
            kind: "rectangle".to_owned(),
            within: None,
            from: PanelStart::Now,
        })
        .unwrap();
    assert_eq!(rows(&session), [("plane", true), ("circle", false), ("rectangle", true)]);
    assert_eq!(session.undo().unwrap().as_deref(), Some("Make panels rectangle"));
    assert_eq!(session.undo().unwrap().as_deref(), Some("Make panels flat"));
    assert_eq!(rows(&session), [("plane", false), ("circle", true)]);
}

#[test]
fn a_scene_that_would_not_keep_its_mesh_whole_gets_the_weights_that_do() {
    let opened = Scene::opened("own.obj");
    let mut scene = Scene { weights: Default::default(), ..opened.clone() };
    scene.closeness = Default::default();
    scene.smoothness = Default::default();
    let mesh = crate::support::grid::bumpy(4);
    scene.request_panels("circle", Require::Soft, &mesh).unwrap();
    assert_eq!(scene.weights, opened.weights);
    assert_eq!((&scene.closeness, scene.smoothness), (&opened.closeness, opened.smoothness));
    // Weights that the user chose stay.
    let mut own = Scene::opened("own.obj");
    own.weights.close = 10.0;
    own.request_panels("circle", Require::Soft, &mesh).unwrap();
    assert_eq!(own.weights.close, 10.0);
    // A weight of closeness to nothing holds nothing.
    own.closeness.to = ClosenessTo::None;
    own.weights.smooth = 0.0;
    own.request_panels("circle", Require::Soft, &mesh).unwrap();
    assert_eq!((own.weights, own.closeness), (opened.weights, opened.closeness));
}

#[test]
fn only_a_row_that_asks_for_nothing_else_is_switched_on() {
    let level = r#"{ "kind": "plane", "on": "faces", "normal": [0, 0, 1], "enabled": false }"#;
    let flat = r#"{ "kind": "plane", "on": "faces" }"#;
    let off = r#"{ "kind": "plane", "on": "faces", "enabled": false }"#;
    for (rows, then) in [
        (vec![level], vec![false, true]),
        (vec![level, flat], vec![false, true]),
        (vec![off, flat], vec![false, true]),
    ] {
        let row = |row: &&str| serde_json::from_str::<ConstraintSpec>(row).expect("a constraint");
        let mut scene = Scene::opened("own.obj");
        scene.constraints = rows.iter().map(row).collect();
        let mesh = crate::support::grid::bumpy(4);
        scene.request_panels("plane", Require::Exact, &mesh).unwrap();
        let are_on: Vec<bool> = scene.constraints.iter().map(|row| row.enabled).collect();
        assert_eq!(are_on, then, "{rows:?}");
        assert_eq!(scene.constraints[1].require, Require::Exact, "{rows:?}");
    }
}

#[test]
fn where_it_means_nothing_the_press_is_refused_in_words() {
    let triangles = Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        faces: [[0, 1, 2]].into_iter().collect(),
        ..Mesh::default()
    };
    let offers = panel_offers(&triangles);
    assert_eq!(offers.len(), 2);
    for (offer, words) in offers.iter().zip(["always flat", "always circular"]) {
        assert!(offer.reason.as_ref().unwrap().contains(words), "{offer:?}");
    }
    // Nothing can be joined to a single triangle.
    assert_eq!(suggestion_of(&triangles), None);
    let mut scene = Scene::opened("own.obj");
    for (kind, mesh, words) in [
        ("circle", &triangles, "All panels are triangles, which are always circular."),
        ("square", &triangles, "exactly 4 vertices"),
        ("plane", &Mesh::default(), "There are no panels."),
        ("beauty", &triangles, "found `beauty`, expected "),
    ] {
        let refused = scene.request_panels(kind, Require::Soft, mesh).unwrap_err();
        assert!(refused.message.contains(words), "{refused}");
        assert_eq!(scene, Scene::opened("own.obj"));
    }
    assert!(
        panel_offers(&crate::support::grid::bumpy(4)).iter().all(|offer| offer.reason.is_none())
    );
}

fn suggestion_of(mesh: &Mesh) -> Option<MeshSuggestion> {
    panel_suggestion(mesh, &Topology::new(mesh))
}

/// On a surface with one side, the button ended in a refusal.
#[test]
fn turning_faces_is_offered_where_it_can_succeed() {
    let offered = |last: &[u32]| {
        let faces = [&[0, 1, 3, 2][..], &[2, 3, 5, 4], last].into_iter().collect();
        let positions = (0..6).map(|v| [f64::from(v % 2), f64::from(v / 2), f64::from(v)]);
        let mesh = Mesh { positions: positions.collect(), faces, ..Mesh::default() };
        let kind = ProblemKind::FlippedNeighbour;
        problem_suggestion(kind, &mesh, &Topology::new(&mesh)).is_some()
    };
    assert!(offered(&[0, 1, 5, 4]), "a ring with one face turned");
    assert!(!offered(&[4, 5, 0, 1]), "a Moebius strip");
}

#[test]
fn new_panels_are_offered_for_curved_surfaces_of_triangles() {
    let of = |height: f64, columns: u32| {
        let mut mesh = Mesh::default();
        for i in 0..=columns {
            let x = f64::from(i);
            mesh.positions.extend([[x, 0.0, height * x * x], [x, 1.0, height * x * x]]);
        }
        for i in 0..columns {
            let a = 2 * i;
            mesh.faces.push(&[a, a + 2, a + 1]);
            mesh.faces.push(&[a + 1, a + 2, a + 3]);
        }
        let offered = offers_new_panels(&mesh, &Topology::new(&mesh));
        let words = suggestion_of(&mesh).unwrap().words;
        assert_eq!(offered, words.contains("New panels"), "{words}");
        offered
    };
    assert!(of(0.01, 12));
    assert!(!of(0.0, 12), "a flat plate");
    assert!(!of(0.3, 1), "two triangles");
    let quads = crate::support::grid::bumpy(8);
    assert!(!offers_new_panels(&quads, &Topology::new(&quads)), "these are panels");
    // Faces of a surface that a program has joined in part: one quad took the offer away, and made as many
    // panels as there are faces the suitable number.
    let mut mesh = crate::quads::parametric([30, 30], [false, false], |u, v| [u, v, u * u]);
    let joined = [0, 1, 32, 31];
    let faces = mesh.faces.iter().filter(|face| !face.iter().all(|v| joined.contains(v)));
    mesh.faces = faces.chain([&joined[..]]).collect();
    assert_eq!(mesh.faces.len(), 1799);
    assert!(offers_new_panels(&mesh, &Topology::new(&mesh)));
    let session = Session::open(Scene::opened("own.obj"), mesh).unwrap();
    let usual = LayoutSettings { count: None, size: None, follow: 0.5, even: 0.5, boundary: None };
    let layout = session.panel_layouts(&[]).unwrap().lay_out(&usual, &mut |_| ()).unwrap();
    assert!((450..550).contains(&layout.count), "{}", layout.count);
}

#[test]
fn triangles_can_be_joined_to_quads_for_which_panels_are_offered() {
    let quads = crate::support::grid::bumpy(4);
    assert_eq!(suggestion_of(&quads), None);
    let remesh = |operation: &str, sizes: &[f64]| {
        let (operation, sizes) = (operation.to_owned(), sizes.to_vec());
        Edit::Remesh(Remeshing { operation, sizes, ..Remeshing::default() })
    };
    let mut session = Session::open(Scene::opened("own.obj"), quads).unwrap();
    session.edit(remesh("triangles", &[])).unwrap();
    let suggestion = suggestion_of(session.mesh()).unwrap();
    assert!(
        suggestion.words.contains("triangles, which are always flat and circular"),
        "{suggestion:?}"
    );
    session.edit(remesh(suggestion.operation, &[160.0])).unwrap();
    assert!(panel_offers(session.mesh()).iter().all(|offer| offer.reason.is_none()));
}

#[test]
fn a_verdict_counts_panels_within_the_tolerance() {
    let mut session = pressed(crate::support::grid::bumpy(4), "plane");
    session.solve(false).unwrap();
    let all = session.verdict(f64::INFINITY).unwrap();
    assert_eq!((all.of, all.within), (16, 16));
    let none = session.verdict(0.5 * all.worst).unwrap();
    assert!(none.within < all.of && none.within > 0, "{none:?}");
    let worst = session.worst_faces("planarity", 1, None).unwrap();
    assert_eq!((worst[0].value, &*worst[0].faces), (all.worst, &[all.worst_face][..]));
    assert_eq!(session.report().moved, all.moved);
    session.edit(Edit::RemoveConstraint { index: 0 }).unwrap();
    assert_eq!(session.verdict(1.0), None);
}

#[test]
fn real_meshes_are_opened_the_right_way_up() {
    // The visual up direction: roofs and shells lie on their openings, animals stand on their feet.
    const Z: &[&str] = &[
        "M2_eq_quad2.obj",
        "botanic-garden-bubble-0.obj",
        "chebyshev_sphere.obj",
        "compas_faces_big.obj",
        "compas_hypar.obj",
        "compas_tubemesh.obj",
        "inspired_mesh.obj",
        "pillow_1.obj",
        "awkward/compas_boxes.obj",
        "awkward/assimp_box_without_lineending.obj",
    ];
    const Y: &[&str] =
        &["bunny_poly.obj", "camelhead.off", "decimated-knight.off", "horse_quad.obj", "igloo.obj"];
    // The others have no clear direction: a knot, a dodecahedron, a tilted half sphere.
    for (files, up) in [(Z, Up::Z), (Y, Up::Y)] {
        for file in files {
            let Some(mesh) = crate::support::shared::mesh(file) else { return };
            assert_eq!(UnitsAndUp::guess_up(&mesh), up, "{file}");
        }
    }
}

#[test]
fn real_meshes_are_not_welded_but_what_is_in_pieces_is() {
    let Some(folder) = crate::support::shared::path("meshes") else { return };
    for folder in [folder.clone(), folder.join("awkward")] {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let Ok(bytes) = std::fs::read(&path) else { continue };
            let Ok(mut read) = shape_up::mesh::read(&name, &bytes) else { continue };
            // A room of eighteen walls with separate corners, and eight boxes that touch.
            let left = read.weld().map(|_| read.mesh.positions.len());
            let expected = match &*name {
                "tinyobj_no_material.obj" => Some(29),
                "compas_boxes.obj" => Some(8 * 8),
                // All but its vertices without a place.
                "tinyobj_test-nan.obj" => Some(33),
                _ => None,
            };
            assert_eq!(left, expected, "{name}");
        }
    }
    // The same faces with separate vertices each.
    for file in ["pillow_1.obj", "horse_quad.obj", "compas_tubemesh.obj"] {
        let Some(mesh) = crate::support::shared::mesh(file) else { return };
        let mut text = String::new();
        for [x, y, z] in mesh.faces.indices().iter().map(|&v| mesh.positions[v as usize]) {
            text += &format!("v {x:.6} {y:.6} {z:.6}\n");
        }
        let mut next = 1;
        for face in mesh.faces.iter() {
            let corners: Vec<_> = (next..next + face.len()).map(|c| c.to_string()).collect();
            text += &format!("f {}\n", corners.join(" "));
            next += face.len();
        }
        let mut read = shape_up::mesh::read("pieces.obj", text.as_bytes()).unwrap();
        let weld = read.weld().unwrap();
        assert_eq!(weld.to.len(), mesh.faces.indices().len());
        assert_eq!(read.mesh.positions.len(), mesh.positions.len(), "{file}");
        let edges = |mesh: &Mesh| Topology::new(mesh).edges().len();
        assert_eq!(edges(&read.mesh), edges(&mesh), "{file}");
        // Circular panels have the same effect as on the original mesh.
        let mut session = pressed(read.mesh, "circle");
        session.solve(false).unwrap();
        assert!(session.verdict(1.0).unwrap().moved.max < 0.06 * diagonal(&mesh.positions));
    }
}
