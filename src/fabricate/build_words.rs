//! The report in words: the sentences of the page's card and panel, of the report as a document,
//! and of the command line.

use super::advice::Advice;
use super::build::Build;
use super::card::{BuildCard, OffsetReport};
use super::check_card::CheckRow;
use super::file::Drawing;
use super::offset::Choice;
use super::paper::LEAST_TAB;
use super::report::{BuildReport, FrameReport, JOINT_STEP};
use super::tighten::PanelSuggestion;
use crate::scene::{BuildSettings, Fold, Join, OffsetKind, Product, panel_adjective};
use crate::words;
use serde::Serialize;

/// The most names in a sentence; the report has them all.
const NAMED: usize = 6;
/// The digits of the error of a kind of offset, which is compared with those of other kinds.
const ERROR_DIGITS: usize = 2;

/// A number of the build check in words.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CheckWords {
    /// Its value.
    pub value: String,
    /// Its limit; empty if it is not known either.
    pub limit: String,
    /// Whether it is within the limit, and how many elements are not.
    pub state: String,
    /// What it measures, as a sentence.
    pub meaning: &'static str,
    /// What helps, as a sentence, if it is not within the limit; else empty.
    pub remedy: &'static str,
}

/// The card in words.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct CardWords {
    /// The numbers of the check, in their order.
    pub check: Vec<CheckWords>,
    /// What keeps the distance, and why not exactly; empty if there is no offset.
    pub offset: String,
    /// The distance of the offset; empty if there is none.
    pub distance: String,
    /// The distances at which no edge flips; empty if there is no offset.
    pub safe: String,
    /// What each suggestion does, in their order.
    pub suggestions: Vec<String>,
}

/// The report in words.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BuildWords {
    /// One line about the parts on the sheets.
    pub sheets: String,
    /// A sentence for each kind of parts that are missing or hard to read.
    pub warnings: Vec<String>,
    /// The least joint for panels of this thickness; empty for other products, for no thickness, and
    /// if it is said by an advice.
    pub joint: String,
    /// What to set otherwise.
    pub advice: Vec<Advice>,
    /// The card.
    pub card: CardWords,
}

impl CheckRow {
    /// The row in words.
    pub fn words(&self) -> CheckWords {
        let state = match self.met {
            Some(true) => "satisfied".to_owned(),
            Some(false) if self.failed > 0 => {
                format!("not satisfied by {}", words::group_digits(self.failed))
            }
            Some(false) => "not satisfied".to_owned(),
            None => String::new(),
        };
        let [meaning, remedy] = match self.id {
            "beam_warp" => [
                "How far the four corners of a beam are from one plane: a warped beam cannot be cut from a board.",
                "Press “Meet the limits” if it is enabled, or choose something else under “Measured at”.",
            ],
            "distance_error" => [
                "How much the distance between the shape and its offset differs from place to place.",
                "Press “Meet the limits” if it is enabled, or choose something else under “Measured at”.",
            ],
            "lean" => [
                "How far the axis of a node leans from the normal of the surface.",
                "Choose something else under “Measured at”, or increase “Upright axes” where that is shown.",
            ],
            "safe_distance" => [
                "The distance of the offset: beyond its limit edges flip.",
                "Bring “Distance” nearer to 0.",
            ],
            _ => [
                "How far the corners of a panel are from one plane: others cannot be cut from flat sheet.",
                "Press “Meet the limits” if it is enabled, or divide the panels into triangles, which are flat.",
            ],
        };
        let remedy = if self.met == Some(false) { remedy } else { "" };
        let limit = |limit| match self.unit {
            "deg" => format!("≤ {}°", words::brief(limit)),
            _ => format!("≤ {}", words::millimetres_limit(limit)),
        };
        CheckWords {
            value: self
                .value
                .map_or("not available".to_owned(), |value| self.value_in_words(value)),
            // The limit of the distance is measured; the others are settings.
            limit: match self.limit {
                // Inwards both are negative.
                Some(measured) if self.id == "safe_distance" => {
                    let sign = if measured < 0.0 { "≥" } else { "≤" };
                    format!("{sign} {}", self.value_in_words(measured))
                }
                Some(other) => limit(other),
                None if self.value.is_some() => "no limit".to_owned(),
                None => String::new(),
            },
            state,
            meaning,
            remedy,
        }
    }

    /// Formats a value of this row with its unit.
    pub(super) fn value_in_words(&self, value: f64) -> String {
        if self.unit == "deg" { words::degrees(value) } else { words::millimetres(value) }
    }
}

