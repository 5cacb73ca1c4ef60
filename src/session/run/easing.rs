//! A larger tolerance for a part of the panels, if the required one is not met, or faces fold within it.
//!
//! The first attempt has the largest tolerance for all panels. If it folds nothing, the tolerance
//! is reduced in steps to the required one. If a step folds faces, these and the faces around them
//! are eased, and the step is repeated from its result; only the eased faces start as in the last
//! shape without folds. If a step folds nothing but is not met, the faces that folded within the
//! required tolerance are eased. Finally the tolerance of the eased faces is halved as long as
//! nothing folds.

use super::outcome::Outcome;
use crate::scene::{ChosenAttempt, EasedFaces};

/// Factors of the required tolerance, in order, and its maximum relative to the mean edge.
const STEPS: [f64; 3] = [100.0, 10.0, 1.0];
const LARGEST: f64 = 0.15;

/// Tolerance of eased faces, relative to the largest one of all panels: this reduces repeated folds
/// of faces between tight panels.
const EASED: f64 = 2.0;

/// Maximum number of repeated steps in total.
const MOST_AGAIN: u32 = 12;

/// Maximum of iterations times vertices of all attempts within larger tolerances.
const MOST_EASED_WORK: u64 = 16_000_000;

/// Tolerances of an attempt, in the unit of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tolerances {
    /// The settings of the attempt: its smoothness, and whether vertices slide along the surface.
    pub(crate) settings: ChosenAttempt,
    /// Tolerance of the panels that are not eased.
    pub(crate) within: f64,
    /// The eased faces and their tolerance.
    pub(crate) eased: Option<EasedFaces>,
}

/// The attempts within larger tolerances.
#[derive(Debug)]
pub(crate) struct Easing {
    settings: ChosenAttempt,
    /// Tolerances still to be tried, the next one last.
    steps: Vec<f64>,
    now: f64,
    largest: f64,
    /// The tolerance of eased faces, and whether it is already being halved.
    of_eased: f64,
    is_last: bool,
    /// The eased faces, ascending.
    faces: Vec<u32>,
    again: u32,
    work: u64,
    /// The faces that folded within the required tolerance, with those around them.
    resisting: Vec<u32>,
}

impl Easing {
    /// Plans the steps to a required tolerance, with these settings; none if every larger one is too
    /// large.
    pub(crate) fn new(asked: f64, mean_edge: f64, settings: ChosenAttempt) -> Option<Easing> {
        let steps = STEPS.map(|times| times * asked);
        let steps = steps.into_iter().filter(|&within| within <= LARGEST * mean_edge);
        let mut steps: Vec<f64> = steps.collect();
        steps.reverse();
        let largest = steps.pop().filter(|&largest| largest > asked)?;
        Some(Easing {
            settings,
            steps,
            now: largest,
            largest,
            of_eased: EASED * largest,
            is_last: false,
            faces: Vec::new(),
            again: 0,
            work: 0,
            resisting: Vec::new(),
        })
    }

    /// Sets the faces that folded within the required tolerance, with those around them.
    pub(crate) fn expect(&mut self, resisting: Vec<u32>) {
        self.resisting = resisting;
    }

    /// Whether the current tolerance of all panels is larger than required.
    pub(crate) fn eases_all(&self) -> bool {
        !self.steps.is_empty()
    }

    pub(crate) fn tolerances(&self) -> Tolerances {
        let eased = (!self.faces.is_empty())
            .then(|| EasedFaces { within: self.of_eased, faces: self.faces.as_slice().into() });
        Tolerances { settings: self.settings, within: self.now, eased }
    }

    /// Records the outcome of these tolerances. Returns whether they were met without folds, and
    /// whether there are others to try. `around` adds to faces those that share a vertex with them.
    pub(crate) fn take(
        &mut self,
        outcome: &Outcome,
        around: &dyn Fn(&[u32]) -> Vec<u32>,
    ) -> (bool, bool) {
        self.work += outcome.work;
        let is_whole = outcome.is_whole();
        let has_time = self.work < MOST_EASED_WORK;
        if is_whole {
            return (true, has_time && self.go_on());
        }
        let is_first = self.now == self.largest;
        if is_first || self.is_last || self.again == MOST_AGAIN || !has_time {
            return (false, false);
        }
        self.again += 1;
        let known = self.faces.len();
        let folded = &outcome.measure.folded;
        if folded.is_empty() {
            self.ease(&self.resisting.clone());
            return (false, self.faces.len() > known);
        }
        let is_new = |face: &&u32| self.faces.binary_search(face).is_err();
        let new: Vec<u32> = folded.iter().filter(is_new).copied().collect();
        self.ease(&around(&new));
        // If only eased faces fold, ease more faces around them.
        let mut more = folded.clone();
        while self.faces.len() == known {
            let before = more.len();
            more = around(&more);
            if more.len() == before {
                return (false, false);
            }
            self.ease(&more);
        }
        (false, true)
    }

