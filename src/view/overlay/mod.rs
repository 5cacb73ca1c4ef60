//! Overlays: everything drawn beside the mesh. The ghost of the mesh as it was opened, the ground
//! grid, a layer joined to the surface by posts, and lines over the surface are lines between their
//! own points.

pub mod ground;
pub mod ground_shadow;
pub mod scale_bar;

pub use ground::Ground;
pub use ground_shadow::GroundShadow;
pub use scale_bar::scale_bar;

use crate::view::appearance::LineKind;
use crate::view::model::{ViewError, read_points, rows};
use glam::DVec3;

/// The ghost and the ground.
#[derive(Clone, Debug, Default)]
pub struct Surroundings {
    /// Positions of the mesh as it was opened, #V in file coordinates; empty if not known.
    pub(in crate::view) rest: Vec<DVec3>,
    /// Corners of the box around these, or around the mesh as it was first shown until they are known.
    pub(in crate::view) extent: [DVec3; 2],
    pub(in crate::view) ghost: bool,
    pub(in crate::view) ground: bool,
    /// The grid, if it is shown and the rest positions are known.
    pub(in crate::view) grid: Ground,
}

impl Surroundings {
    /// Returns the rest positions, #V in file coordinates; empty if not known.
    pub fn rest(&self) -> &[DVec3] {
        &self.rest
    }

    /// Returns the spacing of the grid, in the unit of the file; none if it is not drawn.
    pub fn grid_step(&self) -> Option<f64> {
        (!self.grid.lines.is_empty()).then_some(self.grid.step)
    }
}

/// Polylines of two kinds; nothing is drawn without points.
#[derive(Clone, Debug, Default)]
pub struct SurfaceLines {
    /// Points in file coordinates.
    pub(in crate::view) points: Vec<DVec3>,
    /// Two points of each line, and its [`LineKind`].
    pub(in crate::view) lines: Vec<[u32; 3]>,
}

impl SurfaceLines {
    /// Creates polylines through `coordinates`, #points by 3: polyline `k` has the points from
    /// `offsets[k]` to `offsets[k + 1]`. The first `count` are along the larger principal
    /// curvature, the others along the smaller one.
    ///
    /// # Errors
    /// Arrays that do not fit together, or a coordinate that is not finite.
    pub fn new(
        coordinates: &[f64],
        offsets: Vec<u32>,
        count: usize,
    ) -> Result<SurfaceLines, ViewError> {
        let points = read_points(coordinates)?;
        let every = (0..points.len() as u32).collect();
        let polylines = rows("lines on the surface", offsets, every, points.len())?;
        let lines = polylines.iter().enumerate().flat_map(|(k, line)| {
            let kind = if k < count { LineKind::Larger } else { LineKind::Smaller };
            line.windows(2).map(move |ends| [ends[0], ends[1], kind as u32])
        });
        Ok(SurfaceLines { lines: lines.collect(), points })
    }
}

/// A layer; nothing is drawn without points.
#[derive(Clone, Debug, Default)]
pub struct ShownLayer {
    /// #V in file coordinates, or empty.
    pub(in crate::view) points: Vec<DVec3>,
    /// Edges that fail, by their ends: drawn on the surface and in the layer, with their posts.
    pub(in crate::view) failed_edges: Vec<[u32; 2]>,
    pub(in crate::view) failed_vertices: Vec<u32>,
}
