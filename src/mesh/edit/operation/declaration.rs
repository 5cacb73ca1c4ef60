//! The declaration of an operation, and its errors.

use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Touching;
use crate::mesh::edit::size::{Size, SizeError};
use crate::mesh::{Mesh, Point, Topology, counted};
use serde::Serialize;
use std::fmt;

/// An operation on a mesh. Hosts build their controls from it.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct MeshOperation {
    /// The word for it.
    pub id: &'static str,
    /// Its name.
    pub label: &'static str,
    /// One sentence.
    pub summary: &'static str,
    /// The elements to select for it.
    pub picks: Picks,
    /// The numbers that it takes, in the order of [`Task::sizes`].
    pub sizes: &'static [Size],
    #[serde(skip)]
    pub(super) apply: fn(&Task<'_>) -> Result<Edited, OperationError>,
}

/// The elements that an operation takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub enum Picks {
    /// It is for the whole mesh.
    Nothing,
    /// Some faces.
    Faces,
    /// Some vertices.
    Vertices,
    /// Some vertices, or all of them where none are picked.
    AnyVertices,
}

/// The input of an operation.
#[derive(Clone, Copy, Debug)]
pub struct Task<'a> {
    /// The mesh as it is seen.
    pub mesh: &'a Mesh,
    /// That of the mesh.
    pub topology: &'a Topology,
    /// The direction that points up, a unit vector.
    pub up: Point,
    /// Of each size of the operation its value.
    pub sizes: &'a [f64],
    /// The vertices that are picked.
    pub vertices: &'a [u32],
    /// The faces that are picked.
    pub faces: &'a [u32],
}

/// Why an operation is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum OperationError {
    /// There is none of that name.
    Unknown(String),
    /// A size is missing, or out of its limits.
    Size(SizeError),
    /// The mesh has so many tetrahedra.
    Tetrahedra(usize),
    /// The mesh has no faces.
    NoFaces,
    /// Something that is picked is not there.
    NotThere {
        /// `face` or `vertex`.
        element: &'static str,
        /// Its index.
        index: u32,
    },
    /// It needs something else.
    Expected(&'static str),
    /// This face would touch itself.
    Touching(u32),
    /// More than two faces would meet at an edge, and none did.
    Joining,
    /// Nothing of the mesh would be left.
    NothingLeft,
}

impl fmt::Display for OperationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OperationError::Unknown(id) => write!(f, "there is no operation `{id}`"),
            OperationError::Size(why) => why.fmt(f),
            OperationError::Tetrahedra(count) => write!(
                f,
                "the mesh has {}, expected faces and curves only",
                counted(*count, "tetrahedron", "tetrahedra")
            ),
            OperationError::NoFaces => f.write_str("the mesh has no faces"),
            OperationError::NotThere { element, index } => {
                write!(f, "there is no {element} {index}")
            }
            OperationError::Expected(what) => write!(f, "expected {what}"),
            OperationError::Touching(face) => {
                write!(f, "face {face} would touch itself; a smaller distance may do")
            }
            OperationError::Joining => f.write_str(
                "more than two faces would meet at an edge: some faces have several edges in common",
            ),
            OperationError::NothingLeft => f.write_str("nothing of the mesh would be left"),
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
    /// The mesh that it makes.
    ///
    /// # Errors
    /// When a size is out of its limits, what is picked is not there or does not fit, or the mesh is not one for it.
    pub fn apply(&self, task: &Task<'_>) -> Result<Edited, OperationError> {
        Size::check(self.sizes, task.sizes).map_err(OperationError::Size)?;
        if !task.mesh.tets.is_empty() {
            return Err(OperationError::Tetrahedra(task.mesh.tets.len()));
        }
        if task.mesh.faces.is_empty() {
            return Err(OperationError::NoFaces);
        }
        let there = |element, picked: &[u32], count: usize| match picked
            .iter()
            .find(|&&index| index as usize >= count)
        {
            Some(&index) => Err(OperationError::NotThere { element, index }),
            None => Ok(()),
        };
        there("vertex", task.vertices, task.mesh.positions.len())?;
        there("face", task.faces, task.mesh.faces.len())?;
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
        if is_manifold(task.topology)
            && !merges(&edited)
            && !is_manifold(&Topology::new(&edited.mesh))
        {
            return Err(OperationError::Joining);
        }
        Ok(edited)
    }
}

/// Whether at most two faces meet at every edge.
fn is_manifold(topology: &Topology) -> bool {
    topology.edge_faces().iter().all(|faces| faces.len() <= 2)
}

/// Whether vertices become one: where that is wanted, so are the edges that become one by it.
fn merges(edited: &Edited) -> bool {
    let mut is_taken = vec![false; edited.mesh.positions.len()];
    let mut into = edited.origins.vertices.iter().flatten();
    into.any(|&v| std::mem::replace(&mut is_taken[v as usize], true))
}

impl Task<'_> {
    /// Of each vertex whether it is picked; where none are, of all of them.
    pub(super) fn picked_vertices(&self) -> Vec<bool> {
        let mut is_picked = vec![self.vertices.is_empty(); self.mesh.positions.len()];
        self.vertices.iter().for_each(|&v| is_picked[v as usize] = true);
        is_picked
    }

    /// Of each face whether it is picked.
    pub(super) fn picked_faces(&self) -> Vec<bool> {
        let mut is_picked = vec![false; self.mesh.faces.len()];
        self.faces.iter().for_each(|&face| is_picked[face as usize] = true);
        is_picked
    }

    /// All faces.
    pub(super) fn all_faces(&self) -> std::ops::Range<u32> {
        0..self.mesh.faces.len() as u32
    }
}
