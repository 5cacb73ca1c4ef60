//! wasm-bindgen faces: `solver` for the worker, `view` for the page.
