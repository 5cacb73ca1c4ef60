//! The search for a shape that meets hard constraints: attempts one after another, compared by the
//! measure of their shapes, until one is good.
//!
//! The first attempt has the required tolerances and starts at the soft solution, which approximates
//! the shapes themselves; a soft solution within the tolerances needs no more. The others differ in
//! one thing: panels with a tolerance become exact (the approach then ends earlier, and the polish
//! moves little, which may avoid a few folds), displacements are smoothed more, the start is the rest
//! shape, or vertices are kept on the surface instead of at their places. None is left out because an
//! earlier one collapsed or was not met, but none begins after [`MOST_WORK`]. If all fold faces or are
//! not met, and the tolerance may be eased, it is: see [`Easing`]. If that helps nowhere, it is eased
//! with the settings of the attempt that had the fewest faults.
//!
//! Of two shapes one is taken for better only if it is so by a margin: results within rounding of
//! each other do not change the choice. A scene that names an attempt is solved by that one alone.

#[cfg(test)]
mod tests;

use super::attempt::{Attempt, Search, Tried};
use super::easing::Easing;
use super::outcome::{Flaw, Level, Outcome};
use crate::scene::{AttemptStart, ChosenAttempt};

/// Factors of the smoothness weight, in order.
const SMOOTHER: [f64; 2] = [10.0, 30.0];

/// A shape that meets the requirements without folds is the last resort if it is farther from the
/// design than this multiple of that of the first attempt: one with some larger tolerances is better.
const FAR: f64 = 3.0;

/// A shape is better if its change of the design, or its number of faults, is at most this fraction
/// of those of the other.
const BETTER: f64 = 0.8;

/// Exact panels are tried if the first attempt folds at most this fraction of the faces.
const FEW: f64 = 0.01;

/// Iterations times vertices of all attempts after which none begins: some seconds in a browser, and
/// less where a shape has been found that can be built.
const MOST_WORK: u64 = 10_000_000;
const MOST_WORK_ONCE_WHOLE: u64 = 4_000_000;
/// The same for relaxed tolerances with other settings.
const MOST_WORK_BEFORE_OTHER_SETTINGS: u64 = 15_000_000;

/// The attempts of one run.
#[derive(Debug)]
pub(crate) struct Attempts {
    search: Search,
    /// The attempt that the scene names.
    named: ChosenAttempt,
    now: Attempt,
    /// Whether the current attempt has ended and is the best so far.
    is_best: bool,
    tried: Vec<Tried>,
    first: Option<Outcome>,
    /// The best outcome, and its index in `tried`.
    best: Option<(usize, Outcome)>,
    /// The settings of that attempt.
    best_settings: ChosenAttempt,
    /// Whether less folded, or was smoother, with ten times the smoothness.
    smoothness_helps: bool,
    /// Whether the best shape with the required tolerance can be built.
    is_whole_without_easing: bool,
    /// Number of faces of the mesh, its mean edge at rest, and that to judge the place of a shape by (unit
    /// of the mesh).
    faces: usize,
    mean_edge: f64,
    edge: f64,
    /// Whether attempts may begin at rest.
    can_begin_at_rest: bool,
    /// Attempts still to be tried before tolerances are eased, the next one last.
    others: Vec<Attempt>,
    easing: Option<Easing>,
    /// Whether it has the settings of the best attempt.
    has_other_settings: bool,
    work: u64,
}

impl Attempts {
    /// Begins with the attempt that the scene names, or at the soft solution. Others may begin at rest if
    /// nothing pulls, be smoother if displacements are smoothed, slide if vertices are held at their
    /// places, and ease if panels have the tolerance of the search. The mesh has this number of faces; the
    /// edges are its mean one (in its unit), and that to judge the place of a shape by, or infinite.
    pub(crate) fn new(
        search: Search,
        named: ChosenAttempt,
        [can_begin_at_rest, can_be_smoother, can_slide, can_ease]: [bool; 4],
        faces: usize,
        [mean_edge, edge]: [f64; 2],
    ) -> Attempts {
        let is_on = search != Search::Off;
        let asked = if let Search::Panels(asked) = search { Some(asked) } else { None };
        let eased = asked.filter(|_| can_ease);
        let now = match named.from {
            AttemptStart::Rest if is_on => Attempt::FromRest,
            AttemptStart::Exact if is_on => Attempt::Exact,
            _ => Attempt::FromSoft,
        };
        let mut others = Vec::new();
        // What the scene names was chosen after the others had been tried.
        if is_on && named.is_first() {
            others.extend((asked.is_some() && can_slide).then_some(Attempt::OnSurface));
            others.extend(can_begin_at_rest.then_some(Attempt::FromRest));
            let smoother = SMOOTHER.iter().rev().map(|&times| Attempt::Smoother(times));
            others.extend(smoother.filter(|_| can_be_smoother));
            others.extend(eased.is_some().then_some(Attempt::Exact));
        }
        Attempts {
            search,
            named,
            now,
            is_best: false,
            tried: Vec::new(),
            first: None,
            best: None,
            best_settings: ChosenAttempt::default(),
            smoothness_helps: false,
            is_whole_without_easing: false,
            faces,
            mean_edge,
            edge,
            can_begin_at_rest,
            others,
            easing: eased.and_then(|asked| Easing::new(asked, mean_edge, ChosenAttempt::default())),
            has_other_settings: false,
            work: 0,
        }
    }

