//! The picture: camera, picking, and one primitive per file with its shader. Sees positions and
//! index buffers, never the solver.
//!
//! [`state`] and all before it know the mesh as it is shown, the camera, and what is picked or
//! marked; they need no GPU, so that native tests can hold them to account. [`gpu`] turns a state into
//! draw calls; it is compiled for the browser only. [`svg`] writes a state as SVG.
//!
//! | folder | holds |
//! |---|---|
//! | `model` | the mesh as it is shown |
//! | `camera` | where it is looked at from |
//! | `picking` | what is under the cursor or in front |
//! | `appearance` | colours |
//! | `gizmo` | arrows and squares with which a handle is dragged |
//! | `overlay` | ghost, ground, scale bar |
//! | `state` | everything that a picture shows, and what has changed since the last one |
//! | `side_by_side` | two pictures on one canvas: the flat map, the original |
//! | `svg` | pictures without a GPU |
//! | `gpu` | pictures with wgpu |
//!
//! Positions come in as `f64` in file coordinates. The view subtracts its own centre, the middle
//! of the first bounding box of the mesh, before it rounds to `f32`: a mesh at site coordinates
//! neither jitters nor loses digits.

pub mod appearance;
pub mod camera;
pub mod gizmo;
pub mod gpu;
pub mod model;
pub mod overlay;
pub mod picking;
pub mod side_by_side;
pub mod state;
pub mod svg;
