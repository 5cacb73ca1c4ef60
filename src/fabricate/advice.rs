//! Advice: other values of settings with which parts can be cut and joined.

use super::beam::Frame;
use super::build::Build;
use super::cutting::distinct_corners;
use super::panel::{inset, smallest_box_within};
use super::report::BuildReport;
use crate::scene::{BuildSettings, Product};
use crate::words;
use serde::Serialize;
use std::collections::BTreeSet;

/// Usual scales of models, by their denominators.
const SCALES: [f64; 13] =
    [1.0, 2.0, 5.0, 10.0, 20.0, 25.0, 50.0, 100.0, 200.0, 250.0, 500.0, 1000.0, 2000.0];
/// Mean edge in mm on the sheet below which parts are too small for hands and letters.
const SMALL: f64 = 10.0;
/// The mean edge in mm on the sheet that is proposed instead, at least.
const HANDY: f64 = 25.0;
/// Width of splice plates in thicknesses, as of the butt blocks of boats: ten on either side of the seam.
/// And the least one in mm, for hands and letters.
const OF_THICKNESS: f64 = 20.0;
const NARROWEST: f64 = 10.0;
/// Smaller differences of joints, in mm, are less than the accuracy of cutting.
const STEP: f64 = 0.1;

/// A remark with the values of a setting that help.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Advice {
    /// What is wrong, as a sentence.
    pub words: String,
    /// Each of them helps.
    pub choices: Vec<AdvisedValue>,
}

/// A value of a setting.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct AdvisedValue {
    /// The name of a button that sets it.
    pub label: String,
    /// The setting, by its id among those of Build.
    pub setting: &'static str,
    /// The value, in the unit of the setting.
    pub value: f64,
}

impl AdvisedValue {
    fn scale(denominator: f64) -> AdvisedValue {
        let label = format!("Scale 1:{denominator}");
        AdvisedValue { label, setting: "scale", value: denominator }
    }
}

impl Build {
    /// The advice for this build.
    pub(super) fn advice(&self, report: &BuildReport) -> Vec<Advice> {
        let all = [
            self.advice_on_scale(report),
            self.advice_on_pieces(report),
            self.advice_on_joint(report),
        ];
        all.into_iter().flatten().collect()
    }

    /// The width of plates with which every panel that is too large can be cut into pieces that fit.
    fn advice_on_pieces(&self, report: &BuildReport) -> Option<Advice> {
        let BuildSettings { product, splice, thickness, .. } = self.settings;
        if product != Product::Panels || splice > 0.0 || report.too_large.is_empty() {
            return None;
        }
        let width = (OF_THICKNESS * thickness).max(NARROWEST);
        // Those of a type are cut alike.
        let mut tried = BTreeSet::new();
        let panels = self.layout.too_large.iter().flat_map(|&part| &self.parts[part].panels);
        let mut large = panels
            .filter(|&&panel| self.types.of[panel as usize].is_none_or(|kind| tried.insert(kind)));
        // Reliefs are cut into its pieces, not into the whole panel.
        let can_be_spliced = |&panel: &u32| {
            let whole = self.cut[panel as usize].as_ref().map(|cut| &cut.whole);
            let outline = whole.and_then(|whole| inset(whole, self.panel_inset()))?;
            self.spliced(&distinct_corners(&outline), width)
        };
        large.all(|panel| can_be_spliced(panel).is_some()).then(|| Advice {
            words: "Panels that are larger than the sheet can be cut into pieces with plates behind their seams."
                .to_owned(),
            choices: vec![AdvisedValue {
                label: format!("Splice plates {}", words::millimetres_limit(width)),
                setting: "splice",
                value: width,
            }],
        })
    }

    /// The joints that keep panels of this thickness apart outside and inside the surface, if each of
    /// the sides that need one needs a wider one than there is.
    fn advice_on_joint(&self, report: &BuildReport) -> Option<Advice> {
        let words = report.joint(self.settings.thickness);
        let needed = || report.least_joint_mm.into_iter().flatten();
        // Panels are laid on one side: a joint that is wide enough there is one that was chosen.
        if words.is_empty() || needed().any(|least| least - report.joint_mm < STEP) {
            return None;
        }
        let mut choices: Vec<AdvisedValue> = Vec::new();
        for least in needed() {
            let joint = (least / STEP - 1e-9).ceil() * STEP;
            let value = words::rounded(joint / self.mm_of_sheet(), 6);
            let label = format!("Joint {}", self.as_entered(value));
            if choices.iter().all(|other| other.label != label) {
                choices.push(AdvisedValue { label, setting: "joint", value });
            }
        }
        choices.sort_by(|a, b| a.value.total_cmp(&b.value));
        (!choices.is_empty()).then_some(Advice { words, choices })
    }

