//! The inverse of the normal matrix in single precision, for steps that a check in double precision
//! follows: twice as fast, and good to six digits or so.
//!
//! `f32` has few powers of ten, and weights and units may be anything: matrix and gradients are
//! scaled by powers of two before they are rounded, which changes no digit of a step.

use super::panels::Panels;
use super::rank_one::Change;
use super::symbolic::Symbolic;
use crate::constraint::Row;
use crate::math::Lane;
use std::rc::Rc;

/// A row in single precision, one 128-bit register.
pub(super) type SingleRow = [f32; 4];

/// Scaled gradients start below this. The influence of one vertex on far ones falls off
/// exponentially, and where it falls out of the normal numbers of `f32` processors become slow:
/// starting this high, that is at 1e-45 of the largest one. Products of two rows stay far below
/// the largest `f32`.
const LARGEST: f64 = (1_u64 << 24) as f64;

/// The factor in single precision.
pub(super) struct Metric {
    panels: Panels<f32>,
    /// The matrix was divided by this power of two, so that the largest pivot is near one.
    unit: f64,
}

impl Metric {
    /// Lays out panels, which are to be stored or filled; see [`Panels::new`].
    pub(super) fn new(symbolic: Rc<Symbolic>) -> Metric {
        Metric { panels: Panels::new(symbolic), unit: 1.0 }
    }

    /// The panels, to be stored or filled.
    pub(super) fn panels(&mut self) -> &mut Panels<f32> {
        &mut self.panels
    }

    /// Replaces `D`. Columns that are `fixed` are no unknowns.
    pub(super) fn set_pivots(&mut self, pivots: &[f64], fixed: &[bool]) {
        let (unit, scaled) = scaled(pivots, fixed);
        self.unit = unit;
        self.panels.set_pivots(&scaled);
    }

    /// Changes the factor as [`Panels::change`] does.
    pub(super) fn change(&mut self, column: u32, change: Change) {
        self.panels.change(
            column,
            match change {
                Change::Weight(weight) => Change::Weight(weight / self.unit),
                Change::Fix => Change::Fix,
            },
        );
    }

    /// What gradients are multiplied by before they are rounded, a power of two that fits `gradient`.
    pub(super) fn scale(gradient: &[Row]) -> f64 {
        LARGEST / power_of_two(2.0 * largest(gradient))
    }

    /// Beside the scale of the gradient, what steps are multiplied by.
    pub(super) fn unit(&self) -> f64 {
        self.unit
    }

    /// Turns a scaled gradient into the scaled step.
    pub(super) fn solve(&self, rows: &mut [SingleRow]) {
        self.panels.solve(rows);
    }

    /// `to = x - step`, where the step was made of gradients times `scale`.
    #[inline(never)]
    pub(super) fn subtract_step(&self, to: &mut [Row], x: &[Row], step: &[SingleRow], scale: f64) {
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
pub(super) fn round(to: &mut [SingleRow], from: &[Row], scale: f64) {
    for (to, from) in to.as_flattened_mut().iter_mut().zip(from.as_flattened()) {
        *to = (scale * from) as f32;
    }
}
