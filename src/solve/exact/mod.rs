//! Hard constraints, which are met, not weighed: `min f(x)` subject to `N_i x` in `C_i` for hard
//! rows, where `f` is the energy of everything else. Both stages use only the projection `P_i` of
//! an operator.
//!
//! 1. The approach is the quasi-Newton iteration with shifted projections (the augmented Lagrangian
//!    of a set constraint) and a growing weight. It comes within 1e-5 of the size, or within the
//!    allowed distance.
//! 2. The polish takes least-change Newton steps onto the constraints, and ends at rounding error.
//!    It is for exact constraints, and for others if the approach stands still.
//!
//! Penalties alone converge like one over the weight, and Newton steps alone wander; both were
//! tried.

mod answer;
mod approach;
pub(super) mod block_system;
mod hard_rows;
mod improve;
mod least_move;
pub(super) mod model;
mod normal_space;
pub(super) mod polish;
mod requirement;

pub use answer::{ExactAnswer, Improved, Moved, Unmet};
pub use answer::{coordinate_rounding, exact_tolerance, farthest};
pub use least_move::{least_move, projections_at};
pub use requirement::{Require, Requirements};

use super::clock;
use super::energy::{Energy, Handle, IterateSeconds, springs};
use super::error::SolveError;
use super::local_frame::centre_and_extent;
use super::parts::SetupCache;
use super::problem::Problem;
use super::settings::SolverSettings;
use crate::constraint::Row;
use crate::mesh::Point;
use crate::sparse::BlockMatrix;
use approach::Approach;
use improve::Improve;
use model::Model;
use polish::{Polish, Polished};

/// The approach ends at this fraction of the size, or, if it was long, at [`NEAR_ENOUGH`]; the
/// polish follows.
const NEAR: f64 = 1e-5;
const NEAR_ENOUGH: f64 = 1e-4;

/// What is added to the metric of each node, as a fraction of the mean, for nodes that nothing else holds.
const HELD: f64 = 1e-3;

/// If the polish fails, the approach goes on to this fraction of the last distance, but not below
/// [`NEAREST`] times the size.
const NEARER: f64 = 0.3;
const NEAREST: f64 = 1e-7;

/// Greatest number of consecutive polishes. After the second, another one follows only if the last
/// one reduced the worst excess to the fraction [`GAINED`].
const POLISHES: u32 = 8;
const GAINED: f64 = 0.8;

/// Constraints that miss by at most this multiple of the tolerance are not said to contradict each
/// other: where steps gain little, they end on the way.
const NEARLY_MET: f64 = 100.0;

/// Greatest size of the factor of the polish in bytes; larger problems end with the approach.
const MOST_BYTES: f64 = 400e6;

/// With smoothness, the block factor of the polish has at most this fraction of the nonzeros of the
/// scalar factor, for each entry of a block: it couples only neighbours, see [`springs`]. On meshes
/// of quads of more than 1,000 vertices the fraction is .48 to .56, on triangles .32.
const COUPLED: f64 = 0.6;

/// Greatest number of pairs of points that constraints couple: each constraint couples all its
/// points in the system of the polish.
const MOST_COUPLED: f64 = 20e6;

/// Greatest sum of the cubes of the numbers of coordinates of the constraints: what their normal
/// spaces cost. One constraint on 500 points takes a second natively, and a few in a browser.
const MOST_CUBES: f64 = 3.5e9;

/// The stage after a call of [`Exact::step`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// An iteration of the approach.
    Approach,
    /// The end of a round of the approach: a good point to stop.
    Round,
    /// A step of the polish.
    Polish,
    /// A step of the improvement.
    Improve,
    /// All stages have ended.
    Ended,
}

