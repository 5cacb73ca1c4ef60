//! The shape space of a shape whose hard constraints are met: its softest variations that keep them
//! met (the tangent space of Yang, Yang, Pottmann, Mitra 2011, from projections only), and the
//! return onto the constraints after a step along them.
//!
//! The energy is that of smoothness of the displacement, and a little of the displacement itself.
//! One factor of the block system serves all modes; a step needs another one, and a few triangular
//! sweeps.

mod modes;
mod subspace;

pub use modes::{SLIDE, Variation};

use super::error::SolveError;
use crate::constraint::Row;
use crate::math::{Vec3, cosine, twice_vector_area};
use crate::mesh::{BoundaryCurves, Mesh, Point};
use crate::solve::energy::{smooth_terms, springs};
use crate::solve::exact::block_system::BlockSystem;
use crate::solve::exact::model::Model;
use crate::solve::exact::polish::{Polish, Polished};
use crate::solve::exact::polish_fits;
use crate::solve::{
    BoundaryRequire, Constraints, ExactAnswer, Handle, Hold, Problem, Require, Requirements,
    SetupCache, Smoothness, SmoothnessOf, Weighting, Weights,
};
use modes::{Mirror, goes_outwards, modes};
use std::collections::VecDeque;
use subspace::{Subspace, kept_motions};

/// What is added to the metric of each node, as a fraction of the mean, for nodes that nothing else holds:
/// small, so that soft modes differ.
const HELD: f64 = 1e-5;

/// Greatest number of factors of a step, and of one that is only tried to find the range of a mode.
const MOST_FACTORS: u32 = 8;
const MOST_FACTORS_TRIED: u32 = 3;

/// Number of halvings that find the end of a range.
const HALVINGS: u32 = 3;

/// If a step is not possible, these fractions of it are tried.
const SHORTER: [f64; 4] = [1.0, 0.75, 0.5, 0.25];

/// Constraints bring a step back by at most this fraction of its length: beyond, it leads
/// elsewhere.
const MOST_BACK: f64 = 0.5;

/// A shape whose hard constraints are met, and its softest variations.
pub struct ShapeSpace {
    model: Model,
    /// Brings steps back.
    polish: Polish,
    /// `#V by 3`: the shape.
    shape: Vec<Point>,
    /// The unit normals of the vertices, or zero.
    normals: Vec<Vec3<f64>>,
    /// The system that defines the stiffness of the modes, with the iteration; `None` once they are
    /// found.
    subspace: Option<(Subspace, BlockSystem)>,
    modes: Vec<Variation>,
    untried: VecDeque<Trial>,
    /// Whether the current factor is that of the shape.
    is_at_shape: bool,
    /// The constraints that are not held at the shape: edges that are longer than required.
    inactive: Vec<bool>,
    /// Whether nothing is required within a distance: the factor of the shape then serves steps
    /// from it.
    is_exact: bool,
}

/// A search for one end of the range of a mode.
struct Trial {
    mode: usize,
    side: usize,
    /// The greatest possible and the least impossible coefficient so far, without their sign.
    between: [f64; 2],
    halvings: u32,
}

/// The result of a step along some modes.
#[derive(Clone, Debug)]
pub struct Reached {
    /// `#V by 3`.
    pub positions: Vec<Point>,
    /// The fraction of the step that was taken; the rest is not possible.
    pub part: f64,
    /// How well the constraints are met; displacements are relative to the shape.
    pub answer: ExactAnswer,
}

