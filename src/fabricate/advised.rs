//! Values of settings that are advised, each with the name of a button that sets it.

use serde::Serialize;

/// A value of a setting.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct AdvisedValue {
    /// The name of a button that sets it.
    pub label: String,
    /// The setting, by its id among those of Build.
    pub setting: &'static str,
    /// The value, as in a scene; null for what an absent one stands for.
    pub value: Option<SettingValue>,
}

/// A value of a setting, as in a scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum SettingValue {
    /// A number, in the unit of the setting.
    Number(f64),
    /// One of the words of a choice.
    Word(&'static str),
}

impl std::fmt::Display for SettingValue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            SettingValue::Number(number) => number.fmt(f),
            SettingValue::Word(word) => f.write_str(word),
        }
    }
}

impl AdvisedValue {
    pub(super) fn number(label: String, setting: &'static str, value: f64) -> AdvisedValue {
        AdvisedValue { label, setting, value: Some(SettingValue::Number(value)) }
    }

    pub(super) fn scale(denominator: f64) -> AdvisedValue {
        AdvisedValue::number(format!("Scale 1:{denominator}"), "scale", denominator)
    }
}
