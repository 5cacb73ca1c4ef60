//! The declaration of a parameter: its key, unit, default and the values it takes.

use serde::Serialize;

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
    /// The accepted forms; that of the default is one of them.
    pub forms: &'static [Form],
    /// Least and greatest number, also at the ends of a range. JSON has null for infinity.
    pub range: [f64; 2],
}

/// A form that the value of a parameter may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// One number.
    Number,
    /// From and to, either end null for no limit.
    Range,
    /// Three numbers, not all zero: a direction.
    Vector,
    /// This word.
    Word(&'static str),
    /// Null: whatever fits best.
    Nothing,
}

/// The value of a parameter, as in JSON.
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
