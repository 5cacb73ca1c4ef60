//! Pairs of ports: the two ends of each edge of the grid.

use super::fan::Fans;
use super::line::{across, turned};
use super::nodes::{Node, Place, is_cut};
use super::ports::{Line, Port, Ports};
use super::trace::{Arrival, Shift, Start, back, trace};
use crate::quads::grid_map::{GridMap, Side, Triangulation};

/// The other end of each port, `#P`: an involution without fixed points on the ports that have one.
pub(super) type Links = Vec<Option<usize>>;

/// Follows the line of each port to the port at its end, and pairs them.
pub(super) fn link(
    surface: &Triangulation,
    map: &GridMap,
    fans: &Fans,
    nodes: &[Node],
    ports: &Ports,
    careful: bool,
) -> Links {
    let search = Search { surface, map, fans, nodes, ports, on: Points::of(surface, fans, nodes) };
    let mut ends: Vec<Option<usize>> =
        ports.all.iter().map(|port| search.end(port, careful)).collect();
    search.along_boundary(&mut ends);
    let mut other = vec![None; ends.len()];
    let is_mutual = |p: usize, q: usize| ends[q] == Some(p);
    // Pairs of which both ends agree, then those of which only one has an end.
    for mutual in [true, false] {
        for (p, end) in ends.iter().enumerate() {
            let Some(q) = *end else { continue };
            let free = other[p].is_none() && other[q].is_none() && p != q;
            if free && (is_mutual(p, q) || !mutual && ends[q].is_none()) {
                other[p] = Some(q);
                other[q] = Some(p);
            }
        }
    }
    other
}

/// The nodes of each triangle, with those on its sides and corners.
struct Points {
    /// `#T`.
    of_triangle: Vec<Vec<usize>>,
}

impl Points {
    fn of(surface: &Triangulation, fans: &Fans, nodes: &[Node]) -> Points {
        let mut of_triangle = vec![Vec::new(); surface.triangles.len()];
        for (index, node) in nodes.iter().enumerate() {
            match node.place {
                Place::Vertex(v) => {
                    fans.of_vertex(v).iter().for_each(|at| of_triangle[at.triangle].push(index));
                }
                Place::Side(side) => {
                    let both = [Some(side), surface.across(side)];
                    both.iter().flatten().for_each(|at| of_triangle[at.triangle].push(index));
                }
                Place::Inside(triangle) => of_triangle[triangle].push(index),
            }
        }
        Points { of_triangle }
    }
}

struct Search<'a> {
    surface: &'a Triangulation,
    map: &'a GridMap,
    fans: &'a Fans,
    nodes: &'a [Node],
    ports: &'a Ports,
    on: Points,
}

