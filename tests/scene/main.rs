//! The scene file.

#![allow(clippy::unwrap_used, reason = "a helper that fails here fails its test")]

#[path = "../support/fuzz.rs"]
mod fuzz;

mod asked;
mod file;
mod fuzzed;
mod round_trip;
