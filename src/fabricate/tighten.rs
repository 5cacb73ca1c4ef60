//! Suggestions for numbers of the build check that exceed their limits: constraints for the solver.

use super::build::{Build, allowed};
use super::check_card::CheckRow;
use crate::scene::OffsetKind;
use serde::Serialize;

/// Tolerance of panels relative to the limits of beams and offsets, which depend on them.
const PART: f64 = 0.1;

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
    pub otherwise: &'static str,
}

impl Build {
    /// Finds suggestions for the numbers of the check that exceed their limits.
    pub(super) fn tighten(&self, rows: &[CheckRow]) -> Tighten {
        let missed = |id: &str| rows.iter().find(|row| row.id == id && row.met == Some(false));
        let limit = |id: &str| missed(id).and_then(|row| row.limit);
        let flatness = limit("panel_flatness");
        let of_offset = [limit("beam_warp"), limit("distance_error")].into_iter().flatten();
        let of_offset = of_offset.reduce(f64::min);
        let suggestion = |constraint, within: f64| PanelSuggestion {
            constraint,
            within: allowed(within) / self.mm_of_building(),
        };
        let corners = self.settings.kind.is_none_or(|kind| kind == OffsetKind::Corner);
        let mut suggestions = Vec::new();
        if let Some(of_offset) = of_offset.filter(|_| corners) {
            // Panels with their corners on circles are also flat.
            suggestions.push(suggestion(
                "circle",
                flatness.unwrap_or(f64::INFINITY).min(PART * of_offset),
            ));
        }
        suggestions.extend(flatness.map(|flatness| suggestion("plane", flatness)));
        let otherwise = if of_offset.is_some() && !corners {
            "Set “Measured at” to “Corners”: circular panels then make the offset exact."
        } else if missed("safe_distance").is_some() {
            "Bring “Distance” nearer to 0: fewer edges then flip."
        } else if missed("lean").is_some() {
            "Increase “Upright axes”: the axes then lean less."
        } else if rows.iter().all(|row| row.met != Some(false)) {
            "Every number is within its limit."
        } else {
            "These panels can be made neither circular nor flat."
        };
        Tighten { suggestions, otherwise }
    }
}
