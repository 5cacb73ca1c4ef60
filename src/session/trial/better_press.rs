//! Better choices than a press for panels that did not end well. Each is tried on a copy, so that
//! only those that help are offered, with what they would come to.

use crate::mesh::Mesh;
use crate::scene::{ClosenessTo, Scene, panel_adjective, panel_offers};
use crate::session::edit::PanelStart;
use crate::session::run::{BendChange, Flaw, Level};
use crate::session::{EasedPanels, Error, Session, Verdict};
use crate::words::{group_digits, length, limit_like};
use serde::Serialize;

/// Larger tolerances to try, as multiples of the required one, and the largest relative to the mean
/// edge.
const LARGER: [f64; 2] = [10.0, 50.0];
const LARGEST: f64 = 0.15;

/// A choice of the same level is better if the surface moves at most this fraction of the distance, or at
/// most this fraction of the panels has a relaxed tolerance. The former is offered if the panels also stay
/// [`AS_MANY`].
const NEARER: f64 = 0.6;

/// At least this fraction of the panels within the tolerance stays so.
const AS_MANY: f64 = 0.9;

/// A surface that moves at most this fraction of the mean edge is said to stay.
const STAYS: f64 = 1e-3;

/// A press for panels that ends better.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct BetterPress {
    /// What is different: `tolerance`, `smoother`, `surface`, `boundary` or `kind`.
    pub id: &'static str,
    /// The label of its button.
    pub label: String,
    /// What it would come to.
    pub words: String,
    /// The kind of panels to make.
    pub kind: &'static str,
    /// The tolerance of the panels, in the unit of the mesh.
    pub within: f64,
    /// The shape and the settings to start from.
    pub from: PanelStart,
    /// The level of its shape.
    pub level: Level,
    /// The largest distance of its surface from the original, in the unit of the mesh.
    pub surface: f64,
    /// Whether it is the best of those found.
    pub recommended: bool,
}

impl BetterPress {
    /// Whether it ends better than another one: at a better level, or with the same kind of panels at the
    /// same level and much nearer.
    fn ends_better_than(&self, other: &BetterPress) -> bool {
        let is_nearer = self.kind == other.kind && self.surface <= NEARER * other.surface;
        self.level < other.level || (self.level == other.level && is_nearer)
    }
}

/// The verdict in a report, with its words, and with what would end better.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct VerdictReport {
    /// The numbers.
    #[serde(flatten)]
    pub numbers: Verdict,
    /// Number of panels within a larger tolerance only.
    pub eased: usize,
    /// That tolerance, in the unit of the mesh.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub eased_within: Option<f64>,
    /// All of it in words.
    pub words: String,
    /// Better choices, in the order of the trials; empty if the shape is good.
    pub suggestions: Vec<BetterPress>,
}

impl VerdictReport {
    pub(crate) fn new(numbers: Verdict, words: String, suggestions: Vec<BetterPress>) -> Self {
        let eased = numbers.eased;
        VerdictReport {
            numbers,
            eased: eased.map_or(0, |eased| eased.panels),
            eased_within: eased.map(|eased| eased.within),
            words,
            suggestions,
        }
    }
}

/// The trials, run step by step.
pub struct BetterPresses {
    scene: Scene,
    mesh: Mesh,
    /// The verdict to be bettered.
    before: Verdict,
    /// The mean edge at rest, in the unit of the mesh.
    edge: f64,
    /// Presses still to be tried, the next one last; what they come to is not known.
    untried: Vec<BetterPress>,
    current: Option<(BetterPress, Box<Session>)>,
    found: Vec<BetterPress>,
}

impl BetterPresses {
    /// Prepares the trials for a session whose press for panels within `tolerance` has ended; none if
    /// its shape is good, or if no panels were made.
    pub fn new(session: &mut Session, tolerance: f64) -> Option<BetterPresses> {
        let before = session.verdict(tolerance)?;
        if before.level == Level::Good {
            return None;
        }
        let mut untried = presses(session, &before);
        untried.reverse();
        let (scene, mesh) = (session.scene(), session.mesh().clone());
        let edge = session.mean_edge();
        Some(BetterPresses { scene, mesh, before, edge, untried, current: None, found: Vec::new() })
    }

