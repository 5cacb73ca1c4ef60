//! The geometry that operators may look up: the reference surface, and another pose.

use crate::mesh::Surface;
use std::rc::Rc;

/// A position or a gradient with a pad, so that a row is two 128-bit registers.
pub type Row = [f64; 4];

/// Geometry that an operator may look up besides its own points.
#[derive(Clone, Copy)]
pub struct Reference<'a> {
    /// The rest surface, made when it is asked for; in the same place as points that are not centred.
    pub surface: &'a dyn Fn() -> Rc<Surface>,
    /// The nodes in another pose: the rest points of the kinds with [`super::Projection::TAKES_POSE`].
    pub pose: Option<&'a [Row]>,
}
