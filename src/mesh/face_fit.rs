//! Least-squares plane of a face, and the circle in it (paper section 3.1).
//!
//! The plane is that of the two greatest principal axes. The circle is the algebraic fit of Thomas
//! and Chan 1989, which minimises `sum (|p - c|^2 - r^2)^2` in closed form.

use super::Point;
use super::principal_axes::principal_axes;
use crate::math::Vec3;

/// The corners of a face, seen from their mean along their principal axes.
#[derive(Clone, Debug, Default)]
pub(super) struct FaceFit {
    /// Per corner: along the longest axis, along the second, height over the plane.
    corners: Vec<[f64; 3]>,
}

impl FaceFit {
    /// Fits the plane of some corners, replacing the face that was fitted before.
    pub(super) fn fit(&mut self, corners: impl ExactSizeIterator<Item = Point> + Clone) {
        let share = 1.0 / corners.len() as f64;
        let mut mean = Vec3::zero();
        corners.clone().for_each(|p| mean += Vec3::from(p) * share);
        let mut scatter = [[0.0; 3]; 3];
        for p in corners.clone() {
            let p = Point::from(Vec3::from(p) - mean);
            for i in 0..3 {
                for j in i..3 {
                    scatter[i][j] += p[i] * p[j];
                }
            }
        }
        let axes = principal_axes(scatter);
        self.corners.clear();
        self.corners.extend(corners.map(|p| {
            let p = Vec3::from(p) - mean;
            axes.map(|axis| axis.dot(p))
        }));
    }

    /// The errors to the plane.
    pub(super) fn plane_errors(&self) -> Errors {
        let mut errors = Errors::default();
        for [_, _, height] in &self.corners {
            errors.add(height * height, self.share());
        }
        errors
    }

    /// The errors to the circle. Corners on one line have that line for a circle, and coincident
    /// ones have no error.
    ///
    /// The mean square is that of the energy `E_shape` (Eq. 4), in which the closest points on the
    /// circle are moved so that they have the mean of the corners.
    pub(super) fn circle_errors(&self) -> Errors {
        let share = self.share();
        let (mut xx, mut yy, mut x_rr, mut y_rr) = (0.0, 0.0, 0.0, 0.0);
        for [x, y, _] in &self.corners {
            let rr = x * x + y * y;
            xx += x * x * share;
            yy += y * y * share;
            x_rr += x * rr * share;
            y_rr += y * rr * share;
        }
        // The centre is (x_rr / 2 xx, y_rr / 2 yy) and far away where the corners are nearly on the
        // x axis. All is taken times yy, and then nothing grows without bound.
        let centre = if xx > 0.0 { [0.5 * x_rr * (yy / xx), 0.5 * y_rr] } else { [0.0; 2] };
        let radius = (centre[0] * centre[0] + centre[1] * centre[1] + yy * yy * (xx + yy)).sqrt();
        let mut errors = Errors::default();
        let mut mean = [0.0; 2];
        for [x, y, height] in &self.corners {
            let from_centre = [yy * x - centre[0], yy * y - centre[1]];
            let length = (from_centre[0] * from_centre[0] + from_centre[1] * from_centre[1]).sqrt();
            // |p - c| - r without a difference of great numbers.
            let power = yy * (x * x + y * y - xx - yy) - 2.0 * (centre[0] * x + centre[1] * y);
            let outside = if length + radius > 0.0 { power / (length + radius) } else { 0.0 };
            errors.add(outside * outside + height * height, share);
            if length > 0.0 {
                mean[0] += share * outside * from_centre[0] / length;
                mean[1] += share * outside * from_centre[1] / length;
            }
        }
        let moved = errors.mean_square - mean[0] * mean[0] - mean[1] * mean[1];
        errors.mean_square = if moved > 0.0 { moved } else { 0.0 };
        errors
    }

    fn share(&self) -> f64 {
        1.0 / self.corners.len() as f64
    }
}

/// How far the corners of a face are from a fitted shape.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Errors {
    /// The largest squared distance.
    pub(super) largest_square: f64,
    /// The mean squared distance.
    pub(super) mean_square: f64,
}

impl Errors {
    fn add(&mut self, square: f64, share: f64) {
        self.mean_square += share * square;
        if square > self.largest_square {
            self.largest_square = square;
        }
    }
}
