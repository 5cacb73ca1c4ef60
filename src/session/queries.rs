//! Queries of hosts: selections, previews, measures, reports, flat maps.

use super::Session;
use super::edit::{ConstraintOffers, constraint_offers};
use super::report::{
    self, ConstraintMap, ExactWords, FaceMeasure, LessonProgress, Measuring, Projections, Report,
    RowPalette, RunVerdict, Shape, Verdict, VerdictWords, WorstElement, WorstRow,
};
use super::run::shortest_edge;
use super::selection::{SelectRequest, Selection, select};
use super::trial::{BetterPresses, VerdictReport};
use crate::mesh::{ElementsWithProblem, Measures, Mesh};
use crate::scene::{Forecast, GoalResult, SceneError};
use crate::session::Error;
use crate::solve::{
    ConformalNorm, ConformalWeights, FewerFlips, Moved, Parametrization, Require, SolveError,
};
use crate::words::{self, MeasureUnit};
use std::rc::Rc;

/// A forecast for this many faces takes about half a second.
const MOST_FORECAST_FACES: usize = 50_000;

impl Session {
    /// Returns the selection after `request`, on the current shape; indices ascending.
    ///
    /// # Errors
    /// If it refers to an operation, a set or an element that does not exist, or if a parameter is
    /// not a number in its range.
    pub fn select(&mut self, request: &SelectRequest) -> Result<Selection, SceneError> {
        select(&mut self.measuring(), request)
    }

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

    /// Planarity and circularity of the faces of the current shape.
    pub fn measures(&self) -> Rc<Measures> {
        self.measured.measures(&self.scene, &self.rest)
    }

    /// As [`Session::measures`], up to `seconds` old: measuring may take longer than an iteration.
    pub fn recent_measures(&self, seconds: f64) -> Rc<Measures> {
        self.measured.recent_measures(&self.scene, &self.rest, seconds)
    }

    /// Returns the values of the measure `id`, `#F`, in its unit; NaN for faces without one, such
    /// as a triangle, which has no diagonals. None if there is no such measure.
    pub fn face_values(&mut self, id: &str) -> Option<Vec<f64>> {
        self.face_values_of(id, Shape::Now)
    }

    /// Returns the values of the measure `id` as [`Session::face_values`] does, and the largest absolute
    /// one; rounding errors are 0 there.
    pub fn face_values_and_greatest(&mut self, id: &str) -> Option<(Vec<f64>, f64)> {
        let unit = FaceMeasure::of(id)?.unit;
        let values = self.face_values(id)?;
        // In single precision, as the values that are drawn.
        let greatest = values.iter().fold(0.0, |most: f32, value| most.max(value.abs() as f32));
        Some((values, unit.or_zero(f64::from(greatest), self.rest.diameter())))
    }

    /// As [`Session::face_values`], for the current or the original shape.
    pub fn face_values_of(&mut self, id: &str, shape: Shape) -> Option<Vec<f64>> {
        report::face_values(&mut self.measuring(), id, shape)
    }

    /// Returns the vertex values (`#V`) whose maximum over a face is its measure `id`. Only for
    /// distances to the original, which vary gradually; none for any other measure.
    pub fn corner_values(&self, id: &str) -> Option<Vec<f64>> {
        report::corner_values(&self.scene, &self.rest, &self.measured, id)
    }

