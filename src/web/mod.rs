//! wasm-bindgen faces: one for the worker (feature `solver`), one for the page (feature `view`).
//!
//! | file | holds |
//! |---|---|
//! | `solver` | the worker's face: the model that is open, its state, its numbers |
//! | `reading`, `edit`, `drag` | files in; edits and previews; handles that are dragged |
//! | `shown`, `original`, `report` | what is drawn and told of the session, and of what it was before |
//! | `selecting`, `lists`, `lesson` | selections and settings, lists of elements, goals |
//! | `saved` | steps of undo and unfinished work as bytes, to go on after a restart |
//! | `parametrize`, `experiment` | the flat map, the paper's comparisons |
//! | `remedies` | what would help where constraints are not met |
//! | `measure`, `warm_up` | what benchmarks ask; what makes the first steps fast |
//! | `plain` | between Rust and JavaScript |
//! | `view` | the page's face: the canvas and what is shown on it |
//! | `view_camera`, `view_picking`, `view_gizmo` | where it is looked from, what is under the cursor, what it holds |
//! | `view_map`, `view_split`, `view_seeing` | the flat map beside the model, two pictures, ways of seeing |

#[cfg(feature = "solver")]
mod drag;
#[cfg(feature = "solver")]
mod edit;
#[cfg(feature = "solver")]
pub mod experiment;
#[cfg(feature = "solver")]
mod lesson;
#[cfg(feature = "solver")]
mod lists;
#[cfg(feature = "solver")]
mod measure;
#[cfg(feature = "solver")]
mod original;
#[cfg(feature = "solver")]
mod parametrize;
#[cfg(feature = "solver")]
mod plain;
#[cfg(feature = "solver")]
mod reading;
#[cfg(feature = "solver")]
pub mod remedies;
#[cfg(feature = "solver")]
mod report;
#[cfg(feature = "solver")]
mod saved;
#[cfg(feature = "solver")]
mod selecting;
#[cfg(feature = "solver")]
mod shown;
#[cfg(feature = "solver")]
pub mod solver;
#[cfg(feature = "view")]
pub mod view;
#[cfg(feature = "view")]
mod view_camera;
#[cfg(feature = "view")]
mod view_gizmo;
#[cfg(feature = "view")]
mod view_map;
#[cfg(feature = "view")]
mod view_picking;
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
