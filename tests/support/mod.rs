//! What the tests of several rooms share.

pub(crate) mod degenerate;
pub(crate) mod fuzz;
pub(crate) mod grid;
pub(crate) mod hard;
pub(crate) mod meshes;
pub(crate) mod minimise;
pub(crate) mod project;
pub(crate) mod random;
pub(crate) mod shapes;
pub(crate) mod shared;
pub(crate) mod sources;
pub(crate) mod time;

use shape_up::mesh::Point;
use shape_up::session::{DragPhase, Error, Session};

/// Moves handles to targets in the drag under way.
pub(crate) fn drag(
    session: &mut Session,
    targets: impl IntoIterator<Item = (u32, Point)>,
) -> Result<(), Error> {
    let (vertices, targets): (Vec<u32>, Vec<Point>) = targets.into_iter().unzip();
    assert!(session.is_dragging(), "a drag has begun");
    session.drag_through(DragPhase::Move, &vertices, &targets)
}

/// `all` in `npm run test:long`, else `some` of them, which take seconds.
pub(crate) fn long_or<T>(all: T, some: T) -> T {
    if std::env::var_os("LONG").is_some() { all } else { some }
}
