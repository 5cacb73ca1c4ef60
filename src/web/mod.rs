//! wasm-bindgen faces: `solver` for the worker, `view` for the page.

#[cfg(feature = "view")]
pub mod view;
