//! wasm-bindgen faces: `solver` for the worker, `view` for the page.

#[cfg(feature = "solver")]
mod report;
#[cfg(feature = "solver")]
pub mod solver;
#[cfg(feature = "view")]
pub mod view;
