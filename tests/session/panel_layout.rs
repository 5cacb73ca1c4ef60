//! New panels along the lines of curvature in place of the mesh: what is said, what is carried over,
//! undo, and refusals.

use crate::session::refine::{everything, open};
use serde_json::json;
use shape_up::math::{Vec3, cosine, sine, twice_vector_area};
use shape_up::mesh::{Mesh, Point, Surface, Topology, write_obj};
use shape_up::quads::{Boundary, RemeshStage};
use shape_up::scene::{
    BoundaryCloseness, BoundaryRequire, Forecast, MeshSource, Scene, SceneError, Target,
};
use shape_up::session::{
    Edit, Flaw, LayoutNote, LayoutSettings, Level, PanelLayout, PanelStart, Session,
};

pub(super) const USUAL: LayoutSettings =
    LayoutSettings { count: None, size: None, follow: 2.0 / 3.0, even: 0.25, boundary: None };

/// A vault over a square of side 12, of `n` by `n` pairs of triangles; turned by `turn` against its
/// lines of curvature.
pub(super) fn vault(n: u32, turned: bool) -> Mesh {
    let side = f64::from(n);
    let mut mesh = Mesh::default();
    for j in 0..=n {
        for i in 0..=n {
            let [x, y] = [i, j].map(|k| 12.0 * f64::from(k) / side - 6.0);
            let z = if turned { 0.05 * x * y } else { -0.08 * x * x - 0.02 * y * y };
            mesh.positions.push([x, y, z]);
        }
    }
    for j in 0..n {
        for i in 0..n {
            let a = j * (n + 1) + i;
            mesh.faces.push(&[a, a + 1, a + n + 2]);
            mesh.faces.push(&[a, a + n + 2, a + n + 1]);
        }
    }
    mesh
}

pub(super) fn opened(mesh: Mesh) -> Session {
    Session::open(Scene::opened("own.obj"), mesh).expect("the scene is valid")
}

pub(super) fn laid_out(session: &Session, settings: &LayoutSettings) -> PanelLayout {
    lay_out(session, settings).expect("the surface can be covered")
}

fn lay_out(session: &Session, settings: &LayoutSettings) -> Result<PanelLayout, SceneError> {
    let mut layouts = session.panel_layouts(&[]).expect("no face is kept");
    layouts.lay_out(settings, &mut |_| ())
}

/// Sets, constraints, and handles at a corner and inside.
const SCENE: &str = r#"
    "sets": { "left": { "faces": [0, 1, 20, 21, 40, 41, 60, 61] }, "none": { "vertices": [12, 13] } },
    "constraints": [ { "kind": "circle", "on": "faces" }, { "kind": "plane", "on": { "each": "face", "in": "left" } } ],
    "handles": [ { "vertices": [0, 60], "fixed": true } ]"#;

#[test]
fn panels_take_the_place_of_triangles_in_one_step_of_undo() {
    let mut session = open(SCENE, vault(10, false));
    let before = everything(&session);
    let layout = laid_out(&session, &LayoutSettings { count: Some(64), ..USUAL });
    assert_eq!(everything(&session), before, "laying out changes nothing");
    let said = &layout.words;
    assert!(said.contains(" panels, ") && said.contains("The mesh will then "), "{said}");

    let generation = session.generation();
    assert!(session.take_panels(generation, &layout.mesh).expect("it can be solved"));
    assert_eq!(session.mesh().faces.len(), layout.mesh.faces.len());
    // The faces over those of the set; the corner handle; what is gone is said.
    let left = &session.document().sets["left"].faces;
    assert!(!left.is_empty() && left.len() < layout.mesh.faces.len() / 4, "{left:?}");
    let handles = session.solver().handles();
    assert_eq!(handles.len(), 1);
    let corner = vault(10, false).positions[0];
    assert_eq!(session.positions()[handles[0].vertex as usize], corner);
    let lost = session.lost();
    assert!(lost.iter().any(|words| words.contains("1 handle")), "{lost:?}");
    assert!(lost.iter().any(|words| words.contains("none")), "{lost:?}");
    assert!(session.undo().expect("it was solvable").expect("a step").starts_with("Lay out "));
    assert_eq!(everything(&session), before);
}

