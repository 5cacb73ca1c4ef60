//! The build check: five numbers with units and limits, each with its worst element, and all
//! elements that exceed a limit. Lengths are in mm of the building.

use super::build::{Build, is_within};
use super::numbers::{BEAM_WARP, BuildNumber, DISTANCE_ERROR, LEAN, NumberUnit, PANEL_FLATNESS};
use super::offset::{BeamCheck, NodeCheck};
use super::surface::distinct;
use serde::Serialize;

/// A number of the build check.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct CheckRow {
    /// Identifier in files.
    pub id: &'static str,
    /// Display name.
    pub label: &'static str,
    /// Its value; none if it does not apply.
    pub value: Option<f64>,
    /// The largest permitted value; none for the offset distance if it has no limit on this side, or
    /// there is no offset.
    pub limit: Option<f64>,
    /// `mm` or `deg`.
    pub unit: &'static str,
    /// Whether it is within the limit; none without a value.
    pub met: Option<bool>,
    /// The worst element: an edge, a vertex or a panel.
    pub worst: Worst,
    /// Number of elements that exceed the limit.
    pub failed: usize,
}

/// An element of the mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Worst {
    /// No element.
    #[default]
    None,
    /// A vertex.
    Vertex(u32),
    /// An edge, by its ends.
    Edge([u32; 2]),
    /// A face.
    Panel(u32),
}

/// The elements that exceed a limit.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Failed {
    /// Panels that are not flat.
    pub panels: Vec<u32>,
    /// Beams that are warped, and edges that flip in the offset; indices of
    /// [`super::PanelSurface::edges`].
    pub edges: Vec<u32>,
    /// Vertices whose axis leans, or does not have the required length.
    pub nodes: Vec<u32>,
}

/// One value per element, in the unit of the limit; none if it does not apply to the element.
struct Checked {
    values: Vec<Option<f64>>,
    limit: f64,
}

impl Checked {
    /// The elements that exceed the limit.
    fn failed(&self) -> impl Iterator<Item = u32> + '_ {
        let failed = |value: &Option<f64>| value.is_some_and(|value| !is_within(value, self.limit));
        (0..).zip(&self.values).filter(move |(_, value)| failed(value)).map(|(k, _)| k)
    }

    /// The largest value, and its first element.
    fn worst(&self) -> Option<(f64, u32)> {
        let values = (0..).zip(&self.values).filter_map(|(k, value)| Some(((*value)?, k)));
        values.reduce(|worst, other| if other.0 > worst.0 { other } else { worst })
    }

    fn row(
        &self,
        (id, label, unit): (&'static str, &'static str, &'static str),
        element: impl Fn(u32) -> Worst,
    ) -> CheckRow {
        let worst = self.worst();
        CheckRow {
            id,
            label,
            value: worst.map(|(value, _)| value),
            limit: Some(self.limit),
            unit,
            met: worst.map(|(value, _)| is_within(value, self.limit)),
            worst: worst.filter(|(value, _)| *value > 0.0).map_or(Worst::None, |(_, k)| element(k)),
            failed: self.failed().count(),
        }
    }
}

impl Build {
    /// The five rows of the build check.
    pub(super) fn check_rows(&self) -> Vec<CheckRow> {
        let beam = |e: u32| Worst::Edge(self.surface.edges[e as usize].ends);
        let of = |BuildNumber { id, label, unit, .. }| {
            (id, label, if unit == NumberUnit::Degrees { "deg" } else { "mm" })
        };
        vec![
            self.warp().row(of(BEAM_WARP), beam),
            self.distance_error().row(of(DISTANCE_ERROR), Worst::Vertex),
            self.lean().row(of(LEAN), Worst::Vertex),
            self.safe_distance_row(beam),
            self.flatness().row(of(PANEL_FLATNESS), |f| match self.face_of(f) {
                Some(face) => Worst::Panel(face),
                None => Worst::Vertex(self.surface.faces.row(f as usize)[0]),
            }),
        ]
    }

    /// The values behind the rows of the check, in their order; empty for the distance, a single
    /// number.
    pub(super) fn check_values(&self) -> [Vec<f64>; 5] {
        let values = |checked: Checked| checked.values.into_iter().flatten().collect();
        [
            values(self.warp()),
            values(self.distance_error()),
            values(self.lean()),
            Vec::new(),
            values(self.flatness()),
        ]
    }

    /// All elements that exceed a limit.
    pub fn failed(&self) -> Failed {
        let edges = distinct(self.warp().failed().chain(self.shrinking().failed()));
        let nodes = distinct(self.distance_error().failed().chain(self.lean().failed()));
        Failed { panels: self.flatness().failed().collect(), edges, nodes }
    }

    fn of_beams(&self, limit: f64, value: impl Fn(&BeamCheck) -> f64) -> Checked {
        let beams = self.offset.iter().flat_map(|(_, check)| &check.beams);
        Checked { values: beams.map(|beam| Some(value(beam))).collect(), limit }
    }

    fn of_nodes(&self, limit: f64, value: impl Fn(&NodeCheck) -> Option<f64>) -> Checked {
        let nodes = self.offset.iter().flat_map(|(_, check)| &check.nodes);
        Checked { values: nodes.map(|node| node.as_ref().and_then(&value)).collect(), limit }
    }

    fn warp(&self) -> Checked {
        let building = self.mm_of_building();
        self.of_beams(self.settings.limits.warp, |beam| beam.warp * building)
    }

    /// The fraction of its length that an edge loses in the offset; above 1 the edge flips.
    fn shrinking(&self) -> Checked {
        let distance = self.distance();
        self.of_beams(1.0, |beam| beam.shrinking * distance)
    }

    fn distance_error(&self) -> Checked {
        let building = self.mm_of_building();
        self.of_nodes(self.settings.limits.distance, |node| Some(node.distance_error * building))
    }

    fn lean(&self) -> Checked {
        // Only inner nodes are checked.
        self.of_nodes(self.settings.limits.lean, |node| node.is_inner.then_some(node.lean_deg))
    }

    fn flatness(&self) -> Checked {
        let building = self.mm_of_building();
        let flatness = self.flat.iter().map(|flat| Some(flat.as_ref()?.flatness * building));
        Checked { values: flatness.collect(), limit: self.settings.limits.flatness }
    }

    /// The row of the offset distance, with its limit on the side of the offset.
    fn safe_distance_row(&self, beam: impl Fn(u32) -> Worst) -> CheckRow {
        let building = self.mm_of_building();
        let side = usize::from(self.distance() > 0.0);
        let check = self.offset.as_ref().map(|(_, check)| check);
        let limit = check.and_then(|check| check.safe_distance[side]).map(|limit| limit * building);
        let shrinking = self.shrinking();
        let row = shrinking.row(("safe_distance", "Offset distance", "mm"), beam);
        let value = check.map(|_| self.distance() * building);
        let met = value.map(|value| limit.is_none_or(|limit| value.abs() < limit.abs()));
        CheckRow { value, limit, met, worst: limit.map_or(Worst::None, |_| row.worst), ..row }
    }
}
