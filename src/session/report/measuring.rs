//! The shapes to be measured, with the data that measuring needs.

use super::measure_cache::{MeasureCache, rest_surface_distances};
use crate::mesh::{Measures, Point, Ragged};
use crate::session::state::{RestMesh, SolvedScene};
use std::rc::Rc;

/// The shape to be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// The current positions.
    Now,
    /// The rest shape: the model as opened.
    Original,
}

/// A scene with its rest mesh and cached measures.
pub(crate) struct Measuring<'a> {
    pub(crate) rest: &'a RestMesh,
    pub(crate) scene: &'a mut SolvedScene,
    pub(crate) cache: &'a MeasureCache,
}

impl Measuring<'_> {
    pub(super) fn faces(&self) -> &Ragged {
        &self.rest.mesh().faces
    }

    /// Positions, `#V by 3`.
    pub(super) fn positions(&self, shape: Shape) -> Rc<[Point]> {
        positions(self.scene, self.rest, shape)
    }

    /// Returns planarity and circularity of the faces.
    pub(super) fn measures(&self, shape: Shape) -> Rc<Measures> {
        match shape {
            Shape::Now => self.cache.measures(self.scene, self.rest),
            Shape::Original => {
                let diameter = self.rest.mesh().bounding_diameter();
                Rc::new(Measures::new(self.rest.positions(), self.faces(), diameter))
            }
        }
    }

    /// Returns the distance of each vertex to the surface of the opened model, `#V`, in its unit.
    pub(super) fn surface_distances(&self, shape: Shape) -> Rc<[f64]> {
        match shape {
            Shape::Now => self.cache.surface_distances(self.scene, self.rest),
            Shape::Original => rest_surface_distances(self.scene, self.rest),
        }
    }
}

/// Positions of a shape, `#V by 3`.
pub(super) fn positions(scene: &SolvedScene, rest: &RestMesh, shape: Shape) -> Rc<[Point]> {
    match shape {
        Shape::Now => Rc::clone(scene.positions()),
        Shape::Original => rest.positions().into(),
    }
}
