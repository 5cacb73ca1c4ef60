//! The reference surface, for operators that ask for it.

use crate::mesh::Surface;
use std::rc::Rc;

/// Geometry that an operator may look up besides its own points.
#[derive(Clone, Copy)]
pub struct Reference<'a> {
    /// The rest surface, made when it is asked for; in the same place as points that are not centred.
    pub surface: &'a dyn Fn() -> Rc<Surface>,
}
