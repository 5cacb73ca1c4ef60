//! Maps with integers, by the factor of the map without them: an integer is held by a force, of which
//! the dense inverse gives the size.

use super::energy::Energy;
use super::rounding::Inverse;
use super::seamless::{Seamless, doubled_areas};
use super::seams::Seams;
use super::separation::Separation;
use super::snap::snapped;
use crate::quads::RemeshError;
use crate::quads::system::TOGETHER;
use nalgebra::DMatrix;

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

/// What the roundings of one seamless map share.
pub(super) struct Integers<'a> {
    seams: &'a Seams,
    seamless: &'a Seamless,
    /// The integer unknowns, as free unknowns of the seams.
    pub unknowns: Vec<usize>,
    /// `None` without integer unknowns.
    inverse: Option<Inverse>,
    right: Vec<f64>,
}

impl<'a> Integers<'a> {
    /// Computes the inverse of the Schur complement of the integer unknowns. The energy must be
    /// factored with the weights of the seamless map.
    ///
    /// # Errors
    /// If it is not positive definite.
    pub(super) fn new(
        seams: &'a Seams,
        energy: &mut Energy,
        seamless: &'a Seamless,
    ) -> Result<Integers<'a>, RemeshError> {
        let integers = (0..seams.is_integer.len()).filter(|&k| seams.is_integer[k]);
        let (unknowns, places): (Vec<usize>, Vec<usize>) =
            integers.filter_map(|k| Some((k, energy.unknowns[k]?))).unzip();
        let m = places.len();
        let size = energy.unknowns.len() - seams.pinned.len();
        let mut matrix = DMatrix::zeros(m, m);
        for first in (0..m).step_by(TOGETHER) {
            let together = TOGETHER.min(m - first);
            let mut x = vec![[0.0; TOGETHER]; size];
            (0..together).for_each(|r| x[places[first + r]][r] = 1.0);
            energy.system.solve(&mut x);
            for (i, &place) in places.iter().enumerate() {
                (0..together).for_each(|r| matrix[(i, first + r)] = x[place][r]);
            }
        }
        let inverse =
            if m > 0 { Some(Inverse::new(matrix).ok_or(RemeshError::Numerical)?) } else { None };
        let right = energy.right(seams, &seamless.weights);
        Ok(Integers { seams, seamless, unknowns, inverse, right })
    }

    /// The integers by greedy rounding of the map scaled by `scale`, with separations.
    pub(super) fn round(&self, scale: f64, separations: &[Separation]) -> Vec<f64> {
        let Some(inverse) = &self.inverse else { return Vec::new() };
        // Pinned unknowns are zero.
        let local =
            |&(k, c): &(u32, f64)| Some((self.unknowns.binary_search(&(k as usize)).ok()?, c));
        let given: Vec<(Vec<(usize, f64)>, f64)> = separations
            .iter()
            .map(|one| (one.row.iter().filter_map(local).collect(), one.value))
            .collect();
        inverse.round(&self.free(scale), &given)
    }

    /// The integer unknowns of the scaled seamless map.
    fn free(&self, scale: f64) -> Vec<f64> {
        self.unknowns.iter().map(|&k| scale * self.seamless.values[k]).collect()
    }

    /// The map of least energy with these integers, by the factor of the seamless map.
    pub(super) fn solve(&self, energy: &mut Energy, scale: f64, integers: &[f64]) -> Rounded {
        let mut x: Vec<[f64; 1]> = self.right.iter().map(|b| [scale * b]).collect();
        if let Some(inverse) = &self.inverse {
            let forces = inverse.forces(integers, &self.free(scale));
            for (&k, force) in self.unknowns.iter().zip(forces) {
                x[energy.unknowns[k].expect("it is not pinned")][0] += force;
            }
        }
        energy.system.solve(&mut x);
        self.of_solution(energy, &x, integers)
    }

    fn of_solution(&self, energy: &Energy, x: &[[f64; 1]], integers: &[f64]) -> Rounded {
        let mut values: Vec<f64> =
            energy.unknowns.iter().map(|unknown| unknown.map_or(0.0, |i| x[i][0])).collect();
        self.unknowns.iter().zip(integers).for_each(|(&k, &value)| values[k] = value);
        Rounded::new(self.seams, values)
    }
}
