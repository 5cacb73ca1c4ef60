//! The outcome of an attempt to meet hard constraints.

/// The outcome of an attempt.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    pub(crate) met: bool,
    /// The faces that are folded or dented.
    pub(crate) folded: Vec<u32>,
    /// The mean angle in degrees between neighbouring faces.
    pub(crate) bend: f64,
    /// The energy of the soft terms, without the hard constraints.
    pub(crate) energy: f64,
    /// The largest displacement of a vertex from its rest position.
    pub(crate) moved: f64,
    /// Iterations times vertices.
    pub(crate) work: u64,
}
