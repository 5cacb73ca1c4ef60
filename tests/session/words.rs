//! Verdicts in words: on a run, on hard constraints, and on trials of exactness.

use crate::support::grid::grid;
use serde_json::{Value, json};
use shape_up::mesh::Mesh;
use shape_up::scene::Scene;
use shape_up::session::{EndWords, Session};

/// Quads that are not flat.
fn wavy() -> Mesh {
    grid(4, 4, |i, j| [f64::from(i), f64::from(j), 0.2 * f64::from((7 * i + 5 * j) % 4)])
}

/// A solved session in metres with these constraints and handles.
fn solved(constraints: &Value, handles: &Value) -> Session {
    let text = json!({
        "format": "shape-up-scene", "version": 1, "units": "m", "mesh": { "file": "wavy.obj" },
        "constraints": constraints, "handles": handles,
        "weights": { "shape": 5, "close": 10, "smooth": 2 }, "closeness": { "to": "rest" },
        "smoothness": { "of": "displacement" },
    });
    let scene = Scene::from_json(&text.to_string()).expect("it is a scene");
    let mut session = Session::open(scene, wavy()).expect("it opens");
    session.solve(false).expect("regular");
    session
}

#[test]
fn a_run_says_whether_all_is_met_or_which_element_is_worst() {
    let mut session = solved(&json!([{ "kind": "plane", "on": "faces" }]), &json!([]));
    let met = session.run_verdict(10.0).expect("there is a constraint");
    assert!(met.met && met.worst.is_none() && met.numbers.is_empty(), "{met:?}");
    assert_eq!(met.brief, "All constraints are satisfied within 10 m.");
    let moved = session.moved_words();
    assert!(moved.starts_with("Moved at most ") && moved.ends_with(" on average."), "{moved}");

    let missed = session.run_verdict(0.001).expect("there is a constraint");
    let worst = missed.worst.expect("a face is not flat");
    let words = format!(
        "The run has ended, and some constraints are beyond the tolerance of 1 mm. Worst: Plane on {}.",
        worst.element
    );
    assert_eq!(missed.brief, words);
    let distance = &missed.numbers;
    assert!(distance.starts_with("Its distance is ") && distance.ends_with(" mm."), "{distance}");

    // A constraint without a weight is not judged.
    let weightless = json!([{ "kind": "plane", "on": "faces", "weight": 0 }]);
    assert_eq!(solved(&weightless, &json!([])).run_verdict(1.0), None);
}

#[test]
fn an_exact_shape_is_said_to_be_so_with_and_without_its_error() {
    let planes = |require: Value| json!([{ "kind": "plane", "on": "faces", "require": require }]);
    let words = solved(&planes(json!("exact")), &json!([])).exact_words().expect("it was met");
    assert_eq!(words.brief, "All required constraints are exact.");
    assert_eq!(words.numbers, "The largest error is 0 mm.");
    let within = solved(&planes(json!({ "within": 0.02 })), &json!([]));
    let words = within.exact_words().expect("it was met");
    assert_eq!(
        [&*words.brief, &words.numbers],
        ["All required constraints are satisfied within 20 mm.", ""]
    );
    assert!(words.suggestions.is_empty());
    // Of several, the largest was said to be that of all.
    let several = json!([
        { "kind": "plane", "on": { "vertices": [0, 1, 2, 3] }, "require": { "within": 0.01 } },
        { "kind": "plane", "on": "faces", "require": { "within": 0.02 } },
    ]);
    let words = solved(&several, &json!([])).exact_words().expect("it was met");
    let brief = "All required constraints are satisfied within their tolerances, of at most 20 mm.";
    assert_eq!(words.brief, brief);
    // Of both, only the tolerance was said.
    let both = json!([
        { "kind": "plane", "on": { "vertices": [0, 1, 2, 3] }, "require": "exact" },
        { "kind": "plane", "on": "faces", "require": { "within": 0.02 } },
    ]);
    let words = solved(&both, &json!([])).exact_words().expect("it was met");
    assert_eq!(words.brief, "All exact constraints are met exactly, the others within 20 mm.");
    assert_eq!(words.numbers, "The largest error of the exact ones is 0 mm.");
}

