//! The shapes to be measured, and what several measures need of them.

use crate::mesh::{Measures, Point, Ragged};
use crate::session::Session;
use crate::session::measured::rest_surface_distances;
use std::rc::Rc;

/// The shape to be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// The current positions.
    Now,
    /// The rest shape: the model as opened.
    Original,
}

impl Session {
    /// Planarity and circularity of the faces of the current shape.
    pub fn measures(&self) -> Rc<Measures> {
        self.measured.measures(&self.scene, &self.rest)
    }

    /// As [`Session::measures`], up to `seconds` old: measuring may take longer than an iteration.
    pub fn recent_measures(&self, seconds: f64) -> Rc<Measures> {
        self.measured.recent_measures(&self.scene, &self.rest, seconds)
    }

    pub(super) fn faces(&self) -> &Ragged {
        &self.rest.mesh().faces
    }

    /// Positions, `#V by 3`.
    pub(super) fn positions_of(&self, shape: Shape) -> Rc<[Point]> {
        match shape {
            Shape::Now => Rc::clone(self.scene.positions()),
            Shape::Original => self.rest.positions().into(),
        }
    }

    /// Returns planarity and circularity of the faces.
    pub(super) fn measures_of(&self, shape: Shape) -> Rc<Measures> {
        match shape {
            Shape::Now => self.measures(),
            Shape::Original => {
                let diameter = self.rest.mesh().size();
                Rc::new(Measures::new(self.rest.positions(), self.faces(), diameter))
            }
        }
    }

    /// Returns the distance of each vertex to the surface of the opened model, `#V`, in its unit.
    pub(super) fn surface_distances(&self, shape: Shape) -> Rc<[f64]> {
        match shape {
            Shape::Now => self.measured.surface_distances(&self.scene, &self.rest),
            Shape::Original => rest_surface_distances(&self.scene, &self.rest),
        }
    }
}
