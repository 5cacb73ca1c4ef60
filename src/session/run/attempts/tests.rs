//! Tests of the order and the choice of attempts.

use super::*;
use crate::session::run::easing::Tolerances;
use crate::session::run::outcome::Outcome;
use crate::session::run::shape_measure::{Bend, BendChange, SurfaceDistance};

const EDGE: f64 = 1.0;

fn folds(count: u32) -> Outcome {
    Outcome::of_test(&(0..count).collect::<Vec<_>>())
}

fn away(far: f64) -> Outcome {
    let mut outcome = folds(0);
    outcome.measure.surface = SurfaceDistance { rms: far, max: far };
    outcome
}

fn bent(now: f64) -> Outcome {
    let mut outcome = folds(0);
    outcome.measure.bend = Bend { rest: 4.0, now, change: Some(BendChange::Rougher) };
    outcome
}

fn flat(folded: u32) -> Outcome {
    let mut outcome = folds(folded);
    let change = Some(BendChange::Flatter);
    outcome.measure.bend = Bend { rest: 4.0, now: 1.0, change };
    outcome
}

fn attempts(search: Search, from: AttemptStart) -> Attempts {
    let named = ChosenAttempt { from, ..ChosenAttempt::default() };
    Attempts::new(search, named, [true; 4], 1000, [EDGE; 2])
}

/// The attempts that follow these `outcomes`, and whether each was the best so far.
fn follow(search: Search, outcomes: &[Outcome]) -> Vec<(bool, Option<Attempt>)> {
    let mut attempts = attempts(search, AttemptStart::Soft);
    let each = outcomes.iter().map(|outcome| {
        let next = attempts.after(outcome, &|faces| faces.to_vec());
        let is_best = attempts.is_best();
        if let Some(next) = next.clone() {
            attempts.begin(next);
        }
        (is_best, next)
    });
    each.collect()
}

fn press(outcomes: &[Outcome]) -> Vec<(bool, Option<Attempt>)> {
    follow(Search::Panels(4e-4), outcomes)
}

const REST: Option<Attempt> = Some(Attempt::FromRest);
const EXACT: Option<Attempt> = Some(Attempt::Exact);
const SMOOTHER: [Option<Attempt>; 2] =
    [Some(Attempt::Smoother(10.0)), Some(Attempt::Smoother(30.0))];
const SURFACE: Option<Attempt> = Some(Attempt::OnSurface);

#[test]
fn a_good_shape_ends_the_search() {
    assert_eq!(press(&[folds(0)]), [(true, None)]);
    let found = press(&[folds(20), folds(20), folds(0)]);
    assert_eq!(found, [(true, SMOOTHER[0].clone()), (false, REST), (true, None)]);
}

#[test]
fn what_is_not_met_is_tried_in_all_ways() {
    // It used to be tried once.
    let unmet = |misses| Outcome { met: false, misses, ..folds(0) };
    let all = press(&[unmet(8), unmet(4), unmet(4), unmet(4), folds(0)]);
    let next: Vec<Option<Attempt>> = all.iter().map(|(_, next)| next.clone()).collect();
    let [ten, thirty] = SMOOTHER;
    assert_eq!(next, [ten, thirty, REST, SURFACE, None]);
    let best: Vec<bool> = all.iter().map(|(is_best, _)| *is_best).collect();
    assert_eq!(best, [true, true, false, false, true]);
}

#[test]
fn a_few_folds_may_go_where_panels_are_exact() {
    let found = press(&[folds(10), folds(0)]);
    assert_eq!(found, [(true, EXACT), (true, None)]);
}

#[test]
fn a_surface_that_moves_far_may_stay_where_vertices_slide() {
    let found = press(&[away(0.4), away(0.38), away(0.1)]);
    assert_eq!(found, [(true, REST), (false, SURFACE), (true, None)]);
    // Shapes that are alike do not change the choice.
    let found = press(&[away(0.4), away(0.39), away(0.35)]);
    assert_eq!(found, [(true, REST), (false, SURFACE), (false, None)]);
    // A run of a scene keeps its closeness.
    assert_eq!(follow(Search::Scene, &[away(0.4)]), [(true, None)]);
}

