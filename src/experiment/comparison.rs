//! The comparison of section 5 on any scene: how fast each method lowers the energy.

use super::declaration::{Experiment, Limits, Over, Plot, Quantity, Unit};
use super::methods::{ACCELERATED, BFGS, CENTRED, GRADIENT_DESCENT, L_BFGS, NOT_CENTRED};

/// Runs on the open scene.
pub const COMPARISON: Experiment = Experiment {
    id: "methods",
    label: "Methods compared",
    summary: "The same start and the same energy, lowered by six methods. The plots show how much of it is left above the lowest that any of them has found.",
    examples: &[],
    quantities: &[Quantity { id: "energy", label: "Energy", unit: Unit::Energy }],
    plots: &[
        Plot { quantity: 0, over: Over::Iterations, above_lowest: true },
        Plot { quantity: 0, over: Over::Seconds, above_lowest: true },
    ],
    methods: &[ACCELERATED, CENTRED, NOT_CENTRED, GRADIENT_DESCENT, L_BFGS, BFGS],
    limits: Limits { iterations: 300, seconds: 10.0 },
};
