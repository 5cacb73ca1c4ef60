//! Numbers for readers: three digits, and lengths no finer than a hundredth of a mm.

use crate::fabricate::file::places;

/// Smaller values are shown as less than this, in mm.
const LEAST_MM: f64 = 0.01;

/// A number in mm or degrees.
pub(super) fn short(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if size < LEAST_MM {
        format!("< {LEAST_MM}")
    } else if size >= 99.95 {
        places(value, 0)
    } else {
        let most = [(9.995, 1), (0.9995, 2), (0.09995, 3)];
        places(value, most.into_iter().find(|(from, _)| size >= *from).map_or(4, |(_, most)| most))
    }
}

/// A length in mm, or in metres from 10 m.
pub(super) fn length(mm: f64) -> String {
    if mm.abs() < 1e4 { format!("{} mm", short(mm)) } else { format!("{} m", short(mm / 1000.0)) }
}

/// An area in mm2, in square metres.
pub(super) fn area(mm2: f64) -> String {
    format!("{} m\u{b2}", short(mm2 / 1e6))
}

/// A number of the build check with its unit.
pub(super) fn with_unit(value: f64, unit: &str) -> String {
    if unit == "deg" { format!("{}\u{b0}", short(value)) } else { length(value) }
}

/// A sentence with its first letter in upper case, if it is ASCII.
pub(super) fn sentence(words: &str) -> String {
    let mut words = words.to_owned();
    if let Some(first) = words.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    words
}

/// A number with its noun.
pub(super) fn count(number: usize, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_digits() {
        let found = [0.0, 0.004, -0.05, 0.1234, 9.999, 12.34, 99.96, 1234.4].map(short);
        assert_eq!(found, ["0", "< 0.01", "-0.05", "0.123", "10", "12.3", "100", "1234"]);
        assert_eq!([length(9_999.0), length(12_345.0)], ["9999 mm", "12.3 m"]);
    }
}
