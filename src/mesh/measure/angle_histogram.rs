//! Histogram of the corner angles of faces (paper Fig. 7).

use crate::math::{Vec3, cosine, polygon_corners};
use crate::mesh::{Point, Ragged};

/// Counts the corners of `faces` at `positions` (`#V by 3`) by their angles, in `bins` of equal
/// width from 0 to 180 degrees. An angle on the bound of two bins is in the upper one. Corners at a
/// side of zero length have no angle and are not counted.
pub fn angle_histogram(positions: &[Point], faces: &Ragged, bins: usize) -> Vec<u32> {
    // Angles are compared by their cosines, which decrease with the angle.
    let bound = |k: usize| cosine(0.5 * k as f64 / bins as f64);
    let bounds: Vec<f64> = (1..bins).map(bound).collect();
    let at = |v: u32| Vec3::from(positions[v as usize]);
    let mut counts = vec![0; bins];
    for face in faces.iter() {
        for [before, here, after] in polygon_corners(face) {
            let here = at(here);
            let (before, after) = (at(before) - here, at(after) - here);
            let lengths = before.length() * after.length();
            if lengths > 0.0 {
                let cosine = before.dot(after) / lengths;
                counts[bounds.partition_point(|&bound| cosine <= bound)] += 1;
            }
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_fall_into_their_bins() {
        // A square, a triangle of 30, 60 and 90 degrees, and one without area or angles.
        let height = 3.0f64.sqrt();
        let positions = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, height, 0.0],
        ];
        let mut faces = Ragged::new();
        faces.push(&[0, 1, 2, 3]);
        faces.push(&[0, 1, 4]);
        faces.push(&[2, 2, 2]);
        // Bins of 10 degrees.
        let counts = angle_histogram(&positions, &faces, 18);
        let mut expected = [0; 18];
        (expected[3], expected[6]) = (1, 1);
        expected[9] = 5;
        let near = |from: usize| counts[from - 1] + counts[from];
        // 30, 60 and 90 degrees are bounds of bins up to rounding.
        for k in [3, 6, 9] {
            assert_eq!(near(k), expected[k], "{counts:?}");
        }
        assert_eq!(counts.iter().sum::<u32>(), 7);
    }

    #[test]
    fn a_mesh_at_any_scale_has_the_same_angles() {
        let mut faces = Ragged::new();
        faces.push(&[0, 1, 2]);
        let counts = |scale: f64| {
            let corners = [[0.0, 0.0, 0.0], [1.0, 0.2, 0.1], [0.3, 0.9, -0.2]];
            angle_histogram(&corners.map(|p| p.map(|x| x * scale)), &faces, 36)
        };
        assert_eq!(counts(1.0), counts(1e-3));
        assert_eq!(counts(1.0), counts(1e3));
        assert_eq!(counts(1.0).iter().sum::<u32>(), 3);
    }
}
