//! A direction in space, from the scene file.
//!
//! In JSON an array of three numbers, not all zero, of any length.

use crate::json::JsonError;
use crate::math::{Lane, Vec3};
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// A direction: the numbers of the file, and the unit vector.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Value", into = "[f64; 3]")]
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

impl TryFrom<Value> for Direction {
    type Error = String;

    fn try_from(value: Value) -> Result<Direction, String> {
        const EXPECTED: &str = "a direction [x, y, z], not all zero";
        let Ok(given) = <[f64; 3]>::deserialize(&value) else {
            return Err(JsonError::found(&value, EXPECTED).message);
        };
        let [x, y, z] = given;
        Direction::new(given).ok_or_else(|| format!("found [{x}, {y}, {z}], expected {EXPECTED}"))
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
            (json!([1, 2]), "expected a direction [x, y, z]"),
            (json!([1, 2, 3, 4]), "expected a direction [x, y, z]"),
            (json!([1, 2, "3"]), "expected a direction [x, y, z]"),
            (json!([1, null, 3]), "expected a direction [x, y, z]"),
            (json!("up"), "found \"up\", expected a direction [x, y, z]"),
            (json!(1), "found 1, expected a direction [x, y, z]"),
        ] {
            let message = read(value).unwrap_err();
            assert!(message.contains(words), "{message}: expected {words}");
        }
        assert_eq!(Direction::new([1.0, f64::NAN, 0.0]), None);
        assert_eq!(Direction::new([1.0, f64::INFINITY, 0.0]), None);
    }
}
