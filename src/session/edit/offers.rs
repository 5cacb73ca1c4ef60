//! What is offered for a new constraint: the places on the mesh, given the selection, the kinds that
//! fit there, and the kind and place to start with.

use super::constraint_target::{ConstraintTarget, target_shape};
use crate::constraint::{
    Centring, Element, Info, KINDS, Selector, Set, Sets, TargetShape, resolve,
};
use crate::scene::SceneError;
use crate::session::state::{RestMesh, edges_among};
use crate::words::{count, decimal, group_digits};
use serde::Serialize;
use std::collections::BTreeMap;

/// What is offered for a new constraint.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct ConstraintOffers {
    /// All places, those with the selection first.
    pub places: Vec<OfferedPlace>,
    /// The kinds that fit somewhere, in the order of [`KINDS`].
    pub kinds: Vec<OfferedKind>,
    /// The kind and the place to start with; none if no kind fits anywhere.
    pub start: Option<OfferedStart>,
    /// The number of the other kinds, in words; empty if all fit.
    pub misfit: String,
    /// For each of the other kinds, what it is for.
    pub misfits: Vec<String>,
}

/// A place for a constraint.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OfferedPlace {
    /// Its id among the places.
    pub id: String,
    /// Its name on the page.
    pub label: String,
    /// The target of the constraint.
    #[serde(flatten)]
    pub target: ConstraintTarget,
    /// Whether kinds that act on any element are not offered there.
    #[serde(skip)]
    is_for_own_kinds: bool,
}

/// A kind with the places that it fits, at least one.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OfferedKind {
    /// The id of the kind.
    pub kind: &'static str,
    /// The places that it fits, in the order of all places.
    pub offers: Vec<ConstraintOffer>,
}

/// What adding a kind at a place makes.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ConstraintOffer {
    /// The id of the place.
    pub place: String,
    /// Number of constraints.
    pub constraints: usize,
    /// Number of elements whose number of vertices or edges does not fit the kind.
    pub skipped: usize,
    /// Whether the kind is the usual choice for the place.
    pub usual: bool,
    /// The constraints and what is skipped, in words.
    pub words: String,
}

/// The kind and the place that are chosen at first.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct OfferedStart {
    /// The id of the kind.
    pub kind: &'static str,
    /// The id of the place.
    pub place: String,
}

