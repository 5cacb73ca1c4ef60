//! Positional constraints: soft and fixed handles, and pins of components that nothing holds.

use crate::constraint::Row;
use crate::mesh::Point;
use crate::solve::local_frame::relative;
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

/// How a handle holds its vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// Adds `weight * |v - target|^2` to the total.
    Soft {
        /// Positive.
        weight: f64,
    },
    /// Takes the vertices out of the unknowns: the targets are met exactly.
    Fixed,
}

/// Where the handle of each vertex is in a list of handles.
pub struct HandleIndex {
    /// `#V`: the place of the handle of each vertex, from 1 on.
    places: Vec<Option<NonZeroU32>>,
}

impl HandleIndex {
    /// Of `handles`, of which each vertex has one at most, on a mesh of `n_vertices`.
    pub fn new(n_vertices: usize, handles: &[Handle]) -> HandleIndex {
        let mut places = HandleIndex { places: vec![None; n_vertices] };
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

/// One vertex of each connected component of the normal matrix that nothing holds: without, the system
/// would be singular.
///
/// `node_of` (`#V`) is the node of each vertex; `components` (`#nodes`) a number for each node, below
/// `#nodes`, that its component shares; `held` (`#nodes`) whether closeness or a handle holds it.
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

/// The soft handles, in terms of nodes.
#[derive(Default)]
pub(crate) struct PositionalConstraints {
    held: Vec<(u32, f64, Row)>,
}

impl PositionalConstraints {
    /// The soft ones among `handles`, whose vertices are called `node_of[v]`; targets relative to `centre`.
    pub(crate) fn new(handles: &[Handle], node_of: &[u32], centre: Point) -> Self {
        let held = handles.iter().filter_map(|handle| match handle.hold {
            Hold::Soft { weight } => {
                Some((node_of[handle.vertex as usize], weight, relative(handle.target, centre)))
            }
            Hold::Fixed => None,
        });
        PositionalConstraints { held: held.collect() }
    }

    /// Adds half the gradient of `sum weight |v - target|^2` at `x`, and gives the sum.
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
