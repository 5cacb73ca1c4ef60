//! Edits to offer if a run has ended with unmet constraints. Each is tried on a copy of the
//! session, so that only edits that reduce the worst distance are offered.

use crate::mesh::Point;
use crate::scene::ClosenessTo;
use crate::session::Error;
use crate::session::Session;
use crate::session::edit::Edit;
use serde::Serialize;
use serde_json::{Value, json};
use std::rc::Rc;

/// Maximum number of iterations of a trial.
const ITERATIONS: u32 = 200;
/// To be offered, an edit must reduce the worst distance below this fraction of its initial value.
const HELPS: f64 = 0.9;
/// An edit that moves a vertex by more than this fraction of the size of the mesh is not offered.
const FAR: f64 = 0.25;
/// Factor by which weights are lowered and raised.
const FACTOR: f64 = 10.0;
/// Largest factor of the weight of the constraints.
const MOST_FACTOR: f64 = 1000.0;

/// An edit that reduces the worst distance.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Suggestion {
    /// The label of the edit.
    pub label: String,
    /// The edit in JSON, for [`Edit::from_json`].
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Edit"))]
    pub edit: Value,
    /// The worst distance of a vertex to its projection after the trial, in the unit of the mesh.
    pub worst: f64,
}

/// The trials, run iteration by iteration.
pub struct Suggestions {
    /// The copy on which edits are tried.
    session: Session,
    /// The shape at which each trial begins, `#V by 3`.
    start: Rc<[Point]>,
    before: f64,
    /// Edits still to be tried, the next one last.
    untried: Vec<(String, Value)>,
    current: Option<Trial>,
    found: Vec<Suggestion>,
}

struct Trial {
    label: String,
    edit: Value,
    iterations: u32,
}

impl Suggestions {
    /// Prepares the trials for a session whose run has ended.
    ///
    /// # Errors
    /// As [`Session::open`]; not expected, because the scene could be solved before.
    pub fn new(session: &Session) -> Result<Suggestions, Error> {
        let mut untried = candidates(session);
        untried.reverse();
        let copy = Session::open(session.scene(), session.mesh().clone())?;
        let (start, before) = (Rc::clone(copy.scene.positions()), worst(session));
        Ok(Suggestions { session: copy, start, before, untried, current: None, found: Vec::new() })
    }

    /// Runs one iteration; returns whether there is more to try.
    ///
    /// # Errors
    /// As [`Session::undo`].
    pub fn step(&mut self) -> Result<bool, Error> {
        let Some(trial) = &mut self.current else {
            return self.begin_next();
        };
        trial.iterations += 1;
        // An edit that makes positions non-finite does not help.
        let ended = self.session.step().map_or(true, |step| step.ended);
        if ended || trial.iterations >= ITERATIONS {
            self.end_current()?;
        }
        Ok(self.current.is_some() || !self.untried.is_empty())
    }

    /// The suggestions found so far, the most effective first.
    pub fn found(&self) -> &[Suggestion] {
        &self.found
    }

    fn begin_next(&mut self) -> Result<bool, Error> {
        let Some((label, edit)) = self.untried.pop() else { return Ok(false) };
        let read = Edit::from_json(&edit.to_string())?;
        // Nor does an edit help that is refused, for example because nothing would hold the mesh, or
        // that changes nothing.
        if self.session.edit(read).is_ok_and(|is_step| is_step) {
            self.current = Some(Trial { label, edit, iterations: 0 });
        }
        Ok(true)
    }

    fn end_current(&mut self) -> Result<(), Error> {
        let Some(Trial { label, edit, .. }) = self.current.take() else { return Ok(()) };
        let worst = worst(&self.session);
        // Nor does an edit help whose run collapses the shape.
        let is_whole = self.session.collapse_since(&self.start).is_none();
        if worst < HELPS * self.before && is_whole && self.session.moved().max < self.far() {
            let place = self.found.partition_point(|other| other.worst <= worst);
            self.found.insert(place, Suggestion { label, edit, worst });
        }
        self.session.undo()?;
        Ok(())
    }

    fn far(&self) -> f64 {
        FAR * self.session.mesh().size()
    }
}

/// The distance by which edits are compared.
fn worst(session: &Session) -> f64 {
    session.scene.worst_row().map_or(0.0, |(_, far)| far)
}

/// Returns the factor of the weight of the constraints, a power of ten, that brings all of them
/// within the tolerance of the mesh. Distances are about inversely proportional to the weight.
fn sufficient_factor(session: &Session) -> f64 {
    let mut factor = FACTOR;
    while factor < MOST_FACTOR && worst(session) > factor * session.tolerance() {
        factor *= FACTOR;
    }
    factor
}

/// Returns the edits to try, in order.
fn candidates(session: &Session) -> Vec<(String, Value)> {
    let document = session.document();
    let weights = document.weights;
    let mut candidates = Vec::new();
    let mut offer = |label: &str, edit: Value| candidates.push((label.to_owned(), edit));
    let is_close = weights.close > 0.0 && document.closeness.to != ClosenessTo::None;
    if is_close {
        offer("Less closeness", json!({ "setWeights": { "close": weights.close / FACTOR } }));
    }
    if weights.smooth > 0.0 {
        offer("Less smoothness", json!({ "setWeights": { "smooth": weights.smooth / FACTOR } }));
    }
    offer(
        "More weight on constraints",
        json!({ "setWeights": { "shape": weights.shape * sufficient_factor(session) } }),
    );
    let handles: Vec<u32> = session.solver().handles().iter().map(|handle| handle.vertex).collect();
    if !handles.is_empty() {
        offer("Remove the handles", json!({ "removeHandles": { "vertices": handles } }));
    }
    if is_close && document.closeness.to == ClosenessTo::Rest {
        offer(
            "Let it slide along the original",
            json!({ "set": { "id": "closeness", "value": "surface" } }),
        );
    }
    let enabled = session.rows().iter().filter(|row| row.enabled).count();
    if let Some((index, _)) = session.scene.worst_row().filter(|_| enabled > 1) {
        let spec = &document.constraints[index];
        let label = format!("More weight on {}", spec.label());
        offer(
            &label,
            json!({ "setConstraint": { "index": index, "weight": spec.weight * FACTOR } }),
        );
    }
    if document.solver.tolerance > 0.0 {
        let value = document.solver.tolerance / 1000.0;
        offer("Iterate longer", json!({ "set": { "id": "tolerance", "value": value } }));
    }
    candidates
}