    /// Returns the attempt after the current one, which had this `outcome`; none after the last.
    /// `around` adds to faces those that share a vertex with them.
    pub(crate) fn after(
        &mut self,
        outcome: &Outcome,
        around: &dyn Fn(&[u32]) -> Vec<u32>,
    ) -> Option<Attempt> {
        self.work += outcome.work;
        if matches!(self.now, Attempt::Eased(_)) {
            let easing = self.easing.as_mut()?;
            let easing_all = easing.eases_all();
            let (is_whole, goes_on) = easing.take(outcome, around);
            let next = goes_on.then(|| Attempt::Eased(easing.tolerances()));
            // Of two that can be built, that with the required tolerance for most panels.
            let is_design = outcome.keeps_design() && !easing_all;
            self.keep(outcome, is_whole && (is_design || !self.is_whole_without_easing));
            return next.or_else(|| self.ease_with_other_settings(around));
        }
        let is_better = self.is_better(outcome);
        self.keep(outcome, is_better);
        if self.has_other_settings {
            // As a run of the scene that names these settings would go on.
            let easing = self.easing.as_mut().filter(|_| !outcome.is_whole())?;
            easing.expect(around(&outcome.resisting()));
            return Some(Attempt::Eased(easing.tolerances()));
        }
        if let Attempt::Smoother(_) = self.now {
            self.smoothness_helps = self.is_fairer_than_first(outcome);
        }
        let first = self.first.get_or_insert_with(|| outcome.clone());
        let is_flawed = !first.is_whole();
        if let Some(easing) = &mut self.easing {
            easing.expect(around(&first.resisting()));
        }
        // With more tolerance than the soft solution needs, a nearer shape may do.
        if outcome.met && outcome.work == 0 && self.tried.len() == 1 {
            let rest = self.others.iter().position(|other| *other == Attempt::FromRest);
            if let Some(place) = rest {
                return Some(self.others.remove(place));
            }
        }
        while let Some(other) = self.others.pop() {
            if self.may_help(&other) {
                return Some(other);
            }
        }
        let is_whole = self.has_whole();
        let is_fine = !is_flawed || (is_whole && self.best.as_ref()?.1.keeps_design());
        self.is_whole_without_easing = is_whole;
        let easing = self.easing.as_ref().filter(|_| !is_fine)?;
        Some(Attempt::Eased(easing.tolerances()))
    }

    /// Begins to ease tolerances with the settings of the best attempt, where they have been eased in vain
    /// with those of the scene. A run of the scene that names the result makes the same attempts.
    fn ease_with_other_settings(&mut self, around: &dyn Fn(&[u32]) -> Vec<u32>) -> Option<Attempt> {
        let (settings, (_, best)) = (self.best_settings, self.best.as_ref()?);
        let Search::Panels(asked) = self.search else { return None };
        let is_in_vain = !best.is_whole() && !settings.is_first() && !self.has_other_settings;
        let has_time = self.work <= MOST_WORK_BEFORE_OTHER_SETTINGS;
        if !is_in_vain || !has_time || !self.can_begin_at_rest {
            return None;
        }
        let mut easing = Easing::new(asked, self.mean_edge, settings)?;
        self.has_other_settings = true;
        let next = match settings.on_surface {
            // That attempt began at its own soft solution.
            true => {
                easing.expect(around(&best.resisting()));
                Attempt::Eased(easing.tolerances())
            }
            false => Attempt::SmootherFromSoft(settings.smoother),
        };
        self.easing = Some(easing);
        Some(next)
    }

    /// Proceeds to an attempt; returns the previous one if it is the best so far.
    pub(crate) fn begin(&mut self, next: Attempt) -> Option<Attempt> {
        let before = std::mem::replace(&mut self.now, next);
        std::mem::take(&mut self.is_best).then_some(before)
    }

    /// Adds an attempt to the list, where steps within larger tolerances are one; if it is the best so
    /// far, it is kept as that.
    fn keep(&mut self, outcome: &Outcome, is_best: bool) {
        let is_eased = matches!(self.now, Attempt::Eased(_));
        let name = self.named.then(self.now.chosen()).name();
        let is_again = is_eased && self.tried.last().is_some_and(|last| last.name == name);
        let place = self.tried.len() - usize::from(is_again);
        let was_best = self.best.as_ref().is_some_and(|(best, _)| *best == place);
        // Of the steps within larger tolerances, the best counts, or else the last that can be built.
        if is_best || !is_again || (outcome.is_whole() && !was_best) {
            self.tried.truncate(place);
            self.tried.push(Tried {
                name,
                level: outcome.level(is_eased, self.edge),
                misses: outcome.misses,
                folded: outcome.measure.folded.len(),
                moved: outcome.measure.moved.max,
            });
        }
        self.is_best = is_best;
        if is_best {
            self.best = Some((place, outcome.clone()));
            self.best_settings = ChosenAttempt { from: AttemptStart::Soft, ..self.now.chosen() };
        }
    }

