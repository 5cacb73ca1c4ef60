//! Shapes that the user kept, and the steps in which a scene is shown to an audience.

use super::Weights;
use crate::json::{fixed, object_or_none, objects, points, present};
use crate::mesh::Point;
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// Shapes that the user kept, to compare them and to return to them.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Variants {
    /// The shapes, oldest first, [`Variants::MOST`] at most.
    #[serde(deserialize_with = "objects")]
    pub kept: Vec<Variant>,
    /// Index of the shape that closeness and smoothness refer to; `None` for the rest shape.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub design: Option<usize>,
}

/// A shape that the user kept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Variant {
    /// Name.
    pub name: String,
    /// Positions, `#V by 3`.
    #[serde(deserialize_with = "points")]
    pub positions: Rc<[Point]>,
}

impl Variants {
    /// Maximum number of kept shapes.
    pub const MOST: usize = 12;

    pub(super) fn is_empty(&self) -> bool {
        self.kept.is_empty()
    }

    /// Returns the positions of the design, `#V by 3`; `None` if it is the rest shape.
    pub fn design_positions(&self) -> Option<&[Point]> {
        self.design.and_then(|index| self.kept.get(index)).map(|variant| &*variant.positions)
    }
}

/// One step of a presentation: text, view, and changes of the shape. Camera, shape and weights that a
/// step leaves out stay as they were; projection and measure are those of the step.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Slide {
    /// Title.
    pub title: String,
    /// Text shown to the audience; line breaks are kept.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub text: String,
    /// Notes, not shown in the presentation; line breaks are kept.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub notes: String,
    /// Camera: pivot, distance, turn, tilt, and whether the model is framed
    /// ([`crate::view::state::navigate`]).
    #[serde(default, deserialize_with = "fixed", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number[]"))]
    pub camera: Option<[f64; 7]>,
    /// Whether the projection is parallel instead of perspective.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub parallel: bool,
    /// Id of the measure that colours the faces; `None` for the plain material.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub measure: Option<String>,
    /// Whether the step returns to the rest shape.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub original: bool,
    /// Index of the kept shape that the step goes to; not together with `original`.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub variant: Option<usize>,
    /// The weights of Eq. 13.
    #[serde(default, deserialize_with = "object_or_none", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Weights"))]
    pub weights: Option<Weights>,
    /// Whether the solver runs from there.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub run: bool,
}

impl Slide {
    /// Maximum number of steps of a presentation.
    pub const MOST: usize = 99;
}
