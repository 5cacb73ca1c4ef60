//! Collapse of a shape: iterations, without a drag, that shrink the model to a dot, crush its
//! faces, or carry it away.
//!
//! The shape is compared with the start: the shape at the first iteration after the last edit.

use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{Mesh, Point, Ragged, at_vertices, diagonal};
use crate::solve::Handle;
use std::fmt;
use std::mem::size_of_val;
use std::rc::Rc;

/// Smallest allowed diagonal of the bounding box, relative to that at the start.
const LEAST_DIAGONAL: f64 = 0.5;
/// Largest allowed displacement of a vertex, relative to the size of the start.
const FARTHEST: f64 = 0.25;
/// A face with less than this fraction of its area at the start has lost it.
const LOST: f64 = 0.05;
/// Largest allowed fraction of faces that lose their area. With the settings of a newly opened mesh
/// it is less than one in a hundred, on real meshes with circular panels.
const MOST_LOST: f64 = 0.1;
/// Extra change allowed, relative to the distance of the farthest handle from its target.
const PER_PULL: f64 = 2.0;

/// A collapse of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collapse {
    /// Its kind.
    pub reason: CollapseReason,
    /// Shrunk: the remaining fraction of the diagonal. Area: the fraction of faces that lost their
    /// area. Moved: the largest displacement of a vertex, relative to the size of the start.
    pub amount: f64,
}

/// Written to end a sentence: "the mesh shrank to a dot".
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
    /// The whole mesh has shrunk.
    Shrunk,
    /// Faces have lost their area.
    Area,
    /// Vertices have moved far away.
    Moved,
}

/// A shape at which iterations started.
pub(crate) struct Start {
    /// `#V by 3`.
    positions: Rc<[Point]>,
    iteration: u32,
    diagonal: f64,
    /// The larger of `diagonal` and the diagonal at rest: after an undo the start may be a dot.
    size: f64,
    /// `#F`.
    areas: Vec<f64>,
    /// The largest distance of a handle from its target.
    pull: f64,
}

/// The diagonal of what can move of a shape: faces that are left as they are stay where they are.
fn extent_of(positions: &[Point], mesh: &Mesh) -> f64 {
    match mesh.faces.is_empty() {
        true => diagonal(&mesh.body_of(positions)),
        false => diagonal(&at_vertices(positions, &[mesh.faces.indices()])),
    }
}

impl Start {
    /// Stores the shape `positions` (`#V by 3`) of `rest` after `iteration`, with these handles.
    pub(crate) fn new(
        positions: &Rc<[Point]>,
        iteration: u32,
        handles: &[Handle],
        rest: &Mesh,
    ) -> Start {
        let offsets = handles.iter().map(|handle| {
            Vec3::from(positions[handle.vertex as usize]) - Vec3::from(handle.target)
        });
        let pull = offsets.map(|offset| offset.length_squared()).fold(0.0, f64::max).sqrt();
        let extent = extent_of(positions, rest);
        Start {
            diagonal: extent,
            size: extent.max(extent_of(&rest.positions, rest)),
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

    /// Memory in bytes.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(&*self.positions) + size_of_val(&*self.areas)
    }

    /// Returns how the shape `now`, `#V by 3`, has collapsed since the start, if it has.
    pub(crate) fn collapse(&self, now: &[Point], mesh: &Mesh) -> Option<Collapse> {
        let slack = PER_PULL * self.pull;
        let diagonal = extent_of(now, mesh);
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
        let displacements =
            now.iter().zip(&*self.positions).map(|(&a, &b)| Vec3::from(a) - Vec3::from(b));
        let farthest = displacements.map(|it| it.length_squared()).fold(0.0, f64::max).sqrt();
        (farthest > FARTHEST * self.size + slack)
            .then(|| Collapse { reason: CollapseReason::Moved, amount: farthest / self.size })
    }
}

/// Lengths of the area vectors of the faces, `#F`.
fn areas(positions: &[Point], faces: &Ragged) -> Vec<f64> {
    let at = |&v: &u32| Vec3::from(positions[v as usize]);
    faces.iter().map(|face| 0.5 * twice_vector_area(face.iter().map(at)).length()).collect()
}
