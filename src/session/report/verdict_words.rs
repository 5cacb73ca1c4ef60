//! The verdict on the panels in words.

use super::verdict::{Verdict, count_in_words};
use crate::session::run::{Bend, BendChange, Flaw};
use crate::words::{
    MeasureUnit, brief, count, group_digits, length, length_like, limit_like, moved, part,
    rough_degrees, rounded,
};
use serde::Serialize;

/// From this part of the tolerance on, the distance of the worst panel says no more than it.
const SAYS_NO_MORE: f64 = 0.99;

/// From this multiple of the mean edge on, a length is said in edges, not in percent of one.
const MANY_EDGES: f64 = 1.5;

/// The verdict in words.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct VerdictWords {
    /// What became of the panels and of the design.
    pub brief: String,
    /// The worst panel, unless the verdict says it, and how far the mesh moved.
    pub numbers: String,
    /// The label of a button that makes the panels again, within the tolerance of the verdict, if they
    /// were made within another one.
    pub again: Option<String>,
}

impl VerdictWords {
    /// All of it.
    pub fn full(&self) -> String {
        format!("{} {}", self.brief, self.numbers)
    }
}

/// The quantities of the design: the symbol of the unit of the mesh, empty if not known; the size of
/// the mesh, and its mean edge at rest, in that unit.
struct Scale<'a> {
    units: &'a str,
    size: f64,
    edge: f64,
}

impl Verdict {
    /// The verdict in words; `units` is the symbol of the unit of the mesh, empty if not known,
    /// `size` the size of the mesh, and `edge` its mean edge at rest.
    pub fn words(&self, units: &str, size: f64, edge: f64) -> VerdictWords {
        let scale = Scale { units, size, edge };
        let worst = MeasureUnit::Length.or_zero(self.worst, size);
        let worst = length_like(worst, units, self.tolerance);
        let is_told = self.within == self.of && self.worst > SAYS_NO_MORE * self.tolerance;
        let mut reasons = self.flaws.iter().map(|&flaw| (flaw, self.why(flaw, &scale)));
        let (flaw, why) = reasons
            .find(|(_, why)| !why.is_empty())
            .map_or_else(Default::default, |(flaw, why)| (Some(flaw), why));
        let folds = self.folds();
        let [before, after] = match self.within == self.of {
            true => [folds, String::new()],
            false if folds.is_empty() => [String::new(), folds],
            false => [String::new(), format!("But {folds}")],
        };
        // That panels have a larger tolerance is the graver reason, and is said with their number.
        let [first, second] = match self.eased {
            None => [why, String::new()],
            Some(_) => [String::new(), why],
        };
        let sentences = [
            first,
            before,
            self.reached(units),
            second,
            after,
            match self.is_on_other && flaw != Some(Flaw::Away) {
                true => {
                    let far = length(self.surface.max, units);
                    format!("They stay within {far} of the surface that they were laid out on.")
                }
                false => String::new(),
            },
        ];
        let numbers = [
            if is_told { String::new() } else { format!("Worst {worst}.") },
            match moved(self.moved.max, self.moved.mean, units, scale.size) {
                Some(far) => format!("Your mesh moved by {far}."),
                None => "Your mesh did not move.".to_owned(),
            },
        ];
        let again = self.required.filter(|&required| required != self.tolerance);
        let label =
            |_| format!("Solve again within {}", limit_like(self.tolerance, units, self.tolerance));
        VerdictWords { brief: text(&sentences), numbers: text(&numbers), again: again.map(label) }
    }

    /// Says what is not good about the shape; empty if the rest of the verdict says it.
    fn why(&self, flaw: Flaw, scale: &Scale<'_>) -> String {
        let edges = |far: f64| edges(far / scale.edge);
        match flaw {
            Flaw::Eased => String::new(),
            Flaw::SeamOpened => format!(
                "A seam opened by {}: its vertices lie on each other but are not joined. To join them: Open or make, Change the mesh, Edit mesh, Join seams.",
                edges(self.seam)
            ),
            Flaw::Rougher | Flaw::Flatter => self.bend.words(),
            Flaw::Away => {
                let far = length(self.surface.max, scale.units);
                let edges = edges(self.surface.max);
                match self.is_on_other {
                    true => format!(
                        "The panels are up to {far}, {edges}, off the surface that they were laid out on."
                    ),
                    false => format!("The surface moved by up to {far}, {edges}."),
                }
            }
            Flaw::Moved => format!(
                "Panels slid by {} on average; the surface stays within {}.",
                edges(self.moved.mean),
                length(self.surface.max, scale.units)
            ),
            Flaw::OffBoundary => {
                let far = length(self.boundary, scale.units);
                format!("The boundary moved by up to {far}, {}.", edges(self.boundary))
            }
            Flaw::Short => {
                format!(
                    "The shortest edge has {} of its original length.",
                    part(self.shortest_edge)
                )
            }
            Flaw::Shrunk => format!("The surface lost {} of its area.", part(self.area_lost)),
        }
    }

