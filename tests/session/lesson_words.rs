//! What is said of the goals of a lesson, and of how far they are met.

use super::lessons::{scene, session};
use crate::support::grid::{bumpy, grid};
use serde_json::json;
use shape_up::fabricate::BUILD_NUMBERS;
use shape_up::scene::Scene;
use shape_up::session::{Edit, Session, goals_in_words};
use shape_up::words;

#[test]
fn goals_and_their_values_are_said_as_readers_write_them() {
    let mut scene = scene();
    scene.lesson = Some(
        serde_json::from_value(json!({ "text": "Make every panel flat.", "goals": [
            { "measure": "planarity", "at_most": 0.005 },
            { "measure": "planarity", "beyond": 0.005, "at_most": 0 },
            { "measure": "planarity", "beyond": 0.005, "at_most": 1 },
            { "measure": "planarity", "beyond": 0.005, "at_most": 12 },
            { "measure": "displacement", "at_most": 0 },
            { "constraint": "Panels", "at_most": 0 },
            { "constraint": "Panels", "at_most": 0.2 },
            { "build": "types", "at_most": 3 } ] }))
        .expect("it is a lesson"),
    );
    let sentences = |scene: &Scene| -> Vec<String> {
        let lesson = scene.lesson.as_ref().expect("it has one");
        goals_in_words(lesson, &scene.units).into_iter().map(|goal| goal.sentence).collect()
    };
    let types =
        BUILD_NUMBERS.iter().find(|number| number.id == "types").expect("it is declared").label;
    assert_eq!(
        sentences(&scene),
        [
            "Planarity: at most 5 mm",
            "Planarity: no panel beyond 5 mm",
            "Planarity beyond 5 mm: at most 1 panel",
            "Planarity beyond 5 mm: at most 12 panels",
            "Moved: at most 0 mm",
            "Panels: exact",
            "Panels: largest distance at most 0.2 m",
            &format!("{types}: at most 3"),
        ]
    );
    scene.units = String::new();
    assert_eq!(sentences(&scene)[6], "Panels: largest distance at most 0.2");
    scene.units = "m".to_owned();

    let mut session = Session::open(scene, bumpy(5)).expect("it fits");
    let worst = session.measures().planarity.max_distance;
    let beyond = session.goals()[1].value.expect("it is measured");
    let progress = session.lesson_progress().expect("there is a lesson");
    let said: Vec<_> = progress.goals.iter().map(|goal| (goal.words, &*goal.value)).collect();
    // In the unit of the limit.
    let in_mm = words::length_like(worst, "m", 0.005);
    assert_eq!(said[0], ("not satisfied", &*in_mm));
    assert_eq!(said[1], ("not satisfied", &*format!("{beyond} panels")));
    assert_eq!(said[4], ("satisfied", "0 mm"));
    assert_eq!(said[7], ("not satisfied", "measured when the shape no longer moves"));
    let met = progress.goals.iter().filter(|goal| goal.met).count();
    assert_eq!((progress.passed, progress.words), (false, format!("{met} of 8 goals satisfied")));
    // A goal without a value waited for the shape to rest, which it did.
    session.set_build_numbers(Vec::new());
    let progress = session.lesson_progress().expect("there is a lesson");
    assert_eq!(progress.goals[7].value, "cannot be measured: see Build");
}

#[test]
fn what_is_zero_but_for_rounding_meets_a_limit_of_zero() {
    // "At most 0 mm, now 0 mm: not satisfied".
    let mut scene = scene();
    let goals = json!([{ "measure": "planarity", "at_most": 0 },
                       { "measure": "planarity", "beyond": 0, "at_most": 0 }]);
    let lesson = json!({ "text": "Make every panel flat.", "goals": goals });
    scene.lesson = Some(serde_json::from_value(lesson).expect("it is a lesson"));
    let tilted = |i: u32, j: u32| {
        let [x, y] = [i, j].map(f64::from);
        [x, y, 0.3 * x + 0.7 * y]
    };
    let mut session = Session::open(scene, grid(5, 5, tilted)).expect("it fits");
    assert!(session.measures().planarity.max_distance > 0.0, "it is rounded");
    assert!(session.lesson_progress().expect("there is a lesson").passed);
}

#[test]
fn a_lesson_is_passed_when_all_goals_are_met() {
    let progress = |session: &mut Session| session.lesson_progress().expect("there is a lesson");
    let mut session = session();
    assert_eq!(progress(&mut session).words, "1 of 3 goals satisfied");
    session.solve(false).expect("positions stay finite");
    let passed = progress(&mut session);
    assert!(passed.passed && passed.goals.iter().all(|goal| goal.words == "satisfied"));
    assert_eq!(passed.words, "Passed: 3 goals satisfied");
    session.edit(Edit::SetLesson { lesson: None, unsolved: false }).expect("it can be removed");
    assert_eq!(session.lesson_progress(), None);
}