    fn ease(&mut self, faces: &[u32]) {
        self.faces.extend(faces);
        self.faces.sort_unstable();
        self.faces.dedup();
    }

    /// Proceeds to smaller tolerances, if there are any.
    fn go_on(&mut self) -> bool {
        if let Some(next) = self.steps.pop() {
            self.now = next;
            return true;
        }
        self.is_last = true;
        self.of_eased *= 0.5;
        !self.faces.is_empty() && self.of_eased > self.now
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outcome(folded: &[u32]) -> Outcome {
        Outcome::of_test(folded)
    }

    /// Neighbours of faces in a row.
    fn around(faces: &[u32]) -> Vec<u32> {
        let near = |face: &u32| faces.iter().any(|&other| other.abs_diff(*face) <= 1);
        (0..100).filter(near).collect()
    }

    fn easing() -> Easing {
        Easing::new(1e-3, 1.0, ChosenAttempt::default()).expect("there are larger ones")
    }

    fn tolerances(within: f64, faces: &[u32]) -> Tolerances {
        let eased = EasedFaces { within: EASED * 0.1, faces: faces.into() };
        Tolerances {
            settings: ChosenAttempt::default(),
            within,
            eased: (!faces.is_empty()).then_some(eased),
        }
    }

    #[test]
    fn all_panels_come_down_to_what_is_asked_but_those_that_fold() {
        let mut easing = easing();
        assert_eq!(easing.tolerances(), tolerances(0.1, &[]));
        assert_eq!(easing.take(&outcome(&[]), &around), (true, true));
        assert_eq!(easing.tolerances(), tolerances(0.01, &[]));
        assert_eq!(easing.take(&outcome(&[7]), &around), (false, true));
        assert_eq!(easing.tolerances(), tolerances(0.01, &[6, 7, 8]));
        assert_eq!(easing.take(&outcome(&[7, 20]), &around), (false, true));
        assert_eq!(easing.tolerances(), tolerances(0.01, &[6, 7, 8, 19, 20, 21]));
        // All faces around it are eased already.
        assert_eq!(easing.take(&outcome(&[7]), &around), (false, true));
        assert_eq!(easing.tolerances(), tolerances(0.01, &[5, 6, 7, 8, 9, 19, 20, 21]));
        assert_eq!(easing.take(&outcome(&[]), &around), (true, true));
        assert_eq!(easing.tolerances().within, 1e-3);
        // The tolerance of eased faces is also reduced, as long as nothing folds.
        for of_eased in [0.1, 0.05] {
            assert_eq!(easing.take(&outcome(&[]), &around), (true, true));
            let eased = easing.tolerances().eased.expect("some are");
            assert_eq!((eased.within, eased.faces.len()), (of_eased, 8));
        }
        assert_eq!(easing.take(&outcome(&[7]), &around), (false, false));
    }

    #[test]
    fn what_folded_at_first_is_eased_where_a_step_is_not_met() {
        let mut easing = easing();
        easing.expect(vec![40, 41]);
        easing.take(&outcome(&[]), &around);
        let missed = Outcome { met: false, ..outcome(&[]) };
        assert_eq!(easing.take(&missed, &around), (false, true));
        assert_eq!(easing.tolerances(), tolerances(0.01, &[40, 41]));
        assert_eq!(easing.take(&missed, &around), (false, false));
    }

    #[test]
    fn it_ends_where_the_largest_folds_or_nothing_helps() {
        assert_eq!(easing().take(&outcome(&[3]), &around), (false, false));
        let mut easing = easing();
        easing.take(&outcome(&[]), &around);
        let again = (0..100).take_while(|_| easing.take(&outcome(&[3]), &around).1).count();
        assert_eq!(again as u32, MOST_AGAIN);
        assert!(Easing::new(1e-3, 1e-3, ChosenAttempt::default()).is_none());
    }
}
