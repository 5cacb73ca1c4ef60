//! Selectors: the vertices that a constraint acts on, independent of its kind.

use crate::json::indices;
use crate::words::count;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;
use std::rc::Rc;

/// The named sets of a scene.
pub type Sets = BTreeMap<String, Set>;

/// A named set of vertices and faces.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Set {
    /// Indices of vertices.
    #[serde(with = "indices", skip_serializing_if = "<[u32]>::is_empty")]
    pub vertices: Rc<[u32]>,
    /// Indices of faces.
    #[serde(with = "indices", skip_serializing_if = "<[u32]>::is_empty")]
    pub faces: Rc<[u32]>,
}

/// The elements of a mesh that can carry one constraint each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "kebab-case")]
pub enum Element {
    /// The corners of a face.
    Face,
    /// The two ends of an edge.
    Edge,
    /// A vertex and its neighbours.
    Ring,
    /// The corners of a tetrahedron.
    Tet,
    /// A polyline of the file, or a straight edge line of a quad-dominant mesh; if one runs along
    /// another, only the longer.
    Curve,
    /// A polyline of the file.
    Polyline,
    /// A straight edge line of a quad-dominant mesh.
    EdgeLine,
    /// A boundary loop.
    Boundary,
    /// A strip of quads joined across opposite edges, on a quad-dominant mesh.
    Strip,
    /// All vertices of a group.
    Group,
    /// A corner of a face: the vertex before it, itself, the vertex after it.
    Corner,
    /// An interior vertex, then its neighbours around it.
    Star,
    /// An edge between two triangles: its ends, then the corners opposite to it.
    Hinge,
}

/// The vertices that a constraint acts on.
#[derive(Clone, Debug, PartialEq)]
pub enum Selector {
    /// One constraint per element.
    Each {
        /// Which elements.
        element: Element,
        /// Only those in this set or group.
        within: Option<String>,
        /// The rings of neighbours added to each element; a ring itself has radius 1.
        radius: u32,
    },
    /// One constraint of all vertices of a set or group.
    Set(String),
    /// One constraint of these vertices.
    Vertices(Rc<[u32]>),
}

impl Selector {
    /// The set or group that it names, if any.
    pub fn named(&self) -> Option<&str> {
        match self {
            Selector::Each { within, .. } => within.as_deref(),
            Selector::Set(name) => Some(name),
            Selector::Vertices(_) => None,
        }
    }
}

/// For each element, in the order of its declaration: the id in scene files, the word there for one
/// constraint on each of its type, if there is one, and the name on the page.
const ELEMENTS: [(&str, Option<&str>, &str); 13] = [
    ("face", Some("faces"), "face"),
    ("edge", Some("edges"), "edge"),
    ("ring", Some("rings"), "vertex with its neighbours"),
    ("tet", Some("tets"), "tetrahedron"),
    ("curve", Some("curves"), "curve"),
    ("polyline", Some("polylines"), "polyline of the file"),
    ("edge-line", Some("edge-lines"), "straight line of edges"),
    ("boundary", Some("boundary"), "boundary loop"),
    ("strip", Some("strips"), "strip of faces"),
    ("group", None, "group"),
    ("corner", Some("corners"), "corner of a face"),
    ("star", Some("stars"), "inner vertex"),
    ("hinge", Some("hinges"), "edge between two triangles"),
];

impl Element {
    /// All elements, in the order in which hosts list them.
    pub const ALL: [Element; 13] = {
        use Element::*;
        [
            Face, Edge, Ring, Tet, Curve, Polyline, EdgeLine, Boundary, Strip, Group, Corner, Star,
            Hinge,
        ]
    };

    /// The id in scene files.
    pub fn id(self) -> &'static str {
        ELEMENTS[self as usize].0
    }

    /// The word in scene files for one constraint on each element of this type, if there is one.
    pub fn word_for_all(self) -> Option<&'static str> {
        ELEMENTS[self as usize].1
    }

    /// The least radius, which is also the default: a ring has its neighbours.
    pub(crate) fn least_radius(self) -> u32 {
        u32::from(self == Element::Ring)
    }

    /// The name on the page, in the singular.
    pub fn label(self) -> &'static str {
        ELEMENTS[self as usize].2
    }
}

/// Upper bound on the vertices of all elements of one selector, counted once per element. With a
/// radius, their number could reach the square of that of the mesh.
pub(super) const MOST_MEMBERS: usize = 20_000_000;

/// Why a selector cannot be resolved.
#[derive(Clone, Debug, PartialEq)]
pub enum SelectError {
    /// There is no set or group of that name.
    UnknownSet(String),
    /// A vertex index out of range.
    VertexOutOfRange(u32),
    /// A face index out of range.
    FaceOutOfRange(u32),
    /// All constraints together have more vertices than can be solved for.
    TooMany,
}

impl fmt::Display for SelectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SelectError::UnknownSet(name) => {
                write!(f, "`{name}` is neither a set of the scene nor a group of the mesh")
            }
            SelectError::VertexOutOfRange(v) => write!(f, "the mesh has no vertex {v}"),
            SelectError::FaceOutOfRange(face) => write!(f, "the mesh has no face {face}"),
            SelectError::TooMany => write!(
                f,
                "the elements have more than {MOST_MEMBERS} vertices together, expected a smaller radius or fewer elements"
            ),
        }
    }
}

impl std::error::Error for SelectError {}

/// Describes a selector in words: "each face", "each face of eaves", "12 vertices".
pub fn describe(selector: &Selector) -> String {
    match selector {
        Selector::Each { element, within, radius } => {
            let one = match element {
                Element::Ring => "vertex",
                element => element.label(),
            };
            let of = within.as_ref().map(|name| format!(" of {name}")).unwrap_or_default();
            match (element, radius) {
                (_, 0) => format!("each {one}{of}"),
                (Element::Ring, 1) => format!("each {one}{of} with its neighbours"),
                (_, 1) => format!("each {one}{of} with 1 ring of neighbours"),
                (_, radius) => format!("each {one}{of} with {radius} rings of neighbours"),
            }
        }
        Selector::Set(name) => format!("the vertices of {name}"),
        Selector::Vertices(vertices) => count(vertices.len(), "vertex", "vertices"),
    }
}
