//! The queries of hosts: selections, previews, measures, reports, files.

use super::Session;
use super::edit::{ConstraintTarget, Preview, previews};
use super::export;
use super::report::{
    self, ConstraintMap, Measuring, Projections, Report, RowPalette, Shape, Verdict, WorstElement,
};
use super::selection::{SelectRequest, Selection, select};
use crate::mesh::{ElementsWithProblem, Measures, Mesh, Weld, write_obj_with_uv};
use crate::scene::{Forecast, GoalResult, MeshSource, Scene, SceneError};
use crate::solve::{
    ConformalNorm, ConformalWeights, FewerFlips, Moved, Parametrization, SolveError,
};
use std::rc::Rc;

/// A forecast for so many faces takes about half a second.
const MOST_FORESEEN: usize = 50_000;

impl Session {
    /// The selection after `request`, on the current shape; indices ascending.
    ///
    /// # Errors
    /// When it names an operation, a set, or an element that is not there, or when a parameter is not
    /// a number in its range.
    pub fn select(&mut self, request: &SelectRequest) -> Result<Selection, SceneError> {
        select(&mut self.measuring(), request)
    }

    /// The size of a row of each kind at each place: `#kinds by #places`, kinds in the order of
    /// [`crate::constraint::KINDS`]. None where nothing fits, and where the elements are not those that the
    /// kind is meant for.
    ///
    /// # Errors
    /// When a place names what is not there.
    pub fn previews(
        &self,
        places: &[ConstraintTarget],
    ) -> Result<Vec<Vec<Option<Preview>>>, SceneError> {
        previews(places, &self.document().sets, &self.rest)
    }

    /// Planarity and circularity of the faces as they are now.
    pub fn measures(&self) -> Rc<Measures> {
        self.measured.measures(&self.scene, &self.rest)
    }

    /// [`Session::measures`] at most `seconds` old: on large meshes measuring takes longer than an iteration.
    pub fn recent_measures(&self, seconds: f64) -> Rc<Measures> {
        self.measured.recent_measures(&self.scene, &self.rest, seconds)
    }

    /// The values of the measure `id`, `#F`, in its unit; not a number where a face has none, as the
    /// diagonals of a triangle. None when no measure is called so.
    pub fn face_values(&mut self, id: &str) -> Option<Vec<f64>> {
        self.face_values_of(id, Shape::Now)
    }

    /// [`Session::face_values`] of the current or of the original shape.
    pub fn face_values_of(&mut self, id: &str, shape: Shape) -> Option<Vec<f64>> {
        report::face_values(&mut self.measuring(), id, shape)
    }

    /// The values of the vertices (`#V`) whose largest a face has in the measure `id`, where they change
    /// gradually over the surface: distances to the original. None for every other measure.
    pub fn corner_values(&self, id: &str) -> Option<Vec<f64>> {
        report::corner_values(&self.scene, &self.rest, &self.measured, id)
    }

    /// The distance of each face to where its constraints want it, `#F`, in the unit of the mesh: the
    /// largest distance of a corner to its projection in any enabled constraint.
    pub fn residuals(&mut self) -> Vec<f64> {
        self.face_values("residual").unwrap_or_default()
    }

    /// The largest distance of a vertex to its projection over all rows that are on, as the last local
    /// step found it, in the unit of the mesh.
    pub fn worst_distance(&self) -> f64 {
        self.solver().found().map(|row| row.worst_squared).fold(0.0, f64::max).sqrt()
    }

    /// Distances of the vertices from their rest positions.
    pub fn moved(&self) -> Moved {
        report::moved(&self.scene, &self.rest)
    }

    /// The least length of an edge as a part of its length at rest; those without a length at rest do
    /// not count, and without edges it is 1.
    pub fn shortest_edge(&self) -> f64 {
        report::shortest_edge(&self.scene, &self.rest)
    }

    /// Mean length of an edge at rest, in the unit of the mesh; zero without edges.
    pub fn mean_edge(&self) -> f64 {
        self.rest.mean_edge()
    }

    /// A tolerance for distances on this mesh: about a thousandth of the mean edge, rounded to 1, 2 or 5
    /// times a power of ten, in the unit of the mesh.
    pub fn tolerance(&self) -> f64 {
        report::tolerance(&self.rest)
    }

    /// Corners of faces by their angles, in bins of five degrees from 0 to 180.
    pub fn angles(&self, shape: Shape) -> Vec<u32> {
        report::angles(&self.scene, &self.rest, shape)
    }

    /// How near the panels are to what they are asked to be, by the last row that is on and asks it of
    /// single faces: distances up to `tolerance` are within. None where nothing of the kind is asked.
    pub fn verdict(&mut self, tolerance: f64) -> Option<Verdict> {
        Verdict::of(&mut self.measuring(), tolerance)
    }

    /// How far the mesh as it was opened will move for panels of one shape; none where no such shape is offered, and
    /// where it would be waited for.
    pub fn forecast(&self) -> Option<Forecast> {
        let is_quick = self.mesh().faces.len() <= MOST_FORESEEN;
        is_quick.then(|| Forecast::of(self.mesh(), self.topology())).flatten()
    }

    /// Takes over numbers of what is built of the shape as it is, by the ids of
    /// [`crate::fabricate::BUILD_NUMBERS`]: they are measured elsewhere, and hold until the shape moves.
    pub fn tell_build(&mut self, numbers: Vec<(String, f64)>) {
        self.measured.tell(&self.scene, numbers);
    }

    /// The value of each goal of the lesson on the shape as it is, in their order; empty without a lesson. One on what is
    /// built has none until [`Session::tell_build`].
    pub fn goals(&mut self) -> Vec<GoalResult> {
        report::goals(&mut self.measuring())
    }

