//! The two-step iteration (paper sections 2.1 and 2.2) on one mesh.
//!
//! In delta form: `x -= A^-1 g(x)`, where `A = Q^T Q` is the normal matrix and `g(x) = A x - Q^T p(x)`
//! half the gradient of the total energy (Appendix A). The local step gives `g` as a by-product, and
//! the factor of `A` is only a metric: its rounding cannot move the fixed point.

mod handles;

use super::accelerate::{Accelerator, Iterate};
use super::centred::{centre_and_extent, relative, rest_surface};
use super::close::{CloseEnergy, RestShape};
use super::energy::{Energies, Energy, IterateSeconds};
use super::hold::{Handle, HandlePlaces, SoftHandles};
use super::kept::Kept;
use super::problem::Problem;
use super::shape::ShapeEnergy;
use super::smooth::SmoothEnergy;
use super::system::{SetUpSeconds, System};
use super::{SolveError, clock, smooth};
use crate::constraint::{Fitted, LocalStep, Projected, Reference, Row};
use crate::mesh::{Mesh, Point, Surface};
use crate::scene::{SmoothnessOf, SolverSettings};
use std::cell::OnceCell;
use std::rc::Rc;

/// A problem that is assembled, factored, and evaluated at its current positions.
pub struct Solver {
    centre: Point,
    n_vertices: usize,
    /// Vertices and extra unknowns; nodes beyond are padding.
    n_unknowns: usize,
    settings: SolverSettings,
    system: System,
    /// See [`Kept::surface`].
    surface: OnceCell<Rc<Surface>>,
    energies: Energies,
    /// Nodes that the shape energy holds in their place.
    held: Vec<bool>,
    /// Corners of the boundary, if these are fixed, and where.
    corners: Vec<(u32, Point)>,
    handles: Vec<Handle>,
    handle_places: HandlePlaces,
    /// Whether the factor is that of these handles.
    factored: bool,
    pinned: Vec<u32>,
    accelerator: Accelerator,
    x: Vec<Row>,
    /// The positions that vertices were last put at, `#V by 3`: a vertex that is still there keeps
    /// every bit of its coordinates.
    put: Vec<Point>,
    /// Half the gradient of the total at `x`; zero where fixed.
    gradient: Vec<Row>,
    energy: Energy,
    /// The same before the last step.
    previous: (Vec<Row>, Vec<Row>),
    /// Whether there was one since the problem changed.
    has_previous: bool,
    /// Room for the next positions.
    next: Vec<Row>,
    /// The lowest total of an accelerated run, and where.
    best: Option<(f64, Vec<Row>)>,
    /// Changes of the total below this are rounding: positions have no more digits.
    rounding: f64,
    converged: bool,
    /// Whether the last step was not the plain one.
    accelerated: bool,
    seconds: IterateSeconds,
}

impl Solver {
    /// Assembles, orders, factors, and evaluates at the positions `start`, `#V by 3`. Each vertex
    /// has one handle at most. What another solver on the same mesh has `kept` is not made again.
    ///
    /// # Errors
    /// When the normal matrix is not positive definite.
    pub fn new(
        problem: &Problem<'_>,
        kept: Kept,
        handles: Vec<Handle>,
        start: &[Point],
    ) -> Result<Solver, SolveError> {
        let started = clock::now();
        let Problem { mesh, constraints, weights, settings, .. } = *problem;
        let n_vertices = mesh.positions.len();
        let n_unknowns = problem.n_unknowns();
        // `sprs-ldl` panics below two unknowns: the rest is padding, and fixed.
        let n = n_unknowns.max(2);
        let laplacian = problem.laplacian();
        let shape_terms = problem.shape_terms();
        let held = problem.nodes_held_by(&shape_terms, n);
        let smooth_terms = laplacian.as_ref().map(smooth::terms).unwrap_or_default();
        let before_system = clock::now();
        let terms = vec![shape_terms, smooth_terms];
        let Kept { surface: made, ordered } = kept;
        let mut system = System::with_order(n, terms, settings.factorization, ordered.as_ref());
        let after_system = clock::now();

        let (centre, diameter) = centre_and_extent(&mesh.positions);
        let node_of = &system.node_of()[..n_vertices];
        let to_rows = |points: &[Point]| {
            let mut rows = vec![[0.0; 4]; n];
            for (&point, &node) in points.iter().zip(node_of) {
                rows[node as usize] = relative(point, centre);
            }
            rows
        };
        let rest = to_rows(&mesh.positions);
        let x = to_rows(start);
        let surface = || Rc::clone(made.get_or_init(|| Rc::new(rest_surface(mesh, centre))));
        let reference = Reference { surface: &surface };
        let (close, corners) = if weights.close > 0.0 {
            let factors = problem.closeness_factors;
            let rest_shape =
                RestShape { rest: &rest, node_of, topology: problem.topology, surface: &surface };
            CloseEnergy::new(problem.closeness, factors, &rest_shape)
        } else {
            Default::default()
        };
        let energies = Energies {
            weights,
            shape: ShapeEnergy::new(constraints, node_of, &rest, settings.monotone, &reference),
            smooth: laplacian.map(|laplacian| {
                let rest = match problem.smoothness.of {
                    SmoothnessOf::Surface => Vec::new(),
                    SmoothnessOf::Displacement => rest.clone(),
                };
                SmoothEnergy::new(&laplacian, node_of, n, rest)
            }),
            close,
            handles: SoftHandles::default(),
        };
        let held = {
            let mut by_node = vec![false; n];
            held.iter().zip(system.node_of()).for_each(|(&h, &node)| by_node[node as usize] = h);
            by_node
        };
        system.seconds.assemble += before_system - started + clock::now() - after_system;

        let mut solver = Solver {
            centre,
            n_vertices,
            n_unknowns,
            settings,
            system,
            surface: made,
            energies,
            held,
            corners: corners.into_iter().map(|v| (v, mesh.positions[v as usize])).collect(),
            handles: Vec::new(),
            handle_places: HandlePlaces::new(n_vertices, &[]),
            factored: false,
            pinned: Vec::new(),
            accelerator: Accelerator::new(&settings),
            gradient: vec![[0.0; 4]; n],
            previous: (vec![[0.0; 4]; n], vec![[0.0; 4]; n]),
            has_previous: false,
            next: vec![[0.0; 4]; n],
            x,
            put: start.to_vec(),
            energy: Energy::default(),
            best: None,
            rounding: 1e-30 * diameter * diameter * n_vertices as f64,
            converged: false,
            accelerated: false,
            seconds: IterateSeconds::default(),
        };
        solver.hold(handles, None)?;
        Ok(solver)
    }

