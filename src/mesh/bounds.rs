//! Smallest enclosing ball of a point set, the diagonal of its box, and the limit on coordinates.
//!
//! The errors `e_p` and `e_c` refer to a ball of diameter 1 (paper Fig. 5).

use super::Point;
use crate::math::Vec3;

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
