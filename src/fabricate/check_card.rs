//! The build check: five numbers with units and limits, each with the element that is worst, and all elements that
//! are not within a limit. Lengths are in mm of the building.

use super::build::Build;
use super::offset::{BeamCheck, NodeCheck};
use super::surface::distinct;
use serde::Serialize;

/// A number of the build check.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct CheckRow {
    /// Its name in files.
    pub id: &'static str,
    /// Its name for people.
    pub label: &'static str,
    /// Its value; none where it does not apply.
    pub value: Option<f64>,
    /// The value that it should not pass; none of the safe distance inwards where there is no limit.
    pub limit: Option<f64>,
    /// `mm` or `deg`.
    pub unit: &'static str,
    /// Whether it is within the limit; none where there is no value.
    pub met: Option<bool>,
    /// The element that is worst: the ends of an edge, a vertex or a panel.
    pub worst: Worst,
    /// How many elements are not within the limit.
    pub failed: usize,
}

/// An element of the mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Worst {
    /// None.
    #[default]
    None,
    /// A vertex.
    Vertex(u32),
    /// The ends of an edge.
    Edge([u32; 2]),
    /// A face.
    Panel(u32),
}

/// The elements that are not within a limit.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Failed {
    /// Panels that are not flat.
    pub panels: Vec<u32>,
    /// Beams that are warped, and edges that turn round in the offset, by [`super::PanelSurface::edges`].
    pub edges: Vec<u32>,
    /// Vertices whose axis leans, or has another length than it should.
    pub nodes: Vec<u32>,
}

/// One number of every element of a kind, in the unit of its limit; none where an element has no such number.
struct Checked {
    values: Vec<Option<f64>>,
    limit: f64,
}

impl Checked {
    /// The elements that are not within the limit.
    fn failed(&self) -> impl Iterator<Item = u32> + '_ {
        let failed = |value: &Option<f64>| value.is_some_and(|value| value > self.limit);
        (0..).zip(&self.values).filter(move |(_, value)| failed(value)).map(|(k, _)| k)
    }

    /// The first element of the greatest value.
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
            met: worst.map(|(value, _)| value <= self.limit),
            worst: worst.filter(|(value, _)| *value > 0.0).map_or(Worst::None, |(_, k)| element(k)),
            failed: self.failed().count(),
        }
    }
}

impl Build {
    /// The card.
    pub(super) fn check_rows(&self) -> Vec<CheckRow> {
        let beam = |e: u32| Worst::Edge(self.surface.edges[e as usize].ends);
        vec![
            self.warp().row(("beam_warp", "Beam warp", "mm"), beam),
            self.distance_error().row(("distance_error", "Distance error", "mm"), Worst::Vertex),
            self.lean().row(("lean", "Lean", "deg"), Worst::Vertex),
            self.safe_distance_row(beam),
            self.flatness().row(("panel_flatness", "Panel flatness", "mm"), Worst::Panel),
        ]
    }

    /// The values behind the rows of the card, in their order; none behind the distance, which is one number.
    pub(super) fn spreads(&self) -> [Vec<f64>; 5] {
        let values = |checked: Checked| checked.values.into_iter().flatten().collect();
        let checks = self.offset.iter().flat_map(|(_, check)| &check.nodes);
        // Of a rim nothing is judged.
        let lean = checks.filter(|node| node.is_inner).map(|node| node.lean_deg).collect();
        [
            values(self.warp()),
            values(self.distance_error()),
            lean,
            Vec::new(),
            values(self.flatness()),
        ]
    }

    /// All elements that are not within a limit.
    pub fn failed(&self) -> Failed {
        let edges = distinct(self.warp().failed().chain(self.shrinking().failed()));
        let nodes = distinct(self.distance_error().failed().chain(self.lean().failed()));
        Failed { panels: self.flatness().failed().collect(), edges, nodes }
    }

    fn of_beams(&self, limit: f64, value: impl Fn(&BeamCheck) -> f64) -> Checked {
        let beams = self.offset.iter().flat_map(|(_, check)| &check.beams);
        Checked { values: beams.map(|beam| Some(value(beam))).collect(), limit }
    }

    fn of_nodes(&self, limit: f64, value: impl Fn(&NodeCheck) -> f64) -> Checked {
        let nodes = self.offset.iter().flat_map(|(_, check)| &check.nodes);
        Checked { values: nodes.map(|node| Some(value(node))).collect(), limit }
    }

    fn warp(&self) -> Checked {
        let building = self.building();
        self.of_beams(self.settings.limits.warp, |beam| beam.warp * building)
    }

    /// By how much of its length an edge is shorter in the offset; one that is shorter by all of it turns round.
    fn shrinking(&self) -> Checked {
        let distance = self.distance();
        self.of_beams(1.0, |beam| beam.shrinking * distance)
    }

    fn distance_error(&self) -> Checked {
        let building = self.building();
        self.of_nodes(self.settings.limits.distance, |node| node.distance_error * building)
    }

    fn lean(&self) -> Checked {
        let judged = |node: &NodeCheck| if node.is_inner { node.lean_deg } else { 0.0 };
        self.of_nodes(self.settings.limits.lean, judged)
    }

    fn flatness(&self) -> Checked {
        let building = self.building();
        let flatness = self.flat.iter().map(|flat| Some(flat.as_ref()?.flatness * building));
        Checked { values: flatness.collect(), limit: self.settings.limits.flatness }
    }

    /// The limit of the distance on the side to which it goes.
    fn safe_distance_row(&self, beam: impl Fn(u32) -> Worst) -> CheckRow {
        let building = self.building();
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
