//! The collapse of a shape: iterations that, without anybody dragging, shrink the model to a dot, crush
//! its faces, or carry it away.
//!
//! A shape is compared with that at the start: where somebody last changed something and iterating began.

use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{Mesh, Point, Ragged};
use crate::solve::Handle;
use std::fmt;
use std::mem::size_of_val;
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

/// A collapse of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collapse {
    /// Its kind.
    pub reason: CollapseReason,
    /// Shrunk: the part of the diagonal that is left. Area: the part of the faces that lost theirs. Moved:
    /// the largest displacement of a vertex, as a part of the diagonal.
    pub amount: f64,
}

/// As the end of a sentence: "the mesh shrank to a dot".
impl fmt::Display for Collapse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = (100.0 * self.amount).round();
        match self.reason {
            CollapseReason::Shrunk if self.amount < 0.01 => f.write_str("the mesh shrank to a dot"),
            CollapseReason::Shrunk => write!(f, "the mesh shrank to {percent} % of its size"),
            CollapseReason::Area => write!(f, "{percent} % of the faces lost their area"),
            CollapseReason::Moved => {
                write!(f, "vertices moved by up to {percent} % of the size of the mesh")
            }
        }
    }
}

/// The kind of a collapse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CollapseReason {
    /// The whole has shrunk.
    Shrunk,
    /// Faces have lost their area.
    Area,
    /// Vertices have moved far away.
    Moved,
}

/// A shape from which iterations started.
pub(crate) struct Start {
    /// `#V by 3`.
    positions: Rc<[Point]>,
    iteration: u32,
    diagonal: f64,
    /// The greater one of `diagonal` and the diagonal at rest: after an undo it may start from a dot.
    size: f64,
    /// `#F`.
    areas: Vec<f64>,
    /// The largest distance of a handle from its target.
    pull: f64,
}

impl Start {
    /// The shape `positions` (`#V by 3`) of `rest` after `iteration`, with these handles.
    pub(crate) fn new(
        positions: &Rc<[Point]>,
        iteration: u32,
        handles: &[Handle],
        rest: &Mesh,
    ) -> Start {
        let ways = handles.iter().map(|handle| {
            Vec3::from(positions[handle.vertex as usize]) - Vec3::from(handle.target)
        });
        let pull = ways.map(|way| way.length_squared()).fold(0.0, f64::max).sqrt();
        let extent = diagonal(positions, &rest.faces);
        Start {
            diagonal: extent,
            size: extent.max(diagonal(&rest.positions, &rest.faces)),
            areas: areas(positions, &rest.faces),
            pull,
            iteration,
            positions: Rc::clone(positions),
        }
    }

    /// `#V by 3`.
    pub(crate) fn positions(&self) -> &Rc<[Point]> {
        &self.positions
    }

    pub(crate) fn iteration(&self) -> u32 {
        self.iteration
    }

    /// The bytes that it holds.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(&*self.positions) + size_of_val(&*self.areas)
    }

    /// How the shape `now`, `#V by 3`, has collapsed since.
    pub(crate) fn collapse(&self, now: &[Point], mesh: &Mesh) -> Option<Collapse> {
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
        let ways = now.iter().zip(&*self.positions).map(|(&a, &b)| Vec3::from(a) - Vec3::from(b));
        let farthest = ways.map(|way| way.length_squared()).fold(0.0, f64::max).sqrt();
        (farthest > FARTHEST * self.size + slack)
            .then(|| Collapse { reason: CollapseReason::Moved, amount: farthest / self.size })
    }
}

/// The diagonal of the bounding box of the vertices of faces; of all vertices where there are no faces.
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

/// The lengths of the area vectors of faces, `#F`.
fn areas(positions: &[Point], faces: &Ragged) -> Vec<f64> {
    let at = |&v: &u32| Vec3::from(positions[v as usize]);
    faces.iter().map(|face| 0.5 * twice_vector_area(face.iter().map(at)).length()).collect()
}
