//! Memory read speed of this machine: a lower bound for every solve, which reads the factor once
//! downwards and once upwards.

use shape_up::solve::clock;
use std::hint::black_box;

/// Number of rounds; the fastest counts, as the others were disturbed.
const ROUNDS: usize = 15;
/// Each round is long compared to the resolution of a browser's clock.
const SECONDS_PER_ROUND: f64 = 0.002;

/// Milliseconds to read this number of bytes once. Data that fits in a cache is read from there, as
/// by a solver that iterates.
pub(crate) fn milliseconds(bytes: usize) -> f64 {
    let values = vec![1.0_f32; bytes / size_of::<f32>()];
    let timed = |repeats: usize| {
        let started = clock::now();
        for _ in 0..repeats {
            black_box(sum(black_box(&values)));
        }
        clock::now() - started
    };
    let mut repeats = 1;
    while timed(repeats) < SECONDS_PER_ROUND {
        repeats *= 2;
    }
    let fastest = (0..ROUNDS).map(|_| timed(repeats)).fold(f64::INFINITY, f64::min);
    1e3 * fastest / repeats as f64
}

/// Eight registers of four: enough additions in flight that reading is the bottleneck.
#[inline(never)]
fn sum(values: &[f32]) -> f32 {
    let mut sums = [0.0; 32];
    for values in values.as_chunks::<32>().0 {
        for (sum, value) in sums.iter_mut().zip(values) {
            *sum += value;
        }
    }
    sums.iter().sum()
}
