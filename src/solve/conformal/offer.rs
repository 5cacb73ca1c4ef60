//! Better weights and norm where a flat map turns faces over.

use super::{ConformalNorm, ConformalWeights, Parametrization};
use crate::mesh::{Mesh, Topology};

/// Settings of a map that turn fewer faces over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FewerFlips {
    /// The weights of the faces.
    pub weights: ConformalWeights,
    /// The norm that is kept.
    pub norm: ConformalNorm,
    /// How many faces that map turns over.
    pub flipped: usize,
    /// Its mean quasi-conformal error.
    pub mean: f64,
}

impl FewerFlips {
    /// The settings that turn fewest over, of those that turn fewer than `flipped`, and of several the ones with the
    /// least mean error; none where all turn as many. It makes every map that there is.
    pub fn of(mesh: &Mesh, topology: &Topology, flipped: usize) -> Option<FewerFlips> {
        let mut best: Option<FewerFlips> = None;
        for weights in
            [ConformalWeights::InverseArea, ConformalWeights::One, ConformalWeights::Lscm]
        {
            for norm in [ConformalNorm::Boundary, ConformalNorm::Vertices] {
                let Ok(map) = Parametrization::new(mesh, topology, weights, norm) else { continue };
                let errors = map.errors;
                let mean = errors.quasi_conformal.mean;
                let found = FewerFlips { weights, norm, flipped: errors.flipped, mean };
                let is_better =
                    |best: FewerFlips| (found.flipped, found.mean) < (best.flipped, best.mean);
                if found.flipped < flipped && best.is_none_or(is_better) {
                    best = Some(found);
                }
            }
        }
        best
    }
}
