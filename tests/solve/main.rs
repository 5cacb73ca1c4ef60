//! The solver: energies, factors, hard constraints and maps, against definitions and an independent
//! implementation.

#![allow(clippy::unwrap_used, reason = "a helper that fails here fails its test")]

#[path = "../support/fuzz.rs"]
mod fuzz;
#[path = "../support/grid.rs"]
mod grid;
#[path = "../support/hard.rs"]
mod hard;
#[path = "../support/meshes.rs"]
mod meshes;
#[path = "../support/project.rs"]
mod project;
#[path = "../support/random.rs"]
mod random;
#[path = "../support/shared.rs"]
mod shared;

mod conformal;
mod descent;
mod energies;
mod exact;
mod exact_boundary;
mod exact_limits;
mod expected;
mod factor;
mod improve;
mod precision;
mod registration;
mod variation;
