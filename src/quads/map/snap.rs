//! From numbers to fixed point: the free unknowns are rounded to 18 fractional bits, of which all
//! coordinates are sums with multiples of a quarter, so that every transition is exact with 20 bits.

use super::seams::Seams;
use crate::quads::{GridMap, MapFault, Side, Transition, UNIT};

/// Bits of the fraction of a free unknown.
const BITS: u32 = 18;
/// Free unknowns are less than this, so that determinants of coordinates fit 128 bits by far.
const MOST: f64 = 1e7;

/// The nearest number that fixed point has for a free unknown.
pub(super) fn snapped(value: f64) -> f64 {
    let scale = f64::from(1u32 << BITS);
    (value * scale + 0.5).floor() / scale
}

/// Rounds a map, in which integer unknowns are integers.
///
/// # Errors
/// If the map is too large for fixed point, or a coefficient is not a multiple of a quarter.
pub(super) fn snap(seams: &Seams, values: &[f64]) -> Result<GridMap, MapFault> {
    let scale = f64::from(1u32 << BITS);
    let fixed = |&value: &f64| (value.abs() < MOST).then(|| (value * scale + 0.5).floor() as i64);
    let values: Option<Vec<i64>> = values.iter().map(fixed).collect();
    let values = values.ok_or(MapFault::OutOfRange)?;
    let mut coordinates = Vec::with_capacity(seams.sums.len());
    for row in &seams.sums {
        let mut sum = 0i64;
        for &(k, c) in row {
            let quarters = 4.0 * c;
            if quarters.fract() != 0.0 || quarters.abs() > MOST {
                return Err(MapFault::OutOfRange);
            }
            let product = values[k as usize].checked_mul(quarters as i64);
            sum = product.and_then(|p| sum.checked_add(p)).ok_or(MapFault::OutOfRange)?;
        }
        coordinates.push(sum);
    }
    let corner = |class: u32| [0, 1].map(|axis| coordinates[2 * class as usize + axis]);
    let corners: Vec<[[i64; 2]; 3]> =
        seams.classes.iter().map(|classes| classes.map(corner)).collect();
    let mut transitions = vec![[Transition::default(); 3]; corners.len()];
    for (&[side, back], &quarter_turns) in seams.cut.iter().zip(&seams.quarter_turns) {
        let turn = Transition { quarter_turns, shift: [0; 2] };
        let at = |Side { triangle, side }: Side, k: usize| corners[triangle][(side + k) % 3];
        let [x, y] = turn.turn(at(side, 0));
        let [to_x, to_y] = at(back, 1);
        let transition = Transition { quarter_turns, shift: [to_x - x, to_y - y] };
        let whole = transition.shift.iter().all(|shift| shift % UNIT == 0);
        if !whole || transition.apply(at(side, 1)) != at(back, 0) {
            return Err(MapFault::OutOfRange);
        }
        transitions[side.triangle][side.side] = transition;
        transitions[back.triangle][back.side] = transition.inverse();
    }
    Ok(GridMap { corners, transitions })
}
