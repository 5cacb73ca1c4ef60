//! Limits of a non-negative quantity, such as a scale, a length or a radius, or of an angle.
//!
//! In JSON one number for an exact value, or an array of two, each a number or null for no limit.

use crate::math::{Lane, cosine_and_sine_of_degrees};
use serde::de::{Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer, de};
use std::fmt;

/// Least and greatest value; none for no limit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Limits([Option<f64>; 2]);

impl Limits {
    /// Both limits equal to `amount`.
    pub(crate) const fn exactly(amount: f64) -> Limits {
        Limits([Some(amount); 2])
    }

    /// Returns the limits, with zero and infinity for no limit.
    pub(crate) fn ends(self) -> [f64; 2] {
        let [least, greatest] = self.0;
        [least.unwrap_or(0.0), greatest.unwrap_or(f64::INFINITY)]
    }

    /// Returns the amount nearest to `amount` within the limits.
    #[inline(always)]
    pub(crate) fn clamp<S: Lane>(self, amount: S) -> S {
        self.clamp_times(amount, S::one())
    }

    /// As [`Limits::clamp`], with both limits times `unit`.
    #[inline(always)]
    pub(crate) fn clamp_times<S: Lane>(self, amount: S, unit: S) -> S {
        let [least, greatest] = self.0;
        let amount = amount.max(S::splat(least.unwrap_or(0.0)) * unit);
        greatest.map_or(amount, |greatest| amount.min(S::splat(greatest) * unit))
    }
}

impl Serialize for Limits {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            [Some(least), Some(greatest)] if least == greatest => serializer.serialize_f64(least),
            limits => limits.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for Limits {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(LimitsVisitor)
    }
}

struct LimitsVisitor;

impl<'de> Visitor<'de> for LimitsVisitor {
    type Value = Limits;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number from 0, or [least, greatest], each a number from 0 or null")
    }

    fn visit_u64<E: de::Error>(self, amount: u64) -> Result<Limits, E> {
        self.visit_f64(amount as f64)
    }
    fn visit_i64<E: de::Error>(self, amount: i64) -> Result<Limits, E> {
        self.visit_f64(amount as f64)
    }
    fn visit_f64<E: de::Error>(self, amount: f64) -> Result<Limits, E> {
        LimitFrom(0.0).visit_f64(amount).map(|limit| Limits([limit; 2]))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<Limits, A::Error> {
        let mut limits = [None; 2];
        let mut least = 0.0;
        for (k, limit) in limits.iter_mut().enumerate() {
            let next = array.next_element_seed(LimitFrom(least))?;
            *limit = next.ok_or_else(|| de::Error::invalid_length(k, &self))?;
            least = limit.unwrap_or(least);
        }
        match array.next_element::<de::IgnoredAny>()? {
            Some(_) => Err(de::Error::custom(format_args!(
                "found an array of more than two, expected {}",
                &self as &dyn de::Expected
            ))),
            None => Ok(Limits(limits)),
        }
    }
}

/// Deserialises one limit that is at least this.
struct LimitFrom(f64);

impl<'de> de::DeserializeSeed<'de> for LimitFrom {
    type Value = Option<f64>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Option<f64>, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl Visitor<'_> for LimitFrom {
    type Value = Option<f64>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a number from {}, or null for no limit", self.0)
    }
    fn visit_unit<E>(self) -> Result<Option<f64>, E> {
        Ok(None)
    }
    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Option<f64>, E> {
        self.visit_f64(value as f64)
    }
    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Option<f64>, E> {
        self.visit_f64(value as f64)
    }
    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Option<f64>, E> {
        if value >= self.0 && value.is_finite() {
            // Turns -0 into +0.
            return Ok(Some(value + 0.0));
        }
        Err(E::custom(format_args!("found {value}, expected {}", &self as &dyn de::Expected)))
    }
}

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
