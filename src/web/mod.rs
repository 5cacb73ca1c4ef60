//! wasm-bindgen interfaces: those of the engine (feature `engine`), which runs in workers, and those
//! of the view (feature `view`) and of words (feature `words`), which run in the page.
//!
//! | file or folder | holds |
//! |---|---|
//! | `worker` | the interface of the solver |
//! | `jobs` | the interface of what takes long, for the second worker |
//! | `page` | the interface of the view |
//! | `generate` | the interface of new meshes, and the files of the examples |
//! | `plan` | meshes from a plan, and the plan as it is drawn |
//! | `values` | values of Rust as those of JavaScript, with their TypeScript types, and back |
//! | `words` | numbers and lengths in words, for the page |
//! | `warm_up` | iterations that make V8 optimise the solver |

#[cfg(feature = "engine")]
pub mod generate;
#[cfg(feature = "engine")]
pub mod jobs;
#[cfg(feature = "view")]
pub mod page;
#[cfg(feature = "engine")]
pub mod plan;
#[cfg(feature = "engine")]
mod values;
#[cfg(feature = "engine")]
pub mod warm_up;
#[cfg(feature = "words")]
pub mod words;
#[cfg(feature = "engine")]
pub mod worker;

use wasm_bindgen::JsValue;

/// Returns the JavaScript `Error` for an error, whose message is one complete line.
fn thrown(error: impl std::fmt::Display) -> JsValue {
    js_sys::Error::new(&error.to_string()).into()
}

/// Creates the mesh of `positions`, `#V by 3`, and faces: face `f` has the corners from
/// `offsets[f]` to `offsets[f + 1]` of `indices`.
#[cfg(feature = "engine")]
fn mesh_of(positions: &[f64], offsets: &[u32], indices: &[u32]) -> crate::mesh::Mesh {
    let points = positions.chunks_exact(3).map(|point| [point[0], point[1], point[2]]);
    crate::mesh::Mesh {
        positions: points.collect(),
        faces: rows_of(offsets, indices),
        ..crate::mesh::Mesh::default()
    }
}

/// Creates rows: row `i` has the entries from `offsets[i]` to `offsets[i + 1]` of `indices`.
#[cfg(feature = "engine")]
fn rows_of(offsets: &[u32], indices: &[u32]) -> crate::mesh::Ragged {
    offsets.windows(2).map(|ends| &indices[ends[0] as usize..ends[1] as usize]).collect()
}

/// Writes panics to the console; the page otherwise sees only "unreachable".
#[cfg(any(feature = "engine", feature = "view"))]
fn log_panics() {
    std::panic::set_hook(Box::new(|panic| web_sys::console::error_1(&panic.to_string().into())));
}
