//! Edits to offer where a run has ended and constraints are not met. Each is tried on a copy of the session,
//! so that only edits that lower the worst distance are offered.

use crate::error::Error;
use crate::mesh::BoundingSphere;
use crate::scene::ClosenessTo;
use crate::session::Session;
use crate::session::edit::Edit;
use serde::Serialize;
use serde_json::{Value, json};

/// A change is tried for at most so many iterations.
const ITERATIONS: u32 = 200;
/// To be offered, it has to bring the worst distance below this part of what it was.
const HELPS: f64 = 0.9;
/// A change that moves a vertex by more than this part of the size of the mesh is not offered.
const FAR: f64 = 0.25;
/// By which weights are lowered and raised.
const FACTOR: f64 = 10.0;
/// By which the weight of the constraints is raised at most.
const MOST_FACTOR: f64 = 1000.0;

/// A change that lowers the worst distance.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Remedy {
    /// The change, in words.
    pub label: String,
    /// The edit, as [`Edit::from_json`] reads it.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "any"))]
    pub edit: Value,
    /// The worst distance of a vertex to its projection when it was tried, in the unit of the mesh.
    pub worst: f64,
}

/// The trials, one iteration after the other.
pub struct Remedies {
    /// The copy on which changes are tried.
    session: Session,
    before: f64,
    /// Not tried yet, the last one first.
    untried: Vec<(String, Value)>,
    current: Option<Trial>,
    found: Vec<Remedy>,
}

struct Trial {
    label: String,
    edit: Value,
    iterations: u32,
}

impl Remedies {
    /// Of a session whose run has ended.
    ///
    /// # Errors
    /// As [`Session::open`]; what could be solved before can be solved again.
    pub fn new(session: &Session) -> Result<Remedies, Error> {
        let mut untried = candidates(session);
        untried.reverse();
        let copy = Session::open(session.scene(), session.mesh().clone())?;
        let before = session.worst_distance();
        Ok(Remedies { session: copy, before, untried, current: None, found: Vec::new() })
    }

    /// Goes on by one iteration; whether there is more to try.
    ///
    /// # Errors
    /// As [`Session::undo`].
    pub fn step(&mut self) -> Result<bool, Error> {
        let Some(trial) = &mut self.current else {
            return self.begin_next();
        };
        trial.iterations += 1;
        // A change that leads out of the finite numbers is no help.
        let ended = self.session.step().map_or(true, |step| step.converged);
        if ended || trial.iterations >= ITERATIONS {
            self.end_current()?;
        }
        Ok(self.current.is_some() || !self.untried.is_empty())
    }

    /// The remedies found so far, the most effective first.
    pub fn found(&self) -> &[Remedy] {
        &self.found
    }

    fn begin_next(&mut self) -> Result<bool, Error> {
        let Some((label, edit)) = self.untried.pop() else { return Ok(false) };
        let read = Edit::from_json(&edit.to_string(), self.session.document())?;
        // What cannot be done, as when nothing would hold the mesh, is no help.
        if self.session.edit(read).is_ok() {
            self.current = Some(Trial { label, edit, iterations: 0 });
        }
        Ok(true)
    }

    fn end_current(&mut self) -> Result<(), Error> {
        let Some(Trial { label, edit, .. }) = self.current.take() else { return Ok(()) };
        let worst = self.session.worst_distance();
        if worst < HELPS * self.before && self.session.moved().max < self.far() {
            let place = self.found.partition_point(|other| other.worst <= worst);
            self.found.insert(place, Remedy { label, edit, worst });
        }
        self.session.undo()?;
        Ok(())
    }

    fn far(&self) -> f64 {
        FAR * BoundingSphere::of(&self.session.mesh().positions).diameter()
    }
}

/// By how much the weight of the constraints has to be raised for all to be within the tolerance of the mesh:
/// a power of ten. Distances fall like one over the weight.
fn enough(session: &Session) -> f64 {
    let mut factor = FACTOR;
    while factor < MOST_FACTOR && session.worst_distance() > factor * session.tolerance() {
        factor *= FACTOR;
    }
    factor
}

/// The candidate remedies, in the order in which they are tried.
fn candidates(session: &Session) -> Vec<(String, Value)> {
    let document = session.document();
    let weights = document.weights;
    let mut candidates = Vec::new();
    let mut offer = |label: &str, edit: Value| candidates.push((label.to_owned(), edit));
    let is_close = weights.close > 0.0 && document.closeness.to != ClosenessTo::None;
    if is_close {
        offer(
            "Weigh closeness less",
            json!({ "type": "setWeights", "close": weights.close / FACTOR }),
        );
    }
    if weights.smooth > 0.0 {
        offer("Smooth less", json!({ "type": "setWeights", "smooth": weights.smooth / FACTOR }));
    }
    offer(
        "Weigh constraints more",
        json!({ "type": "setWeights", "shape": weights.shape * enough(session) }),
    );
    let handles: Vec<u32> = session.solver().handles().iter().map(|handle| handle.vertex).collect();
    if !handles.is_empty() {
        offer("Release the handles", json!({ "type": "removeHandles", "vertices": handles }));
    }
    if is_close && document.closeness.to == ClosenessTo::Rest {
        offer(
            "Let it slide along the original",
            json!({ "type": "set", "id": "closeness", "value": "surface" }),
        );
    }
    let enabled = session.rows().iter().filter(|row| row.enabled).count();
    let rows = (0..).zip(session.rows()).filter(|(_, row)| row.enabled);
    let worst = rows
        .zip(session.solver().found())
        .max_by(|(_, a), (_, b)| a.worst_squared.total_cmp(&b.worst_squared));
    if let Some(((index, _), _)) = worst.filter(|_| enabled > 1) {
        let spec = &document.constraints[index];
        let label = format!("Weigh {} more", spec.label());
        offer(
            &label,
            json!({ "type": "setConstraint", "index": index, "weight": spec.weight * FACTOR }),
        );
    }
    if document.solver.tolerance > 0.0 {
        let value = document.solver.tolerance / 1000.0;
        offer("Iterate longer", json!({ "type": "set", "id": "tolerance", "value": value }));
    }
    candidates
}
