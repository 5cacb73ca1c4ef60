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
pub use dihedral::{folded_faces, mean_dihedral_angle};
pub use histogram::{Histogram, angle_histogram};
pub use quasi_conformal::{MapErrors, QuasiConformal, quasi_conformal};

use crate::math::{CircleFit, PrincipalCircle, Vec3, centre};
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
    /// The largest `e_p` of a face, bounding sphere of diameter 1: the mean squared distance of its
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
    /// The largest `e_c` of a face, bounding sphere of diameter 1: the mean squared distance of its
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
    /// Measures `faces` at `positions` (`#V by 3`). `diameter` is the diameter of the bounding
    /// sphere of the rest mesh; if it is 0, so are `e_p` and `e_c`.
    pub fn new(positions: &[Point], faces: &Ragged, diameter: f64) -> Measures {
        let mut all = Measures::default();
        let squares_scale = if diameter > 0.0 { 1.0 / diameter / diameter } else { 0.0 };
        let share = if faces.is_empty() { 0.0 } else { 1.0 / faces.len() as f64 };
        let mut fit = FaceFit::default();
        let (planarity, circularity) = (&mut all.planarity, &mut all.circularity);
        for face in faces.iter() {
            let corners = face.iter().map(|&v| positions[v as usize]);
            let errors = fit.errors(corners);
            let (distance, e_p) = (errors.plane.largest_square.sqrt(), errors.plane.mean_square);
            all.planarity_distances.push(distance);
            planarity.max_distance = greater(planarity.max_distance, distance);
            planarity.mean_distance += share * distance;
            let e_p = squares_scale * e_p;
            all.e_p.push(e_p);
            planarity.e_p_max = greater(planarity.e_p_max, e_p);
            planarity.e_p_mean += share * e_p;
            if let &[a, b, c, d] = face {
                let ratio = diagonal_ratio([a, b, c, d].map(|v| positions[v as usize]));
                planarity.diagonal_ratio_max = greater(planarity.diagonal_ratio_max, ratio);
            }
            let (distance, e_c) = (errors.circle.largest_square.sqrt(), errors.circle.mean_square);
            all.circularity_distances.push(distance);
            circularity.max_distance = greater(circularity.max_distance, distance);
            circularity.mean_distance += share * distance;
            let e_c = squares_scale * e_c;
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

/// Fits a plane and a circle to one face at a time.
#[derive(Clone, Debug, Default)]
struct FaceFit {
    /// The corners of the current face, relative to their mean.
    corners: Vec<Vec3<f64>>,
}

impl FaceFit {
    /// Returns the errors of the face with these corners. The fitted circle of collinear corners is
    /// their line; coincident corners have no error.
    pub(crate) fn errors(&mut self, corners: impl Iterator<Item = Point>) -> FaceErrors {
        self.corners.clear();
        self.corners.extend(corners.map(Vec3::from));
        centre(&mut self.corners);
        match CircleFit::of(&self.corners) {
            Some(circle) => self.sum(|p| circle.height_and_step(p)),
            None => {
                let circle = PrincipalCircle::rotate(&mut self.corners);
                self.sum(|p| circle.height_and_step(p))
            }
        }
    }

    /// Returns the errors, given the height of each corner over the plane and its displacement in
    /// the plane to the circle.
    #[inline(always)]
    fn sum(&self, height_and_step: impl Fn(Vec3<f64>) -> (f64, Vec3<f64>)) -> FaceErrors {
        let share = 1.0 / self.corners.len() as f64;
        let mut errors = FaceErrors::default();
        for p in &self.corners {
            let (height, step) = height_and_step(*p);
            errors.plane.add(height * height, share);
            errors.circle.add(step.length_squared() + height * height, share);
        }
        errors
    }
}

/// Errors of a face against its plane and its circle.
#[derive(Clone, Copy, Debug, Default)]
struct FaceErrors {
    pub(crate) plane: Errors,
    pub(crate) circle: Errors,
}

/// Distances of the corners of a face to a fitted shape.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Errors {
    pub(crate) largest_square: f64,
    pub(crate) mean_square: f64,
}

impl Errors {
    fn add(&mut self, square: f64, share: f64) {
        self.mean_square += share * square;
        if square > self.largest_square {
            self.largest_square = square;
        }
    }
}
