//! The sequence of attempts to meet hard constraints if faces fold or the surface becomes rough.
//!
//! The first attempt has the required tolerances and starts at the soft solution, which approximates
//! the shapes themselves. If this is within the tolerances already, an attempt that starts at the
//! rest shape may end nearer to it, with more of the tolerances used. If the first folds a few faces, panels with a tolerance are made exact, which may avoid the folds: the approach then ends
//! earlier, and the polish moves little. Smoother displacements, starting at the rest shape, often
//! end in a valley that has no folds and is not rough, though farther away. If faces still fold, and
//! the tolerance may be eased, it is: see [`Easing`].

use super::easing::{Easing, Tolerances};
use super::outcome::Outcome;
use std::ops::RangeInclusive;

/// The permitted ways to avoid folded faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Unfolding {
    /// None: the shape follows a drag.
    Off,
    /// Smoother displacements.
    Smoother,
    /// The same and, for some panels, tolerances above this required one (unit of the mesh).
    Eased(f64),
}

/// Factors of the smoothness weight, in order.
const SMOOTHER: [f64; 2] = [10.0, 30.0];

/// Maximum displacement of a smoother attempt, relative to the first.
const FAR: f64 = 2.0;

/// The same if the first attempt is rough and this one is not.
const FAR_BUT_FAIR: f64 = 3.0;

/// A smoother attempt is better if this angle is at most this fraction of the best one.
const FAIRER: f64 = 0.8;

/// The next smoother attempt is tried if the last left at most this fraction of the folds.
const FEWER: f64 = 0.8;

/// Exact panels are tried if the first attempt folds at most this fraction of the faces.
const FEW: f64 = 0.01;

/// Iterations times vertices of the first attempt above which smoother ones would take too long.
const MOST_WORK: u64 = 3_000_000;

/// Maximum number of iterations within a larger tolerance: if more, the shape resists.
const MOST_EASED_ITERATIONS: u32 = 600;

/// One way to meet hard constraints.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Attempt {
    /// With the requirements of the scene.
    Asked,
    /// The same, starting at the rest shape.
    FromRest,
    /// With exact panels.
    Exact,
    /// With the requirements of the scene, and the smoothness weight multiplied by this factor.
    Smoother(f64),
    /// With the panels within these tolerances, in few iterations.
    Eased(Tolerances),
}

impl Attempt {
    /// The factor of the smoothness weight.
    pub(crate) fn smoother(&self) -> f64 {
        if let Attempt::Smoother(times) = self { *times } else { 1.0 }
    }

    /// Maximum number of iterations of the approach; none for the default.
    pub(crate) fn iterations(&self) -> Option<u32> {
        matches!(self, Attempt::Eased(_)).then_some(MOST_EASED_ITERATIONS)
    }
}

/// The attempts of one run.
#[derive(Debug)]
pub(crate) struct Attempts {
    now: Attempt,
    /// Whether the current attempt has ended and is the best so far.
    is_best: bool,
    count: u32,
    first: Option<Outcome>,
    /// Number of folded faces of the best attempt.
    folded: usize,
    /// The mean angle between neighbouring faces of the best attempt, in degrees, and the range
    /// that is neither flat nor rough.
    bend: f64,
    fair: RangeInclusive<f64>,
    /// Number of faces of the mesh.
    faces: usize,
    /// Attempts still to be tried before tolerances are eased, the next one last.
    others: Vec<Attempt>,
    easing: Option<Easing>,
}

impl Attempts {
    /// Begins with the requirements of the scene; `can_be_smoother` if displacements are smoothed.
    /// The mesh has this number of faces and this mean edge at rest (unit of the mesh); `fair` are
    /// the mean angles between neighbouring faces at which it is neither flat nor rough (degrees).
    pub(crate) fn new(
        unfolding: Unfolding,
        can_be_smoother: bool,
        faces: usize,
        mean_edge: f64,
        fair: RangeInclusive<f64>,
    ) -> Attempts {
        let is_on = unfolding != Unfolding::Off && can_be_smoother;
        let easing = match unfolding {
            Unfolding::Eased(asked) => Easing::new(asked, mean_edge),
            Unfolding::Off | Unfolding::Smoother => None,
        };
        let smoother =
            SMOOTHER.iter().filter(|_| is_on).rev().map(|&times| Attempt::Smoother(times));
        let mut others: Vec<Attempt> = smoother.collect();
        others.extend(matches!(unfolding, Unfolding::Eased(_)).then_some(Attempt::Exact));
        others.extend((unfolding != Unfolding::Off).then_some(Attempt::FromRest));
        Attempts {
            now: Attempt::Asked,
            is_best: false,
            count: 1,
            first: None,
            folded: 0,
            bend: 0.0,
            fair,
            faces,
            others,
            easing,
        }
    }