impl Search<'_> {
    /// The port at the other end of the line of a port.
    fn end(&self, port: &Port, careful: bool) -> Option<usize> {
        let &Port { triangle, point, line: Line::Grid(direction), .. } = port else { return None };
        let start = Start { triangle, point, direction };
        [Shift::Left, Shift::Right].into_iter().find_map(|shift| {
            let arrival = trace(self.surface, self.map, start, shift)?;
            if careful && arrival.flipped {
                return None;
            }
            match arrival.leaves {
                None => self.node_at(&arrival).and_then(|node| self.port_of(node, &arrival)),
                Some(side) => self.crossing(&arrival, side),
            }
        })
    }

    /// The node at the grid point of an arrival.
    fn node_at(&self, arrival: &Arrival) -> Option<usize> {
        let on = self.on.of_triangle[arrival.triangle].iter().copied();
        on.into_iter().find(|&node| self.point_in(node, arrival.triangle) == Some(arrival.point))
    }

    /// The coordinates of a node in a triangle that contains it.
    fn point_in(&self, node: usize, triangle: usize) -> Option<[i64; 2]> {
        let Node { place, point, .. } = self.nodes[node];
        match place {
            Place::Inside(_) => Some(point),
            Place::Vertex(v) => {
                let corner = (0..3).find(|&k| self.surface.corner(triangle, k) == v)?;
                Some(self.map.corners[triangle][corner])
            }
            Place::Side(side) if side.triangle == triangle => Some(point),
            Place::Side(side) => Some(self.map.transitions[side.triangle][side.side].apply(point)),
        }
    }

    /// The port of a node that leads back: in the triangle of the arrival or, if the line runs along
    /// a side, in the neighbour over it.
    fn port_of(&self, node: usize, arrival: &Arrival) -> Option<usize> {
        let direction = back(arrival);
        let here = self.ports.find(node, arrival.triangle, Line::Grid(direction));
        here.or_else(|| {
            (0..3).find_map(|side| {
                let side = Side { triangle: arrival.triangle, side };
                let next = self.surface.across(side)?.triangle;
                let there = turned(direction, self.map.transitions[side.triangle][side.side]);
                let found = self.ports.find(node, next, Line::Grid(there))?;
                self.is_on(node, side).then_some(found)
            })
        })
    }

    /// Whether a node lies on a side or at an end of it.
    fn is_on(&self, node: usize, side: Side) -> bool {
        match self.nodes[node].place {
            Place::Vertex(v) => {
                (0..2).any(|k| self.surface.corner(side.triangle, side.side + k) == v)
            }
            Place::Side(at) => at == side || self.surface.across(at) == Some(side),
            Place::Inside(_) => false,
        }
    }

    /// The port of the node at which a line leaves the surface over a boundary that cuts the grid.
    fn crossing(&self, arrival: &Arrival, side: usize) -> Option<usize> {
        let side = Side { triangle: arrival.triangle, side };
        if !is_cut(self.surface, side) {
            return None;
        }
        let direction = back(arrival);
        let axis = across(direction);
        let nodes = self.on.of_triangle[side.triangle].iter().copied();
        let mut on_line = nodes.filter(|&node| {
            let point = self.point_in(node, side.triangle);
            self.is_on(node, side) && point.is_some_and(|p| p[axis] == arrival.point[axis])
        });
        on_line.find_map(|node| self.port_of(node, arrival))
    }

    /// Links the nodes along each boundary loop.
    fn along_boundary(&self, ends: &mut [Option<usize>]) {
        for index in (0..self.nodes.len()).filter(|&index| self.nodes[index].boundary) {
            let Some(next) = self.following(index) else { continue };
            let ahead = self.ports.of_node(index).start;
            let behind = self.ports.of_node(next).end - 1;
            ends[ahead] = Some(behind);
            ends[behind] = Some(ahead);
        }
    }

    /// The next node along the boundary.
    fn following(&self, index: usize) -> Option<usize> {
        let mut side = match self.nodes[index].place {
            Place::Vertex(v) => self.fans.of_vertex(v)[0],
            Place::Side(side) => side,
            Place::Inside(_) => return None,
        };
        let is_inside = |node: &usize| self.nodes[*node].place == Place::Side(side);
        // The nodes inside a side follow each other in the list, in their order along it.
        if self.nodes.get(index + 1).is_some_and(|_| is_inside(&(index + 1)))
            && self.nodes[index].place == Place::Side(side)
        {
            return Some(index + 1);
        }
        let mut begins_here = matches!(self.nodes[index].place, Place::Vertex(_));
        for _ in 0..self.surface.triangles.len() {
            let on = &self.on.of_triangle[side.triangle];
            if begins_here
                && let Some(&node) = on.iter().find(|&&n| self.nodes[n].place == Place::Side(side))
            {
                return Some(node);
            }
            let end = self.surface.corner(side.triangle, side.side + 1);
            if let Some(&node) = on.iter().find(|&&n| self.nodes[n].place == Place::Vertex(end)) {
                return Some(node);
            }
            side = self.fans.of_vertex(end)[0];
            begins_here = true;
        }
        None
    }
}
