//! Geometry that operators may use besides their points: the reference surface, and another pose.

use crate::mesh::Surface;
use std::rc::Rc;

/// A position or a gradient, padded to two 128-bit registers.
pub type Row = [f64; 4];

/// Geometry that an operator may use besides its own points.
#[derive(Clone, Copy)]
pub struct Reference<'a> {
    /// The rest surface, built on demand, in the coordinates of uncentred points.
    pub surface: &'a dyn Fn() -> Rc<Surface>,
    /// The nodes in another pose, used as rest points by kinds with
    /// [`super::Projection::USES_POSE`].
    pub pose: Option<&'a [Row]>,
}