impl ShapeSpace {
    /// Creates the shape space at the positions `shape`, `#V by 3`, where the hard rows of
    /// `problem` are met. Its weights and soft rows are ignored. Fixed handles stay, soft ones are
    /// ignored. The directions keep constraints "within a distance" as they are; the steps keep
    /// them within the distance.
    ///
    /// # Errors
    /// If the problem is too large, as for exact constraints, or the system is not positive definite.
    pub fn new(
        problem: &Problem<'_>,
        requirements: &Requirements<'_>,
        handles: &[Handle],
        shape: &[Point],
        cache: SetupCache,
    ) -> Result<ShapeSpace, SolveError> {
        let corners = fixed_corners(problem, handles);
        let rows = problem.constraints.iter().zip(requirements.rows);
        let (constraints, requires): (Vec<Constraints>, Vec<Require>) = rows
            .filter(|(_, require)| require.is_hard())
            .map(|(row, it)| (row.clone(), *it))
            .unzip();
        let problem = Problem {
            constraints: &constraints,
            weights: Weights { shape: 0.0, close: 0.0, smooth: 1.0 },
            smoothness: Smoothness {
                of: SmoothnessOf::Displacement,
                weighting: Weighting::Uniform,
            },
            ..*problem
        };
        let requirements = Requirements { rows: &requires, ..*requirements };
        let is_fixed = |handle: &&Handle| handle.hold == Hold::Fixed;
        let mut held: Vec<Handle> = handles.iter().filter(is_fixed).copied().collect();
        held.extend(corners.into_iter().map(|vertex| {
            let target = shape[vertex as usize];
            Handle { vertex, target, hold: Hold::Fixed }
        }));
        held.extend(alone(&problem, &held, shape));
        let mut model = Model::new(&problem, &requirements, &held, shape, cache);
        if !polish_fits(&problem, &requirements, model.parts.system.factor_nonzeros()) {
            return Err(SolveError::TooLarge);
        }
        // The small addition to the metric holds them: the shape is free to move.
        for &vertex in &model.holding.pinned {
            let node = model.parts.system.node_of()[vertex as usize];
            model.holding.fixed[node as usize] = false;
        }
        let mut system = BlockSystem::new(&model, HELD, smooth_terms);
        system.factor(&model, false)?;
        let nodes = system.node_of().to_vec();
        let at = by_node(&system, &model);
        let motions = kept_motions(&mut system, &at, &nodes);
        let subspace = Subspace::new(&system, motions);
        Ok(ShapeSpace {
            normals: normals(problem.mesh, shape),
            shape: shape.to_vec(),
            inactive: system.inactive(),
            subspace: Some((subspace, system)),
            modes: Vec::new(),
            untried: VecDeque::new(),
            is_at_shape: false,
            is_exact: !requires.iter().any(|require| matches!(require, Require::Within(_))),
            polish: Polish::new(&model, HELD, springs),
            model,
        })
    }

    /// Performs one iteration for the modes, or, once they are found, one trial for their ranges;
    /// returns whether there is more to do.
    ///
    /// # Errors
    /// If a system is not positive definite.
    pub fn step(&mut self) -> Result<bool, SolveError> {
        match &mut self.subspace {
            Some((subspace, system)) => {
                if !subspace.iterate(system) {
                    self.find_modes();
                }
            }
            None => self.try_range()?,
        }
        Ok(self.subspace.is_some() || !self.untried.is_empty())
    }

    /// The modes, the softest first; empty until they are found. There are fewer than eight if the
    /// shape has fewer variations.
    pub fn modes(&self) -> &[Variation] {
        &self.modes
    }

    /// Whether the modes are found; their ranges may not be known yet.
    pub fn has_modes(&self) -> bool {
        self.subspace.is_none()
    }

    /// The shape, `#V by 3`, plus the modes times these coefficients, not yet brought back onto the
    /// constraints.
    pub fn towards(&self, coefficients: &[f64]) -> Vec<Point> {
        let mut positions = self.shape.clone();
        for (mode, coefficient) in self.modes.iter().zip(coefficients).filter(|(_, c)| **c != 0.0) {
            for (point, offset) in positions.iter_mut().zip(&mode.displacement) {
                (0..3).for_each(|c| point[c] += coefficient * offset[c]);
            }
        }
        positions
    }

