//! What is declared of a setting of Build, and the checks that follow from it.

use super::choice::Product;
use super::settings::BuildSettings;
use crate::json::from_value;
use crate::scene::SceneError;
use serde::Serialize;
use serde_json::{Map, Value};

/// A declared setting of Build. Hosts make their forms, options and lists of them.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct BuildSetting {
    /// Its path in [`BuildSettings`], such as `kerf`, `sheet[0]` or `limits.warp`.
    pub id: &'static str,
    /// Its name, without a unit.
    pub label: &'static str,
    /// What it does, in one sentence.
    pub summary: &'static str,
    /// The heading under which hosts list it.
    pub group: BuildGroup,
    /// The products that it concerns.
    pub products: &'static [Product],
    /// The values that it may have.
    pub form: BuildForm,
    /// What an absent value (null) stands for; empty if it may not be absent.
    pub absent: &'static str,
}

/// The heading of a group of settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum BuildGroup {
    /// What is made, and how large: never folded.
    #[serde(rename = "Model")]
    Model,
    /// What the parts are like.
    #[serde(rename = "Parts")]
    Parts,
    /// The offset, which has controls of its own on the page.
    #[serde(rename = "Offset")]
    Offset,
    /// Cutting and the room on sheets.
    #[serde(rename = "Cutting")]
    Cutting,
    /// What makes two parts of one type.
    #[serde(rename = "Types of parts")]
    Types,
    /// Names and files.
    #[serde(rename = "Names and files")]
    Files,
    /// Limits of the build check.
    #[serde(rename = "Limits of the check")]
    Limits,
}

/// The values that a setting may have.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(tag = "type", rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum BuildForm {
    /// A number.
    Number {
        /// Its unit.
        unit: BuildUnit,
        /// The least and the greatest; a range on both sides of 0 excludes 0.
        range: [f64; 2],
    },
    /// One of several words.
    Choice {
        /// The words.
        options: &'static [BuildOption],
    },
    /// True or false.
    Switch,
    /// Any text.
    Text,
    /// Edges of the mesh, each by its two vertices.
    Edges,
}

/// The unit of a declared number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum BuildUnit {
    /// None.
    #[serde(rename = "")]
    Plain,
    /// That of the mesh.
    Mesh,
    /// Millimetres of the sheet, the material or, where the setting says so, the building.
    Mm,
    /// Degrees.
    Degrees,
}

/// A word that a setting may have.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct BuildOption {
    /// The word in files and on the command line.
    pub word: &'static str,
    /// Its name.
    pub label: &'static str,
    /// What it does, if its name does not say it; else empty.
    pub summary: &'static str,
}

/// The least of a number that must be positive.
pub(super) const ABOVE_0: f64 = f64::MIN_POSITIVE;

impl BuildSetting {
    /// Its name among the options of the command line; none for a part of an option.
    pub fn option(&self) -> Option<String> {
        (!self.id.contains('[')).then(|| format!("--{}", self.id.replace(['.', '_'], "-")))
    }

    /// Its value in settings as in a scene, or null.
    pub(super) fn value_in(&self, settings: &Value) -> Value {
        settings.pointer(&pointer(self.id)).cloned().unwrap_or_default()
    }

    /// What it accepts, in words: `a number from 0`, `corner or face or edge`.
    pub fn expected(&self) -> String {
        match self.form {
            BuildForm::Number { range: [least, _], .. } if least < 0.0 => {
                "a number that is not 0".to_owned()
            }
            BuildForm::Number { range: [least, _], .. } if least > 0.0 => {
                "a number above 0".to_owned()
            }
            BuildForm::Number { .. } => "a number from 0".to_owned(),
            BuildForm::Choice { options } => {
                options.iter().map(|option| option.word).collect::<Vec<_>>().join(" or ")
            }
            BuildForm::Switch => "on or off".to_owned(),
            BuildForm::Text => "a text".to_owned(),
            BuildForm::Edges => "edges by their vertices, such as 3-4,4-9, or none".to_owned(),
        }
    }

    /// Says what is wrong with a number; none if it is in the range.
    pub fn fault(&self, number: f64) -> Option<String> {
        let BuildForm::Number { range: [least, most], .. } = self.form else { return None };
        let is_on_other_side = match least < 0.0 {
            true => number == 0.0,
            false => number < 0.0 || (least > 0.0 && number == 0.0),
        };
        let expected = if is_on_other_side || !number.is_finite() {
            self.expected()
        } else if number.abs() > most {
            format!("at most {most}")
        } else if number < least {
            format!("at least {least}")
        } else {
            return None;
        };
        Some(format!("found {number}, expected {expected}"))
    }
}

impl BuildSettings {
    /// Returns the value of a setting, as in a scene.
    pub fn value(&self, setting: &BuildSetting) -> Value {
        setting.value_in(&serde_json::to_value(self).unwrap_or_default())
    }

    /// Returns the settings with other values at these paths, as in a scene: those of declared settings,
    /// or of what contains them, such as `sheet`.
    ///
    /// # Errors
    /// If there is no such setting, or the values do not fit, also together: see
    /// [`BuildSettings::check`].
    pub fn with_all(&self, values: Map<String, Value>) -> Result<BuildSettings, SceneError> {
        let error = |path: &str, message| SceneError { path: format!("build.{path}"), message };
        let mut own = serde_json::to_value(self).unwrap_or_default();
        for (path, value) in values {
            let place = own.pointer_mut(&pointer(&path));
            *place.ok_or_else(|| error(&path, "there is no such setting".to_owned()))? = value;
        }
        let own: BuildSettings =
            from_value(own).map_err(|found| error(&found.path, found.message))?;
        own.check().map_err(|(path, message)| error(&path, message))?;
        Ok(own)
    }
}

/// The JSON pointer of a path such as `sheet[0]` or `limits.warp`.
fn pointer(path: &str) -> String {
    format!("/{}", path.replace(['.', '['], "/").replace(']', ""))
}
