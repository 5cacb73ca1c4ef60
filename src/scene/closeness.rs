//! The closeness energy `close = sum_v k_v |v - c(v)|^2` (Eq. 11): its target points `c(v)` and
//! factors `k_v`.

use super::SceneError;
use crate::constraint::{Selector, Sets, resolve};
use crate::mesh::{Mesh, Topology};
use crate::solve::{BoundaryCloseness, BoundaryRequire, ClosenessTo};
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// Closeness of vertices: target points and factors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Closeness {
    /// Definition of `c(v)`.
    pub to: ClosenessTo,
    /// The other surface, for [`ClosenessTo::Target`].
    pub target: Option<Target>,
    /// Factors `k_v` other than 1; if several entries select a vertex, the last applies.
    pub weights: Vec<ClosenessWeight>,
    /// Whether boundary vertices are kept close to the boundary curves, whatever `to` is.
    pub boundary: BoundaryCloseness,
}

/// A surface other than the mesh of the scene, in the same coordinates.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// Path of a mesh file relative to the scene; to be read before the scene is opened.
    File(String),
    /// The mesh of the surface.
    Mesh(Rc<Mesh>),
}

impl Target {
    /// Returns the mesh, if it was read.
    pub fn mesh(&self) -> Option<&Rc<Mesh>> {
        match self {
            Target::File(_) => None,
            Target::Mesh(mesh) => Some(mesh),
        }
    }
}

/// Closeness factor of a selection of vertices.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClosenessWeight {
    /// Selector; all selected vertices get the factor.
    pub on: Selector,
    /// Factor `k_v` of `weights.close`, not negative; 0 disables closeness.
    pub weight: f64,
}

impl Closeness {
    /// The other surface that vertices are kept close to, if there is one.
    pub fn target_mesh(&self) -> Option<&Rc<Mesh>> {
        self.target.as_ref().filter(|_| self.to == ClosenessTo::Target)?.mesh()
    }

    /// Returns the path of the file with the surface that the shape is kept close to, if it is not read
    /// yet. That of a surface to which nothing is close may be anywhere.
    pub fn file_to_read(&self) -> Option<&str> {
        match &self.target {
            Some(Target::File(path)) if self.to == ClosenessTo::Target => Some(path),
            _ => None,
        }
    }

    /// Replaces closeness to the mesh itself by closeness to the surface `original` from which it was
    /// made, and to its own boundary.
    pub fn stay_on(&mut self, original: &Rc<Mesh>) {
        if matches!(self.to, ClosenessTo::Rest | ClosenessTo::Surface) {
            self.to = ClosenessTo::Target;
            self.target = Some(Target::Mesh(Rc::clone(original)));
            self.boundary.require = self.boundary.require.max(BoundaryRequire::Soft);
        }
    }

    /// Returns `k_v` of each vertex, `#V`.
    ///
    /// # Errors
    /// If an entry selects nothing or has an unknown name, with its JSON path.
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
