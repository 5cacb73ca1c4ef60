//! The part of the report that is updated while the user moves the shape or tries a distance.

use super::build::Build;
use super::check_card::CheckRow;
use super::fault::Fault;
use super::offset::{Closing, Reason, closing};
use super::tighten::Tighten;
use crate::scene::OffsetKind;
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
    /// What is not available, or not as it seems, each with the reason, as sentences.
    pub problems: Vec<String>,
}

impl Build {
    /// The card, without the parts of the report that take longer.
    pub fn card(&self) -> BuildCard {
        let check = self.check_rows();
        let closing = closing(&self.surface);
        let inexact = self.inexact(&closing);
        BuildCard {
            mean_edge_mm: self.surface.mean_edge() * self.mm_of_building(),
            tighten: self.tighten(&check, &closing, inexact),
            offset: self.offset_report(closing, inexact),
            check,
            problems: self.faults.iter().map(Fault::sentence).collect(),
        }
    }

    fn offset_report(&self, closing: Closing, inexact: Option<Reason>) -> Option<OffsetReport> {
        let (axes, check) = self.offset.as_ref()?;
        let building = self.mm_of_building();
        Some(OffsetReport {
            kind: axes.kind,
            exact: inexact.is_none(),
            why_not: inexact.map_or_else(String::new, |reason| reason.words(&self.names)),
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

    /// Why the axes of the offset are not exact; none if they are, or there is no offset.
    fn inexact(&self, closing: &Closing) -> Option<Reason> {
        /// Panels are flat within this fraction of the tolerance of exact offsets.
        const FLAT: f64 = 0.01;
        let most = FLAT * self.exact_tolerance();
        let are_flat = self.flat.iter().flatten().all(|flat| flat.flatness <= most);
        self.offset.as_ref()?.0.reason(closing, are_flat)
    }
}
