//! Meshes: reading and writing files, topology, measures, closest points, Laplacians.

mod boundary_curves;
mod closest;
mod concave_faces;
mod curvature;
mod developable;
mod extrude;
mod files;
mod folds;
mod formats;
mod fuzzed;
mod guide_lines;
mod measure;
mod new_kinds;
mod openings;
mod operation_cost;
mod operation_refusals;
mod operations;
mod plan;
mod polygon_laplacian;
mod reading;
mod round_trip;
mod span;
mod strips;
mod subdivide;
mod topology;
