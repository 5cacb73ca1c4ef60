//! The guard against collapse: iterations that, without anybody dragging, shrink the model to a dot,
//! crush its faces, or carry it away.
//!
//! A shape is compared with that at the start: where somebody last changed something and iterating
//! began. A scene is solved as its author meant it, whatever becomes of it, until somebody edits what
//! is asked of it.

use super::Session;
use super::transition::same_problem;
use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{Mesh, Point, Ragged};
use crate::scene::{ClosenessTo, Scene};
use serde::Serialize;
use std::rc::Rc;

/// The least diagonal of the bounding box, as a part of that at the start.
const LEAST_DIAGONAL: f64 = 0.5;
/// The farthest that a vertex may go, as a part of the diagonal at the start.
const FARTHEST: f64 = 0.25;
/// A face that has less than this part of its area at the start has lost it.
const LOST: f64 = 0.05;
/// So many of the faces may lose their area: with the settings of a mesh that is opened less than one
/// in a hundred does, on real meshes with circular panels.
const MOST_LOST: f64 = 0.1;
/// Handles that are away from their targets pull: the shape may change by so many times their way more.
const PER_PULL: f64 = 2.0;
/// How many iterations go by between two looks.
const EVERY: u32 = 8;

/// What has become of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Collapse {
    /// In which way.
    pub reason: CollapseReason,
    /// Of the diagonal what is left, or the part of the faces that lost their area, or the farthest way
    /// of a vertex as a part of the diagonal.
    pub amount: f64,
}

/// In which way a shape collapsed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum CollapseReason {
    /// The whole has shrunk.
    Shrunk,
    /// Faces have lost their area.
    Area,
    /// Vertices have moved far away.
    Moved,
}

/// The guard of a session.
pub(super) struct Guard {
    /// The document as it was opened, without handles and positions.
    opened: Scene,
    /// The document asks for something else than the one that was opened.
    armed: bool,
    /// The run goes on whatever happens.
    pub(super) goes_on: bool,
    /// Where iterating began; none before the first iteration.
    pub(super) start: Option<Rc<Start>>,
    collapse: Option<Collapse>,
    /// Iterations since the last look.
    unseen: u32,
}

impl Guard {
    /// That of a session on the document `opened`.
    pub(super) fn new(opened: Scene) -> Guard {
        let (armed, goes_on, start, collapse, unseen) = (false, false, None, None, 0);
        Guard { opened, armed, goes_on, start, collapse, unseen }
    }
}

/// A shape from which iterations started.
pub(super) struct Start {
    /// `#V by 3`.
    pub(super) positions: Vec<Point>,
    pub(super) iteration: u32,
    diagonal: f64,
    /// The same, or that at rest where it is greater: after an undo it may start from a dot.
    size: f64,
    /// `#F`.
    areas: Vec<f64>,
    /// The largest distance of a handle from its target.
    pull: f64,
}

impl Start {
    /// How the shape `now`, `#V by 3`, has collapsed since.
    fn collapse(&self, now: &[Point], mesh: &Mesh) -> Option<Collapse> {
        let slack = PER_PULL * self.pull;
        let diagonal = diagonal(now, &mesh.faces);
        if diagonal + slack < LEAST_DIAGONAL * self.diagonal {
            let amount = diagonal / self.diagonal;
            return Some(Collapse { reason: CollapseReason::Shrunk, amount });
        }
        let areas = areas(now, &mesh.faces);
        let lost = areas.iter().zip(&self.areas).filter(|(now, before)| **now < LOST * **before);
        let lost = lost.count() as f64 / areas.len().max(1) as f64;
        if lost > MOST_LOST && self.pull == 0.0 {
            return Some(Collapse { reason: CollapseReason::Area, amount: lost });
        }
        let ways = now.iter().zip(&self.positions).map(|(&a, &b)| Vec3::from(a) - Vec3::from(b));
        let farthest = ways.map(|way| way.length_squared()).fold(0.0, f64::max).sqrt();
        (farthest > FARTHEST * self.size + slack)
            .then(|| Collapse { reason: CollapseReason::Moved, amount: farthest / self.size })
    }
}

