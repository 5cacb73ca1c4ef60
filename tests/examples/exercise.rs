//! Examples that are lessons: their goals are missed at first, and can be met and handed in.

use shape_up::fabricate::{BUILD_NUMBERS, Build, Stand, unit_of};
use shape_up::generate::example::{EXAMPLES, Example};
use shape_up::mesh::Mesh;
use shape_up::scene::{MeshSource, Results, Scene, Weights};
use shape_up::session::{Edit, LayoutSettings, Session, check_results};
use shape_up::solve::Require;

fn lessons() -> impl Iterator<Item = &'static Example> {
    EXAMPLES.iter().filter(|example| example.build().0.lesson.is_some())
}

/// Values of the goals after a run.
fn run(session: &mut Session) -> Vec<f64> {
    session.solve(false).expect("positions stay finite");
    let goals = session.goals();
    goals.iter().map(|goal| goal.value.expect("it is measured")).collect()
}

#[test]
fn there_are_lessons_among_the_examples() {
    let ids: Vec<_> = lessons().map(|example| example.id).collect();
    let expected = [
        "what-a-projection-is",
        "circles",
        "curvature-and-panels",
        "from-surface-to-panels",
        "circles-and-offsets",
        "stiffness-of-hexagons",
        "paper-model",
        "exact-and-variations",
        "glass-roof",
    ];
    assert_eq!(ids, expected.map(|id| format!("lesson-{id}")));
}

/// The lesson with this id, opened.
fn opened(id: &str) -> Session {
    let example = lessons().find(|example| example.id == id).expect("it is a lesson");
    let (scene, mesh) = example.build();
    Session::open(scene, mesh).expect("it can be solved")
}

/// Whether each goal is met now.
fn met(session: &mut Session) -> Vec<bool> {
    session.goals().iter().map(|goal| goal.met).collect()
}

/// What sets the requirement of the first row.
fn requires(require: Require) -> Edit {
    Edit::SetConstraint {
        index: 0,
        weight: None,
        enabled: None,
        require: Some(require),
        params: Default::default(),
    }
}

#[test]
fn the_glass_roof_pulls_both_ways_and_can_be_met() {
    let example = lessons().find(|example| example.id == "lesson-glass-roof").expect("it is there");
    let mut session = opened(example.id);
    let [flat, near] = run(&mut session)[..] else { panic!("it has two goals") };
    assert!(flat > 0.001 && (0.05..0.06).contains(&near), "{flat} {near}");

    // Flatter panels alone are farther from the drawn shape.
    let weights = |shape, close| Edit::SetWeights(Weights { shape, close, smooth: 0.5 }.into());
    session.edit(weights(1e4, 10.0)).expect("weights can be changed");
    let [flat, near] = run(&mut session)[..] else { panic!("it has two goals") };
    assert!(flat < 0.001 && near > 0.05, "{flat} {near}");

    session.edit(weights(1e4, 50.0)).expect("weights can be changed");
    let [flat, near] = run(&mut session)[..] else { panic!("it has two goals") };
    assert!(flat < 0.001 && near < 0.05, "{flat} {near}");

    // The recipient of the results measures them again, on the lesson as it is in the files.
    let results = session.results("Ada", "").expect("it is a lesson");
    assert!(results.passed);
    let results = Results::from_json(&results.to_json()).expect("it was written here");
    let (scene, mesh) = example.build();
    let goals = check_results(&results, scene, mesh).expect("they are of this lesson").goals;
    assert!(goals.iter().all(|goal| goal.met), "{goals:?}");
}

/// Which goals are met after the row of a lesson gets this requirement, before or after a run.
fn required(id: &str, require: Require, runs_first: bool) -> Vec<bool> {
    let mut session = opened(id);
    assert_eq!(met(&mut session), [false, true], "{id} starts unsolved");
    if runs_first {
        session.solve(false).expect("positions stay finite");
        assert!(!met(&mut session)[0], "{id} is not met by Run alone");
    }
    session.edit(requires(require)).expect("it is not locked");
    session.solve(false).expect("positions stay finite");
    let weights = Weights { shape: 1e5, close: 0.0, smooth: 0.0 };
    session.edit(Edit::SetWeights(weights.into())).expect_err("it is locked");
    met(&mut session)
}

#[test]
fn closeness_decides_how_far_projections_get() {
    let mut session = opened("lesson-what-a-projection-is");
    let mut with = |close: f64| {
        let weights = Weights { shape: 1.0, close, smooth: 0.0 };
        session.edit(Edit::SetWeights(weights.into())).expect("weights are not locked");
        session.solve(false).expect("positions stay finite");
        met(&mut session)
    };
    assert_eq!([0.1, 0.01].map(&mut with), [[false, true], [true, true]]);
}

/// Builds the parts of the shape, as a host does, for the goals on them.
fn build(session: &mut Session) {
    let settings = session.document().build.clone().expect("the lesson has settings");
    let mesh = Mesh { positions: session.positions(), ..session.mesh().clone() };
    let unit = unit_of("m").expect("it is known");
    let numbers = Build::new(&mesh, &settings, unit, &Stand::default()).expect("panels").numbers();
    let known = BUILD_NUMBERS.iter().zip(numbers);
    let known = known.filter_map(|(number, value)| Some((number.id.to_owned(), value?)));
    session.set_build_numbers(known.collect());
}

