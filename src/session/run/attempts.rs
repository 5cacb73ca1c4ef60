//! Which ways to meet hard constraints are tried where faces fold, one after the other.
//!
//! The first is as asked, from the soft solution. Where that folds faces, smoother displacements from the rest shape
//! on often end in a valley without folds. Where they do not, and the tolerance may be eased, larger ones are tried,
//! the largest first and each from the shape before, down to the last one that folds nothing.

/// What may be done for faces not to fold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Unfolding {
    /// Nothing: the shape follows a drag.
    Off,
    /// Smoother displacements.
    Smoother,
    /// The same, and tolerances larger than this, which is asked, in the unit of the mesh.
    Eased(f64),
}

/// The weight of smoothness is multiplied by this, in turn.
const SMOOTHER: [f64; 2] = [10.0, 30.0];

/// A smoother displacement may take vertices so many times as far.
const FAR: f64 = 2.0;

/// The next smoother one is tried where the last left at most this part of the folds.
const FEWER: f64 = 0.8;

/// Iterations times vertices of the first attempt beyond which smoother ones would take too long.
const MOST_WORK: u64 = 3_000_000;

/// A tolerance is multiplied by this, in turn, and is none beyond this part of the mean edge.
const EASED: [f64; 6] = [100.0, 50.0, 20.0, 10.0, 5.0, 2.0];
const LOOSEST: f64 = 0.15;

/// Iterations of an attempt within a larger tolerance, at most: where one needs more the shape resists.
const EASILY: u32 = 400;

/// One way to meet hard constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Attempt {
    /// The weight of smoothness is multiplied by this.
    pub(crate) smoother: f64,
    /// The tolerance instead of the one that is asked.
    pub(crate) within: Option<f64>,
    /// Iterations of the approach at most; none for those that are usual.
    pub(crate) iterations: Option<u32>,
}

/// What has come of one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome {
    pub(crate) met: bool,
    /// How many faces are folded or dented.
    pub(crate) folded: usize,
    /// The longest way of a vertex from its rest position.
    pub(crate) moved: f64,
    /// Iterations times vertices.
    pub(crate) work: u64,
}

/// The attempts of one meeting.
#[derive(Debug)]
pub(crate) struct Attempts {
    now: Attempt,
    /// Whether that has ended, and is the best so far.
    is_best: bool,
    count: u32,
    first: Option<Outcome>,
    /// Folded faces of the best one.
    folded: usize,
    /// Not tried yet, the next one last.
    smoother: Vec<f64>,
    eased: Vec<f64>,
}

impl Attempts {
    /// As asked first. `can_be_smoother` where displacements are smoothed at all.
    pub(crate) fn new(unfolding: Unfolding, can_be_smoother: bool, mean_edge: f64) -> Attempts {
        let is_on = unfolding != Unfolding::Off && can_be_smoother;
        let eased = match unfolding {
            Unfolding::Eased(asked) => EASED.map(|times| times * asked).to_vec(),
            Unfolding::Off | Unfolding::Smoother => Vec::new(),
        };
        let eased = eased.into_iter().rev().filter(|&within| within <= LOOSEST * mean_edge);
        Attempts {
            now: Attempt { smoother: 1.0, within: None, iterations: None },
            is_best: false,
            count: 1,
            first: None,
            folded: 0,
            smoother: if is_on { SMOOTHER.iter().rev().copied().collect() } else { Vec::new() },
            eased: eased.collect(),
        }
    }

    /// The attempt after the one that has come to this; none where all are made.
    pub(crate) fn after(&mut self, outcome: Outcome) -> Option<Attempt> {
        self.is_best = self.judge(outcome);
        if let Some(smoother) = self.smoother.pop() {
            return Some(Attempt { smoother, within: None, iterations: None });
        }
        let within = Some(self.eased.pop()?);
        Some(Attempt { smoother: 1.0, within, iterations: Some(EASILY) })
    }

