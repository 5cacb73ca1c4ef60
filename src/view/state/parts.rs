//! Small parts of a view: handles, switches, and flags of changes since the last picture.

use crate::view::appearance::DotKind;
use glam::DVec3;

/// Numbers per fitted shape: kind (0 circle, 1 sphere), centre, normal, radius.
pub const SHAPE_NUMBERS: usize = 8;

/// A handle: a vertex that is held softly or exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandleMark {
    /// The vertex.
    pub vertex: u32,
    /// [`DotKind::Handle`], [`DotKind::Fixed`] or [`DotKind::Active`].
    pub kind: DotKind,
    /// The target position, in file coordinates.
    pub target: DVec3,
}

/// The parts of the view that are switched on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Display {
    /// Edges of the polygons.
    pub edges: bool,
    /// A dot on every vertex.
    pub vertices: bool,
    /// Fitted circles and spheres.
    pub shapes: bool,
    /// Outlines of projected shapes.
    pub outlines: bool,
    /// Arrows from vertices to their projections.
    pub arrows: bool,
}

/// Flags of what has changed since the last picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changes {
    /// Faces, curves, edges.
    pub mesh: bool,
    /// Vertex positions.
    pub positions: bool,
    /// Handle targets.
    pub targets: bool,
    /// Values and marks of faces.
    pub appearance: bool,
    /// The sets of dots and pull lines.
    pub marks: bool,
    /// Fitted shapes.
    pub shapes: bool,
    /// The projections.
    pub projections: bool,
    /// Texture coordinates of the checkerboard.
    pub checks: bool,
    /// Camera, theme, size, display: all that needs a new picture but no new data.
    pub view: bool,
}

impl Changes {
    /// Everything.
    pub const ALL: Changes = Changes {
        mesh: true,
        positions: true,
        targets: true,
        appearance: true,
        marks: true,
        shapes: true,
        projections: true,
        checks: true,
        view: true,
    };

    /// Returns whether anything has changed.
    pub fn any(self) -> bool {
        self != Changes::default()
    }
}
