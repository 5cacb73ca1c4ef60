//! Selectors: which vertices a constraint acts on, orthogonal to its kind.

use std::collections::BTreeMap;

/// The named sets of a scene.
pub type Sets = BTreeMap<String, Set>;

/// A named set of vertices and faces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Set {
    /// Indices of vertices.
    pub vertices: Vec<u32>,
    /// Indices of faces.
    pub faces: Vec<u32>,
}

/// The elements of a mesh that can carry one constraint each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// The corners of a face.
    Face,
    /// The two ends of an edge.
    Edge,
    /// A vertex and its neighbours.
    Ring,
    /// The corners of a tetrahedron.
    Tet,
    /// A polyline of the file, or a straight edge line of a quad-dominant mesh.
    Curve,
    /// A boundary loop.
    Boundary,
    /// All vertices of a group.
    Group,
}

/// Which vertices a constraint acts on (design section 5).
#[derive(Clone, Debug, PartialEq)]
pub enum Selector {
    /// One constraint per element.
    Each {
        /// Which elements.
        element: Element,
        /// Only those in this set or group.
        within: Option<String>,
        /// Enlarge each element by this many rings of neighbours; a ring itself has radius 1.
        radius: u32,
    },
    /// One constraint of all vertices of a set or group.
    Set(String),
    /// One constraint of these vertices.
    Vertices(Vec<u32>),
}

/// Why a selector selects nothing.
#[derive(Clone, Debug, PartialEq)]
pub enum SelectError {
    /// There is no set or group of that name.
    UnknownSet(String),
    /// A vertex that the mesh does not have.
    VertexOutOfRange(u32),
}