#[test]
fn what_is_rough_may_become_fair_with_more_smoothness() {
    let [ten, thirty] = SMOOTHER;
    let found = press(&[bent(12.0), folds(0)]);
    assert_eq!(found, [(true, ten.clone()), (true, None)]);
    let found = press(&[bent(12.0), bent(9.0), bent(7.0)]);
    assert_eq!(found, [(true, ten.clone()), (true, thirty), (true, SURFACE)]);
    // If more smoothness hardly helps, even more is not tried.
    assert_eq!(press(&[bent(12.0), bent(11.0)]), [(true, ten), (false, SURFACE)]);
}

#[test]
fn a_shape_without_folds_may_not_be_too_far_away() {
    let folded_at = |far: f64| {
        let mut outcome = away(far);
        outcome.measure.folded = (0..20).collect();
        outcome
    };
    let folded = folded_at(0.3);
    assert_eq!(press(&[folded.clone(), away(0.8)])[1], (true, REST));
    // One that is farther is the last resort: the search goes on for another.
    let found = press(&[folded.clone(), away(1.0), folds(20), folds(20), folded.clone()]);
    assert!(found[1].0 && matches!(found[4], (false, Some(Attempt::Eased(_)))), "{found:?}");
    assert_eq!(press(&[folded, away(1.0), away(0.8)])[2], (true, REST));
    // Within the limits of a good shape none is, though it is many times as far as the first.
    let found = press(&[folded_at(1e-4), away(0.1)]);
    assert_eq!(found, [(true, SMOOTHER[0].clone()), (true, None)]);
}

#[test]
fn tolerances_are_eased_last() {
    let all = press(&[folds(20), folds(20), folds(20), folds(20), folds(0)]);
    let settings = ChosenAttempt::default();
    let within = |within| Some(Attempt::Eased(Tolerances { settings, within, eased: None }));
    let next: Vec<Option<Attempt>> = all.into_iter().map(|(_, next)| next).collect();
    let [ten, _] = SMOOTHER;
    assert_eq!(next, [ten, REST, SURFACE, within(0.04), within(0.004)]);
    let scene = follow(Search::Scene, &[folds(20), folds(20), folds(20)]);
    assert_eq!(scene[2], (false, None));
}

#[test]
fn where_easing_fails_it_has_the_settings_of_the_fewest_faults() {
    // Two real meshes kept 5 and 22 folds, and could be eased with thirty times the smoothness.
    let counts = [200, 50, 20, 190, 60, 180, 30, 0];
    let all = press(&counts.map(folds));
    let next: Vec<Option<Attempt>> = all.iter().map(|(_, next)| next.clone()).collect();
    let [ten, thirty] = SMOOTHER;
    let eased = |smoother, within| {
        let settings = ChosenAttempt { smoother, ..ChosenAttempt::default() };
        Some(Attempt::Eased(Tolerances { settings, within, eased: None }))
    };
    let from_soft = Some(Attempt::SmootherFromSoft(30.0));
    let expected = [ten, thirty, REST, SURFACE, eased(1.0, 0.04), from_soft, eased(30.0, 0.04)];
    assert_eq!(next[..7], expected);
    assert_eq!((all[6].0, &all[7]), (false, &(true, eased(30.0, 0.004))));
    // What slides has begun at its own soft solution.
    let all = press(&[200, 200, 200, 20, 180, 0].map(folds));
    let settings = ChosenAttempt { on_surface: true, ..ChosenAttempt::default() };
    let slides = Attempt::Eased(Tolerances { settings, within: 0.04, eased: None });
    assert_eq!(all[4], (false, Some(slides)));
    // Without folds it is the result itself; no settings but those of the scene are no others.
    assert_eq!(press(&[200, 50, 20, 190, 60, 180, 0].map(folds))[6], (true, None));
    assert_eq!(press(&[200, 200, 200, 200, 200].map(folds))[4], (false, None));
}

