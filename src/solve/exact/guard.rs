//! The guard: edges between vertices of hard constraints keep a part of their length at rest. Coincident vertices
//! meet most constraints, and without a bound many a mesh ends there.

use crate::constraint::Kind;
use crate::mesh::{Ragged, Topology};
use crate::solve::energy::Constraints;
use serde_json::json;
use std::collections::BTreeSet;

/// The guarded edges as a row of line segments that are at least `ratio` times as long as at rest; none where
/// there are no such edges.
///
/// An edge that a hard constraint is on by itself is not guarded: its length is what is asked for.
pub(super) fn guard(hard: &[Constraints], topology: &Topology, ratio: f64) -> Option<Constraints> {
    let is_pair = |members: &&[u32]| members.len() == 2;
    let pairs = hard.iter().flat_map(|row| row.members.iter()).filter(is_pair);
    let own: BTreeSet<[u32; 2]> =
        pairs.map(|ends| [ends[0].min(ends[1]), ends[0].max(ends[1])]).collect();
    let mut is_hard = vec![false; topology.vertex_faces().len()];
    for row in hard {
        row.members.indices().iter().for_each(|&v| is_hard[v as usize] = true);
    }
    let edges = topology.edges().iter().zip(topology.edge_faces().iter());
    let guarded = edges.filter(|(ends, faces)| {
        !faces.is_empty() && ends.iter().all(|&v| is_hard[v as usize]) && !own.contains(*ends)
    });
    let members: Ragged = guarded.map(|(ends, _)| ends).collect();
    let kind = Kind::new("line-segment", json!({ "length": "rest", "strain": [ratio, null] }));
    let kind = kind.ok().filter(|_| !members.is_empty())?;
    Some(Constraints { kind, weight: 1.0, members })
}