/// A step-by-step solver for hard constraints.
pub struct Exact {
    model: Model,
    approach: Approach,
    polish: Option<Polish>,
    improve: Option<Improve>,
    /// Whether an improvement is requested.
    is_to_improve: bool,
    stage: Stage,
    /// The worst excess at which the approach ends.
    near: f64,
    /// Number of block factors when this polish began, and the positions.
    began: (u32, Vec<Row>),
    most_iterations: u32,
    can_polish: bool,
    /// Whether rows must be exact, but the problem is too large for the polish.
    too_large: bool,
    contradicts: bool,
    /// Number of approaches that have ended, and of polishes after the last one.
    tries: u32,
    polishes: u32,
    /// The least worst excess when the last polish began.
    polished_from: f64,
    /// The least worst excess so far, and its positions.
    best: (f64, Vec<Row>),
    seconds: f64,
}

impl Exact {
    /// Creates a solver for a problem whose rows have the requirements `requirements.rows`, from
    /// the positions `start`, `#V by 3`: preferably the solution with all rows soft. Each vertex
    /// has at most one handle.
    pub fn new(
        problem: &Problem<'_>,
        requirements: &Requirements<'_>,
        handles: &[Handle],
        start: &[Point],
        cache: SetupCache,
    ) -> Exact {
        let started = clock::now();
        let settings: SolverSettings = problem.settings;
        let model = Model::new(problem, requirements, handles, start, cache);
        let approach = Approach::new(&model, &settings);
        let worst = model.hard.worst_excess(&model.x);
        let can_polish = polish_fits(problem, requirements, model.parts.system.factor_nonzeros());
        // Bands are reached without a polish, unless rounds stand still.
        let near = if model.hard.any_exact() { NEAR * model.parts.extent } else { 0.0 };
        let most_iterations = approach.longer() * requirements.iterations;
        let mut exact = Exact {
            best: (worst, model.x.clone()),
            model,
            approach,
            polish: None,
            improve: None,
            is_to_improve: false,
            stage: Stage::Approach,
            near,
            began: (0, Vec::new()),
            most_iterations,
            can_polish,
            too_large: !can_polish && !requirements.all_within(),
            contradicts: false,
            tries: 0,
            polishes: 0,
            polished_from: worst,
            seconds: 0.0,
        };
        let goal = if can_polish { exact.model.goal() } else { near };
        if exact.model.is_met(goal) || exact.model.fixed_in_approach().iter().all(|fixed| *fixed) {
            exact.stage = Stage::Ended;
        } else if worst <= near && can_polish {
            exact.begin_polish();
        }
        exact.seconds = clock::now() - started;
        exact
    }

    /// Once all constraints are met, continues to a shape with less energy that meets them too. Has
    /// no effect if constraints are not met, or if the problem is too large. Can be called before
    /// or after the other steps.
    pub fn improve(&mut self) {
        self.is_to_improve = true;
        self.begin_improvement();
    }

    /// Performs one iteration of the approach, or one step of the polish or of the improvement;
    /// does nothing after the end.
    ///
    /// # Errors
    /// If a system is not positive definite. The best positions so far are kept.
    pub fn step(&mut self) -> Result<Stage, SolveError> {
        let started = clock::now();
        let result = match self.stage {
            Stage::Approach | Stage::Round => self.approach_step(),
            Stage::Polish => self.polish_step(),
            Stage::Improve => self.improve_step(),
            Stage::Ended => Ok(()),
        };
        if result.is_err() {
            self.end();
        } else {
            self.begin_improvement();
        }
        self.seconds += clock::now() - started;
        result.map(|()| self.stage)
    }

    /// Performs all steps.
    ///
    /// # Errors
    /// As [`Exact::step`].
    pub fn run(&mut self) -> Result<(), SolveError> {
        while self.step()? != Stage::Ended {}
        Ok(())
    }

    /// Ends the approach early; the polish starts from its positions.
    pub fn end_approach_early(&mut self) {
        if matches!(self.stage, Stage::Approach | Stage::Round) {
            self.end_approach();
        }
    }

    /// Ends all stages, with the best positions so far.
    pub fn stop(&mut self) {
        self.is_to_improve = false;
        if self.stage != Stage::Ended {
            // An improvement already has the best positions, although others may have less excess
            // by rounding.
            if self.stage != Stage::Improve {
                self.keep_best();
            }
            self.end();
        }
    }

