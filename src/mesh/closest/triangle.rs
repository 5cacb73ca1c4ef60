//! Closest point on a triangle, and a cheap lower bound on its distance.
//!
//! The plane of a triangle and the three planes perpendicular to it through its sides give a lower
//! bound on the distance without a branch. The bound is sharp if the closest point is inside the
//! triangle or on a side, so the exact distance is needed for few of the triangles around a point.

use crate::math::{Lane, Pair, Vec3};
use crate::mesh::Point;

/// The plane of a triangle, and the planes perpendicular to it through its sides, with outward
/// normals, packed in pairs for two-lane SIMD.
///
/// A segment `ab` is the triangle `abb`; its planes are perpendicular to it at both ends. A point
/// is the triangle `aaa`, which has no planes.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Planes {
    /// Unit normals of the triangle and side ab, and of the sides bc and ca.
    normals: [Vec3<Pair>; 2],
    /// Offsets of the planes: the term added to the inner product with the normal.
    offsets: [Pair; 2],
}

/// Signed distances of a point to the four planes.
#[derive(Clone, Copy)]
pub(crate) struct PlaneDistances {
    /// To the plane of the triangle.
    pub(crate) height: f64,
    /// To the planes of the sides ab, bc, ca; positive outside.
    pub(crate) out: [f64; 3],
}

impl Planes {
    pub(crate) fn new([a, b, c]: [Vec3<f64>; 3]) -> Planes {
        let normal = (b - a).cross(c - a);
        let area = normal.length();
        let nothing = (Vec3::zero(), 0.0);
        let [plane, ab, bc, ca] = if area > 0.0 {
            let normal = normal * (1.0 / area);
            let side = |from: Vec3<f64>, to: Vec3<f64>| plane(from, (to - from).cross(normal));
            [plane(a, normal), side(a, b), side(b, c), side(c, a)]
        } else {
            // Side ca is the whole segment: every point is just outside this pseudo-plane, so that
            // `closest` always projects to that side.
            let whole = (Vec3::zero(), f64::MIN_POSITIVE);
            if a == b {
                [nothing, nothing, nothing, whole]
            } else {
                [nothing, plane(b, b - a), plane(a, a - b), whole]
            }
        };
        let mut planes = Planes {
            normals: [Vec3::new(Pair::zero(), Pair::zero(), Pair::zero()); 2],
            offsets: [pair(plane.1, ab.1), pair(bc.1, ca.1)],
        };
        for (i, pair) in [[plane, ab], [bc, ca]].into_iter().enumerate() {
            for (lane, (normal, _)) in pair.into_iter().enumerate() {
                planes.normals[i].set_lane(lane, normal);
            }
        }
        planes
    }

    /// Returns the distances of the point `p`, given in both lanes, to the planes.
    #[inline(always)]
    pub(crate) fn distances(&self, p: Vec3<Pair>) -> PlaneDistances {
        let first = self.normals[0].dot(p) + self.offsets[0];
        let second = self.normals[1].dot(p) + self.offsets[1];
        PlaneDistances {
            height: first.lane(0),
            out: [first.lane(1), second.lane(0), second.lane(1)],
        }
    }

    /// Projects `p`, which has these `distances`, to the plane of the triangle.
    #[inline(always)]
    pub(crate) fn foot(&self, p: Vec3<f64>, distances: PlaneDistances) -> Vec3<f64> {
        p - self.normals[0].lane(0) * distances.height
    }

    pub(crate) fn side_normals(&self) -> [Vec3<f64>; 3] {
        [self.normals[0].lane(1), self.normals[1].lane(0), self.normals[1].lane(1)]
    }

    /// Returns the distances of the corners of another triangle.
    #[inline(always)]
    pub(crate) fn distances_of(&self, other: &Corners) -> [PlaneDistances; 3] {
        let [a, b, c] = other.at;
        [self.distances(splat(a)), self.distances(splat(b)), self.distances(splat(c))]
    }
}

