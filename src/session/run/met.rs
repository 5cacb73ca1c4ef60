//! How well hard constraints are met, for the report.

use super::attempt::Tried;
use crate::session::state::{SceneState, SolvedScene, same_handles, same_problem};
use crate::solve::{ExactAnswer, Improved, Moved, Unmet};
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// How hard constraints were met, and the state of the scene that this holds for.
pub(crate) struct Met {
    state: SceneState,
    /// Whether all attempts ended without interruption.
    pub(crate) is_whole: bool,
    /// Whether the iterations before them had converged.
    pub(crate) converged: bool,
    pub(crate) report: ExactReport,
    /// The attempts that were made, and the index of the one that found the shape.
    pub(crate) tried: Vec<Tried>,
    pub(crate) chosen: Option<usize>,
}

impl Met {
    /// Records a report on the current state of the scene.
    pub(crate) fn new(scene: &SolvedScene, report: ExactReport) -> Met {
        Met {
            state: scene.state(),
            is_whole: true,
            converged: false,
            report,
            tried: Vec::new(),
            chosen: None,
        }
    }

    /// Whether the report holds for the current state of the scene, whatever its handles.
    pub(crate) fn is_of(&self, scene: &SolvedScene) -> bool {
        let SceneState { document, positions, .. } = &self.state;
        let (now, shape) = (scene.document(), scene.positions());
        Rc::ptr_eq(positions, shape) && (Rc::ptr_eq(document, now) || same_problem(document, now))
    }

    /// Whether another run cannot improve the current state of the scene.
    pub(crate) fn is_searched(&self, scene: &SolvedScene) -> bool {
        self.is_whole && same_handles(&self.state.handles, scene.handles())
    }
}

/// Panels with a larger tolerance than required, within which a shape was found that folds no face.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Eased {
    /// The required tolerance, in the unit of the mesh.
    pub asked: f64,
    /// The larger tolerance.
    pub within: f64,
    /// Number of faces with the larger tolerance.
    pub panels: usize,
    /// Number of faces that were folded within the required tolerance; 0 if constraints were only not
    /// met.
    pub folded: usize,
}

/// Maximum number of unmet constraints that are listed.
const MOST_NAMED: usize = 1000;

/// How well hard constraints are met. Lengths are in the unit of the mesh; numbers of work, but the
/// time, are of the attempt that found the shape.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct ExactReport {
    /// The largest distance of a vertex to its projection by a hard constraint.
    pub max_distance: f64,
    /// The distance up to which a constraint counts as met; the largest, if constraints differ.
    pub tolerance: f64,
    /// Whether all hard constraints are met.
    pub met: bool,
    /// Whether the unmet constraints contradict each other.
    pub contradiction: bool,
    /// Indices of the unmet rows in the scene's list of constraints.
    pub unmet: Vec<usize>,
    /// Whether the mesh, or one constraint, is too large to be exact: constraints are then met only
    /// up to about a hundred-thousandth of its size.
    pub too_large: bool,
    /// Number of unmet constraints, counted individually.
    pub misses: usize,
    /// The worst of them, with indices of rows in the list.
    pub worst: Vec<Unmet>,
    /// Displacements from where the attempt began.
    pub moved: Moved,
    /// Number of edges that are as short as allowed.
    pub on_guard: usize,
    /// The smallest ratio of a guarded edge length to its rest length; none without guarded edges.
    pub shortest_edge: Option<f64>,
    /// Number of iterations of the approach.
    pub iterations: u32,
    /// Number of numeric factorisations of the scalar matrix.
    pub refactorizations: u32,
    /// Number of numeric factorisations of the block matrix.
    pub block_factors: u32,
    /// Number of attempts to meet the constraints without folding faces.
    pub attempts: u32,
    /// The panels that needed a larger tolerance for that.
    pub eased: Option<Eased>,
    /// The gain of an improvement, if one was requested.
    pub improved: Option<Improved>,
    /// Time of all attempts in seconds.
    pub seconds: f64,
}

impl ExactReport {
    /// Reports on a shape that already met the constraints, without any work.
    pub(crate) fn of_what_is_met(max_distance: f64, tolerance: f64) -> ExactReport {
        ExactReport { max_distance, tolerance, met: true, ..ExactReport::default() }
    }

    /// Reports on an answer whose rows have these `places` in the scene's list of constraints.
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
