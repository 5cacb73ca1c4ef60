//! What is declared, for the controls of the page: kinds of constraints and the elements that they
//! act on, measures, operations, settings, numbers of the build.

use super::solver::Solver;
use crate::constraint::{Element, Info, KINDS, Kind, Sketch};
use crate::fabricate::BUILD_NUMBERS;
use crate::session::{FACE_MEASURES, OPERATIONS, SETTINGS};
use crate::web::plain::plain;
use serde::Serialize;
use serde_json::Value;
use wasm_bindgen::prelude::*;

/// A type of element on which constraints can act, one constraint per element.
#[derive(Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "camelCase")]
struct ElementWords {
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Element"))]
    id: &'static str,
    label: &'static str,
    face_based: bool,
}

fn elements() -> Vec<ElementWords> {
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
struct KindWords {
    #[serde(flatten)]
    info: &'static Info,
    /// The number of vertices or edges that it takes, in words.
    takes: String,
    sketch: Sketch,
}

fn kinds() -> Vec<KindWords> {
    let all = KINDS.iter();
    all.map(|info| {
        let kind = Kind::new(info.id, Value::Object(serde_json::Map::new()));
        let sketch = kind.expect("every parameter has a default").sketch();
        KindWords { info, takes: info.arity_in_words(), sketch }
    })
    .collect()
}

#[wasm_bindgen]
impl Solver {
    /// Returns all kinds of constraints.
    #[wasm_bindgen(unchecked_return_type = "KindWords[]")]
    pub fn kinds(&self) -> Result<JsValue, JsValue> {
        plain(&kinds())
    }

    /// Returns the elements on which constraints can act, one constraint per element.
    #[wasm_bindgen(unchecked_return_type = "ElementWords[]")]
    pub fn elements(&self) -> Result<JsValue, JsValue> {
        plain(&elements())
    }

    /// Returns the measures of faces.
    #[wasm_bindgen(unchecked_return_type = "FaceMeasure[]")]
    pub fn measures(&self) -> Result<JsValue, JsValue> {
        plain(&FACE_MEASURES)
    }

    /// Returns the declared selection operations.
    #[wasm_bindgen(unchecked_return_type = "Operation[]")]
    pub fn operations(&self) -> Result<JsValue, JsValue> {
        plain(&OPERATIONS)
    }

    /// Returns the declared settings of a scene.
    #[wasm_bindgen(unchecked_return_type = "Setting[]")]
    pub fn settings(&self) -> Result<JsValue, JsValue> {
        plain(&SETTINGS)
    }

    /// Returns the numbers of the build that a lesson may bound.
    #[wasm_bindgen(js_name = buildNumbers, unchecked_return_type = "BuildNumber[]")]
    pub fn build_numbers(&self) -> Result<JsValue, JsValue> {
        plain(&BUILD_NUMBERS)
    }
}