    /// Replaces the positions, `#V by 3`.
    pub fn set_positions(&mut self, positions: &[Point]) {
        self.place(Some(positions));
        self.retarget();
    }

    /// The same, if there are others, without evaluating there.
    fn place(&mut self, positions: Option<&[Point]>) {
        let Some(positions) = positions else { return };
        for (&point, &node) in positions.iter().zip(self.system.node_of()) {
            self.x[node as usize] = relative(point, self.centre);
        }
        self.put.copy_from_slice(positions);
    }

    /// Forgets the steps so far: the next one starts anew.
    fn forget(&mut self) {
        self.accelerator.forget();
        self.has_previous = false;
    }

    /// Step I at `x`.
    fn evaluate(&mut self) {
        self.energy = self.energies.evaluate(&self.x, &mut self.gradient, &mut self.seconds);
        self.system.clear_fixed(&mut self.gradient);
    }

    /// One iteration: step II from the projections at hand, then step I at the new positions.
    ///
    /// # Errors
    /// When a position leaves the finite numbers; the positions are then those before the step.
    pub fn step(&mut self) -> Result<(), SolveError> {
        if self.system.unknowns() == 0 && self.energy.total.is_finite() {
            self.accelerated = false;
            self.converged = self.settings.tolerance > 0.0;
            return Ok(());
        }
        self.system.prepare()?;
        let before = self.energy;
        let started = clock::now();
        let now = Iterate { x: &self.x, gradient: &self.gradient };
        let previous = Iterate { x: &self.previous.0, gradient: &self.previous.1 };
        let learned = self.has_previous;
        let previous = learned.then_some(previous);
        let accelerated = self.accelerator.propose(now, previous, &mut self.system, &mut self.next);
        std::mem::swap(&mut self.previous.0, &mut self.x);
        std::mem::swap(&mut self.previous.1, &mut self.gradient);
        std::mem::swap(&mut self.x, &mut self.next);
        self.has_previous = true;
        self.seconds.global += clock::now() - started;
        self.evaluate();
        // Without a step to learn from, a proposal is the plain step in fewer digits.
        self.accelerated = accelerated && learned;
        if accelerated {
            // Written so that NaN falls back too.
            let falls = self.energy.total < before.total;
            if !falls {
                self.accelerated = false;
                self.take_plain_step();
            }
            self.keep_best(before.total);
        }
        self.stop_non_finite()?;
        let change = (self.energy.total - before.total).abs();
        let tolerance = self.settings.tolerance;
        self.converged = tolerance > 0.0 && change <= (tolerance * before.total).max(self.rounding);
        Ok(())
    }

    /// The step of the plain iteration from the positions before.
    fn take_plain_step(&mut self) {
        let started = clock::now();
        let previous = Iterate { x: &self.previous.0, gradient: &self.previous.1 };
        self.system.plain_step(previous, &mut self.x);
        self.seconds.global += clock::now() - started;
        self.energies.shape.take_back();
        self.evaluate();
    }

    /// With operators that are not exact even the plain step can raise the total in a late digit.
    fn keep_best(&mut self, before: f64) {
        if self.energy.total > before && self.best.as_ref().is_none_or(|best| before < best.0) {
            self.best = Some((before, self.previous.0.clone()));
        }
    }

