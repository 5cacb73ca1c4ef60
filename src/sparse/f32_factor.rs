//! The factor in single precision, for steps that are checked in double precision afterwards: its
//! sweeps are twice as fast, with a relative error of about 1e-6.
//!
//! `f32` ranges from 1e-38 to 1e38 only, but weights and units are arbitrary. The matrix and the
//! gradients are therefore scaled by powers of two before they are rounded, which changes no digit
//! of a step.

use super::matrix::Row;
use super::panels::Panels;
use super::rank_one::Update;
use super::supernodes::Supernodes;
use crate::math::Lane;
use std::rc::Rc;

/// Coordinates x, y, z of one unknown and a zero: one 128-bit register.
pub(crate) type F32Row = [f32; 4];

/// Upper bound of scaled gradients. The influence of a vertex falls off exponentially with
/// distance, and processors become slow where it leaves the normal numbers of `f32`: with this
/// bound, at 1e-45 of the largest value. Products of two rows stay far below the largest `f32`.
const LARGEST: f64 = (1_u64 << 24) as f64;

/// A factor whose panels are `f32`.
pub(crate) struct F32Factor {
    panels: Panels<f32>,
    /// The power of two by which the matrix was divided, so that the largest pivot is near one.
    unit: f64,
}

impl F32Factor {
    /// Lays out panels, whose values are yet to be stored or filled; see [`Panels::new`].
    pub(crate) fn new(supernodes: Rc<Supernodes>) -> F32Factor {
        F32Factor { panels: Panels::new(supernodes), unit: 1.0 }
    }

    /// The panels, for storing or filling.
    pub(crate) fn panels(&mut self) -> &mut Panels<f32> {
        &mut self.panels
    }

    /// Replaces `D`. Columns marked `fixed` are not unknowns.
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

    /// Returns the power of two by which a gradient is multiplied before rounding, so that it fits
    /// `f32`.
    pub(crate) fn scale(gradient: &[Row]) -> f64 {
        LARGEST / power_of_two(2.0 * largest(gradient))
    }

    /// The factor by which steps are multiplied, in addition to the scale of the gradient.
    pub(crate) fn unit(&self) -> f64 {
        self.unit
    }

    /// Replaces a scaled gradient by the scaled step.
    pub(crate) fn solve(&self, rows: &mut [F32Row]) {
        self.panels.solve(rows);
    }

    /// `to = x - step`, with `step` computed from gradients times `scale`.
    #[inline(never)]
    pub(crate) fn subtract_step(&self, to: &mut [Row], x: &[Row], step: &[F32Row], scale: f64) {
        let back = 1.0 / scale / self.unit;
        let (x, step) = (x.as_flattened(), step.as_flattened());
        for ((to, x), step) in to.as_flattened_mut().iter_mut().zip(x).zip(step) {
            *to = x - back * f64::from(*step);
        }
    }
}

/// Returns a power of two near the largest pivot, and the pivots divided by it. The pivots of fixed
/// columns do not count, and become one.
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

/// The greatest power of two not above `x`, which is positive and clamped to 1e-200..1e200: values
/// beyond are negligible or not finite.
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
