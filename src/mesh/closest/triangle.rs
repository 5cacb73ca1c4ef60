//! Closest point on a triangle, and a cheap bound that tells when it need not be found.
//!
//! The plane of a triangle and the three planes that stand on its sides give, without a branch, a
//! distance below which the triangle cannot be. The bound is met wherever the closest point is
//! inside or on a side, so that of all triangles around a point few are looked at twice.

use crate::math::{Lane, Pair, Vec3};
use crate::mesh::Point;

/// The plane of a triangle, and the planes through its sides that stand on it and look outwards.
/// They are packed in pairs, as one multiplication takes two lanes.
///
/// A segment `ab` is the triangle `abb`; its planes stand on it at both ends. A point is the
/// triangle `aaa`, which has none.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Planes {
    /// Unit normals: of the triangle and side ab; of the sides bc and ca.
    normals: [Vec3<Pair>; 2],
    /// The offset of the plane along the normal.
    offsets: [Pair; 2],
}

/// The signed distances of a point to the four planes.
#[derive(Clone, Copy)]
pub(crate) struct Over {
    /// To that of the triangle.
    pub(crate) height: f64,
    /// To those of the sides ab, bc, ca; positive outside.
    pub(crate) out: [f64; 3],
}

impl Planes {
    /// The planes of the triangle with these corners.
    pub(crate) fn new([a, b, c]: [Vec3<f64>; 3]) -> Planes {
        let normal = (b - a).cross(c - a);
        let area = normal.length();
        let nothing = (Vec3::zero(), 0.0);
        let [plane, ab, bc, ca] = if area > 0.0 {
            let normal = normal * (1.0 / area);
            let side = |from: Vec3<f64>, to: Vec3<f64>| plane(from, (to - from).cross(normal));
            [plane(a, normal), side(a, b), side(b, c), side(c, a)]
        } else {
            // The side ca is the whole segment. A plane that everything is just outside of says so.
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

    /// Where the point `p`, the same in both lanes, is.
    #[inline(always)]
    pub(crate) fn over(&self, p: Vec3<Pair>) -> Over {
        let first = self.normals[0].dot(p) + self.offsets[0];
        let second = self.normals[1].dot(p) + self.offsets[1];
        Over { height: first.lane(0), out: [first.lane(1), second.lane(0), second.lane(1)] }
    }

    /// The point of the plane of the triangle below or above `p`, which is `over` it.
    #[inline(always)]
    pub(crate) fn foot(&self, p: Vec3<f64>, over: Over) -> Vec3<f64> {
        p - self.normals[0].lane(0) * over.height
    }

    /// The outward normals of the planes on the sides ab, bc, ca.
    pub(crate) fn side_normals(&self) -> [Vec3<f64>; 3] {
        [self.normals[0].lane(1), self.normals[1].lane(0), self.normals[1].lane(1)]
    }

    /// At least this far apart are this triangle and another one.
    pub(crate) fn gap(&self, corners: &[Vec3<f64>; 3]) -> f64 {
        let [a, b, c] = *corners;
        let over = [self.over(splat(a)), self.over(splat(b)), self.over(splat(c))];
        let least = |of: fn(&Over) -> f64| {
            let [a, b, c] = [of(&over[0]), of(&over[1]), of(&over[2])];
            Lane::min(a, Lane::min(b, c))
        };
        let sides =
            Lane::max(least(|o| o.out[0]), Lane::max(least(|o| o.out[1]), least(|o| o.out[2])));
        let plane = Lane::max(least(|o| o.height), least(|o| -o.height));
        Lane::max(0.0, Lane::max(sides, plane))
    }
}

impl Over {
    /// Whether the triangle can be nearer than the square root of `bound`. Without a branch and
    /// without a maximum, which WebAssembly engines make a branch of.
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

    /// Whether the point is above or below the triangle.
    #[inline(always)]
    fn is_inside(&self) -> bool {
        let [ab, bc, ca] = self.out;
        (ab <= 0.0) & (bc <= 0.0) & (ca <= 0.0)
    }
}

/// A plane through a point: unit normal, and what is added to the inner product with it.
fn plane(through: Vec3<f64>, direction: Vec3<f64>) -> (Vec3<f64>, f64) {
    let normal = direction * (1.0 / direction.length());
    (normal, -normal.dot(through))
}

fn pair(low: f64, high: f64) -> Pair {
    Pair::from_fn(|lane| if lane == 0 { low } else { high })
}

/// The same point in both lanes.
#[inline(always)]
pub(crate) fn splat(p: Vec3<f64>) -> Vec3<Pair> {
    Vec3::new(Pair::splat(p.x), Pair::splat(p.y), Pair::splat(p.z))
}

/// The corners of a triangle.
#[derive(Clone, Debug)]
pub(crate) struct Corners {
    pub(crate) at: [Vec3<f64>; 3],
    /// One over the squared lengths of the sides ab, bc, ca; 0 where the ends coincide.
    inverse: [f64; 3],
}

/// A point of a surface and its squared distance to the point that was asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    pub(crate) point: Vec3<f64>,
    pub(crate) distance_squared: f64,
}

impl Corners {
    /// The triangle with these corners. It must not be a sliver, unless two corners are the same.
    pub(crate) fn new(at: [Vec3<f64>; 3]) -> Corners {
        let inverse = std::array::from_fn(|k| {
            let squared = (at[(k + 1) % 3] - at[k]).length_squared();
            if squared > 0.0 { 1.0 / squared } else { 0.0 }
        });
        Corners { at, inverse }
    }

    /// Whether the two have a corner in common.
    pub(crate) fn touches(&self, other: &Corners) -> bool {
        self.at.iter().any(|corner| other.at.contains(corner))
    }

    /// The point of the triangle that is closest to `p`, which is `over` its `planes`.
    #[inline(always)]
    pub(crate) fn closest(&self, planes: &Planes, p: Vec3<f64>, over: Over) -> Hit {
        if over.is_inside() {
            let point = planes.foot(p, over);
            return Hit { point, distance_squared: over.height * over.height };
        }
        let mut best = Hit { point: p, distance_squared: f64::INFINITY };
        for k in 0..3 {
            if over.out[k] > 0.0 {
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

/// Whether a triangle is so thin that rounding decides what is inside: its height is less than 1e-8
/// of its longest side. Its three sides then stand for it.
pub(crate) fn is_sliver(corners: [Point; 3]) -> bool {
    const THINNEST: f64 = 1e-8;
    let [a, b, c] = corners.map(Vec3::from);
    let longest_squared =
        (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
    (b - a).cross(c - a).length() <= THINNEST * longest_squared
}
