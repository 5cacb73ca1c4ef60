//! The files of the examples, which the build of the page writes with the module that it ships.

use super::thrown;
use crate::experiment::example_files;
use wasm_bindgen::prelude::*;

/// Returns the names and texts of the files of all examples.
///
/// # Errors
/// None: the texts are plain strings.
#[wasm_bindgen(js_name = exampleFiles, unchecked_return_type = "[string, string][]")]
pub fn files() -> Result<JsValue, JsValue> {
    serde_wasm_bindgen::to_value(&example_files()).map_err(thrown)
}
