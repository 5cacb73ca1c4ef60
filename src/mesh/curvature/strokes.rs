//! Short strokes along the directions of principal curvature, two on each face.

use super::field::{CurvatureField, Family};
use crate::mesh::Point;

/// Half the length of a stroke, as a part of the mean edge.
const HALF: f64 = 0.3;

impl CurvatureField {
    /// A stroke through the middle of each face along the directions of a family, by its ends; none where the surface
    /// is flat or bends alike in all directions.
    pub fn strokes(&self, family: Family) -> Vec<[Point; 2]> {
        let half = HALF * self.mean_edge();
        let middles = self.middles();
        let directed = middles.filter_map(|place| {
            let way = self.direction(place, family, super::edges::UMBILIC)?;
            Some([place.at - way * half, place.at + way * half].map(Point::from))
        });
        directed.collect()
    }
}