/// Panels on the few faces that are the other way were said to be turned over.
#[test]
fn panels_on_faces_of_both_orientations_are_not_said_to_be_turned_over() {
    let mut mesh = vault(10, false);
    let turned = |(k, face): (usize, &[u32])| match k % 5 {
        0 => [face[0], face[2], face[1]],
        _ => [face[0], face[1], face[2]],
    };
    mesh.faces = mesh.faces.iter().enumerate().map(turned).collect();
    let mut session = opened(mesh);
    let layout = laid_out(&session, &USUAL);
    assert!(session.take_panels(session.generation(), &layout.mesh).expect("it can be solved"));
    assert_eq!(session.lost(), [""; 0]);
    // The first face is one of the few.
    let up = |face: &[u32]| {
        let corners = face.iter().map(|&v| Vec3::from(session.mesh().positions[v as usize]));
        twice_vector_area(corners).z
    };
    assert!(session.mesh().faces.iter().all(|face| up(face) > 0.0));
}

#[test]
fn panels_for_another_shape_are_refused() {
    let mut session = opened(vault(8, false));
    let layout = laid_out(&session, &USUAL);
    let generation = session.generation();
    let text =
        r#"{ "addConstraint": { "kind": "plane", "on": "faces", "weight": 1, "params": {} } }"#;
    session.edit(Edit::from_json(text).expect("an edit")).expect("it can be solved");
    assert!(!session.take_panels(generation, &layout.mesh).expect("it is refused quietly"));
    assert_eq!(session.mesh().faces.len(), 128);
}

#[test]
fn circular_panels_after_them_stay_near_the_surface_before_them() {
    let mut session = opened(vault(12, false));
    let before = session.mesh().clone();
    let layout = laid_out(&session, &LayoutSettings { count: Some(100), ..USUAL });
    let generation = session.generation();
    assert!(session.take_panels(generation, &layout.mesh).expect("it can be solved"));
    let target = session.document().closeness.target_mesh().expect("closeness to that surface");
    assert_eq!((&target.positions, &target.faces), (&before.positions, &before.faces));
    session.make_panels("circle", 1e-3, PanelStart::Now).expect("quads");
    session.solve(false).expect("it can be solved");
    let verdict = session.verdict(1e-3).expect("panels");
    assert_eq!((verdict.within, verdict.folded), (verdict.of, 0));
    assert!(verdict.moved.mean < 0.1 * layout.size, "{verdict:?}");
    // It used to be the distance from the panels as they were laid out.
    let mut hint = Surface::NO_HINT;
    let surface = Surface::new(&before.positions, &before);
    let far = |point: &Point| {
        (Vec3::from(surface.closest(*point, &mut hint)) - Vec3::from(*point)).length()
    };
    let farthest = session.positions().iter().map(far).fold(0.0, f64::max);
    assert!(farthest > 0.0 && verdict.surface.max >= farthest, "{farthest} {verdict:?}");
    // Against another original it is measured anew, though nothing moves.
    let there = session.face_values("surface").expect("it is a measure");
    session
        .edit(Edit::Set { id: "closeness".to_owned(), value: json!("rest") })
        .expect("a setting");
    assert!(!session.verdict(1e-3).expect("panels").is_on_other);
    assert_ne!(session.face_values("surface").expect("it is a measure"), there);
    session.undo().expect("it can be solved");
    assert!(session.verdict(1e-3).expect("panels").is_on_other);
    assert_eq!(session.face_values("surface").expect("it is a measure"), there);
    assert!(verdict.surface.max < 0.1 * layout.size, "{verdict:?}");
    let words = session.verdict_words(&verdict).full();
    assert!(words.contains("of the surface that they were laid out on"), "{words}");

    // A scene that is saved and opened again has it too.
    let scene = Scene::from_json(&session.scene_with_mesh()).expect("a scene");
    let MeshSource::Inline(mesh) = scene.mesh.clone() else { panic!("the mesh is in the scene") };
    let mut again = Session::open(scene, *mesh).expect("the scene is valid");
    let same = again.verdict(1e-3).expect("panels");
    assert_eq!((same.surface, same.is_on_other, same.within), (verdict.surface, true, same.of));
    assert_eq!((verdict.level, &verdict.flaws[..]), (Level::Good, &[][..]));

    // Circular panels an edge away from the surface are circular, but not the roof that was asked for.
    let mut scene = Scene::from_json(&session.scene_with_mesh()).expect("a scene");
    // Its corners would be held at the original.
    scene.closeness.boundary = BoundaryCloseness::default();
    let pose = scene.current.as_mut().expect("it is solved");
    pose.iter_mut().for_each(|point| point[2] += layout.size);
    let MeshSource::Inline(mesh) = scene.mesh.clone() else { panic!("the mesh is in the scene") };
    let mut away = Session::open(scene, *mesh).expect("the scene is valid");
    let verdict = away.verdict(1.001e-3).expect("panels");
    assert_eq!((verdict.within, verdict.level), (verdict.of, Level::Fair));
    assert!(verdict.flaws.contains(&Flaw::Away), "{verdict:?}");
    let words = away.verdict_words(&verdict).full();
    assert!(words.contains("of the surface that they were laid out on"), "{words}");
}