    /// Returns the attempt after the current one, which had this `outcome`; none after the last.
    /// `around` adds to faces those that share a vertex with them.
    pub(crate) fn after(
        &mut self,
        outcome: &Outcome,
        around: &dyn Fn(&[u32]) -> Vec<u32>,
    ) -> Option<Attempt> {
        let mut goes_on = true;
        if matches!(self.now, Attempt::Eased(_)) {
            let easing = self.easing.as_mut()?;
            (self.is_best, goes_on) = easing.take(outcome, around);
        } else {
            self.is_best = self.judge(outcome);
            if let Some(other) = self.others.pop() {
                return Some(other);
            }
            if let (Some(easing), Some(first)) = (&mut self.easing, &self.first) {
                easing.expect(around(&first.folded));
            }
        }
        let easing = self.easing.as_ref().filter(|_| goes_on)?;
        Some(Attempt::Eased(easing.tolerances()))
    }

    /// Proceeds to an attempt; returns the previous one if it is the best so far.
    pub(crate) fn begin(&mut self, next: Attempt) -> Option<Attempt> {
        self.count += 1;
        let before = std::mem::replace(&mut self.now, next);
        std::mem::take(&mut self.is_best).then_some(before)
    }

    /// Records the outcome within the required tolerance; returns whether it is the best so far.
    fn judge(&mut self, outcome: &Outcome) -> bool {
        let Outcome { met, moved, energy, bend, .. } = *outcome;
        let (folded, is_rough) = (outcome.folded.len(), self.is_rough(bend));
        let Some(first) = &self.first else {
            self.judge_first(outcome);
            return true;
        };
        if matches!(self.now, Attempt::FromRest) {
            let is_better = met && folded <= self.folded && energy < first.energy;
            if is_better {
                self.judge_first(outcome);
            }
            return is_better;
        }
        let becomes_fair = self.is_rough(first.bend) && self.fair.contains(&bend);
        let far = if becomes_fair { FAR_BUT_FAIR } else { FAR };
        let is_fairer = |than: f64| self.is_rough(than) && bend <= FAIRER * than;
        let is_better = folded < self.folded || (folded == self.folded && is_fairer(self.bend));
        let is_best = met && is_better && moved <= far * first.moved;
        let is_fewer =
            folded < first.folded.len() && folded as f64 <= FEWER * first.folded.len() as f64;
        let helps = is_fewer || is_fairer(first.bend);
        if is_best {
            (self.folded, self.bend) = (folded, bend);
        }
        if is_best && folded == 0 {
            self.easing = None;
            if !is_rough {
                self.end();
            }
        } else if !helps && !matches!(self.now, Attempt::Exact) {
            self.others.clear();
        }
        is_best
    }

    /// Records the outcome of the first attempt, or of one that replaces it, and keeps the attempts
    /// that may help.
    fn judge_first(&mut self, outcome: &Outcome) {
        let folded = outcome.folded.len();
        (self.folded, self.bend) = (folded, outcome.bend);
        // Without work, the tolerances are more than what the soft solution needs.
        let is_within = outcome.met && outcome.work == 0 && self.first.is_none();
        let is_fine = !outcome.met || (folded == 0 && !self.is_rough(outcome.bend));
        let may_help = !is_fine && outcome.work <= MOST_WORK;
        let are_few = folded > 0 && folded as f64 <= FEW * self.faces as f64;
        self.others.retain(|other| match other {
            Attempt::FromRest => is_within,
            Attempt::Exact => may_help && are_few,
            _ => may_help,
        });
        if is_fine || folded == 0 {
            self.easing = None;
        }
        self.first = Some(outcome.clone());
    }

    /// Whether this mean angle between neighbouring faces makes the surface rough.
    fn is_rough(&self, bend: f64) -> bool {
        bend > *self.fair.end()
    }

    pub(crate) fn now(&self) -> &Attempt {
        &self.now
    }

    /// Whether the current attempt has ended and is the best so far.
    pub(crate) fn is_best(&self) -> bool {
        self.is_best
    }

    /// Number of attempts, including the current one.
    pub(crate) fn count(&self) -> u32 {
        self.count
    }

    /// Number of faces folded by the first attempt.
    pub(crate) fn folded_at_first(&self) -> usize {
        self.first.as_ref().map_or(0, |first| first.folded.len())
    }

