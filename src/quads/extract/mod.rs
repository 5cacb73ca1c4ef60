//! Exact extraction of the quads of an integer-grid map (Ebke, Bommes, Campen and Kobbelt 2013,
//! section 4): every question is answered by the sign of an integer, so that rounding can neither
//! lose a vertex nor invent one.
//!
//! | file | holds |
//! |---|---|
//! | `line` | directions of the grid, and the side of a line on which a point lies |
//! | `fan` | the triangles around each vertex, in order |
//! | `nodes` | points of the surface at which grid lines meet, or leave it |
//! | `ports` | the grid lines that begin at each node, counterclockwise |
//! | `trace` | the walk along a grid line to the next node |
//! | `links` | pairs of ports that are two ends of one edge |
//! | `cells` | the faces between the edges |
//! | `tests` | maps that are known |

mod cells;
mod fan;
mod line;
mod links;
mod nodes;
mod ports;
#[cfg(test)]
pub(in crate::quads) mod tests;
mod trace;

use super::grid_map::{GridMap, Triangulation};
use fan::Fans;
use links::link;
pub(super) use nodes::{Node, Place};
use ports::Ports;

/// The grid of a map on its surface.
#[derive(Clone, Debug)]
pub(super) struct Extraction {
    /// `#N`: the points where grid lines meet, or meet the boundary.
    pub(super) nodes: Vec<Node>,
    /// The faces, as nodes counterclockwise with the face on the left.
    pub(super) faces: Vec<Vec<usize>>,
}

/// Extracts the grid. Where triangles are flipped, lines can be lost: their walk does not end at a
/// node, or at one that leads back elsewhere. The faces around them are then larger, but every edge
/// still has a face, or the outside, on either side.
///
/// With `careful`, lines through flipped triangles count as lost, so that nothing wrong is linked.
pub(super) fn extract(surface: &Triangulation, map: &GridMap, careful: bool) -> Extraction {
    let fans = Fans::of(surface);
    let nodes = nodes::nodes(surface, map, &fans);
    let ports = Ports::of(surface, map, &fans, &nodes);
    let links = link(surface, map, &fans, &nodes, &ports, careful);
    let faces = cells::faces(&ports, &links);
    Extraction { nodes, faces }
}