/// Circular panels of a roof moved .45 m where .13 m was said: mostly along the surface.
#[test]
fn the_forecast_is_how_far_panels_leave_the_surface() {
    let mut meshes = vec![vault(12, false), vault(12, true)];
    for name in ["M2_eq_quad2.obj", "botanic-garden-bubble-0.obj"] {
        meshes.extend(crate::support::shared::mesh(name));
    }
    for mesh in meshes {
        let mut session = opened(mesh);
        let layout = laid_out(&session, &LayoutSettings { count: Some(300), ..USUAL });
        let words = &layout.words;
        assert!(words.ends_with(", besides gliding along the surface."), "{words}");
        let topology = Topology::new(&layout.mesh);
        let forecast = Forecast::of(&layout.mesh, &topology).expect("panels of four corners");
        let circle = forecast.kinds.iter().find(|one| one.kind == "circle").expect("it is offered");
        let edge = topology.mean_edge(&layout.mesh.positions);
        session.take_panels(session.generation(), &layout.mesh).expect("it can be solved");
        session.make_panels("circle", 1e-3 * edge, PanelStart::Now).expect("quads");
        session.solve(false).expect("it can be solved");
        let verdict = session.verdict(1e-3 * edge).expect("panels");
        // Less than a twentieth of an edge is said to be a little, whatever it is.
        let ratio = circle.least_move * edge / verdict.surface.rms;
        let is_little = circle.least_move < 0.05 && verdict.surface.rms < 0.05 * edge;
        assert!(is_little || (0.4..2.5).contains(&ratio), "{ratio} {words} {verdict:?}");
    }
}

#[test]
fn a_mesh_that_is_not_on_the_target_of_its_closeness_is_judged_by_itself() {
    let mut session = opened(vault(12, false));
    let layout = laid_out(&session, &LayoutSettings { count: Some(100), ..USUAL });
    let generation = session.generation();
    assert!(session.take_panels(generation, &layout.mesh).expect("it can be solved"));
    let mut scene = session.scene();
    let mut other = vault(12, false);
    other.positions.iter_mut().for_each(|point| point[2] += 1.0);
    scene.closeness.target = Some(Target::Mesh(other.into()));
    let mut moved = Session::open(scene, session.mesh().clone()).expect("the scene is valid");
    moved.make_panels("circle", 1e-3, PanelStart::Now).expect("quads");
    let verdict = moved.verdict(1e-3).expect("panels");
    assert_eq!((verdict.is_on_other, verdict.surface.max), (false, 0.0));
}