    fn approach_step(&mut self) -> Result<(), SolveError> {
        self.stage = Stage::Approach;
        if !self.approach.iterate(&mut self.model)? {
            return Ok(());
        }
        self.stage = Stage::Round;
        let worst = self.keep_best();
        let is_long = self.approach.is_long() && self.tries == 0;
        if self.near > 0.0 && self.can_polish && is_long {
            self.near = NEAR_ENOUGH * self.model.parts.extent;
        }
        let near = if self.can_polish { worst <= self.near } else { self.model.is_met(self.near) };
        let stands = self.approach.stands_still(worst);
        self.contradicts |= stands;
        if self.model.is_met(self.model.goal()) {
            self.end();
        } else if near || stands || self.approach.iterations >= self.most_iterations {
            self.end_approach();
        }
        Ok(())
    }

    fn end_approach(&mut self) {
        if self.can_polish {
            self.begin_polish();
        } else {
            self.end();
        }
    }

    fn begin_polish(&mut self) {
        let model = &mut self.model;
        let polish = self.polish.get_or_insert_with(|| Polish::new(model, HELD, springs));
        polish.restart(false);
        self.began = (polish.factors, model.x.clone());
        (self.tries, self.polishes) = (self.tries + 1, 1);
        self.polished_from = self.best.0;
        self.stage = Stage::Polish;
    }

    fn polish_step(&mut self) -> Result<(), SolveError> {
        let Some(polish) = &mut self.polish else { return Ok(()) };
        if !self.model.has_free() {
            // Only the approach moves vertices along their curves.
            self.polish_failed();
            return Ok(());
        }
        let polished = polish.step(&mut self.model, self.began.0)?;
        self.keep_best();
        if polished == Polished::Contradicts {
            self.contradicts = true;
            // All constraints are met here except the contradicting ones; their excess would be
            // less if other constraints gave way.
            self.best.1.copy_from_slice(&self.model.x);
            self.end();
        } else if self.model.is_met(self.model.goal()) {
            self.end();
        } else if polished == Polished::Ended {
            self.polish_failed();
        }
        Ok(())
    }

    fn begin_improvement(&mut self) {
        let model = &mut self.model;
        if self.stage != Stage::Ended || !std::mem::take(&mut self.is_to_improve) {
            return;
        }
        if self.can_polish && model.has_free() && model.is_met(model.tolerance()) {
            let polish = self.polish.get_or_insert_with(|| Polish::new(model, HELD, springs));
            polish.restart(false);
            self.improve = Some(Improve::new(model, polish));
            self.stage = Stage::Improve;
        }
    }

    fn improve_step(&mut self) -> Result<(), SolveError> {
        let (Some(improve), Some(polish)) = (&mut self.improve, &mut self.polish) else {
            return Ok(());
        };
        let goes = improve.step(&mut self.model, polish)?;
        self.best = (self.model.hard.worst_excess(&self.model.x), self.model.x.clone());
        if !goes {
            self.end();
        }
        Ok(())
    }

    /// Tries again from the best positions with steps that gain, as long as they do. Otherwise
    /// continues the approach to a smaller distance, if it may go on. At last the steps lead to the
    /// shapes themselves instead of to the edge of what is tolerated.
    fn polish_failed(&mut self) {
        let gained = self.best.0 <= GAINED * self.polished_from;
        if let Some(polish) = &mut self.polish
            && (self.polishes == 1 || (gained && self.polishes < POLISHES))
        {
            self.model.x.copy_from_slice(&self.best.1);
            polish.restart(true);
            self.began.0 = polish.factors;
            self.polishes += 1;
            self.polished_from = self.best.0;
            return;
        }
        let nearer = NEARER * self.near;
        let is_far = self.best.0 > self.model.tolerance();
        if is_far
            && self.approach.iterations < self.most_iterations
            && nearer >= NEAREST * self.model.parts.extent
        {
            self.near = nearer;
            self.model.x.copy_from_slice(&self.began.1);
            self.stage = Stage::Round;
        } else if is_far
            && let Some(polish) = &mut self.polish
            && polish.system.aim_at_shapes()
        {
            self.model.x.copy_from_slice(&self.best.1);
            polish.restart(false);
            self.began.0 = polish.factors;
            (self.polishes, self.polished_from) = (1, self.best.0);
        } else {
            self.end();
        }
    }