impl OffsetReport {
    /// Says what keeps the distance, and why not exactly.
    pub fn words(&self) -> String {
        let kept = match self.kind {
            OffsetKind::Corner => "Corners keep",
            OffsetKind::Face => "Panels keep",
            OffsetKind::Edge => "Beams keep",
        };
        let how = if self.exact { "exactly" } else { "as nearly as possible" };
        let why = if self.exact { String::new() } else { format!("; {}", self.why_not) };
        format!("{kept} their distance {how}{why}.")
    }

    fn safe(&self) -> String {
        let side = |limit: Option<f64>, way: &str| match limit {
            Some(limit) => format!("up to {} {way}", words::millimetres(limit.abs())),
            None => format!("at any distance {way}"),
        };
        let [inwards, outwards] = self.safe_distance_mm;
        format!("Safe {}, {}.", side(inwards, "inwards"), side(outwards, "outwards"))
    }
}

impl Choice {
    /// The error of this kind of offset: "exact", or "± 1.2 mm".
    pub fn words(&self) -> String {
        if self.exact {
            return "exact".to_owned();
        }
        let error = self.warp_mm.max(self.distance_error_mm);
        format!("± {}", words::millimetres_limit(words::rounded(error, ERROR_DIGITS)))
    }
}

impl BuildReport {
    fn sheets_in_words(&self) -> String {
        let all = self.parts_in_words(false);
        let all = match self.placed == self.parts {
            true => all,
            false => format!("{} of {all}", words::group_digits(self.placed)),
        };
        let types = |number: usize, of: &str| words::count(number, "type", "types") + of;
        let mut line = vec![
            format!("{all} on {}", words::count(self.sheets, "sheet", "sheets")),
            format!("{} covered", words::part(self.used)),
        ];
        if self.product == Product::Panels {
            line.push(types(self.types, " of panels"));
            if self.openings > 0 {
                line.push(words::count(self.openings, "hole in a panel", "holes in panels"));
            }
            if self.strips > 0 {
                line.push(count(self.strips, "cover strip"));
            }
            if self.spliced > 0 {
                line.push(words::count(self.spliced, "panel in pieces", "panels in pieces"));
            }
        }
        line.extend(self.frame.as_ref().map(|frame| {
            let within = words::brief(frame.alike_deg);
            types(frame.node_types, &format!(" of nodes within {within}°"))
        }));
        let [tongues, tabs] =
            self.paper.as_ref().map_or([0; 2], |paper| [paper.tongues, paper.tabs]);
        let joins = [(tongues, "tongue"), (tabs, "tab")].into_iter();
        line.extend(joins.filter(|(number, _)| *number > 0).map(|(n, noun)| count(n, noun)));
        line.join(", ")
    }

    /// Formats the number of parts, or of those on sheets; fins and node discs by themselves.
    pub(super) fn parts_in_words(&self, on_sheets: bool) -> String {
        let of_frame = |frame: &FrameReport| [frame.discs, frame.placed_discs];
        let discs = self.frame.as_ref().map_or([0; 2], of_frame);
        let (all, discs) = match on_sheets {
            true => (self.placed, discs[1]),
            false => (self.parts, discs[0]),
        };
        match discs {
            0 if self.spliced + self.halved > 0 => count(all, "part"),
            0 => parts(all, self.product),
            _ => format!("{} and {}", parts(all - discs, self.product), count(discs, "node disc")),
        }
    }

    /// The smallest part, with its size on the sheet; empty without parts.
    pub(super) fn smallest_in_words(&self) -> String {
        self.smallest_part_mm.map_or_else(String::new, |[length, width]| {
            let [length, width] = [length, width].map(words::millimetres);
            format!("{}, {width} wide and {length} long", self.smallest_part)
        })
    }

