//! How fast methods lower the energy of a scene: the five of Fig. 10, which recover an animal whose
//! vertices have collapsed, with the rest shape of each ring of neighbours as a constraint; and all
//! methods, on any scene. The paper's BFGS stores a matrix of the squared number of unknowns, more
//! than half a gigabyte for this animal: L-BFGS replaces it there.

use super::declaration::{Experiment, Limits, Over, Plot, Quantity, Unit};
use super::methods::{ACCELERATED, BFGS, CENTRED, GRADIENT_DESCENT, L_BFGS, NOT_CENTRED};

const ENERGY: Quantity = Quantity { id: "energy", label: "Energy", unit: Unit::Energy };

pub(super) const RECOVERY: Experiment = Experiment {
    id: "recovery",
    label: "Five ways back from a collapse",
    summary: "The same start and the same energy, lowered by five methods. Compare how far each has come after the same number of iterations, and after the same time.",
    examples: &["fig-10-collapse", "fig-10-random"],
    quantities: &[ENERGY],
    plots: &[
        Plot { quantity: 0, over: Over::Iterations, above_lowest: false },
        Plot { quantity: 0, over: Over::Seconds, above_lowest: false },
    ],
    methods: &[CENTRED, NOT_CENTRED, GRADIENT_DESCENT, L_BFGS, ACCELERATED],
    limits: Limits { iterations: 500, seconds: 20.0 },
};

/// Runs on any scene with constraints.
pub const COMPARISON: Experiment = Experiment {
    id: "methods",
    label: "Methods compared",
    summary: "The same start and the same energy, lowered by six methods. The plots show how much of it is left above the lowest that any of them has found.",
    examples: &[],
    quantities: &[ENERGY],
    plots: &[
        Plot { quantity: 0, over: Over::Iterations, above_lowest: true },
        Plot { quantity: 0, over: Over::Seconds, above_lowest: true },
    ],
    methods: &[ACCELERATED, CENTRED, NOT_CENTRED, GRADIENT_DESCENT, L_BFGS, BFGS],
    limits: Limits { iterations: 300, seconds: 10.0 },
};
