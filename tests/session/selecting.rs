//! Selection by properties of the mesh: properties on random meshes, and expected results on a
//! torus, a box and a roof.

use crate::support::meshes::{grid, mixed, wavy};
use proptest::prelude::*;
use serde_json::{Map, Value, json};
use shape_up::constraint::Set;
use shape_up::mesh::{Group, GroupKeyword, Mesh};
use shape_up::scene::{MeshSource, Scene};
use shape_up::session::{Edit, Mode, OPERATIONS, SelectRequest, Selection, Session};

const MODES: [Mode; 3] = [Mode::Vertices, Mode::Edges, Mode::Faces];

fn session(mesh: Mesh) -> Session {
    let scene = Scene::new(MeshSource::Inline(Box::new(mesh.clone())));
    Session::open(scene, mesh).expect("the mesh can be opened")
}

fn of(mode: Mode, items: Vec<u32>) -> Selection {
    let mut selection = Selection::default();
    match mode {
        Mode::Vertices => selection.vertices = items,
        Mode::Edges => selection.edges = items,
        Mode::Faces => selection.faces = items,
    }
    selection
}

fn items(mode: Mode, selection: &Selection) -> Vec<u32> {
    match mode {
        Mode::Vertices => selection.vertices.clone(),
        Mode::Edges => selection.edges.clone(),
        Mode::Faces => selection.faces.clone(),
    }
}

fn ask(
    session: &mut Session,
    operation: &str,
    mode: Mode,
    from: &Selection,
    params: Value,
) -> Result<Selection, String> {
    let Value::Object(params) = params else { panic!("parameters are an object") };
    let (operation, from) = (operation.to_owned(), from.clone());
    session
        .select(&SelectRequest { operation, mode, from, params })
        .map_err(|error| error.to_string())
}

/// Items after an operation without parameters on `from`.
fn after(session: &mut Session, operation: &str, mode: Mode, from: &[u32]) -> Vec<u32> {
    let found = ask(session, operation, mode, &of(mode, from.to_vec()), json!({}));
    items(mode, &found.expect("the operation is known"))
}

fn within(inner: &[u32], outer: &[u32]) -> bool {
    inner.iter().all(|item| outer.contains(item))
}