    /// Keeps the positions if they are the best so far; returns their worst excess.
    fn keep_best(&mut self) -> f64 {
        let worst = self.model.hard.worst_excess(&self.model.x);
        // An approach that comes nearer also improves the shape.
        if worst <= self.best.0 {
            self.best.0 = worst;
            self.best.1.copy_from_slice(&self.model.x);
        }
        worst
    }

    fn end(&mut self) {
        self.stage = Stage::Ended;
        self.model.x.copy_from_slice(&self.best.1);
    }

    /// The current stage.
    pub fn stage(&self) -> Stage {
        self.stage
    }

    /// The current positions, `#V by 3`; after the end, the best ones.
    pub fn positions(&self) -> Vec<Point> {
        self.model.positions(&self.model.x)
    }

    /// The greatest distance of a constraint from being met at the current positions, in the unit
    /// of the mesh.
    pub fn worst_excess(&self) -> f64 {
        self.model.hard.worst_excess(&self.model.x)
    }

    /// The energies, without the hard rows, at the current positions.
    pub fn energy(&mut self) -> Energy {
        let mut gradient = vec![[0.0; 4]; self.model.x.len()];
        let mut seconds = IterateSeconds::default();
        self.model.parts.energies.evaluate(&self.model.x, &mut gradient, &mut seconds)
    }

    /// The result at the current positions.
    pub fn answer(&self) -> ExactAnswer {
        let polish = self.polish.as_ref();
        let measured = self.model.measure(&self.model.x);
        ExactAnswer {
            iterations: self.approach.iterations,
            refactorizations: self.approach.rounds,
            block_factors: polish.map_or(0, |polish| polish.factors),
            steps: polish.map_or(0, |polish| polish.steps),
            seconds: self.seconds,
            improved: self.improve.as_ref().map(Improve::gained),
            contradiction: self.contradicts
                && !measured.met
                && self.worst_excess() > NEARLY_MET * self.model.tolerance(),
            too_large: self.too_large,
            ..measured
        }
    }

    /// Whether the polish of a problem would not fit in memory, whatever must be exact. `nonzeros`
    /// are those of the factor with all rows soft; `is_smooth` is whether smoothness has a weight.
    pub fn is_too_large(nonzeros: usize, is_smooth: bool) -> bool {
        let coupled = if is_smooth { COUPLED } else { 1.0 };
        BlockMatrix::bytes(coupled * nonzeros as f64) > MOST_BYTES
    }

    /// Returns the distance to which exact constraints are met if the polish would not fit in
    /// memory, in the unit of the mesh: that at which the approach ends. `None` if it fits, or if
    /// nothing must be exact. `nonzeros` are those of the factor with all rows soft.
    pub fn nearest(
        problem: &Problem<'_>,
        requirements: &Requirements<'_>,
        nonzeros: usize,
    ) -> Option<f64> {
        let is_too_large =
            !requirements.all_within() && !polish_fits(problem, requirements, nonzeros);
        is_too_large.then(|| NEAR * centre_and_extent(problem.mesh).1)
    }

    /// Whether the polish fits in memory; otherwise constraints are met only to 1e-5 of the size.
    pub fn can_polish(&self) -> bool {
        self.can_polish
    }
}

/// Whether the system of the polish fits in memory, given the `nonzeros` of the scalar factor with
/// all rows soft.
pub(super) fn polish_fits(
    problem: &Problem<'_>,
    requirements: &Requirements<'_>,
    nonzeros: usize,
) -> bool {
    let hard = problem.constraints.iter().zip(requirements.rows).filter(|(_, it)| it.is_hard());
    let (mut coupled, mut cubes) = (0.0, 0.0);
    for members in hard.flat_map(|(row, _)| row.members.iter()) {
        let size = members.len() as f64;
        coupled += size * size;
        cubes += (3.0 * size).powi(3);
    }
    coupled <= MOST_COUPLED
        && cubes <= MOST_CUBES
        && !Exact::is_too_large(nonzeros, problem.weights.smooth > 0.0)
}