    /// Says how many panels have their shape, with those that are within a larger tolerance only; if
    /// these are most, that is the tolerance of all.
    fn reached(&self, units: &str) -> String {
        if let Some(relaxed) = self.relaxed_for_most() {
            let [relaxed, required] =
                [relaxed, self.tolerance].map(|it| limit_like(it, units, self.tolerance));
            let met = |within: &str| count_in_words(self.adjective, self.of, self.of, within);
            return match self.would_fold {
                true => {
                    format!("{} With a tolerance of {required}, panels would fold.", met(&relaxed))
                }
                false => met(&format!("a relaxed tolerance of {relaxed}")),
            };
        }
        let required = limit_like(self.tolerance, units, self.tolerance);
        let met = count_in_words(self.adjective, self.within, self.of, &required);
        let Some(eased) = self.eased else { return met };
        let larger = limit_like(eased.within, units, self.tolerance);
        let others = match (eased.panels, self.of - self.within - eased.panels) {
            (1, 0) => "the other one".to_owned(),
            (others, 0) => format!("the other {}", group_digits(others)),
            (some, _) => format!("{} more", group_digits(some)),
        };
        let met = met.trim_end_matches('.');
        let reason = if self.would_fold { ", so that none folds" } else { "" };
        format!("{met}, {others} within a relaxed tolerance of {larger}{reason}.")
    }

    fn folds(&self) -> String {
        match self.folded {
            0 => String::new(),
            folded => format!("{} folded or dented.", count(folded, "panel is", "panels are")),
        }
    }
}

/// Returns the sentences that are not empty as one text.
fn text(sentences: &[String]) -> String {
    let told: Vec<&str> =
        sentences.iter().map(String::as_str).filter(|words| !words.is_empty()).collect();
    told.join(" ")
}

/// Says a length relative to the mean edge.
fn edges(far: f64) -> String {
    match far < MANY_EDGES {
        true => format!("{} of an edge", part(far)),
        false => format!("{} edges", brief(rounded(far, 2))),
    }
}

