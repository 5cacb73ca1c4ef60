//! Rows of constraints with their vertices.

use crate::constraint::{Centring, Element, Kind, Selector, resolve};
use crate::math::{Vec3, centre};
use crate::mesh::{Mesh, Ragged, Topology};
use crate::scene::{ConstraintSpec, Scene, SceneError};
use crate::solve::Constraints;
use serde::Serialize;

/// A row of the list of constraints with the vertices that it acts on.
#[derive(Clone, Debug, PartialEq)]
pub struct ResolvedRow {
    /// Kind, weight, and the vertices of each constraint.
    pub constraints: Constraints,
    /// Number of elements whose number of vertices does not fit the kind.
    pub skipped: usize,
    /// Whether the row is enabled.
    pub enabled: bool,
    /// Number of vertices with a partner at rest, for a kind that acts on vertices in pairs.
    pub paired: Option<Paired>,
}

/// Number of vertices with a partner at rest, such as a mirror image; all others are free.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Paired {
    /// Number of vertices with a partner; a shared vertex counts once per constraint.
    pub vertices: usize,
    /// Number of all vertices, counted in the same way.
    pub of: usize,
}

/// Whether vertices are drawn to the shapes of a row: hard constraints are met whatever they weigh.
pub(crate) fn acts(row: &ConstraintSpec, scene: &Scene) -> bool {
    let is_weighed = row.weight > 0.0 && scene.weights.shape > 0.0;
    row.enabled && (row.require.is_hard() || is_weighed)
}

impl Paired {
    /// Counts over all constraints of a row; none if the kind does not act on pairs.
    fn of(constraints: &Constraints, mesh: &Mesh) -> Option<Paired> {
        let mut vertices = 0;
        for members in constraints.members.iter() {
            let mut rest: Vec<_> =
                members.iter().map(|&v| Vec3::from(mesh.positions[v as usize])).collect();
            centre(&mut rest);
            vertices += constraints.kind.paired(&rest)?;
        }
        Some(Paired { vertices, of: constraints.members.indices().len() })
    }
}

/// Maximum number of vertices of all constraints together, because a few words of a scene could
/// stand for any number.
const MOST_MEMBERS: usize = 40_000_000;

/// Resolves every row of a scene.
///
/// # Errors
/// If a row has no constraint left, or all constraints together have too many vertices for the
/// solver, with the JSON path of the row.
pub(crate) fn resolve_rows(
    scene: &Scene,
    mesh: &Mesh,
    topology: &Topology,
) -> Result<Vec<ResolvedRow>, SceneError> {
    let mut members = 0;
    let resolved = scene.constraints.iter().enumerate().map(|(i, spec)| {
        let error = |message| SceneError { path: format!("constraints[{i}].on"), message };
        let row = resolve_row(spec, scene, mesh, topology).map_err(error)?;
        members += row.constraints.members.indices().len();
        if members > MOST_MEMBERS {
            return Err(error(format!(
                "the constraints have more than {MOST_MEMBERS} vertices together, expected fewer of them"
            )));
        }
        Ok(row)
    });
    resolved.collect()
}

/// Resolves one row; the error is the reason why no constraint is left.
pub(crate) fn resolve_row(
    spec: &ConstraintSpec,
    scene: &Scene,
    mesh: &Mesh,
    topology: &Topology,
) -> Result<ResolvedRow, String> {
    let selected =
        resolve(&spec.on, mesh, topology, &scene.sets).map_err(|error| error.to_string())?;
    let info = spec.kind.info();
    let selected = match info.centring {
        Centring::ByEdge => selected
            .iter()
            .map(|members| {
                let ends = edges_among(members, topology).into_flattened().into_iter();
                ends.map(|end| members[end as usize]).collect::<Vec<u32>>()
            })
            .collect(),
        Centring::Together | Centring::Placed => selected,
    };
    let selected = match (&spec.kind, &spec.on) {
        (Kind::OnCurve(curve), Selector::Each { element: Element::Boundary, .. })
            if curve.tells_closed_by_gap() =>
        {
            selected.iter().map(|row| begun_elsewhere(row, mesh, topology)).collect()
        }
        _ => selected,
    };
    let fits = |members: &&[u32]| info.arity.fits(members.len());
    let members: Ragged = selected.iter().filter(fits).collect();
    if members.is_empty() {
        return Err(if selected.is_empty() {
            "nothing is selected: the mesh has no such element, expected at least one".to_owned()
        } else {
            format!(
                "{} takes {}, and none of the {} selected elements has that, expected some that do",
                info.id,
                info.arity_in_words(),
                selected.len()
            )
        });
    }
    let skipped = selected.len() - members.len();
    let constraints = Constraints { kind: spec.kind.clone(), weight: spec.weight, members };
    let paired = Paired::of(&constraints, mesh);
    Ok(ResolvedRow { constraints, skipped, enabled: spec.enabled, paired })
}

/// A boundary loop whose closing edge is by far the longest is begun one vertex later: [`OnCurve`], which
/// does not know edges, would take such an edge for a gap.
///
/// [`OnCurve`]: crate::constraint::Kind::OnCurve
fn begun_elsewhere(row: &[u32], mesh: &Mesh, topology: &Topology) -> Vec<u32> {
    let mut row = row.to_vec();
    let length = |a: u32, b: u32| {
        let [a, b] = [a, b].map(|v| Vec3::from(mesh.positions[v as usize]));
        (b - a).length()
    };
    let closing = length(row[row.len() - 1], row[0]);
    let is_longest = row.windows(2).all(|ends| 1.5 * length(ends[0], ends[1]) < closing);
    if is_longest && topology.is_closed_loop(&row) {
        row.rotate_left(1);
    }
    row
}

/// Returns the edges of the mesh between `members`, each as the indices there of its ends, in the order
/// of the smaller end among the members.
pub(crate) fn edges_among(members: &[u32], topology: &Topology) -> Vec<[u32; 2]> {
    let mut sorted: Vec<(u32, u32)> = members.iter().copied().zip(0..).collect();
    sorted.sort_unstable();
    let mut edges = Vec::new();
    for (&v, place) in members.iter().zip(0..) {
        for &u in topology.neighbours().row(v as usize) {
            if v < u
                && let Ok(other) = sorted.binary_search_by_key(&u, |(member, _)| *member)
            {
                edges.push([place, sorted[other].1]);
            }
        }
    }
    edges
}