    fn end(&mut self) {
        self.others.clear();
        self.easing = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outcome(folded: u32, moved: f64) -> Outcome {
        Outcome { met: true, folded: (0..folded).collect(), bend: 4.0, energy: 9.0, moved, work: 1 }
    }

    /// The attempts that follow these `outcomes`, and whether each was the best so far.
    fn follow(
        unfolding: Unfolding,
        is_smooth: bool,
        outcomes: &[Outcome],
    ) -> Vec<(bool, Option<Attempt>)> {
        let mut attempts = Attempts::new(unfolding, is_smooth, 1000, 0.3, 2.0..=6.0);
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

    fn smoother(times: f64) -> Option<Attempt> {
        Some(Attempt::Smoother(times))
    }

    fn within(within: f64) -> Option<Attempt> {
        Some(Attempt::Eased(Tolerances { within, eased: None }))
    }

    #[test]
    fn what_folds_nothing_is_tried_once() {
        for first in [outcome(0, 1.0), Outcome { met: false, ..outcome(3, 1.0) }] {
            let all = follow(Unfolding::Eased(4e-4), true, &[first]);
            assert_eq!(all, [(true, None)]);
        }
    }

    #[test]
    fn a_few_folds_may_go_where_panels_are_exact() {
        let exact = Some(Attempt::Exact);
        let all = follow(Unfolding::Eased(4e-4), true, &[outcome(10, 1.0), outcome(0, 1.1)]);
        assert_eq!(all, [(true, exact.clone()), (true, None)]);
        // If they still fold, smoother ones come next; with many folds they come at once.
        let all = follow(Unfolding::Eased(4e-4), true, &[outcome(10, 1.0), outcome(10, 1.1)]);
        assert_eq!(all, [(true, exact), (false, smoother(10.0))]);
        let all = follow(Unfolding::Eased(4e-4), true, &[outcome(11, 1.0)]);
        assert_eq!(all, [(true, smoother(10.0))]);
    }

    #[test]
    fn smoother_ones_come_first_and_may_not_go_far() {
        let outcomes = [outcome(20, 1.0), outcome(4, 1.5), outcome(0, 2.5), outcome(0, 0.1)];
        let all = follow(Unfolding::Eased(4e-4), true, &outcomes);
        let expected = [
            (true, smoother(10.0)),
            (true, smoother(30.0)),
            (false, within(0.04)),
            (true, within(0.004)),
        ];
        assert_eq!(all, expected);
        let all = follow(Unfolding::Smoother, true, &outcomes[..3]);
        assert_eq!(all[2], (false, None));
    }

    #[test]
    fn what_is_rough_may_become_fair_farther_away() {
        let bent = |bend, moved| Outcome { bend, ..outcome(0, moved) };
        let all = |outcomes: &[Outcome]| follow(Unfolding::Eased(4e-4), true, outcomes);
        // Within a quarter and a degree, nothing else is tried.
        assert_eq!(all(&[bent(5.9, 1.0)]), [(true, None)]);
        let found = all(&[bent(6.1, 1.0), bent(4.8, 2.9)]);
        assert_eq!(found, [(true, smoother(10.0)), (true, None)]);
        // Less rough is better too, but not that far away; and nothing is eased where nothing folds.
        let found = all(&[bent(12.0, 1.0), bent(9.0, 1.9), bent(5.0, 3.1)]);
        assert_eq!(found, [(true, smoother(10.0)), (true, smoother(30.0)), (false, None)]);
        let found = all(&[bent(12.0, 1.0), bent(9.0, 2.1), bent(7.0, 2.1)]);
        assert_eq!(found, [(true, smoother(10.0)), (false, smoother(30.0)), (false, None)]);
        // A surface that has become flat is no fair one.
        assert_eq!(all(&[bent(12.0, 1.0), bent(1.9, 2.1)])[1], (false, smoother(30.0)));
        // If more smoothness hardly helps, even more is not tried.
        assert_eq!(all(&[bent(12.0, 1.0), bent(11.0, 1.0)])[1], (false, None));
    }

    #[test]
    fn where_the_tolerance_is_more_than_needed_the_rest_shape_is_another_start() {
        let soft = Outcome { work: 0, ..outcome(0, 2.0) };
        let near = Outcome { energy: 1.0, ..outcome(0, 0.5) };
        let from_rest = Some(Attempt::FromRest);
        let all = |second: &Outcome| {
            follow(Unfolding::Eased(4e-4), true, &[soft.clone(), second.clone()])
        };
        assert_eq!(all(&near), [(true, from_rest.clone()), (true, None)]);
        // It is taken if it costs less, and folds no more.
        let costly = Outcome { energy: 9.5, ..near.clone() };
        assert_eq!(all(&costly), [(true, from_rest.clone()), (false, None)]);
        let folds = Outcome { folded: vec![0], ..near.clone() };
        assert_eq!(all(&folds), [(true, from_rest.clone()), (false, None)]);
        // Folds of both are avoided afterwards.
        let all = follow(
            Unfolding::Smoother,
            true,
            &[Outcome { folded: vec![0, 1], ..soft.clone() }, folds, outcome(0, 0.6)],
        );
        assert_eq!(all, [(true, from_rest), (true, smoother(10.0)), (true, None)]);
    }

    #[test]
    fn while_one_drags_nothing_else_is_tried() {
        assert_eq!(follow(Unfolding::Off, true, &[outcome(10, 1.0)]), [(true, None)]);
    }
}
