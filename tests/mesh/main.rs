//! Meshes: reading and writing files, topology, measures, closest points, Laplacians.

#![allow(clippy::unwrap_used, reason = "a helper that fails here fails its test")]

#[path = "../support/fuzz.rs"]
mod fuzz;
#[path = "../support/grid.rs"]
mod grid;
#[path = "../support/meshes.rs"]
mod meshes;
#[path = "../support/random.rs"]
mod random;
#[path = "../support/shared.rs"]
mod shared;

mod begin;
mod boundary_curves;
mod closest;
mod curvature;
mod curvature_lines;
mod developable;
mod files;
mod folds;
mod fuzzed;
mod measure;
mod operation_cost;
mod operations;
mod plan;
mod polygon_laplacian;
mod reading;
mod round_trip;
mod span;
mod strips;
mod subdivide;
mod topology;