    /// Goes on to an attempt; gives the one before, where that is the best so far.
    pub(crate) fn begin(&mut self, next: Attempt) -> Option<Attempt> {
        self.count += 1;
        let before = std::mem::replace(&mut self.now, next);
        std::mem::take(&mut self.is_best).then_some(before)
    }

    /// Whether the attempt at hand has come to this as the best so far.
    fn judge(&mut self, outcome: Outcome) -> bool {
        let Outcome { met, folded, moved, work } = outcome;
        let Some(first) = self.first else {
            self.first = Some(outcome);
            self.folded = folded;
            if folded == 0 || !met {
                self.end();
            } else if work > MOST_WORK {
                self.smoother.clear();
            }
            return true;
        };
        if self.now.within.is_some() {
            let is_whole = met && folded == 0;
            if !is_whole {
                self.eased.clear();
            }
            return is_whole;
        }
        let is_best = met && folded < self.folded && moved <= FAR * first.moved;
        if is_best {
            self.folded = folded;
        }
        if is_best && folded == 0 {
            self.end();
        } else if folded as f64 > FEWER * first.folded as f64 {
            self.smoother.clear();
        }
        is_best
    }

    /// The attempt at hand.
    pub(crate) fn now(&self) -> Attempt {
        self.now
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
        self.first.map_or(0, |first| first.folded)
    }

    fn end(&mut self) {
        self.smoother.clear();
        self.eased.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outcome(folded: usize, moved: f64) -> Outcome {
        Outcome { met: true, folded, moved, work: 1 }
    }

    /// The attempts that follow where they come to `outcomes`, and whether each of those was the best.
    fn follow(
        unfolding: Unfolding,
        is_smooth: bool,
        outcomes: &[Outcome],
    ) -> Vec<(bool, Option<Attempt>)> {
        let mut attempts = Attempts::new(unfolding, is_smooth, 0.4);
        let each = outcomes.iter().map(|outcome| {
            let next = attempts.after(*outcome);
            let is_best = attempts.is_best();
            if let Some(next) = next {
                attempts.begin(next);
            }
            (is_best, next)
        });
        each.collect()
    }

    fn smoother(times: f64) -> Option<Attempt> {
        Some(Attempt { smoother: times, within: None, iterations: None })
    }

    fn within(length: f64) -> Option<Attempt> {
        Some(Attempt { smoother: 1.0, within: Some(length), iterations: Some(EASILY) })
    }

    #[test]
    fn what_folds_nothing_is_tried_once() {
        for first in [outcome(0, 1.0), Outcome { met: false, ..outcome(3, 1.0) }] {
            let all = follow(Unfolding::Eased(1e-3), true, &[first]);
            assert_eq!(all, [(true, None)]);
        }
    }

    #[test]
    fn smoother_ones_come_first_and_may_not_go_far() {
        let outcomes = [outcome(10, 1.0), outcome(4, 1.5), outcome(0, 2.5), outcome(0, 0.1)];
        let all = follow(Unfolding::Eased(1e-3), true, &outcomes);
        let expected = [
            (true, smoother(10.0)),
            (true, smoother(30.0)),
            (false, within(0.05)),
            (true, within(0.02)),
        ];
        assert_eq!(all, expected);
        let all = follow(Unfolding::Smoother, true, &outcomes[..3]);
        assert_eq!(all[2], (false, None));
    }

    #[test]
    fn tolerances_become_smaller_until_one_folds() {
        let outcomes = [outcome(10, 1.0), outcome(0, 1.0), outcome(1, 1.0)];
        let all = follow(Unfolding::Eased(1e-3), false, &outcomes);
        assert_eq!(all, [(true, within(0.05)), (true, within(0.02)), (false, None)]);
    }

    #[test]
    fn while_one_drags_nothing_else_is_tried() {
        assert_eq!(follow(Unfolding::Off, true, &[outcome(10, 1.0)]), [(true, None)]);
    }
}
