//! The effect of adding constraints, for every kind and several targets at once.

use super::constraint_target::{ConstraintTarget, target_shape};
use crate::constraint::{Centring, Info, KINDS, Selector, Sets, TargetShape, resolve as select};
use crate::mesh::{Ragged, Topology};
use crate::scene::SceneError;
use crate::session::state::{RestMesh, edges_among};
use serde::Serialize;
use std::collections::BTreeMap;

/// The size of a row of one kind on one target, before it is added.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Preview {
    /// Number of constraints.
    pub constraints: usize,
    /// Number of elements whose number of vertices does not fit the kind.
    pub skipped: usize,
    /// Total number of vertices of all constraints; a shared vertex counts once per constraint.
    pub vertices: usize,
    /// Whether all constraints have the same number of vertices.
    #[serde(skip)]
    pub is_even: bool,
    /// Whether the kind is the usual choice for the target.
    pub usual: bool,
}

/// Returns the size of a row of each kind on each target: `#kinds by #targets`, kinds in the order
/// of [`KINDS`]. An entry is none if no element fits, or if the kind is not meant for the type of
/// element. Each target is resolved once.
///
/// # Errors
/// If a target refers to something that does not exist.
pub(crate) fn previews(
    places: &[ConstraintTarget],
    sets: &Sets,
    rest: &RestMesh,
) -> Result<Vec<Vec<Option<Preview>>>, SceneError> {
    let places: Vec<_> =
        places.iter().map(|place| sizes(place, sets, rest)).collect::<Result<_, _>>()?;
    let of = |info: &Info| places.iter().map(|sizes| sizes.of(info)).collect();
    Ok(KINDS.iter().map(of).collect())
}

fn sizes<'a>(
    place: &'a ConstraintTarget,
    sets: &Sets,
    rest: &RestMesh,
) -> Result<Sizes<'a>, SceneError> {
    let (mesh, topology) = (rest.mesh(), rest.topology());
    let (on, named) = place.clone().named_in(sets, mesh);
    // A selector refers to at most one set.
    let own = named.map(|named| Sets::from([named]));
    let selected = select(&on, mesh, topology, own.as_ref().unwrap_or(sets))
        .map_err(|error| SceneError { path: "on".to_owned(), message: error.to_string() })?;
    let shape = target_shape(&on, &selected, mesh, topology);
    Ok(Sizes::new(&place.on, &selected, shape, topology))
}

/// Sizes of the elements of a target.
struct Sizes<'a> {
    on: &'a Selector,
    /// Their shape on the mesh.
    shape: Option<TargetShape>,
    /// Number of elements by their number of vertices.
    vertices: BTreeMap<usize, usize>,
    /// Number of elements by their number of edge ends.
    ends: BTreeMap<usize, usize>,
}

impl<'a> Sizes<'a> {
    fn new(
        on: &'a Selector,
        selected: &Ragged,
        shape: Option<TargetShape>,
        topology: &Topology,
    ) -> Sizes<'a> {
        let count = |size: &dyn Fn(&[u32]) -> usize| {
            let mut counts = BTreeMap::new();
            selected.iter().for_each(|row| *counts.entry(size(row)).or_insert(0) += 1);
            counts
        };
        let by_edge = KINDS.iter().any(|info| info.centring == Centring::ByEdge);
        Sizes {
            on,
            shape,
            vertices: count(&|row| row.len()),
            ends: if by_edge {
                count(&|row| edges_among(row, topology).len())
            } else {
                BTreeMap::new()
            },
        }
    }

    fn of(&self, info: &Info) -> Option<Preview> {
        let meant = |on: &Selector| match on {
            Selector::Each { element, .. } => {
                info.elements.is_empty() || info.elements.contains(element)
            }
            Selector::Set(_) | Selector::Vertices(_) => true,
        };
        if !meant(self.on) {
            return None;
        }
        let sizes = match info.centring {
            Centring::ByEdge => &self.ends,
            Centring::Together | Centring::Placed => &self.vertices,
        };
        let usual = self.shape.is_some_and(|shape| info.default_for.contains(&shape));
        let mut preview = Preview { usual, ..Preview::default() };
        for (&size, &count) in sizes {
            if info.arity.fits(size) {
                preview.is_even = preview.constraints == 0;
                preview.constraints += count;
                preview.vertices += count * size;
            } else {
                preview.skipped += count;
            }
        }
        (preview.constraints > 0).then_some(preview)
    }
}
