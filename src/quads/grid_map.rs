//! What map and extraction exchange: a triangulated surface, and a map of it to the plane in which the
//! integer grid is the quad mesh (integer-grid map: Bommes, Campen, Ebke, Alliez and Kobbelt 2013).
//!
//! Coordinates are in fixed point, so that every transition between triangles is exact and every
//! question of the extraction has an exact answer.

use crate::math::Vec3;

/// Number of fractional bits of the coordinates of a [`GridMap`].
pub const FRACTION_BITS: u32 = 20;
/// One unit of u or v, the side of one panel, in a [`GridMap`].
pub const UNIT: i64 = 1 << FRACTION_BITS;

/// A side of a triangle, from corner `side` to corner `side + 1` (modulo three).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Side {
    /// Index of the triangle.
    pub triangle: usize,
    /// 0, 1 or 2.
    pub side: usize,
}

/// A connected, consistently oriented surface of triangles. Every side has at most one neighbour,
/// and the triangles at a vertex are one fan.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangulation {
    /// `#V by 3`, in the unit of the input.
    pub positions: Vec<Vec3<f64>>,
    /// `#T by 3`, counterclockwise.
    pub triangles: Vec<[usize; 3]>,
    /// `#T by 3`: the same side as the neighbouring triangle has it; `None` at the boundary.
    pub neighbours: Vec<[Option<Side>; 3]>,
    /// `#T by 3`: whether a side lies on a feature, along which the grid runs: the boundary where it
    /// is followed, and creases. The same on both sides.
    pub feature: Vec<[bool; 3]>,
    /// `#V`: the vertex of the input; `None` of those that were added.
    pub vertices: Vec<Option<u32>>,
}

impl Triangulation {
    /// The vertex at a corner, counted modulo three.
    pub fn corner(&self, triangle: usize, corner: usize) -> usize {
        self.triangles[triangle][corner % 3]
    }

    /// The position at a corner, counted modulo three.
    pub fn at(&self, triangle: usize, corner: usize) -> Vec3<f64> {
        self.positions[self.corner(triangle, corner)]
    }

    /// The vector along a side.
    pub fn along(&self, Side { triangle, side }: Side) -> Vec3<f64> {
        self.at(triangle, side + 1) - self.at(triangle, side)
    }

    /// Twice the area of a triangle, times its unit normal.
    pub fn area_vector(&self, triangle: usize) -> Vec3<f64> {
        let [a, b, c] = self.triangles[triangle].map(|v| self.positions[v]);
        (b - a).cross(c - a)
    }

    /// Barycentric coordinates of the foot of a point in the plane of a triangle.
    pub(super) fn barycentric(&self, triangle: usize, point: Vec3<f64>) -> [f64; 3] {
        let area = self.area_vector(triangle);
        let square = area.length_squared();
        [0, 1, 2].map(|k| {
            let [b, c] = [1, 2].map(|next| self.at(triangle, k + next) - point);
            b.cross(c).dot(area) / square
        })
    }

    /// All sides, triangle by triangle.
    pub fn sides(&self) -> impl Iterator<Item = Side> + use<> {
        (0..self.triangles.len())
            .flat_map(|triangle| (0..3).map(move |side| Side { triangle, side }))
    }

    /// The side across, if any.
    pub fn across(&self, Side { triangle, side }: Side) -> Option<Side> {
        self.neighbours[triangle][side]
    }

    /// Whether a side lies on a feature.
    pub fn is_feature(&self, Side { triangle, side }: Side) -> bool {
        self.feature[triangle][side]
    }

    /// Whether each vertex is on the boundary of the surface, `#V`.
    pub fn boundary_vertices(&self) -> Vec<bool> {
        let mut found = vec![false; self.positions.len()];
        for side in self.sides().filter(|&side| self.across(side).is_none()) {
            found[self.corner(side.triangle, side.side)] = true;
            found[self.corner(side.triangle, side.side + 1)] = true;
        }
        found
    }
}

/// A map of each triangle to the plane, with transitions that carry the integer grid over every side.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GridMap {
    /// `#T by 3 by 2`: u and v of each corner, in units of one [`UNIT`]th.
    pub corners: Vec<[[i64; 2]; 3]>,
    /// `#T by 3`: from the coordinates of the triangle to those of its neighbour over the side; the
    /// identity where there is none.
    pub transitions: Vec<[Transition; 3]>,
}

impl GridMap {
    /// Twice the area of a mapped triangle in squares of the fixed-point unit; positive unless it is
    /// flipped or degenerate.
    pub fn doubled_area(&self, triangle: usize) -> i128 {
        let [a, b, c] = self.corners[triangle].map(|point| point.map(i128::from));
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    }
}

/// A turn by quarters and a shift of the plane that keep the integer grid:
/// `x_g = R^quarter_turns x_f + shift`, R counterclockwise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Transition {
    /// 0 to 3.
    pub quarter_turns: u8,
    /// A multiple of [`UNIT`].
    pub shift: [i64; 2],
}

impl Transition {
    /// The image of a point.
    pub fn apply(self, point: [i64; 2]) -> [i64; 2] {
        let [x, y] = self.turn(point);
        [x + self.shift[0], y + self.shift[1]]
    }

    /// The image of a direction.
    pub fn turn(self, [x, y]: [i64; 2]) -> [i64; 2] {
        match self.quarter_turns % 4 {
            0 => [x, y],
            1 => [-y, x],
            2 => [-x, -y],
            _ => [y, -x],
        }
    }

    /// The transition back.
    pub fn inverse(self) -> Transition {
        let quarter_turns = (4 - self.quarter_turns % 4) % 4;
        let back = Transition { quarter_turns, shift: [0, 0] };
        let [x, y] = back.turn(self.shift);
        Transition { quarter_turns, shift: [-x, -y] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transition_and_its_inverse_cancel() {
        for quarter_turns in 0..4 {
            let there = Transition { quarter_turns, shift: [3 * UNIT, -7 * UNIT] };
            for point in [[0, 0], [5, 9], [-UNIT, 12345]] {
                assert_eq!(there.inverse().apply(there.apply(point)), point);
                assert_eq!(there.apply(there.inverse().apply(point)), point);
            }
        }
    }
}
