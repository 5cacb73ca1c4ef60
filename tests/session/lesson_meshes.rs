//! Lessons whose mesh may be changed: results on another mesh are of the same exercise.

use crate::support::grid::bumpy;
use shape_up::scene::{BuildSettings, Goal, GoalOf, Hold, Product, Scene};
use shape_up::session::{Edit, Session, check_results};

/// Flat panels and a straight side, between two fixed corners, to be reached on any mesh.
fn scene() -> Scene {
    let text = r#"{ "format": "shape-up-scene", "version": 1, "title": "Roof", "units": "m",
        "mesh": { "file": "grid.obj" },
        "sets": { "eave": { "vertices": [0, 1, 2, 3, 4, 5, 6, 7, 8] } },
        "constraints": [{ "kind": "plane", "on": "faces", "weight": 100 },
                        { "kind": "line", "on": { "set": "eave" }, "weight": 1, "name": "Eave" }],
        "handles": [{ "vertices": [0, 1] }],
        "lesson": { "text": "Make every panel flat.", "goals": [
            { "measure": "planarity", "at_most": 1 }, { "constraint": "Eave", "at_most": 9 } ],
            "lock": ["weights", "constraints", "handles"] } }"#;
    let mut scene = Scene::from_json(text).expect("the scene is valid");
    scene.handles[0].hold = Hold::Fixed;
    scene
}

fn session() -> Session {
    Session::open(scene(), bumpy(8)).expect("it fits")
}

fn refine(adopt: bool) -> Edit {
    let text = format!(
        r#"{{ "refine": {{ "scheme": "linear", "levels": 1, "keep": 180, "adopt": {adopt} }} }}"#
    );
    Edit::from_json(&text).expect("it is an edit")
}

#[test]
fn on_another_mesh_only_what_the_student_changed_counts() {
    // Refining carries handles and sets over.
    let mut refined = session();
    refined.edit(refine(false)).expect("the mesh is not locked");
    let results = refined.results("Ada", "").expect("it is a lesson");
    let checked = check_results(&results, scene(), bumpy(8)).expect("it is of this lesson");
    assert_eq!((checked.altered, checked.changed), (Vec::new(), vec!["mesh".to_owned()]));
    // The eave is a set of the first mesh: what a student puts there instead is not believed.
    assert_eq!(checked.goals.iter().map(|it| it.met).collect::<Vec<_>>(), [true, false]);
    assert_eq!(checked.goals[1].value, None);
}

#[test]
fn parts_are_counted_on_another_mesh_although_seams_are_edges_of_the_first_one() {
    let mut scene = scene();
    scene.build = Some(Box::new(BuildSettings {
        product: Product::Paper,
        seams: [[10, 11]].into(),
        ..BuildSettings::default()
    }));
    let lesson = scene.lesson.as_mut().expect("it has one");
    lesson.goals[1] = Goal { of: GoalOf::Build("sheets".to_owned()), at_most: 9.0 };
    let mut refined = Session::open(scene.clone(), bumpy(8)).expect("it fits");
    refined.edit(refine(false)).expect("the mesh is not locked");
    let results = refined.results("Ada", "").expect("it is a lesson");
    let checked = check_results(&results, scene, bumpy(8)).expect("it is of this lesson");
    assert!(checked.goals[1].met && checked.goals[1].value.is_some(), "{:?}", checked.goals);
}

#[test]
fn goals_stay_in_the_order_of_the_lesson_and_are_met_by_all_rows_of_their_name() {
    // Those that cannot be measured came last, and a student was said to have lied; and a goal on two
    // rows of one name was measured on the row that was left.
    let text = scene().to_json(&bumpy(8));
    let text = text.replace(r#""name": "Eave""#, r#""name": "Flat""#);
    let mut scene = Scene::from_json(&text).expect("the scene is valid");
    scene.constraints[0].name = "Flat".to_owned();
    let lesson = scene.lesson.as_mut().expect("it has one");
    lesson.goals.reverse();
    lesson.goals[0].of = GoalOf::Constraint("Flat".to_owned());
    let mut refined = Session::open(scene.clone(), bumpy(8)).expect("it fits");
    refined.edit(refine(false)).expect("the mesh is not locked");
    let results = refined.results("Ada", "").expect("it is a lesson");
    let checked = check_results(&results, scene, bumpy(8)).expect("it is of this lesson");
    let found: Vec<_> = checked.goals.iter().map(|it| (&it.goal.of, it.met)).collect();
    let said: Vec<_> = results.goals.iter().map(|it| &it.goal.of).collect();
    assert_eq!(found, [(said[0], false), (said[1], true)]);
    assert_eq!(checked.goals[0].value, None);
}

#[test]
fn the_shape_that_was_given_stays_what_goals_are_measured_from() {
    let mut session = session();
    session.solve(false).expect("positions stay finite");
    let refused = session.edit(refine(true)).expect_err("displacement would be 0").to_string();
    assert!(refused.contains("expected the original"), "{refused}");
    session.edit(refine(false)).expect("the mesh is not locked");
}

#[test]
fn a_lesson_that_is_saved_again_is_the_same_exercise_until_it_is_handed_out() {
    let mut session = session();
    session.edit(refine(false)).expect("the mesh is not locked");
    let exercise = |session: &mut Session| session.results("Ada", "").expect("a lesson").scene;
    let given = exercise(&mut session);
    assert_eq!(given, scene().fingerprint(&bumpy(8)));
    let lesson = || scene().lesson;
    let save = |unsolved| Edit::SetLesson { lesson: lesson(), unsolved };
    session.edit(save(false)).expect("it asks the same");
    assert_eq!(exercise(&mut session), given);
    session.edit(save(true)).expect("it asks the same");
    assert_ne!(exercise(&mut session), given);
}
