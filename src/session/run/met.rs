//! How well hard constraints are met, as the report says it.

use crate::mesh::Point;
use crate::scene::Scene;
use crate::session::state::{SolvedScene, same_problem};
use crate::solve::{ExactAnswer, Handle, Improved, Moved, Unmet};
use serde::Serialize;
use std::rc::Rc;

/// How hard constraints were met at some positions of a scene.
pub(crate) struct Met {
    positions: Rc<[Point]>,
    handles: Rc<[Handle]>,
    document: Scene,
    /// It was not interrupted.
    is_whole: bool,
    pub(crate) report: ExactReport,
}

impl Met {
    /// Of the scene as it is.
    pub(crate) fn new(scene: &SolvedScene, report: ExactReport) -> Met {
        Met {
            positions: Rc::clone(scene.positions()),
            handles: Rc::clone(scene.handles()),
            document: scene.document().clone(),
            is_whole: true,
            report,
        }
    }

    /// It was interrupted: there is more to gain.
    pub(crate) fn interrupt(&mut self) {
        self.is_whole = false;
    }

    /// Whether that is true of the scene as it is.
    pub(crate) fn is_of(&self, scene: &SolvedScene) -> bool {
        Rc::ptr_eq(&self.positions, scene.positions())
            && same_problem(&self.document, scene.document())
    }

    /// Whether the scene as it is has nothing to gain.
    pub(crate) fn is_all(&self, scene: &SolvedScene) -> bool {
        self.is_whole
            && (Rc::ptr_eq(&self.handles, scene.handles()) || self.handles == *scene.handles())
    }
}

/// Panels within a larger tolerance than was asked, so that no face is folded.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Eased {
    /// The tolerance that was asked, in the unit of the mesh.
    pub asked: f64,
    /// The larger one.
    pub within: f64,
    /// How many faces have it.
    pub panels: usize,
    /// How many faces were folded within the one that was asked.
    pub folded: usize,
}

/// Constraints that are not met are named up to this many.
const MOST_NAMED: usize = 1000;

/// How well hard constraints are met. Lengths are in the unit of the mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct ExactReport {
    /// The greatest distance of a vertex to the shape of a hard constraint.
    pub max_distance: f64,
    /// Up to this distance a constraint counts as met; the greatest where constraints have several.
    pub tolerance: f64,
    /// Whether all hard constraints are met.
    pub met: bool,
    /// Whether those that are not contradict each other.
    pub contradiction: bool,
    /// The entries of the scene's list of constraints that are not met.
    pub unmet: Vec<usize>,
    /// Whether the mesh is too large for what is to be exact: that is met up to about a hundred-thousandth of the size
    /// only.
    pub too_large: bool,
    /// How many constraints are not met, counted one by one.
    pub misses: usize,
    /// The worst of them, by the entry of the list.
    pub worst: Vec<Unmet>,
    /// The way from the soft solution.
    pub moved: Moved,
    /// How many edges are as short as they may be.
    pub on_guard: usize,
    /// The least ratio of a guarded edge to its length at rest; none without guard.
    pub shortest_edge: Option<f64>,
    /// Iterations of the approach.
    pub iterations: u32,
    /// Numeric factors of the scalar matrix.
    pub refactorizations: u32,
    /// Numeric factors of the matrix of blocks.
    pub block_factors: u32,
    /// How many ways to meet them were tried, so that no face is folded.
    pub attempts: u32,
    /// The panels that have a larger tolerance for that.
    pub eased: Option<Eased>,
    /// The gain of an improvement, where one was asked for.
    pub improved: Option<Improved>,
    /// Seconds of all of it.
    pub seconds: f64,
}

impl ExactReport {
    /// Of a shape that was found met: nothing was done for it.
    pub(crate) fn of_what_is_met(max_distance: f64, tolerance: f64) -> ExactReport {
        ExactReport {
            max_distance,
            tolerance,
            met: true,
            contradiction: false,
            unmet: Vec::new(),
            too_large: false,
            misses: 0,
            worst: Vec::new(),
            moved: Moved::default(),
            on_guard: 0,
            shortest_edge: None,
            iterations: 0,
            refactorizations: 0,
            block_factors: 0,
            attempts: 0,
            eased: None,
            improved: None,
            seconds: 0.0,
        }
    }

    /// Of an answer whose rows have these `places` in the scene's list of constraints.
    pub(crate) fn new(answer: ExactAnswer, places: &[usize]) -> ExactReport {
        let misses = answer.unmet.len();
        let mut unmet: Vec<usize> = answer.unmet.iter().map(|miss| places[miss.row]).collect();
        unmet.sort_unstable();
        unmet.dedup();
        let named = answer.unmet.into_iter().take(MOST_NAMED);
        ExactReport {
            max_distance: answer.max_distance,
            tolerance: answer.tolerance,
            met: answer.met,
            contradiction: answer.contradiction,
            unmet,
            too_large: answer.too_large,
            misses,
            worst: named.map(|miss| Unmet { row: places[miss.row], ..miss }).collect(),
            moved: answer.moved,
            on_guard: answer.on_guard.len(),
            shortest_edge: answer.shortest_edge,
            iterations: answer.iterations,
            refactorizations: answer.refactorizations,
            block_factors: answer.block_factors,
            attempts: 1,
            eased: None,
            improved: answer.improved,
            seconds: answer.seconds,
        }
    }
}