/// Returns what is offered for the selected `faces` and `vertices`; the latter include the corners of
/// the faces.
///
/// # Errors
/// If a vertex or a face does not exist.
pub(crate) fn constraint_offers(
    vertices: Vec<u32>,
    faces: Vec<u32>,
    sets: &Sets,
    rest: &RestMesh,
) -> Result<ConstraintOffers, SceneError> {
    let places = places(vertices, faces);
    let sizes: Vec<Sizes> = places
        .iter()
        .map(|place| Sizes::of(&place.target, sets, rest))
        .collect::<Result<_, _>>()?;
    let mut kinds = Vec::new();
    let mut misfits = Vec::new();
    // The usual kind of the first place that has one.
    let mut usual: Option<(usize, &'static str)> = None;
    for info in KINDS {
        let mut offers = Vec::new();
        for (at, (place, sizes)) in places.iter().zip(&sizes).enumerate() {
            let Some(offer) = place.offer(info, sizes) else { continue };
            if offer.usual && usual.is_none_or(|(first, _)| at < first) {
                usual = Some((at, info.id));
            }
            offers.push(offer);
        }
        if offers.is_empty() {
            misfits.push(misfit_in_words(info));
        } else {
            kinds.push(OfferedKind { kind: info.id, offers });
        }
    }
    let start = match usual {
        Some((at, kind)) => Some(OfferedStart { kind, place: places[at].id.clone() }),
        None => kinds.first().map(|OfferedKind { kind, offers }| OfferedStart {
            kind,
            place: offers[0].place.clone(),
        }),
    };
    let misfit = match misfits.len() {
        0 => String::new(),
        number => format!("{} not fit here", count(number, "shape does", "shapes do")),
    };
    Ok(ConstraintOffers { places, kinds, start, misfit, misfits })
}

/// Returns all places: the selection together, each element in it, and each element of the mesh.
fn places(vertices: Vec<u32>, faces: Vec<u32>) -> Vec<OfferedPlace> {
    let each = |element: Element, within: Option<&str>| Selector::Each {
        element,
        within: within.map(str::to_owned),
        radius: element.least_radius(),
    };
    let mut places = Vec::new();
    if !vertices.is_empty() {
        let has_faces = !faces.is_empty();
        let set = if has_faces {
            Set { faces: faces.into(), ..Set::default() }
        } else {
            Set { vertices: vertices.as_slice().into(), ..Set::default() }
        };
        places.push(OfferedPlace {
            id: "selection".to_owned(),
            label: "whole selection together".to_owned(),
            target: ConstraintTarget { on: Selector::Vertices(vertices.into()), set: None },
            is_for_own_kinds: false,
        });
        places.extend(Element::ALL.map(|element| {
            let is_selected = element == Element::Face && has_faces;
            let label = element.label();
            let on = each(element, Some(ConstraintTarget::UNNAMED));
            OfferedPlace {
                id: format!("each-{}-selected", element.id()),
                label: if is_selected {
                    format!("each selected {label}")
                } else {
                    format!("each {label}, within the selection")
                },
                target: ConstraintTarget { on, set: Some(set.clone()) },
                is_for_own_kinds: !is_selected,
            }
        }));
    }
    places.extend(Element::ALL.map(|element| OfferedPlace {
        id: format!("each-{}", element.id()),
        label: format!("each {}", element.label()),
        target: ConstraintTarget { on: each(element, None), set: None },
        is_for_own_kinds: false,
    }));
    places
}

impl OfferedPlace {
    /// Returns what adding a kind here makes; none if it is not meant for the type of element, or no
    /// element fits.
    fn offer(&self, info: &Info, sizes: &Sizes) -> Option<ConstraintOffer> {
        if let Selector::Each { element, .. } = &self.target.on {
            let acts_on_any = info.elements.is_empty() && !self.is_for_own_kinds;
            if !acts_on_any && !info.elements.contains(element) {
                return None;
            }
        }
        let ([one, many], each) = info.counted_as();
        let by_size = match info.centring {
            Centring::ByEdge => &sizes.ends,
            Centring::Together | Centring::Placed => &sizes.vertices,
        };
        let [mut constraints, mut skipped, mut points, mut fitting] = [0; 4];
        for (&size, &count) in by_size {
            if info.arity.fits(size) {
                constraints += count;
                points += count * size;
                fitting += 1;
            } else {
                skipped += count;
            }
        }
        let size = match fitting {
            0 => return None,
            1 => count(points / constraints / each, one, many),
            _ => {
                let mean = points as f64 / (constraints * each) as f64;
                format!("{} {many} on average", decimal(mean, 1))
            }
        };
        let mut words = format!("{} of {size}.", count(constraints, "constraint", "constraints"));
        if skipped > 0 {
            let their = if skipped == 1 { "its" } else { "their" };
            let skipped = group_digits(skipped);
            words += &format!(" {skipped} skipped: {their} number of {many} does not fit.");
        }
        let usual = sizes.shape.is_some_and(|shape| info.default_for.contains(&shape));
        Some(ConstraintOffer { place: self.id.clone(), constraints, skipped, usual, words })
    }
}

/// The sizes of the elements of a place.
struct Sizes {
    /// Their shape on the mesh.
    shape: Option<TargetShape>,
    /// Number of elements by their number of vertices.
    vertices: BTreeMap<usize, usize>,
    /// Number of elements by their number of edge ends.
    ends: BTreeMap<usize, usize>,
}

impl Sizes {
    /// Resolves the target of a place, once for all kinds.
    ///
    /// # Errors
    /// If it refers to something that does not exist.
    fn of(target: &ConstraintTarget, sets: &Sets, rest: &RestMesh) -> Result<Sizes, SceneError> {
        let (mesh, topology) = (rest.mesh(), rest.topology());
        let (on, named) = target.clone().named_in(sets, mesh);
        // A selector refers to at most one set.
        let own = named.map(|named| Sets::from([named]));
        let selected = resolve(&on, mesh, topology, own.as_ref().unwrap_or(sets))
            .map_err(|error| SceneError { path: "on".to_owned(), message: error.to_string() })?;
        let count = |size: &dyn Fn(&[u32]) -> usize| {
            let mut counts = BTreeMap::new();
            selected.iter().for_each(|row| *counts.entry(size(row)).or_insert(0) += 1);
            counts
        };
        Ok(Sizes {
            shape: target_shape(&on, &selected, mesh, topology),
            vertices: count(&|row| row.len()),
            ends: count(&|row| 2 * edges_among(row, topology).len()),
        })
    }
}

/// Says what a kind is for that fits nowhere.
fn misfit_in_words(info: &Info) -> String {
    let elements = Element::ALL.iter().filter(|element| info.elements.contains(element));
    let elements: Vec<&str> = elements.map(|element| element.label()).collect();
    if elements.is_empty() {
        return format!("{}: it takes {}", info.label, info.arity_in_words());
    }
    format!("{}: it is for each {}", info.label, elements.join(" or "))
}