/// A torus of `around` quads around the tube and `along` rows.
fn torus(around: u32, along: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let at = |i: u32, j: u32| (j % along) * around + i % around;
    for j in 0..along {
        for i in 0..around {
            let (u, v) = (f64::from(i), f64::from(j));
            mesh.positions.push([u, v, 0.1 * u * v]);
            mesh.faces.push(&[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    mesh
}

/// The six sides of a cube, of two by two quads each.
fn cube() -> Mesh {
    let mut mesh = Mesh::default();
    let vertex = |at: [f64; 3], mesh: &mut Mesh| {
        let known = mesh.positions.iter().position(|p| *p == at);
        known.unwrap_or_else(|| {
            mesh.positions.push(at);
            mesh.positions.len() - 1
        }) as u32
    };
    for axis in 0..3 {
        for side in [0.0, 2.0] {
            for j in 0..2_u32 {
                for i in 0..2_u32 {
                    let corner = |di: u32, dj: u32| {
                        let mut at = [side; 3];
                        at[(axis + 1) % 3] = f64::from(i + di);
                        at[(axis + 2) % 3] = f64::from(j + dj);
                        at
                    };
                    // Opposite sides have the same orientation: the surface is not consistently
                    // oriented.
                    let corners = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                    let face = corners.map(|at| vertex(at, &mut mesh));
                    mesh.faces.push(&face);
                }
            }
        }
    }
    mesh
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(48))]

    #[test]
    fn growing_and_shrinking_undo_each_other_where_they_can(
        mesh in mixed(),
        picks in prop::collection::vec(0.0..1.0, 1..9),
    ) {
        let mut session = session(mesh);
        for mode in MODES {
            let all = after(&mut session, "all", mode, &[]);
            if all.is_empty() {
                continue;
            }
            let mut some: Vec<u32> =
                picks.iter().map(|part| all[(part * all.len() as f64) as usize]).collect();
            some.sort_unstable();
            some.dedup();
            let mut step = |operation: &str, from: &[u32]| after(&mut session, operation, mode, from);
            let (grown, shrunk) = (step("grow", &some), step("shrink", &some));
            prop_assert!(within(&some, &grown) && within(&shrunk, &some));
            prop_assert!(within(&some, &step("shrink", &grown)));
            prop_assert!(within(&step("grow", &shrunk), &some));
            let others = step("invert", &some);
            prop_assert_eq!(others.len() + some.len(), all.len());
            prop_assert_eq!(&step("invert", &others), &some);
            // Repeated growing ends at the connected component.
            let connected = step("connected", &some);
            let mut reached = some;
            loop {
                let next = step("grow", &reached);
                if next == reached { break }
                reached = next;
            }
            prop_assert_eq!(reached, connected);
        }
    }

    #[test]
    fn strips_cover_the_quads_and_loops_the_edges(mesh in mixed()) {
        let quads: Vec<u32> = (0..).zip(mesh.faces.iter()).filter(|(_, f)| f.len() == 4)
            .map(|(f, _)| f).collect();
        let is_quad_dominant = 2 * quads.len() > mesh.faces.len();
        let mut session = session(mesh);
        for face in quads {
            let strip = after(&mut session, "strip", Mode::Faces, &[face]);
            prop_assert_eq!(strip.contains(&face), is_quad_dominant);
        }
        for edge in after(&mut session, "all", Mode::Edges, &[]) {
            let along = after(&mut session, "loop", Mode::Edges, &[edge]);
            prop_assert_eq!(along.contains(&edge), is_quad_dominant);
            // Any edge of a line selects the same line.
            for &other in along.iter().take(3) {
                prop_assert_eq!(&after(&mut session, "loop", Mode::Edges, &[other]), &along);
            }
        }
    }

    #[test]
    fn without_a_seed_the_boundary_is_every_edge_of_one_face(mesh in mixed()) {
        let mut session = session(mesh);
        let found = after(&mut session, "boundary", Mode::Edges, &[]);
        let topology = session.topology();
        let edges = 0..topology.edges().len() as u32;
        let boundary: Vec<u32> = edges.filter(|&e| topology.is_boundary_edge(e)).collect();
        prop_assert_eq!(found, boundary);
    }
}

#[test]
fn loops_rings_and_strips_close_on_a_torus() {
    let (around, along) = (7, 5);
    let mut session = session(torus(around, along));
    for edge in 0..session.topology().edges().len() as u32 {
        let [a, b] = session.topology().edges()[edge as usize];
        let goes_around = a / around == b / around;
        let (same, other) = if goes_around { (around, along) } else { (along, around) };
        assert_eq!(after(&mut session, "loop", Mode::Edges, &[edge]).len(), same as usize);
        assert_eq!(after(&mut session, "ring", Mode::Edges, &[edge]).len(), other as usize);
    }
    let both = after(&mut session, "strip", Mode::Faces, &[3]);
    assert_eq!(both.len(), (around + along - 1) as usize);
    // Two adjacent faces select the one strip through both.
    assert_eq!(after(&mut session, "strip", Mode::Faces, &[3, 4]).len(), around as usize);
    assert!(after(&mut session, "boundary", Mode::Edges, &[]).is_empty());
    // Two adjacent vertices select the line through them.
    let line = after(&mut session, "loop", Mode::Vertices, &[0, 1]);
    assert_eq!(line, (0..around).collect::<Vec<_>>());
}

#[test]
fn a_flat_patch_ends_at_the_edges_of_a_cube_however_its_faces_run() {
    let mut session = session(cube());
    for face in 0..24 {
        let side: Vec<u32> = (0..4).map(|k| face / 4 * 4 + k).collect();
        assert_eq!(after(&mut session, "flat", Mode::Faces, &[face]), side);
    }
    let from = of(Mode::Faces, vec![0]);
    let wide = ask(&mut session, "flat", Mode::Faces, &from, json!({ "angle": 91 }));
    assert_eq!(wide.expect("the angle is in range").faces.len(), 24);
    let refused = ask(&mut session, "flat", Mode::Faces, &from, json!({ "angle": 200 }));
    assert!(refused.expect_err("no surface bends by 200 degrees").starts_with("angle: "));
}

#[test]
fn a_boundary_loop_is_that_of_the_selection() {
    // A frame: a grid of five by five quads without its middle.
    let whole = wavy(5, 5);
    let mut mesh = Mesh { positions: whole.positions, ..Mesh::default() };
    whole.faces.iter().enumerate().filter(|(f, _)| *f != 12).for_each(|(_, f)| mesh.faces.push(f));
    let mut session = session(mesh);
    assert_eq!(after(&mut session, "boundary", Mode::Vertices, &[]).len(), 20 + 4);
    assert_eq!(after(&mut session, "boundary", Mode::Vertices, &[0]).len(), 20);
    assert_eq!(after(&mut session, "boundary", Mode::Edges, &[]).len(), 20 + 4);
    // Face 7 lies below the hole. A pick by face selects the edges of the loop: the faces along the
    // loop would add a second ring of vertices, which would be fixed too.
    let from = Selection { faces: vec![7], ..Selection::default() };
    let found = ask(&mut session, "boundary", Mode::Faces, &from, json!({}));
    let found = found.expect("it is no error");
    assert_eq!((found.edges.len(), found.faces.len()), (4, 0));
    // The faces along the boundary are a separate operation.
    assert_eq!(after(&mut session, "boundary-faces", Mode::Faces, &[7]).len(), 4);
}

#[test]
fn vertices_that_nothing_acts_on_are_found() {
    let mut session = session(wavy(5, 5));
    let plane = r#"{ "addConstraint": { "kind": "plane", "on": { "vertices": [0, 1, 6, 7] }, "weight": 1 } }"#;
    let plane = Edit::from_json(plane).expect("it is an edit");
    let find = |session: &mut Session| {
        let found = ask(session, "free", Mode::Faces, &Selection::default(), json!({}));
        found.expect("it takes no parameters").vertices.len()
    };
    assert_eq!(find(&mut session), 36);
    session.edit(plane).expect("it fits");
    assert_eq!(find(&mut session), 32);
    session.edit(Edit::AddHandles { vertices: vec![35], fixed: true }).expect("it is there");
    assert_eq!(find(&mut session), 31);
    // What is required is met without a weight too: its vertices were said to stand still.
    for (change, free) in [(r#""weight": 0"#, 35), (r#""require": "exact""#, 31)] {
        let edit = format!(r#"{{ "setConstraint": {{ "index": 0, {change} }} }}"#);
        session.edit(Edit::from_json(&edit).expect("it is an edit")).expect("it can be met");
        assert_eq!(find(&mut session), free, "{change}");
    }
    // An opened mesh has none.
    session.edit(Edit::Preset { id: "opened".to_owned() }).expect("it is declared");
    assert_eq!((find(&mut session), session.free().len()), (0, 0));
    // A soft boundary without weight takes its vertices from the surface, and keeps them nowhere; the
    // four corners stay. They were not counted.
    for edit in [
        r#"{ "setWeights": { "smooth": 0 } }"#,
        r#"{ "set": { "id": "boundary", "value": "soft" } }"#,
        r#"{ "set": { "id": "boundary-weight", "value": 0 } }"#,
        r#"{ "removeConstraint": { "index": 0 } }"#,
    ] {
        session.edit(Edit::from_json(edit).expect("it is an edit")).expect("it can be met");
    }
    assert_eq!(session.free().len(), 16);
}

#[test]
fn elements_are_found_by_their_numbers_and_their_errors() {
    let mut mesh =
        grid(4, 3, |i, j| [f64::from(i), f64::from(j), if i == 0 && j == 0 { 0.4 } else { 0.0 }]);
    mesh.faces.push(&[19, 18, 14]);
    let mut session = session(mesh);
    let mut find = |operation: &str, mode: Mode, params: Value| {
        let found = ask(&mut session, operation, mode, &Selection::default(), params);
        items(mode, &found.expect("the parameters are in range"))
    };
    assert_eq!(find("sides", Mode::Faces, json!({ "sides": 3 })), [12]);
    assert_eq!(find("sides", Mode::Faces, json!({})).len(), 12);
    assert_eq!(find("valence", Mode::Vertices, json!({ "edges": 2 })), [0, 4, 15, 19]);
    assert_eq!(find("error", Mode::Faces, json!({ "tolerance": 0.05 })), [0]);
    assert!(find("error", Mode::Faces, json!({ "tolerance": 1.0 })).is_empty());
    let circular = json!({ "measure": "circularity", "tolerance": 0.05 });
    assert_eq!(find("error", Mode::Faces, circular), [0]);
    let none = Selection::default();
    for (params, words) in [
        (json!({ "measure": "beauty" }), "beauty"),
        // It said "from 0 to inf".
        (json!({ "tolerance": -1 }), "expected a number from 0"),
    ] {
        let refused = ask(&mut session, "error", Mode::Faces, &none, params);
        let message = refused.expect_err("it does not fit");
        assert!(message.contains(words) && !message.contains("inf"), "{message}");
    }
    // A name has no default: asking for none panicked.
    let refused = ask(&mut session, "named", Mode::Faces, &none, json!({}));
    assert_eq!(refused, Err("name: expected a word".to_owned()));
}

#[test]
fn a_selection_goes_from_one_kind_of_element_to_another() {
    let mut session = session(wavy(3, 3));
    let faces = of(Mode::Faces, vec![0, 1]);
    let vertices =
        ask(&mut session, "to-vertices", Mode::Faces, &faces, json!({})).unwrap_or_default();
    assert_eq!(vertices, of(Mode::Vertices, vec![0, 1, 2, 4, 5, 6]));
    let back = ask(&mut session, "to-faces", Mode::Vertices, &vertices, json!({}));
    assert_eq!(back, Ok(faces.clone()));
    let edges = ask(&mut session, "to-edges", Mode::Faces, &faces, json!({})).unwrap_or_default();
    assert_eq!(edges.edges.len(), 7);
    // There may be an unselected face between two selected ones.
    let apart = of(Mode::Faces, vec![0, 2]);
    assert_eq!(
        items(
            Mode::Faces,
            &ask(&mut session, "invert", Mode::Faces, &apart, json!({})).unwrap_or_default()
        )
        .len(),
        7
    );
}

#[test]
fn sets_are_kept_in_the_scene_found_again_and_undone() {
    let mut mesh = wavy(3, 2);
    mesh.groups.push(Group {
        name: "panels".to_owned(),
        keyword: GroupKeyword::Group,
        faces: vec![1, 4],
        curves: vec![],
    });
    let mut session = session(mesh);
    session.edit(set_named("eaves", &[0, 3], &[])).expect("the vertices are there");
    assert!(session.scene().to_json(session.mesh()).contains("\"eaves\""));
    let mut named = |name: &str, mode: Mode| {
        ask(&mut session, "named", mode, &Selection::default(), json!({ "name": name }))
    };
    assert_eq!(named("eaves", Mode::Vertices), Ok(of(Mode::Vertices, vec![0, 3])));
    assert_eq!(named("panels", Mode::Faces), Ok(of(Mode::Faces, vec![1, 4])));
    assert_eq!(named("panels", Mode::Vertices).map(|found| found.vertices.len()), Ok(6));
    assert!(named("attic", Mode::Faces).expect_err("there is none").contains("attic"));
    assert_eq!(session.undo().expect("it can be undone").as_deref(), Some("Save set eaves"));
    assert!(session.document().sets.is_empty());
    let empty = set_named("nothing", &[], &[]);
    assert!(session.edit(empty).is_err());
}

fn set_named(name: &str, vertices: &[u32], faces: &[u32]) -> Edit {
    let (name, vertices, faces) = (name.to_owned(), vertices.to_vec(), faces.to_vec());
    Edit::NameSet { name, vertices, faces }
}

#[test]
fn a_set_that_a_constraint_uses_takes_the_constraint_with_it() {
    let mesh = wavy(3, 3);
    let set = |faces: &[u32]| Set { faces: faces.into(), ..Set::default() };
    let mut scene = Scene::new(MeshSource::Inline(Box::new(mesh.clone())));
    scene.sets.insert("some".to_owned(), set(&[0]));
    let spec = r#"{ "kind": "plane", "on": { "each": "face", "in": "some" } }"#;
    scene.constraints.push(
        serde_json::from_str::<shape_up::scene::ConstraintSpec>(spec)
            .expect("the constraint is valid"),
    );
    let mut session = Session::open(scene, mesh).expect("it fits");
    assert_eq!(session.rows()[0].constraints.members.len(), 1);
    session.edit(set_named("some", &[], &[0, 4, 8])).expect("the faces are there");
    assert_eq!(session.rows()[0].constraints.members.len(), 3);
    let still = session.edit(Edit::RemoveSet { name: "some".to_owned() });
    assert!(still.is_err(), "the constraint needs it");
    assert_eq!(session.rows()[0].constraints.members.len(), 3);
}

#[test]
fn what_is_not_there_is_refused_by_its_place() {
    let mut session = session(wavy(2, 2));
    let bad = of(Mode::Edges, vec![99]);
    let refused = ask(&mut session, "grow", Mode::Edges, &bad, json!({}));
    assert!(refused.expect_err("there are twelve").starts_with("from.edges: 99"));
    let request = SelectRequest {
        operation: "guess".to_owned(),
        mode: Mode::Faces,
        from: Selection::default(),
        params: Map::new(),
    };
    assert!(session.select(&request).expect_err("it is not declared").message.contains("guess"));
}

/// Every operation with its default parameters succeeds on meshes with nothing to find.
#[test]
fn every_declared_operation_can_be_asked_of_every_mesh() {
    let curve = Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 1.0, 0.0]],
        curves: [[0, 1, 2]].into_iter().collect(),
        ..Mesh::default()
    };
    for mesh in [curve, wavy(1, 1), torus(3, 3)] {
        let mut session = session(mesh);
        for operation in OPERATIONS.iter().filter(|operation| !operation.takes_name) {
            for &mode in operation.modes {
                let from = Selection { vertices: vec![0], ..Selection::default() };
                for from in [from, Selection::default()] {
                    let found = ask(&mut session, operation.id, mode, &from, json!({}));
                    assert!(found.is_ok(), "{} of {mode:?}: {found:?}", operation.id);
                }
            }
        }
    }
}