/// Returns a lower bound on the distance between two triangles, given the distances of the corners of
/// one to the planes of the other.
#[inline(always)]
pub(crate) fn gap(distances: &[PlaneDistances; 3]) -> f64 {
    let least = |of: fn(&PlaneDistances) -> f64| {
        let [a, b, c] = [of(&distances[0]), of(&distances[1]), of(&distances[2])];
        Lane::min(a, Lane::min(b, c))
    };
    let sides = Lane::max(least(|o| o.out[0]), Lane::max(least(|o| o.out[1]), least(|o| o.out[2])));
    let plane = Lane::max(least(|o| o.height), least(|o| -o.height));
    Lane::max(0.0, Lane::max(sides, plane))
}

impl PlaneDistances {
    /// Whether the triangle can be nearer than the square root of `bound`. Branch-free, so without
    /// `max`, which is a branch in wasm.
    #[inline(always)]
    pub(crate) fn within(&self, bound: f64) -> bool {
        let height_squared = self.height * self.height;
        let beyond = |out: f64| {
            let positive = 0.5 * (out + out.abs());
            height_squared + positive * positive
        };
        let [ab, bc, ca] = self.out.map(beyond);
        (ab < bound) & (bc < bound) & (ca < bound)
    }

    /// Whether the point projects into the triangle.
    #[inline(always)]
    fn is_inside(&self) -> bool {
        let [ab, bc, ca] = self.out;
        (ab <= 0.0) & (bc <= 0.0) & (ca <= 0.0)
    }
}

/// Returns a plane through a point as unit normal and offset.
fn plane(through: Vec3<f64>, direction: Vec3<f64>) -> (Vec3<f64>, f64) {
    let normal = direction * (1.0 / direction.length());
    (normal, -normal.dot(through))
}

fn pair(low: f64, high: f64) -> Pair {
    Pair::from_fn(|lane| if lane == 0 { low } else { high })
}

/// Copies a point to both lanes.
#[inline(always)]
pub(crate) fn splat(p: Vec3<f64>) -> Vec3<Pair> {
    Vec3::new(Pair::splat(p.x), Pair::splat(p.y), Pair::splat(p.z))
}

#[derive(Clone, Debug)]
pub(crate) struct Corners {
    pub(crate) at: [Vec3<f64>; 3],
    /// Reciprocals of the squared lengths of the sides ab, bc, ca; 0 where the ends coincide.
    inverse: [f64; 3],
}

/// A point of a surface and its squared distance to the query point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    pub(crate) point: Vec3<f64>,
    pub(crate) distance_squared: f64,
}

impl Corners {
    /// Builds the triangle with these corners. It must not be a sliver, unless two corners
    /// coincide.
    pub(crate) fn new(at: [Vec3<f64>; 3]) -> Corners {
        let inverse = std::array::from_fn(|k| {
            let squared = (at[(k + 1) % 3] - at[k]).length_squared();
            if squared > 0.0 { 1.0 / squared } else { 0.0 }
        });
        Corners { at, inverse }
    }

    pub(crate) fn touches(&self, other: &Corners) -> bool {
        self.at.iter().any(|corner| other.at.contains(corner))
    }

    /// Returns the point of the triangle closest to `p`, which has these `distances` to `planes`.
    #[inline(always)]
    pub(crate) fn closest(&self, planes: &Planes, p: Vec3<f64>, distances: PlaneDistances) -> Hit {
        if distances.is_inside() {
            let point = planes.foot(p, distances);
            return Hit { point, distance_squared: distances.height * distances.height };
        }
        let mut best = Hit { point: p, distance_squared: f64::INFINITY };
        for k in 0..3 {
            if distances.out[k] > 0.0 {
                let from = self.at[k];
                let side = self.at[(k + 1) % 3] - from;
                let along = side.dot(p - from) * self.inverse[k];
                let point = from + side * Lane::min(Lane::max(along, 0.0), 1.0);
                let distance_squared = (p - point).length_squared();
                if distance_squared < best.distance_squared {
                    best = Hit { point, distance_squared };
                }
            }
        }
        best
    }
}

/// Whether a triangle is so thin that rounding decides what is inside: its height is at most 1e-8
/// of its longest side. Its three sides then replace it.
pub(crate) fn is_sliver(corners: [Point; 3]) -> bool {
    const THINNEST: f64 = 1e-8;
    let [a, b, c] = corners.map(Vec3::from);
    let longest_squared =
        (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
    (b - a).cross(c - a).length() <= THINNEST * longest_squared
}
