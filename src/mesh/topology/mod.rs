//! How vertices, edges and faces are connected, and lines and regions that follow from it.
//!
//! | file | holds |
//! |---|---|
//! | `adjacency` | edges, neighbours, rings, faces around edges and vertices |
//! | `boundary` | boundary loops |
//! | `components` | connected components |
//! | `curves` | polylines and edge lines that run along each other |
//! | `edge_lines` | straight lines of edges through regular vertices |
//! | `feature_curves` | creases: lines along which the surface turns sharply |
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