    /// Moves along the modes with these coefficients, and back onto the constraints, as far as
    /// possible.
    ///
    /// # Errors
    /// If a system is not positive definite.
    pub fn move_along(&mut self, coefficients: &[f64]) -> Result<Reached, SolveError> {
        let mut reached = 0.0;
        if coefficients.iter().any(|coefficient| *coefficient != 0.0) {
            for part in SHORTER {
                let shorter: Vec<f64> = coefficients.iter().map(|c| part * c).collect();
                // The factor of the shape may lead far elsewhere.
                let is_quick = part == 1.0
                    && self.is_exact
                    && self.bring_back(&shorter, MOST_FACTORS, true)?;
                if is_quick || self.bring_back(&shorter, MOST_FACTORS, false)? {
                    reached = part;
                    break;
                }
            }
        }
        if reached == 0.0 {
            self.model.x.copy_from_slice(&self.model.start);
        }
        Ok(Reached {
            positions: self.model.positions(&self.model.x),
            part: reached,
            answer: self.model.measure(&self.model.x),
        })
    }

    /// How well the constraints are met at other positions, `#V by 3`.
    pub fn measure(&self, positions: &[Point]) -> ExactAnswer {
        self.model.measure(&self.model.parts.to_rows(positions))
    }

    fn find_modes(&mut self) {
        let Some((subspace, mut system)) = self.subspace.take() else { return };
        let nodes = system.node_of().to_vec();
        let at = by_node(&system, &self.model);
        let size = self.model.parts.extent;
        let mirrors = Mirror::all(&at, &nodes, size);
        for (mode, stiffness) in modes(&mut system, subspace, &mirrors) {
            let rows = nodes.iter().map(|&node| mode[node as usize]);
            let mut displacement: Vec<Point> = rows.map(|[x, y, z, _]| [x, y, z]).collect();
            let lengths = displacement.iter().map(|&d| Vec3::from(d).length());
            let longest = lengths.fold(0.0, f64::max);
            let outwards = goes_outwards(&displacement, &self.normals, &self.shape);
            let scale = if outwards { size / longest } else { -size / longest };
            displacement.as_flattened_mut().iter_mut().for_each(|value| *value *= scale);
            self.modes.push(Variation { displacement, stiffness, range: None });
        }
        let trials = (0..self.modes.len()).flat_map(|mode| [1, 0].map(|side| (mode, side)));
        let untried = trials.map(|(mode, side)| Trial {
            mode,
            side,
            between: [0.0, 2.0 * SLIDE],
            halvings: 0,
        });
        self.untried = untried.collect();
    }

    /// Tries how far a mode can go to one side.
    fn try_range(&mut self) -> Result<(), SolveError> {
        let Some(mut trial) = self.untried.pop_front() else { return Ok(()) };
        let middle = 0.5 * (trial.between[0] + trial.between[1]);
        let mut coefficients = vec![0.0; self.modes.len()];
        coefficients[trial.mode] = if trial.side == 1 { middle } else { -middle };
        let possible = self.bring_back(&coefficients, MOST_FACTORS_TRIED, false)?;
        trial.between[usize::from(!possible)] = middle;
        trial.halvings += 1;
        if (possible && middle == SLIDE) || trial.halvings > HALVINGS {
            let range = self.modes[trial.mode].range.get_or_insert([f64::NAN; 2]);
            range[trial.side] = if trial.side == 1 { trial.between[0] } else { -trial.between[0] };
        } else {
            self.untried.push_front(trial);
        }
        Ok(())
    }

