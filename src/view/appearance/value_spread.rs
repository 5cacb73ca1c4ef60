//! The range of the colours of face values, and the distribution of the values, for a legend.
//!
//! The range does not depend on the history: it begins at the tolerance (or at 0 if all values are
//! coloured) and ends at a round number that neither the worst face of the original nor the current
//! worst face exceeds. It is therefore constant during a run that improves the shape, and colours are
//! comparable between pictures. The user can set either end instead.

use super::value_axis::ValueAxis;
use crate::math::round_up;

/// The number of bars of a histogram.
pub const BARS: usize = 36;

/// Smallest range in multiples of the rounding error; nothing finer can be seen or built.
const LEAST_RANGE: f64 = 1000.0;
/// Start of a logarithmic range over all values, relative to its end.
const LOG_RANGE: f64 = 1e-4;
/// On a logarithmic axis, values within the tolerance get the width of this factor.
const LOG_WITHIN: f64 = 0.1;

/// The values that have colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coloured {
    /// All of them.
    All,
    /// Those beyond the tolerance.
    Beyond,
    /// All, of both signs: 0 is the middle of the range.
    Signed,
}

/// What determines a range: the measure, and what the user has chosen.
#[derive(Clone, Copy, Debug)]
pub struct RangeChoice {
    /// The values that have colours.
    pub coloured: Coloured,
    /// Whether equal factors have equal lengths; not for signed values.
    pub logarithmic: bool,
    /// The bound up to which values are within the tolerance.
    pub tolerance: Option<f64>,
    /// The bound below which values are rounding errors.
    pub rounding: f64,
    /// The start of the range; none if it is automatic.
    pub low: Option<f64>,
    /// The end of the range; none if it is automatic.
    pub high: Option<f64>,
    /// The end of the axis; none if it is automatic.
    pub top: Option<f64>,
}

/// The histogram of some values.
#[derive(Clone, Debug, PartialEq)]
pub struct Bars {
    /// The number of faces per bar, #bars.
    pub counts: Vec<u32>,
    /// The greatest absolute value.
    pub greatest: f64,
}

/// The range of the colours, and the distribution of the values.
#[derive(Clone, Debug, PartialEq)]
pub struct ValueSpread {
    /// The values at the first and at the last colour.
    pub range: [f64; 2],
    /// The axis of the bars, which contains the range.
    pub axis: ValueAxis,
    /// The current shape.
    pub now: Bars,
    /// The original shape on the same axis, without faces beyond its ends; none if it is not known.
    pub original: Option<Bars>,
    /// The number of faces with a value.
    pub faces: u32,
    /// The number of faces within the tolerance; all without one.
    pub within: u32,
}

impl ValueSpread {
    /// Chooses the range for the `values` of the faces (#F), NaN for faces without one, and counts
    /// them; `original` are those of the original shape, if known.
    pub fn new(values: &[f32], original: Option<&[f32]>, choice: &RangeChoice) -> ValueSpread {
        let RangeChoice { coloured, tolerance, .. } = *choice;
        let is_signed = coloured == Coloured::Signed;
        let logarithmic = choice.logarithmic && !is_signed;
        let greatest = greatest_of(values);
        let worst =
            greatest.max(original.map_or(0.0, greatest_of)).max(2.0 * tolerance.unwrap_or(0.0));
        let top = round_up(worst.max(LEAST_RANGE * choice.rounding));
        let high = choice.high.unwrap_or(top);
        let beyond = tolerance.filter(|&tolerance| tolerance > 0.0);
        let first = match beyond {
            Some(tolerance) if coloured == Coloured::Beyond => tolerance,
            _ if logarithmic => LOG_RANGE * high,
            _ => 0.0,
        };
        let low = if is_signed { -high } else { choice.low.unwrap_or(first).min(high) };
        let end = choice.top.unwrap_or(top).max(high).max(greatest);
        let begin = match beyond {
            _ if is_signed => -end,
            _ if !logarithmic => 0.0,
            Some(tolerance) => low.min(LOG_WITHIN * tolerance),
            None => low,
        };
        let axis = ValueAxis::new(begin, end, logarithmic);
        // Rounded as the values are.
        let limit = tolerance.map_or(f32::INFINITY, |tolerance| tolerance as f32);
        let count = |counts: &dyn Fn(f32) -> bool| {
            values.iter().filter(|&&value| counts(value)).count() as u32
        };
        ValueSpread {
            range: [low, high],
            axis,
            now: bars(values, &axis),
            original: original.map(|original| bars(original, &axis)),
            faces: count(&|value| !value.is_nan()),
            within: count(&|value| value <= limit),
        }
    }
}

/// Counts the faces per bar along an axis. The first and the last bar include the ends, and the first
/// also smaller values, unless values have both signs and it is an end as well. NaN and values beyond
/// an end are not counted.
fn bars(values: &[f32], axis: &ValueAxis) -> Bars {
    let mut counts = vec![0; BARS];
    // Values equal to the end may have been rounded up.
    let end = f64::from(axis.high as f32) * (1.0 + 1e-6);
    let is_signed = axis.low < 0.0;
    let is_on_axis = |&value: &f64| if is_signed { value.abs() <= end } else { value <= end };
    for value in values.iter().map(|&value| f64::from(value)).filter(is_on_axis) {
        let bar = (axis.part(value) * BARS as f64) as usize;
        counts[bar.min(BARS - 1)] += 1;
    }
    Bars { counts, greatest: greatest_of(values) }
}

