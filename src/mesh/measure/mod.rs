//! Measures of a mesh: planarity and circularity of its faces (paper Fig. 5), from the distances of
//! their corners to the least-squares plane and to the circle fitted in it (section 3.1); angles,
//! distortion of flat maps, and histograms.

mod area;
mod developable;
mod dihedral;
mod histogram;
mod quasi_conformal;

pub use area::smoothed_area;
pub use developable::{UnrolledStrip, gauss_curvature};
pub(crate) use dihedral::crease_edges;
pub use dihedral::{folded_faces, mean_dihedral_angle};
pub use histogram::{Histogram, angle_histogram};
pub use quasi_conformal::{MapErrors, QuasiConformal, quasi_conformal};

use crate::math::{CircleFit, PrincipalRound, Vec3, centre};
use crate::mesh::{Point, Ragged};
use serde::Serialize;

/// Planarity of the faces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Planarity {
    /// The largest distance of a vertex to the least-squares plane of its face, units of the mesh.
    pub max_distance: f64,
    /// The mean over faces of the largest distance of their vertices.
    pub mean_distance: f64,
    /// The largest `e_p` of a face, in the scale of [`Measures::new`]: the mean squared distance of its
    /// vertices to the plane.
    pub e_p_max: f64,
    /// The mean `e_p`.
    pub e_p_mean: f64,
    /// The largest ratio of the distance between the diagonals of a quad to their mean length; 0
    /// without quads.
    pub diagonal_ratio_max: f64,
}

/// Circularity of the faces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Circularity {
    /// The largest distance of a vertex to the fitted circle of its face, units of the mesh.
    pub max_distance: f64,
    /// The mean over faces of the largest distance of their vertices.
    pub mean_distance: f64,
    /// The largest `e_c` of a face, in the scale of [`Measures::new`]: the mean squared distance of its
    /// vertices to the circle of Thomas and Chan in their least-squares plane. It is more than
    /// their share of `E_shape` (Eq. 4), which moves the circle so that the closest points have the
    /// same mean as the vertices.
    pub e_c_max: f64,
    /// The mean `e_c`.
    pub e_c_mean: f64,
}

/// The errors of all faces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measures {
    /// Over all faces; zeros without faces.
    pub planarity: Planarity,
    /// Over all faces; zeros without faces.
    pub circularity: Circularity,
    /// Largest distance of the vertices of each face to their plane, `#F`, units of the mesh.
    pub planarity_distances: Vec<f64>,
    /// Largest distance of the vertices of each face to their circle, `#F`, units of the mesh.
    pub circularity_distances: Vec<f64>,
    /// `e_p` of each face, `#F`.
    pub e_p: Vec<f64>,
    /// `e_c` of each face, `#F`.
    pub e_c: Vec<f64>,
}

impl Measures {
    /// Measures `faces` at `positions` (`#V by 3`). `e_p` and `e_c` are those in the scale where `diameter` is
    /// 1; if it is 0, so are they. For reports it is the [size](crate::mesh::Mesh::size) of the rest mesh: the
    /// diameter of the bounding sphere of its faces, without curves, tetrahedra and vertices beside them.
    pub fn new(positions: &[Point], faces: &Ragged, diameter: f64) -> Measures {
        let mut all = Measures::default();
        let squares_scale = if diameter > 0.0 { 1.0 / diameter / diameter } else { 0.0 };
        let share = if faces.is_empty() { 0.0 } else { 1.0 / faces.len() as f64 };
        let mut corners = Vec::new();
        let (planarity, circularity) = (&mut all.planarity, &mut all.circularity);
        for face in faces.iter() {
            corners.clear();
            corners.extend(face.iter().map(|&v| Vec3::from(positions[v as usize])));
            let [[plane, e_p], [circle, e_c]] = face_errors(&mut corners);
            let (distance, e_p) = (plane.sqrt(), squares_scale * e_p);
            all.planarity_distances.push(distance);
            planarity.max_distance = greater(planarity.max_distance, distance);
            planarity.mean_distance += share * distance;
            all.e_p.push(e_p);
            planarity.e_p_max = greater(planarity.e_p_max, e_p);
            planarity.e_p_mean += share * e_p;
            if let &[a, b, c, d] = face {
                let ratio = diagonal_ratio([a, b, c, d].map(|v| positions[v as usize]));
                planarity.diagonal_ratio_max = greater(planarity.diagonal_ratio_max, ratio);
            }
            let (distance, e_c) = (circle.sqrt(), squares_scale * e_c);
            all.circularity_distances.push(distance);
            circularity.max_distance = greater(circularity.max_distance, distance);
            circularity.mean_distance += share * distance;
            all.e_c.push(e_c);
            circularity.e_c_max = greater(circularity.e_c_max, e_c);
            circularity.e_c_mean += share * e_c;
        }
        all
    }
}

fn greater(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// Returns the distance between the lines of the diagonals of a quad, relative to their mean
/// length; 0 if both have no length. Diagonals can be parallel, up to rounding.
pub fn diagonal_ratio(corners: [Point; 4]) -> f64 {
    const PARALLEL: f64 = 1e-12;
    let [a, b, c, d] = corners.map(Vec3::from);
    let (ac, bd, between) = (c - a, d - b, b - a);
    let lengths = [ac.length(), bd.length()];
    let normal = ac.cross(bd);
    let sine = normal.length();
    let distance = if sine > PARALLEL * lengths[0] * lengths[1] {
        between.dot(normal).abs() / sine
    } else {
        let longer = if lengths[0] >= lengths[1] { ac } else { bd };
        let squared = longer.length_squared();
        if squared > 0.0 { between.cross(longer).length() / squared.sqrt() } else { 0.0 }
    };
    let mean = 0.5 * (lengths[0] + lengths[1]);
    if mean > 0.0 { distance / mean } else { 0.0 }
}

/// Returns the largest and the mean of the squared distances of the corners of a face to its plane, and
/// to the circle fitted in it. The circle of collinear corners is their line; coincident corners have no
/// error. The corners are moved.
fn face_errors(corners: &mut [Vec3<f64>]) -> [[f64; 2]; 2] {
    centre(corners);
    match CircleFit::of(corners) {
        Some(circle) => errors(corners, |p| circle.height_and_step(p)),
        None => {
            let circle = PrincipalRound::rotate(corners, 2, |radius| radius);
            errors(corners, |p| circle.height_and_step(p))
        }
    }
}

/// The errors, given the height of each corner over the plane and its displacement in the plane to the
/// circle.
#[inline(always)]
fn errors(
    corners: &[Vec3<f64>],
    height_and_step: impl Fn(Vec3<f64>) -> (f64, Vec3<f64>),
) -> [[f64; 2]; 2] {
    let share = 1.0 / corners.len() as f64;
    let mut errors = [[0.0; 2]; 2];
    for &p in corners {
        let (height, step) = height_and_step(p);
        let squares = [height * height, step.length_squared() + height * height];
        for ([largest, mean], square) in errors.iter_mut().zip(squares) {
            *largest = greater(*largest, square);
            *mean += share * square;
        }
    }
    errors
}
