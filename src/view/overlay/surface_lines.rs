//! Lines over the surface, between points that are not vertices of the mesh.

use crate::view::appearance::LineKind;
use crate::view::model::{Lists, ViewError, read_points};
use glam::DVec3;

/// Polylines of two kinds; nothing is drawn without points.
#[derive(Clone, Debug, Default)]
pub struct SurfaceLines {
    /// Points in file coordinates.
    pub(in crate::view) points: Vec<DVec3>,
    /// Two points of each line, and its [`LineKind`].
    pub(in crate::view) lines: Vec<[u32; 3]>,
    /// Changed since the last picture.
    pub(in crate::view) changed: bool,
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
        let polylines = Lists::new("lines on the surface", offsets, every, points.len())?;
        let lines = polylines.iter().enumerate().flat_map(|(k, line)| {
            let kind = if k < count { LineKind::Larger } else { LineKind::Smaller };
            line.windows(2).map(move |ends| [ends[0], ends[1], kind as u32])
        });
        Ok(SurfaceLines { lines: lines.collect(), points, changed: true })
    }

    /// Creates an empty set of lines, which clears those drawn before.
    pub fn none() -> SurfaceLines {
        SurfaceLines { changed: true, ..SurfaceLines::default() }
    }
}
