//! Distances of the corners of a face to their least-squares plane and to the circle fitted in it
//! (paper section 3.1).

use crate::math::{CircleFit, PrincipalCircle, Vec3, centre};
use crate::mesh::Point;

/// Fits a plane and a circle to one face at a time.
#[derive(Clone, Debug, Default)]
pub(crate) struct FaceFit {
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
pub(crate) struct FaceErrors {
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
