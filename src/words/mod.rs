//! Words for readers: numbers, lengths, counts and lists, the same on the page and on the command
//! line. Values in files are written elsewhere.
//!
//! Measured values have three significant digits and a true minus sign. What somebody has entered,
//! such as a tolerance, has the digits that were entered. Lengths below a
//! thousandth of a millimetre are 0, where the unit is known: they mean nothing for a building.
//!
//! The page has it in a small module of its own, since what follows the hand is written on its thread at
//! once, where the engine is not: functions are exported where they are, or with other arguments in
//! `web/words`.
//!
//! | file | holds |
//! |---|---|
//! | `number` | numbers without a unit, angles, times, fractions |
//! | `length` | lengths with their units, coordinates, displacements |
//! | `typed_length` | lengths as people type them |
//! | `units` | the units of length |
//! | `measure_unit` | the units of measures of a mesh, and which values are rounding errors |
//! | `count` | counts with their nouns, lists, sentences |

#![cfg(any(feature = "engine", feature = "words"))]

mod count;
mod length;
mod measure_unit;
mod number;
mod typed_length;
mod units;

pub use count::{and_more, count, group_digits, is_or_are, sentence};
pub use length::{
    ComparedLengths, ROUNDING, area, area_of, compared_lengths, coordinate, decimals_for,
    displacement, length, length_like, limit, limit_like, millimetres, millimetres_limit, moved,
    number_in, range_in, rough_length,
};
pub use measure_unit::{MeasureUnit, WrittenUnit, energy_or_zero};
pub use number::{
    brief, decimal, degrees, duration, megabytes, number, part, power_of_ten, ratio, rough_degrees,
    rounded, signed_part,
};
pub use typed_length::{NotALength, TypedLength};
pub use units::{LengthUnit, UNITS};
