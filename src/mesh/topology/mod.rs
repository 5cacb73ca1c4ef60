//! Connectivity of vertices, edges and faces, and curves and regions derived from it.
//!
//! | file | holds |
//! |---|---|
//! | `adjacency` | edges, neighbours, rings, faces at edges and vertices |
//! | `boundary` | boundary loops |
//! | `components` | connected components |
//! | `curves` | polylines and edge lines that duplicate each other |
//! | `edge_lines` | lines of edges through regular vertices |
//! | `feature_curves` | creases, boundary and non-manifold edges as curves |
//! | `local` | corners of faces, stars of vertices, hinges |
//! | `strips` | strips of quads |

mod adjacency;
mod boundary;
mod components;
mod curves;
mod edge_lines;
mod feature_curves;
mod local;
mod strips;

pub use adjacency::Topology;
pub use components::components;
pub use curves::{Repeated, repeated};
pub use edge_lines::edge_lines;
pub use feature_curves::feature_curves;
pub use local::{corners, hinges, stars};
pub use strips::strips;
