//! The largest mesh that can be dragged interactively, estimated from the iterations of a small one.

/// Seconds of an iteration with which a drag is followed thirty times a second.
const AT_ONCE: f64 = 1.0 / 30.0;
/// A face of a large mesh costs this many times as much as one of a small mesh: the factor has more
/// entries per vertex, and nothing stays in the cache. Measured from 361 to 49,729 faces.
const GROWTH: f64 = 2.0;
/// The limits on any machine: fewer faces than the first are always worked with at once, more than
/// the second fill its memory first.
const BOUNDS: [f64; 2] = [1e4, 5e5];

/// The most faces of a mesh whose iterations take no longer than a thirtieth of a second, on a machine
/// that needs `seconds` for an iteration on `faces` faces; with one digit, or two where the first is 1.
pub fn max_interactive_faces(faces: usize, seconds: f64) -> u32 {
    let most = AT_ONCE / GROWTH * faces as f64 / seconds;
    let [least, greatest] = BOUNDS;
    // Not a number, where the clock stands still, counts as fast.
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