/// Returns the greatest absolute value, ignoring NaN.
fn greatest_of(values: &[f32]) -> f64 {
    f64::from(values.iter().fold(0.0, |most: f32, value| most.max(value.abs())))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: RangeChoice = RangeChoice {
        coloured: Coloured::All,
        logarithmic: false,
        tolerance: None,
        rounding: 1e-12,
        low: None,
        high: None,
        top: None,
    };
    const BEYOND: RangeChoice =
        RangeChoice { coloured: Coloured::Beyond, tolerance: Some(0.01), ..ALL };

    fn range(values: &[f32], original: Option<&[f32]>, choice: RangeChoice) -> [f64; 2] {
        ValueSpread::new(values, original, &choice).range
    }

    #[test]
    fn the_range_begins_at_the_tolerance_and_ends_round_beyond_the_worst_face() {
        assert_eq!(range(&[0.0, 0.073], None, BEYOND), [0.01, 0.08]);
        assert_eq!(range(&[0.0, 0.073], None, ALL), [0.0, 0.08]);
        // Within the tolerance there is nothing to colour, but the range is not empty.
        assert_eq!(range(&[0.001], None, BEYOND), [0.01, 0.02]);
        assert_eq!(range(&[], None, RangeChoice { tolerance: None, ..BEYOND }), [0.0, 1e-9]);
    }

    #[test]
    fn during_a_run_that_improves_the_shape_the_range_stays() {
        let original: &[f32] = &[0.5, 7.0];
        for worst in [7.0, 3.0, 0.2, 1e-9] {
            assert_eq!(range(&[0.0, worst], Some(original), BEYOND), [0.01, 8.0]);
        }
        assert_eq!(range(&[0.0, 9.0], Some(original), BEYOND), [0.01, 10.0]);
    }

    #[test]
    fn the_user_sets_either_end_and_the_axis_contains_both_and_all_values() {
        let own = RangeChoice { low: Some(0.02), high: Some(0.5), top: Some(0.1), ..BEYOND };
        let spread = ValueSpread::new(&[0.3], None, &own);
        assert_eq!((spread.range, spread.axis.high), ([0.02, 0.5], 0.5));
        let spread = ValueSpread::new(&[3.0], None, &own);
        assert_eq!((spread.range, spread.axis.high), ([0.02, 0.5], 3.0));
        // The start is never behind the end.
        let crossed = RangeChoice { low: Some(4.0), high: Some(2.0), ..ALL };
        assert_eq!(range(&[3.0], None, crossed), [2.0, 2.0]);
    }

    #[test]
    fn a_logarithmic_axis_has_room_for_what_is_within_the_tolerance() {
        let spread = ValueSpread::new(&[3.0], None, &RangeChoice { logarithmic: true, ..BEYOND });
        assert_eq!((spread.range, spread.axis.low), ([0.01, 3.0], 0.001));
        let all = ValueSpread::new(&[3.0], None, &RangeChoice { logarithmic: true, ..ALL });
        assert_eq!((all.range, all.axis.low), ([LOG_RANGE * 3.0, 3.0], LOG_RANGE * 3.0));
    }

    #[test]
    fn every_face_with_a_value_is_in_one_bar_those_with_the_largest_values_in_the_last() {
        let values = [0.0, 0.5, 1.0, f32::NAN, 2.0];
        let counted = bars(&values, &ValueAxis::new(0.0, 1.0, false)).counts;
        assert_eq!((counted.len(), counted.iter().sum::<u32>(), counted[BARS - 1]), (BARS, 3, 1));
        let choice = RangeChoice { tolerance: Some(0.5), ..ALL };
        let ValueSpread { faces, within, now, original, .. } =
            ValueSpread::new(&values, Some(&values), &choice);
        assert_eq!((faces, within, now.greatest), (4, 2, 2.0));
        assert_eq!(original, Some(now));
    }

    #[test]
    fn values_of_both_signs_have_a_range_around_zero_and_the_largest_is_that_of_either_sign() {
        let values = [-3.0, -1.0, 0.0, 0.5, 2.0, f32::NAN];
        // They have no logarithms.
        let choice = RangeChoice { coloured: Coloured::Signed, logarithmic: true, ..ALL };
        let ValueSpread { range, axis, now, faces, .. } = ValueSpread::new(&values, None, &choice);
        assert_eq!((range, axis), ([-3.0, 3.0], ValueAxis::new(-3.0, 3.0, false)));
        assert_eq!((now.greatest, faces, now.counts.iter().sum::<u32>()), (3.0, 5, 5));
        assert_eq!(now.counts[..BARS / 2].iter().sum::<u32>(), 2);
        // An axis that is fitted to the current values has no bar for those beyond either end.
        let fitted = RangeChoice { high: Some(1.0), top: Some(1.0), ..choice };
        let original = ValueSpread::new(&[0.5, -1.0], Some(&values), &fitted).original;
        let counts = original.expect("it is known").counts;
        assert_eq!((counts.iter().sum::<u32>(), counts[0], counts[BARS - 1]), (3, 1, 0));
    }
}
