//! The declaration of an operation, and its errors.

use crate::math::marked;
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Touching;
use crate::mesh::edit::size::{Size, SizeError};
use crate::mesh::{Mesh, Point, Topology};
use crate::words;
use serde::Serialize;
use std::fmt;

/// Declaration of an operation on a mesh. Hosts build their controls from it.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct MeshOperation {
    /// Identifier.
    pub id: &'static str,
    /// Name shown to the user.
    pub label: &'static str,
    /// Description in one sentence.
    pub summary: &'static str,
    /// The elements that the user selects for it.
    pub picks: Picks,
    /// Numeric parameters, in the order of [`Task::sizes`].
    pub sizes: &'static [Size],
    #[serde(skip)]
    pub(super) apply: fn(&Task<'_>) -> Result<Edited, OperationError>,
}

/// The elements that an operation acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub enum Picks {
    /// The whole mesh.
    Nothing,
    /// The picked faces, at least one.
    Faces,
    /// The picked vertices, at least one.
    Vertices,
    /// The picked vertices, or all vertices if none are picked.
    AnyVertices,
}

/// The input of an operation.
#[derive(Clone, Copy, Debug)]
pub struct Task<'a> {
    /// The mesh at its current positions.
    pub mesh: &'a Mesh,
    /// `#V by 3`: its rest positions, where what lies on each other is looked for.
    pub rest: &'a [Point],
    /// The topology of the mesh.
    pub topology: &'a Topology,
    /// The direction that points up, a unit vector.
    pub up: Point,
    /// The values of the sizes of the operation; lengths are in the unit of the mesh.
    pub sizes: &'a [f64],
    /// The picked vertices.
    pub vertices: &'a [u32],
    /// The picked faces.
    pub faces: &'a [u32],
}

/// Reason why an operation is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum OperationError {
    /// No operation has this id.
    Unknown(String),
    /// A size is missing or out of range.
    Size(SizeError),
    /// The mesh has tetrahedra, this many.
    Tetrahedra(usize),
    /// The mesh has no faces.
    NoFaces,
    /// The mesh has no boundary.
    NoBoundary,
    /// A picked element does not exist.
    NotThere {
        /// `face` or `vertex`.
        element: &'static str,
        /// Its index.
        index: u32,
    },
    /// The operation requires the described input.
    Expected(&'static str),
    /// This face would touch itself.
    Touching(u32),
    /// This face would touch itself if vertices at this distance were welded.
    TouchingWithin(u32),
    /// More than two faces would meet at an edge of a mesh that has no such edge now.
    Joining,
    /// The result would have no faces.
    NothingLeft,
    /// The result would be the same mesh.
    NoChange,
}

impl fmt::Display for OperationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OperationError::Unknown(id) => write!(f, "there is no operation `{id}`"),
            OperationError::Size(why) => why.fmt(f),
            OperationError::Tetrahedra(count) => write!(
                f,
                "the mesh has {}, expected faces and curves only",
                words::count(*count, "tetrahedron", "tetrahedra")
            ),
            OperationError::NoFaces => f.write_str("the mesh has no faces"),
            OperationError::NoBoundary => f.write_str("the mesh is closed: it has no boundary"),
            OperationError::NotThere { element, index } => {
                write!(f, "there is no {element} {index}")
            }
            OperationError::Expected(what) => write!(f, "this needs {what}"),
            OperationError::Touching(face) => write!(f, "face {face} would touch itself"),
            OperationError::TouchingWithin(face) => {
                write!(f, "{}; try a smaller distance", OperationError::Touching(*face))
            }
            OperationError::Joining => f.write_str(
                "more than two faces would meet at an edge: some faces have several edges in common",
            ),
            OperationError::NothingLeft => f.write_str("no faces would be left"),
            OperationError::NoChange => f.write_str("this would change nothing"),
        }
    }
}

impl std::error::Error for OperationError {}

impl From<Touching> for OperationError {
    fn from(Touching(face): Touching) -> OperationError {
        OperationError::Touching(face)
    }
}

impl MeshOperation {
    /// Applies the operation and returns the new mesh with its origins.
    ///
    /// # Errors
    /// If a size is out of range, or a picked element or the mesh is not suitable.
    pub fn apply(&self, task: &Task<'_>) -> Result<Edited, OperationError> {
        Size::check(self.sizes, task.sizes).map_err(OperationError::Size)?;
        if !task.mesh.tets.is_empty() {
            return Err(OperationError::Tetrahedra(task.mesh.tets.len()));
        }
        if task.mesh.faces.is_empty() {
            return Err(OperationError::NoFaces);
        }
        let check = |element, picked: &[u32], count: usize| match picked
            .iter()
            .find(|&&index| index as usize >= count)
        {
            Some(&index) => Err(OperationError::NotThere { element, index }),
            None => Ok(()),
        };
        check("vertex", task.vertices, task.mesh.positions.len())?;
        check("face", task.faces, task.mesh.faces.len())?;
        match self.picks {
            Picks::Faces if task.faces.is_empty() => {
                return Err(OperationError::Expected("selected faces"));
            }
            Picks::Vertices if task.vertices.is_empty() => {
                return Err(OperationError::Expected("selected vertices"));
            }
            _ => {}
        }
        let edited = (self.apply)(task)?;
        if edited.mesh.faces.is_empty() {
            return Err(OperationError::NothingLeft);
        }
        let (old, new) = (task.mesh, &edited.mesh);
        if (&old.positions, &old.faces, &old.curves) == (&new.positions, &new.faces, &new.curves)
            && new.untouched.is_empty()
        {
            return Err(OperationError::NoChange);
        }
        if is_manifold(task.topology)
            && !merges(&edited)
            && !is_manifold(&Topology::new(&edited.mesh))
        {
            return Err(OperationError::Joining);
        }
        Ok(edited)
    }
}

fn is_manifold(topology: &Topology) -> bool {
    topology.edge_faces().iter().all(|faces| faces.len() <= 2)
}

/// Whether vertices were merged, so that coincident edges are intended.
fn merges(edited: &Edited) -> bool {
    let mut is_taken = vec![false; edited.mesh.positions.len()];
    let mut into = edited.origins.vertices.iter().flatten();
    into.any(|&v| std::mem::replace(&mut is_taken[v as usize], true))
}

impl Task<'_> {
    /// Returns for each vertex whether it is picked; true for all if none are picked.
    pub(super) fn picked_vertices(&self) -> Vec<bool> {
        let mut is_picked = vec![self.vertices.is_empty(); self.mesh.positions.len()];
        self.vertices.iter().for_each(|&v| is_picked[v as usize] = true);
        is_picked
    }

    pub(super) fn picked_faces(&self) -> Vec<bool> {
        marked(self.mesh.faces.len(), self.faces)
    }

    /// The topology with the faces that are left as they are after the others: at those there is no
    /// boundary.
    pub(super) fn whole_topology(&self) -> Topology {
        let faces = self.mesh.all_faces().collect();
        Topology::new(&Mesh { faces, ..self.mesh.clone() })
    }

    pub(super) fn all_faces(&self) -> std::ops::Range<u32> {
        0..self.mesh.faces.len() as u32
    }
}
