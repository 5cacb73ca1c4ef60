//! The seamless map without integers, stiffened where triangles are flipped.

use super::energy::Energy;
use super::seams::Seams;
use crate::quads::surface::Prepared;
use crate::quads::{MapFault, Triangulation};

/// Most rounds of stiffening.
const ROUNDS: usize = 4;
/// Triangles that are mapped to less than this fraction of their area are stiffened.
const SMALL: f64 = 0.02;

/// A map as values of the free unknowns of the seams.
pub(crate) struct Seamless {
    /// Values of the free unknowns; zero for pinned ones.
    pub values: Vec<f64>,
    /// Weights of the triangles, with which the energy is assembled and factored.
    pub weights: Vec<f64>,
}

/// The map of least energy; the energy is left assembled and factored for its weights.
///
/// # Errors
/// If the matrix is singular.
pub(crate) fn seamless_map(
    prepared: &Prepared,
    seams: &Seams,
    energy: &mut Energy,
    areas: &[f64],
) -> Result<Seamless, MapFault> {
    let mut weights = vec![1.0; areas.len()];
    let mut best: Option<(usize, Vec<f64>, Vec<f64>)> = None;
    let none = vec![false; energy.unknowns.len() - seams.pinned.len()];
    let mut last_best = false;
    for _ in 0..ROUNDS {
        let values = solve(seams, energy, &weights, &none)?;
        let doubled = doubled_areas(seams, &values);
        let flipped = doubled.iter().filter(|&&area| area <= 0.0).count();
        last_best = best.as_ref().is_none_or(|best| flipped < best.0);
        if last_best {
            best = Some((flipped, weights.clone(), values));
        }
        if flipped == 0 {
            break;
        }
        stiffen(&prepared.surface, &doubled, areas, prepared.size, &mut weights);
    }
    let (_, weights, values) = best.expect("there was a round");
    if !last_best {
        energy.assemble(&weights);
        energy.system.factor(&none)?;
    }
    Ok(Seamless { values, weights })
}

fn solve(
    seams: &Seams,
    energy: &mut Energy,
    weights: &[f64],
    none: &[bool],
) -> Result<Vec<f64>, MapFault> {
    energy.assemble(weights);
    energy.system.factor(none)?;
    let mut x: Vec<[f64; 1]> = energy.right(seams, weights).into_iter().map(|b| [b]).collect();
    energy.system.solve(&mut x);
    Ok(energy.unknowns.iter().map(|unknown| unknown.map_or(0.0, |i| x[i][0])).collect())
}

/// Twice the area of each mapped triangle, in squares of panels.
pub(super) fn doubled_areas(seams: &Seams, values: &[f64]) -> Vec<f64> {
    let of_sum = |row: &[(u32, f64)]| row.iter().map(|&(k, c)| c * values[k as usize]).sum::<f64>();
    let coordinates: Vec<f64> = seams.sums.iter().map(|row| of_sum(row)).collect();
    let of_triangle = |classes: &[u32; 3]| {
        let [a, b, c] =
            classes.map(|class| [0, 1].map(|axis| coordinates[2 * class as usize + axis]));
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    seams.classes.iter().map(of_triangle).collect()
}

/// Multiplies the weights of small and flipped triangles by three, and of those up to two sides away
/// by less.
pub(super) fn stiffen(
    surface: &Triangulation,
    doubled: &[f64],
    areas: &[f64],
    size: f64,
    weights: &mut [f64],
) {
    let small = |(&doubled, &area): (&f64, &f64)| {
        f64::from(u8::from(doubled <= SMALL * 2.0 * area / (size * size)))
    };
    let mut amount: Vec<f64> = doubled.iter().zip(areas).map(small).collect();
    for _ in 0..2 {
        let before = amount.clone();
        for (t, sides) in surface.neighbours.iter().enumerate() {
            for next in sides.iter().flatten() {
                amount[t] = amount[t].max(0.5 * before[next.triangle]);
            }
        }
    }
    weights.iter_mut().zip(amount).for_each(|(weight, amount)| *weight *= 1.0 + 2.0 * amount);
}