    /// Returns the residual of each face, `#F`, in the unit of the mesh: the largest distance of a
    /// corner to its projection in any enabled constraint.
    pub fn residuals(&mut self) -> Vec<f64> {
        self.face_values("residual").unwrap_or_default()
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

    /// Histogram of the face angles, in bins of five degrees from 0 to 180.
    pub fn angles(&self, shape: Shape) -> Vec<u32> {
        report::angles(&self.scene, &self.rest, shape)
    }

    /// Returns how many panels have the shape required by the last enabled row on single faces,
    /// with distances up to `tolerance`. None if no row constrains panels.
    pub fn verdict(&mut self, tolerance: f64) -> Option<Verdict> {
        let edge = self.edge_of_design();
        let met = self.met.as_ref().filter(|met| met.is_of(&self.scene));
        let Session { rest, scene, measured: cache, .. } = self;
        Verdict::of(&mut Measuring { rest, scene, cache }, tolerance, edge, met)
    }

    /// Says how many panels have the shape required of them so far, with distances up to `tolerance`.
    /// None if no row constrains panels.
    pub fn panel_progress(&mut self, tolerance: f64) -> Option<String> {
        report::panel_progress(&mut self.measuring(), tolerance)
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

    /// Returns in words whether the constraints are met, with distances up to `tolerance`. None if
    /// no constraint has a weight.
    pub fn run_verdict(&mut self, tolerance: f64) -> Option<RunVerdict> {
        RunVerdict::of(&mut self.measuring(), tolerance)
    }

    /// Says for each constraint on pairs of vertices, some of which have no partner, how many have one.
    pub fn unpaired_words(&self) -> Vec<String> {
        report::Unpaired::words(&self.scene)
    }

    /// Returns in words how well the hard constraints are met; none if they have not been met for
    /// the current shape, see [`Session::exact`].
    pub fn exact_words(&self) -> Option<ExactWords> {
        self.exact().map(|report| ExactWords::of(&self.scene, &report))
    }

    /// Returns how far the mesh as opened would move for panels of one shape. None if no such shape
    /// is offered, or if the forecast would take too long.
    pub fn forecast(&self) -> Option<Forecast> {
        let is_quick = self.mesh().faces.len() <= MOST_FORECAST_FACES;
        is_quick.then(|| Forecast::of(self.mesh(), self.topology())).flatten()
    }

    /// Stores numbers of the parts built from the current shape, by the ids of
    /// [`crate::fabricate::BUILD_NUMBERS`], until the shape, the settings of the build or the unit change.
    pub fn set_build_numbers(&mut self, numbers: Vec<(String, f64)>) {
        self.measured.set_build_numbers(&self.scene, numbers);
    }

    /// Returns the value of each goal of the lesson on the current shape, in their order; empty
    /// without a lesson. A goal on the built parts has no value before [`Session::set_build_numbers`].
    pub fn goals(&mut self) -> Vec<GoalResult> {
        report::goals(&mut self.measuring())
    }

    /// Returns the goals of the lesson on the current shape in words; none without a lesson.
    pub fn lesson_progress(&mut self) -> Option<LessonProgress> {
        report::progress(&mut self.measuring())
    }

    /// Returns the `count` faces with the largest absolute values of the measure `id`, largest
    /// first, ties in mesh order, without faces that have no value. None if there is no such
    /// measure.
    pub fn worst_faces(&mut self, id: &str, count: usize) -> Option<Vec<WorstElement>> {
        report::worst_faces(&mut self.measuring(), id, count)
    }

    /// Returns the `count` constraints of row `index` that are farthest from being met, farthest
    /// first, by the largest distance of a vertex to its projection, in the unit of the mesh. Empty
    /// if the row is disabled or does not exist.
    pub fn worst_constraints(&mut self, index: usize, count: usize) -> Vec<WorstElement> {
        report::worst_constraints(&mut self.measuring(), index, count)
    }

    /// Returns what [`Session::worst_faces`] does as a list. Lengths are written in the unit in which
    /// their `tolerance` is written.
    pub fn worst_faces_in_words(
        &mut self,
        id: &str,
        count: usize,
        tolerance: Option<f64>,
    ) -> Option<Vec<WorstRow>> {
        let unit = FaceMeasure::of(id)?.unit;
        let worst = self.worst_faces(id, count)?;
        Some(self.worst_in_words(worst, unit, tolerance))
    }

    /// Returns what [`Session::worst_constraints`] does as a list, in the unit in which `tolerance` is
    /// written.
    pub fn worst_constraints_in_words(
        &mut self,
        index: usize,
        count: usize,
        tolerance: Option<f64>,
    ) -> Vec<WorstRow> {
        let worst = self.worst_constraints(index, count);
        self.worst_in_words(worst, MeasureUnit::Length, tolerance)
    }

    fn worst_in_words(
        &self,
        worst: Vec<WorstElement>,
        unit: MeasureUnit,
        tolerance: Option<f64>,
    ) -> Vec<WorstRow> {
        let units = &self.document().units;
        worst.into_iter().map(|one| one.in_words(unit, &self.rest, units, tolerance)).collect()
    }

    /// Returns the projections at the current positions.
    pub fn projections(&mut self) -> Projections {
        report::projections(&mut self.scene, &self.rest)
    }

    /// Returns the enabled row that acts on each face and each vertex.
    pub fn acting_rows(&self) -> ConstraintMap {
        report::acting_rows(self.rows(), &self.rest)
    }

    /// Returns the colours of the rows of constraints.
    pub fn row_palette(&self) -> RowPalette {
        RowPalette::of(self.rows())
    }

    /// Returns the faces and the vertices that row `index` acts on, ascending. A face is included
    /// if one constraint of the row contains all its corners.
    pub fn members(&self, index: usize) -> [Vec<u32>; 2] {
        report::members(self.rows().get(index), &self.rest)
    }

    /// Returns the id of the measure that fits the scene: that of the first enabled row that has one,
    /// else the distance to the constraints; none without constraints or faces.
    pub fn scene_measure(&self) -> Option<&'static str> {
        report::scene_measure(self.document(), self.mesh())
    }

    /// Returns the id of the measure whose largest value over all faces is the largest distance of
    /// constraint row `index`; none if there is no such measure.
    pub fn row_measure(&self, index: usize) -> Option<&'static str> {
        report::row_measure(&self.scene, self.mesh(), index)
    }