    /// Runs one iteration; returns whether there is more to try.
    ///
    /// # Errors
    /// As [`Session::open`]; not expected, because the scene is open.
    pub fn step(&mut self) -> Result<bool, Error> {
        let Some((press, session)) = &mut self.current else {
            return self.begin_next();
        };
        // What makes positions non-finite does not help.
        let ended = session.step().map_or(true, |step| step.ended);
        if ended {
            session.end_run();
            let verdict = session.verdict(press.within);
            let press = press.clone();
            self.current = None;
            self.found.extend(verdict.and_then(|after| self.offer(press, &after)));
            self.recommend();
        }
        Ok(self.current.is_some() || !self.untried.is_empty())
    }

    /// The presses that end better, as far as they were tried.
    pub fn found(&self) -> &[BetterPress] {
        &self.found
    }

    /// Begins the next trial.
    fn begin_next(&mut self) -> Result<bool, Error> {
        let Some(press) = self.untried.pop() else { return Ok(false) };
        // Where the smaller tolerance is good, a larger one is not needed.
        let is_enough = |found: &BetterPress| found.id == press.id && found.level == Level::Good;
        if self.found.iter().any(is_enough) {
            return Ok(!self.untried.is_empty());
        }
        let mut session = Session::open(self.scene.clone(), self.mesh.clone())?;
        // A press that is refused does not help.
        if session.make_panels(press.kind, press.within, press.from).is_ok() {
            self.current = Some((press, Box::new(session)));
        }
        Ok(true)
    }

    /// Recommends the best that was found.
    fn recommend(&mut self) {
        let found = &self.found;
        let better = |best: usize, k: usize| {
            if found[k].ends_better_than(&found[best]) { k } else { best }
        };
        let best = (1..found.len()).fold(0, better);
        for (k, press) in self.found.iter_mut().enumerate() {
            press.recommended = k == best;
        }
    }

    /// Returns the suggestion of a press that ends like `after`, if that is better.
    fn offer(&self, press: BetterPress, after: &Verdict) -> Option<BetterPress> {
        let before = &self.before;
        let is_nearer = after.surface.max <= NEARER * before.surface.max;
        // What is mended may not be paid for by another flaw.
        let eases = after.eased.is_some() && before.eased.is_none() && before.level == Level::Fair;
        let roughens =
            after.flaws.contains(&Flaw::Rougher) && !before.flaws.contains(&Flaw::Rougher);
        // A design that was lost is not regained as far away, unless it was lost by becoming flat.
        let was_lost = before.level == Level::Poor && before.is_met() && before.folded == 0;
        let stays_lost = was_lost && !is_nearer && !self.stays_curved(after);
        if eases || roughens || stays_lost {
            return None;
        }
        let is_as_many = after.within as f64 >= AS_MANY * before.within as f64;
        let is_nearer_with_as_many = is_nearer && is_as_many;
        let is_better = after.level < before.level
            || (after.level == before.level
                && after.level != Level::Poor
                && (is_nearer_with_as_many || relaxes_fewer(before, after)));
        let (words, level, surface) = (self.words(press.id, after), after.level, after.surface.max);
        let better = BetterPress { words, level, surface, ..press };
        // A larger tolerance is offered beside a smaller one only if it ends better.
        let mut same = self.found.iter().filter(|found| found.id == better.id);
        let is_best = same.all(|found| better.ends_better_than(found));
        (is_better && is_best).then_some(better)
    }

    /// Whether a surface that became flatter is not so `after` another press.
    fn stays_curved(&self, after: &Verdict) -> bool {
        self.before.flaws.contains(&Flaw::Flatter) && !after.flaws.contains(&Flaw::Flatter)
    }

