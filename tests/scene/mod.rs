//! The scene file.

mod asked;
mod file;
mod forecast;
mod fuzzed;
mod refused;
mod round_trip;