#[test]
fn what_a_changed_wish_leaves_as_it_was_is_not_computed_again() {
    // Both choices at the boundary are laid out: one used to replace the other.
    let session = opened(vault(10, true));
    let mut layouts = session.panel_layouts(&[]).expect("a surface");
    let mut stages_of = |settings: &LayoutSettings| {
        let mut stages: Vec<RemeshStage> = Vec::new();
        let layout = layouts.lay_out(settings, &mut |stage| stages.push(stage));
        let fresh = laid_out(&session, settings);
        let layout = layout.expect("the surface can be covered");
        assert_eq!((layout.mesh, layout.boundary), (fresh.mesh, fresh.boundary));
        stages
    };
    let first = LayoutSettings { count: Some(80), ..USUAL };
    assert!(stages_of(&first).contains(&RemeshStage::Field));
    let even = stages_of(&LayoutSettings { even: 0.75, ..first });
    assert!(even.contains(&RemeshStage::Map) && !even.contains(&RemeshStage::Field), "{even:?}");
    assert_eq!(stages_of(&LayoutSettings { even: 0.75, ..first }), [], "the same again");
    let cut = Some(Boundary::Cut);
    assert_eq!(stages_of(&LayoutSettings { even: 0.75, boundary: cut, ..first }), []);
    let other = stages_of(&LayoutSettings { count: Some(60), ..first });
    assert!(other.contains(&RemeshStage::Field));
}

/// They were counted and not marked.
#[test]
fn irregular_points_on_the_boundary_are_marked_too() {
    // A rhombus with a corner of 20 degrees, which one panel fills.
    let [c, s] = [cosine(20.0 / 360.0), sine(20.0 / 360.0)];
    let mesh = crate::quads::parametric([16, 16], [false, false], |u, v| {
        let [x, y] = [10.0 * (u + c * v), 10.0 * s * v];
        [x, y, 0.02 * x * x]
    });
    let session = opened(mesh);
    let settings = LayoutSettings { count: Some(80), boundary: Some(Boundary::Followed), ..USUAL };
    let layout = laid_out(&session, &settings);
    assert!(layout.words.contains("irregular point"), "{}", layout.words);
    let is_corner = |point: &Point| Vec3::from(*point).length() < 1e-9;
    let marked = &layout.lines[..layout.marked_lines];
    assert!(marked.iter().any(|line| line.iter().any(is_corner)), "{}", layout.words);
}

#[test]
fn places_that_are_named_are_marked_and_framed() {
    // A lid beside the vault.
    let mut mesh = vault(12, false);
    let first = mesh.positions.len() as u32;
    mesh.positions.extend([[20.0, 0.0, 0.0], [21.0, 0.0, 0.0], [20.0, 1.0, 0.0]]);
    mesh.faces.push(&[first, first + 1, first + 2]);
    let session = opened(mesh);
    let layout = laid_out(&session, &LayoutSettings { count: Some(100), ..USUAL });
    let [note] = &layout.notes[..] else { panic!("{:?}", layout.notes) };
    assert_eq!(note.words, "1 small part stays as it is.");
    assert_eq!(note.places, [[first, first + 1, first + 2]]);
    assert!(layout.marked_lines >= 1 && layout.lines[0].iter().all(|point| point[0] > 10.0));
    assert_eq!(layout.count + 1, layout.mesh.faces.len());

    let mut layouts = session.panel_layouts(&[]).expect("a surface");
    let large = LayoutSettings { size: Some(100.0), ..USUAL };
    layouts.lay_out(&large, &mut |_| ()).expect_err("too large");
    let place = layouts.refused_at().expect("at the boundary");
    assert!(!place.around.is_empty() && place.ring.iter().all(|point| point[0] < 10.0));
    layouts.lay_out(&USUAL, &mut |_| ()).expect("it is possible");
    assert_eq!(layouts.refused_at(), None);
}

