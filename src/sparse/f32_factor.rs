//! The factor in single precision, for steps that are checked in double precision afterwards: its sweeps
//! are twice as fast, and their relative error is about 1e-6.
//!
//! The exponents of `f32` end at 1e-38 and 1e38, and weights and units may be anything: matrix and
//! gradients are scaled by powers of two before they are rounded, which changes no digit of a step.

use super::matrix::Row;
use super::panels::Panels;
use super::rank_one::Update;
use super::supernodes::Supernodes;
use crate::math::Lane;
use std::rc::Rc;

/// Coordinates x, y, z of one unknown and a zero: one 128-bit register.
pub(crate) type F32Row = [f32; 4];

/// Scaled gradients start below this. The influence of one vertex on far ones falls off
/// exponentially, and where it falls out of the normal numbers of `f32` processors become slow:
/// starting this high, that is at 1e-45 of the largest one. Products of two rows stay far below
/// the largest `f32`.
const LARGEST: f64 = (1_u64 << 24) as f64;

/// A factor whose panels are `f32`.
pub(crate) struct F32Factor {
    panels: Panels<f32>,
    /// The matrix was divided by this power of two, so that the largest pivot is near one.
    unit: f64,
}

impl F32Factor {
    /// Lays out panels, which are to be stored or filled; see [`Panels::new`].
    pub(crate) fn new(supernodes: Rc<Supernodes>) -> F32Factor {
        F32Factor { panels: Panels::new(supernodes), unit: 1.0 }
    }

    /// The panels, to be stored or filled.
    pub(crate) fn panels(&mut self) -> &mut Panels<f32> {
        &mut self.panels
    }

    /// Replaces `D`. Columns that are `fixed` are no unknowns.
    pub(crate) fn set_pivots(&mut self, pivots: &[f64], fixed: &[bool]) {
        let (unit, scaled) = scaled(pivots, fixed);
        self.unit = unit;
        self.panels.set_pivots(&scaled);
    }

    /// Changes the factor as [`Panels::update`] does.
    pub(crate) fn update(&mut self, column: u32, update: Update) {
        let scaled = match update {
            Update::Weight(weight) => Update::Weight(weight / self.unit),
            Update::Fix => Update::Fix,
        };
        self.panels.update(column, scaled);
    }

    /// The power of two by which a gradient is multiplied before it is rounded, so that it fits `f32`.
    pub(crate) fn scale(gradient: &[Row]) -> f64 {
        LARGEST / power_of_two(2.0 * largest(gradient))
    }

    /// Beside the scale of the gradient, what steps are multiplied by.
    pub(crate) fn unit(&self) -> f64 {
        self.unit
    }

    /// Turns a scaled gradient into the scaled step.
    pub(crate) fn solve(&self, rows: &mut [F32Row]) {
        self.panels.solve(rows);
    }

    /// `to = x - step`, where the step was made of gradients times `scale`.
    #[inline(never)]
    pub(crate) fn subtract_step(&self, to: &mut [Row], x: &[Row], step: &[F32Row], scale: f64) {
        let back = 1.0 / scale / self.unit;
        let (x, step) = (x.as_flattened(), step.as_flattened());
        for ((to, x), step) in to.as_flattened_mut().iter_mut().zip(x).zip(step) {
            *to = x - back * f64::from(*step);
        }
    }
}

/// A power of two near the largest pivot, and the pivots divided by it. Those of fixed columns have no
/// unit, and become one.
fn scaled(pivots: &[f64], fixed: &[bool]) -> (f64, Vec<f64>) {
    let mut scaled = pivots.to_vec();
    let largest = pivots.iter().zip(fixed).filter(|(_, fixed)| !**fixed);
    let unit = power_of_two(largest.map(|(&pivot, _)| pivot).fold(0.0, Lane::max));
    for (pivot, fixed) in scaled.iter_mut().zip(fixed) {
        *pivot = if *fixed { 1.0 } else { *pivot / unit };
    }
    (unit, scaled)
}

/// The largest absolute value.
#[inline(never)]
fn largest(x: &[Row]) -> f64 {
    let mut largest = [0.0; 4];
    for row in x {
        for i in 0..4 {
            largest[i] = Lane::max(row[i].abs(), largest[i]);
        }
    }
    largest.into_iter().fold(0.0, Lane::max)
}

/// The greatest power of two that is not above `x`, which is positive and not at the ends of the
/// range of `f64`: what is there is nothing, or not finite.
fn power_of_two(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    f64::from_bits(x.clamp(1e-200, 1e200).to_bits() & EXPONENT)
}

/// `to = scale * from`, rounded.
#[inline(never)]
pub(crate) fn round(to: &mut [F32Row], from: &[Row], scale: f64) {
    for (to, from) in to.as_flattened_mut().iter_mut().zip(from.as_flattened()) {
        *to = (scale * from) as f32;
    }
}
