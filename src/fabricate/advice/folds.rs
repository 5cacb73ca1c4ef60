//! Advice on how card is folded, by its thickness.

use super::Advice;
use crate::fabricate::advised::{AdvisedValue, SettingValue};
use crate::fabricate::build::Build;
use crate::fabricate::paper::{Card, FoldKind, PaperModel, PaperSize};
use crate::fabricate::report::JOINT_STEP;
use crate::scene::{BuildSettings, Fold};
use crate::words;

/// The thickest paper in mm: it folds as if it had no thickness.
const PAPER: f64 = 0.3;
/// The thickest card in mm that is creased, as for folding boxes: 0.35 to 0.57 mm in D. Babić, V.
/// Kropar-Vančina, B. Lajić, "Grooving quality research on packaging cardboard". Cut half through, what is
/// left is not to be thicker either.
const CREASED: f64 = 0.6;

impl AdvisedValue {
    fn fold(fold: Fold) -> AdvisedValue {
        let (label, word) = match fold {
            Fold::Crease => ("Crease the folds", "crease"),
            Fold::Score => ("Score the folds", "score"),
            Fold::VCut => ("V-cut the folds", "v-cut"),
            Fold::Separate => ("Separate the panels", "separate"),
        };
        AdvisedValue {
            label: label.to_owned(),
            setting: "fold",
            value: Some(SettingValue::Word(word)),
        }
    }
}

impl Build {
    /// What becomes of creased card that is thicker than paper, and the folds that allow for the thickness.
    pub(super) fn advice_on_folds(&self) -> Option<Advice> {
        let (BuildSettings { fold, thickness, scale, joint, .. }, model) =
            (&self.settings, self.paper.as_ref()?);
        if *fold != Fold::Crease || *thickness <= PAPER {
            return None;
        }
        let scored = |fold: Fold| {
            let card = Card { fold, thickness: *thickness };
            PaperSize { card, tab: 0.0, slots: None, ..self.paper_size(*scale) }
        };
        let ridges = model.net.joints.iter().filter(|joint| joint.kind() == FoldKind::Ridge);
        let steepest = ridges.map(|joint| joint.fold).fold(0.0, f64::max);
        let too_long = 2.0 * scored(Fold::Score).card.back(steepest);
        if too_long < JOINT_STEP {
            return None;
        }
        let (why, ways) = match *thickness {
            thin if thin <= CREASED => (
                "It can be creased, as for folding boxes; if it is scored, panels are shorter by that, and edges \
                 are glued to each other without tabs.",
                &[Fold::Score][..],
            ),
            card if card <= 2.0 * CREASED => (
                "It breaks if it is creased: cut half through, what is left can be folded; a V-cut leaves the \
                 outside whole.",
                &[Fold::Score, Fold::VCut][..],
            ),
            _ => (
                "It breaks if it is creased, and half of it is too thick to be folded: cut a V on the inside, or, \
                 with a laser, which cuts square, cut panels apart.",
                &[Fold::VCut, Fold::Separate][..],
            ),
        };
        let made = self.made(*scale, *joint);
        let is_made =
            |fold: &&Fold| PaperModel::made_at(&self.surface, &self.flat, scored(**fold)) >= made;
        Some(Advice {
            words: format!(
                "Creases do not allow for the thickness: the inside of card of {} is {} too long at the \
                 steepest ridge. {why}",
                words::millimetres_limit(*thickness),
                words::millimetres(too_long),
            ),
            choices: ways.iter().filter(is_made).map(|fold| AdvisedValue::fold(*fold)).collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::advice::tests::{advice, floor, ridge};
    use crate::mesh::Mesh;
    use crate::scene::Product;

    /// The folds that are advised for card of this thickness, and the remark.
    fn folds(mesh: &Mesh, thickness: f64) -> (Vec<SettingValue>, String) {
        let (product, scale) = (Product::Paper, 20.0);
        let own = BuildSettings { product, thickness, scale, ..BuildSettings::default() };
        let given = advice(mesh, &own).into_iter().find(|own| own.words.starts_with("Creases"));
        let given = given.unwrap_or(Advice { words: String::new(), choices: Vec::new() });
        (given.choices.iter().filter_map(|own| own.value).collect(), given.words)
    }

    #[test]
    fn folds_that_allow_for_the_thickness_are_advised_for_card_by_its_thickness() {
        for (thickness, expected) in [
            (0.2, &[][..]),
            (0.5, &["score"][..]),
            (1.0, &["score", "v-cut"][..]),
            (1.5, &["v-cut", "separate"][..]),
            (2.0, &["v-cut", "separate"][..]),
        ] {
            let (found, words) = folds(&ridge(1.0, 30.0), thickness);
            let expected: Vec<_> = expected.iter().map(|word| SettingValue::Word(word)).collect();
            assert_eq!(found, expected, "{thickness}");
            // Both panels have c tan(theta/2) too much.
            let too_long = 2.0 * thickness * libm::tan(30.0_f64.to_radians());
            let told = format!("is {} too long", words::millimetres(too_long));
            assert_eq!(words.contains(&told), !expected.is_empty(), "{words}");
        }
        // Nothing is too long without ridges, and nothing helps where folds leave nothing.
        assert_eq!(folds(&floor(), 2.0), (Vec::new(), String::new()));
        let (found, words) = folds(&ridge(0.02, 60.0), 2.0);
        assert!(found.is_empty() && !words.is_empty(), "{found:?}");
    }
}