    /// Goes back to the lowest total of the run, if the last step was not it.
    pub fn settle(&mut self) {
        if let Some((total, x)) = self.best.take()
            && total < self.energy.total
        {
            self.x = x;
            self.forget();
            self.evaluate();
        }
    }

    /// The second of two gates for non-finite numbers; the first is where input is read.
    fn stop_non_finite(&mut self) -> Result<(), SolveError> {
        let finite = |row: &Row| row.iter().all(|value| value.is_finite());
        // Without a way out halfway it takes several at a time.
        let all_finite = |all: bool, value: &f64| all & value.is_finite();
        if self.energy.total.is_finite() && self.x.as_flattened().iter().fold(true, all_finite) {
            return Ok(());
        }
        let node = self.x.iter().position(|row| !finite(row)).unwrap_or(0) as u32;
        let vertex = self.system.node_of()[..self.n_vertices].iter().position(|&of| of == node);
        self.x.copy_from_slice(&self.previous.0);
        self.forget();
        self.evaluate();
        Err(SolveError::NotFinite { vertex: vertex.unwrap_or(0) as u32 })
    }

    /// Current positions, `#V by 3`.
    pub fn positions(&self) -> impl ExactSizeIterator<Item = Point> {
        (0..self.n_vertices as u32).map(|vertex| self.position(vertex))
    }

    fn position(&self, vertex: u32) -> Point {
        let row = self.x[self.system.node_of()[vertex as usize] as usize];
        let put = self.put[vertex as usize];
        if row == relative(put, self.centre) {
            put
        } else {
            std::array::from_fn(|i| row[i] + self.centre[i])
        }
    }

    /// The energies at the current positions.
    pub fn energy(&self) -> Energy {
        self.energy
    }
    /// The gradient of the total energy at the current positions (Appendix A), `#V by 3`; zero where
    /// vertices are fixed.
    pub fn gradient(&self) -> impl ExactSizeIterator<Item = Point> {
        let half = |&node: &u32| self.gradient[node as usize];
        self.system.node_of()[..self.n_vertices]
            .iter()
            .map(half)
            .map(|[x, y, z, _]| [x + x, y + y, z + z])
    }
    /// Whether the last step changed the total by no more than the tolerance.
    pub fn converged(&self) -> bool {
        self.converged
    }
    /// Whether the last step went elsewhere than to the least-squares answer to its projections.
    pub fn accelerated(&self) -> bool {
        self.accelerated
    }
    /// The handles.
    pub fn handles(&self) -> &[Handle] {
        &self.handles
    }
    /// Vertices pinned because nothing holds their part.
    pub fn pinned(&self) -> &[u32] {
        &self.pinned
    }
    /// What the last local step found in each row of constraints.
    pub fn found(&self) -> impl Iterator<Item = LocalStep> {
        self.energies.shape.found()
    }
    /// The linear system.
    pub fn system(&self) -> &System {
        &self.system
    }
    /// The rest surface of `mesh`, which is that of the problem, and the centre that its coordinates are
    /// relative to. It is made when it is first asked for.
    pub fn rest_surface(&self, mesh: &Mesh) -> (Rc<Surface>, Point) {
        let surface = self.surface.get_or_init(|| Rc::new(rest_surface(mesh, self.centre)));
        (Rc::clone(surface), self.centre)
    }
    /// For the next solver on the same mesh.
    pub fn kept(&self) -> Kept {
        Kept { surface: self.surface.clone(), ordered: Some(Rc::clone(self.system.ordered())) }
    }
    /// What setting up took.
    pub fn set_up_seconds(&self) -> SetUpSeconds {
        self.system.seconds
    }
    /// What iterating took.
    pub fn iterate_seconds(&self) -> IterateSeconds {
        self.seconds
    }

    /// Gives `each` the row of every constraint, its vertices, and the way from each of these to the
    /// shape that fits at the current positions, in the unit of the mesh.
    pub fn projected(&mut self, mut each: impl FnMut(usize, &Projected)) {
        let mut vertex_of = vec![0; self.x.len()];
        for (vertex, &node) in (0..).zip(&self.system.node_of()[..self.n_vertices]) {
            vertex_of[node as usize] = vertex;
        }
        let mut points = Vec::new();
        self.energies.shape.projected(&self.x, |row, projected| {
            points.clear();
            points.extend(projected.iter().map(|&(node, way)| (vertex_of[node as usize], way)));
            each(row, &points);
        });
    }

    /// The shapes that fit the constraints at the current positions, to be drawn.
    pub fn fitted(&self) -> Vec<Fitted> {
        let offset = self.centre.into();
        let mut shapes = self.energies.shape.fitted(&self.x);
        for shape in &mut shapes {
            match shape {
                Fitted::Circle { centre, .. } | Fitted::Sphere { centre, .. } => *centre += offset,
            }
        }
        shapes
    }
}
