//! A range of angles, in degrees from 0 to 180.

use super::limits::Limits;
use crate::math::cosine_and_sine_of_degrees;
use serde::de::Deserializer;
use serde::{Deserialize, Serialize, Serializer};

/// In JSON one number, or an array of two, each a number or null for no limit, in degrees. The
/// upper bound of 180 is checked by the declaration of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct AngleRange {
    degrees: Limits,
    /// Cosine and sine of the least angle.
    pub(crate) least: [f64; 2],
    /// Cosine and sine of the greatest angle.
    pub(crate) greatest: [f64; 2],
    /// Whether both limits are equal.
    pub(crate) is_one_angle: bool,
}

impl AngleRange {
    /// Makes a range from limits in degrees.
    pub(crate) fn of(degrees: Limits) -> AngleRange {
        let ends = degrees.ends().map(|end| end.min(180.0));
        let [least, greatest] = ends.map(cosine_and_sine_of_degrees);
        AngleRange { degrees, least, greatest, is_one_angle: ends[0] == ends[1] }
    }
}

impl Serialize for AngleRange {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.degrees.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for AngleRange {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Limits::deserialize(deserializer).map(AngleRange::of)
    }
}
