//! Advice: other values of settings with which parts can be cut and joined.

mod folds;
mod joining;

use super::advised::{AdvisedValue, SettingValue};
use super::beam::Frame;
use super::build::Build;
use super::panel::smallest_box_within;
use super::paper::PaperModel;
use super::report::{BuildReport, JOINT_STEP};
use crate::math::{key_of_number, sort_by_number};
use crate::scene::{BuildSettings, Product};
use crate::words;
use serde::Serialize;

/// Usual scales of models, by their denominators.
const SCALES: [f64; 13] =
    [1.0, 2.0, 5.0, 10.0, 20.0, 25.0, 50.0, 100.0, 200.0, 250.0, 500.0, 1000.0, 2000.0];
/// Mean edge in mm on the sheet below which parts are too small for hands and letters.
const SMALL: f64 = 10.0;
/// The mean edge in mm on the sheet that is proposed instead, at least.
const HANDY: f64 = 25.0;

/// A remark with the values of a setting that help.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Advice {
    /// What is wrong, or what helps, as a sentence.
    pub words: String,
    /// Each of them helps.
    pub choices: Vec<AdvisedValue>,
}

impl Build {
    /// The advice for this build.
    pub(super) fn advice(&self, report: &BuildReport) -> Vec<Advice> {
        let all = [
            self.advice_on_scale(report),
            self.advice_on_pieces(report),
            self.advice_on_joint(report),
            self.advice_on_discs(),
            self.advice_on_folds(),
        ];
        all.into_iter().flatten().collect()
    }

    /// The joints that keep panels of this thickness apart outside and inside the surface, if each of
    /// the sides that need one needs a wider one than there is: only joints with which no further panel
    /// is lost.
    fn advice_on_joint(&self, report: &BuildReport) -> Option<Advice> {
        let words = report.joint(self.settings.thickness);
        let needed = || report.least_joint_mm.into_iter().flatten();
        // Panels are laid on one side: a joint that is wide enough there is one that was chosen.
        if words.is_empty() || needed().any(|least| least - report.joint_mm < JOINT_STEP) {
            return None;
        }
        let BuildSettings { scale, joint, .. } = self.settings;
        let made = self.made(scale, joint);
        let mut choices: Vec<AdvisedValue> = Vec::new();
        for least in needed() {
            let joint = (least / JOINT_STEP - 1e-9).ceil() * JOINT_STEP;
            let value = words::rounded(joint / self.mm_of_sheet(), 6);
            let label = format!("Joint {}", self.as_entered(value));
            let is_new = choices.iter().all(|other| other.label != label);
            if is_new && self.made(scale, value) >= made {
                choices.push(AdvisedValue::number(label, "joint", value));
            }
        }
        // The joints outside and inside.
        let joint = |choice: &AdvisedValue| match choice.value {
            Some(SettingValue::Number(joint)) => joint,
            _ => 0.0,
        };
        sort_by_number(&mut choices, |choice| key_of_number(joint(choice)));
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
        let BuildSettings { scale: now, joint, .. } = self.settings;
        let mean_edge = report.card.mean_edge_mm;
        let is_too_large = !report.too_large.is_empty();
        if !is_too_large && (mean_edge / now >= SMALL || report.parts < 2) {
            return None;
        }
        // A disc is as large at every scale.
        if self.layout.too_large.iter().any(|&part| self.disc_of(part).is_some()) {
            return None;
        }
        if is_too_large {
            let fits = *SCALES.iter().find(|&&scale| scale > now && self.fits_at(scale))?;
            if self.made(fits, joint) < self.made(now, joint) {
                return None;
            }
            let words = format!("At a scale of 1:{fits} every part fits on a sheet.");
            return Some(Advice { words, choices: vec![AdvisedValue::scale(fits)] });
        }
        let handy = SCALES.iter().rev().find(|&&scale| mean_edge / scale >= HANDY);
        let handy = *handy.unwrap_or(&SCALES[0]);
        let mut larger = SCALES.into_iter().take_while(|&scale| scale < now);
        let scale = larger.find(|&scale| scale >= handy && self.fits_at(scale))?;
        let words = format!(
            "On the sheet, edges are {} long on average.",
            words::millimetres(mean_edge / now)
        );
        Some(Advice { words, choices: vec![AdvisedValue::scale(scale)] })
    }

    /// The number of panels, or of fins and node discs, of which there are parts at this scale and with
    /// this joint.
    fn made(&self, scale: f64, joint: f64) -> usize {
        let is_now = [scale, joint] == [self.settings.scale, self.settings.joint];
        let settings = &BuildSettings { scale, joint, ..self.settings.clone() };
        match settings.product {
            Product::Panels if is_now => self.cut.iter().flatten().count(),
            Product::Panels => {
                let panels = 0..self.flat.len();
                panels.filter(|&f| self.outline(f, settings).is_ok()).count()
            }
            Product::Fins if is_now => self.frame.as_ref().map_or(0, Frame::made),
            Product::Fins => self.frame_of(settings).map_or(0, |frame| frame.made()),
            Product::Paper if is_now => self.paper.as_ref().map_or(0, PaperModel::made),
            Product::Paper => {
                PaperModel::made_at(&self.surface, &self.flat, self.paper_size(scale))
            }
        }
    }