    /// Moves along the modes and back onto the constraints, with at most this many factors besides
    /// that of the shape, which is used first if `from_shape`; returns whether that succeeded.
    fn bring_back(
        &mut self,
        coefficients: &[f64],
        factors: u32,
        from_shape: bool,
    ) -> Result<bool, SolveError> {
        let there = self.model.parts.to_rows(&self.towards(coefficients));
        let (model, polish) = (&mut self.model, &mut self.polish);
        polish.restart(false);
        if from_shape {
            // Checked before computing a factor that would not serve.
            if polish.system.is_violated(model, &there, &self.inactive) {
                return Ok(false);
            }
            if !self.is_at_shape {
                model.x.copy_from_slice(&model.start);
                polish.system.factor(model, false)?;
            }
            polish.resume();
        }
        let goal = model.goal();
        let fixed = model.holding.fixed.iter().zip(&there).enumerate();
        for (node, (_, row)) in fixed.filter(|(_, (fixed, _))| !**fixed) {
            model.x[node] = *row;
        }
        let from: Vec<Row> = model.x.clone();
        let began = polish.factors;
        self.is_at_shape = from_shape;
        while !model.is_met(goal) {
            let polished = polish.try_step(model, began);
            self.is_at_shape &= matches!(polished, Ok(Some(_))) && polish.factors == began;
            if polished? != Some(Polished::Continues) || polish.factors - began > factors {
                return Ok(false);
            }
        }
        let farthest = |a: &[Row], b: &[Row]| {
            let away = a
                .iter()
                .zip(b)
                .map(|(a, b)| (0..3).map(|c| (a[c] - b[c]) * (a[c] - b[c])).sum::<f64>());
            away.fold(0.0, f64::max).sqrt()
        };
        let (length, back) = (farthest(&from, &model.start), farthest(&from, &model.x));
        // Written so that NaN is not possible.
        Ok(back <= MOST_BACK * length + goal)
    }
}

/// The positions of the model by nodes of a block system.
fn by_node(system: &BlockSystem, model: &Model) -> Vec<Row> {
    let mut at = vec![[0.0; 4]; system.size()];
    for (&own, &node) in system.node_of().iter().zip(model.parts.system.node_of()) {
        at[own as usize] = model.x[node as usize];
    }
    at
}

/// The corners that closeness to the boundary fixes, except those with a handle.
fn fixed_corners(problem: &Problem<'_>, handles: &[Handle]) -> Vec<u32> {
    let boundary = problem.boundary_closeness;
    // On curves that the vertices may not leave, the corners are fixed anyway.
    if boundary.require != BoundaryRequire::Soft || problem.weights.close <= 0.0 {
        return Vec::new();
    }
    let shape = problem.design.unwrap_or(&problem.mesh.positions);
    let found = BoundaryCurves::new(shape, problem.topology, cosine(boundary.corners / 360.0));
    let is_fixed = |v: &u32| {
        let has_handle = handles.iter().any(|handle| handle.vertex == *v);
        problem.closeness_factors[*v as usize] != 0.0 && !has_handle
    };
    found.corners.into_iter().filter(is_fixed).collect()
}

/// Handles for the vertices without a face or a constraint, which nothing else determines.
fn alone<'a>(
    problem: &'a Problem<'_>,
    held: &[Handle],
    shape: &'a [Point],
) -> impl Iterator<Item = Handle> + use<'a> {
    let mut free = vec![true; shape.len()];
    held.iter().for_each(|handle| free[handle.vertex as usize] = false);
    for row in problem.constraints {
        row.members.indices().iter().for_each(|&v| free[v as usize] = false);
    }
    let neighbours = problem.topology.neighbours();
    (0..).zip(shape).filter_map(move |(vertex, &target)| {
        let is_alone = free[vertex as usize] && neighbours.row(vertex as usize).is_empty();
        is_alone.then_some(Handle { vertex, target, hold: Hold::Fixed })
    })
}

/// Unit normals of the vertices, weighted by area; zero if there is none.
fn normals(mesh: &Mesh, shape: &[Point]) -> Vec<Vec3<f64>> {
    let mut normals = vec![Vec3::zero(); shape.len()];
    for face in mesh.faces.iter() {
        let corners: Vec<Vec3<f64>> = face.iter().map(|&v| shape[v as usize].into()).collect();
        let area = twice_vector_area(corners);
        face.iter().for_each(|&v| normals[v as usize] += area);
    }
    normals.iter().map(|normal| normal.length_and_direction().1.unwrap_or(Vec3::zero())).collect()
}
