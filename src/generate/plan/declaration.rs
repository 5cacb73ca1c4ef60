//! The description of a plan, and its errors.

use crate::generate::quads::TooManyFaces;
use crate::json::{fixed, lists_of_objects, objects, word};
use crate::words;
use serde::{Deserialize, Serialize};
use std::fmt;

/// Largest number of points in a list.
const MOST_POINTS: usize = 500;
/// Limit of the cells of the grid, most of which a narrow plan leaves empty: they are all in memory.
pub(super) const MOST_CELLS: f64 = 1e6;

/// A closed outline on the ground, and how it becomes a surface.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub struct Plan {
    /// The points of the outline, in either direction.
    #[serde(deserialize_with = "objects")]
    pub outline: Vec<PlanPoint>,
    /// The points of each hole.
    #[serde(default, deserialize_with = "lists_of_objects")]
    pub holes: Vec<Vec<PlanPoint>>,
    /// How it is divided into panels.
    #[serde(deserialize_with = "word")]
    pub layout: PlanLayout,
    /// The target length of a panel's side.
    pub size: f64,
    /// Direction of a cut grid, in degrees from the `x` axis.
    #[serde(default)]
    pub turn: f64,
    /// The height of the highest vertex.
    pub height: f64,
    /// The part of the surface that stays on the ground.
    #[serde(rename = "stands", deserialize_with = "word")]
    pub support: Support,
}

/// A point of an outline, with the side from it to the next one.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
pub struct PlanPoint {
    /// Its coordinates.
    #[serde(deserialize_with = "fixed")]
    pub at: [f64; 2],
    /// Curvature as an arc: its rise over half its chord, from -1 to 1 (half circles), positive
    /// outwards.
    #[serde(default)]
    pub bulge: f64,
    /// Whether it is a corner: of a grid that follows the outline, or to stand on.
    #[serde(default)]
    pub corner: bool,
}

/// How a plan is divided into panels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub enum PlanLayout {
    /// Into a grid of quads whose four sides are the pieces of the outline between its four corners.
    Follow,
    /// Into squares that are cut at the outline and its holes.
    Cut,
}

/// The part of a surface that stays on the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub enum Support {
    /// The whole outline.
    Outline,
    /// Only the corners.
    Corners,
}

/// A side of a plan: its loop and its first point. Written with its place in JSON, without it by `{:#}`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanSide {
    /// The hole that it bounds; none for the outline.
    pub hole: Option<usize>,
    /// The point where it begins.
    pub point: usize,
}

impl fmt::Display for PlanSide {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let PlanSide { hole, point } = *self;
        write!(f, "side {} of ", point + 1)?;
        match hole {
            None => f.write_str("the outline")?,
            Some(hole) => write!(f, "hole {}", hole + 1)?,
        }
        match hole {
            _ if f.alternate() => Ok(()),
            None => write!(f, " (outline[{point}])"),
            Some(hole) => write!(f, " (holes[{hole}][{point}])"),
        }
    }
}

/// An error in a plan. Elements and settings are written as in JSON; for those who have drawn the plan, `{:#}`
/// has them as on the page.
#[derive(Clone, Debug, PartialEq)]
pub enum PlanError {
    /// An invalid entry of the text.
    Entry {
        /// JSON path, such as `outline[3].bulge`; empty for the whole text.
        path: String,
        /// The value found, and what was expected.
        message: String,
    },
    /// Two sides cross or touch.
    Crossing([PlanSide; 2]),
    /// A hole lies outside the outline.
    Outside(usize),
    /// A hole lies inside another, the second.
    Nested([usize; 2]),
    /// A grid that follows the outline needs four corners; holds the number marked.
    FourCorners(usize),
    /// A surface that stands on its corners needs three; holds the number marked.
    TooFewCorners(usize),
    /// A grid that follows the outline has no holes.
    Holes,
    /// Panels of a grid that follows the outline overlap.
    Folded,
    /// A hole, or the outline if none, is smaller than a panel.
    TooCoarse(Option<usize>),
    /// A connected piece of the surface has no support.
    NoSupport,
    /// The grid over the extent of the plan would have too many cells.
    TooManyCells,
    /// Too many faces.
    TooManyFaces(TooManyFaces),
}

impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [corner, cut, outline, size] = if f.alternate() {
            [
                "“Corner of the roof”",
                "“A grid, cut to fit”",
                "“The whole outline”",
                "their size, Panel",
            ]
        } else {
            ["`corner`", "the layout `cut`", "to stand on the `outline`", "`size`"]
        };
        match self {
            PlanError::Entry { path, message } if path.is_empty() => f.write_str(message),
            PlanError::Entry { path, message } => write!(f, "{path}: {message}"),
            PlanError::Crossing([first, second]) => {
                first.fmt(f)?;
                f.write_str(" and ")?;
                second.fmt(f)?;
                f.write_str(" cross or touch")
            }
            PlanError::Outside(hole) => {
                write_hole(f, *hole)?;
                f.write_str(" lies outside the outline")
            }
            PlanError::Nested([inner, outer]) => {
                write_hole(f, *inner)?;
                f.write_str(" lies inside ")?;
                write_hole(f, *outer)
            }
            PlanError::FourCorners(marked) => write!(
                f,
                "expected four corners for panels along the outline, found {marked}: mark four points as {corner}, or choose {cut}"
            ),
            PlanError::TooFewCorners(marked) => write!(
                f,
                "expected at least three corners to stand on, found {marked}: mark more points as {corner}, or choose {outline}"
            ),
            PlanError::Holes => write!(
                f,
                "panels along the outline cannot have holes: delete the holes, or choose {cut}"
            ),
            PlanError::Folded => {
                write!(f, "panels along this outline would overlap: choose other corners, or {cut}")
            }
            PlanError::TooCoarse(hole) => {
                match hole {
                    Some(hole) => write_hole(f, *hole)?,
                    None => f.write_str("the outline")?,
                }
                write!(f, " is too small for these panels: reduce {size}")
            }
            PlanError::NoSupport => {
                write!(f, "a piece of the surface has no support: mark a point of it as {corner}")
            }
            PlanError::TooManyCells => {
                let most = words::group_digits(MOST_CELLS as usize);
                write!(
                    f,
                    "a grid over the extent of the plan would have more than {most} panels: increase {size}"
                )
            }
            PlanError::TooManyFaces(why) => why.fmt(f),
        }
    }
}

/// Writes the number of a hole, and its place in JSON as [`PlanError`] does.
fn write_hole(f: &mut fmt::Formatter<'_>, hole: usize) -> fmt::Result {
    write!(f, "hole {}", hole + 1)?;
    if f.alternate() { Ok(()) } else { write!(f, " (holes[{hole}])") }
}

impl std::error::Error for PlanError {}

impl Plan {
    /// Reads a plan from JSON.
    ///
    /// # Errors
    /// If the text is not JSON, or an entry is not valid in a plan.
    #[cfg(feature = "cli")]
    pub fn from_json(text: &str) -> Result<Plan, PlanError> {
        crate::json::from_text(text).map_err(|error| entry(error.path, error.message))
    }
}

pub(super) fn entry(path: impl Into<String>, message: impl Into<String>) -> PlanError {
    PlanError::Entry { path: path.into(), message: message.into() }
}

/// Fails if a list of points cannot be a closed outline.
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
            return at("expected a point different from the next one");
        }
    }
    Ok(())
}
