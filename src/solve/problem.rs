//! What is solved, and what of it the normal matrix is made of.

use super::assemble::Terms;
use super::shape::{self, Constraints, extra_unknowns};
use crate::mesh::{Laplacian, Mesh, Topology};
use crate::scene::{Closeness, Smoothness, SolverSettings, Weighting, Weights};

/// What is solved: the rest shape and what its parts shall be.
pub struct Problem<'a> {
    /// The rest shape.
    pub mesh: &'a Mesh,
    /// Its topology.
    pub topology: &'a Topology,
    /// Every row of constraints, resolved.
    pub constraints: &'a [Constraints],
    /// The weights of Eq. 13.
    pub weights: Weights,
    /// What vertices are kept close to.
    pub closeness: &'a Closeness,
    /// `k_v` of each vertex, `#V`: see [`Closeness::factors`].
    pub closeness_factors: &'a [f64],
    /// What is smoothed.
    pub smoothness: Smoothness,
    /// How it is solved.
    pub settings: SolverSettings,
}

impl Problem<'_> {
    /// Vertices and extra unknowns, which are numbered behind them.
    pub(super) fn n_unknowns(&self) -> usize {
        self.mesh.positions.len() + extra_unknowns(self.constraints, self.settings.mean_centring)
    }

    /// The part of the shape energy in the normal matrix, over all unknowns.
    pub(super) fn shape_terms(&self) -> Terms {
        if self.weights.shape > 0.0 {
            let n_vertices = self.mesh.positions.len();
            shape::terms(self.constraints, n_vertices, self.settings.mean_centring)
        } else {
            Terms::default()
        }
    }

    /// Which of `n` nodes the shape energy holds in their place.
    pub(super) fn nodes_held_by(&self, shape_terms: &Terms, n: usize) -> Vec<bool> {
        let mut held = vec![false; n];
        if !self.settings.mean_centring {
            // Without N_i a constraint holds its points against translation too.
            shape_terms.nodes().indices().iter().for_each(|&v| held[v as usize] = true);
        } else if self.weights.shape > 0.0 {
            let placed = self.constraints.iter().flat_map(Constraints::placed);
            placed.for_each(|&v| held[v as usize] = true);
        }
        held
    }

    /// The Laplacian of the smoothness energy, if that counts.
    pub(super) fn laplacian(&self) -> Option<Laplacian> {
        let weighting = match self.smoothness.weighting {
            Weighting::Auto if self.topology.is_triangle_mesh() => Weighting::Cotangent,
            weighting => weighting,
        };
        (self.weights.smooth > 0.0).then(|| match weighting {
            Weighting::Auto | Weighting::Uniform => Laplacian::uniform(self.topology),
            Weighting::Cotangent => Laplacian::cotangent(self.mesh, self.topology),
            Weighting::Polygon => Laplacian::polygon(self.mesh),
        })
    }
}