    /// Returns the largest value of the scene's measure, up to `seconds` old; rounding errors are 0,
    /// and so is the value without a measure.
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

    /// Counts the vertices with a closeness factor other than 1.
    pub fn reweighted_vertices(&self) -> usize {
        report::reweighted_vertices(self.document(), &self.rest)
    }

    /// Returns the vertices without constraint, closeness, smoothness and handle, ascending.
    pub fn free(&self) -> Vec<u32> {
        report::free(&self.scene, &self.rest)
    }

    /// Returns the elements with the problem `name`, of [`super::flaw_of`] or
    /// [`super::ZERO_SIZE_FACES`]; none for any other name.
    pub fn elements_with_problem(&self, name: &str) -> Option<ElementsWithProblem> {
        report::elements_with_problem(name, self.scene.positions(), &self.rest)
    }

    /// Indices in [`crate::mesh::Topology::edges`] of the edges with these ends, ascending.
    pub fn edges_between(&self, ends: &[[u32; 2]]) -> Vec<u32> {
        self.rest.edges_between(ends)
    }

    /// Returns the report on the current state.
    pub fn report(&self) -> Report {
        // The steps that meet hard constraints are not iterations.
        let converged =
            self.scene.solver().converged() || self.met_here().is_some_and(|met| met.converged);
        Report::of(
            &self.scene,
            &self.rest,
            &self.progress,
            &self.measures(),
            converged && self.collapse().is_none(),
            self.exact(),
        )
    }

    /// One line per face, from 0: its corners, its groups, and every measure of
    /// [`super::FACE_MEASURES`], empty if the face has no value.
    pub fn errors_csv(&mut self) -> String {
        report::errors_csv(&mut self.measuring())
    }

    /// One line per recorded iteration since the scene was opened: the energies, of which the total has
    /// the weights.
    pub fn convergence_csv(&self) -> String {
        report::convergence_csv(self.trace(), &self.document().units)
    }

    /// One line per bin: its lower and upper angle, and the number of corners of the original and
    /// of the current shape in it.
    pub fn angles_csv(&self) -> String {
        report::angles_csv(&self.scene, &self.rest)
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

    fn measuring(&mut self) -> Measuring<'_> {
        Measuring { rest: &self.rest, scene: &mut self.scene, cache: &self.measured }
    }
}