    /// The `count` faces with the largest values of the measure `id`, largest first, of equal ones
    /// the first of the mesh; those without a value are left out. None when no measure is called so.
    pub fn worst_faces(&mut self, id: &str, count: usize) -> Option<Vec<WorstElement>> {
        report::worst_faces(&mut self.measuring(), id, count)
    }

    /// The `count` constraints of row `index` that are farthest from being met, farthest first: the
    /// largest distance of a vertex to its projection, in the unit of the mesh. Empty where the row is
    /// off or is not there.
    pub fn worst_constraints(&mut self, index: usize, count: usize) -> Vec<WorstElement> {
        report::worst_constraints(&mut self.measuring(), index, count)
    }

    /// The projections at the current positions.
    pub fn projections(&mut self) -> Projections {
        report::projections(&mut self.scene, &self.rest)
    }

    /// The enabled row that acts on each face and each vertex.
    pub fn acting_rows(&self) -> ConstraintMap {
        report::acting_rows(self.rows(), &self.rest)
    }

    /// The colours of the rows of constraints.
    pub fn row_palette(&self) -> RowPalette {
        RowPalette::of(self.rows())
    }

    /// The faces and the vertices that row `index` acts on, ascending; a face counts when one of the
    /// row's constraints has all its corners.
    pub fn members(&self, index: usize) -> [Vec<u32>; 2] {
        report::members(self.rows().get(index), &self.rest)
    }

    /// The id of the measure that row `index` brings to zero on single faces: that of its kind, if each of its
    /// constraints is on one face.
    pub fn asked_measure(&self, index: usize) -> Option<&'static str> {
        report::asked_measure(self.document(), index)
    }

    /// How many vertices are kept close more or less than the others.
    pub fn held_otherwise(&self) -> usize {
        report::held_otherwise(self.document(), &self.rest)
    }

    /// The vertices on which neither a constraint nor closeness, smoothness, or a handle acts, ascending.
    pub fn free(&self) -> Vec<u32> {
        report::free(&self.scene, &self.rest)
    }

    /// The elements with the problem `name`, of [`super::flaw_of`] or [`super::ZERO_SIZE_FACES`]; none for
    /// any other name.
    pub fn elements_with_problem(&self, name: &str) -> Option<ElementsWithProblem> {
        report::elements_with_problem(name, self.scene.positions(), &self.rest)
    }

    /// The edges between these pairs of vertices, as places in [`crate::mesh::Topology::edges`], ascending.
    pub fn edges_between(&self, ends: &[[u32; 2]]) -> Vec<u32> {
        self.rest.edges_between(ends)
    }

    /// The report as of now.
    pub fn report(&self) -> Report {
        let collapsed = self.collapse().is_some();
        Report::of(
            &self.scene,
            &self.rest,
            &self.progress,
            &self.measures(),
            collapsed,
            self.exact(),
        )
    }

    /// One line per face, from 0: its corners, the groups that it is in, and every measure of
    /// [`super::FACE_MEASURES`]; empty where a face has no such value.
    pub fn errors_csv(&mut self) -> String {
        report::errors_csv(&mut self.measuring())
    }

    /// One line per recorded iteration since the scene was opened: the energies, weights included.
    pub fn convergence_csv(&self) -> String {
        report::convergence_csv(self.trace(), &self.document().units)
    }

    /// One line per bin: the angles where it begins and ends, and how many corners of the original
    /// and of the current shape are in it.
    pub fn angles_csv(&self) -> String {
        report::angles_csv(&self.scene, &self.rest)
    }

    /// The current shape as the text of an OBJ file, with the unit and the axis that are known.
    pub fn obj(&self) -> String {
        export::obj(&self.scene, &self.rest)
    }

    /// [`Session::obj`] with the vertices and faces that the file had before it was welded.
    pub fn obj_as_it_came(&self, weld: &Weld) -> String {
        export::obj_as_it_came(&self.scene, &self.rest, weld)
    }

    /// The current shape as OBJ with the texture coordinates `uv` of each vertex, `#V by 2`.
    ///
    /// # Errors
    /// Another number of coordinates than vertices, in words.
    pub fn obj_with_uv(&self, uv: &[[f64; 2]]) -> Result<String, String> {
        let vertices = self.rest.positions().len();
        if uv.len() != vertices {
            let found = 2 * uv.len();
            return Err(format!("{found} texture coordinates, expected {}", 2 * vertices));
        }
        Ok(write_obj_with_uv(self.mesh(), self.scene.positions(), uv))
    }

    /// The flat map of the current shape (paper section 4.3, Eq. 14).
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

    /// The weights and norm whose flat map of the current shape turns fewer than `flipped` faces over; see
    /// [`FewerFlips::of`].
    pub fn fewer_flips(&self, flipped: usize) -> Option<FewerFlips> {
        FewerFlips::of(&self.current_shape(), self.topology(), flipped)
    }

    fn current_shape(&self) -> Mesh {
        Mesh { positions: self.positions(), ..self.mesh().clone() }
    }

    /// The scene file with the mesh inline, as text.
    pub fn scene_with_mesh(&self) -> String {
        let mut scene = self.scene();
        scene.mesh = MeshSource::Inline(Box::new(self.mesh().clone()));
        scene.to_json(self.mesh())
    }

    /// The scene as it stands, with current positions when they are not at rest.
    pub fn scene(&self) -> Scene {
        export::whole_scene(&self.scene, &self.rest)
    }

    fn measuring(&mut self) -> Measuring<'_> {
        Measuring { rest: &self.rest, scene: &mut self.scene, cache: &self.measured }
    }
}
