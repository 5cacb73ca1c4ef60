//! The scene file, version 1, as JSON in and out; the README shows one.
//!
//! An error names its JSON path, with what was found and what was expected. Here the
//! form is checked; whether indices and names fit the mesh is checked by `validate`.
//!
//! # The file
//!
//! Only `format`, `version` and `mesh` are required. Indices count from 0; a list of them is an array
//! or a string of ranges, `"0-199,240"`.
//!
//! | key | holds |
//! |---|---|
//! | "mesh" | `{ "file": PATH }`, relative to the scene, or `{ "positions", "faces", "curves", "tets", "groups" }` |
//! | "current" | `#V by 3`, where the iteration starts; without it, at the design of `variants`, or at rest |
//! | "sets" | `{ NAME: { "vertices": LIST } }` or `{ NAME: { "faces": LIST } }` |
//! | "constraints" | `kind`, `on`, `weight` (1), `enabled` (true), `name`, `require` (`"soft"`, `"exact"` or `{ "within": LENGTH }`), `eased` (`{ "within": LENGTH, "faces": LIST }`: faces that are met within a larger length than the others), and the parameters of the kind |
//! | "handles" | `vertices`, `targets` (the rest positions), and `weight` (100) or `"fixed": true` |
//! | "weights" | `shape`, `close`, `smooth`: the weights of Eq. 13, by default 1, 0, 0 |
//! | "closeness" | `"to"`: `"surface"`, `"rest"`, `"none"`, or another surface, `{ "mesh": ... }` as the scene's own or the path of its file; `"weights"` of single sets; `"boundary"`: of its vertices to their curves, `corners` (45 degrees), `require` (`"soft"` or `"exact"`), `weight` (1, where it is soft) |
//! | "smoothness" | `"of"`: `"surface"` or `"displacement"`; `"weighting"`: `"auto"`, `"uniform"`, `"cotangent"` (triangles) or `"polygon"` (any faces) |
//! | "solver" | `iterations`, `tolerance`, `accelerator` (`"quasi-newton"`, `"anderson"`, `"none"`), `window`, `mean_centring`, `monotone`, `factorization` (`"auto"`, `"supernodal"`, `"sprs-ldl"`), `shortest_edge` (0 to 1, or null) |
//! | "lesson" | a text and goals |
//! | "build" | what is to be made of the shape: `kind`, `distance`, `follow`, `joint`, `scale`, `sheet`, ... ([`crate::fabricate::BuildSettings`]) |
//! | "steps" | a presentation: of each step `title`, `text`, `notes` for who presents, and what it shows: `camera`, `parallel`, `measure`, `original` (the rest shape) or `variant`, `weights`, `run` ([`crate::scene::Slide`]) |
//! | "variants" | shapes that were kept: `kept`, at most 12 of `{ "name", "positions" }`, and `design`, the place of the one that closeness and smoothness hold the shape to instead of the rest shape |
//!
//! | on | one constraint for |
//! |---|---|
//! | "faces", "edges", "tets" | each face, edge, tetrahedron |
//! | "rings", "stars" | each vertex with its neighbours; with them in their order around it |
//! | "corners", "hinges" | each corner of a face, each edge with the corners opposite to it |
//! | "boundary", "strips" | each boundary loop, each strip of quads |
//! | "polylines" | each polyline of the file |
//! | "edge-lines" | on a mesh of quads each straight line of edges |
//! | "curves" | both; of two of which one runs along the other, the longer |
//! | { "each": "face", "in": NAME } | each of them in a set or group; "each": "group" is each group |
//! | { "each": "ring", "radius": 2 } | each, with so many rings of neighbours |
//! | { "set": NAME }, { "vertices": LIST } | all these vertices together |
//!
//! # The code
//!
//! | file | holds |
//! |---|---|
//! | `file` | format and version, before what is in the file |
//! | `mesh` | a mesh inside the scene |
//! | `constraint`, `selector` | one entry of the list of constraints; the forms of `on` |
//! | `closeness` | what vertices are kept close to |
//! | `handle` | one entry of the list of handles |
//! | `lesson` | the exercise that a scene is, and the results that are handed in |
//! | `write` | the scene as text |
//! | `text` | JSON as text |

mod closeness;
mod constraint;
mod file;
mod handle;
mod lesson;
mod mesh;
mod selector;
mod text;
mod write;

pub use file::{FORMAT, VERSION};
