//! Presentations: the steps in which a scene is shown to others.

use super::Weights;
use crate::json::present;
use serde::{Deserialize, Serialize};

/// One step of a presentation: what is said, how the shape is seen, and what it becomes. What a step
/// leaves out stays as it was.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Slide {
    /// Its title.
    pub title: String,
    /// The text shown with it; line breaks are kept.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub text: String,
    /// What only the one who presents sees; line breaks are kept.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub notes: String,
    /// Where it is seen from: pivot, distance, turn, tilt, and whether it is framed
    /// ([`crate::view::state::saved_camera`]).
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "number[]"))]
    pub camera: Option<[f64; 7]>,
    /// In parallel projection, not in perspective.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub parallel: bool,
    /// The id of the measure that faces are coloured by; none is the plain material.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub measure: Option<String>,
    /// Goes back to the rest shape.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub original: bool,
    /// Goes to one of the shapes that were kept: its place among them. Not from the rest shape.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    pub variant: Option<usize>,
    /// The weights of Eq. 13.
    #[serde(default, deserialize_with = "present", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "Weights"))]
    pub weights: Option<Weights>,
    /// Iterates from there.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub run: bool,
}

impl Slide {
    /// A presentation has no more.
    pub const MOST: usize = 99;
}
