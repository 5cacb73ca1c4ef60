//! The cube root, from correctly rounded operations only.

/// The cube root of a non-negative number, accurate to the last bits.
pub fn cube_root(x: f64) -> f64 {
    if x == 0.0 || x == f64::INFINITY {
        return x;
    }
    // Fixed-point iteration r <- (r x)^(1/4): each step divides the error of the logarithm by four.
    let start = (0..28).fold(1.0f64, |root, _| (root.sqrt() * x.sqrt()).sqrt());
    start - (start - x / start / start) / 3.0
}

#[cfg(test)]
mod tests {
    use super::cube_root;

    #[test]
    fn cubes_give_back_what_was_cubed() {
        for k in -100..=100 {
            let power = 10f64.powi(k);
            for root in [1.0, 1.7, 3.3, 9.9].map(|factor| factor * power) {
                let error = cube_root(root * root * root) / root - 1.0;
                assert!(error.abs() <= 1e-15, "{root:e}: off by {error:e}");
            }
        }
        assert_eq!(cube_root(0.0), 0.0);
        assert!(cube_root(5e-324) > 0.0);
        assert_eq!(cube_root(f64::INFINITY), f64::INFINITY);
    }
}
