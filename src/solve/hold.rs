//! What holds vertices in place: soft and fixed handles, and pins of parts that nothing holds.

use super::centred::relative;
use crate::constraint::Row;
use crate::mesh::Point;
use crate::scene::Hold;
use std::num::NonZeroU32;

/// A vertex held at a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handle {
    /// The vertex.
    pub vertex: u32,
    /// Where it shall be.
    pub target: Point,
    /// How it is held.
    pub hold: Hold,
}

/// Where the handle of each vertex is in a list of handles.
pub struct HandlePlaces {
    /// `#V`
    places: Vec<Option<NonZeroU32>>,
}

impl HandlePlaces {
    /// Of `handles`, of which each vertex has one at most, on a mesh of `n_vertices`.
    pub fn new(n_vertices: usize, handles: &[Handle]) -> HandlePlaces {
        let mut places = HandlePlaces { places: vec![None; n_vertices] };
        for (place, handle) in handles.iter().enumerate() {
            places.insert(handle.vertex, place);
        }
        places
    }

    /// The place of the handle of `vertex`, if it is one.
    pub fn get(&self, vertex: u32) -> Option<usize> {
        let place = self.places.get(vertex as usize).copied().flatten()?;
        Some(place.get() as usize - 1)
    }

    /// Says that the handle of `vertex` is at `place` of the list.
    pub fn insert(&mut self, vertex: u32, place: usize) {
        self.places[vertex as usize] = NonZeroU32::new(place as u32 + 1);
    }
}

/// One vertex of each connected part that nothing holds: without, the system would be singular.
///
/// `node_of` names the node of each vertex, `parts` labels the connected part of each node, `held` says of
/// each node whether closeness or a handle holds it.
pub(super) fn pins(node_of: &[u32], parts: &[u32], held: &[bool]) -> Vec<u32> {
    let mut part_is_held = vec![false; parts.len()];
    for (&part, &held) in parts.iter().zip(held) {
        part_is_held[part as usize] |= held;
    }
    let mut pins = Vec::new();
    for (vertex, &node) in node_of.iter().enumerate() {
        let part = parts[node as usize] as usize;
        if !std::mem::replace(&mut part_is_held[part], true) {
            pins.push(vertex as u32);
        }
    }
    pins
}

/// Soft handles, in terms of nodes.
#[derive(Default)]
pub(super) struct SoftHandles {
    held: Vec<(u32, f64, Row)>,
}

impl SoftHandles {
    /// The soft ones among `handles`, whose vertices are called `node_of[v]`; targets relative to `centre`.
    pub(super) fn new(handles: &[Handle], node_of: &[u32], centre: Point) -> Self {
        let held = handles.iter().filter_map(|handle| match handle.hold {
            Hold::Soft { weight } => {
                Some((node_of[handle.vertex as usize], weight, relative(handle.target, centre)))
            }
            Hold::Fixed => None,
        });
        SoftHandles { held: held.collect() }
    }

    /// Adds half the gradient of `sum weight |v - target|^2` at `x`, and gives the sum.
    pub(super) fn step(&self, x: &[Row], gradient: &mut [Row]) -> f64 {
        let mut energy = 0.0;
        for &(node, weight, target) in &self.held {
            for i in 0..3 {
                let away = x[node as usize][i] - target[i];
                energy += weight * away * away;
                gradient[node as usize][i] += weight * away;
            }
        }
        energy
    }
}
