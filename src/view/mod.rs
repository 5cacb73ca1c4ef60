//! The picture: camera, picking, and one file with its shader for each drawing primitive. It uses
//! positions and index buffers, never the solver.
//!
//! [`state`] and the modules that it builds on hold the displayed mesh, the camera, and what is
//! picked or marked. They need no GPU, so that native tests can check them. [`gpu`] turns a state
//! into draw calls and is compiled for the browser only. [`line_drawing`] draws the lines of a
//! state for print.
//!
//! | file or folder | holds |
//! |---|---|
//! | `model` | the mesh as it is drawn |
//! | `camera` | the camera |
//! | `picking` | elements under the cursor, and visibility |
//! | `appearance` | colours |
//! | `gizmo` | arrows and squares for dragging handles |
//! | `overlay` | ghost, ground, scale bar |
//! | `state` | the state that determines a picture, and what has changed since the last one |
//! | `pictures` | the model, and its flat map beside it on one canvas |
//! | `line_drawing` | the line drawing for print, as SVG |
//! | `gpu` | pictures with wgpu |
//!
//! Positions arrive as `f64` in file coordinates. The view subtracts the centre of the first
//! bounding box of the mesh before rounding to `f32`, so that a mesh at site coordinates neither
//! jitters nor loses digits.

pub mod appearance;
pub mod camera;
pub mod gizmo;
pub mod gpu;
pub mod line_drawing;
pub mod model;
pub mod overlay;
pub mod picking;
pub mod pictures;
pub mod state;
