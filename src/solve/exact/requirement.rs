//! The requirements on rows of constraints, and on the edges while they are met: the guard keeps
//! edges between vertices of hard constraints at a fraction of their rest length. Coincident
//! vertices meet most constraints, and without a bound many meshes end there.

use crate::constraint::Kind;
use crate::math::{Lane, Vec3, marked};
use crate::mesh::{Mesh, Ragged};
use crate::solve::energy::Constraints;
use crate::solve::problem::Problem;
use serde_json::json;
use std::collections::BTreeSet;

/// The requirement on a row of constraints.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(rename_all = "camelCase"))]
pub enum Require {
    /// It is weighed against all other energies.
    #[default]
    Soft,
    /// It is met exactly.
    Exact,
    /// No vertex is farther than this from the shape, a length above zero in the unit of the mesh.
    Within(f64),
}

impl Require {
    /// Whether it is hard: met, not weighed.
    pub fn is_hard(self) -> bool {
        self != Require::Soft
    }
}

/// The hard constraints, and the settings for meeting them.
#[derive(Clone, Copy, Debug)]
pub struct Requirements<'a> {
    /// The requirement on each row of constraints of the problem.
    pub rows: &'a [Require],
    /// The least ratio of an edge between vertices of hard constraints to its length at rest, at
    /// most one; `None` is no bound.
    pub shortest_edge: Option<f64>,
    /// Greatest number of iterations of the approach; on meshes of at most a hundred vertices, whose
    /// rounds settle, [`LONGER`](Requirements::LONGER) times as many.
    pub iterations: u32,
}

impl Requirements<'_> {
    /// Number of iterations of the approach that is enough for every mesh that was tried.
    pub const ITERATIONS: u32 = 2000;

    /// See [`Requirements::iterations`].
    pub const LONGER: u32 = 5;

    /// Whether a tolerance is enough for all hard rows.
    pub(super) fn all_within(&self) -> bool {
        !self.rows.contains(&Require::Exact)
    }
}

/// If a tolerance is enough for all other constraints, the guard aims at edges longer by this
/// fraction, so that the approach can end without meeting it exactly.
pub(super) const GUARD_MARGIN: f64 = 0.01;

/// The guarded edges.
pub(super) struct Guard {
    /// A row of line segments, each with a least length.
    pub row: Constraints,
    pub require: Require,
}

impl Guard {
    /// Guards the edges of the `hard` constraints, which stay at least `ratio` times as long as at
    /// rest; `None` if there are no such edges.
    ///
    /// Not guarded are an edge with a hard constraint on its ends alone, other than a line segment
    /// that lets it be as long and shorter, and one whose ends are both `fixed` vertices: nothing could
    /// be done about it.
    pub(super) fn new(
        hard: &[Constraints],
        problem: &Problem<'_>,
        fixed: &BTreeSet<u32>,
        ratio: f64,
        all_within: bool,
    ) -> Option<Guard> {
        let Problem { mesh, topology, .. } = *problem;
        let aim = if all_within { Lane::min((1.0 + GUARD_MARGIN) * ratio, 1.0) } else { ratio };
        let mut own: BTreeSet<[u32; 2]> = BTreeSet::new();
        for row in hard {
            for ends in row.members.iter().filter(|members| members.len() == 2) {
                let rest = length(mesh, ends);
                let needs_guard = matches!(&row.kind, Kind::LineSegment(segment) if {
                    let [least, greatest] = segment.lengths(rest);
                    least < aim * rest && greatest >= aim * rest
                });
                if !needs_guard {
                    own.insert([ends[0].min(ends[1]), ends[0].max(ends[1])]);
                }
            }
        }
        let of_hard = hard.iter().flat_map(|row| row.members.indices());
        let is_hard = marked(topology.vertex_faces().len(), of_hard);
        let edges = topology.edges().iter().zip(topology.edge_faces().iter());
        let guarded = edges.filter(|(ends, faces)| {
            let is_asked = ends.iter().all(|&v| is_hard[v as usize]) && !own.contains(*ends);
            !faces.is_empty() && is_asked && !ends.iter().all(|v| fixed.contains(v))
        });
        let members: Ragged = guarded.map(|(ends, _)| ends).collect();
        let lengths = members.iter().map(|ends| length(mesh, ends)).filter(|length| *length > 0.0);
        let shortest = lengths.fold(f64::INFINITY, Lane::min);
        // Each end may be this far from positions at which the edge is long enough.
        let slack = 0.5 * (aim - ratio) * shortest;
        let require = if slack > 0.0 { Require::Within(slack) } else { Require::Exact };
        let kind = Kind::new("line-segment", json!({ "length": "rest", "strain": [aim, null] }));
        let kind = kind.ok().filter(|_| !members.is_empty())?;
        Some(Guard { row: Constraints { kind, weight: 1.0, members }, require })
    }
}

fn length(mesh: &Mesh, ends: &[u32]) -> f64 {
    let [a, b] = [ends[0], ends[1]].map(|v| Vec3::from(mesh.positions[v as usize]));
    (a - b).length_squared().sqrt()
}
