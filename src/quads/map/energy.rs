//! The energy of a map: how far its gradients are from the directions of the field over the size of a
//! panel, with directions weighted more than sizes where the surface is curved (Bommes, Zimmer and
//! Kobbelt 2009, anisotropic norm).
//!
//! ```text
//! E = sum_f A_f s_f [(grad u . X1 - 1/h)^2 + (grad v . X2 - 1/h)^2
//!                    + d_f ((grad u . X2)^2 + (grad v . X1)^2)]
//! d_f = 1 + D k^2 / (k^2 + 0.05^2),   k = |k1 - k2| h
//! ```

use super::seams::Seams;
use crate::quads::field::{Combed, Cross, Frames, at_angle, size};
use crate::quads::surface::Prepared;
use crate::quads::system::SymmetricSystem;

/// Turn of a panel, in radians, at which half of the weight of directions applies.
const TURN: f64 = 0.05;

/// The quadratic energy in the free unknowns that are not pinned.
pub(crate) struct Energy {
    /// The matrix; its unknowns are those of `unknowns`.
    pub system: SymmetricSystem,
    /// The index in the system of each free unknown of the seams; `None` if pinned.
    pub unknowns: Vec<Option<usize>>,
    /// Additions to the matrix, triangle by triangle: place, factor, number of the entry of the
    /// element matrix.
    additions: Vec<(u32, f64, u8)>,
    /// Start of each triangle in `additions`, and the end of the last one.
    starts: Vec<u32>,
    /// For each triangle the entries of `K` of u and v (rows and columns are corners), and the
    /// right-hand sides, for a weight of one.
    elements: Vec<Element>,
}

#[derive(Clone, Copy)]
struct Element {
    /// `[axis][3 a + c]`
    matrix: [[f64; 9]; 2],
    /// `[axis][a]`
    right: [[f64; 3]; 2],
}

impl Energy {
    /// Sets up the pattern and the elements. `direction` is D.
    pub(crate) fn new(
        prepared: &Prepared,
        frames: &Frames,
        combed: &Combed,
        cross: &Cross,
        seams: &Seams,
        direction: f64,
    ) -> Energy {
        let mut unknowns = vec![None; seams.is_integer.len()];
        let mut count = 0;
        for (k, unknown) in unknowns.iter_mut().enumerate() {
            if !seams.pinned.contains(&(k as u32)) {
                *unknown = Some(count);
                count += 1;
            }
        }
        let rows: Vec<Vec<(usize, f64)>> = seams
            .sums
            .iter()
            .map(|row| row.iter().filter_map(|&(k, c)| Some((unknowns[k as usize]?, c))).collect())
            .collect();
        let n = prepared.surface.triangles.len();
        let entries = |t: usize| {
            let rows = &rows;
            let classes = seams.classes[t];
            (0..18usize).flat_map(move |k| {
                let (axis, a, c) = (k / 9, k % 9 / 3, k % 3);
                let row = &rows[2 * classes[a] as usize + axis];
                let column = &rows[2 * classes[c] as usize + axis];
                row.iter().flat_map(move |&(i, x)| {
                    column.iter().map(move |&(j, y)| (i, j, x * y, k as u8))
                })
            })
        };
        let mut pairs = Vec::new();
        for t in 0..n {
            pairs.extend(entries(t).filter(|e| e.0 < e.1).map(|e| [e.0 as u32, e.1 as u32]));
        }
        let mut system = SymmetricSystem::new(count, pairs);
        system.values().fill(0.0);
        let (mut additions, mut starts) = (Vec::new(), vec![0]);
        for t in 0..n {
            // Both orders of a pair are in the sum, and one place stands for both.
            let upper = entries(t).filter(|e| e.0 <= e.1);
            additions.extend(upper.map(|(i, j, factor, k)| (system.place(i, j) as u32, factor, k)));
            starts.push(additions.len() as u32);
        }
        let element = |t: usize| element(prepared, frames, combed, cross, direction, t);
        Energy { system, unknowns, additions, starts, elements: (0..n).map(element).collect() }
    }

    /// Sets the matrix for the weights `#T`.
    pub(crate) fn assemble(&mut self, weights: &[f64]) {
        let values = self.system.values();
        values.fill(0.0);
        for (t, (element, weight)) in self.elements.iter().zip(weights).enumerate() {
            let range = self.starts[t] as usize..self.starts[t + 1] as usize;
            for &(place, factor, k) in &self.additions[range] {
                let (axis, entry) = (k as usize / 9, k as usize % 9);
                values[place as usize] += weight * factor * element.matrix[axis][entry];
            }
        }
    }

    /// The right-hand side for the weights `#T`, one value for each unknown of the system.
    pub(crate) fn right(&self, seams: &Seams, weights: &[f64]) -> Vec<f64> {
        let mut right = vec![0.0; self.unknowns.len() - seams.pinned.len()];
        for (t, (element, weight)) in self.elements.iter().zip(weights).enumerate() {
            for (axis, a) in (0..2).flat_map(|axis| (0..3).map(move |a| (axis, a))) {
                let value = weight * element.right[axis][a];
                for &(k, c) in &seams.sums[2 * seams.classes[t][a] as usize + axis] {
                    if let Some(i) = self.unknowns[k as usize] {
                        right[i] += c * value;
                    }
                }
            }
        }
        right
    }
}

fn element(
    prepared: &Prepared,
    frames: &Frames,
    combed: &Combed,
    cross: &Cross,
    direction: f64,
    t: usize,
) -> Element {
    let h = prepared.size;
    let area = frames.area[t];
    let turn = 2.0 * size(cross.anisotropy[t]) * h;
    let stiff = 1.0 + direction * turn * turn / (turn * turn + TURN * TURN);
    let [c, s] = at_angle(combed.angles[t]);
    // Gradients of the hat functions along both directions: the normal times the opposite side.
    let slopes = [0, 1, 2].map(|k| {
        let side = prepared.surface.at(t, k + 2) - prepared.surface.at(t, k + 1);
        let [x, y] = frames.of(t, side).map(|part| part / (2.0 * area));
        let [gx, gy] = [-y, x];
        [gx * c + gy * s, -gx * s + gy * c]
    });
    let mut element = Element { matrix: [[0.0; 9]; 2], right: [[0.0; 3]; 2] };
    for axis in 0..2 {
        for a in 0..3 {
            element.right[axis][a] = area * slopes[a][axis] / h;
            for c in 0..3 {
                let along = slopes[a][axis] * slopes[c][axis];
                let across = slopes[a][1 - axis] * slopes[c][1 - axis];
                element.matrix[axis][3 * a + c] = area * (along + stiff * across);
            }
        }
    }
    element
}
