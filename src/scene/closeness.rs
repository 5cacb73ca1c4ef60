//! The closeness of vertices: to which points, and with which factors: `close = sum_v k_v |v - c(v)|^2` (Eq. 11).

use super::SceneError;
use crate::constraint::{Selector, Sets, resolve};
use crate::mesh::{Mesh, Topology};
use crate::solve::{BoundaryCloseness, ClosenessTo};
use serde::Deserialize;
use std::rc::Rc;

/// The closeness of vertices: to which points, and the factor of each vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Closeness {
    /// `c(v)`.
    pub to: ClosenessTo,
    /// Another surface: that of [`ClosenessTo::Target`].
    pub target: Option<Target>,
    /// `k_v` where it is not 1; of a vertex that several entries select, the last one's.
    pub weights: Vec<ClosenessWeight>,
    /// Whether boundary vertices have the boundary curves for `c(v)`, whatever `to` is.
    pub boundary: Option<BoundaryCloseness>,
}

/// Another surface than that of the scene, in the same coordinates.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// A mesh file beside the scene: path relative to it. It has to be read before the scene is opened.
    File(String),
    /// Its mesh.
    Mesh(Rc<Mesh>),
}

impl Target {
    /// The mesh, if it was read.
    pub fn mesh(&self) -> Option<&Rc<Mesh>> {
        match self {
            Target::File(_) => None,
            Target::Mesh(mesh) => Some(mesh),
        }
    }
}

/// How much more or less some vertices are kept close than the rest.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClosenessWeight {
    /// Which: all vertices that it selects.
    pub on: Selector,
    /// `k_v`, a factor of `weights.close`, not negative; at 0 nothing keeps them close.
    pub weight: f64,
}

impl Closeness {
    /// `k_v` of each vertex, `#V`.
    ///
    /// # Errors
    /// When an entry selects nothing or names what is not there, with its JSON path.
    pub fn factors(
        &self,
        mesh: &Mesh,
        topology: &Topology,
        sets: &Sets,
    ) -> Result<Vec<f64>, SceneError> {
        let mut factors = vec![1.0; mesh.positions.len()];
        for (i, entry) in self.weights.iter().enumerate() {
            let error =
                |message| SceneError { path: format!("closeness.weights[{i}].on"), message };
            let selected = resolve(&entry.on, mesh, topology, sets)
                .map_err(|problem| error(problem.to_string()))?;
            if selected.indices().is_empty() {
                let message =
                    "nothing is selected: the mesh has no such element, expected at least one";
                return Err(error(message.to_owned()));
            }
            selected.indices().iter().for_each(|&v| factors[v as usize] = entry.weight);
        }
        Ok(factors)
    }
}
