//! The size of a mesh: what it is made of, the smallest ball around that, the diagonal of its box, and
//! the limit on coordinates.
//!
//! The errors `e_p` and `e_c` refer to a ball of diameter 1 (paper Fig. 5).

use super::{Mesh, Point, Ragged};
use crate::math::Vec3;
use std::borrow::Cow;

/// Largest absolute value of a coordinate: sixth powers of lengths, the highest that are computed,
/// stay finite.
pub const LARGEST_COORDINATE: f64 = 1e50;

/// Index of the first position (of `#V by 3`) with a coordinate beyond [`LARGEST_COORDINATE`] or
/// NaN.
pub fn first_out_of_range(positions: &[Point]) -> Option<usize> {
    positions.iter().position(|point| !point.iter().all(|x| x.abs() <= LARGEST_COORDINATE))
}

/// Returns the diagonal of the bounding box of points; 0 without points.
pub fn diagonal(points: &[Point]) -> f64 {
    let squared = |axis: usize| {
        let ends = points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| {
            [low.min(point[axis]), high.max(point[axis])]
        });
        let side = (ends[1] - ends[0]).max(0.0);
        side * side
    };
    (squared(0) + squared(1) + squared(2)).sqrt()
}

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundingSphere {
    /// Centre.
    pub centre: Point,
    /// Radius; 0 for a single point.
    pub radius: f64,
}

impl BoundingSphere {
    /// Returns the smallest ball that contains the finite `points`, up to rounding; without points,
    /// radius 0 at the origin.
    ///
    /// At most four of the points, its support, determine the ball. Starting from one point, the
    /// farthest point outside is added to the support, and the smallest ball of these at most five
    /// points, found by trying all subsets, is the next ball. Each ball is larger than the one
    /// before, so this ends, after about ten rounds (compare Gaertner, *Fast and robust smallest
    /// enclosing balls*, 1999).
    pub fn of(points: &[Point]) -> BoundingSphere {
        let Some(&first) = points.first() else {
            return BoundingSphere { centre: [0.0; 3], radius: 0.0 };
        };
        let origin = Vec3::from(first);
        let at = |i: usize| Vec3::from(points[i]) - origin;
        let mut ball = Ball { centre: Vec3::zero(), radius_squared: 0.0, support: vec![0] };
        let mut farthest = ball.farthest(points.len(), at);
        while !ball.support.contains(&farthest.0) && farthest.1 > ball.radius_squared {
            // No ball is larger when only a rounding error is left.
            let Some(greater) = ball.with(farthest.0, at) else { break };
            ball = greater;
            farthest = ball.farthest(points.len(), at);
        }
        let radius_squared = if farthest.1 > 0.0 { farthest.1 } else { 0.0 };
        BoundingSphere { centre: (origin + ball.centre).into(), radius: radius_squared.sqrt() }
    }

    /// Twice the radius.
    pub fn diameter(&self) -> f64 {
        2.0 * self.radius
    }
}

struct Ball {
    centre: Vec3<f64>,
    radius_squared: f64,
    /// The support: at most four points on the surface that determine the ball.
    support: Vec<usize>,
}

impl Ball {
    /// Returns the first of the points farthest from the centre, and its squared distance.
    fn farthest(&self, n: usize, at: impl Fn(usize) -> Vec3<f64>) -> (usize, f64) {
        (0..n).fold((0, -1.0), |farthest, i| {
            let squared = (at(i) - self.centre).length_squared();
            if squared > farthest.1 { (i, squared) } else { farthest }
        })
    }

    /// Returns the smallest ball of the support and of one point outside, which lies on its
    /// surface; `None` if it is not larger than this ball.
    fn with(&self, outside: usize, at: impl Fn(usize) -> Vec3<f64>) -> Option<Ball> {
        let mut least: Option<Ball> = None;
        for subset in 0..1_usize << self.support.len() {
            let chosen = self.support.iter().enumerate().filter(|(k, _)| subset >> k & 1 == 1);
            let mut support = vec![outside];
            support.extend(chosen.map(|(_, &i)| i));
            if support.len() > 4 {
                continue;
            }
            let sides: Vec<Vec3<f64>> = support[1..].iter().map(|&i| at(i) - at(outside)).collect();
            let Some(to_centre) = circumcentre(&sides) else { continue };
            let (centre, radius_squared) = (at(outside) + to_centre, to_centre.length_squared());
            // Points on the surface can lie slightly outside, by rounding.
            let holds =
                |i: &usize| (at(*i) - centre).length_squared() <= radius_squared * (1.0 + 1e-12);
            if radius_squared > self.radius_squared
                && least.as_ref().is_none_or(|least| radius_squared < least.radius_squared)
                && self.support.iter().all(holds)
            {
                least = Some(Ball { centre, radius_squared, support });
            }
        }
        least
    }
}

