//! The description of a plan, and its errors.

use crate::begin::declaration::MOST_FACES;
use serde::Deserialize;
use std::fmt;

/// Longer lists of points are refused.
const MOST_POINTS: usize = 500;

/// A closed outline on the ground, and what becomes of it.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub struct Plan {
    /// The points of the outline, in either direction.
    pub outline: Vec<PlanPoint>,
    /// Those of each hole.
    #[serde(default)]
    pub holes: Vec<Vec<PlanPoint>>,
    /// How it is divided.
    pub layout: PlanLayout,
    /// The length of a panel.
    pub size: f64,
    /// The direction of a grid that is cut, in degrees from the `x` axis.
    #[serde(default)]
    pub turn: f64,
    /// The height of the highest vertex.
    pub height: f64,
    /// The part of the surface that stays on the ground.
    pub stands: Standing,
}

/// A point of an outline, with the side from it to the next one.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub struct PlanPoint {
    /// Its coordinates.
    pub at: [f64; 2],
    /// How far the side is an arc: its rise over half its chord, from -1 to 1 for half circles; outward where it
    /// is positive.
    #[serde(default)]
    pub bulge: f64,
    /// Whether it is a corner of the surface: of a grid that follows the outline, and where that stands.
    #[serde(default)]
    pub corner: bool,
}

/// How a plan is divided into panels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub enum PlanLayout {
    /// Into a grid of quads whose four sides are the pieces of the outline between its four corners.
    Follow,
    /// Into squares that are cut where the outline and its holes end.
    Cut,
}

/// The part of a surface that stays on the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub enum Standing {
    /// The whole outline.
    Outline,
    /// The corners alone.
    Corners,
}

/// A side of a plan, by where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanSide {
    /// The hole that it bounds, or none for the outline.
    pub hole: Option<usize>,
    /// The point where it begins.
    pub point: usize,
}

impl fmt::Display for PlanSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let PlanSide { hole, point } = *self;
        write!(f, "side {} of ", point + 1)?;
        match hole {
            None => write!(f, "the outline (outline[{point}])"),
            Some(hole) => write!(f, "hole {} (holes[{hole}][{point}])", hole + 1),
        }
    }
}

/// An error in a plan.
#[derive(Clone, Debug, PartialEq)]
pub enum PlanError {
    /// An entry of its text, by its JSON path.
    Entry {
        /// Such as `outline[3].bulge`; empty for the whole text.
        path: String,
        /// The value found, and what was expected.
        message: String,
    },
    /// Two sides meet that should not.
    Crossing([PlanSide; 2]),
    /// A hole lies outside the outline.
    Outside(usize),
    /// So many corners are marked; a grid that follows the outline has four.
    FourCorners(usize),
    /// A surface that stands on its corners needs three, and so many are marked.
    NoCorners(usize),
    /// A grid that follows the outline has no holes.
    Holes,
    /// Panels of a grid that follows the outline lie over each other.
    Folded,
    /// This hole, or the outline where there is none, is smaller than a panel.
    TooCoarse(Option<usize>),
    /// There is a piece that stands nowhere.
    Apart,
    /// More faces than are made, see the number.
    TooMany(f64),
}

impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PlanError::Entry { path, message } if path.is_empty() => f.write_str(message),
            PlanError::Entry { path, message } => write!(f, "{path}: {message}"),
            PlanError::Crossing([first, second]) => {
                write!(f, "{first} and {second} cross or touch")
            }
            PlanError::Outside(hole) => {
                write!(f, "hole {} (holes[{hole}]) lies outside the outline", hole + 1)
            }
            PlanError::FourCorners(marked) => write!(
                f,
                "expected four corners for panels along the outline, found {marked}: mark four, or cut a grid"
            ),
            PlanError::NoCorners(marked) => {
                write!(f, "expected at least three corners to stand on, found {marked}")
            }
            PlanError::Holes => {
                f.write_str("panels along the outline leave no holes: remove them, or cut a grid")
            }
            PlanError::Folded => f.write_str(
                "panels along this outline would lie over each other: choose other corners, or cut a grid",
            ),
            PlanError::TooCoarse(Some(hole)) => write!(
                f,
                "hole {} (holes[{hole}]) is too small for these panels: make them smaller",
                hole + 1
            ),
            PlanError::TooCoarse(None) => {
                f.write_str("the outline is too small for these panels: make them smaller")
            }
            PlanError::Apart => {
                f.write_str("a piece of the surface stands nowhere: mark a corner on it")
            }
            PlanError::TooMany(faces) => {
                write!(f, "that would be {faces:.0} faces, expected at most {MOST_FACES}")
            }
        }
    }
}

impl std::error::Error for PlanError {}

impl Plan {
    /// Reads a plan: its fields by their names.
    ///
    /// # Errors
    /// Where it is no JSON, or an entry is not one of a plan.
    #[cfg(feature = "cli")]
    pub fn from_json(text: &str) -> Result<Plan, PlanError> {
        use crate::json::{JsonError, parse, read_tree};
        let at = |error: JsonError| PlanError::Entry { path: error.path, message: error.message };
        read_tree(&parse(text).map_err(at)?).map_err(at)
    }
}

pub(super) fn entry(path: impl Into<String>, message: impl Into<String>) -> PlanError {
    PlanError::Entry { path: path.into(), message: message.into() }
}

/// Refuses lists of points that are no outline.
pub(super) fn check(points: &[PlanPoint], path: &str) -> Result<(), PlanError> {
    let is_arc = points.iter().any(|point| point.bulge != 0.0);
    let fewest = if is_arc { 2 } else { 3 };
    if !(fewest..=MOST_POINTS).contains(&points.len()) {
        let found = points.len();
        return Err(entry(
            path,
            format!("expected {fewest} to {MOST_POINTS} points, found {found}"),
        ));
    }
    for (k, point) in points.iter().enumerate() {
        let at = |message: &str| Err(entry(format!("{path}[{k}]"), message));
        if !point.at.iter().all(|x| x.abs() <= 1e7) {
            return at("expected coordinates up to 1e7");
        }
        if point.bulge.is_nan() || point.bulge.abs() > 1.0 {
            return at("expected a bulge from -1 to 1");
        }
        if point.at == points[(k + 1) % points.len()].at {
            return at("expected another place than that of the next point");
        }
    }
    Ok(())
}