/// The panels were pulled to the walls of the spike, and their lines and the place were on these.
#[test]
fn faces_that_are_left_out_are_no_part_of_the_surface() {
    let mut mesh = vault(12, false);
    let (vertex, depth) = (6 * 13 + 6, 40.0);
    let faces = mesh.faces.len();
    mesh.positions[vertex as usize][2] -= depth;
    mesh.unplaced = vec![vertex];
    let spike: Vec<u32> =
        (0..faces as u32).filter(|&face| mesh.faces.row(face as usize).contains(&vertex)).collect();
    let mut session = opened(mesh);
    let is_high = |points: &[Point]| points.iter().all(|point| point[2] > -depth / 8.0);
    let layout = laid_out(&session, &LayoutSettings { size: Some(2.5), ..USUAL });
    let left_out = |note: &&LayoutNote| note.words.starts_with("6 faces are left out, ");
    let note = layout.notes.iter().find(left_out).expect("it is said");
    assert!(!note.places[0].is_empty() && !note.places[0].contains(&vertex), "{note:?}");
    assert!(layout.lines.iter().all(|line| is_high(line)));
    assert!(session.take_panels(session.generation(), &layout.mesh).expect("it can be solved"));
    let target = session.document().closeness.target_mesh().expect("closeness to that surface");
    assert_eq!(target.faces.len(), faces - spike.len());
    session.undo().expect("it can be solved");

    // Asked to stay, they do, and are a part of it.
    let mut layouts = session.panel_layouts(&spike).expect("a surface");
    let layout = layouts.lay_out(&USUAL, &mut |_| ()).expect("the others are covered");
    assert!(session.take_panels(session.generation(), &layout.mesh).expect("it can be solved"));
    let target = session.document().closeness.target_mesh().expect("closeness to that surface");
    assert_eq!(target.faces.len(), faces);
}

#[test]
fn selected_faces_stay_as_they_are() {
    let mut session = opened(vault(10, false));
    let kept: Vec<u32> = (0..20).collect();
    let mut layouts = session.panel_layouts(&kept).expect("a surface");
    let settings = LayoutSettings { count: Some(80), ..USUAL };
    let layout = layouts.lay_out(&settings, &mut |_| ()).expect("the others are covered");
    let note = layout.notes.last().expect("it is said");
    assert!(note.words.starts_with("20 selected faces stay, "), "{note:?}");
    let before: Vec<Vec<Point>> = corners(session.mesh()).drain(..20).collect();
    let generation = session.generation();
    assert!(session.take_panels(generation, &layout.mesh).expect("it can be solved"));
    let after = corners(session.mesh());
    assert!(before.iter().all(|face| after.contains(face)));
    // The step has the number of the dialogue.
    let name = format!("Lay out {} panels", layout.count);
    assert_eq!(session.undo_and_redo()[0], Some(&*name));
    assert!(session.panel_layouts(&[1000]).is_err());
}

/// The copy that the staying face keeps lost them.
#[test]
fn where_faces_that_stay_meet_the_boundary_both_vertices_keep_handle_and_set() {
    let scene = r#"
        "sets": { "eave": { "vertices": [0, 11, 22] } },
        "handles": [ { "vertices": [11], "fixed": true } ]"#;
    let mut session = open(scene, vault(10, false));
    let at = session.positions()[11];
    let kept: Vec<u32> = (0..20).collect();
    let mut layouts = session.panel_layouts(&kept).expect("a surface");
    let settings = LayoutSettings { count: Some(80), ..USUAL };
    let layout = layouts.lay_out(&settings, &mut |_| ()).expect("the others are covered");
    assert!(session.take_panels(session.generation(), &layout.mesh).expect("it can be solved"));
    let positions = session.positions();
    let there = (0..).zip(positions).filter(|(_, position)| *position == at);
    let there: Vec<u32> = there.map(|(v, _)| v).collect();
    let held: Vec<u32> = session.solver().handles().iter().map(|handle| handle.vertex).collect();
    assert_eq!((there.len(), &held), (2, &there));
    let eave = &session.document().sets["eave"].vertices;
    assert!(there.iter().all(|v| eave.contains(v)), "{eave:?}");
}

