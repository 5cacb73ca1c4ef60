//! The kinds of constraints and the elements that they act on, for the controls of the page.

use crate::constraint::{Element, Info, KINDS, Kind, Sketch};
use serde::Serialize;
use serde_json::Value;

/// A type of element on which constraints can act, one constraint per element.
#[derive(Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "camelCase")]
pub(crate) struct ElementWords {
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Element"))]
    id: &'static str,
    label: &'static str,
    face_based: bool,
}

pub(crate) fn elements() -> Vec<ElementWords> {
    let all = Element::ALL.iter();
    all.map(|&element| ElementWords {
        id: element.id(),
        label: element.label(),
        face_based: element == Element::Face,
    })
    .collect()
}

/// A kind of constraint with its sketch.
#[derive(Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub(crate) struct KindWords {
    #[serde(flatten)]
    info: &'static Info,
    /// The number of vertices or edges that it takes, in words.
    takes: String,
    sketch: Sketch,
}

pub(crate) fn kinds() -> Vec<KindWords> {
    let all = KINDS.iter();
    all.map(|info| {
        let kind = Kind::new(info.id, Value::Object(serde_json::Map::new()));
        let sketch = kind.expect("every parameter has a default").sketch();
        KindWords { info, takes: info.arity_in_words(), sketch }
    })
    .collect()
}
