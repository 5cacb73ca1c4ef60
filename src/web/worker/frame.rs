//! The numbers of one state of the iteration.

use super::solver::Solver;
use crate::constraint::LocalStep;
use crate::mesh::{Circularity, Planarity};
use crate::session::{EndWords, ExactReport, LessonProgress, Moved, Session};
use crate::solve::Energy;
use crate::web::values::{Js, plain};
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// The numbers of one state of the iteration.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
#[serde(rename_all = "camelCase")]
pub struct FrameNumbers {
    iteration: u32,
    converged: bool,
    /// What the run tries to meet its hard constraints; none before that.
    attempt: Option<&'static str>,
    /// How the run is described if it ends here.
    ended: EndWords,
    /// How the shape has collapsed, if it has.
    collapse: Option<String>,
    /// Whether the local step is done and the global step comes next.
    halfway: bool,
    energy: Energy,
    planarity: Planarity,
    circularity: Circularity,
    moved: Moved,
    /// The largest distance by the scene's measure, see [`Session::worst_by_scene_measure`].
    worst_distance: f64,
    /// The worst distance of each row of the document; zero for disabled rows.
    worst: Vec<f64>,
    /// The share of each row in the total energy, from 0 to 1.
    shares: Vec<f64>,
    /// The goals of the lesson, if there is one.
    lesson: Option<LessonProgress>,
    /// How well hard constraints are met; none before they are.
    exact: Option<ExactReport>,
    step_ms: f64,
}

/// Maximum age of the measures while iterating, in seconds.
const RENEWED: f64 = 0.5;

/// Maximum number of unmet constraints in a report.
const NAMED: usize = 100;

fn exact(session: &Session) -> Option<ExactReport> {
    let mut exact = session.exact()?;
    exact.worst.truncate(NAMED);
    Some(exact)
}

impl FrameNumbers {
    /// Creates the frame of `session`, after a step of `step_ms`; see [`Session::recent_measures`].
    fn new(session: &mut Session, step_ms: f64, iterating: bool) -> Self {
        let lesson = session.lesson_progress();
        let age = if iterating { RENEWED } else { 0.0 };
        let measures = session.recent_measures(age);
        let worst_distance = session.worst_by_scene_measure(age);
        let mut found = session.solver().found();
        let rows = session.rows().iter().map(|row| row.enabled.then(|| found.next()).flatten());
        let rows: Vec<LocalStep> = rows.map(Option::unwrap_or_default).collect();
        let energy = session.solver().energy();
        let whole = session.document().weights.shape / energy.total;
        let share = |row: &LocalStep| if energy.total > 0.0 { row.energy * whole } else { 0.0 };
        FrameNumbers {
            iteration: session.iteration(),
            converged: session.converged(),
            attempt: session.attempt_words(),
            ended: EndWords::after(session.iteration()),
            collapse: session.collapse().map(|collapse| collapse.to_string()),
            halfway: session.halfway(),
            energy,
            planarity: measures.planarity,
            circularity: measures.circularity,
            moved: session.moved(),
            worst_distance,
            worst: rows.iter().map(|row| row.worst_squared.sqrt()).collect(),
            shares: rows.iter().map(share).collect(),
            lesson,
            exact: exact(session),
            step_ms,
        }
    }
}

#[wasm_bindgen]
impl Solver {
    /// Returns the numbers of the current state. While `iterating`, planarity and circularity may
    /// be half a second old.
    pub fn frame(&mut self, iterating: bool) -> Result<Js<FrameNumbers>, JsValue> {
        let step_ms = self.step_ms;
        plain(&FrameNumbers::new(self.open_mut()?, step_ms, iterating))
    }
}
