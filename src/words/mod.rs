//! Words for readers: numbers, lengths, counts and lists, the same on the page and on the command
//! line. Values in files are written elsewhere.
//!
//! Measured values have three significant digits and a true minus sign. What somebody has entered,
//! such as a tolerance, has the digits that were entered. Lengths without meaning for a building
//! are 0.
//!
//! `www/ui/format.ts` has the numbers that the page shows while a shape moves; both read the cases
//! in `tests/data/words.json`.

mod count;
mod length;
mod number;

pub use count::{and_more, count, group_digits, sentence};
pub use length::{
    ROUNDING, area, length, length_like, limit, limit_like, millimetres, millimetres_limit, moved,
    rough_length,
};
pub use number::{brief, decimal, degrees, number, part, rough_degrees, rounded};
