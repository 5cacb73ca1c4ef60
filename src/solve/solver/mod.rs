//! The two-step iteration (paper sections 2.1 and 2.2) on one mesh.
//!
//! In delta form: `x -= A^-1 g(x)`, where `A = Q^T Q` is the normal matrix and
//! `g(x) = A x - Q^T p(x)` half the gradient of the total energy (Appendix A). The local step gives
//! `g` as a by-product, and the factor of `A` is only a metric: its rounding errors do not move the
//! fixed point.

mod handles;
mod saddle;
mod step;

use super::descent::Descent;
use super::energy::{CloseEnergy, Energy, Handle, HandleIndex, IterateSeconds};
use super::error::SolveError;
use super::gliding::Gliding;
use super::local_frame::{relative, rest_surface};
use super::parts::{Added, Parts, SetupCache};
use super::problem::Problem;
use super::settings::SolverSettings;
use super::system::{SetUpSeconds, System};
use crate::constraint::{Fitted, LocalStep, Projected, Row};
use crate::mesh::{Mesh, Point, Surface};
use std::rc::Rc;

/// A problem that is assembled, factored, and evaluated at its current positions.
pub struct Solver {
    /// The energies, the system of their global step, and the nodes that are not unknowns.
    parts: Parts,
    settings: SolverSettings,
    handles: Vec<Handle>,
    handle_index: HandleIndex,
    /// Whether the factor is that of the current handles.
    factored: bool,
    pinned: Vec<u32>,
    descent: Descent,
    x: Vec<Row>,
    /// The positions at which vertices were last put, `#V by 3`: a vertex that is still there keeps
    /// every bit of its coordinates.
    put: Vec<Point>,
    energy: Energy,
    /// The lowest total of an accelerated run, and its positions.
    best: Option<(f64, Vec<Row>)>,
    /// Changes of the total below this are rounding error: positions have no more digits.
    rounding: f64,
    converged: bool,
    /// The total at the last place that was found to be no saddle.
    no_saddle: Option<f64>,
    /// Whether the last step was not the plain one.
    accelerated: bool,
    seconds: IterateSeconds,
}

impl Solver {
    /// Assembles, orders, factors, and evaluates at the positions `start`, `#V by 3`. Each vertex
    /// has at most one handle. Reuses what another solver on the same mesh left in the `cache`.
    ///
    /// # Errors
    /// If the normal matrix is not positive definite.
    pub fn new(
        problem: &Problem<'_>,
        cache: SetupCache,
        handles: Vec<Handle>,
        start: &[Point],
    ) -> Result<Solver, SolveError> {
        let parts = Parts::new(problem, Added::default(), cache);
        let (n, settings) = (parts.held.len(), problem.settings);
        let x = parts.to_rows(start);
        let (extent, n_vertices) = (parts.extent, parts.n_vertices);
        let mut solver = Solver {
            parts,
            settings,
            handles: Vec::new(),
            handle_index: HandleIndex::new(n_vertices, &[]),
            factored: false,
            pinned: Vec::new(),
            descent: Descent::new(&settings, n),
            x,
            put: start.to_vec(),
            energy: Energy::default(),
            best: None,
            rounding: 1e-30 * extent * extent * n_vertices as f64,
            converged: false,
            no_saddle: None,
            accelerated: false,
            seconds: IterateSeconds::default(),
        };
        solver.set_handles(handles, None)?;
        Ok(solver)
    }

    /// Replaces the positions, `#V by 3`.
    pub fn set_positions(&mut self, positions: &[Point]) {
        self.place(Some(positions));
        self.retarget();
    }

    /// Replaces the positions, if given, without evaluating.
    fn place(&mut self, positions: Option<&[Point]>) {
        let Some(positions) = positions else { return };
        for (&point, &node) in positions.iter().zip(self.parts.system.node_of()) {
            self.x[node as usize] = relative(point, self.parts.centre);
        }
        self.put.copy_from_slice(positions);
    }

    /// Forgets the steps so far, and that their end was no saddle.
    fn forget(&mut self) {
        self.descent.forget();
        self.no_saddle = None;
    }

    /// Step I at `x`.
    fn evaluate(&mut self) {
        let gradient = &mut self.descent.gradient;
        self.energy = self.parts.energies.evaluate(&self.x, gradient, &mut self.seconds);
        self.parts.constrain(gradient);
    }

    /// Current positions, `#V by 3`.
    pub fn positions(&self) -> impl ExactSizeIterator<Item = Point> {
        (0..self.parts.n_vertices as u32).map(|vertex| self.position(vertex))
    }

    fn position(&self, vertex: u32) -> Point {
        let row = self.x[self.parts.system.node_of()[vertex as usize] as usize];
        let put = self.put[vertex as usize];
        if row == relative(put, self.parts.centre) { put } else { self.parts.to_point(row) }
    }

