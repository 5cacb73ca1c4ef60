//! The faces between the edges of the grid.
//!
//! Ports in counterclockwise order around nodes, in pairs, are a combinatorial map: with the face on
//! the left, the edge after one that arrives at a port begins at the next port clockwise. So every
//! edge has a face or the outside on either side, whatever is missing, and the result is a surface.

use super::links::Links;
use super::ports::{Line, Ports};

/// Finds the faces, as nodes counterclockwise with the face on the left, without edges that bound no face
/// of their own: those of inner nodes with fewer than three edges, one side of a face of two sides, and
/// those from a node to itself.
pub(super) fn faces(ports: &Ports, links: &Links) -> Vec<Vec<usize>> {
    let mut map = CombinatorialMap::new(ports, links);
    while map.simplify() {}
    map.faces()
}

struct CombinatorialMap<'a> {
    ports: &'a Ports,
    /// `#P`.
    other: Vec<Option<usize>>,
}

impl<'a> CombinatorialMap<'a> {
    fn new(ports: &'a Ports, links: &Links) -> Self {
        CombinatorialMap { ports, other: links.clone() }
    }

    /// The port at which the next edge of the face on the left begins, and whether the outside lies
    /// before it.
    fn next(&self, port: usize) -> Option<(usize, bool)> {
        let arrived = self.other[port]?;
        let node = self.ports.all[arrived].node;
        let all = self.ports.of_node(node);
        let (mut at, mut outside) = (arrived, false);
        loop {
            if at == all.start {
                at = all.end;
                outside |= self.ports.open[node];
            }
            at -= 1;
            if self.other[at].is_some() {
                return Some((at, outside));
            }
        }
    }

    /// The ports of the cell on the left of an edge, and whether it is the outside.
    fn cell(&self, port: usize) -> (Vec<usize>, bool) {
        let (mut cell, mut outside, mut at) = (Vec::new(), false, port);
        while let Some((next, passes)) = self.next(at) {
            cell.push(at);
            outside |= passes;
            at = next;
            if at == port {
                break;
            }
        }
        (cell, outside)
    }

    fn is_boundary(&self, port: usize) -> bool {
        !matches!(self.ports.all[port].line, Line::Grid(_))
    }

    /// Removes an edge that is not on the boundary.
    fn unlink(&mut self, port: usize) -> bool {
        match self.other[port] {
            Some(other) if !self.is_boundary(port) && !self.is_boundary(other) => {
                self.other[port] = None;
                self.other[other] = None;
                true
            }
            _ => false,
        }
    }

    /// Removes edges once; whether there were any.
    fn simplify(&mut self) -> bool {
        let mut changed = false;
        for node in 0..self.ports.open.len() {
            let all = self.ports.of_node(node);
            let linked = all.clone().filter(|&p| self.other[p].is_some()).count();
            let is_superfluous = !self.ports.open[node] && linked < 3;
            for port in all {
                let Some(other) = self.other[port] else { continue };
                let to_itself = self.ports.all[other].node == node;
                if is_superfluous || to_itself {
                    changed |= self.unlink(port);
                }
            }
        }
        for port in 0..self.other.len() {
            let Some((next, _)) = self.next(port) else { continue };
            let returns = self.next(next).is_some_and(|(again, _)| again == port);
            if returns && port < next {
                changed |= self.unlink(port) || self.unlink(next);
            }
        }
        changed
    }

    fn faces(&self) -> Vec<Vec<usize>> {
        let mut seen = vec![false; self.other.len()];
        let mut faces = Vec::new();
        for port in 0..self.other.len() {
            if seen[port] || self.other[port].is_none() {
                continue;
            }
            let (cell, outside) = self.cell(port);
            cell.iter().for_each(|&p| seen[p] = true);
            if !outside {
                faces.push(cell.iter().map(|&p| self.ports.all[p].node).collect());
            }
        }
        faces
    }
}
