//! The largest mesh for interactive drags, estimated from iterations on a small one.

/// Duration of an iteration, in seconds, for thirty updates per second during a drag.
const INTERACTIVE_SECONDS: f64 = 1.0 / 30.0;
/// Cost of a face of a large mesh relative to one of a small mesh: the factor has more entries per
/// vertex, and the cache is too small. Measured from 361 to 49,729 faces.
const GROWTH: f64 = 2.0;
/// Bounds for any machine: fewer faces than the first are always interactive, and more than the
/// second exceed its memory first.
const BOUNDS: [f64; 2] = [1e4, 5e5];

/// Returns the largest number of faces for iterations of at most a thirtieth of a second, on a
/// machine that needs `seconds` for an iteration on `faces` faces. It has one digit, or two if the
/// first is 1.
pub fn max_interactive_faces(faces: usize, seconds: f64) -> u32 {
    let most = INTERACTIVE_SECONDS / GROWTH * faces as f64 / seconds;
    let [least, greatest] = BOUNDS;
    // NaN, from a clock that stands still, counts as fast.
    let most = if most < greatest { most.max(least) } else { greatest };
    let mut digit = 1.0;
    while most >= 20.0 * digit {
        digit *= 10.0;
    }
    ((most / digit) as u32) * digit as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_machine_that_is_twice_as_fast_takes_about_twice_as_many() {
        let slow = max_interactive_faces(400, 2e-4);
        let fast = max_interactive_faces(400, 1e-4);
        assert!((slow..=4 * slow).contains(&fast), "{slow} {fast}");
        assert!(fast > slow);
    }

    #[test]
    fn it_stays_within_what_is_sane() {
        assert_eq!(max_interactive_faces(400, 1e3), 10_000);
        for none in [0.0, f64::NAN, 1e-300] {
            assert_eq!(max_interactive_faces(400, none), 500_000);
        }
    }

    #[test]
    fn it_is_a_round_number() {
        for (seconds, round) in [(3e-4, 20_000), (1e-4, 60_000), (4e-5, 160_000)] {
            assert_eq!(max_interactive_faces(400, seconds), round);
        }
    }
}
