//! The softest directions along the constraints, by subspace iteration: the inverse of the factored
//! matrix almost cancels components across them. The motions are subtracted too, so that the
//! iterated operator is symmetric, and its greatest eigenvalues are the compliances.

use super::vectors::{COUNT, MODES, Vectors, principal};
use crate::solve::exact::block_system::BlockSystem;

/// Greatest number of iterations; five to forty are usual.
const ITERATIONS: u32 = 60;

/// The iteration has converged when no compliance of a mode grows by more than this fraction.
const GAIN: f64 = 1e-4;

/// The iteration.
pub(super) struct Subspace {
    pub vectors: Vectors,
    /// Compliances, the greatest first.
    pub compliances: [f64; COUNT],
    pub motions: Vectors,
    iterations: u32,
}

impl Subspace {
    /// Starts from pseudo-random vectors.
    pub(super) fn new(system: &BlockSystem, motions: Vectors) -> Subspace {
        let mut vectors = Vectors::zero(system.size());
        let mut state = 1_u32;
        let free = vectors.0.chunks_exact_mut(3).zip(system.fixed()).filter(|(_, fixed)| !**fixed);
        for entry in free.flat_map(|(rows, _)| rows.as_flattened_mut()) {
            // Numerical Recipes' quick generator.
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            *entry = f64::from(state >> 8) - f64::from(1 << 23);
        }
        vectors.project_out(&motions);
        vectors.orthonormalise();
        Subspace { vectors, compliances: [0.0; COUNT], motions, iterations: 0 }
    }

    /// Performs one iteration; returns whether there is more to gain.
    pub(super) fn iterate(&mut self, system: &BlockSystem) -> bool {
        let mut next = self.vectors.clone();
        next.solve(system);
        next.project_out(&self.motions);
        let (compliances, factors) = principal(&self.vectors.products(&next));
        next.mix(&factors);
        next.orthonormalise();
        self.vectors = next;
        let before = std::mem::replace(&mut self.compliances, compliances);
        self.iterations += 1;
        let gains = compliances[..MODES].iter().zip(before).any(|(c, b)| c - b > GAIN * c);
        gains && self.iterations < ITERATIONS
    }
}
