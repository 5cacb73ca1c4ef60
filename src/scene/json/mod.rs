//! Reading and writing the scene file, version 1, as JSON.
//!
//! Errors give the JSON path, the value found and the value expected. This module checks the form;
//! `validate` checks indices and names against the mesh.
//!
//! # The file
//!
//! Only `format`, `version` and `mesh` are required; defaults are in brackets. Indices count from
//! 0; a list of indices is an array or a string of ranges, `"0-199,240"`.
//!
//! ```json
//! { "format": "shape-up-scene", "version": 1, "title": "Roof", "units": "m", "up": "z",
//!   "mesh": { "file": "roof.obj" },
//!   "sets": { "eaves": { "vertices": "0-20,41" }, "skylight": { "faces": [7, 8, 9] } },
//!   "constraints": [
//!     { "kind": "circle", "on": "faces", "weight": 1 },
//!     { "kind": "similar", "on": { "each": "ring", "radius": 1, "in": "eaves" }, "scale": [0.8, 1.25] },
//!     { "kind": "sphere", "on": { "set": "eaves" }, "weight": 2, "name": "Dome" },
//!     { "kind": "plane", "on": { "vertices": [3, 5, 8, 13] } } ],
//!   "handles": [ { "vertices": [12], "targets": [[1.2, 0.4, 2.5]], "weight": 100 },
//!                { "vertices": "0-3", "fixed": true } ],
//!   "weights": { "shape": 5, "close": 10, "smooth": 2 },
//!   "closeness": { "to": "surface" },
//!   "smoothness": { "of": "surface", "weighting": "auto" },
//!   "solver": { "iterations": 200, "tolerance": 1e-9, "accelerator": "quasi-newton" } }
//! ```
//!
//! | key | holds |
//! |---|---|
//! | "mesh" | `{ "file": PATH }`, relative to the scene, or `{ "positions", "faces", "curves", "tets", "groups" }` |
//! | "tolerance" | the distance within which panels have their shape (what their constraint requires, else about a thousandth of the mean edge) |
//! | "current" | start positions of the iteration, `#V by 3` (the design of `variants`, else the rest positions) |
//! | "pose" | another pose that constraints take rest shapes from: `{ "file": PATH }` or `{ "positions": ... }` |
//! | "attempt" | by which attempt of a search the settings came about ([`crate::scene::ChosenAttempt`]) |
//! | "sets" | `{ NAME: { "vertices": LIST } }` or `{ NAME: { "faces": LIST } }` |
//! | "constraints" | `kind`, `on`, `weight` (1), `enabled` (true), `name`, `require` (`"soft"`, `"exact"` or `{ "within": LENGTH }`), `eased` (`{ "within": LENGTH, "faces": LIST }`: faces with a larger tolerance), and the parameters of the kind |
//! | "handles" | `vertices`, `targets` (the rest positions), and `weight` (100) or `"fixed": true` |
//! | "weights" | `shape`, `close`, `smooth`: the weights of Eq. 13, by default 1, 0, 0 |
//! | "closeness" | `"to"`: `"surface"`, `"rest"`, `"none"`, or another surface, `{ "mesh": ... }` like the mesh of the scene or the path of its file, which is kept as `"target"` while `to` is a word; `"weights"`: factors of selections; `"boundary"`: closeness of boundary vertices to the boundary curves, `corners` (45 degrees), `require` (`"soft"`, `"exact"` or `"off"`, as without it), `weight` (1, if soft) |
//! | "smoothness" | `"of"`: `"surface"` or `"displacement"`; `"weighting"`: `"auto"`, `"uniform"`, `"cotangent"` (triangles) or `"polygon"` (any faces) |
//! | "solver" | `iterations`, `tolerance`, `accelerator` (`"quasi-newton"`, `"anderson"`, `"none"`), `window`, `mean_centring`, `monotone`, `factorization` (`"auto"`, `"supernodal"`, `"sprs-ldl"`), `shortest_edge` (0 to 1, or null) |
//! | "lesson" | a task, goals, and the parts of the scene that are locked |
//! | "build" | settings of the parts to build: `kind`, `distance`, `follow`, `joint`, `scale`, `sheet`, `seams`, ... ([`crate::scene::BuildSettings`]) |
//! | "steps" | a presentation; each step has `title`, `text`, `notes`, and what it shows: `camera`, `parallel`, `measure`, `original` (the rest shape) or `variant`, `weights`, `run` ([`crate::scene::Slide`]) |
//! | "variants" | shapes that the user kept: `kept`, at most 12 of `{ "name", "positions" }`, and `design`, the index of the one that closeness and smoothness refer to instead of the rest shape |
//!
//! | on | one constraint for |
//! |---|---|
//! | "faces", "edges", "tets" | each face, edge, tetrahedron |
//! | "rings" | each vertex with its neighbours |
//! | "stars" | each vertex with its neighbours in cyclic order |
//! | "corners", "hinges" | each corner of a face, each edge with the corners opposite to it |
//! | "boundary", "strips" | each boundary loop, each strip of quads |
//! | "polylines" | each polyline of the file |
//! | "edge-lines" | each edge line of a quad-dominant mesh |
//! | "curves" | each polyline and edge line; if one contains another, only the longer |
//! | { "each": "face", "in": NAME } | each face in a set or group; "each": "group" is each group |
//! | { "each": "ring", "radius": 2 } | each vertex with two rings of neighbours |
//! | { "set": NAME }, { "vertices": LIST } | all these vertices together |
//!
//! # The code
//!
//! | file | holds |
//! |---|---|
//! | `file` | checks of format and version, and writing |
//! | `layout` | the layout of what is written |
//! | `mesh` | an inline mesh |
//! | `closeness` | the target of the closeness energy |
//! | `constraint` | an entry of the lists of constraints and handles |
//! | `selector` | the forms of `on` |

mod closeness;
mod constraint;
mod file;
mod layout;
mod mesh;
mod selector;

pub(crate) use constraint::kind_of;
pub use file::{FORMAT, VERSION};
