//! Similar (paper section 3.2): the rest points, moved by the closest rotation, uniform scale and
//! translation (Umeyama 1991), with the scale between two limits.

use super::{Arity, Info, Param, ParamValue, Projection};
use crate::math::{Alignment, Lane, Vec3};
use serde::de::{self, Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};
use std::fmt;

/// The vertices keep their rest shape up to its size: it may move, turn and grow, not bend or flip
/// over.
///
/// The rotation does not depend on the scale, and the distance is a parabola in the scale, so that
/// clamping the best scale is exact.
///
/// Degenerate shapes are treated as by `rigid`. Vertices that all coincide, and a rest shape that has
/// no size, give one point, unless the least scale asks for more.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Similar {
    /// Least and greatest scale.
    scale: ScaleLimits,
}

impl Projection for Similar {
    const INFO: Info = Info {
        id: "similar",
        label: "Similar",
        summary: "The vertices keep their rest shape up to its size, and so all its angles.",
        paper: "3.2",
        arity: Arity::AtLeast(2),
        exact: true,
        measure: None,
        colour: [0, 145, 160],
        params: &[Param {
            id: "scale",
            label: "Scale",
            unit: "",
            default: ParamValue::Range([None, None]),
            range: [0.0, f64::INFINITY],
        }],
    };

    const READS_REST: bool = true;

    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let alignment = Alignment::of(rest, v);
        let scale = self.scale.clamp(alignment.scale);
        for (r, p) in rest.iter().zip(projected) {
            *p = alignment.turn(*r) * scale;
        }
        alignment.accurate.all_greater(S::zero())
    }

    fn careful(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let alignment = Alignment::careful(rest, v);
        let scale = self.scale.clamp(alignment.scale);
        for (r, p) in rest.iter().zip(v) {
            *p = alignment.turn(*r) * scale;
        }
    }
}

/// Least and greatest scale of the rest shape; none is no limit. In JSON an array of two, each a
/// number from 0 or null.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
struct ScaleLimits([Option<f64>; 2]);

impl ScaleLimits {
    #[inline(always)]
    fn clamp<S: Lane>(self, scale: S) -> S {
        let [least, greatest] = self.0;
        let scale = scale.max(S::splat(least.unwrap_or(0.0)));
        greatest.map_or(scale, |greatest| scale.min(S::splat(greatest)))
    }
}

impl<'de> Deserialize<'de> for ScaleLimits {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(LimitsVisitor)
    }
}

struct LimitsVisitor;

impl<'de> Visitor<'de> for LimitsVisitor {
    type Value = ScaleLimits;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("[least, greatest], each a number from 0 or null")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut array: A) -> Result<ScaleLimits, A::Error> {
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
            None => Ok(ScaleLimits(limits)),
        }
    }
}

/// Reads one limit that is not below this one.
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
            // Zero has one sign.
            return Ok(Some(value + 0.0));
        }
        Err(E::custom(format_args!("found {value}, expected {}", &self as &dyn de::Expected)))
    }
}