/// The corners of all faces.
fn corners(mesh: &Mesh) -> Vec<Vec<Point>> {
    let of = |face: &[u32]| face.iter().map(|&v| mesh.positions[v as usize]).collect();
    mesh.faces.iter().map(of).collect()
}

#[test]
fn lines_lie_on_the_surface_and_those_at_irregular_points_come_first() {
    let session = opened(vault(12, true));
    let settings = LayoutSettings { count: Some(60), boundary: Some(Boundary::Followed), ..USUAL };
    let layout = laid_out(&session, &settings);
    assert!(layout.marked_lines < layout.lines.len() / 2);
    let height = |[x, y, z]: [f64; 3]| (z - 0.05 * x * y).abs();
    assert!(layout.lines.iter().flatten().all(|&point| height(point) < 0.02));
    for (line, ends) in layout.lines.iter().map(|line| (line, [line[0], line[line.len() - 1]])) {
        let chord = (Vec3::from(ends[0]) - Vec3::from(ends[1])).length();
        let way: f64 =
            line.windows(2).map(|p| (Vec3::from(p[0]) - Vec3::from(p[1])).length()).sum();
        assert!(way < 1.2 * chord, "{line:?}");
    }
}

#[test]
fn what_cannot_be_covered_is_refused_with_the_reason() {
    let session = opened(vault(8, false));
    let settings = LayoutSettings { size: Some(100.0), ..USUAL };
    let refused = lay_out(&session, &settings).expect_err("too large");
    assert!(refused.to_string().contains("too large for the surface"), "{refused}");
}

#[test]
fn panels_on_a_variation_stay_on_its_surface() {
    // They were kept to the surface of before the variation.
    let mut session = opened(vault(10, false));
    let up: Vec<Point> = session.positions().iter().map(|[x, y, z]| [*x, *y, z + 0.5]).collect();
    let start = session.positions().into();
    session.edit(Edit::KeepVariant { start }).expect("there is room");
    let mut scene = session.scene();
    scene.variants.kept[1].positions = up.clone().into();
    let mut session = Session::open(scene, session.mesh().clone()).expect("it fits");
    assert_eq!(session.positions(), up);
    let panels = laid_out(&session, &USUAL).mesh;
    assert!(session.take_panels(session.generation(), &panels).expect("nothing is locked"));
    let target = session.document().closeness.target.as_ref().and_then(Target::mesh);
    assert_eq!(target.map(|mesh| &mesh.positions), Some(&up));
}

#[test]
fn panels_that_are_fitted_to_another_surface_leave_the_outline_of_theirs() {
    // Their boundary was kept near it, which nobody had chosen.
    let mut session = opened(vault(10, false));
    let panels = laid_out(&session, &USUAL).mesh;
    assert!(session.take_panels(session.generation(), &panels).expect("nothing is locked"));
    let boundary = |session: &Session| session.document().closeness.boundary.require;
    assert_eq!(boundary(&session), BoundaryRequire::Soft);
    let mut raised = vault(10, false);
    raised.positions.iter_mut().for_each(|point| point[2] += 1.0);
    let text = write_obj(&raised, &raised.positions);
    session.edit(Edit::FitTo { name: "raised.obj".to_owned(), text }).expect("it is a mesh");
    assert_eq!(boundary(&session), BoundaryRequire::Off);
}