    fn warnings(&self, settings: &BuildSettings) -> Vec<String> {
        let bare = self.paper.as_ref().map_or(&[][..], |paper| &paper.without_tab);
        // With tabs, they are among those without one.
        let unpaired = self.paper.as_ref().filter(|_| bare.is_empty());
        let unpaired = unpaired.map_or(&[][..], |paper| &paper.unpaired);
        let too_thick = self.paper.as_ref().map_or(&[][..], |paper| &paper.too_thick);
        let gaps = self.paper.as_ref().map_or(&[][..], |paper| &paper.gaps);
        let creased = self.paper.as_ref().map_or(0, |paper| paper.creased);
        let some = |names: &[String]| words::and_more(names, NAMED);
        let named = |names: &[String], sentence: String| (!names.is_empty()).then_some(sentence);
        let counted = |number: usize, sentence: String| (number > 0).then_some(sentence);
        let has_discs = self.frame.as_ref().is_some_and(|frame| frame.discs > 0);
        let unnamed = match has_discs || self.spliced + self.halved > 0 {
            true => count(self.unnamed.len(), "part"),
            false => parts(self.unnamed.len(), self.product),
        };
        let has = if self.unnamed.len() == 1 { "has" } else { "have" };
        let (large, uncut) = (some(&self.too_large), some(&self.not_cut));
        let larger = self.larger_sheet_mm.map_or_else(String::new, |[width, height]| {
            format!(" A sheet of {width} x {height} mm has room for each of them.")
        });
        let has_low_tabs =
            settings.fold == Fold::Crease && settings.tab > 0.0 && settings.tab < LEAST_TAB;
        let glued = match settings.join {
            Join::Slots => self.paper.as_ref().map_or(0, |paper| paper.tabs),
            Join::Tabs => 0,
        };
        let left = self.left_out;
        let without_prism = self.frame.as_ref().map_or(0, |frame| frame.without_prism);
        [
            named(
                &self.too_large,
                format!(
                    "Larger than the sheet within its margins: {large}. They are left out, not scaled.{larger}"
                ),
            ),
            named(&self.not_cut, format!("Not cut: {uncut}.")),
            named(
                &self.narrow,
                format!(
                    "Narrower than {} on the sheet: {}. The smallest part is {}.",
                    words::millimetres_limit(settings.limits.part),
                    some(&self.narrow),
                    self.smallest_in_words()
                ),
            ),
            counted(
                left.dropped_names,
                format!("No room for {} of neighbours.", count(left.dropped_names, "name")),
            ),
            named(
                &self.unnamed,
                format!("{unnamed} {has} no room for a name: {}.", some(&self.unnamed)),
            ),
            counted(
                left.small_names,
                words::count(left.small_names, "part has", "parts have")
                    + " no room for letters of 2 mm; the tables say where each name is.",
            ),
            counted(
                left.dropped_holes,
                match settings.hole > settings.kerf {
                    true => format!("No room for {}.", count(left.dropped_holes, "hole")),
                    false => {
                        let holes = words::count(left.dropped_holes, "hole is", "holes are");
                        format!("{holes} left out: no wider than the kerf.")
                    }
                },
            ),
            counted(
                left.unpaired_holes,
                words::count(left.unpaired_holes, "hole is", "holes are")
                    + " left out where panels do not meet one to one.",
            ),
            counted(
                left.dropped_reliefs,
                words::count(left.dropped_reliefs, "inner corner has", "inner corners have")
                    + " no room for a relief: the tool leaves material there.",
            ),
            counted(
                self.halved,
                format!(
                    "{} cut as two triangles: each would be bent to a radius below {} on the sheet, {} times the thickness.",
                    words::count(self.halved, "panel is", "panels are"),
                    words::millimetres_limit(settings.bend * settings.thickness),
                    words::brief(settings.bend)
                ),
            ),
            counted(
                self.dropped_strips,
                words::count(self.dropped_strips, "joint has", "joints have")
                    + " no cover strip: those at its ends leave no room.",
            ),
            (self.strips > 0 && settings.strip <= self.joint_mm).then(|| {
                format!(
                    "Cover strips of {} do not cover a joint of {}.",
                    words::millimetres_limit(settings.strip),
                    words::millimetres_limit(self.joint_mm)
                )
            }),
            counted(
                without_prism,
                words::count(without_prism, "beam has", "beams have")
                    + " no solid: the cuts at both ends leave nothing.",
            ),
            (self.paper.is_some() && has_low_tabs)
                .then(|| format!("Tabs lower than {LEAST_TAB} mm are not made.")),
            counted(
                glued,
                format!(
                    "No room for {}: tabs for glue instead.",
                    words::count(glued, "tongue and its slot", "tongues and their slots")
                ),
            ),
            named(bare, format!("No tab between {}.", some(bare))),
            named(unpaired, format!("Not joined along their edges: {}.", some(unpaired))),
            named(
                too_thick,
                format!(
                    "Card of {} is too thick: its folds leave nothing of the inside of {}.",
                    words::millimetres_limit(settings.thickness),
                    some(too_thick)
                ),
            ),
            named(
                gaps,
                format!(
                    "Cut back further than the fold asks, in line with a steeper one: {}.",
                    some(gaps)
                ),
            ),
            counted(
                creased,
                format!(
                    "{} not flat and {} along a diagonal.",
                    words::count(creased, "panel is", "panels are"),
                    if settings.fold == Fold::Separate { "cut apart" } else { "creased" }
                ),
            ),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// The least joint for panels of this thickness, as a sentence; empty without thickness.
    pub(super) fn joint(&self, thickness: f64) -> String {
        if self.product != Product::Panels || thickness == 0.0 {
            return String::new();
        }
        const KNOWN: &str = "a joint on the sheet of ";
        let panels = format!("Panels of {}", words::millimetres_limit(thickness));
        let of_side = |k: usize| match (self.no_least_joint[k], self.least_joint_mm[k]) {
            ("", Some(least)) => {
                format!("{KNOWN}at least {}", words::millimetres(least))
            }
            ("", None) => "no joint".to_owned(),
            (why, _) => format!("a joint that is not known ({why})"),
        };
        let needed = match [of_side(0), of_side(1)] {
            [outside, inside] if outside == inside => format!("{panels} need {outside}."),
            [outside, inside] => {
                // What is the same for both is said once.
                let of_both = inside.strip_prefix(KNOWN).filter(|_| outside.starts_with(KNOWN));
                let inside = of_both.unwrap_or(&inside);
                format!("{panels} need {outside} outside the surface, and {inside} inside.")
            }
        };
        needed + &self.steepest() + &self.served()
    }

    /// Between which panels the least joint of each side is needed, as a sentence after another one; empty
    /// if none is needed.
    fn steepest(&self) -> String {
        let of_side = |(side, k): (&str, usize)| {
            self.least_joint_mm[k].map(|_| format!("{side} between {}", self.least_joint_at[k]))
        };
        let sides: Vec<String> =
            [("outside", 0), ("inside", 1)].into_iter().filter_map(of_side).collect();
        match sides.is_empty() {
            true => String::new(),
            false => format!(" It is needed {}.", sides.join(", ")),
        }
    }

    /// On which side the joint that is set is enough, as a sentence after another one; empty if there is
    /// none, none is needed, or it is enough on neither side.
    fn served(&self) -> String {
        let is_enough = |k: usize| {
            self.no_least_joint[k].is_empty()
                && self.least_joint_mm[k].is_none_or(|least| least - self.joint_mm < JOINT_STEP)
        };
        let sides = match [is_enough(0), is_enough(1)] {
            _ if self.joint_mm < JOINT_STEP || self.least_joint_mm == [None, None] => {
                return String::new();
            }
            [true, true] => "on both sides",
            [true, false] => "outside only",
            [false, true] => "inside only",
            [false, false] => return String::new(),
        };
        format!(" The joint of {} is enough {sides}.", words::millimetres(self.joint_mm))
    }
}

impl Build {
    /// The report of this build in words.
    pub fn words(&self, report: &BuildReport) -> BuildWords {
        let advice = self.advice(report);
        let joint = report.joint(self.settings.thickness);
        let is_advised = advice.iter().any(|advice| advice.words == joint);
        let mut warnings = report.warnings(&self.settings);
        warnings.extend(self.legend_left_out());
        BuildWords {
            sheets: report.sheets_in_words(),
            warnings,
            joint: if is_advised { String::new() } else { joint },
            advice,
            card: self.card_words(&report.card),
        }
    }

    /// Says that the margin of the sheets has no room for their legend, if it has none.
    fn legend_left_out(&self) -> Option<String> {
        let BuildSettings { sheet: [width, _], margin, outlines_only, .. } = self.settings;
        let legend = self.legend();
        let has_room = Drawing::height_in_margin(&legend, width, margin).is_some();
        let is_asked = !outlines_only && !legend.is_empty() && !self.layout.sheets.is_empty();
        (is_asked && !has_room).then(|| {
            "The margin of the sheets has no room for their legend; it is in summary.csv."
                .to_owned()
        })
    }

    /// The card of this build in words.
    pub fn card_words(&self, card: &BuildCard) -> CardWords {
        let BuildCard { check, offset, tighten, .. } = card;
        let suggestion = |found: &PanelSuggestion| {
            let adjective = panel_adjective(found.constraint).unwrap_or_default();
            let within = words::millimetres_limit(self.mm_of_building() * found.within);
            format!("Makes all panels {adjective} within {within}")
        };
        let of_offset =
            |words: fn(&OffsetReport) -> String| offset.as_ref().map(words).unwrap_or_default();
        CardWords {
            check: check.iter().map(CheckRow::words).collect(),
            offset: of_offset(OffsetReport::words),
            distance: of_offset(|offset| words::millimetres(offset.distance_mm)),
            safe: of_offset(OffsetReport::safe),
            suggestions: tighten.suggestions.iter().map(suggestion).collect(),
        }
    }
}

/// Formats a number of parts of a product.
fn parts(number: usize, product: Product) -> String {
    count(
        number,
        match product {
            Product::Panels => "panel",
            Product::Fins => "fin",
            Product::Paper => "piece",
        },
    )
}

/// Formats a count of a noun whose plural ends with s.
fn count(number: usize, noun: &str) -> String {
    words::count(number, noun, &format!("{noun}s"))
}
