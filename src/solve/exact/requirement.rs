//! The requirements on rows of constraints, and on the edges while they are met.

/// The requirement on a row of constraints.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Require {
    /// It is weighed against all other energies.
    #[default]
    Soft,
    /// It is met exactly.
    Exact,
    /// No vertex is farther than this from the shape, a length above zero in the unit of the mesh.
    Within(f64),
}

impl Require {
    /// Whether it is hard: met, not weighed.
    pub fn is_hard(self) -> bool {
        self != Require::Soft
    }
}

/// The hard constraints, and the settings for meeting them.
#[derive(Clone, Copy, Debug)]
pub struct Requirements<'a> {
    /// The requirement on each row of constraints of the problem.
    pub rows: &'a [Require],
    /// The least ratio of an edge between vertices of hard constraints to its length at rest, at
    /// most one; `None` is no bound.
    pub shortest_edge: Option<f64>,
    /// Greatest number of iterations of the approach.
    pub iterations: u32,
}

impl Requirements<'_> {
    /// Number of iterations of the approach that is enough for every mesh that was tried.
    pub const ITERATIONS: u32 = 2000;

    /// Whether a tolerance is enough for all hard rows.
    pub(super) fn all_within(&self) -> bool {
        !self.rows.contains(&Require::Exact)
    }
}
