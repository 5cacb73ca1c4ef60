//! Better weights and norm for a flat map that flips faces.

use super::{ConformalNorm, ConformalWeights, Parametrization};
use crate::mesh::{Mesh, Topology};

/// The settings of a map that flips fewer faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FewerFlips {
    /// The weights of the faces.
    pub weights: ConformalWeights,
    /// The norm that is fixed.
    pub norm: ConformalNorm,
    /// Number of faces that this map flips.
    pub flipped: usize,
    /// Its mean quasi-conformal error.
    pub mean: f64,
}

impl FewerFlips {
    /// Returns the settings that flip the fewest faces, if these are fewer than `flipped`; of
    /// several, those with the least mean error. Computes the maps of all settings.
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
