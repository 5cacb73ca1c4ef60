//! Parameters of kinds: declaration (key, unit, default, forms and range), checks, and value types
//! shared by several kinds.

mod direction;
mod limits;
mod target;

pub(crate) use direction::Direction;
pub(crate) use limits::{AngleRange, Limits};
pub(crate) use target::Target;

use crate::json::JsonError;
use serde::Serialize;
use serde_json::Value;

/// The declaration of a parameter of a kind.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Param {
    /// The key in scene files.
    pub id: &'static str,
    /// The name on the page.
    pub label: &'static str,
    /// `"length"`, `"area"`, `"volume"`, `"degrees"`, or empty for a plain number.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "\"length\" | \"area\" | \"volume\" | \"degrees\" | \"\"")
    )]
    pub unit: &'static str,
    /// The value when the key is absent.
    pub default: ParamValue,
    /// The accepted forms, including that of the default.
    pub forms: &'static [Form],
    /// Each word that has another name on the page, with that name.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub labels: &'static [(&'static str, &'static str)],
    /// Least and greatest number, which also bound the ends of a range. Infinity is null in JSON.
    pub range: [f64; 2],
}

/// The range of parameters with unlimited numbers, or none.
const UNLIMITED: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

impl Param {
    /// A number in a range.
    pub(crate) const fn number(
        id: &'static str,
        label: &'static str,
        unit: &'static str,
        default: f64,
        range: [f64; 2],
    ) -> Param {
        let default = ParamValue::Number(default);
        Param { id, label, unit, default, forms: &[Form::Number], labels: &[], range }
    }

    /// A number, or a lower and an upper limit, in a range.
    pub(crate) const fn limits(
        id: &'static str,
        label: &'static str,
        unit: &'static str,
        default: f64,
        range: [f64; 2],
    ) -> Param {
        let forms = &[Form::Number, Form::Range];
        Param { forms, ..Param::number(id, label, unit, default, range) }
    }

    /// One of several words.
    pub(crate) const fn word(
        id: &'static str,
        label: &'static str,
        default: &'static str,
        words: &'static [Form],
    ) -> Param {
        let default = ParamValue::Word(default);
        Param { id, label, unit: "", default, forms: words, labels: &[], range: UNLIMITED }
    }

    /// Whether a number is in the range.
    pub(crate) fn allows(&self, number: f64) -> bool {
        (self.range[0]..=self.range[1]).contains(&number)
    }

    /// The numbers in the range, in words.
    pub(crate) fn range_in_words(&self) -> String {
        match self.range {
            UNLIMITED => "a number".to_owned(),
            [least, f64::INFINITY] => format!("a number from {least}"),
            [least, greatest] => format!("a number from {least} to {greatest}"),
        }
    }

    /// The parameter, with other names for some of its words.
    pub(crate) const fn called(self, labels: &'static [(&'static str, &'static str)]) -> Param {
        Param { labels, ..self }
    }

    /// A direction, by default the best fit.
    pub(crate) const fn direction(id: &'static str, label: &'static str) -> Param {
        let forms = &[Form::Nothing, Form::Vector];
        let default = ParamValue::Nothing;
        Param { id, label, unit: "", default, forms, labels: &[], range: UNLIMITED }
    }

    /// A radius, by default the best fit.
    pub(crate) const RADIUS: Param = Param {
        id: "radius",
        label: "Radius",
        unit: "length",
        default: ParamValue::Nothing,
        forms: &[Form::Nothing, Form::Number, Form::Range],
        labels: &[],
        range: [0.0, f64::INFINITY],
    };
}

/// A form that the value of a parameter may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// One number.
    Number,
    /// A lower and an upper limit, each null for no limit.
    Range,
    /// Three numbers, not all zero: a direction.
    Vector,
    /// This word.
    Word(&'static str),
    /// Null: the best fit.
    Nothing,
}

impl Form {
    /// Returns the words of a choice, each beside what it stands for.
    pub(crate) const fn words<T, const N: usize>(words: &[(&'static str, T)]) -> [Form; N] {
        let mut forms = [Form::Nothing; N];
        let mut i = 0;
        while i < N {
            forms[i] = Form::Word(words[i].0);
            i += 1;
        }
        forms
    }
}

/// The value of a parameter, as written in JSON.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(untagged)]
pub enum ParamValue {
    /// See [`Form::Number`].
    Number(f64),
    /// See [`Form::Range`].
    Range([Option<f64>; 2]),
    /// See [`Form::Vector`].
    Vector([f64; 3]),
    /// See [`Form::Word`].
    Word(&'static str),
    /// See [`Form::Nothing`].
    Nothing,
}

/// Checks that the numbers among the values of `params` are in their declared ranges.
pub(crate) fn check_ranges(params: &[Param], values: &Value) -> Result<(), KindError> {
    for param in params {
        let check = |value: &Value, path: String| match value.as_f64() {
            Some(number) if !param.allows(number) => {
                let message = format!("found {number}, expected {}", param.range_in_words());
                Err(KindError::Params { path, message })
            }
            _ => Ok(()),
        };
        match &values[param.id] {
            Value::Array(several) => (0..)
                .zip(several)
                .try_for_each(|(i, value)| check(value, format!("{}[{i}]", param.id)))?,
            value => check(value, param.id.to_owned())?,
        }
    }
    Ok(())
}

/// The error of [`Kind::new`](crate::constraint::Kind::new).
#[derive(Clone, Debug, PartialEq)]
pub enum KindError {
    /// No kind has that id.
    Unknown,
    /// A parameter is unknown, missing or of the wrong type.
    Params {
        /// The JSON path below the constraint, such as `scale[0]`.
        path: String,
        /// The fault, and the expected value.
        message: String,
    },
}

impl From<JsonError> for KindError {
    fn from(JsonError { path, message }: JsonError) -> KindError {
        KindError::Params { path, message }
    }
}
