//! An amount, given or as at rest.

use super::limits::Limits;
use super::{Form, Param, ParamValue};
use serde::de::{self, Deserializer, IntoDeserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer};
use std::fmt;

/// In JSON the word `"rest"`, a number, or an array of two.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Target {
    /// As at rest.
    #[default]
    Rest,
    /// Within these limits.
    Within(Limits),
}

impl Target {
    /// The word for [`Target::Rest`].
    pub(crate) const REST: &'static str = "rest";

    /// Returns the parameters of a kind with a target: the amount, named by `unit`, and `strain`.
    pub(crate) const fn params(
        unit: &'static str,
        label: &'static str,
        strain_label: &'static str,
    ) -> [Param; 2] {
        [
            Param {
                id: unit,
                label,
                unit,
                default: ParamValue::Word(Target::REST),
                forms: &[Form::Word(Target::REST), Form::Number, Form::Range],
                labels: &[(Target::REST, "original")],
                range: [0.0, f64::INFINITY],
            },
            Param::limits("strain", strain_label, "", 1.0, [0.0, f64::INFINITY]),
        ]
    }

    /// Returns the least and greatest size, a length whose square is the area or whose cube is the
    /// volume. `root` computes that square or cube root, `rest` is the size at rest, `unit` the
    /// size of a unit area or volume. For [`Target::Rest`] the limits are those of `strain`,
    /// relative to the rest shape.
    pub(crate) fn sizes(
        self,
        strain: Limits,
        root: impl Fn(f64) -> f64,
        [rest, unit]: [f64; 2],
    ) -> [f64; 2] {
        let (limits, size) = match self {
            Target::Rest => (strain, rest),
            Target::Within(limits) => (limits, unit),
        };
        // Keeps infinity for a rest size of zero, where the product would not be a number.
        limits.ends().map(|end| if end.is_finite() { root(end) * size } else { end })
    }
}

impl Serialize for Target {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Target::Rest => serializer.serialize_str(Target::REST),
            Target::Within(limits) => limits.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for Target {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(TargetVisitor)
    }
}

struct TargetVisitor;

impl<'de> Visitor<'de> for TargetVisitor {
    type Value = Target;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\"rest\", a number from 0, or [least, greatest], each a number or null")
    }

    fn visit_str<E: de::Error>(self, word: &str) -> Result<Target, E> {
        if word == Target::REST {
            return Ok(Target::Rest);
        }
        Err(E::invalid_value(de::Unexpected::Str(word), &self))
    }
    fn visit_u64<E: de::Error>(self, amount: u64) -> Result<Target, E> {
        self.visit_f64(amount as f64)
    }
    fn visit_i64<E: de::Error>(self, amount: i64) -> Result<Target, E> {
        self.visit_f64(amount as f64)
    }
    fn visit_f64<E: de::Error>(self, amount: f64) -> Result<Target, E> {
        Limits::deserialize(amount.into_deserializer()).map(Target::Within)
    }
    fn visit_seq<A: SeqAccess<'de>>(self, array: A) -> Result<Target, A::Error> {
        Limits::deserialize(de::value::SeqAccessDeserializer::new(array)).map(Target::Within)
    }
}
