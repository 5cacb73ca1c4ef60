//! Operators and selectors: properties of every kind, and of single kinds.

#![allow(clippy::unwrap_used, reason = "a helper that fails here fails its test")]

#[path = "../support/degenerate.rs"]
mod degenerate;
#[path = "../support/fuzz.rs"]
mod fuzz;
#[path = "../support/grid.rs"]
mod grid;
#[path = "../support/meshes.rs"]
mod meshes;
#[path = "../support/minimise.rs"]
mod minimise;
#[path = "../support/project.rs"]
mod project;
#[path = "../support/random.rs"]
mod random;
#[path = "../support/shapes/mod.rs"]
mod shapes;

mod cases;
mod conformance;
mod radius;
mod rectangle;
mod relative;
mod round;
mod selectors;
mod sketch;
