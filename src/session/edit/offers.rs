//! What is offered for a new constraint: the places on the mesh, given the selection, the kinds that
//! fit there, and the kind and place to start with.

use super::constraint_target::ConstraintTarget;
use super::preview::{Preview, previews};
use crate::constraint::{Element, Info, KINDS, Selector, Set, Sets};
use crate::scene::SceneError;
use crate::session::state::RestMesh;
use crate::words::{count, decimal, group_digits};
use serde::Serialize;

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
    pub on: ConstraintTarget,
    /// Only kinds that are meant for this element are offered; none if any kind is.
    #[serde(skip)]
    only_for: Option<Element>,
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
    /// The constraints.
    #[serde(flatten)]
    pub preview: Preview,
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
    let targets: Vec<ConstraintTarget> = places.iter().map(|place| place.on.clone()).collect();
    let previews = previews(&targets, sets, rest)?;
    let fits = |info: &Info, place: &OfferedPlace| {
        place.only_for.is_none_or(|element| info.elements.contains(&element))
    };
    let mut kinds = Vec::new();
    let mut misfits = Vec::new();
    // The usual kind of the first place that has one.
    let mut usual: Option<(usize, &'static str)> = None;
    for (info, row) in KINDS.iter().zip(previews) {
        let mut offers = Vec::new();
        for (at, (place, preview)) in places.iter().zip(row).enumerate() {
            let Some(preview) = preview.filter(|_| fits(info, place)) else { continue };
            if preview.usual && usual.is_none_or(|(first, _)| at < first) {
                usual = Some((at, info.id));
            }
            let (place, words) = (place.id.clone(), in_words(preview));
            offers.push(ConstraintOffer { place, preview, words });
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
            on: ConstraintTarget { on: Selector::Vertices(vertices.into()), set: None },
            only_for: None,
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
                on: ConstraintTarget { on, set: Some(set.clone()) },
                only_for: (!is_selected).then_some(element),
            }
        }));
    }
    places.extend(Element::ALL.map(|element| OfferedPlace {
        id: format!("each-{}", element.id()),
        label: format!("each {}", element.label()),
        on: ConstraintTarget { on: each(element, None), set: None },
        only_for: None,
    }));
    places
}

fn in_words(preview: Preview) -> String {
    let Preview { constraints, skipped, vertices, is_even, .. } = preview;
    let size = if is_even {
        count(vertices / constraints, "vertex", "vertices")
    } else {
        format!("{} vertices on average", decimal(vertices as f64 / constraints as f64, 1))
    };
    let made = format!("{} of {size}.", count(constraints, "constraint", "constraints"));
    match skipped {
        0 => made,
        _ => format!(
            "{made} {} skipped: their number of vertices does not fit.",
            group_digits(skipped)
        ),
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
