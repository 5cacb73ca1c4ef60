//! One press for all panels: they are asked for one shape, and the run weighs the constraints more until
//! all panels are within a tolerance.

/// The weight of the constraints is raised at most so often, and each time by at most and at least this:
/// distances fall like one over the weight.
const MOST_ROUNDS: u32 = 3;
const MOST_FACTOR: f64 = 1000.0;
const LEAST_FACTOR: f64 = 4.0;
/// How much more than that it is raised, since other panels give way.
const MARGIN: f64 = 1.6;
/// It is not raised again unless the worst distance has come below this part of what it was.
const HELPS: f64 = 0.7;

/// The tolerance for which a run goes on after it has converged.
pub(crate) struct PanelGoal {
    /// In the unit of the mesh.
    tolerance: f64,
    /// How often the weight may still be raised.
    rounds: u32,
    /// The worst distance when it was last raised.
    worst: f64,
}

impl PanelGoal {
    pub(crate) fn new(tolerance: f64) -> PanelGoal {
        PanelGoal { tolerance, rounds: MOST_ROUNDS, worst: f64::INFINITY }
    }

    /// The largest distance of a panel's vertex that is within, in the unit of the mesh.
    pub(crate) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Where the worst panel is `worst` away, beyond the tolerance: the next weight of the constraints
    /// instead of `weight`, and what remains of the goal then. None where raising it has not helped, or
    /// often enough.
    pub(crate) fn raise(&self, weight: f64, worst: f64) -> Option<(f64, PanelGoal)> {
        if self.rounds == 0 || worst > HELPS * self.worst {
            return None;
        }
        let factor = (MARGIN * worst / self.tolerance).clamp(LEAST_FACTOR, MOST_FACTOR);
        let goal = PanelGoal { tolerance: self.tolerance, rounds: self.rounds - 1, worst };
        Some((two_digits(factor * weight), goal))
    }
}

/// A number that one says, near this one.
fn two_digits(number: f64) -> f64 {
    format!("{number:.1e}").parse().unwrap_or(number)
}
