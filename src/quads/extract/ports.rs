//! The ports: grid lines, and the two pieces of the boundary, that begin at a node, counterclockwise
//! around it.

use super::fan::Fans;
use super::line::{
    Direction, GridPoint, across, directions_between, directions_left_of, is_integral,
};
use super::nodes::{Node, Place, minus};
use crate::quads::grid_map::{GridMap, Side, Triangulation};

/// What begins at a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Line {
    /// A grid line, in the coordinates of the triangle.
    Grid(Direction),
    /// The boundary, with the surface on the left.
    BoundaryAhead,
    /// The same boundary in the other direction.
    BoundaryBehind,
}

/// The beginning of a line at a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Port {
    /// Index of the node.
    pub(super) node: usize,
    /// A triangle with the node, into which the line runs.
    pub(super) triangle: usize,
    /// The node in its coordinates.
    pub(super) point: GridPoint,
    pub(super) line: Line,
}

/// All ports, node by node, counterclockwise; at a boundary node from the outside to the outside.
pub(super) struct Ports {
    pub(super) all: Vec<Port>,
    /// `#N + 1`.
    offsets: Vec<usize>,
    /// `#N`: whether the outside lies between the last port of a node and its first.
    pub(super) open: Vec<bool>,
}

impl Ports {
    /// Finds the ports of all nodes. At a vertex of index I there are 4 - I.
    pub(super) fn of(surface: &Triangulation, map: &GridMap, fans: &Fans, nodes: &[Node]) -> Ports {
        let mut ports = Ports { all: Vec::new(), offsets: vec![0], open: Vec::new() };
        for (index, node) in nodes.iter().enumerate() {
            match node.place {
                Place::Vertex(v) => ports.at_vertex(map, fans, index, v),
                Place::Side(side) => ports.on_side(surface, map, index, side, node.point),
                Place::Inside(triangle) => {
                    (0..4).for_each(|d| ports.push(index, triangle, node.point, Line::Grid(d)));
                }
            }
            ports.offsets.push(ports.all.len());
            ports.open.push(node.boundary);
        }
        ports
    }

    /// The indices of the ports of a node.
    pub(super) fn of_node(&self, node: usize) -> std::ops::Range<usize> {
        self.offsets[node]..self.offsets[node + 1]
    }

    /// The port of a node that begins in a triangle in a direction.
    pub(super) fn find(&self, node: usize, triangle: usize, line: Line) -> Option<usize> {
        self.of_node(node).find(|&p| self.all[p].triangle == triangle && self.all[p].line == line)
    }

    fn push(&mut self, node: usize, triangle: usize, point: GridPoint, line: Line) {
        self.all.push(Port { node, triangle, point, line });
    }

    fn at_vertex(&mut self, map: &GridMap, fans: &Fans, node: usize, v: usize) {
        let fan = fans.of_vertex(v);
        let (first, last) = (fan[0], fan[fan.len() - 1]);
        let open = !fans.is_closed(v);
        let corner = |at: Side| map.corners[at.triangle][at.side];
        if open {
            self.push(node, first.triangle, corner(first), Line::BoundaryAhead);
        }
        for &at in fan.iter().filter(|at| map.doubled_area(at.triangle) > 0) {
            let corners = map.corners[at.triangle];
            let point = corners[at.side];
            let [a, b] = [1, 2].map(|k| minus(corners[(at.side + k) % 3], point));
            for d in directions_between(a, b, [!open || at != first, false]) {
                if is_integral(point[across(d)]) {
                    self.push(node, at.triangle, point, Line::Grid(d));
                }
            }
        }
        if open {
            self.push(node, last.triangle, corner(last), Line::BoundaryBehind);
        }
    }

    fn on_side(
        &mut self,
        surface: &Triangulation,
        map: &GridMap,
        node: usize,
        side: Side,
        point: GridPoint,
    ) {
        let other = surface.across(side);
        let open = other.is_none();
        if open {
            self.push(node, side.triangle, point, Line::BoundaryAhead);
        }
        let halves = [Some((side, point)), other.map(|at| (at, across_side(map, side, point)))];
        for (Side { triangle, side }, point) in halves.into_iter().flatten() {
            if map.doubled_area(triangle) <= 0 {
                continue;
            }
            let corners = map.corners[triangle];
            let along = minus(corners[(side + 1) % 3], corners[side]);
            for d in directions_left_of(along, [!open, false]) {
                if is_integral(point[across(d)]) {
                    self.push(node, triangle, point, Line::Grid(d));
                }
            }
        }
        if open {
            self.push(node, side.triangle, point, Line::BoundaryBehind);
        }
    }
}

/// The image of a point of a side in the coordinates of the neighbour.
fn across_side(map: &GridMap, side: Side, point: GridPoint) -> GridPoint {
    map.transitions[side.triangle][side.side].apply(point)
}
