//! Fig. 10: five methods recover an animal whose vertices have collapsed, with the rest shape of
//! each ring of neighbours as a constraint. The paper's BFGS stores a matrix of the squared number
//! of unknowns, more than half a gigabyte for this animal: L-BFGS replaces it here, and
//! [`COMPARISON`](super::COMPARISON) includes it on smaller meshes.

use super::declaration::{Experiment, Limits, Over, Plot, Quantity, Unit};
use super::methods::{ACCELERATED, CENTRED, GRADIENT_DESCENT, L_BFGS, NOT_CENTRED};

pub(super) const RECOVERY: Experiment = Experiment {
    id: "recovery",
    label: "Five ways back from a collapse",
    summary: "The same start and the same energy, lowered by five methods. Compare how far each has come after the same number of iterations, and after the same time.",
    examples: &["fig-10-collapse", "fig-10-random"],
    quantities: &[Quantity { id: "energy", label: "Energy", unit: Unit::Energy }],
    plots: &[
        Plot { quantity: 0, over: Over::Iterations, above_lowest: false },
        Plot { quantity: 0, over: Over::Seconds, above_lowest: false },
    ],
    methods: &[CENTRED, NOT_CENTRED, GRADIENT_DESCENT, L_BFGS, ACCELERATED],
    limits: Limits { iterations: 500, seconds: 20.0 },
};
