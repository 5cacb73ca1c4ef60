//! The shapes to be measured, and what several measures need of them.

use crate::mesh::{Measures, Point, Ragged};
use crate::session::Session;
use crate::session::measured::surface_distances_at;
use std::rc::Rc;

/// The shape to be measured.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The current positions.
    Now,
    /// The rest shape: the model as opened.
    Original,
    /// These positions, `#V by 3`, such as those of a kept variant.
    At(Rc<[Point]>),
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
    pub(super) fn positions_of(&self, shape: &Shape) -> Rc<[Point]> {
        match shape {
            Shape::Now => Rc::clone(self.scene.positions()),
            Shape::Original => self.rest.positions().into(),
            Shape::At(positions) => Rc::clone(positions),
        }
    }

    /// Returns planarity and circularity of the faces.
    pub(super) fn measures_of(&self, shape: &Shape) -> Rc<Measures> {
        match shape {
            Shape::Now => self.measures(),
            Shape::Original | Shape::At(_) => {
                let diameter = self.rest.mesh().size();
                Rc::new(Measures::new(&self.positions_of(shape), self.faces(), diameter))
            }
        }
    }

    /// Returns the distance of each vertex to the surface of the opened model, `#V`, in its unit.
    pub(super) fn surface_distances(&self, shape: &Shape) -> Rc<[f64]> {
        match shape {
            Shape::Now => self.measured.surface_distances(&self.scene, &self.rest),
            Shape::Original | Shape::At(_) => {
                surface_distances_at(&self.positions_of(shape), &self.scene, &self.rest)
            }
        }
    }
}