#[test]
fn a_model_of_flat_panels_fits_on_two_sheets_at_the_right_scale() {
    let mut session = opened("lesson-paper-model");
    build(&mut session);
    assert_eq!(met(&mut session), [false, false]);
    session.solve(false).expect("positions stay finite");
    build(&mut session);
    assert_eq!(met(&mut session), [true, false]);
    let edit = Edit::from_json(r#"{ "setBuild": { "values": { "scale": 100 } } }"#);
    session.edit(edit.expect("an edit")).expect("settings are not locked");
    build(&mut session);
    assert_eq!(met(&mut session), [true, true]);
}

#[test]
fn near_is_not_exact_and_exact_is_within_reach() {
    let id = "lesson-stiffness-of-hexagons";
    for runs_first in [false, true] {
        assert_eq!(required(id, Require::Exact, runs_first), [true, true]);
        assert!(!required(id, Require::Within(0.001), runs_first)[0]);
    }
}

#[test]
fn flat_panels_are_not_circular_and_a_press_makes_them_so() {
    let mut session = opened("lesson-circles");
    assert_eq!(met(&mut session), [false, true]);
    assert_eq!(met_by_run(&mut session), [false, true]);
    assert!(session.measures().planarity.max_distance < 0.001);
    session.solve_as_pressed(Some("circle"), session.tolerance(), false).expect("there are quads");
    assert_eq!(met(&mut session), [true, true]);
    assert!(session.measures().planarity.max_distance < 0.001);
    // The row Plane is switched off.
    let enabled: Vec<_> = session.document().constraints.iter().map(|row| row.enabled).collect();
    assert_eq!(enabled, [false, true]);
}

#[test]
fn beams_are_flat_once_panels_are_exactly_circular() {
    for runs_first in [false, true] {
        let mut session = opened("lesson-circles-and-offsets");
        build(&mut session);
        assert_eq!(met(&mut session), [false, true]);
        if runs_first {
            session.solve(false).expect("positions stay finite");
            build(&mut session);
            assert_eq!(met(&mut session), [false, true]);
        }
        for (require, are_flat) in [(Require::Within(0.001), false), (Require::Exact, true)] {
            session.edit(requires(require)).expect("it is not locked");
            session.solve(false).expect("positions stay finite");
            build(&mut session);
            assert_eq!(met(&mut session), [are_flat, true]);
        }
    }
}

#[test]
fn across_the_lines_of_curvature_exact_costs_more_than_within() {
    let id = "lesson-curvature-and-panels";
    for runs_first in [false, true] {
        assert_eq!(required(id, Require::Within(0.001), runs_first), [true, true]);
        assert_eq!(required(id, Require::Exact, runs_first), [true, false]);
    }
}

/// Runs, and returns which goals are met.
fn met_by_run(session: &mut Session) -> Vec<bool> {
    session.solve(false).expect("positions stay finite");
    met(session)
}

#[test]
fn panels_along_the_lines_of_curvature_stay_on_a_surface_that_those_across_leave() {
    let id = "lesson-from-surface-to-panels";
    let mut across = opened(id);
    assert_eq!(met(&mut across), [false, true]);
    assert_eq!(met_by_run(&mut across), [true, false]);

    let mut along = opened(id);
    let wished = LayoutSettings { count: None, size: None, follow: 0.5, even: 0.5, boundary: None };
    let mut layouts = along.panel_layouts(&[]).expect("no face is kept");
    let layout = layouts.lay_out(&wished, &mut |_| ()).expect("it is a surface");
    assert!(along.take_panels(along.generation(), &layout.mesh).expect("nothing is locked"));
    along.solve_as_pressed(Some("circle"), along.tolerance(), false).expect("there are quads");
    assert_eq!(met(&mut along), [true, true]);

    // Another mesh does not make it another exercise, also after it was saved and opened again.
    let scene = Scene::from_json(&along.scene_with_mesh()).expect("it is a scene");
    let MeshSource::Inline(mesh) = scene.mesh.clone() else { panic!("the mesh is in the scene") };
    let mut again = Session::open(scene, *mesh).expect("it can be solved");
    for session in [&mut along, &mut again] {
        let results = session.results("Ada", "").expect("it is a lesson");
        let results = Results::from_json(&results.to_json()).expect("it was written here");
        let (scene, mesh) = lessons().find(|it| it.id == id).expect("it is there").build();
        let checked = check_results(&results, scene.clone(), mesh.clone()).expect("of this lesson");
        assert!(checked.goals.iter().all(|goal| goal.met), "{:?}", checked.goals);
        // Closeness to the first surface is set by what lays panels out, not by the student.
        assert_eq!((checked.altered, checked.changed), (Vec::new(), vec!["mesh".to_owned()]));
        // The goals are measured again: of a shape that left the surface one is missed.
        let mut lifted = results.clone();
        lifted.positions.iter_mut().for_each(|p| p[2] += 0.8);
        let checked = check_results(&lifted, scene, mesh).expect("of this lesson");
        assert_eq!(checked.goals.iter().map(|goal| goal.met).collect::<Vec<_>>(), [true, false]);
    }
}

#[test]
fn a_variation_of_an_exact_roof_has_better_corners() {
    let mut session = opened("lesson-exact-and-variations");
    assert_eq!(met_by_run(&mut session), [true, false]);
    let mut variations = session.variations().expect("regular").expect("all is exact");
    while variations.step().expect("regular") {}
    // One slider is enough, to one of its ends.
    let mut coefficients = vec![0.0; variations.modes().len()];
    let found = [-0.095, 0.095].into_iter().any(|end| {
        coefficients[0] = end;
        let varied = variations.go(&coefficients).expect("regular");
        let (generation, report) = (variations.generation(), Some(varied.report));
        assert!(session.show_variation(generation, &varied.positions, report));
        met(&mut session) == [true, true]
    });
    assert!(found);
    assert!(session.keep_variation().expect("there is room"));
    assert!(session.results("Ada", "").expect("it is a lesson").passed);
}
