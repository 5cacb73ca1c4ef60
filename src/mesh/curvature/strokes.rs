//! Short strokes along the directions of principal curvature, two on each face.

use super::field::{CurvatureField, Family};
use crate::mesh::Point;

/// Half the length of a stroke, as a fraction of the mean edge.
const HALF: f64 = 0.3;

impl CurvatureField {
    /// Returns the ends of a stroke through the centre of each face along the direction of a
    /// family. Faces where the surface is flat or umbilic have no stroke.
    pub fn strokes(&self, family: Family) -> Vec<[Point; 2]> {
        let half = HALF * self.mean_edge();
        let centres = self.centres();
        let directed = centres.filter_map(|point| {
            let direction = self.direction(point, family, super::edges::UMBILIC)?;
            Some([point.at - direction * half, point.at + direction * half].map(Point::from))
        });
        directed.collect()
    }
}
