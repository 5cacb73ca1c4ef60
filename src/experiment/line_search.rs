//! Step length along a descent direction, by bisection until the weak Wolfe conditions hold
//! (Nocedal and Wright, Numerical Optimization, 3.6; bisection as in Burke, Lewis and Overton).

/// Fraction of the decrease predicted by the slope that a step must achieve.
const DECREASE: f64 = 1e-4;
/// Fraction of the initial slope that may remain.
const CURVATURE: f64 = 0.9;
/// Maximum number of trial steps. So many halvings leave nothing of a step.
const TRIALS: u32 = 50;

/// Value and slope of a function at a step along the direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Along {
    pub(super) value: f64,
    pub(super) slope: f64,
}

/// Calls `at` with trial steps, `first` first, and returns the accepted one; none if no step lowers
/// the value. The last call is with the returned step. The slope of `start` must be negative.
pub(super) fn wolfe_step(
    start: Along,
    first: f64,
    mut at: impl FnMut(f64) -> Along,
) -> Option<f64> {
    let (mut low, mut high, mut step) = (0.0, f64::INFINITY, first);
    for _ in 0..TRIALS {
        let found = at(step);
        // Written so that NaN counts as too far.
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
    // Rounding errors may prevent the conditions from being met; a lower value is then enough.
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
