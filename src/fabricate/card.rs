//! The part of the report that is updated while the user moves the shape or tries a distance.

use super::build::Build;
use super::check_card::CheckRow;
use super::fault::Fault;
use super::offset::{Closings, Reason, closings};
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
        let closings = closings(&self.surface);
        let inexact = self.inexact(&closings);
        BuildCard {
            mean_edge_mm: self.surface.mean_edge() * self.mm_of_building(),
            tighten: self.tighten(&check, &closings, inexact),
            offset: self.offset_report(&closings, inexact),
            check,
            problems: self.faults.iter().map(Fault::sentence).collect(),
        }
    }

    fn offset_report(&self, closings: &Closings, inexact: Option<Reason>) -> Option<OffsetReport> {
        let (axes, check) = self.offset.as_ref()?;
        let building = self.mm_of_building();
        let parts = || closings.parts.iter();
        Some(OffsetReport {
            kind: axes.kind,
            exact: inexact.is_none(),
            why_not: inexact.map_or_else(String::new, |reason| self.in_words(reason)),
            distance_mm: self.distance() * building,
            warp_mm: check.warp * building,
            twist_deg: check.twist_deg,
            distance_error_mm: check.distance_error * building,
            lean_deg: check.lean_deg,
            inner_lean_deg: check.inner_lean_deg,
            offset_flatness_mm: check.offset_flatness * building,
            safe_distance_mm: check.safe_distance.map(|limit| limit.map(|limit| limit * building)),
            beam_height_mm: check.edge_distance.map(|height| height * building),
            closing_panel_deg: parts().map(|own| own.panel_deg).fold(0.0, f64::max),
            odd_panels: parts().map(|own| own.odd_panels).sum(),
            closing_rims_deg: parts().flat_map(|own| own.rims_deg.iter().copied()).collect(),
        })
    }

    /// Why the axes of the offset are not exact; none if they are, or there is no offset.
    fn inexact(&self, closings: &Closings) -> Option<Reason> {
        /// Panels are flat within this fraction of the tolerance of exact offsets.
        const FLAT: f64 = 0.01;
        let most = FLAT * self.exact_tolerance();
        let are_flat = self.flat.iter().flatten().all(|flat| flat.flatness <= most);
        self.offset.as_ref()?.0.reason(closings, are_flat)
    }

    /// Why axes are not exact, as a clause.
    pub(super) fn in_words(&self, reason: Reason) -> String {
        let (node, beam) = (|v: u32| self.node_name(v), |ends: [u32; 2]| self.beam_name(ends));
        reason.words(&self.names, node, beam, self.exact_tolerance() * self.mm_of_building())
    }
}
