//! wasm-bindgen faces: `solver` for the worker, `view` for the page.

#[cfg(feature = "solver")]
mod drag;
#[cfg(feature = "solver")]
pub mod experiment;
#[cfg(feature = "solver")]
mod lists;
#[cfg(feature = "solver")]
mod measure;
#[cfg(feature = "solver")]
mod original;
#[cfg(feature = "solver")]
mod page_edit;
#[cfg(feature = "solver")]
mod parametrize;
#[cfg(feature = "solver")]
mod report;
#[cfg(feature = "solver")]
mod seeing;
#[cfg(feature = "solver")]
mod selecting;
#[cfg(feature = "solver")]
pub mod solver;
#[cfg(feature = "view")]
pub mod view;
#[cfg(feature = "view")]
mod view_gizmo;
#[cfg(feature = "view")]
mod view_map;
#[cfg(feature = "view")]
mod view_seeing;
#[cfg(feature = "view")]
mod view_split;
#[cfg(feature = "solver")]
pub mod warm_up;

use wasm_bindgen::JsValue;

/// The error that a host sees: `{ message }`, one line that says all.
fn thrown(error: impl std::fmt::Display) -> JsValue {
    js_sys::Error::new(&error.to_string()).into()
}

/// Writes panics to the console: the host sees only "unreachable" otherwise.
fn log_panics() {
    std::panic::set_hook(Box::new(|panic| web_sys::console::error_1(&panic.to_string().into())));
}
