//! Maps with integers: rounded at several scales, stiffened, and with single roundings changed where
//! triangles are flipped.

use super::energy::Energy;
use super::rounding::Inverse;
use super::seamless::{NO_AREA, Seamless, doubled_areas, stiffen};
use super::seams::Seams;
use super::separation::Separation;
use crate::quads::RemeshError;
use crate::quads::surface::Prepared;
use crate::quads::system::TOGETHER;
use nalgebra::DMatrix;

/// A map whose integer unknowns are integers.
#[derive(Clone)]
pub(super) struct Rounded {
    /// Values of the free unknowns of the seams.
    pub values: Vec<f64>,
    /// Twice the areas of the mapped triangles, in squares of panels.
    pub doubled: Vec<f64>,
    /// Number of triangles without positive area.
    pub flips: usize,
}

impl Rounded {
    fn new(seams: &Seams, values: Vec<f64>) -> Rounded {
        let doubled = doubled_areas(seams, &values);
        let flips = doubled.iter().filter(|&&area| area <= NO_AREA).count();
        Rounded { values, doubled, flips }
    }
}

/// What the roundings of one seamless map share.
pub(super) struct Integers<'a> {
    pub prepared: &'a Prepared,
    pub seams: &'a Seams,
    pub areas: &'a [f64],
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
        prepared: &'a Prepared,
        seams: &'a Seams,
        areas: &'a [f64],
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
        Ok(Integers { prepared, seams, areas, seamless, unknowns, inverse, right })
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

    /// The change of energy when one integer is raised or lowered by one: unknown, step, cost;
    /// cheapest first.
    pub(super) fn steps(&self, scale: f64, integers: &[f64]) -> Vec<(usize, f64, f64)> {
        let Some(inverse) = &self.inverse else { return Vec::new() };
        let forces = inverse.forces(integers, &self.free(scale));
        let both =
            forces.iter().zip(inverse.stiffness()).enumerate().flat_map(|(j, (force, k))| {
                [1.0, -1.0].map(|step| (j, step, step * force + 0.5 * k))
            });
        let mut steps: Vec<(usize, f64, f64)> = both.collect();
        steps.sort_by(|a, b| a.2.total_cmp(&b.2).then(a.0.cmp(&b.0)));
        steps
    }

    /// Stiffens flipped triangles with the integers held, for at most `rounds` factorisations, and
    /// returns the best map found. The energy is left with other weights.
    ///
    /// # Errors
    /// If a matrix is singular.
    pub(super) fn stiffened(
        &self,
        energy: &mut Energy,
        scale: f64,
        integers: &[f64],
        start: Rounded,
        rounds: usize,
    ) -> Result<Rounded, RemeshError> {
        let mut given = vec![false; self.right.len()];
        for &k in &self.unknowns {
            given[energy.unknowns[k].expect("it is not pinned")] = true;
        }
        let mut weights = self.seamless.weights.clone();
        let mut best = start.clone();
        let mut last = start;
        for _ in 0..rounds {
            let (surface, size) = (&self.prepared.surface, self.prepared.size / scale);
            stiffen(surface, &last.doubled, self.areas, size, &mut weights);
            energy.assemble(&weights);
            energy.system.factor(&given)?;
            let mut x: Vec<[f64; 1]> =
                energy.right(self.seams, &weights).iter().map(|b| [scale * b]).collect();
            for (&k, &value) in self.unknowns.iter().zip(integers) {
                x[energy.unknowns[k].expect("it is not pinned")] = [value];
            }
            energy.system.solve(&mut x);
            last = self.of_solution(energy, &x, integers);
            if last.flips < best.flips {
                best = last.clone();
            }
            if best.flips == 0 {
                break;
            }
        }
        Ok(best)
    }

    /// Assembles and factors the energy of the seamless map again.
    ///
    /// # Errors
    /// None that did not occur before.
    pub(super) fn restore(&self, energy: &mut Energy) -> Result<(), RemeshError> {
        energy.assemble(&self.seamless.weights);
        energy.system.factor(&vec![false; self.right.len()])
    }

    fn of_solution(&self, energy: &Energy, x: &[[f64; 1]], integers: &[f64]) -> Rounded {
        let mut values: Vec<f64> =
            energy.unknowns.iter().map(|unknown| unknown.map_or(0.0, |i| x[i][0])).collect();
        self.unknowns.iter().zip(integers).for_each(|(&k, &value)| values[k] = value);
        Rounded::new(self.seams, values)
    }
}
