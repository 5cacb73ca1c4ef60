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
use crate::math::{cosine, sine};
use crate::quads::field::{Combed, Cross, Frames};
use crate::quads::surface::Prepared;
use crate::quads::system::SymmetricSystem;
use std::f64::consts::TAU;

/// Turn of a panel, in radians, at which half of the weight of directions applies.
const TURN: f64 = 0.05;

/// The quadratic energy in the free unknowns that are not pinned.
pub(crate) struct Energy {
    /// The matrix; its unknowns are those of `unknowns`.
    pub system: SymmetricSystem,
    /// The index in the system of each free unknown of the seams; `None` if pinned.
    pub unknowns: Vec<Option<usize>>,
    /// Two of each triangle: u, and v.
    blocks: Vec<Block>,
    /// For each triangle the entries of `K` of u and v (rows and columns are corners), and the
    /// right-hand sides, for a weight of one.
    elements: Vec<Element>,
}

/// One coordinate of the corners of a triangle in the unknowns of the system: `P` of `P^T K P`.
struct Block {
    /// For each unknown its coefficient in the coordinate of each corner.
    columns: Vec<[f64; 3]>,
    /// Places in the matrix of the pairs of unknowns, of each with itself and with those before it.
    places: Vec<u32>,
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
        let n = prepared.surface.triangles.len();
        // The rows of the three corners share most of their unknowns, over many cuts many.
        let block = |k: usize| {
            let rows = seams.classes[k / 2].map(|class| &seams.sums[2 * class as usize + k % 2]);
            let mut columns: Vec<(usize, [f64; 3])> = Vec::new();
            for (corner, row) in rows.into_iter().enumerate() {
                for &(k, c) in row {
                    let Some(unknown) = unknowns[k as usize] else { continue };
                    let mut column = [0.0; 3];
                    column[corner] = c;
                    columns.push((unknown, column));
                }
            }
            columns.sort_by_key(|&(unknown, _)| unknown);
            columns.dedup_by(|later, first| {
                let same = later.0 == first.0;
                if same {
                    first.1.iter_mut().zip(later.1).for_each(|(sum, c)| *sum += c);
                }
                same
            });
            columns
        };
        let all: Vec<Vec<(usize, [f64; 3])>> = (0..2 * n).map(block).collect();
        let mut pairs = Vec::new();
        for columns in &all {
            for (j, &(second, _)) in columns.iter().enumerate() {
                pairs.extend(columns[..j].iter().map(|first| [first.0 as u32, second as u32]));
            }
        }
        let mut system = SymmetricSystem::new(count, pairs);
        system.values().fill(0.0);
        let placed = |columns: Vec<(usize, [f64; 3])>| {
            let mut places = Vec::with_capacity(columns.len() * (columns.len() + 1) / 2);
            for (j, &(second, _)) in columns.iter().enumerate() {
                let of_pair = |first: &(usize, [f64; 3])| system.place(first.0, second) as u32;
                places.extend(columns[..=j].iter().map(of_pair));
            }
            Block { columns: columns.into_iter().map(|(_, column)| column).collect(), places }
        };
        let blocks = all.into_iter().map(placed).collect();
        let element = |t: usize| element(prepared, frames, combed, cross, direction, t);
        Energy { system, unknowns, blocks, elements: (0..n).map(element).collect() }
    }

    /// Sets the matrix for the weights `#T`.
    pub(crate) fn assemble(&mut self, weights: &[f64]) {
        let values = self.system.values();
        values.fill(0.0);
        for (k, block) in self.blocks.iter().enumerate() {
            let (matrix, weight) = (&self.elements[k / 2].matrix[k % 2], weights[k / 2]);
            let mut places = block.places.iter();
            for (j, second) in block.columns.iter().enumerate() {
                let by_matrix = [0, 1, 2].map(|a| {
                    let row = &matrix[3 * a..3 * a + 3];
                    weight * (row[0] * second[0] + row[1] * second[1] + row[2] * second[2])
                });
                for (first, &place) in block.columns[..=j].iter().zip(places.by_ref()) {
                    let [x, y, z] = [0, 1, 2].map(|a| first[a] * by_matrix[a]);
                    values[place as usize] += x + y + z;
                }
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
    let turn = 2.0 * cross.anisotropy[t].norm_sqr().sqrt() * h;
    let stiff = 1.0 + direction * turn * turn / (turn * turn + TURN * TURN);
    let [c, s] = [cosine, sine].map(|of| of(combed.angles[t] / TAU));
    // Gradients of the hat functions along both directions: the normal times the opposite side.
    let slopes = [0, 1, 2].map(|k| {
        let side = prepared.surface.at(t, k + 2) - prepared.surface.at(t, k + 1);
        let side = frames.of(t, side) / (2.0 * area);
        let [gx, gy] = [-side.im, side.re];
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
