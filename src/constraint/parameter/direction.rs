//! A direction in space, from the scene file.
//!
//! In JSON an array of three numbers, not all zero, of any length.

use crate::math::{Lane, Vec3};
use serde::de::{Deserializer, Error, Expected, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use std::fmt;

/// A direction: the numbers of the file, and the unit vector.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(into = "[f64; 3]")]
pub(crate) struct Direction {
    given: [f64; 3],
    unit: Vec3<f64>,
}

impl Direction {
    /// Returns none if all numbers are zero or one is not finite.
    pub(crate) fn new(given: [f64; 3]) -> Option<Direction> {
        if !given.iter().all(|x| x.is_finite()) {
            return None;
        }
        let (_, unit) = Vec3::from(given).length_and_direction();
        unit.map(|unit| Direction { given, unit })
    }

    /// The unit vector, the same in every lane.
    #[inline(always)]
    pub(crate) fn unit<S: Lane>(&self) -> Vec3<S> {
        Vec3::new(S::splat(self.unit.x), S::splat(self.unit.y), S::splat(self.unit.z))
    }
}

impl<'de> Deserialize<'de> for Direction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Direction, D::Error> {
        deserializer.deserialize_seq(DirectionVisitor)
    }
}

struct DirectionVisitor;

impl<'de> Visitor<'de> for DirectionVisitor {
    type Value = Direction;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a direction [x, y, z], not all zero")
    }

    /// Number by number, so that an error has the path of the one at fault.
    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Direction, A::Error> {
        let mut numbers: Vec<f64> = Vec::new();
        while let Some(number) = array.next_element()? {
            numbers.push(number);
        }
        let given = <[f64; 3]>::try_from(&numbers[..])
            .map_err(|_| A::Error::invalid_length(numbers.len(), &self))?;
        let [x, y, z] = given;
        let expected: &dyn Expected = &self;
        let none = || A::Error::custom(format_args!("found [{x}, {y}, {z}], expected {expected}"));
        Direction::new(given).ok_or_else(none)
    }
}

impl From<Direction> for [f64; 3] {
    fn from(direction: Direction) -> [f64; 3] {
        direction.given
    }
}

#[cfg(test)]
mod tests {
    use super::Direction;
    use crate::math::Vec3;
    use serde_json::json;

    fn read(value: serde_json::Value) -> Result<Direction, String> {
        serde_json::from_value(value).map_err(|error| error.to_string())
    }

    #[test]
    fn keeps_what_the_file_said_and_has_length_one() {
        for scale in [1.0, -5e-324, 1e-310, 1e-200, 1e200, 1.7e308] {
            let direction = read(json!([0, scale, -scale])).unwrap();
            assert_eq!(serde_json::to_value(direction).unwrap(), json!([0.0, scale, -scale]));
            let half = 0.5f64.sqrt() * f64::signum(scale);
            let error = direction.unit::<f64>() - Vec3::new(0.0, half, -half);
            assert!(error.length() <= 1e-15, "{scale}: {direction:?}");
        }
    }

    #[test]
    fn says_what_is_no_direction() {
        for (value, words) in [
            (json!([0, -0.0, 0]), "found [0, -0, 0]"),
            (json!([1, 2]), "length 2, expected a direction [x, y, z]"),
            (json!([1, 2, 3, 4]), "length 4, expected a direction [x, y, z]"),
            (json!([1, 2, "3"]), "\"3\""),
            (json!([1, null, 3]), "null"),
            (json!("up"), "\"up\", expected a direction [x, y, z]"),
            (json!(1), "`1`, expected a direction [x, y, z]"),
        ] {
            let message = read(value).unwrap_err();
            assert!(message.contains(words), "{message}: expected {words}");
        }
        assert_eq!(Direction::new([1.0, f64::NAN, 0.0]), None);
        assert_eq!(Direction::new([1.0, f64::INFINITY, 0.0]), None);
    }
}
