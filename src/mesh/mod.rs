//! Polygon meshes, curves and tetrahedra: data, files, and computations on them.
//!
//! | file or folder | holds |
//! |---|---|
//! | `polygon_mesh` | positions, faces, curves, tetrahedra, groups |
//! | `file_order` | the order of an OBJ file, so that it is written as it came |
//! | `bounds` | the size of a mesh: what it is made of, its bounding sphere and box, and the limit on coordinates |
//! | `problem` | kinds and counts of the problems that do not stop reading a file |
//! | `diagnostics` | the problems of a mesh as a whole: unused vertices, duplicate faces, non-manifold edges |
//! | `rings` | the outline and the holes of a face that goes around both |
//! | `sides` | the sides of all elements, grouped by edge |
//! | `coincident` | vertices at one place, up to rounding |
//! | `seams` | boundary vertices that lie on others without being joined |
//! | `io` | reading and writing mesh files |
//! | `topology` | edges, neighbours, boundary loops, strips, components, orientation, curves on the mesh |
//! | `laplacian` | the weights `w_ij` of Eq. 12 |
//! | `closest` | closest points `c(v)` on a surface, Eq. 11, and on its boundary curves |
//! | `measure` | planarity, circularity, angles, Gauss curvature, unrolled strips, distortion of flat maps |
//! | `curvature` | principal curvatures, lines of curvature, and the alignment of edges with them |
//! | `edit` | meshes made from meshes: welding, subdivision, editing operations |

mod bounds;
mod closest;
mod coincident;
mod curvature;
mod diagnostics;
mod edit;
mod file_order;
mod io;
mod laplacian;
mod measure;
mod polygon_mesh;
mod problem;
mod rings;
mod seams;
mod sides;
mod topology;

pub use crate::math::Ragged;
pub(crate) use bounds::{Body, at_vertices};
pub use bounds::{BoundingSphere, LARGEST_COORDINATE, diagonal, first_out_of_range};
pub use closest::{
    BoundaryCurve, BoundaryCurves, BoundaryPiece, ClosestPointCache, FaceTriangle, Polyline,
    Surface,
};
pub(crate) use coincident::first_of_group;
pub use curvature::{
    Curvature, CurvatureField, CurvatureLine, CurvatureLines, Family, SurfacePoint, curvatures,
    face_curvatures,
};
pub(crate) use curvature::{Tensor, form_on};
pub use diagnostics::{ElementsWithProblem, diagnose, elements_with_problem};
pub(crate) use edit::around;
pub use edit::{
    Combinations, Edited, KEPT_TURN, MESH_OPERATIONS, MeshOperation, OperationError, Origins,
    Picks, Scheme, Size, SizeError, SizeOf, SubdivideError, SubdividedCounts, Subdivision, Task,
    Weld,
};
pub use file_order::FileOrder;
pub use io::{
    Decimal, FILE_FORMATS, FileFormat, MeshPart, Read, ReadError, read, write_medit, write_obj,
    write_obj_with, write_ply, write_stl, write_with_ending,
};
pub(crate) use io::{decode, lines};
pub use laplacian::{LARGEST_COTANGENT, Laplacian};
pub(crate) use measure::crease_edges;
pub use measure::{
    Circularity, Histogram, MapErrors, Measures, Planarity, QuasiConformal, UnrolledStrip,
    angle_histogram, diagonal_ratio, folded_faces, gauss_curvature, mean_dihedral_angle,
    quasi_conformal, smoothed_area,
};
pub use polygon_mesh::{Group, GroupKeyword, Mesh, Point};
pub use problem::{ElementKind, MeshProblem, ProblemKind, untouched_words};
pub(crate) use rings::{rings_of, sides_of_holes, with_holes};
pub use seams::seams;
pub use topology::{
    Repeated, Topology, components, corners, edge_lines, hinges, orientation, repeated, stars,
    strips,
};
