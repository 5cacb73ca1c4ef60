//! The weight of the circles that meets a given circularity error: both methods of Fig. 11 follow the
//! same rule, so that they are compared at the same error.

/// Part of the total by which it may fall over [`SPAN`] iterations and count as settled.
const SETTLED: f64 = 1e-4;
/// Iterations over which that is looked at.
const SPAN: usize = 5;
/// Iterations at one weight at most.
const MOST: usize = 60;
/// How near the error has to come, as a part of it.
const NEAR: f64 = 0.05;
/// By how much the weight changes at most.
const GREATEST_CHANGE: f64 = 4.0;

/// The weight, and how the total went with it.
pub(super) struct Continuation {
    pub(super) weight: f64,
    /// The circularity error that is asked for.
    target: f64,
    totals: Vec<f64>,
}

impl Continuation {
    pub(super) fn new(weight: f64, target: f64) -> Continuation {
        Continuation { weight, target, totals: Vec::new() }
    }

    /// After an iteration, or after one that could not be done (`stuck`): the total at this weight, and
    /// the circularity error. True once the total has settled at the error that is asked for; else the
    /// weight may be another one now.
    pub(super) fn is_reached(&mut self, total: f64, error: f64, stuck: bool) -> bool {
        self.totals.push(total);
        let n = self.totals.len();
        let falls_no_more =
            n > SPAN && self.totals[n - 1 - SPAN] - total <= SETTLED * self.totals[n - 1 - SPAN];
        if !(stuck || falls_no_more || n >= MOST) {
            return false;
        }
        self.totals.clear();
        let ratio = error / self.target;
        // A penalty leaves a distance that falls as its weight grows, and the error is its square.
        self.weight *= ratio.sqrt().clamp(1.0 / GREATEST_CHANGE, GREATEST_CHANGE);
        (ratio - 1.0).abs() <= NEAR
    }
}
