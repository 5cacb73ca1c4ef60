//! The files of the examples: the page makes them when they are opened, so that a visit neither
//! fetches nor keeps them, and its build writes them all.

use super::thrown;
use crate::experiment::{example_file, example_files};
use wasm_bindgen::prelude::*;

/// Returns the bytes of an example's scene or mesh by the name of the file.
///
/// # Errors
/// If no example has a file of that name.
#[wasm_bindgen(js_name = exampleFile)]
pub fn file(name: &str) -> Result<Vec<u8>, JsValue> {
    let text = example_file(name);
    Ok(text.ok_or_else(|| thrown(format!("there is no example file {name:?}")))?.into_bytes())
}

/// Returns the names and texts of the files of all examples.
///
/// # Errors
/// None: the texts are plain strings.
#[wasm_bindgen(js_name = exampleFiles, unchecked_return_type = "[string, string][]")]
pub fn files() -> Result<JsValue, JsValue> {
    serde_wasm_bindgen::to_value(&example_files()).map_err(thrown)
}
