//! Complex numbers as pairs, with which directions in a triangle are turned and raised to powers.

use crate::math::{cosine, sine};
use std::f64::consts::TAU;

/// Real and imaginary part.
pub(crate) type Complex = [f64; 2];

/// The product.
pub(crate) fn times([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a * c - b * d, a * d + b * c]
}

/// The complex conjugate.
pub(crate) fn conjugate([a, b]: Complex) -> Complex {
    [a, -b]
}

/// The absolute value.
pub(crate) fn size([a, b]: Complex) -> f64 {
    (a * a + b * b).sqrt()
}

/// The number of absolute value one in the same direction; `None` of zero.
pub(crate) fn unit([a, b]: Complex) -> Option<Complex> {
    let scale = a.abs().max(b.abs());
    if scale == 0.0 || !scale.is_finite() {
        return None;
    }
    let (a, b) = (a / scale, b / scale);
    let length = size([a, b]);
    Some([a / length, b / length])
}

/// The square.
pub(crate) fn squared(z: Complex) -> Complex {
    times(z, z)
}

/// The angle in radians, from -pi to pi.
pub(crate) fn argument([a, b]: Complex) -> f64 {
    libm::atan2(b, a)
}

/// The number of absolute value one at an angle in radians.
pub(crate) fn at_angle(radians: f64) -> Complex {
    [cosine(radians / TAU), sine(radians / TAU)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_add_in_products() {
        for k in -30..30 {
            let (a, b) = (f64::from(k) / 10.0, f64::from(k * k % 13) / 50.0);
            let product = times(at_angle(a), at_angle(b));
            assert!(
                size([product[0] - at_angle(a + b)[0], product[1] - at_angle(a + b)[1]]) < 1e-14
            );
            assert!((argument(at_angle(a)) - a).abs() < 1e-14, "{a}");
            let square = squared(at_angle(a));
            assert!((times(square, conjugate(square))[0] - 1.0).abs() < 1e-14);
        }
        assert_eq!(unit([0.0, 0.0]), None);
        assert_eq!(unit([0.0, -1e-200]), Some([0.0, -1.0]));
    }
}