impl Session {
    /// How the shape has collapsed since iterating began, if it has.
    pub fn collapse(&self) -> Option<Collapse> {
        self.past.guard.collapse
    }

    /// Whether the last iteration changed the total by no more than the tolerance; never of a shape
    /// that has collapsed.
    pub fn converged(&self) -> bool {
        self.solver.converged() && self.collapse().is_none()
    }

    /// Before an iteration.
    pub(super) fn take_start(&mut self) {
        let guard = &self.past.guard;
        if guard.start.is_some() || !guard.armed || self.is_dragging() {
            return;
        }
        let positions = self.positions();
        let handles = self.solver.handles().iter();
        let ways = handles.map(|handle| {
            Vec3::from(positions[handle.vertex as usize]) - Vec3::from(handle.target)
        });
        let pull = ways.map(|way| way.length_squared()).fold(0.0, f64::max).sqrt();
        let extent = diagonal(&positions, &self.mesh.faces);
        let start = Start {
            diagonal: extent,
            size: extent.max(diagonal(&self.mesh.positions, &self.mesh.faces)),
            areas: areas(&positions, &self.mesh.faces),
            pull,
            iteration: self.past.iteration,
            positions,
        };
        let guard = &mut self.past.guard;
        guard.start = Some(Rc::new(start));
        guard.unseen = 0;
    }

    /// After an iteration: whether it has collapsed now and the run shall end.
    pub(super) fn watch(&mut self) -> bool {
        let guard = &mut self.past.guard;
        guard.unseen += 1;
        if guard.unseen < EVERY && !self.solver.converged() {
            return false;
        }
        let before = guard.collapse;
        self.look();
        let guard = &self.past.guard;
        before.is_none() && guard.collapse.is_some() && !guard.goes_on
    }

    /// Compares the shape with that at the start.
    pub(super) fn look(&mut self) {
        let start = self.past.guard.start.clone().filter(|_| !self.is_dragging());
        let collapse = start.and_then(|start| start.collapse(&self.positions(), &self.mesh));
        self.past.guard.collapse = collapse;
        self.past.guard.unseen = 0;
    }

    /// After the document or the shape was replaced: iterations started from `start`.
    pub(super) fn start_from(&mut self, start: Option<Rc<Start>>) {
        self.past.guard.armed = !same_problem(&self.document, &self.past.guard.opened);
        self.past.guard.start = start;
        self.look();
    }
}

/// Holds every vertex closer to where it was at rest: at first as a mesh that is opened, and from then on
/// ten times as much. On the surface alone it may still shrink to a dot.
pub(super) fn hold_closer(document: &mut Scene) {
    let close = document.weights.close;
    if close > 0.0 && document.closeness.to == ClosenessTo::Rest {
        document.weights.close = 10.0 * close;
    } else {
        document.keep_whole();
    }
}

/// Of the bounding box of the vertices of faces; of all vertices where there are no faces.
fn diagonal(positions: &[Point], faces: &Ragged) -> f64 {
    let [mut low, mut high] = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    let mut enclose = |point: Point| {
        for axis in 0..3 {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    };
    if faces.is_empty() {
        positions.iter().for_each(|&point| enclose(point));
    } else {
        faces.indices().iter().for_each(|&v| enclose(positions[v as usize]));
    }
    (Vec3::from(high) - Vec3::from(low)).length()
}

/// The lengths of the area vectors of faces: `#F`.
fn areas(positions: &[Point], faces: &Ragged) -> Vec<f64> {
    let at = |&v: &u32| Vec3::from(positions[v as usize]);
    faces.iter().map(|face| 0.5 * twice_vector_area(face.iter().map(at)).length()).collect()
}
