//! Maps with integers, by the factor of the map without them: an integer is held by a force, of which
//! the dense inverse gives the size.

use super::energy::Energy;
use super::rounding::Inverse;
use super::seamless::{Seamless, doubled_areas};
use super::seams::Seams;
use super::separation::Separation;
use super::snap::snapped;
use crate::quads::MapFault;
use crate::quads::system::RIGHT_SIDES;
use nalgebra::DMatrix;

/// Most integer unknowns: each is coupled with each, so that memory grows with the square of their
/// number and the time of a rounding with the cube, to 200 MB and some ten seconds.
const MOST_INTEGERS: usize = 3000;

/// A map whose integer unknowns are integers.
pub(super) struct Rounded {
    /// Values of the free unknowns of the seams.
    pub values: Vec<f64>,
    /// Twice the areas of the mapped triangles, in squares of panels.
    pub doubled: Vec<f64>,
}

impl Rounded {
    /// Rounds to fixed point, so that signs of areas are exact.
    fn new(seams: &Seams, mut values: Vec<f64>) -> Rounded {
        values.iter_mut().for_each(|value| *value = snapped(*value));
        let doubled = doubled_areas(seams, &values);
        Rounded { values, doubled }
    }

    /// The triangles without positive area.
    pub(super) fn flipped(&self) -> Vec<usize> {
        (0..self.doubled.len()).filter(|&t| self.doubled[t] <= 0.0).collect()
    }
}

/// The integer unknowns of a seamless map.
pub(super) struct Integers {
    /// The integer unknowns, as free unknowns of the seams, and as unknowns of the system.
    unknowns: Vec<(usize, usize)>,
    /// Values of these in the seamless map.
    free: Vec<f64>,
    /// `None` without integer unknowns.
    inverse: Option<Inverse>,
    right: Vec<f64>,
}

impl Integers {
    /// Computes the inverse of the Schur complement of the integer unknowns. The energy must be
    /// factored with the weights of the seamless map.
    ///
    /// # Errors
    /// If there are too many unknowns, or it is not positive definite.
    pub(super) fn new(
        seams: &Seams,
        energy: &mut Energy,
        seamless: &Seamless,
    ) -> Result<Integers, MapFault> {
        let integers = (0..seams.is_integer.len()).filter(|&k| seams.is_integer[k]);
        let unknowns: Vec<(usize, usize)> =
            integers.filter_map(|k| Some((k, energy.unknowns[k]?))).collect();
        let m = unknowns.len();
        if m > MOST_INTEGERS {
            return Err(MapFault::TooManyIntegers);
        }
        let right = energy.right(seams, &seamless.weights);
        let mut matrix = DMatrix::zeros(m, m);
        for first in (0..m).step_by(RIGHT_SIDES) {
            let together = RIGHT_SIDES.min(m - first);
            let mut x = vec![[0.0; RIGHT_SIDES]; right.len()];
            (0..together).for_each(|r| x[unknowns[first + r].1][r] = 1.0);
            energy.system.solve(&mut x);
            for (i, &(_, place)) in unknowns.iter().enumerate() {
                (0..together).for_each(|r| matrix[(i, first + r)] = x[place][r]);
            }
        }
        let inverse = match m {
            0 => None,
            _ => Some(Inverse::new(matrix).ok_or(MapFault::Numerical)?),
        };
        let free = unknowns.iter().map(|&(k, _)| seamless.values[k]).collect();
        Ok(Integers { unknowns, free, inverse, right })
    }

    /// Number of integer unknowns.
    pub(super) fn count(&self) -> usize {
        self.unknowns.len()
    }

    /// The integers by greedy rounding of the map scaled by `scale`, with separations.
    pub(super) fn round(&self, scale: f64, separations: &[Separation]) -> Vec<f64> {
        let Some(inverse) = &self.inverse else { return Vec::new() };
        // Pinned unknowns are zero.
        let local = |&(k, c): &(u32, f64)| {
            let found = self.unknowns.binary_search_by_key(&(k as usize), |&(k, _)| k);
            Some((found.ok()?, c))
        };
        let of_separation =
            |one: &Separation| (one.row.iter().filter_map(local).collect(), one.value);
        let given: Vec<(Vec<(usize, f64)>, f64)> = separations.iter().map(of_separation).collect();
        inverse.round(&self.scaled(scale), &given)
    }

    /// The integer unknowns of the scaled seamless map.
    fn scaled(&self, scale: f64) -> Vec<f64> {
        self.free.iter().map(|value| scale * value).collect()
    }

    /// The map of least energy with these integers, by the factor of the seamless map.
    pub(super) fn solve(
        &self,
        seams: &Seams,
        energy: &mut Energy,
        scale: f64,
        integers: &[f64],
    ) -> Rounded {
        let mut x: Vec<[f64; 1]> = self.right.iter().map(|b| [scale * b]).collect();
        if let Some(inverse) = &self.inverse {
            let forces = inverse.forces(integers, &self.scaled(scale));
            for (&(_, place), force) in self.unknowns.iter().zip(forces) {
                x[place][0] += force;
            }
        }
        energy.system.solve(&mut x);
        let mut values: Vec<f64> =
            energy.unknowns.iter().map(|unknown| unknown.map_or(0.0, |i| x[i][0])).collect();
        for (&(k, _), &value) in self.unknowns.iter().zip(integers) {
            values[k] = value;
        }
        Rounded::new(seams, values)
    }
}
