//! What the search for a map may cost: a count of passes over the triangles and not a time, so that it
//! ends at the same map on every machine.

/// Cost of a field or a map without integers, which factor matrices, in passes.
const RELAXATION: usize = 100;
/// Cost of a rounding, in passes.
const ROUNDING: usize = 20;
/// Cost of judging a map by the panels that come of it, in passes.
const JUDGEMENT: usize = 100;
/// Passes of a whole search: those that are needed for the surfaces of `reference/quads.md`, with some to
/// spare.
const ALL: usize = 600;

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