    /// Formats a length of the building as its field takes it, and as it is on the sheet if that reads
    /// otherwise.
    fn as_entered(&self, length: f64) -> String {
        let entered = format!("{} {}", words::brief(length), self.unit.symbol);
        let on_sheet = words::millimetres_limit(words::rounded(length * self.mm_of_sheet(), 6));
        if entered == on_sheet { entered } else { format!("{entered}, on the sheet {on_sheet}") }
    }

    /// The scale at which parts fit on a sheet, or are large enough for hands.
    fn advice_on_scale(&self, report: &BuildReport) -> Option<Advice> {
        let now = self.settings.scale;
        let mean_edge = report.card.mean_edge_mm;
        if !report.too_large.is_empty() {
            // A disc is as large at every scale.
            let is_disc = |&k: &usize| self.disc_of(k).is_some();
            if self.layout.too_large.iter().any(is_disc) {
                return None;
            }
            let fits = *SCALES.iter().find(|&&scale| scale >= now * self.beyond_the_sheet())?;
            // Plates are as thick at every scale, and cut short fins away in a smaller model.
            let lost = |frame: &Frame| frame.lost();
            if self.frame_at(fits).as_ref().map(lost) > self.frame.as_ref().map(lost) {
                return None;
            }
            let words = format!("At a scale of 1:{fits} every part fits on a sheet.");
            return Some(Advice { words, choices: vec![AdvisedValue::scale(fits)] });
        }
        if mean_edge / now >= SMALL || report.parts < 2 {
            return None;
        }
        let handy = SCALES.iter().rev().find(|&&scale| mean_edge / scale >= HANDY);
        let handy = *handy.unwrap_or(&SCALES[0]);
        // Pieces of paper are made for the sheet.
        let least = match self.settings.product {
            Product::Paper => 0.0,
            Product::Panels | Product::Fins => now * self.beyond_the_sheet(),
        };
        let fits = SCALES.iter().find(|&&scale| scale >= handy.max(least));
        let scale = *fits.filter(|&&scale| scale < now)?;
        let words = format!(
            "On the sheet, edges are {} long on average.",
            words::millimetres(mean_edge / now)
        );
        Some(Advice { words, choices: vec![AdvisedValue::scale(scale)] })
    }

