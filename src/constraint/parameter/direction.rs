//! A direction in space, from the scene file.
//!
//! In JSON an array of three numbers, not all zero, of any length.

use crate::math::{Lane, Vec3};
use serde::de::{self, Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer};
use std::fmt;

/// A direction: the numbers of the file, and the unit vector.
#[derive(Clone, Copy, Debug, PartialEq)]
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

impl Serialize for Direction {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.given.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Direction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(DirectionVisitor)
    }
}

struct DirectionVisitor;

impl<'de> Visitor<'de> for DirectionVisitor {
    type Value = Direction;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a direction [x, y, z], not all zero")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Direction, A::Error> {
        let mut given = [0.0; 3];
        for (k, number) in given.iter_mut().enumerate() {
            let next = array.next_element()?;
            *number = next.ok_or_else(|| de::Error::invalid_length(k, &self))?;
        }
        if array.next_element::<de::IgnoredAny>()?.is_some() {
            return Err(de::Error::custom(format_args!(
                "found an array of more than three, expected {}",
                &self as &dyn de::Expected
            )));
        }
        Direction::new(given).ok_or_else(|| {
            let [x, y, z] = given;
            de::Error::custom(format_args!(
                "found [{x}, {y}, {z}], expected {}",
                &self as &dyn de::Expected
            ))
        })
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
            (json!([1, 2]), "length 2"),
            (json!([1, 2, 3, 4]), "more than three"),
            (json!([1, 2, "3"]), "\"3\""),
            (json!([1, null, 3]), "null"),
            (json!("up"), "expected a direction [x, y, z]"),
            (json!(1), "expected a direction [x, y, z]"),
        ] {
            let message = read(value).unwrap_err();
            assert!(message.contains(words), "{message}: expected {words}");
        }
        assert_eq!(Direction::new([1.0, f64::NAN, 0.0]), None);
        assert_eq!(Direction::new([1.0, f64::INFINITY, 0.0]), None);
    }
}
