//! Improving an exact shape: the energy never rises, and the shape stays exact.

use crate::solve::exact::{Known, known, worst_face};
use crate::support::grid::grid;
use crate::support::hard::Case;
use proptest::prelude::*;
use shape_up::mesh::{Mesh, Point};
use shape_up::solve::{ExactAnswer, Handle, Hold, Improved, Require, Stage};

/// The exact shape and the improved one, with their answers.
fn improved(case: &Case) -> [(Vec<Point>, ExactAnswer); 2] {
    let mut exact = case.exact(&case.soft());
    exact.run().expect("its systems are regular");
    let first = (exact.positions(), exact.answer());
    exact.improve();
    exact.run().expect("its systems are regular");
    [first, (exact.positions(), exact.answer())]
}

fn gained(answer: &ExactAnswer) -> Improved {
    answer.improved.expect("there is something to improve")
}

#[test]
fn it_ends_at_the_best_known_energy_or_below_on_real_meshes() {
    for known in known() {
        let Known { name, case, expected, diameter, .. } = &known;
        let [_, (positions, answer)] = improved(case);
        let f = gained(&answer).after / (diameter * diameter);
        let best = expected["best"]["f"].as_f64().expect("a number");
        assert!(f <= (1.0 + 1e-4) * best, "{name}: {f} is more than {best}");
        let worst = known.worst(&positions);
        assert!(worst <= 1e-12 && answer.met, "{name}: {worst}");
    }
}

#[test]
fn a_poor_valley_is_left() {
    let Some(mesh) = crate::support::shared::mesh("cmc1.obj") else { return };
    let [_, (_, answer)] = improved(&Case::new(mesh).on_faces("plane", Require::Exact));
    let Improved { before, after, .. } = gained(&answer);
    assert!(after < 0.7 * before, "{before} to {after}");
}

/// Bumps displaced by `off`, with one pulled handle.
fn pulled(off: &[f64], kind: &str, pull: f64) -> Case {
    let n = 5;
    let mesh: Mesh = grid(n, n, |i, j| {
        let (x, y) = (f64::from(i), f64::from(j));
        let off = |k: usize| off[(i as usize * 31 + j as usize * 17 + k * 7) % off.len()];
        [x + off(0), y + off(1), 0.06 * (x - 2.0) * (y - 1.0) + off(2)]
    });
    let mut case = Case::new(mesh).on_faces(kind, Require::Exact);
    let mut target = case.mesh.positions[0];
    target[2] += pull;
    case.handles = vec![Handle { vertex: 0, target, hold: Hold::Fixed }];
    case
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(24))]

    #[test]
    fn it_is_never_worse_never_less_exact_and_the_same_again(
        off in prop::collection::vec(-0.15..0.15, 11),
        kind in prop::sample::select(vec!["circle", "plane", "rectangle"]),
        pull in -1.0..1.0,
    ) {
        let case = pulled(&off, kind, pull);
        let [(_, first), (positions, answer)] = improved(&case);
        if let Some(Improved { before, after, .. }) = answer.improved {
            prop_assert!(after <= before, "{before} to {after}");
        }
        prop_assert_eq!(first.met, answer.met);
        if kind != "rectangle" && answer.met {
            let worst = worst_face(&case.mesh, &positions, usize::from(kind == "circle"));
            prop_assert!(worst <= 1e-10 * case.size(), "{}", worst);
        }
        prop_assert_eq!(positions[0], case.handles[0].target);
        let [_, (again, _)] = improved(&case);
        prop_assert_eq!(positions, again, "it is the same each time");
    }
}

#[test]
fn what_is_improved_has_little_left_to_gain() {
    let off: Vec<f64> = (0..11).map(|k| 0.02 * f64::from(k * 7 % 11) - 0.1).collect();
    let case = pulled(&off, "circle", 0.5);
    let [_, (positions, answer)] = improved(&case);
    let mut exact = case.exact(&positions);
    exact.improve();
    exact.run().expect("its systems are regular");
    let again = gained(&exact.answer());
    let first = gained(&answer);
    assert!(first.after < first.before);
    let left = again.before - again.after;
    assert!(left <= 5e-3 * first.after, "{left} of {}", first.after);
}

#[test]
fn stopped_at_any_step_it_is_exact_and_no_worse() {
    let Some(mesh) = crate::support::shared::mesh("cmc1.obj") else { return };
    let case = Case::new(mesh).on_faces("plane", Require::Exact);
    let mut exact = case.exact(&case.soft());
    exact.run().expect("its systems are regular");
    exact.improve();
    let mut energy = exact.energy().total;
    for _ in 0..3 {
        assert_eq!(exact.step().expect("its systems are regular"), Stage::Improve);
        let now = exact.energy().total;
        assert!(now <= energy && exact.answer().met, "{energy} to {now}");
        energy = now;
    }
    let there = exact.positions();
    exact.stop();
    assert_eq!((exact.positions(), exact.stage()), (there, Stage::Ended));
}

#[test]
fn what_is_not_met_is_not_improved() {
    let mesh = grid(2, 2, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let length = |length: f64| serde_json::json!({ "length": length });
    let both =
        |case: Case, it: f64| case.with("line-segment", length(it), [vec![0, 1]], Require::Exact);
    let case = both(both(Case::new(mesh), 0.9), 1.1);
    let [(before, first), (after, answer)] = improved(&case);
    assert!(!first.met && answer.improved.is_none());
    assert_eq!(before, after);
}