/// Returns the circumcentre of the origin and at most three `points`, in the space that they span;
/// `None` if they are linearly dependent.
fn circumcentre(points: &[Vec3<f64>]) -> Option<Vec3<f64>> {
    let half = |p: Vec3<f64>| 0.5 * p.length_squared();
    let (sum, weight) = match *points {
        [] => return Some(Vec3::zero()),
        [a] => (a * half(a), a.length_squared()),
        [a, b] => {
            let normal = a.cross(b);
            let sum = b.cross(normal) * half(a) + normal.cross(a) * half(b);
            (sum, normal.length_squared())
        }
        [a, b, c] => {
            let sum = b.cross(c) * half(a) + c.cross(a) * half(b) + a.cross(b) * half(c);
            (sum, a.dot(b.cross(c)))
        }
        _ => panic!("a ball in space is determined by at most four points"),
    };
    let centre = sum * (1.0 / weight);
    (weight != 0.0 && centre.length_squared().is_finite()).then_some(centre)
}

impl Mesh {
    /// The positions of the vertices of faces, curves and tetrahedra; of a point set, all: where
    /// something is. Files have stray vertices, often at the origin.
    pub fn used_positions(&self) -> Cow<'_, [Point]> {
        let tets = self.tets.as_flattened();
        let [faces, curves, untouched] =
            [&self.faces, &self.curves, &self.untouched].map(Ragged::indices);
        at_vertices(&self.positions, &[faces, curves, tets, untouched])
    }

    /// What the mesh is made of.
    pub(crate) fn body(&self) -> Body {
        if !self.faces.is_empty() {
            Body::Faces
        } else if !self.tets.is_empty() {
            Body::Tetrahedra
        } else if !self.curves.is_empty() {
            Body::Curves
        } else {
            Body::Points
        }
    }

    /// The entries of `positions` (`#V by 3`) at the vertices of its [`Body`].
    pub(crate) fn body_of<'a>(&self, positions: &'a [Point]) -> Cow<'a, [Point]> {
        let untouched = self.untouched.indices();
        match self.body() {
            Body::Faces => at_vertices(positions, &[self.faces.indices(), untouched]),
            Body::Tetrahedra => at_vertices(positions, &[self.tets.as_flattened()]),
            Body::Curves => at_vertices(positions, &[self.curves.indices()]),
            Body::Points => at_vertices(positions, &[untouched]),
        }
    }

    /// The size of the mesh: the diameter of the smallest ball around its faces, in its unit, which is 1 in
    /// the scale of `e_p` and `e_c`. Curves and tetrahedra count only without faces, lone vertices only in a
    /// point set.
    pub fn size(&self) -> f64 {
        BoundingSphere::of(&self.body_of(&self.positions)).diameter()
    }
}

/// What a mesh is made of. It alone decides how large the mesh is, how long its edges are and how it
/// is curved: guide lines and the outline of a site beside it change nothing of that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Body {
    /// Of faces, if it has any.
    Faces,
    /// Else of tetrahedra.
    Tetrahedra,
    /// Else of curves.
    Curves,
    /// It has no elements.
    Points,
}

/// The entries of `positions` at the vertices of `lists`; all if these have none.
pub(crate) fn at_vertices<'a>(positions: &'a [Point], lists: &[&[u32]]) -> Cow<'a, [Point]> {
    let mut used = vec![false; positions.len()];
    lists.iter().copied().flatten().for_each(|&v| used[v as usize] = true);
    let count = used.iter().filter(|used| **used).count();
    if count == 0 || count == used.len() {
        return Cow::Borrowed(positions);
    }
    let pairs = positions.iter().zip(used);
    pairs.filter_map(|(&point, used)| used.then_some(point)).collect()
}
