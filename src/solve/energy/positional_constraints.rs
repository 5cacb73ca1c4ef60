//! Positional constraints: soft and fixed handles, and pins for components that nothing else holds.

use crate::constraint::Row;
use crate::mesh::Point;
use crate::solve::local_frame::relative;
use std::num::NonZeroU32;

/// A vertex held at a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handle {
    /// The vertex.
    pub vertex: u32,
    /// The target position.
    pub target: Point,
    /// How it is held.
    pub hold: Hold,
}

/// How a handle holds its vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// Adds `weight * |v - target|^2` to the total.
    Soft {
        /// Positive.
        weight: f64,
    },
    /// Removes the vertices from the unknowns: the targets are met exactly.
    Fixed,
}

/// The index of the handle of each vertex in a list of handles.
pub struct HandleIndex {
    /// `#V`: the index of the handle of each vertex, plus one.
    places: Vec<Option<NonZeroU32>>,
}

impl HandleIndex {
    /// Indexes `handles`, at most one for each vertex, on a mesh of `n_vertices`.
    pub fn new(n_vertices: usize, handles: &[Handle]) -> HandleIndex {
        let mut index = HandleIndex { places: vec![None; n_vertices] };
        for (place, handle) in handles.iter().enumerate() {
            index.insert(handle.vertex, place);
        }
        index
    }

    /// The index of the handle of `vertex`, if it has one.
    pub fn get(&self, vertex: u32) -> Option<usize> {
        let place = self.places.get(vertex as usize).copied().flatten()?;
        Some(place.get() as usize - 1)
    }

    /// Sets the index of the handle of `vertex` to `place`.
    pub fn insert(&mut self, vertex: u32, place: usize) {
        self.places[vertex as usize] = NonZeroU32::new(place as u32 + 1);
    }
}

/// Returns one vertex of each connected component of the normal matrix that nothing holds. Without
/// these pins the system would be singular.
///
/// `node_of` (`#V`) is the node of each vertex; `components` (`#nodes`) the number of the component
/// of each node, below `#nodes`; `held` (`#nodes`) whether closeness or a handle holds it.
pub(crate) fn pins(node_of: &[u32], components: &[u32], held: &[bool]) -> Vec<u32> {
    let mut component_is_held = vec![false; components.len()];
    for (&component, &held) in components.iter().zip(held) {
        component_is_held[component as usize] |= held;
    }
    let mut pins = Vec::new();
    for (vertex, &node) in node_of.iter().enumerate() {
        let component = components[node as usize] as usize;
        if !std::mem::replace(&mut component_is_held[component], true) {
            pins.push(vertex as u32);
        }
    }
    pins
}

/// The soft handles, by nodes.
#[derive(Default)]
pub(crate) struct PositionalConstraints {
    held: Vec<(u32, f64, Row)>,
}

impl PositionalConstraints {
    /// Selects the soft ones of `handles`; `node_of` is the node of each vertex, and targets become
    /// relative to `centre`.
    pub(crate) fn new(handles: &[Handle], node_of: &[u32], centre: Point) -> Self {
        let held = handles.iter().filter_map(|handle| match handle.hold {
            Hold::Soft { weight } => {
                Some((node_of[handle.vertex as usize], weight, relative(handle.target, centre)))
            }
            Hold::Fixed => None,
        });
        PositionalConstraints { held: held.collect() }
    }

    /// Adds half the gradient of `sum weight |v - target|^2` at `x`, and returns the sum.
    pub(crate) fn step(&self, x: &[Row], gradient: &mut [Row]) -> f64 {
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
