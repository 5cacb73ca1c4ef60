//! What is declared, for the controls of the page: kinds of constraints, measures, operations, settings,
//! numbers of the build.

use super::solver::Solver;
use crate::constraint::{Info, KINDS, Kind, Sketch};
use crate::fabricate::{BUILD_NUMBERS, BuildNumber};
use crate::mesh::{FILE_FORMATS, FileFormat};
use crate::session::{FACE_MEASURES, FaceMeasure, OPERATIONS, Operation, SETTINGS, Setting};
use crate::web::values::{Js, plains};
use serde::Serialize;
use serde_json::Value;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// A kind of constraint with its sketch.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct KindWords {
    #[serde(flatten)]
    info: &'static Info,
    sketch: Sketch,
}

fn kinds() -> Vec<KindWords> {
    let all = KINDS.iter();
    all.map(|info| {
        let kind = Kind::new(info.id, Value::Object(serde_json::Map::new()));
        let sketch = kind.expect("every parameter has a default").sketch();
        KindWords { info, sketch }
    })
    .collect()
}

#[wasm_bindgen]
impl Solver {
    /// Returns all kinds of constraints.
    pub fn kinds(&self) -> Result<Vec<Js<KindWords>>, JsValue> {
        plains(&kinds())
    }

    /// Returns the measures of faces.
    pub fn measures(&self) -> Result<Vec<Js<FaceMeasure>>, JsValue> {
        plains(FACE_MEASURES)
    }

    /// Returns the file formats of models.
    #[wasm_bindgen(js_name = fileFormats)]
    pub fn file_formats(&self) -> Result<Vec<Js<FileFormat>>, JsValue> {
        plains(FILE_FORMATS)
    }

    /// Returns the declared selection operations.
    pub fn operations(&self) -> Result<Vec<Js<Operation>>, JsValue> {
        plains(OPERATIONS)
    }

    /// Returns the declared settings of a scene.
    pub fn settings(&self) -> Result<Vec<Js<Setting>>, JsValue> {
        plains(SETTINGS)
    }

    /// Returns the numbers of the build that a lesson may bound.
    #[wasm_bindgen(js_name = buildNumbers)]
    pub fn build_numbers(&self) -> Result<Vec<Js<BuildNumber>>, JsValue> {
        plains(&BUILD_NUMBERS)
    }
}
