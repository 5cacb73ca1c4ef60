//! The example that is a lesson: it is missed as it stands, and can be met and handed in.

use shape_up::example::{EXAMPLES, Example};
use shape_up::scene::{Results, Weights};
use shape_up::session::{Edit, Session, check_results};

fn lessons() -> impl Iterator<Item = &'static Example> {
    EXAMPLES.iter().filter(|example| example.build().0.lesson.is_some())
}

/// What the goals are after a run.
fn run(session: &mut Session) -> Vec<f64> {
    session.solve(false).expect("positions stay finite");
    let goals = session.goals();
    goals.iter().map(|goal| goal.value.expect("it is measured")).collect()
}

#[test]
fn there_is_a_lesson_among_the_examples() {
    let ids: Vec<_> = lessons().map(|example| example.id).collect();
    assert_eq!(ids, ["lesson-glass-roof"]);
    assert!(ids.iter().all(|id| id.starts_with("lesson-")));
}

#[test]
fn the_glass_roof_pulls_both_ways_and_can_be_met() {
    let example = lessons().next().expect("there is one");
    let (scene, mesh) = example.build();
    let mut session = Session::open(scene, mesh).expect("it can be solved");
    let [flat, near] = run(&mut session)[..] else { panic!("it has two goals") };
    assert!(flat > 0.001 && (0.05..0.06).contains(&near), "{flat} {near}");

    // Flatter alone is farther from where it was drawn.
    let weights = |shape, close| Edit::SetWeights(Weights { shape, close, smooth: 0.5 });
    session.edit(weights(1e4, 10.0)).expect("weights can be changed");
    let [flat, near] = run(&mut session)[..] else { panic!("it has two goals") };
    assert!(flat < 0.001 && near > 0.05, "{flat} {near}");

    session.edit(weights(1e4, 50.0)).expect("weights can be changed");
    let [flat, near] = run(&mut session)[..] else { panic!("it has two goals") };
    assert!(flat < 0.001 && near < 0.05, "{flat} {near}");

    // Who gets the results measures them again, on the lesson as it is in the files.
    let results = session.results("Ada", "").expect("it is a lesson");
    assert!(results.passed);
    let results = Results::from_json(&results.to_json()).expect("it was written here");
    let (scene, mesh) = example.build();
    let goals = check_results(&results, scene, mesh).expect("they are of this lesson").goals;
    assert!(goals.iter().all(|goal| goal.met), "{goals:?}");
}
