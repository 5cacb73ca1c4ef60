//! The part of a solver that depends only on the mesh and the pattern of its matrix, for the next
//! solver on the same mesh.

use super::local_frame::rest_surface;
use crate::mesh::{Mesh, Point, Surface};
use crate::sparse::SymbolicAnalysis;
use std::cell::OnceCell;
use std::rc::Rc;

/// The rest surface, and the symbolic analysis of the last normal matrix.
#[derive(Clone, Default)]
pub struct SetupCache {
    /// Relative to the centre of the model; computed on first use.
    pub(super) surface: OnceCell<Rc<Surface>>,
    pub(super) analysis: Option<Rc<SymbolicAnalysis>>,
    /// The target surface of closeness with its mesh, relative to the same centre.
    pub(super) target: Option<(Rc<Mesh>, Rc<Surface>)>,
}

impl SetupCache {
    /// Returns the surface of `target`, computed unless the previous solver had the same target.
    pub(super) fn surface_of(&mut self, target: &Rc<Mesh>, centre: Point) -> Rc<Surface> {
        let known = self.target.take().filter(|(mesh, _)| Rc::ptr_eq(mesh, target));
        let (mesh, surface) =
            known.unwrap_or_else(|| (Rc::clone(target), Rc::new(rest_surface(target, centre))));
        self.target = Some((mesh, Rc::clone(&surface)));
        surface
    }
}
