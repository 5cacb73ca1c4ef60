//! Adapts the weight of the circles until the circularity error has a given value. Both methods of
//! Fig. 11 use this rule, so that they are compared at the same error.

/// Relative decrease of the total over [`SPAN`] iterations below which it counts as settled.
const SETTLED: f64 = 1e-4;
/// Number of iterations over which the decrease is measured.
const SPAN: usize = 5;
/// Maximum number of iterations at one weight.
const MOST_ITERATIONS: usize = 60;
/// Relative tolerance of the circularity error.
const TOLERANCE: f64 = 0.05;
/// Largest factor by which the weight changes at once.
const GREATEST_CHANGE: f64 = 4.0;

/// The weight, and the totals of the iterations at this weight.
pub(super) struct Continuation {
    pub(super) weight: f64,
    /// The required circularity error.
    target: f64,
    totals: Vec<f64>,
}

impl Continuation {
    pub(super) fn new(weight: f64, target: f64) -> Continuation {
        Continuation { weight, target, totals: Vec::new() }
    }

    /// Records an iteration, or a failed one (`stuck`): the total at this weight, and the
    /// circularity error. Returns true once the total has settled at the required error; otherwise
    /// it may have changed the weight.
    pub(super) fn is_reached(&mut self, total: f64, error: f64, stuck: bool) -> bool {
        self.totals.push(total);
        let n = self.totals.len();
        let falls_no_more =
            n > SPAN && self.totals[n - 1 - SPAN] - total <= SETTLED * self.totals[n - 1 - SPAN];
        if !(stuck || falls_no_more || n >= MOST_ITERATIONS) {
            return false;
        }
        self.totals.clear();
        let ratio = error / self.target;
        // The remaining distance decreases as the weight grows, and the error is its square.
        self.weight *= ratio.sqrt().clamp(1.0 / GREATEST_CHANGE, GREATEST_CHANGE);
        (ratio - 1.0).abs() <= TOLERANCE
    }
}
