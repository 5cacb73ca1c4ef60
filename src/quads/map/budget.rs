//! What the search for a map may cost: a count of passes over the triangles and not a time, so that it
//! ends at the same map on every machine.

/// Cost of a field or a map without integers, which factor matrices, in passes.
const RELAXATION: usize = 100;
/// Cost of a rounding, in passes.
const ROUNDING: usize = 20;
/// Cost of judging a map by the panels that come of it, in passes.
const JUDGEMENT: usize = 100;
/// Passes of a whole search with its variations: those that are needed for the surfaces of
/// `reference/quads.md`, with some to spare. Per triangle, one random disk of a hundred then takes four times
/// as long as the median of them, and the slowest of 400 six times.
const ALL: usize = 540;
/// Most passes of a variation, which a search can do without.
const VARIATION: usize = 150;

/// What is left of the cost of a search.
pub(super) struct Budget {
    /// In visits of single triangles.
    left: usize,
    /// Number of triangles.
    triangles: usize,
}

impl Budget {
    /// The budget for a surface of so many triangles.
    pub(super) fn new(triangles: usize) -> Budget {
        Budget { left: ALL * triangles, triangles }
    }

    /// Takes what a variation may cost out of what is left.
    pub(super) fn take_variation(&mut self) -> Budget {
        let left = self.left.min(VARIATION * self.triangles);
        self.left -= left;
        Budget { left, triangles: self.triangles }
    }

    /// Gives back what another budget did not spend.
    pub(super) fn give_back(&mut self, other: Budget) {
        self.left += other.left;
    }

    /// How many visits of so many triangles are left.
    pub(super) fn visits_of(&self, triangles: usize) -> usize {
        self.left / triangles.max(1)
    }

    /// Whether nothing is left.
    pub(super) fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// A field or a map without integers, kept or not.
    pub(super) fn relax(&mut self) {
        self.visit(RELAXATION * self.triangles);
    }

    /// A rounding.
    pub(super) fn round(&mut self) {
        self.visit(ROUNDING * self.triangles);
    }

    /// A map that is judged.
    pub(super) fn judge(&mut self) {
        self.visit(JUDGEMENT * self.triangles);
    }

    /// Visits of single triangles.
    pub(super) fn visit(&mut self, triangles: usize) {
        self.left = self.left.saturating_sub(triangles);
    }
}
