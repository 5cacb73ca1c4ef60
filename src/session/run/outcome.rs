//! The outcome of an attempt to meet hard constraints.

/// The outcome of an attempt.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    pub(crate) met: bool,
    /// The faces that are folded or dented.
    pub(crate) folded: Vec<u32>,
    /// The largest displacement of a vertex from its rest position.
    pub(crate) moved: f64,
    /// Iterations times vertices.
    pub(crate) work: u64,
}
