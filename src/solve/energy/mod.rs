//! The total energy (Eq. 13) with its gradient. Each part also provides its terms of the normal
//! matrix.

mod closeness;
mod positional_constraints;
mod shape;
mod smoothness;

pub(super) use closeness::{CloseEnergy, RestShape};
pub use positional_constraints::{Handle, HandleIndex, Hold};
pub(super) use positional_constraints::{PositionalConstraints, pins};
pub use shape::Constraints;
pub(super) use shape::{BIG, ShapeEnergy, extra_unknowns, terms as shape_terms};
pub(super) use smoothness::{SmoothEnergy, springs, terms as smooth_terms};

use super::clock;
use super::settings::Weights;
use crate::constraint::Row;
use serde::Serialize;

/// The energies at one iterate, in squared units of the mesh: unweighted parts, weighted total.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Energy {
    /// `E_shape`, Eq. 4, with the weights `w_i`.
    pub shape: f64,
    /// `E_close`, Eq. 11.
    pub close: f64,
    /// `E_smooth`, Eq. 12.
    pub smooth: f64,
    /// `sum weight * |v - target|^2` over soft handles.
    pub handles: f64,
    /// `lambda_shape * shape + lambda_close * close + lambda_smooth * smooth + handles`.
    pub total: f64,
}

/// Times of the iterations in seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct IterateSeconds {
    /// The projections and their scatter.
    pub shape: f64,
    /// Closest points and their scatter.
    pub close: f64,
    /// The Laplacian of positions or displacements, twice.
    pub smooth: f64,
    /// The triangular sweeps and the accelerator.
    pub global: f64,
}

impl IterateSeconds {
    /// The sum of the parts.
    pub fn total(&self) -> f64 {
        self.shape + self.close + self.smooth + self.global
    }
}

/// The parts of the total energy of a problem.
pub(super) struct Energies {
    /// The weights of Eq. 13.
    pub weights: Weights,
    /// `E_shape` and its batches of projections.
    pub shape: ShapeEnergy,
    /// Closeness; `None` if it has no weight or no targets.
    pub close: Option<CloseEnergy>,
    /// Smoothness; `None` if it has no weight.
    pub smooth: Option<SmoothEnergy>,
    /// `sum weight * |v - target|^2` over soft handles.
    pub handles: PositionalConstraints,
}

impl Energies {
    /// Step I: evaluates the energies at `x`, and sets `gradient` to half the gradient of the
    /// total.
    pub(super) fn evaluate(
        &mut self,
        x: &[Row],
        gradient: &mut [Row],
        seconds: &mut IterateSeconds,
    ) -> Energy {
        gradient.fill([0.0; 4]);
        let weights = self.weights;
        let started = clock::now();
        let shape = self.shape.local_step(x, gradient, weights.shape);
        let shaped = clock::now();
        let close = self.close.as_mut().map_or(0.0, |e| e.step(x, gradient, weights.close));
        let closed = clock::now();
        let smooth = self.smooth.as_mut().map_or(0.0, |e| e.step(x, gradient, weights.smooth));
        let handles = self.handles.step(x, gradient);
        seconds.shape += shaped - started;
        seconds.close += closed - shaped;
        seconds.smooth += clock::now() - closed;
        let total =
            shape * weights.shape + close * weights.close + smooth * weights.smooth + handles;
        Energy { shape, close, smooth, handles, total }
    }
}
