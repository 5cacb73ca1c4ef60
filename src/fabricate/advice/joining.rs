//! Advice on what joins parts: plates behind the seams of panels in pieces, and node discs of fins.

use super::Advice;
use crate::fabricate::advised::AdvisedValue;
use crate::fabricate::build::Build;
use crate::fabricate::panel::distinct_corners;
use crate::fabricate::report::BuildReport;
use crate::math::plane::{Point2, rotated};
use crate::scene::{BuildSettings, Product};
use crate::words;

/// Width of splice plates in thicknesses, as of the butt blocks of boats: ten on either side of the seam.
/// And the least one in mm, for hands and letters.
const OF_THICKNESS: f64 = 20.0;
const NARROWEST: f64 = 10.0;

impl Build {
    /// The width of plates with which every panel that is too large can be cut into pieces that fit.
    pub(super) fn advice_on_pieces(&self, report: &BuildReport) -> Option<Advice> {
        let BuildSettings { product, splice, thickness, .. } = self.settings;
        if product != Product::Panels || splice > 0.0 || report.too_large.is_empty() {
            return None;
        }
        let width = (OF_THICKNESS * thickness).max(NARROWEST);
        let mut large = self.layout.too_large.iter().flat_map(|&part| &self.parts[part].panels);
        // Reliefs are cut into its pieces, not into the whole panel.
        let can_be_spliced = |&panel: &u32| {
            let turn = self.cut[panel as usize].as_ref()?.turn;
            let own = self.outline(panel as usize, &self.settings).ok()?;
            let turned = own.rings.iter().map(|ring| {
                let corners = ring.corners.iter().map(|&corner| rotated(corner, turn));
                distinct_corners(&corners.collect::<Vec<_>>())
            });
            let turned: Vec<Vec<Point2>> = turned.collect();
            self.spliced(&turned[0], &turned[1..], width)
        };
        large.all(|panel| can_be_spliced(panel).is_some()).then(|| Advice {
            words: "Panels that are larger than the sheet can be cut into pieces with plates behind their seams."
                .to_owned(),
            choices: vec![AdvisedValue::number(
                format!("Splice plates {}", words::millimetres_limit(width)),
                "splice",
                width,
            )],
        })
    }

    /// Node discs for fins that nothing joins, if there is room for some.
    pub(super) fn advice_on_discs(&self) -> Option<Advice> {
        if self.settings.disc != Some(0.0) || self.fins.len() < 2 {
            return None;
        }
        let frame = self.frame_of(&BuildSettings { disc: None, ..self.settings.clone() })?;
        let all = frame.discs.iter().flatten().count();
        let made = frame.discs.iter().flatten().flatten().count();
        let room = match made {
            0 => return None,
            _ if made == all => String::new(),
            _ => format!(" {made} of {all} nodes have room for one."),
        };
        Some(Advice {
            words: format!(
                "Nothing joins the fins. Node discs of the same material do, into which they are pushed.{room}"
            ),
            choices: vec![AdvisedValue {
                label: "Node discs of the smallest size".to_owned(),
                setting: "disc",
                value: None,
            }],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::Stand;
    use crate::fabricate::advice::tests::follow;
    use crate::mesh::Mesh;
    use crate::words::UNITS;

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
    fn discs_are_advised_for_fins_that_nothing_joins_where_there_is_room() {
        let positions = (0..9).map(|k| [f64::from(k % 3), f64::from(k / 3), 0.0]).collect();
        let faces = [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]].into_iter().collect();
        let mesh = Mesh { positions, faces, ..Mesh::default() };
        let (product, scale, thickness) = (Product::Fins, 10.0, 3.0);
        let own = |distance: f64| {
            let distance = Some(distance);
            let own = BuildSettings { product, scale, thickness, distance, ..Default::default() };
            let build = Build::new(&mesh, &own, UNITS[0], &Stand::default()).expect("panels");
            (build.advice_on_discs(), own)
        };
        let (advice, mut followed) = own(0.3);
        let advice = advice.expect("there is room");
        assert!(advice.words.ends_with("they are pushed."), "{advice:?}");
        follow(&mut followed, &advice.choices[0]);
        let build = Build::new(&mesh, &followed, UNITS[0], &Stand::default()).expect("panels");
        assert_eq!((build.discs.len(), build.advice_on_discs()), (9, None));
        // Fins of 1 mm have no seat.
        assert_eq!(own(0.01).0, None);
    }
}
