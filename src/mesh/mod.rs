//! Polygon meshes, curves and tetrahedra: what a file holds, and what can be said of it.
//!
//! | file | holds |
//! |---|---|
//! | `ragged` | lists of lists of vertex indices |
//! | `read` | files in, by format: `obj` with `groups`, `off`, `medit` |
//! | `lines`, `stream`, `number`, `draft` | what the formats share: text, rows, numbers, the mesh so far |
//! | `problem`, `survey` | what a file, and a mesh as a whole, has wrong that can be survived |
//! | `obj_write`, `medit_write` | OBJ and Medit out |
//! | `decimal` | numbers as text that reads back to the same bits |
//! | `topology` | edges, neighbours, rings, faces around edges and vertices |
//! | `boundary`, `edge_lines`, `strips`, `components` | boundary loops, straight edge lines, strips of quads, connected components |
//! | `curves` | polylines and edge lines that run along each other |
//! | `feature_curves` | creases: lines along which the surface turns sharply |
//! | `boundary_curves` | the boundary loops as curves to glide on, with corners |
//! | `local` | corners of faces, stars of vertices, hinges |
//! | `laplacian` | the weights `w_ij` of Eq. 12; with its part `polygon_weights` |
//! | `closest` | closest point `c(v)` on the reference surface, Eq. 11; with its parts `footing`, `triangle`, `tree`, `surroundings`, `clearing` |
//! | `measure` | planarity, circularity, diagonal ratio of faces; with its part `face_fit` |
//! | `angle_histogram` | how many corners of faces have which angle |
//! | `quasi_conformal` | how far a flat map is from keeping angles |
//! | `histogram` | how errors are distributed, for legends |
//! | `weld` | vertices at one place made one, where faces have their own |
//! | `bounds` | bounding sphere, and how far out positions may be |

mod angle_histogram;
mod boundary;
mod boundary_curves;
mod bounds;
mod clearing;
mod closest;
mod components;
mod curves;
mod decimal;
mod draft;
mod edge_lines;
mod face_fit;
mod feature_curves;
mod footing;
mod groups;
mod histogram;
mod laplacian;
mod lines;
mod local;
mod measure;
mod medit;
mod medit_write;
mod number;
mod obj;
mod obj_write;
mod off;
mod polygon_weights;
mod problem;
mod quasi_conformal;
mod ragged;
mod read;
mod stream;
mod strips;
mod surroundings;
mod survey;
mod topology;
mod tree;
mod triangle;
mod weld;

pub use angle_histogram::angle_histogram;
pub use boundary_curves::{BoundaryCurve, BoundaryCurves};
pub use bounds::{BoundingSphere, FARTHEST, too_far};
pub use closest::Surface;
pub use components::components;
pub use curves::{Repeated, repeated};
pub use decimal::Decimal;
pub use edge_lines::edge_lines;
pub use feature_curves::feature_curves;
pub use footing::Footing;
pub use histogram::Histogram;
pub use laplacian::{LARGEST_COTANGENT, Laplacian};
pub use local::{corners, hinges, stars};
pub use measure::{Circularity, Measures, Planarity, diagonal_ratio};
pub use medit_write::write_medit;
pub use obj_write::{write_obj, write_obj_with_uv};
pub use problem::{Element, Problem, ProblemKind, counted};
pub use quasi_conformal::{MapErrors, QuasiConformal, quasi_conformal};
pub use ragged::Ragged;
pub use read::{Read, read};
pub use strips::strips;
pub use survey::{Flawed, flawed, survey};
pub use topology::Topology;
pub use weld::Weld;

/// A position in space, in the units of the mesh.
pub type Point = [f64; 3];

/// A polygon mesh with its curves and tetrahedra, as a file gives it. The order of vertices, faces,
/// curves and groups is the file's and never changes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// `#V by 3`, finite.
    pub positions: Vec<Point>,
    /// The corners of each face, at least three, as indices of vertices.
    pub faces: Ragged,
    /// The vertices of each polyline, at least two; a closed one repeats its first vertex at the end.
    pub curves: Ragged,
    /// `#T by 4` indices of vertices.
    pub tets: Vec<[u32; 4]>,
    /// Named sets of faces and curves, which may overlap; none is empty. From a file: by first member.
    pub groups: Vec<Group>,
}

/// A named set of faces and curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The name in the file.
    pub name: String,
    /// Which statement of an OBJ file named it.
    pub keyword: GroupKeyword,
    /// Indices of faces, ascending.
    pub faces: Vec<u32>,
    /// Indices of curves, ascending.
    pub curves: Vec<u32>,
}

/// The statement of an OBJ file that opens a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum GroupKeyword {
    /// `o`
    Object,
    /// `g`
    Group,
    /// `usemtl`
    Material,
}

impl GroupKeyword {
    /// The word of each.
    pub const STATEMENTS: [(&str, GroupKeyword); 3] = [
        ("o", GroupKeyword::Object),
        ("g", GroupKeyword::Group),
        ("usemtl", GroupKeyword::Material),
    ];
}

/// Why a mesh file was refused.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadError {
    /// Name of the file.
    pub file: String,
    /// Line, counted from one; none when the file as a whole is at fault.
    pub line: Option<usize>,
    /// The text of that line, shortened; empty when the file as a whole is at fault.
    pub text: String,
    /// What is wrong and what was expected.
    pub message: String,
}

impl std::fmt::Display for ReadError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.line {
            Some(line) => write!(f, "{}:{line}: `{}`: {}", self.file, self.text, self.message),
            None => write!(f, "{}: {}", self.file, self.message),
        }
    }
}

impl std::error::Error for ReadError {}
