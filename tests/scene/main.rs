//! The scene file.

#![allow(clippy::unwrap_used, reason = "a helper that fails here fails its test")]

#[path = "../support/fuzz.rs"]
mod fuzz;
#[path = "../support/grid.rs"]
mod grid;
#[path = "../support/random.rs"]
mod random;
#[path = "../support/shared.rs"]
mod shared;

mod asked;
mod file;
mod forecast;
mod fuzzed;
mod refused;
mod round_trip;
