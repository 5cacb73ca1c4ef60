//! Coordinates and vertex numbers of mesh files: parsing, and formatting as text that reads back to
//! the same bits.

use crate::mesh::{ElementKind, ProblemKind};
use std::fmt;

/// Parses a coordinate; returns NaN if it is not a finite number, and the problem, if any.
pub(crate) fn coordinate(word: &str) -> (f64, Option<ProblemKind>) {
    let (value, problem) = match word.parse::<f64>() {
        Ok(value) => (value, None),
        // Older Windows runtime libraries print `1.#IND` and `-1.#INF` for non-finite numbers.
        Err(_) if word.contains('#') => (f64::NAN, None),
        Err(_) => match word.replacen(',', ".", 1).parse::<f64>() {
            Ok(value) => (value, Some(ProblemKind::DecimalComma)),
            Err(_) => return (f64::NAN, Some(ProblemKind::MalformedCoordinate)),
        },
    };
    let (value, fault) = of_number(value);
    (value, fault.or(problem))
}

/// Returns a coordinate, and the problem if it is not finite; it is NaN then.
pub(super) fn of_number(x: f64) -> (f64, Option<ProblemKind>) {
    match x.is_finite() {
        true => (x, None),
        false => (f64::NAN, Some(ProblemKind::NonFiniteCoordinate)),
    }
}

/// Parses a vertex number. Numbers beyond the type are clamped, since they are out of range anyway.
pub(crate) fn whole(word: &str) -> Option<i32> {
    let number: i64 = word.parse().ok()?;
    Some(number.clamp(i32::MIN.into(), i32::MAX.into()) as i32)
}

/// Vertex numbering of a format.
#[derive(Clone, Copy)]
pub(crate) enum Numbering {
    ZeroBased,
    OneBased,
    /// One-based; negative numbers count back from the last of the vertices read so far.
    OneBasedOrBack {
        read: usize,
    },
}

impl Numbering {
    /// Returns the zero-based index, less than `vertices`, of the vertex `number`, which is a
    /// corner of an `element`.
    pub(crate) fn vertex(
        self,
        number: Option<i32>,
        vertices: usize,
        element: ElementKind,
    ) -> Result<u32, ProblemKind> {
        let number = i64::from(number.ok_or(ProblemKind::MalformedCorner(element))?);
        let index = match self {
            Numbering::ZeroBased => number,
            _ if number == 0 => return Err(ProblemKind::CornerZero(element)),
            Numbering::OneBasedOrBack { read } if number < 0 => read as i64 + number,
            _ => number - 1,
        };
        match (0..vertices as i64).contains(&index) {
            true => Ok(index as u32),
            false => Err(ProblemKind::CornerOutOfRange(element)),
        }
    }
}

/// Displays the shortest decimal that reads back to the same bits: plain from 1e-5 to below 1e16,
/// else with an exponent, to avoid long runs of zeros.
#[derive(Clone, Copy)]
pub struct Decimal(pub f64);

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Decimal(x) = *self;
        match x == 0.0 || (1e-5..1e16).contains(&x.abs()) {
            true => write!(f, "{x}"),
            false => write!(f, "{x:e}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_read_in_every_form_that_means_one_number() {
        for (word, value) in
            [("2.", 2.0), ("+.5", 0.5), ("-1E2", -100.0), ("2.e-1", 0.2), ("1e-400", 0.0)]
        {
            assert_eq!(coordinate(word), (value, None), "{word}");
        }
        assert_eq!(coordinate("-0,046"), (-0.046, Some(ProblemKind::DecimalComma)));
    }

    #[test]
    fn a_bad_coordinate_is_told_from_one_that_is_not_finite() {
        for word in ["", "x", "3.1+e2", "1,234.5", "1,2,3", "0x10", "1_000"] {
            let (value, problem) = coordinate(word);
            assert!(value.is_nan() && problem == Some(ProblemKind::MalformedCoordinate), "{word}");
        }
        for word in ["nan", "-nan", "INF", "-infinity", "1.#IND", "-1.#INF", "1e999", "1,e999"] {
            let (value, problem) = coordinate(word);
            assert!(value.is_nan() && problem == Some(ProblemKind::NonFiniteCoordinate), "{word}");
        }
    }

    #[test]
    fn vertex_numbers_mean_the_same_vertex_in_every_numbering() {
        let vertex =
            |numbering: Numbering, word| numbering.vertex(whole(word), 4, ElementKind::Face);
        let back = Numbering::OneBasedOrBack { read: 3 };
        assert_eq!(vertex(Numbering::ZeroBased, "2"), Ok(2));
        assert_eq!(vertex(Numbering::OneBased, "3"), Ok(2));
        assert_eq!(vertex(back, "3"), Ok(2));
        assert_eq!(vertex(back, "-1"), Ok(2));
        let out_of_range = Err(ProblemKind::CornerOutOfRange(ElementKind::Face));
        for (numbering, word) in [
            (Numbering::ZeroBased, "4"),
            (Numbering::ZeroBased, "-1"),
            (Numbering::OneBased, "5"),
            (Numbering::OneBased, "-1"),
            (back, "-4"),
            (back, "99999999999"),
        ] {
            assert_eq!(vertex(numbering, word), out_of_range, "{word}");
        }
        assert_eq!(vertex(back, "0"), Err(ProblemKind::CornerZero(ElementKind::Face)));
        assert_eq!(vertex(back, "1.5"), Err(ProblemKind::MalformedCorner(ElementKind::Face)));
    }

    #[test]
    fn what_is_written_is_short_and_reads_back() {
        for (x, text) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (1.0, "1"),
            (-0.1, "-0.1"),
            (1e-5, "0.00001"),
            (9.9e-6, "9.9e-6"),
            (9_999_999_999_999_998.0, "9999999999999998"),
            (1e16, "1e16"),
            (-2.5e300, "-2.5e300"),
            (5e-324, "5e-324"),
        ] {
            assert_eq!(Decimal(x).to_string(), text);
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), f64::to_bits(x));
        }
    }
}
