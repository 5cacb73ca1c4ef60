//! Which ways to meet hard constraints are tried where faces fold, one after the other.
//!
//! The first is as asked, from the soft solution. Where that folds a few faces, panels that are to be within a tolerance
//! may be exact without folds: the approach ends earlier then, and the polish moves little. Smoother displacements from
//! the rest shape on often end in a valley without folds. Where they do not, and the tolerance may be eased, it is: see
//! [`Easing`].

use super::easing::{Easing, Tolerances};
use super::outcome::Outcome;

/// What may be done for faces not to fold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Unfolding {
    /// Nothing: the shape follows a drag.
    Off,
    /// Smoother displacements.
    Smoother,
    /// The same, and for some panels tolerances larger than this, which is asked, in the unit of the mesh.
    Eased(f64),
}

/// The weight of smoothness is multiplied by this, in turn.
const SMOOTHER: [f64; 2] = [10.0, 30.0];

/// A smoother displacement may take vertices so many times as far.
const FAR: f64 = 2.0;

/// The next smoother one is tried where the last left at most this part of the folds.
const FEWER: f64 = 0.8;

/// Exact panels are tried where the first attempt folds at most this part of the faces.
const FEW: f64 = 0.01;

/// Iterations times vertices of the first attempt beyond which smoother ones would take too long.
const MOST_WORK: u64 = 3_000_000;

/// Iterations of an attempt within a larger tolerance, at most: where one needs more the shape resists.
const EASILY: u32 = 600;

/// One way to meet hard constraints.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Attempt {
    /// As asked.
    Asked,
    /// The panels exactly.
    Exact,
    /// As asked, with the weight of smoothness multiplied by this.
    Smoother(f64),
    /// The panels within these tolerances, in a few iterations.
    Eased(Tolerances),
}

impl Attempt {
    /// The weight of smoothness is multiplied by this.
    pub(crate) fn smoother(&self) -> f64 {
        if let Attempt::Smoother(times) = self { *times } else { 1.0 }
    }

    /// Iterations of the approach at most; none for those that are usual.
    pub(crate) fn iterations(&self) -> Option<u32> {
        matches!(self, Attempt::Eased(_)).then_some(EASILY)
    }
}

/// The attempts of one meeting.
#[derive(Debug)]
pub(crate) struct Attempts {
    now: Attempt,
    /// Whether that has ended, and is the best so far.
    is_best: bool,
    count: u32,
    first: Option<Outcome>,
    /// How many faces the best one has folded.
    folded: usize,
    /// How many faces there are.
    faces: usize,
    /// Not tried yet, the next one last, before tolerances are eased.
    others: Vec<Attempt>,
    easing: Option<Easing>,
}

impl Attempts {
    /// As asked first, for a mesh of so many `faces`. `can_be_smoother` where displacements are smoothed at all.
    pub(crate) fn new(
        unfolding: Unfolding,
        can_be_smoother: bool,
        faces: usize,
        mean_edge: f64,
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
        Attempts {
            now: Attempt::Asked,
            is_best: false,
            count: 1,
            first: None,
            folded: 0,
            faces,
            others,
            easing,
        }
    }

    /// The attempt after the one that has come to this; none where all are made. `around` gives faces with those that
    /// share a vertex with them.
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

    /// Goes on to an attempt; gives the one before, where that is the best so far.
    pub(crate) fn begin(&mut self, next: Attempt) -> Option<Attempt> {
        self.count += 1;
        let before = std::mem::replace(&mut self.now, next);
        std::mem::take(&mut self.is_best).then_some(before)
    }

    /// Whether the attempt at hand, within the tolerance that is asked, has come to this as the best so far.
    fn judge(&mut self, outcome: &Outcome) -> bool {
        let (met, folded) = (outcome.met, outcome.folded.len());
        let Some(first) = &self.first else {
            self.first = Some(outcome.clone());
            self.folded = folded;
            if folded == 0 || !met {
                self.end();
            } else if outcome.work > MOST_WORK {
                self.others.clear();
            } else if folded as f64 > FEW * self.faces as f64 {
                self.others.retain(|other| !matches!(other, Attempt::Exact));
            }
            return true;
        };
        let is_best = met && folded < self.folded && outcome.moved <= FAR * first.moved;
        let is_far = !matches!(self.now, Attempt::Exact)
            && folded as f64 > FEWER * first.folded.len() as f64;
        if is_best {
            self.folded = folded;
        }
        if is_best && folded == 0 {
            self.end();
        } else if is_far {
            self.others.clear();
        }
        is_best
    }

    /// The attempt at hand.
    pub(crate) fn now(&self) -> &Attempt {
        &self.now
    }

    /// Whether the attempt at hand has ended and is the best.
    pub(crate) fn is_best(&self) -> bool {
        self.is_best
    }

    /// How many there were, the one at hand with them.
    pub(crate) fn count(&self) -> u32 {
        self.count
    }

    /// How many faces the first one has folded.
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
        Outcome { met: true, folded: (0..folded).collect(), moved, work: 1 }
    }

    /// The attempts that follow where they come to `outcomes`, and whether each of those was the best.
    fn follow(
        unfolding: Unfolding,
        is_smooth: bool,
        outcomes: &[Outcome],
    ) -> Vec<(bool, Option<Attempt>)> {
        let mut attempts = Attempts::new(unfolding, is_smooth, 1000, 0.3);
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
        // Where they fold as well, smoother ones come next; where many fold, at once.
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
    fn while_one_drags_nothing_else_is_tried() {
        assert_eq!(follow(Unfolding::Off, true, &[outcome(10, 1.0)]), [(true, None)]);
    }
}
