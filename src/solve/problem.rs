//! The input of a solver, and the terms of its normal matrix.

use super::assemble::Terms;
use super::energy::{Constraints, extra_unknowns, shape_terms};
use super::settings::{
    BoundaryCloseness, ClosenessTo, Smoothness, SolverSettings, Weighting, Weights,
};
use crate::mesh::{Laplacian, Mesh, Point, Topology};
use std::rc::Rc;

/// A shape, the constraints on its vertices, and the weights of Eq. 13.
pub struct Problem<'a> {
    /// The rest shape `V'`; all other lengths are in its unit.
    pub mesh: &'a Mesh,
    /// Positions, `#V by 3`, used by closeness and smoothness instead of the rest shape.
    pub design: Option<&'a [Point]>,
    /// Positions, `#V by 3`, from which kinds that keep a rest shape take it, instead of from
    /// `mesh`.
    pub pose: Option<&'a [Point]>,
    /// The topology of `mesh`.
    pub topology: &'a Topology,
    /// All rows of constraints, resolved.
    pub constraints: &'a [Constraints],
    /// The weights of Eq. 13.
    pub weights: Weights,
    /// `c(v)` of Eq. 11: the target of each vertex.
    pub closeness_to: ClosenessTo,
    /// The surface of [`ClosenessTo::Target`].
    pub closeness_target: Option<&'a Rc<Mesh>>,
    /// Whether the `c(v)` of boundary vertices are on the boundary curves.
    pub boundary_closeness: BoundaryCloseness,
    /// `k_v` of each vertex, `#V`: factors of the closeness weight.
    pub closeness_factors: &'a [f64],
    /// `l_i` and `w_ij` of Eq. 12.
    pub smoothness: Smoothness,
    /// Accelerator, convergence tolerance, numeric factorisation.
    pub settings: SolverSettings,
}

impl Problem<'_> {
    /// Number of vertices and of extra unknowns, which are numbered after them.
    pub(super) fn n_unknowns(&self) -> usize {
        let extra = || extra_unknowns(self.constraints, self.settings.mean_centring);
        // Without the shape energy no term holds a mean.
        self.mesh.positions.len() + if self.weights.shape > 0.0 { extra() } else { 0 }
    }

    /// The part of the shape energy in the normal matrix, over all unknowns.
    pub(super) fn shape_terms(&self) -> Terms {
        if self.weights.shape > 0.0 {
            let n_vertices = self.mesh.positions.len();
            shape_terms(self.constraints, n_vertices, self.settings.mean_centring)
        } else {
            Terms::default()
        }
    }

    /// For `n` nodes, whether the shape energy holds them in place.
    pub(super) fn nodes_held_by(&self, shape_terms: &Terms, n: usize) -> Vec<bool> {
        let mut held = vec![false; n];
        if !self.settings.mean_centring {
            // Without N_i a constraint also resists translations of its points.
            shape_terms.nodes().indices().iter().for_each(|&v| held[v as usize] = true);
        } else if self.weights.shape > 0.0 {
            let placed = self.constraints.iter().flat_map(Constraints::placed);
            placed.for_each(|&v| held[v as usize] = true);
        }
        held
    }

    /// The Laplacian of the smoothness energy, if its weight is positive.
    pub(super) fn laplacian(&self) -> Option<Laplacian> {
        let weighting = match self.smoothness.weighting {
            // Edges inside tetrahedra have no cotangents.
            Weighting::Auto
                if Laplacian::has_cotangents(self.mesh) && self.mesh.tets.is_empty() =>
            {
                Weighting::Cotangent
            }
            weighting => weighting,
        };
        (self.weights.smooth > 0.0).then(|| match weighting {
            Weighting::Auto | Weighting::Uniform => Laplacian::uniform(self.topology),
            Weighting::Cotangent => Laplacian::cotangent(self.mesh, self.topology),
            Weighting::Polygon => Laplacian::polygon(self.mesh, self.topology),
        })
    }
}
