//! Queries of hosts: offers, distances, the verdict for the report, flat maps.

use super::Session;
use super::edit::{ConstraintOffers, constraint_offers};
use super::report::{self, Verdict, VerdictWords};
use super::run::shortest_edge;
use super::trial::{BetterPresses, VerdictReport};
use crate::mesh::Mesh;
use crate::scene::{Forecast, SceneError};
use crate::session::Error;
use crate::solve::{
    ConformalNorm, ConformalWeights, FewerFlips, Moved, Parametrization, Require, SolveError,
};
use crate::words::{self, MeasureUnit};

/// A forecast for this many faces takes about half a second.
const MOST_FORECAST_FACES: usize = 50_000;

impl Session {
    /// Returns what is offered for a new constraint while `vertices` and `faces` are selected; the
    /// vertices include the corners of the faces.
    ///
    /// # Errors
    /// If a vertex or a face does not exist.
    pub fn constraint_offers(
        &self,
        vertices: Vec<u32>,
        faces: Vec<u32>,
    ) -> Result<ConstraintOffers, SceneError> {
        constraint_offers(vertices, faces, &self.document().sets, &self.rest)
    }

    /// Returns the largest distance of a vertex to its projection over all enabled rows, as found
    /// by the last local step, in the unit of the mesh.
    pub fn worst_distance(&self) -> f64 {
        self.solver().found().map(|row| row.worst_squared).fold(0.0, f64::max).sqrt()
    }

    /// Returns the distances of the vertices from their rest positions.
    pub fn moved(&self) -> Moved {
        self.rest.moved_by(self.scene.positions())
    }

    /// Says how far the mesh moved, as a sentence.
    pub fn moved_words(&self) -> String {
        let Moved { max, mean } = self.moved();
        match words::moved(max, mean, &self.document().units, self.rest.diameter()) {
            Some(far) => format!("Moved {far}."),
            None => "Nothing moved.".to_owned(),
        }
    }

    /// Returns the smallest ratio of an edge length to its rest length. Ignores edges of zero rest
    /// length; 1 without edges.
    pub fn shortest_edge(&self) -> f64 {
        shortest_edge(self.scene.positions(), &self.rest)
    }

    /// Mean edge length at rest, in the unit of the mesh; zero without edges.
    pub fn mean_edge(&self) -> f64 {
        self.rest.mean_edge()
    }

    /// Returns the distance within which panels have their shape, in the unit of the mesh: that of
    /// the scene, or else the one that the constraint on panels requires, or else that of the mesh.
    pub fn tolerance(&self) -> f64 {
        let required = || match self.panel_requirement()? {
            Require::Within(length) => Some(length),
            Require::Soft | Require::Exact => None,
        };
        self.document().tolerance.or_else(required).unwrap_or_else(|| self.mesh_tolerance())
    }

    /// What the constraint on panels requires; none if no row constrains panels.
    pub(super) fn panel_requirement(&self) -> Option<Require> {
        let document = self.document();
        report::panel_row(document).map(|row| document.constraints[row].require)
    }

    /// Returns a tolerance for distances on this mesh: about a thousandth of the mean edge, rounded
    /// to 1, 2 or 5 times a power of ten, in the unit of the mesh.
    pub(super) fn mesh_tolerance(&self) -> f64 {
        report::tolerance(self.rest.mean_edge(), self.rest.diameter())
    }

    /// Returns the verdict for the report; if `tries`, with better choices if the shape is not good.
    /// None if [`Session::verdict`] has none.
    ///
    /// # Errors
    /// As [`BetterPresses::step`].
    pub fn verdict_report(
        &mut self,
        tolerance: f64,
        tries: bool,
    ) -> Result<Option<VerdictReport>, Error> {
        let Some(numbers) = self.verdict(tolerance) else { return Ok(None) };
        let words = self.verdict_words(&numbers).full();
        let mut suggestions = Vec::new();
        let trials = if tries { BetterPresses::new(self, tolerance) } else { None };
        if let Some(mut trials) = trials {
            while trials.step()? {}
            suggestions = trials.found().to_vec();
        }
        Ok(Some(VerdictReport::new(numbers, words, suggestions)))
    }

    /// Returns a verdict on this shape in words.
    pub fn verdict_words(&self, verdict: &Verdict) -> VerdictWords {
        verdict.words(&self.document().units, self.rest.diameter(), self.rest.mean_edge())
    }

    /// Returns how far the mesh as opened would move for panels of one shape. None if no such shape
    /// is offered, or if the forecast would take too long.
    pub fn forecast(&self) -> Option<Forecast> {
        let is_quick = self.mesh().faces.len() <= MOST_FORECAST_FACES;
        is_quick.then(|| Forecast::of(self.mesh(), self.topology())).flatten()
    }

    /// Returns the largest distance by the scene's measure, of a face or, if that is the distance to the
    /// constraints, of any vertex. It is up to `seconds` old; rounding errors are 0, and so is the
    /// distance without a measure.
    pub fn worst_by_scene_measure(&self, seconds: f64) -> f64 {
        let measures = || self.recent_measures(seconds);
        let worst = match self.scene_measure() {
            None => 0.0,
            Some("planarity") => measures().planarity.max_distance,
            Some("circularity") => measures().circularity.max_distance,
            Some(_) => self.worst_distance(),
        };
        MeasureUnit::Length.or_zero(worst, self.rest.diameter())
    }

    /// Indices in [`crate::mesh::Topology::edges`] of the edges with these ends, ascending.
    pub fn edges_between(&self, ends: &[[u32; 2]]) -> Vec<u32> {
        self.rest.edges_between(ends)
    }

    /// Returns the flat map of the current shape (paper section 4.3, Eq. 14).
    ///
    /// # Errors
    /// As [`Parametrization::new`].
    pub fn parametrize(
        &self,
        weights: ConformalWeights,
        norm: ConformalNorm,
    ) -> Result<Parametrization, SolveError> {
        Parametrization::new(&self.current_shape(), self.topology(), weights, norm)
    }

    /// Returns the weights and norm whose flat map of the current shape flips fewer than `flipped`
    /// faces; see [`FewerFlips::of`].
    pub fn fewer_flips(&self, flipped: usize) -> Option<FewerFlips> {
        FewerFlips::of(&self.current_shape(), self.topology(), flipped)
    }

    /// The mesh at its current positions.
    pub(super) fn current_shape(&self) -> Mesh {
        self.mesh().at(self.scene.positions())
    }
}
