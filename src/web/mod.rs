//! wasm-bindgen faces: one for the worker (feature `solver`), one for the page (feature `view`), one for what
//! comes before and after it: meshes to begin with, their curvature, and what is built of a shape (feature `build`).
//!
//! | file or folder | holds |
//! |---|---|
//! | `worker` | the face of the solver |
//! | `page` | the face of the view |
//! | `build` | the face of sheets and the build check |
//! | `begin` | the face of meshes to begin with |
//! | `curvature` | the face of lines of curvature |
//! | `plain` | between Rust and JavaScript |
//! | `warm_up` | what makes the first steps fast |

#[cfg(feature = "build")]
pub mod begin;
#[cfg(feature = "build")]
pub mod build;
#[cfg(feature = "build")]
pub mod curvature;
#[cfg(feature = "view")]
pub mod page;
#[cfg(feature = "solver")]
mod plain;
#[cfg(feature = "solver")]
pub mod warm_up;
#[cfg(feature = "solver")]
pub mod worker;

use wasm_bindgen::JsValue;

/// The error that a host sees: `{ message }`, one line that says all.
fn thrown(error: impl std::fmt::Display) -> JsValue {
    js_sys::Error::new(&error.to_string()).into()
}

/// As a plain object: maps become objects, absent values null.
#[cfg(any(feature = "solver", feature = "build"))]
fn plain_object(value: &impl serde::Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(thrown)
}

/// The mesh of `positions`, `#V by 3`, and faces: face `f` has the corners from `offsets[f]` to `offsets[f + 1]` of
/// `indices`.
#[cfg(feature = "build")]
fn mesh_of(positions: &[f64], offsets: &[u32], indices: &[u32]) -> crate::mesh::Mesh {
    let points = positions.chunks_exact(3).map(|point| [point[0], point[1], point[2]]);
    crate::mesh::Mesh {
        positions: points.collect(),
        faces: rows_of(offsets, indices),
        ..crate::mesh::Mesh::default()
    }
}

/// Row `i` has the entries from `offsets[i]` to `offsets[i + 1]` of `indices`.
#[cfg(feature = "build")]
fn rows_of(offsets: &[u32], indices: &[u32]) -> crate::mesh::Ragged {
    offsets.windows(2).map(|ends| &indices[ends[0] as usize..ends[1] as usize]).collect()
}

/// Writes panics to the console: the host sees only "unreachable" otherwise.
fn log_panics() {
    std::panic::set_hook(Box::new(|panic| web_sys::console::error_1(&panic.to_string().into())));
}
