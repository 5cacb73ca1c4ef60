//! Sessions as hosts use them, from the first edit to undo.

#![allow(clippy::unwrap_used, reason = "a helper that fails here fails its test")]

#[path = "../support/fuzz.rs"]
mod fuzz;
#[path = "../support/grid.rs"]
mod grid;
#[path = "../support/meshes.rs"]
mod meshes;
#[path = "../support/shared.rs"]
mod shared;

mod asked;
mod collapse;
mod edits;
mod edits_json;
mod fairness;
mod halves;
mod improving;
mod kept_measures;
mod lessons;
mod locks;
mod make_panels;
mod measures;
mod offers;
mod operators;
mod own_mesh;
mod presentation;
mod presets;
mod refine;
mod regions;
mod remedies;
mod remesh;
mod replacing;
mod selecting;
mod shown;
mod stories;
mod tables;
mod undo;
mod variations;
mod worst;
