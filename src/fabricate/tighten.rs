//! Suggestions for numbers of the build check that exceed their limits: constraints for the solver.

use super::advised::{AdvisedValue, SettingValue};
use super::build::{Build, allowed};
use super::check_card::CheckRow;
use super::offset::{Closing, Closings, Reason};
use crate::scene::OffsetKind;
use crate::words;
use serde::Serialize;

/// Tolerance of panels relative to the limits of beams and offsets, which depend on them.
const PART: f64 = 0.1;

/// Part of the largest safe distance that is proposed: rounding to two digits stays below it.
const SAFE_PART: f64 = 0.9;
/// Factor by which the weight of upright axes is increased at a time, up to 1.
const MORE: f64 = 10.0;

/// A constraint on all panels.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct PanelSuggestion {
    /// The constraint, by its name in scenes.
    pub constraint: &'static str,
    /// Its tolerance, in the unit of the mesh.
    pub within: f64,
}

/// The suggestions.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Tighten {
    /// In order of preference: the first that suits the panels of the mesh.
    pub suggestions: Vec<PanelSuggestion>,
    /// Why there is none, or what helps if none of them suits the panels.
    pub otherwise: String,
    /// What `otherwise` advises to set, if it does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub change: Option<AdvisedValue>,
}

impl Build {
    /// Finds suggestions for the numbers of the check that exceed their limits, as far as they remove
    /// the reason why the axes are `inexact`.
    pub(super) fn tighten(
        &self,
        rows: &[CheckRow],
        closings: &Closings,
        inexact: Option<Reason>,
    ) -> Tighten {
        let missed = |id: &str| rows.iter().find(|row| row.id == id && row.met == Some(false));
        let limit = |id: &str| missed(id).and_then(|row| row.limit);
        let of_offset = [limit("beam_warp"), limit("distance_error")].into_iter().flatten();
        let of_offset = of_offset.reduce(f64::min).map(|limit| PART * limit);
        let flatness = limit("panel_flatness");
        let is_turned = |reason| matches!(reason, Some(Reason::PanelTurn(..)));
        let kind = self.settings.kind;
        let reasons: Vec<Reason> = closings.parts.iter().filter_map(Closing::reason).collect();
        let all_turned = !reasons.is_empty() && reasons.iter().all(|&own| is_turned(Some(own)));
        let circles = is_turned(inexact) || (kind.is_none() && all_turned);
        // Panels with their corners on circles are also flat.
        let circle = of_offset.filter(|_| circles);
        let circle = circle.map(|within| flatness.map_or(within, |flatness| flatness.min(within)));
        let plane = of_offset.filter(|_| inexact == Some(Reason::NotFlat));
        let plane = [flatness, plane].into_iter().flatten().reduce(f64::min);
        let suggestion = |constraint, within: Option<f64>| {
            let within = allowed(within?) / self.mm_of_building();
            Some(PanelSuggestion { constraint, within })
        };
        let found = [suggestion("circle", circle), suggestion("plane", plane)];
        let suggestions: Vec<PanelSuggestion> = found.into_iter().flatten().collect();
        let irremovable = inexact.filter(|_| of_offset.is_some() && suggestions.is_empty());
        let mut change = None;
        let otherwise = if let Some(reason) = irremovable {
            let others = kind.is_some_and(|kind| kind != OffsetKind::Corner);
            let has_openings = closings.parts.iter().any(|own| own.has_openings);
            match others && all_turned && !has_openings {
                true => {
                    change = Some(AdvisedValue {
                        label: "Measured at corners".to_owned(),
                        setting: "kind",
                        value: Some(SettingValue::Word("corner")),
                    });
                    "Set “Measured at” to “Corners”: circular panels then make the offset exact."
                }
                false => {
                    let denied = match reason {
                        // Whether a constraint would help is not known.
                        Reason::Distance(_) | Reason::Warp(_) => "The offset is not exact",
                        _ => "No constraint on panels makes the offset exact",
                    };
                    let otherwise = format!("{denied}: {}.", self.in_words(reason));
                    return Tighten { suggestions, otherwise, change };
                }
            }
        } else if missed("safe_distance").is_some() {
            change = self.safe_distance();
            "Bring “Distance” nearer to 0: fewer edges then flip."
        } else if missed("lean").is_some() && inexact.is_some() {
            change = self.more_upright();
            "Increase “Upright axes”: the axes then lean less."
        } else if missed("lean").is_some() {
            "The offset is exact: how its axes lean follows from the shape and “Measured at”."
        } else if rows.iter().any(|row| row.met == Some(false)) {
            "These panels can be made neither circular nor flat."
        } else if rows.iter().any(|row| row.met.is_none()) {
            "Every number that is available is within its limit."
        } else {
            "Every number is within its limit."
        };
        Tighten { suggestions, otherwise: otherwise.to_owned(), change }
    }

    /// A distance at which no edge of the offset flips; none if no distance on this side is known.
    fn safe_distance(&self) -> Option<AdvisedValue> {
        let (_, check) = self.offset.as_ref()?;
        let safe = check.safe_distance[usize::from(self.distance() > 0.0)]?;
        let value: f64 = format!("{:.1e}", SAFE_PART * safe).parse().ok()?;
        let label = format!("Distance {}", words::brief(value));
        Some(AdvisedValue { label, setting: "distance", value: Some(SettingValue::Number(value)) })
    }

    /// More upright axes; none if their weight is the largest already.
    fn more_upright(&self) -> Option<AdvisedValue> {
        let value = (MORE * self.settings.follow).min(1.0);
        (value > self.settings.follow).then(|| AdvisedValue {
            label: "More upright axes".to_owned(),
            setting: "follow",
            value: Some(SettingValue::Number(value)),
        })
    }
}
