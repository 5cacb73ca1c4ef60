//! What the card shows, and what follows while somebody moves the shape or tries a distance.

use super::build::Build;
use super::check_card::CheckRow;
use super::offset::{Closing, OffsetKind, closing};
use super::tighten::Tighten;
use serde::Serialize;

/// The offset.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct OffsetReport {
    /// The elements that keep their distance.
    pub kind: OffsetKind,
    /// Whether it does so exactly; else the axes are the least-squares fit.
    pub exact: bool,
    /// Why not; empty where it is.
    pub why_not: String,
    /// The distance, positive outwards.
    pub distance_mm: f64,
    /// The largest distance of a beam's corners to its plane.
    pub warp_mm: f64,
    /// The largest angle between the two ends of a beam.
    pub twist_deg: f64,
    /// How far the distance is from what was asked for at worst.
    pub distance_error_mm: f64,
    /// The largest angle between a node axis and the normal of the surface: of all nodes, and of inner ones,
    /// which are judged (at the rim of a coarse mesh it is large and harmless).
    pub lean_deg: f64,
    /// See `lean_deg`.
    pub inner_lean_deg: f64,
    /// How far the panels of the offset are from flat.
    pub offset_flatness_mm: f64,
    /// The distances, inwards and outwards, at which an edge of the offset has no length; null without limit.
    pub safe_distance_mm: [Option<f64>; 2],
    /// Heights of beams.
    pub beam_height_mm: [f64; 2],
    /// Of corner offsets: the largest turn around a panel, panels with an odd number of edges, and the turn around
    /// each rim (null where it has an odd number of edges).
    pub closing_panel_deg: f64,
    /// See `closing_panel_deg`.
    pub odd_panels: usize,
    /// See `closing_panel_deg`.
    pub closing_rims_deg: Vec<Option<f64>>,
}

/// The part of the report that the offset decides.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct BuildCard {
    /// The mean length of edges.
    pub mean_edge_mm: f64,
    /// The offset; null where it is not offered.
    pub offset: Option<OffsetReport>,
    /// The five numbers.
    pub check: Vec<CheckRow>,
    /// Remedies for the numbers that exceed their limits.
    pub tighten: Tighten,
    /// Products that are not offered, each with the reason.
    pub problems: Vec<String>,
}

impl Build {
    /// The card, without what the rest of the report takes to count.
    pub fn card(&self) -> BuildCard {
        let check = self.check_rows();
        BuildCard {
            mean_edge_mm: self.surface.mean_edge() * self.building(),
            offset: self.offset_report(),
            tighten: self.tighten(&check),
            check,
            problems: self.faults.iter().map(|fault| fault.0.clone()).collect(),
        }
    }

    fn offset_report(&self) -> Option<OffsetReport> {
        let (axes, check) = self.offset.as_ref()?;
        let building = self.building();
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
        /// Turns below this are rounding or a tolerance of the solver.
        const CLOSED: f64 = 0.01;
        match kind {
            OffsetKind::Corner if closing.odd_panels > 0 => format!(
                "{} panels have an odd number of edges and do not close",
                closing.odd_panels
            ),
            OffsetKind::Corner if closing.panel_deg > CLOSED => format!(
                "around panel {} an axis is turned by {:.2} degrees: its corners are not on a circle",
                self.names[closing.panel as usize], closing.panel_deg
            ),
            OffsetKind::Corner => {
                let turns = closing.rims_deg.iter().flatten();
                let worst = turns.copied().fold(0.0, f64::max);
                if closing.rims_deg.contains(&None) || worst > CLOSED {
                    format!(
                        "around a hole an axis is turned by {worst:.2} degrees, so that no axes close around all holes"
                    )
                } else {
                    "the exact axes lean too far".to_owned()
                }
            }
            OffsetKind::Face => {
                "around some vertex the planes of the panels touch no common cone".to_owned()
            }
            OffsetKind::Edge => {
                "the shape is not parallel to one whose edges touch a sphere".to_owned()
            }
        }
    }
}
