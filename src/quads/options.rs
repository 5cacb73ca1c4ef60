//! What can be chosen of a remeshing, and how far it has come.

use serde::{Deserialize, Serialize};

/// More panels than this are refused.
pub(super) const MOST_PANELS: f64 = 100_000.0;

/// What the grid does at the boundary of the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "lowercase")]
pub enum Boundary {
    /// The boundary is a line of the grid.
    #[default]
    #[serde(rename = "follow")]
    Followed,
    /// The grid runs over the boundary, which cuts its panels.
    Cut,
}

impl Boundary {
    /// The word of the command line.
    pub fn word(self) -> &'static str {
        match self {
            Boundary::Followed => "follow",
            Boundary::Cut => "cut",
        }
    }
}

/// The size of panels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PanelSize {
    /// Length of a side in the unit of the mesh; the number follows.
    Length(f64),
    /// Number of panels of the whole surface; the length follows.
    Count(usize),
}

/// Settings of the map. The defaults are those of `reference/quads.md`, in the words of its section 4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapOptions {
    /// Size or number of panels.
    pub size: PanelSize,
    /// Weight of alignment with curvature against few irregular vertices, lambda: 0 to 80.
    pub follow: f64,
    /// Weight of directions against even sizes where the surface is curved, D: 1 to 100.
    pub direction: f64,
    /// Edges that turn by more degrees are creases, which the grid follows; `None` follows none.
    pub crease: Option<f64>,
    /// What the grid does at the boundary.
    pub boundary: Boundary,
}

impl MapOptions {
    /// The defaults with this size.
    pub fn of_size(size: PanelSize) -> MapOptions {
        MapOptions {
            size,
            follow: 20.0,
            direction: 30.0,
            crease: Some(40.0),
            boundary: Boundary::Followed,
        }
    }
}

/// The stages of a remeshing, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum RemeshStage {
    /// Curvature, features, refinement.
    Prepare,
    /// The cross field.
    Field,
    /// The seamless map.
    Map,
    /// Rounding to the integer grid.
    Round,
    /// The quads of the grid.
    Extract,
    /// Checks of the result.
    Verify,
}

impl RemeshStage {
    /// What is done, in words.
    pub fn words(self) -> &'static str {
        match self {
            RemeshStage::Prepare => "Measuring the curvature …",
            RemeshStage::Field => "Following the lines of curvature …",
            RemeshStage::Map => "Laying out a grid …",
            RemeshStage::Round => "Closing the grid …",
            RemeshStage::Extract => "Cutting panels …",
            RemeshStage::Verify => "Checking the panels …",
        }
    }
}

/// Told each stage as it begins, perhaps several times.
pub type RemeshObserver<'a> = dyn FnMut(RemeshStage) + 'a;
