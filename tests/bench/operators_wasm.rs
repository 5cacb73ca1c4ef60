//! The measurements of `operators.rs`, offered to a page.

#[cfg(target_arch = "wasm32")]
mod operators;

/// A table in Markdown of every kind.
#[cfg(target_arch = "wasm32")]
#[wasm_bindgen::prelude::wasm_bindgen]
pub fn operators() -> String {
    operators::table()
}
