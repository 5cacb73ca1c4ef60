//! A step length along a descent direction, by bisection until the weak Wolfe conditions hold (Nocedal
//! and Wright, Numerical Optimization, 3.6; bisection as Burke, Lewis and Overton).

/// How much of the decrease that the slope promises is asked for.
const DECREASE: f64 = 1e-4;
/// How much of the slope may be left.
const CURVATURE: f64 = 0.9;
/// Steps that are tried. Halving this often leaves nothing of a step.
const TRIALS: u32 = 50;

/// The value of a function and its slope along the direction, at some step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Along {
    pub(super) value: f64,
    pub(super) slope: f64,
}

/// Calls `at` with the steps that it tries, `first` first, and gives the one that fits; none when no
/// step lowers the value. The last call was with the step that is given. `start` has a negative slope.
pub(super) fn wolfe_step(
    start: Along,
    first: f64,
    mut at: impl FnMut(f64) -> Along,
) -> Option<f64> {
    let (mut low, mut high, mut step) = (0.0, f64::INFINITY, first);
    for _ in 0..TRIALS {
        let found = at(step);
        // Written so that NaN is too far.
        let decreases = found.value <= start.value + DECREASE * step * start.slope;
        if !decreases || found.value >= start.value {
            high = step;
        } else if found.slope < CURVATURE * start.slope {
            low = step;
        } else {
            return Some(step);
        }
        step = if high < f64::INFINITY { 0.5 * (low + high) } else { 2.0 * step };
    }
    // The conditions cannot be met where rounding is all that is left; a lower value is good enough.
    (low > 0.0).then(|| {
        at(low);
        low
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_a_step_from_far_too_short_and_far_too_long_ones() {
        // The minimum is at 1.
        let parabola = |t: f64| Along { value: t * t - 2.0 * t, slope: 2.0 * t - 2.0 };
        for first in [1e-6, 1e-2, 1.0, 50.0, 1e6] {
            let step = wolfe_step(parabola(0.0), first, parabola).expect("there is one");
            let found = parabola(step);
            assert!(
                found.value <= DECREASE * step * -2.0 && found.slope >= -1.8,
                "{first}: {step}"
            );
        }
    }

    #[test]
    fn gives_up_where_the_value_only_grows() {
        let lied = Along { value: 0.0, slope: -1.0 };
        assert_eq!(wolfe_step(lied, 1.0, |t| Along { value: t, slope: 1.0 }), None);
        assert_eq!(wolfe_step(lied, 1.0, |_| Along { value: f64::NAN, slope: f64::NAN }), None);
    }
}
