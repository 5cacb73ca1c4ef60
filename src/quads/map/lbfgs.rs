//! Minimisation of a smooth function of a few hundred unknowns: limited-memory BFGS (Nocedal 1980;
//! Nocedal and Wright 2006, algorithm 7.5) with halved steps.

use crate::math::{LimitedMemory, inner_product};

/// Number of pairs remembered.
const MEMORY: usize = 8;
/// Sufficient decrease, as a fraction of that of the slope.
const DECREASE: f64 = 1e-4;
/// Most halvings of a step.
const HALVINGS: usize = 30;
/// Relative decrease at which it ends.
const SMALL: f64 = 1e-5;

/// Minimises from `x` in at most so many steps and calls, of which the first is always made. `function`
/// returns the value and sets the gradient; returns how often it was called.
pub(super) fn minimise(
    x: &mut [f64],
    [most_steps, most_calls]: [usize; 2],
    mut function: impl FnMut(&[f64], &mut [f64]) -> f64,
) -> usize {
    let n = x.len();
    let mut calls = 1;
    let mut gradient = vec![0.0; n];
    let mut value = function(x, &mut gradient);
    let mut memory = LimitedMemory::of(MEMORY);
    let (mut next, mut next_gradient) = (vec![0.0; n], vec![0.0; n]);
    for _ in 0..most_steps {
        let mut direction: Vec<f64> = gradient.iter().map(|g| -g).collect();
        memory.apply(&mut direction);
        let mut slope = inner_product(&direction, &gradient);
        if slope >= 0.0 || !slope.is_finite() {
            memory.clear();
            direction = gradient.iter().map(|g| -g).collect();
            slope = -inner_product(&gradient, &gradient);
        }
        if slope == 0.0 {
            break;
        }
        // Without memory the length of the gradient says nothing.
        let longest = direction.iter().fold(0.0f64, |most, d| most.max(d.abs()));
        let mut step = if memory.is_empty() { (0.1 / longest).min(1.0) } else { 1.0 };
        let mut halvings = 0;
        let next_value = loop {
            if calls >= most_calls {
                return calls;
            }
            for i in 0..n {
                next[i] = x[i] + step * direction[i];
            }
            calls += 1;
            let found = function(&next, &mut next_gradient);
            if found.is_finite() && found <= value + DECREASE * step * slope {
                break found;
            }
            halvings += 1;
            if halvings > HALVINGS {
                return calls;
            }
            step *= 0.5;
        };
        let moved: Vec<f64> = next.iter().zip(&*x).map(|(a, b)| a - b).collect();
        let changed: Vec<f64> = next_gradient.iter().zip(&gradient).map(|(a, b)| a - b).collect();
        if inner_product(&moved, &changed) > 1e-12 * inner_product(&changed, &changed) {
            memory.push(moved, changed);
        }
        let decrease = value - next_value;
        x.copy_from_slice(&next);
        gradient.copy_from_slice(&next_gradient);
        value = next_value;
        if decrease <= SMALL * value.abs() {
            break;
        }
    }
    calls
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_finds_the_bottom_of_a_curved_valley() {
        let valley = |x: &[f64], gradient: &mut [f64]| {
            let (a, b) = (1.0 - x[0], x[1] - x[0] * x[0]);
            gradient.copy_from_slice(&[-2.0 * a - 400.0 * x[0] * b, 200.0 * b]);
            a * a + 100.0 * b * b
        };
        let mut x = [-1.2, 1.0];
        minimise(&mut x, [200, 1000], valley);
        assert!((x[0] - 1.0).abs() < 1e-2 && (x[1] - 1.0).abs() < 2e-2, "{x:?}");
        // Nor is it called more often than allowed, and the value only falls.
        let mut none = [0.0; 2];
        for most in [1, 5, 20] {
            let mut x = [-1.2, 1.0];
            assert_eq!(minimise(&mut x, [200, most], valley), most);
            assert!(valley(&x, &mut none) <= valley(&[-1.2, 1.0], &mut none));
        }
    }
}
