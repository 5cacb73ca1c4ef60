//! The weights of Eq. 12 for polygons with any number of corners, planar or not: Alexa and
//! Wardetzky, "Discrete Laplacians on General Polygonal Meshes", 2011.
//!
//! With `d` the differences along the sides of a face, its Laplacian is `d^T (B B^T / |f| + U) d`.
//! The rows of `B` are the midpoints of the sides, and `|f|` is the length of the vector area. `U`
//! is a multiple of the orthogonal projection onto the complement of the differences of linear
//! functions, on the face projected along its vector area. On triangles that complement is zero,
//! and the first term is the cotangent formula.

use super::cotangent::LARGEST_COTANGENT;
use crate::math::{PrincipalAxes, Vec3, twice_vector_area};
use crate::mesh::Point;

/// Factor of the projection in `U`, a free parameter of the method. With this value opposite
/// corners of a square have weight zero, and all weights on a grid of squares are one, as uniform
/// weights.
const STABILITY: f64 = 0.5;

/// Relative extent below which a direction of the projected face, or its vector area, counts as
/// rounding error.
const FLAT: f64 = 1e-10;

/// The weights of the pairs of corners of one face at a time.
#[derive(Default)]
pub(crate) struct PolygonWeights {
    /// The rows of `d^T B / |f|^1/2`, per corner: half the vector from the previous to the next
    /// corner, scaled.
    across: Vec<Vec3<f64>>,
    /// The rows of `d^T Q`, per corner, where `Q` is an orthonormal basis of the differences of
    /// linear functions.
    linear: Vec<Vec3<f64>>,
}

impl PolygonWeights {
    /// Computes the weights of the face with these corners. The area is bounded below so that no
    /// entry of the first term exceeds [`LARGEST_COTANGENT`]: faces without area have finite
    /// weights.
    pub(crate) fn take(&mut self, corners: &[Point]) {
        let n = corners.len();
        let at = |k: usize| Vec3::from(corners[k % n]);
        let vector_area = twice_vector_area((0..n).map(at)) * 0.5;

        self.across.clear();
        self.across.extend((0..n).map(|k| (at(k + 1) - at(k + n - 1)) * 0.5));
        let longest = self.across.iter().fold(0.0, |m: f64, v| m.max(v.length_squared()));
        let area = vector_area.length().max(longest / LARGEST_COTANGENT);
        let scale = if area > 0.0 { 1.0 / area.sqrt() } else { 0.0 };
        self.across.iter_mut().for_each(|v| *v = *v * scale);

        let has_direction = vector_area.length() > FLAT * longest;
        let normal =
            if has_direction { vector_area * (1.0 / vector_area.length()) } else { Vec3::zero() };
        let mut sides: Vec<Vec3<f64>> = (0..n).map(|k| at(k + 1) - at(k)).collect();
        sides.iter_mut().for_each(|side| *side -= normal * normal.dot(*side));
        PrincipalAxes::rotate(&mut sides);
        let squares = sides.iter().fold([0.0; 3], |[x, y, z], side| {
            [x + side.x * side.x, y + side.y * side.y, z + side.z * side.z]
        });
        let unit =
            squares.map(
                |square| {
                    if square > FLAT * FLAT * squares[0] { 1.0 / square.sqrt() } else { 0.0 }
                },
            );
        let basis = |k: usize| {
            let side = sides[k % n];
            Vec3::new(side.x * unit[0], side.y * unit[1], side.z * unit[2])
        };
        self.linear.clear();
        self.linear.extend((0..n).map(|k| basis(k + n - 1) - basis(k)));
    }

    /// Returns the weight of the corners `i` and `j` of the face, `i < j`.
    pub(crate) fn weight(&self, i: usize, j: usize) -> f64 {
        let are_neighbours = j - i == 1 || j - i + 1 == self.across.len();
        let beside_linear =
            f64::from(u8::from(are_neighbours)) + self.linear[i].dot(self.linear[j]);
        STABILITY * beside_linear - self.across[i].dot(self.across[j])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn weights(corners: &[Point]) -> Vec<f64> {
        let mut face = PolygonWeights::default();
        face.take(corners);
        let n = corners.len();
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        pairs.map(|(i, j)| face.weight(i, j)).collect()
    }

    #[test]
    fn a_triangle_has_half_its_cotangents() {
        // Right angle at the first corner; legs of 1 and 2.
        let found = weights(&[[0.0; 3], [0.6, 0.8, 0.0], [0.0, 0.0, 2.0]]);
        for (found, cotangent) in found.into_iter().zip([2.0, 0.5, 0.0]) {
            assert!((found - cotangent / 2.0).abs() < 1e-15, "{found} {cotangent}");
        }
    }

    #[test]
    fn a_square_joins_its_sides_as_uniform_weights_do() {
        let found = weights(&[[0.0; 3], [3.0, 0.0, 0.0], [3.0, 3.0, 0.0], [0.0, 3.0, 0.0]]);
        for (found, expected) in found.into_iter().zip([0.5, 0.0, 0.5, 0.5, 0.0, 0.5]) {
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
    }

    #[test]
    fn faces_without_area_have_finite_weights() {
        let (o, x) = ([0.0; 3], [1.0, 0.0, 0.0]);
        let bow_tie = [o, x, [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
        for corners in
            [&[o; 5][..], &[o, x, o, x], &[o, x, [2.0, 0.0, 0.0], [5.0, 0.0, 0.0]], &bow_tie]
        {
            let found = weights(corners);
            assert!(
                found.iter().all(|w| w.abs() <= 2.0 * LARGEST_COTANGENT),
                "{corners:?} {found:?}"
            );
        }
    }
}
