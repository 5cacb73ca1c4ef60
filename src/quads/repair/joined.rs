//! Faces of an odd number of sides, joined with another one or with the boundary.

use super::panels::{Panels, merged};
use crate::math::polygon_sides;
use crate::quads::extract::{Node, Place};
use std::collections::{BTreeMap, VecDeque};

/// The most faces between two odd ones.
const FARTHEST: usize = 24;

/// Joins each odd face with the nearest one and the faces between them. One that is left over gets a
/// new node on the nearest boundary edge, to which it is joined likewise. What is a quad then is
/// `replaced`; the others are still to be.
pub(super) fn join_odd(
    panels: &mut Panels,
    nodes: &mut Vec<Node>,
    is_trimmed: &impl Fn(&[usize]) -> bool,
    replaced: &mut Vec<Vec<usize>>,
) {
    let is_odd = |panels: &Panels, index: usize| {
        panels.face(index).is_some_and(|face| face.len() % 2 == 1 && !is_trimmed(face))
    };
    for to_boundary in [false, true] {
        let odd: Vec<usize> = panels.indices().filter(|&index| is_odd(panels, index)).collect();
        for start in odd {
            if !is_odd(panels, start) {
                continue;
            }
            let ends = |panels: &Panels, index: usize| {
                let face = panels.face(index)?;
                let outer = polygon_sides(face).find(|&[a, b]| panels.left(b, a).is_none());
                match to_boundary {
                    true => outer.map(Some),
                    false => (index != start && is_odd(panels, index)).then_some(None),
                }
            };
            let Some((path, outer)) = path(panels, start, ends) else { continue };
            let Some(mut polygon) = joined(panels, &path) else { continue };
            if let Some([a, b]) = outer {
                let Some(at) = polygon_sides(&polygon).position(|side| side == [a, b]) else {
                    continue;
                };
                polygon.insert(at + 1, nodes.len());
                nodes.push(between(&nodes[a], &nodes[b]));
            }
            path.iter().for_each(|&index| {
                panels.take(index);
            });
            if polygon.len() == 4 {
                replaced.push(polygon.clone());
            }
            panels.add(polygon);
        }
    }
}

/// A node in the middle of a boundary edge.
fn between(a: &Node, b: &Node) -> Node {
    let position = (a.position + b.position) * 0.5;
    let place = match (a.place, b.place) {
        (Place::Vertex(_), place) | (place, _) => place,
    };
    Node { position, place, corner: false, ..*a }
}

/// The faces from `start` to the nearest one for which `ends` gives a result, breadth first.
fn path<T>(
    panels: &Panels,
    start: usize,
    ends: impl Fn(&Panels, usize) -> Option<T>,
) -> Option<(Vec<usize>, T)> {
    let mut from: BTreeMap<usize, (usize, usize)> = BTreeMap::from([(start, (start, 0))]);
    let mut queue = VecDeque::from([start]);
    while let Some(index) = queue.pop_front() {
        let (_, distance) = from[&index];
        if let Some(end) = ends(panels, index) {
            let mut path = vec![index];
            while path[path.len() - 1] != start {
                path.push(from[&path[path.len() - 1]].0);
            }
            path.reverse();
            return Some((path, end));
        }
        if distance >= FARTHEST {
            continue;
        }
        for [a, b] in polygon_sides(panels.face(index).unwrap_or_default()) {
            if let Some(next) = panels.left(b, a)
                && !from.contains_key(&next)
            {
                from.insert(next, (index, distance + 1));
                queue.push_back(next);
            }
        }
    }
    None
}

/// The polygon around faces of which each shares a side with the one before.
fn joined(panels: &Panels, path: &[usize]) -> Option<Vec<usize>> {
    let mut polygon = panels.face(path[0])?.to_vec();
    for index in &path[1..] {
        let face = panels.face(*index)?;
        let shared = polygon_sides(&polygon)
            .find(|&[a, b]| polygon_sides(face).any(|side| side == [b, a]))?;
        polygon = merged(&polygon, face, shared);
    }
    Some(polygon)
}