#[test]
fn what_contradicts_is_named_with_weaker_requirements_that_can_be_met() {
    let length = |length: f64| {
        let on = json!({ "vertices": [0, 1] });
        let name = format!("Length {length}");
        json!({ "kind": "line-segment", "on": on, "length": length, "require": "exact", "name": name })
    };
    // One that is met, though it is much farther off: its distance is not that of the others.
    let wide = json!({
        "kind": "sphere", "on": { "vertices": [7, 8, 12, 13, 18] }, "radius": 60,
        "require": { "within": 90 },
    });
    let session = solved(&json!([length(1.0), length(1.2), wide]), &json!([]));
    let words = session.exact_words().expect("it was tried");
    let start =
        "2 of 3 constraints cannot be satisfied together: Length 1 on 2 vertices, Length 1.2 on ";
    assert!(words.brief.starts_with(start), "{}", words.brief);
    assert!(words.brief.ends_with(" This is the closest shape that was found."), "{words:?}");
    assert!(words.numbers.starts_with("The largest error is "), "{words:?}");
    let found: Vec<_> = words.suggestions.iter().map(|one| (one.index, one.within)).collect();
    let [(0, None), (0, Some(wide)), (1, None), (1, Some(_))] = found[..] else {
        panic!("{found:?}")
    };
    let exact = session.exact().expect("it was tried");
    let worst = exact.worst[0].distance;
    assert!((worst..2.0 * worst).contains(&wide) && worst < exact.max_distance, "{exact:?}");
    assert_eq!(words.suggestions[0].label, "Make Length 1 soft");
    assert!(words.suggestions[1].label.starts_with("Length 1 within "), "{words:?}");
}

#[test]
fn the_cost_of_exactness_and_the_gain_of_an_improvement_are_said() {
    let within = json!([{ "kind": "plane", "on": "faces", "require": { "within": 0.02 } }]);
    let mut session = solved(&within, &json!([]));
    let mut trial = session.exact_trial().expect("regular").expect("it is within");
    while trial.step(&session).expect("regular") {}
    let cost = trial.offer(&session).expect("nothing has changed").words;
    assert_eq!(cost.taken, "Also made exact.");
    assert!(cost.offered.starts_with("If made exact, the shape would move by up to "), "{cost:?}");
    assert!(cost.away.starts_with("It would then be at most "), "{cost:?}");
    assert!(cost.away.ends_with(" on average, from the original."), "{cost:?}");
    assert!(session.make_exact(trial.shape(), &trial.positions(), false).expect("regular"));

    let mut search = session.improvement().expect("regular").expect("all is met");
    while search.step(&session).expect("regular") {}
    let gain = search.offer(&session).expect("nothing has changed").words;
    let kept = " % less energy; all that is required stays satisfied. It moved by up to ";
    assert!(gain.taken.starts_with("Improved: ") && gain.taken.contains(kept), "{gain:?}");
    assert!(gain.offered.starts_with("No better shape "), "{gain:?}");
}

#[test]
fn what_is_rounded_is_nothing_in_every_unit() {
    // "Worst 4.12e−13 cm", but 0 in metres and millimetres.
    let tilted = grid(5, 5, |i, j| {
        let [x, y] = [i, j].map(|k| 100.0 * f64::from(k));
        [x, y, 0.3 * x + 0.7 * y]
    });
    for units in ["m", "cm", "mm", "ft", "in"] {
        let text = json!({
            "format": "shape-up-scene", "version": 1, "units": units, "mesh": { "file": "a.obj" },
            "constraints": [{ "kind": "plane", "on": "faces", "require": "exact" }],
        });
        let scene = Scene::from_json(&text.to_string()).expect("it is a scene");
        let mut session = Session::open(scene, tilted.clone()).expect("it opens");
        let verdict = session.verdict(0.2).expect("panels are asked to be flat");
        assert!(verdict.worst > 0.0, "it is rounded");
        let numbers = session.verdict_words(&verdict).numbers;
        assert!(numbers.ends_with(" Your mesh did not move."), "{numbers}");
        assert!(numbers.starts_with("Worst 0 "), "{numbers}");
        let said = session.exact_words().expect("it is exact").numbers;
        let zero = if units == "m" { "0 mm" } else { &format!("0 {units}") };
        assert_eq!(said, format!("The largest error is {zero}."));
    }
}

#[test]
fn a_run_that_ends_has_converged_or_was_paused() {
    let EndWords { converged, paused } = EndWords::after(1);
    assert_eq!([converged, paused], ["Converged after 1 iteration", "Stopped after 1 iteration"]);
}