    /// Says what a press comes to.
    fn words(&self, id: &str, after: &Verdict) -> String {
        let units = &self.scene.units;
        let far = length(after.surface.max, units);
        let stays = after.surface.max <= STAYS * self.edge;
        let moves = match id {
            _ if stays => "the surface stays as it is".to_owned(),
            "surface" => format!("panels slide, the surface stays within {far}"),
            // Its distance alone does not say what is gained.
            _ if self.stays_curved(after)
                && after.surface.max > NEARER * self.before.surface.max =>
            {
                format!("the surface stays curved, and moves by {far}")
            }
            _ => format!("the surface moves by {far}"),
        };
        let [within, of] = [after.within, after.of].map(group_digits);
        let all = if after.of == 1 { "the panel".to_owned() } else { format!("all {of} panels") };
        let limit = |within: f64| limit_like(within, units, after.tolerance);
        match after.eased {
            Some(eased) => match after.relaxed_for_most() {
                Some(relaxed) => format!("{all} within {}; {moves}", limit(relaxed)),
                None => {
                    let larger = limit(eased.within);
                    format!("{within} of {of} panels, the others within {larger}; {moves}")
                }
            },
            None if self.before.folded > 0 => format!("all panels without folds; {moves}"),
            None if self.before.within < self.before.of => format!("{all}; {moves}"),
            None => moves,
        }
    }
}

/// Whether clearly fewer panels have a relaxed tolerance after a press than before it, and the surface is
/// no farther away.
fn relaxes_fewer(before: &Verdict, after: &Verdict) -> bool {
    let Some(EasedPanels { panels, within }) = before.eased else { return false };
    let left = after.eased.map_or(0, |eased| eased.panels);
    // A tolerance for all panels that is larger than that of some is no gain, and another flaw is none.
    after.tolerance < within
        && after.eased.is_none_or(|eased| eased.within <= within)
        && after.flaws.iter().all(|flaw| before.flaws.contains(flaw))
        && left as f64 <= NEARER * panels as f64
        && after.surface.max <= before.surface.max
}

/// Returns the presses to try, in order.
fn presses(session: &Session, before: &Verdict) -> Vec<BetterPress> {
    let Verdict { kind, tolerance, .. } = *before;
    let units = session.document().units.clone();
    let (level, surface) = (before.level, before.surface.max);
    let press = |id, label, kind, within, from| {
        let words = String::new();
        BetterPress { id, label, words, kind, within, from, level, surface, recommended: false }
    };
    let mut presses = Vec::new();
    let edge = session.mean_edge();
    for within in LARGER.map(|times| times * tolerance).into_iter().filter(|w| *w <= LARGEST * edge)
    {
        let label = format!("Within {}", limit_like(within, &units, within));
        presses.push(press("tolerance", label, kind, within, PanelStart::Original));
    }
    if before.bend.change == Some(BendChange::Rougher) {
        let label = "Smoother".to_owned();
        presses.push(press("smoother", label, kind, tolerance, PanelStart::Smoother));
    }
    if session.document().closeness.to == ClosenessTo::Rest {
        let label = "Along the surface".to_owned();
        presses.push(press("surface", label, kind, tolerance, PanelStart::Surface));
    }
    let has_boundary = !session.topology().boundary_loops().is_empty();
    if has_boundary && (before.flaws.contains(&Flaw::OffBoundary) || before.level == Level::Poor) {
        let label = "Keep the boundary".to_owned();
        presses.push(press("boundary", label, kind, tolerance, PanelStart::Boundary));
    }
    for offer in panel_offers(session.mesh()) {
        if let Some(adjective) =
            panel_adjective(offer.kind).filter(|_| offer.reason.is_none() && offer.kind != kind)
        {
            let label = format!("Make panels {adjective} instead");
            presses.push(press("kind", label, offer.kind, tolerance, PanelStart::Original));
        }
    }
    presses
}
