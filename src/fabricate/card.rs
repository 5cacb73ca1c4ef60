//! The part of the report that is updated while the user moves the shape or tries a distance.

use super::build::Build;
use super::check_card::CheckRow;
use super::offset::{Closing, can_be_exact, closing};
use super::panel::FlatPanel;
use super::tighten::Tighten;
use crate::scene::OffsetKind;
use crate::words;
use serde::Serialize;

/// Numbers of the offset.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct OffsetReport {
    /// The kind of elements that keep their distance.
    pub kind: OffsetKind,
    /// Whether they keep it exactly; else the axes are a least-squares fit.
    pub exact: bool,
    /// Why it is not exact; empty if it is.
    pub why_not: String,
    /// The distance, positive outwards.
    pub distance_mm: f64,
    /// Largest distance of a beam's corners from its plane.
    pub warp_mm: f64,
    /// Largest angle between the two ends of a beam.
    pub twist_deg: f64,
    /// Largest deviation from the requested distance.
    pub distance_error_mm: f64,
    /// Largest angle between a node axis and the surface normal over all nodes. At the rim of a
    /// coarse mesh it is large and harmless.
    pub lean_deg: f64,
    /// As `lean_deg`, over inner nodes only; this one is checked.
    pub inner_lean_deg: f64,
    /// Largest deviation of a panel of the offset from flat.
    pub offset_flatness_mm: f64,
    /// The distances, inwards and outwards, at which an edge of the offset has zero length; null if
    /// none.
    pub safe_distance_mm: [Option<f64>; 2],
    /// Least and largest height of beams.
    pub beam_height_mm: [f64; 2],
    /// For corner offsets: the largest turn around a panel.
    pub closing_panel_deg: f64,
    /// For corner offsets: panels with an odd number of edges.
    pub odd_panels: usize,
    /// For corner offsets: the turn around each rim; null for an odd number of edges.
    pub closing_rims_deg: Vec<Option<f64>>,
}

/// The part of the report that depends on the offset.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct BuildCard {
    /// Mean length of edges.
    pub mean_edge_mm: f64,
    /// The offset; null if it is not available.
    pub offset: Option<OffsetReport>,
    /// The five numbers of the build check.
    pub check: Vec<CheckRow>,
    /// Suggestions for the numbers that exceed their limits.
    pub tighten: Tighten,
    /// What is not available, or not as it seems, each with the reason.
    pub problems: Vec<String>,
}

impl Build {
    /// The card, without the parts of the report that take longer.
    pub fn card(&self) -> BuildCard {
        let check = self.check_rows();
        BuildCard {
            mean_edge_mm: self.surface.mean_edge() * self.mm_of_building(),
            offset: self.offset_report(),
            tighten: self.tighten(&check),
            check,
            problems: self.faults.iter().map(|fault| fault.0.clone()).collect(),
        }
    }

    fn offset_report(&self) -> Option<OffsetReport> {
        let (axes, check) = self.offset.as_ref()?;
        let building = self.mm_of_building();
        let closing = closing(&self.surface);
        let why_not = if axes.exact { String::new() } else { self.why_not(axes.kind, &closing) };
        Some(OffsetReport {
            kind: axes.kind,
            exact: axes.exact,
            why_not,
            distance_mm: self.distance() * building,
            warp_mm: check.warp * building,
            twist_deg: check.twist_deg,
            distance_error_mm: check.distance_error * building,
            lean_deg: check.lean_deg,
            inner_lean_deg: check.inner_lean_deg,
            offset_flatness_mm: check.offset_flatness * building,
            safe_distance_mm: check.safe_distance.map(|limit| limit.map(|limit| limit * building)),
            beam_height_mm: check.edge_distance.map(|height| height * building),
            closing_panel_deg: closing.panel_deg,
            odd_panels: closing.odd_panels,
            closing_rims_deg: closing.rims_deg,
        })
    }

    fn why_not(&self, kind: OffsetKind, closing: &Closing) -> String {
        const LEAN: &str = "the exact axes lean too far";
        /// Turns below this are due to rounding or the solver's tolerance.
        const CLOSED: f64 = 0.01;
        /// Smaller eigenvalues of the closing form are zero.
        const ZERO: f64 = 1e-6;
        /// Panels are flat within this fraction of the tolerance of exact offsets.
        const FLAT: f64 = 0.01;
        match kind {
            OffsetKind::Corner if closing.odd_panels > 0 => format!(
                "the axes do not close around {}, with an odd number of edges",
                words::count(closing.odd_panels, "panel", "panels")
            ),
            OffsetKind::Corner if closing.panel_deg > CLOSED => format!(
                "around panel {} an axis is turned by {}: its corners are not on a circle",
                self.names[closing.panel as usize],
                words::degrees(closing.panel_deg)
            ),
            OffsetKind::Corner => {
                let turns = closing.rims_deg.iter().flatten();
                let worst = turns.copied().fold(0.0, f64::max);
                if closing.rims_deg.contains(&None) {
                    "a rim has an odd number of edges: axes close around it only in special shapes"
                        .to_owned()
                } else if worst > CLOSED {
                    format!(
                        "around a rim an axis is turned by {}, so the axes do not close",
                        words::degrees(worst)
                    )
                } else if closing.eigenvalues[0] > ZERO {
                    "the axes do not close around the openings through the surface, as in a ring".to_owned()
                } else {
                    LEAN.to_owned()
                }
            }
            OffsetKind::Face => {
                let tolerance = self.exact_tolerance();
                let bent = |flat: &FlatPanel| flat.flatness > FLAT * tolerance;
                if !can_be_exact(&self.surface, kind, self.distance(), tolerance) {
                    "around some vertex, the panels moved by this distance do not meet in one point".to_owned()
                } else if self.flat.iter().flatten().any(bent) {
                    "the panels are not flat".to_owned()
                } else {
                    LEAN.to_owned()
                }
            }
            OffsetKind::Edge => {
                "only a mesh whose edges are parallel to edges that all touch one sphere allows this".to_owned()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::LengthInMetres;
    use crate::mesh::Mesh;
    use crate::scene::BuildSettings;

    fn one_panel() -> Build {
        let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let faces = [[0, 1, 2, 3]].into_iter().collect();
        let mesh = Mesh { positions, faces, ..Mesh::default() };
        let unit = LengthInMetres { symbol: "m".to_owned(), metres: 1.0 };
        Build::new(&mesh, &BuildSettings::default(), unit).unwrap()
    }

    #[test]
    fn an_odd_rim_is_the_reason_rather_than_a_turn_of_zero() {
        let build = one_panel();
        let why = |rims_deg: [Option<f64>; 2]| {
            let closing = Closing { rims_deg: rims_deg.to_vec(), ..Closing::default() };
            build.why_not(OffsetKind::Corner, &closing)
        };
        let odd = why([None, Some(0.0)]);
        assert!(odd.contains("odd number of edges") && !odd.contains('°'), "{odd}");
        let turned = why([Some(0.0), Some(1.5)]);
        assert!(turned.contains("turned by 1.50°"), "{turned}");
    }

    #[test]
    fn openings_are_the_reason_where_axes_close_around_panels_and_rims_and_not_on_the_whole() {
        let build = one_panel();
        let why = |least: f64| {
            let eigenvalues = [least, 0.1, 0.2];
            build.why_not(OffsetKind::Corner, &Closing { eigenvalues, ..Closing::default() })
        };
        assert!(why(0.01).contains("openings through the surface"), "{}", why(0.01));
        assert!(why(1e-12).contains("lean"), "{}", why(1e-12));
    }
}
