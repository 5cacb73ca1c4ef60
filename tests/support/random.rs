//! Seeded random points for tests, the same on every machine.

use shape_up::math::Vec3;

/// The points of one constraint.
pub(crate) type Points = Vec<Vec3<f64>>;

/// Marsaglia's xorshift.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Random {
        let mut random = Random(0x9E37_79B9_7F4A_7C15 ^ seed.wrapping_mul(0xD129_42D7_35A1_5B57));
        for _ in 0..8 {
            random.uniform();
        }
        random
    }

    /// Uniform between -1 and 1.
    pub(crate) fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// Uniform in the cube from -1 to 1.
    pub(crate) fn vector(&mut self) -> Vec3<f64> {
        Vec3::new(self.uniform(), self.uniform(), self.uniform())
    }

    /// Uniform on the unit sphere.
    pub(crate) fn direction(&mut self) -> Vec3<f64> {
        loop {
            let v = self.vector();
            let length = v.length();
            if length > 0.1 && length <= 1.0 {
                return v * (1.0 / length);
            }
        }
    }

    /// An orthonormal, right-handed frame.
    pub(crate) fn frame(&mut self) -> [Vec3<f64>; 3] {
        let a = self.direction();
        loop {
            let b = self.direction();
            let b = b - a * a.dot(b);
            if b.length() > 0.1 {
                let b = b * (1.0 / b.length());
                return [a, b, a.cross(b)];
            }
        }
    }
}

/// The point with coordinates `v` in `frame`.
pub(crate) fn in_frame(frame: [Vec3<f64>; 3], v: Vec3<f64>) -> Vec3<f64> {
    frame[0] * v.x + frame[1] * v.y + frame[2] * v.z
}

/// The points minus their mean.
pub(crate) fn centred(points: &[Vec3<f64>]) -> Points {
    let sum = points.iter().fold(Vec3::zero(), |sum, v| sum + *v);
    points.iter().map(|v| *v - sum * (1.0 / points.len() as f64)).collect()
}

/// Greatest distance from the origin.
pub(crate) fn size(points: &[Vec3<f64>]) -> f64 {
    points.iter().fold(0.0, |m, v| v.length().max(m))
}

/// Greatest distance between points of the same index.
pub(crate) fn farthest(a: &[Vec3<f64>], b: &[Vec3<f64>]) -> f64 {
    a.iter().zip(b).fold(0.0, |m, (p, q)| {
        let distance = (*p - *q).length();
        if distance.is_nan() { f64::INFINITY } else { distance.max(m) }
    })
}

/// Sum of squared distances between points of the same index.
pub(crate) fn distance_squared(a: &[Vec3<f64>], b: &[Vec3<f64>]) -> f64 {
    a.iter().zip(b).map(|(p, q)| (*p - *q).length_squared()).sum()
}