#[test]
fn some_larger_tolerances_are_better_than_another_design() {
    let outcomes = [folds(20), flat(0), flat(0), flat(0), folds(0), folds(0), folds(0)];
    let best: Vec<bool> = press(&outcomes).iter().map(|(is_best, _)| *is_best).collect();
    // Only the last of them has the required tolerance.
    assert_eq!(best, [true, true, false, false, false, false, true]);
    // Where nothing folds, nothing is eased.
    assert_eq!(press(&[flat(0), flat(0), flat(0)])[2], (false, None));
}

#[test]
fn what_is_listed_as_chosen_is_the_shape_that_is_kept() {
    // A later step within larger tolerances was listed, though it was not taken.
    let moved = |mut outcome: Outcome, far: f64| {
        outcome.measure.moved.max = far;
        outcome
    };
    let mut attempts = attempts(Search::Panels(4e-4), AttemptStart::Soft);
    let before = [folds(20), flat(0), flat(0), flat(0), folds(0), folds(0), folds(1)];
    for outcome in before.into_iter().chain([moved(folds(0), 0.1), moved(flat(0), 0.5)]) {
        let next = attempts.after(&outcome, &|faces| faces.to_vec());
        next.into_iter().for_each(|next| drop(attempts.begin(next)));
    }
    let (tried, chosen) = attempts.tried();
    let listed = chosen.map(|place| (&*tried[place].name, tried[place].moved));
    assert_eq!(listed, Some(("eased", 0.1)), "{tried:?}");
}

#[test]
fn where_the_tolerance_is_more_than_needed_the_rest_shape_is_another_start() {
    let soft = Outcome { work: 0, ..folds(0) };
    let near = Outcome { energy: 1.0, ..folds(0) };
    assert_eq!(press(&[soft.clone(), near.clone()]), [(true, REST), (true, None)]);
    // It is taken if it costs less, and folds no more.
    let costly = Outcome { energy: 9.5, ..near };
    assert_eq!(press(&[soft.clone(), costly]), [(true, REST), (false, None)]);
    assert_eq!(press(&[soft, folds(1)])[1], (false, None));
}

#[test]
fn a_scene_is_run_as_it_was_solved() {
    let first = |from, search| attempts(search, from).now;
    let press = Search::Panels(4e-4);
    assert_eq!(first(AttemptStart::Rest, Search::Scene), Attempt::FromRest);
    assert_eq!(first(AttemptStart::Exact, Search::Scene), Attempt::Exact);
    assert_eq!(first(AttemptStart::Rest, Search::Off), Attempt::FromSoft);
    // The tolerance was eased because the first attempt folded.
    let mut eased = attempts(press, AttemptStart::Eased);
    assert_eq!(eased.now, Attempt::FromSoft);
    let next = eased.after(&folds(3), &|faces| faces.to_vec());
    assert!(matches!(next, Some(Attempt::Eased(_))), "{next:?}");
    // The settings of the attempt are those of the scene: nothing is added to them.
    let mut rest = attempts(Search::Scene, AttemptStart::Rest);
    assert_eq!(rest.after(&folds(3), &|faces| faces.to_vec()), None);
}

#[test]
fn a_good_shape_is_taken_before_a_fair_one() {
    let found = press(&[away(0.26), away(0.255), away(0.199)]);
    assert_eq!(found, [(true, REST), (false, SURFACE), (true, None)]);
    // At the limit, shapes that are alike do not change the choice.
    let found = press(&[away(0.21), away(0.205), away(0.19)]);
    assert_eq!(found, [(true, REST), (false, SURFACE), (false, None)]);
}

#[test]
fn nothing_else_is_tried_while_one_drags_or_where_nothing_may_differ() {
    assert_eq!(follow(Search::Off, &[folds(10)]), [(true, None)]);
    // Exact panels were tried so again, and then within larger tolerances.
    let (search, named) = (Search::Panels(4e-4), ChosenAttempt::default());
    let mut press = Attempts::new(search, named, [false; 4], 1000, [EDGE; 2]);
    assert_eq!(press.after(&folds(3), &|faces| faces.to_vec()), None);
}
