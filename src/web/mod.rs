//! wasm-bindgen interfaces: one for the worker (feature `solver`), one for the page (feature
//! `view`), one for new meshes, curvature, and fabrication (feature `build`).
//!
//! | file or folder | holds |
//! |---|---|
//! | `worker` | the interface of the solver |
//! | `page` | the interface of the view |
//! | `build` | the interface of sheets and the build check |
//! | `begin` | the interface of new meshes |
//! | `curvature` | the interface of lines of curvature |
//! | `plain` | conversions between Rust and JavaScript |
//! | `warm_up` | iterations that make V8 optimise the solver |

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

/// Returns the JavaScript `Error` for an error, whose message is one complete line.
fn thrown(error: impl std::fmt::Display) -> JsValue {
    js_sys::Error::new(&error.to_string()).into()
}

/// Converts to a plain object: maps become objects, absent values null.
#[cfg(any(feature = "solver", feature = "build"))]
fn plain_object(value: &impl serde::Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(thrown)
}

/// Creates the mesh of `positions`, `#V by 3`, and faces: face `f` has the corners from
/// `offsets[f]` to `offsets[f + 1]` of `indices`.
#[cfg(feature = "build")]
fn mesh_of(positions: &[f64], offsets: &[u32], indices: &[u32]) -> crate::mesh::Mesh {
    let points = positions.chunks_exact(3).map(|point| [point[0], point[1], point[2]]);
    crate::mesh::Mesh {
        positions: points.collect(),
        faces: rows_of(offsets, indices),
        ..crate::mesh::Mesh::default()
    }
}

/// Creates rows: row `i` has the entries from `offsets[i]` to `offsets[i + 1]` of `indices`.
#[cfg(feature = "build")]
fn rows_of(offsets: &[u32], indices: &[u32]) -> crate::mesh::Ragged {
    offsets.windows(2).map(|ends| &indices[ends[0] as usize..ends[1] as usize]).collect()
}

/// Writes panics to the console; the page otherwise sees only "unreachable".
fn log_panics() {
    std::panic::set_hook(Box::new(|panic| web_sys::console::error_1(&panic.to_string().into())));
}
