//! The measurements of `operators.rs` and `stream.rs`, exported to a page.

#[cfg(target_arch = "wasm32")]
mod operators;
#[cfg(target_arch = "wasm32")]
mod stream;

/// A Markdown table of every kind.
#[cfg(target_arch = "wasm32")]
#[wasm_bindgen::prelude::wasm_bindgen]
pub fn operators() -> String {
    operators::table()
}

/// Milliseconds to read this number of bytes once; see [`stream::milliseconds`].
#[cfg(target_arch = "wasm32")]
#[wasm_bindgen::prelude::wasm_bindgen]
pub fn stream(bytes: usize) -> f64 {
    stream::milliseconds(bytes)
}
