//! wasm-bindgen faces: `solver` for the worker, `view` for the page.

#[cfg(feature = "solver")]
mod report;
#[cfg(feature = "solver")]
pub mod solver;

use wasm_bindgen::prelude::*;

/// The error that a host sees: `{ message }`, one line that says all.
pub(crate) fn thrown(error: impl std::fmt::Display) -> JsValue {
    js_sys::Error::new(&error.to_string()).into()
}
