//! The part of a solver that depends on the mesh and the pattern of its matrix alone, for the next solver
//! on the same mesh.

use crate::mesh::Surface;
use crate::sparse::SymbolicAnalysis;
use std::cell::OnceCell;
use std::rc::Rc;

/// The rest surface, and the symbolic analysis of the last normal matrix.
#[derive(Clone, Default)]
pub struct SetupCache {
    /// Relative to the centre of the model; made when it is first asked for.
    pub(super) surface: OnceCell<Rc<Surface>>,
    pub(super) analysis: Option<Rc<SymbolicAnalysis>>,
}