impl Bend {
    /// Describes a change of the surface as a whole; empty if there is none.
    fn words(&self) -> String {
        let change = match self.change {
            Some(BendChange::Rougher) => "rougher",
            Some(BendChange::Flatter) if self.is_flat() => "flat",
            Some(BendChange::Flatter) => "flatter",
            None => return String::new(),
        };
        let [now, rest] = [self.now, self.rest].map(rough_degrees);
        format!(
            "The surface became {change}: neighbouring panels meet at {now} on average instead of {rest}."
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::EasedPanels;
    use crate::session::run::{Level, SurfaceDistance};
    use crate::solve::Moved;

    fn verdict() -> Verdict {
        Verdict {
            kind: "plane",
            adjective: "flat",
            level: Level::Good,
            flaws: Vec::new(),
            within: 800,
            of: 800,
            tolerance: 0.001,
            required: Some(0.001),
            worst: 0.00088,
            worst_face: 3,
            folded: 0,
            eased: None,
            would_fold: false,
            moved: Moved { max: 0.2134, mean: 0.0512 },
            surface: SurfaceDistance { rms: 0.01, max: 0.03 },
            is_on_other: false,
            boundary: 0.0,
            bend: Bend { rest: 3.6, now: 4.0, change: None },
            shortest_edge: 0.8,
            area_lost: 0.0,
            seam: 0.75,
            attempts: Vec::new(),
            chosen: String::new(),
        }
    }

    fn full(verdict: &Verdict) -> String {
        verdict.words("m", 10.0, 0.5).full()
    }

    #[test]
    fn a_verdict_has_the_panels_the_worst_one_and_the_way_of_the_mesh() {
        assert_eq!(
            full(&verdict()),
            "All 800 panels are flat within 1 mm. Worst 0.880 mm. \
             Your mesh moved by at most 0.213 m, 0.0512 m on average."
        );
        let folded = Verdict { folded: 1, ..verdict() };
        let first = "1 panel is folded or dented. All 800 panels are flat within 1 mm. Worst ";
        assert!(full(&folded).starts_with(first), "{}", full(&folded));
        let bad = Verdict { within: 12, worst: 1.787, folded: 1, ..verdict() };
        let words = "12 of 800 panels are flat within 1 mm. But 1 panel is folded or dented. Worst 1787 mm. Your mesh ";
        assert!(full(&bad).starts_with(words), "{}", full(&bad));
    }

    #[test]
    fn what_does_not_move_or_says_no_more_than_the_tolerance_is_said_so_or_not_at_all() {
        // It used to be "Worst 1 mm. Your mesh moved by at most < 0.001 mm, < 0.001 mm on average."
        let moved = Moved { max: 3e-8, mean: 1e-8 };
        let still = Verdict { worst: 0.000_996, moved, ..verdict() };
        assert_eq!(full(&still), "All 800 panels are flat within 1 mm. Your mesh did not move.");
    }

    #[test]
    fn a_rougher_surface_is_compared_with_the_original() {
        let bend = Bend { rest: 3.64, now: 49.2, change: Some(BendChange::Rougher) };
        let rough = full(&Verdict { bend, flaws: vec![Flaw::Rougher], ..verdict() });
        let words = "The surface became rougher: neighbouring panels meet at 49° on average instead of 3.6°. All 800 ";
        assert!(rough.starts_with(words), "{rough}");
    }

    #[test]
    fn a_surface_that_lost_all_its_curvature_is_called_flat() {
        let bend = |now| Bend { rest: 7.6, now, change: Some(BendChange::Flatter) };
        let said =
            |now| full(&Verdict { bend: bend(now), flaws: vec![Flaw::Flatter], ..verdict() });
        assert!(said(3.0).starts_with("The surface became flatter: "), "{}", said(3.0));
        let words = "The surface became flat: neighbouring panels meet at 0.1° on average instead of 7.6°. ";
        assert!(said(0.13).starts_with(words), "{}", said(0.13));
    }

    #[test]
    fn another_tolerance_than_the_required_one_can_be_solved_for() {
        let again = |verdict: Verdict| verdict.words("m", 10.0, 0.5).again;
        assert_eq!(again(verdict()), None);
        let wider = Verdict { tolerance: 0.025, ..verdict() };
        assert_eq!(again(wider).as_deref(), Some("Solve again within 25 mm"));
        assert_eq!(again(Verdict { required: None, ..verdict() }), None);
    }

    #[test]
    fn what_is_not_good_comes_first() {
        let surface = SurfaceDistance { rms: 0.3, max: 0.98 };
        let with =
            |flaw| full(&Verdict { surface, boundary: 0.11, flaws: vec![flaw], ..verdict() });
        for (flaw, words) in [
            (Flaw::Away, "The surface moved by up to 0.980 m, 2 edges. All 800 "),
            (
                Flaw::Moved,
                "Panels slid by 10 % of an edge on average; the surface stays within 0.980 m. ",
            ),
            (Flaw::OffBoundary, "The boundary moved by up to 0.110 m, 22 % of an edge. All "),
            (Flaw::Short, "The shortest edge has 80 % of its original length. All "),
            (Flaw::Eased, "All 800 "),
            (
                Flaw::SeamOpened,
                "A seam opened by 1.5 edges: its vertices lie on each other but are not joined. To join them: Open or make, Change the mesh, Edit mesh, Join seams. All ",
            ),
        ] {
            assert!(with(flaw).starts_with(words), "{}", with(flaw));
        }
    }

    #[test]
    fn panels_with_a_larger_tolerance_are_counted_apart() {
        let eased = |panels, within| {
            let eased = Some(EasedPanels { panels, within: 0.12 });
            full(&Verdict { within, eased, would_fold: true, ..verdict() })
        };
        let some = "798 of 800 panels are flat within 1 mm, the other 2 within a relaxed tolerance of 120 mm, so that none folds. ";
        assert!(eased(2, 798).starts_with(some), "{}", eased(2, 798));
        // The reason was also given where only constraints had not been met, and beside panels that a
        // drag had folded since.
        let relaxed = Some(EasedPanels { panels: 2, within: 0.12 });
        let missed = full(&Verdict { within: 798, eased: relaxed, ..verdict() });
        let unfolded = "798 of 800 panels are flat within 1 mm, the other 2 within a relaxed tolerance of 120 mm. Worst ";
        assert!(missed.starts_with(unfolded), "{missed}");
        let dragged = full(&Verdict { within: 798, eased: relaxed, folded: 3, ..verdict() });
        let folded = "798 of 800 panels are flat within 1 mm, the other 2 within a relaxed tolerance of 120 mm. But 3 panels are folded or dented. ";
        assert!(dragged.starts_with(folded), "{dragged}");
        let one = "799 of 800 panels are flat within 1 mm, the other one within a relaxed tolerance of 120 mm, so that none folds. ";
        assert!(eased(1, 799).starts_with(one), "{}", eased(1, 799));
        let all =
            "All 800 panels are flat within 120 mm. With a tolerance of 1 mm, panels would fold. ";
        assert!(eased(800, 0).starts_with(all), "{}", eased(800, 0));
        assert!(eased(797, 3).starts_with(all), "{}", eased(797, 3));
        // The larger tolerance was said as if it had been asked for.
        let relaxed = Some(EasedPanels { panels: 797, within: 0.12 });
        let dragged = full(&Verdict { within: 3, eased: relaxed, folded: 3, ..verdict() });
        let folded = "All 800 panels are flat within a relaxed tolerance of 120 mm. But 3 panels are folded or dented. ";
        assert!(dragged.starts_with(folded), "{dragged}");
    }
}