    /// The energies at the current positions.
    pub fn energy(&self) -> Energy {
        self.energy
    }
    /// The gradient of the total energy at the current positions (Appendix A), `#V by 3`; zero at
    /// fixed vertices, and along the curve at vertices that stay exactly on the boundary.
    pub fn gradient(&self) -> impl ExactSizeIterator<Item = Point> {
        let half = |&node: &u32| self.descent.gradient[node as usize];
        self.parts.node_of().iter().map(half).map(|[x, y, z, _]| [x + x, y + y, z + z])
    }
    /// Whether the last step changed the total by no more than the tolerance.
    pub fn converged(&self) -> bool {
        self.converged
    }
    /// Whether the last step was not the plain one, the least-squares solution for its projections.
    pub fn accelerated(&self) -> bool {
        self.accelerated
    }
    /// The handles, in the order in which they were made; targets in the unit of the mesh.
    pub fn handles(&self) -> &[Handle] {
        &self.handles
    }
    /// Returns for each vertex whether closeness or the boundary keeps it near a place, `#V`.
    pub(crate) fn is_kept_close(&self) -> Vec<bool> {
        let Parts { energies, gliding, corners, .. } = &self.parts;
        let close = energies.close.iter().flat_map(CloseEnergy::held).map(|(node, _)| node);
        let gliding = gliding.iter().flat_map(Gliding::vertices).map(|(_, node)| node);
        let mut by_node = vec![false; self.x.len()];
        close.chain(gliding).for_each(|node| by_node[node as usize] = true);
        let node_of = self.parts.node_of();
        corners.iter().for_each(|&(v, _)| by_node[node_of[v as usize] as usize] = true);
        node_of.iter().map(|&node| by_node[node as usize]).collect()
    }
    /// Vertices that are pinned because nothing else holds their component.
    pub fn pinned(&self) -> &[u32] {
        &self.pinned
    }
    /// Returns for each row of constraints its energy at the last local step, and the greatest
    /// squared distance of a point from its projection.
    pub fn found(&self) -> impl Iterator<Item = LocalStep> {
        self.parts.energies.shape.found()
    }
    /// The linear system of the global step.
    pub fn system(&self) -> &System {
        &self.parts.system
    }
    /// Returns the rest surface of `mesh`, which must be the mesh of the problem, and the centre
    /// that its coordinates are relative to. It is computed on first use.
    pub fn rest_surface(&self, mesh: &Mesh) -> (Rc<Surface>, Point) {
        let surface =
            self.parts.surface.get_or_init(|| Rc::new(rest_surface(mesh, self.parts.centre)));
        (Rc::clone(surface), self.parts.centre)
    }
    /// The surface of the mesh `target` that vertices are kept close to, and the centre that its
    /// coordinates are relative to; none if they are not kept close to it.
    pub fn target_surface(&self, target: &Rc<Mesh>) -> Option<(&Surface, Point)> {
        let (mesh, surface) = self.parts.target.as_ref()?;
        Rc::ptr_eq(mesh, target).then_some((surface, self.parts.centre))
    }

    /// The data that the next solver on the same mesh can reuse.
    pub fn setup_cache(&self) -> SetupCache {
        let analysis = Some(Rc::clone(self.parts.system.analysis()));
        SetupCache {
            surface: self.parts.surface.clone(),
            analysis,
            target: self.parts.target.clone(),
        }
    }
    /// Times of the set-up in seconds: terms and matrix, ordering and analysis, the last
    /// factorisation.
    pub fn set_up_seconds(&self) -> SetUpSeconds {
        self.parts.system.seconds
    }
    /// Times of all iterations so far in seconds, by part.
    pub fn iterate_seconds(&self) -> IterateSeconds {
        self.seconds
    }
}

impl Solver {
    /// Calls `each` with the row of every constraint, its vertices, and their displacements to the
    /// fitted shape at the current positions, in the unit of the mesh.
    pub fn projected(&mut self, mut each: impl FnMut(usize, &Projected)) {
        let mut vertex_of = vec![0; self.x.len()];
        for (vertex, &node) in (0..).zip(self.parts.node_of()) {
            vertex_of[node as usize] = vertex;
        }
        let mut points = Vec::new();
        self.parts.energies.shape.projected(&self.x, |row, projected| {
            points.clear();
            points.extend(projected.iter().map(|&(node, way)| (vertex_of[node as usize], way)));
            each(row, &points);
        });
    }

    /// The shapes fitted to the constraints at the current positions, for drawing.
    pub fn fitted(&self) -> Vec<Fitted> {
        let offset = self.parts.centre.into();
        let mut shapes = self.parts.energies.shape.fitted(&self.x);
        for shape in &mut shapes {
            match shape {
                Fitted::Circle { centre, .. } | Fitted::Sphere { centre, .. } => *centre += offset,
            }
        }
        shapes
    }
}
