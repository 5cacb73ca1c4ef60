//! What was measured of the current shape. As long as the shape stays, it is not measured again: a frame,
//! a colour and a list ask for the same numbers.

use crate::mesh::{Measures, Point};
use std::rc::Rc;

/// The measures of one shape, and the closest triangles as a start for the next one.
#[derive(Default)]
pub(crate) struct Measured {
    /// The shape, `#V by 3`.
    pub(in crate::session) positions: Vec<Point>,
    pub(in crate::session) measures: Option<Rc<Measures>>,
    /// Those that were taken last, of this shape or one before, and when, in seconds.
    pub(in crate::session) recent: Option<(Rc<Measures>, f64)>,
    /// `#V`
    pub(in crate::session) surface_distances: Option<Rc<[f64]>>,
    /// The triangle of the original that was closest to each vertex last, `#V`; none before the first search.
    pub(in crate::session) closest: Vec<u32>,
}

impl Measured {
    /// Forgets what was measured of another shape.
    pub(in crate::session) fn of(&mut self, positions: Vec<Point>) {
        if self.positions != positions {
            *self = Measured {
                positions,
                closest: std::mem::take(&mut self.closest),
                recent: self.recent.take(),
                ..Measured::default()
            };
        }
    }
}