    /// Whether a shape is better than the best so far.
    fn is_better(&self, new: &Outcome) -> bool {
        let (Some(first), Some((_, best))) = (&self.first, &self.best) else { return true };
        let change = |of: &Outcome| of.measure.change(self.edge);
        let is_near = |of: &Outcome| self.is_near(of, first);
        match (new.is_whole(), best.is_whole()) {
            (true, false) => true,
            (false, true) => false,
            (false, false) => new.faults() as f64 <= BETTER * best.faults() as f64,
            // With more tolerance than the soft solution needs, the nearer shape is as good.
            (true, true) if first.work == 0 && self.now == Attempt::FromRest => {
                new.energy < best.energy
            }
            (true, true) if is_near(new) != is_near(best) => is_near(new),
            // A rough or flat surface is another design, however near it is.
            (true, true) => match [new, best].map(Outcome::keeps_design) {
                [is_design, other] if is_design != other => is_design,
                _ => match [new, best].map(|of| of.level(false, self.edge)) {
                    // At the limit of a good shape, neither is better.
                    [Level::Good, Level::Fair] if BETTER * change(best) > 1.0 => true,
                    [Level::Fair, Level::Good] => false,
                    [Level::Good | Level::Fair, Level::Poor] => true,
                    [Level::Poor, Level::Good | Level::Fair] => false,
                    _ => change(new) <= BETTER * change(best),
                },
            },
        }
    }

    /// Whether a shape is as near as a good one, or not much farther than that of the first attempt.
    fn is_near(&self, of: &Outcome, first: &Outcome) -> bool {
        let far = f64::max(1.0, FAR * first.measure.distance(self.edge));
        !first.met || of.measure.distance(self.edge) <= far
    }

    /// Whether the best shape can be built, and is near the design.
    fn has_whole(&self) -> bool {
        let best = self.best.as_ref().map(|(_, best)| best);
        best.zip(self.first.as_ref())
            .is_some_and(|(best, first)| best.is_whole() && self.is_near(best, first))
    }

    /// Whether a shape has clearly fewer faults, or is clearly smoother, than that of the first
    /// attempt.
    fn is_fairer_than_first(&self, outcome: &Outcome) -> bool {
        self.first.as_ref().is_some_and(|first| {
            let [now, then] = [outcome, first].map(|of| of.measure.bend.now);
            let [left, faults] = [outcome, first].map(|of| of.faults() as f64);
            (faults > 0.0 && left <= BETTER * faults) || now <= BETTER * then
        })
    }

    /// Whether an attempt may find a better shape than the best so far.
    fn may_help(&self, next: &Attempt) -> bool {
        let (Some(first), Some((_, best))) = (&self.first, &self.best) else { return true };
        let is_whole = self.has_whole();
        let most = if is_whole { MOST_WORK_ONCE_WHOLE } else { MOST_WORK };
        if self.work > most {
            return false;
        }
        let flaws = best.measure.flaws(false, self.edge);
        let is_design = is_whole && best.keeps_design();
        let is_far = || flaws.iter().any(|flaw| matches!(flaw, Flaw::Away | Flaw::Moved));
        match next {
            Attempt::FromRest => {
                let is_flat = flaws.contains(&Flaw::Flatter);
                !is_whole || (self.search != Search::Scene && (is_flat || is_far()))
            }
            Attempt::Exact => {
                let folded = first.measure.folded.len();
                !is_whole && first.met && folded as f64 <= FEW * self.faces as f64
            }
            Attempt::Smoother(times) => {
                let is_next = *times == SMOOTHER[0] || self.smoothness_helps;
                is_next && (!is_whole || flaws.contains(&Flaw::Rougher))
            }
            Attempt::OnSurface => !is_design || is_far(),
            Attempt::FromSoft | Attempt::SmootherFromSoft(_) | Attempt::Eased(_) => true,
        }
    }

    pub(crate) fn now(&self) -> &Attempt {
        &self.now
    }

    pub(crate) fn is_best(&self) -> bool {
        self.is_best
    }

    /// The attempts that have ended, and the index of the best one.
    pub(crate) fn tried(&self) -> (&[Tried], Option<usize>) {
        (&self.tried, self.best.as_ref().map(|(place, _)| *place))
    }

    /// Number of faces folded by the first attempt.
    pub(crate) fn folded_at_first(&self) -> usize {
        self.first.as_ref().map_or(0, |first| first.measure.folded.len())
    }
}