    /// Whether every part has room on a sheet at this scale, except for discs, which are as large at
    /// every scale, as the kerf is. Pieces of paper are made for the sheet, of facets.
    fn fits_at(&self, scale: f64) -> bool {
        let BuildSettings { product, kerf, scale: now, .. } = self.settings;
        if product == Product::Paper {
            return PaperModel::has_room(&self.surface, &self.flat, self.paper_size(scale));
        }
        let most = self.room();
        let mut parts = self.parts.iter().enumerate().filter(|(k, _)| self.disc_of(*k).is_none());
        parts.all(|(_, part)| {
            let (_, size) = smallest_box_within(&part.outline, most);
            (0..2).all(|k| (size[k] - kerf) * now / scale <= most[k] - kerf)
        })
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::fabricate::Stand;
    use crate::math::cosine_and_sine_of_degrees;
    use crate::math::plane::rotated;
    use crate::mesh::Mesh;
    use crate::scene::Fold;
    use crate::words::{LengthUnit, UNITS};

    /// A ridge of two panels with sides of this length, each of which goes down by this angle.
    pub(in crate::fabricate::advice) fn ridge(side: f64, degrees: f64) -> Mesh {
        let [cosine, sine] = cosine_and_sine_of_degrees(degrees);
        let at = |x: f64, y: f64| [x * side * cosine, y * side, -x.abs() * side * sine];
        let positions = vec![
            at(0.0, 0.0),
            at(0.0, 1.0),
            at(1.0, 0.0),
            at(1.0, 1.0),
            at(-1.0, 0.0),
            at(-1.0, 1.0),
        ];
        let faces = [[0, 2, 3, 1], [4, 0, 1, 5]].into_iter().collect();
        Mesh { positions, faces, ..Mesh::default() }
    }

    /// A floor of 12 by 8 with sides of 0.4, and a quad by itself.
    pub(in crate::fabricate::advice) fn floor() -> Mesh {
        let along = |from: [f64; 2], step: [f64; 2], count: u32| {
            (0..count).map(move |k| [0, 1].map(|axis| from[axis] + f64::from(k) * step[axis]))
        };
        let rim = along([0.0, 0.0], [0.4, 0.0], 30)
            .chain(along([12.0, 0.0], [0.0, 0.4], 20))
            .chain(along([12.0, 8.0], [-0.4, 0.0], 30))
            .chain(along([0.0, 8.0], [0.0, -0.4], 20));
        let quad = [[0.0, -1.0], [0.4, -1.0], [0.4, -0.6], [0.0, -0.6]];
        let positions: Vec<_> = rim.chain(quad).map(|[x, y]| [x, y, 0.0]).collect();
        let mut mesh = Mesh { positions, ..Mesh::default() };
        mesh.faces.push(&(0..100).collect::<Vec<u32>>());
        mesh.faces.push(&[100, 101, 102, 103]);
        mesh
    }

    pub(in crate::fabricate::advice) fn advice(
        mesh: &Mesh,
        settings: &BuildSettings,
    ) -> Vec<Advice> {
        let build = Build::new(mesh, settings, UNITS[0], &Stand::default()).expect("panels");
        let report = build.report();
        build.words(&report).advice
    }

    /// The numbers that are advised.
    fn numbers(given: &[Advice]) -> Vec<f64> {
        let values = given.iter().flat_map(|own| &own.choices).map(|own| own.value);
        let number = |value| match value {
            Some(SettingValue::Number(number)) => Some(number),
            _ => None,
        };
        values.filter_map(number).collect()
    }

    pub(in crate::fabricate::advice) fn follow(
        own: &mut BuildSettings,
        AdvisedValue { setting, value, .. }: &AdvisedValue,
    ) {
        let value = serde_json::to_value(value).expect("it is plain");
        let given = [((*setting).to_owned(), value)].into_iter().collect();
        *own = own.with_all(given).expect("it is valid");
    }

    #[test]
    fn advice_that_is_followed_is_not_given_again() {
        // Far too large, right, and far too small for a sheet at 1:50; and large with short edges.
        let ridges = [50.0, 5.0, 0.1, 0.004].map(|side| ridge(side, 45.0));
        for product in Product::ALL {
            let settings = BuildSettings { product, thickness: 3.0, ..BuildSettings::default() };
            for (k, mesh) in ridges.iter().chain([&floor()]).enumerate() {
                let mut own = settings.clone();
                let mut given = 0;
                let first = |own: &BuildSettings| {
                    advice(mesh, own).into_iter().find(|own| !own.choices.is_empty())
                };
                while let Some(first) = first(&own) {
                    follow(&mut own, &first.choices[0]);
                    given += 1;
                    assert!(given <= 3, "{product:?} {k}: {first:?}");
                }
                let meet = product == Product::Panels && k < ridges.len();
                assert!(given > 0 || !meet, "{k}: panels of 3 mm meet inside");
            }
        }
    }

    #[test]
    fn no_scale_is_advised_at_which_a_face_of_paper_is_larger_than_the_sheet() {
        let at = |scale: f64| {
            let (product, sheet) = (Product::Paper, [420.0, 297.0]);
            let own = BuildSettings { product, sheet, scale, ..BuildSettings::default() };
            numbers(&advice(&floor(), &own))
        };
        assert_eq!([at(25.0), at(50.0), at(200.0)], [vec![50.0], vec![], vec![50.0]]);
    }

    #[test]
    fn no_scale_is_advised_at_which_folds_leave_nothing_of_card() {
        // Beside the floor a ridge of two panels, bent down by 60 degrees each, of which a third goes on.
        let at = |width: f64| {
            let mut mesh = floor();
            let [cosine, sine] = cosine_and_sine_of_degrees(60.0);
            let (across, down) = (width * cosine, width * sine);
            let profile = [
                [-0.5 * width - across, -down],
                [-0.5 * width, 0.0],
                [0.5 * width, 0.0],
                [0.5 * width + across, -down],
            ];
            let first = mesh.positions.len() as u32;
            for [x, z] in profile {
                mesh.positions.extend([[x, -4.0, z], [x, -3.0, z]]);
            }
            for k in [0, 2, 4].map(|k| first + k) {
                mesh.faces.push(&[k, k + 2, k + 3, k + 1]);
            }
            let (product, fold, sheet) = (Product::Paper, Fold::Score, [420.0, 297.0]);
            let own = BuildSettings {
                product,
                fold,
                sheet,
                thickness: 3.0,
                scale: 25.0,
                ..BuildSettings::default()
            };
            numbers(&advice(&mesh, &own))
        };
        // The folds take 1.7 mm from either side: of 2 mm at 1:50, or of 8 mm.
        assert_eq!([at(0.1), at(0.4)], [vec![], vec![50.0]]);
    }

    #[test]
    fn no_joint_is_advised_that_leaves_nothing_of_panels() {
        let own = BuildSettings { thickness: 4.0, ..BuildSettings::default() };
        // 20 mm wide on the sheet; at a fold of 140 degrees the joint would be 22 mm.
        for (side, offers) in [(1.0, 0), (2.0, 1)] {
            let (mesh, stand) = (ridge(side, 70.0), Stand::default());
            let build = Build::new(&mesh, &own, UNITS[0], &stand).expect("panels");
            let words = build.words(&build.report());
            assert_eq!(words.advice.len(), offers, "{words:?}");
            let said = words.advice.first().map_or(&words.joint, |advice| &advice.words);
            assert!(said.contains("joint on the sheet of at least 22.0 mm"), "{said}");
        }
    }

    #[test]
    fn folds_that_are_rounding_errors_ask_for_no_joint() {
        let settings = BuildSettings { thickness: 3.0, ..BuildSettings::default() };
        // The slopes of a roof in triangles, turned, with the six decimals of a file.
        for degrees in [0.0, 30.0, 50.0, 70.0] {
            let turn = cosine_and_sine_of_degrees(degrees);
            let mut roof = ridge(5.0, 30.0);
            roof.faces = [[0, 2, 3], [0, 3, 1], [4, 0, 1], [4, 1, 5]].into_iter().collect();
            for at in &mut roof.positions {
                let [x, y] = rotated([at[0], at[1]], turn);
                *at = [x, y, at[2]].map(|x| (1e6 * x).round() * 1e-6);
            }
            let given = advice(&roof, &settings);
            assert_eq!(given.len(), 1, "{degrees}");
            assert!(given[0].words.contains("need no joint outside the surface"), "{given:?}");
            // 2 T tan 30 degrees.
            assert_eq!(given[0].choices[0].label, "Joint 0.175 m, on the sheet 3.5 mm");
        }
    }

    #[test]
    fn the_joint_of_either_side_is_enough() {
        let unit = UNITS[0];
        let settings = BuildSettings { thickness: 3.0, ..BuildSettings::default() };
        let advised = |own: &BuildSettings| {
            let build =
                Build::new(&ridge(5.0, 45.0), own, unit, &Stand::default()).expect("panels");
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
            let mesh = ridge(scale / unit.metres, 45.0);
            let build = Build::new(&mesh, &settings, unit, &Stand::default()).expect("panels");
            let report = BuildReport { least_joint_mm: [None, Some(2.95)], ..build.report() };
            let choices = build.advice_on_joint(&report).map_or(Vec::new(), |own| own.choices);
            assert_eq!(choices.iter().map(|own| &*own.label).collect::<Vec<_>>(), [label]);
        }
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
            build.advice_on_scale(&build.report()).map(|advice| advice.choices.len())
        };
        assert_eq!([frame(3.0), frame(0.28)], [Some(1), None]);
    }
}