    /// How many times as large as the room on a sheet the largest part is that gets smaller with the
    /// scale. The kerf does not.
    fn beyond_the_sheet(&self) -> f64 {
        let kerf = match self.settings.product {
            Product::Paper => 0.0,
            Product::Panels | Product::Fins => self.settings.kerf,
        };
        let most = self.room();
        let parts = self.parts.iter().enumerate().filter(|(k, _)| self.disc_of(*k).is_none());
        let beyond = parts.map(|(_, part)| {
            let (_, size) = smallest_box_within(&part.outline, most);
            [0, 1].map(|k| (size[k] - kerf) / (most[k] - kerf)).into_iter().fold(0.0, f64::max)
        });
        beyond.fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::Stand;
    use crate::mesh::Mesh;
    use crate::words::{LengthUnit, UNITS};

    /// A ridge of two panels with sides of this length, 90 degrees from each other.
    fn ridge(side: f64) -> Mesh {
        let at = |x: f64, y: f64, z: f64| [x * side, y * side, z * side];
        let positions = vec![
            at(0.0, 0.0, 1.0),
            at(0.0, 1.0, 1.0),
            at(1.0, 0.0, 0.0),
            at(1.0, 1.0, 0.0),
            at(-1.0, 0.0, 0.0),
            at(-1.0, 1.0, 0.0),
        ];
        let faces = [[0, 2, 3, 1], [4, 0, 1, 5]].into_iter().collect();
        Mesh { positions, faces, ..Mesh::default() }
    }

    fn advice(side: f64, settings: &BuildSettings) -> Vec<Advice> {
        let unit = UNITS[0];
        let build = Build::new(&ridge(side), settings, unit, &Stand::default()).expect("panels");
        let report = build.report();
        build.words(&report).advice
    }

    fn follow(own: &mut BuildSettings, AdvisedValue { setting, value, .. }: &AdvisedValue) {
        match *setting {
            "joint" => own.joint = *value,
            _ => own.scale = *value,
        }
    }

    #[test]
    fn advice_that_is_followed_is_not_given_again() {
        let settings = BuildSettings { thickness: 3.0, ..BuildSettings::default() };
        // Far too large, right, and far too small for a sheet at 1:50.
        for side in [50.0, 5.0, 0.1, 0.004] {
            let mut own = settings.clone();
            let mut given = 0;
            while let Some(first) = advice(side, &own).first().cloned() {
                follow(&mut own, first.choices.first().expect("a choice"));
                given += 1;
                assert!(given <= 2, "{side}: {first:?}");
            }
            assert!(given > 0, "{side}: panels of 3 mm meet inside");
        }
    }

    #[test]
    fn the_joint_of_either_side_is_enough() {
        let unit = UNITS[0];
        let settings = BuildSettings { thickness: 3.0, ..BuildSettings::default() };
        let advised = |own: &BuildSettings| {
            let build = Build::new(&ridge(5.0), own, unit, &Stand::default()).expect("panels");
            let report = BuildReport { least_joint_mm: [Some(1.0), Some(2.0)], ..build.report() };
            build.advice_on_joint(&report).map_or(Vec::new(), |advice| advice.choices)
        };
        let choices = advised(&settings);
        assert_eq!(choices.len(), 2);
        for choice in &choices {
            let mut own = settings.clone();
            follow(&mut own, choice);
            assert_eq!(advised(&own), [], "{choice:?}");
        }
    }

    #[test]
    fn the_joint_is_said_as_its_field_takes_it_and_as_it_is_on_the_sheet() {
        for (unit, scale, label) in [
            ("m", 50.0, "Joint 0.15 m, on the sheet 3 mm"),
            ("ft", 1.0, "Joint 0.00984252 ft, on the sheet 3 mm"),
            ("mm", 50.0, "Joint 150 mm, on the sheet 3 mm"),
            ("mm", 1.0, "Joint 3 mm"),
        ] {
            let unit = LengthUnit::of(unit).expect("it is known");
            let settings = BuildSettings { scale, ..BuildSettings::default() };
            let build = Build::new(&ridge(scale / unit.metres), &settings, unit, &Stand::default())
                .expect("panels");
            let report = BuildReport { least_joint_mm: [None, Some(2.95)], ..build.report() };
            let choices = build.advice_on_joint(&report).map_or(Vec::new(), |own| own.choices);
            assert_eq!(choices.iter().map(|own| &*own.label).collect::<Vec<_>>(), [label]);
        }
    }

    #[test]
    fn splices_are_advised_for_a_panel_with_reliefs_if_they_make_pieces_of_it() {
        // The spur of the notch would cross the seam, which is halfway along the panel.
        let positions =
            [[0.0, 0.0], [1.2, 0.0], [1.2, 0.6], [0.6025, 0.6], [0.6025, 0.3], [0.0, 0.3]];
        let positions = positions.map(|[x, y]| [x, y, 0.0]).to_vec();
        let faces = [[0, 1, 2, 3, 4, 5]].into_iter().collect();
        let mesh = Mesh { positions, faces, ..Mesh::default() };
        let unit = UNITS[0];
        let settings = BuildSettings {
            sheet: [700.0, 700.0],
            scale: 1.0,
            tool: 6.0,
            kerf: 6.0,
            thickness: 4.0,
            ..BuildSettings::default()
        };
        let build = Build::new(&mesh, &settings, unit, &Stand::default()).expect("a panel");
        let spliced = build.advice_on_pieces(&build.report()).expect("it can be cut into pieces");
        assert_eq!(spliced.choices.len(), 1);
    }

    #[test]
    fn no_scale_is_advised_at_which_fins_are_cut_away() {
        // A long panel with ends of 0.28 m: fins of 8 mm at 1:20, of nothing at 1:50.
        let frame = |width: f64| {
            let positions = vec![[0.0; 3], [20.0, 0.0, 0.0], [20.0, width, 0.0], [0.0, width, 0.0]];
            let faces = [[0, 1, 2, 3]].into_iter().collect();
            let mesh = Mesh { positions, faces, ..Mesh::default() };
            let unit = UNITS[0];
            let distance = Some(0.2);
            let product = Product::Fins;
            let (scale, thickness) = (20.0, 6.0);
            let own = BuildSettings { distance, product, scale, thickness, ..Default::default() };
            let build = Build::new(&mesh, &own, unit, &Stand::default()).expect("a panel");
            assert_eq!((build.not_cut.len(), build.layout.too_large.len()), (0, 2));
            build.advice(&build.report()).len()
        };
        assert_eq!([frame(3.0), frame(0.28)], [1, 0]);
    }
}
