//! Common materials, machines and sheets: values of several settings of a build at once.

use super::declarations::BUILD_SETTINGS;
use serde::Serialize;
use serde_json::Value;

/// What a preset sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum PresetOf {
    /// The material, its thickness, and how far it bends if that is known.
    Material,
    /// How parts are cut: the kerf, the tool of a mill, and the gap that they need.
    Machine,
    /// The size of sheets.
    #[serde(rename = "Sheet size")]
    Sheet,
}

/// Values of several settings.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BuildPreset {
    /// What it sets.
    pub of: PresetOf,
    /// Its name on the command line.
    pub id: &'static str,
    /// Display name.
    pub label: &'static str,
    /// The values.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "Partial<BuildSettings>"))]
    pub values: PresetValues,
}

/// The values of a preset, in mm; absent ones stay. See [`BuildSettings`](super::BuildSettings).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[allow(missing_docs, reason = "they are those of the settings")]
pub struct PresetValues {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub material: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thickness: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bend: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kerf: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tool: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sheet: Option<[f64; 2]>,
}

impl BuildPreset {
    /// The preset of this kind and id.
    pub fn named(of: PresetOf, id: &str) -> Option<&'static BuildPreset> {
        BUILD_PRESETS.iter().find(|preset| preset.of == of && preset.id == id)
    }

    /// The values of the declared settings that it sets, by their paths.
    pub fn settings(&self) -> Vec<(&'static str, Value)> {
        let own = serde_json::to_value(self.values).unwrap_or_default();
        let all = BUILD_SETTINGS.iter().map(|setting| (setting.id, setting.value_in(&own)));
        all.filter(|(_, value)| !value.is_null()).collect()
    }
}

const NONE: PresetValues = PresetValues {
    material: None,
    thickness: None,
    bend: None,
    kerf: None,
    tool: None,
    gap: None,
    sheet: None,
};

const fn material(
    id: &'static str,
    label: &'static str,
    name: &'static str,
    thickness: f64,
) -> BuildPreset {
    let (material, thickness) = (Some(name), Some(thickness));
    let values = PresetValues { material, thickness, bend: Some(0.0), ..NONE };
    BuildPreset { of: PresetOf::Material, id, label, values }
}

/// A material that is known to bend, without heat and elastically, to this many thicknesses.
const fn bent(bend: f64, own: BuildPreset) -> BuildPreset {
    BuildPreset { values: PresetValues { bend: Some(bend), ..own.values }, ..own }
}

const fn machine(id: &'static str, label: &'static str, kerf: f64, gap: f64) -> BuildPreset {
    let values = PresetValues { kerf: Some(kerf), tool: Some(0.0), gap: Some(gap), ..NONE };
    BuildPreset { of: PresetOf::Machine, id, label, values }
}

/// A mill, whose tool is as wide as its kerf.
const fn mill(id: &'static str, label: &'static str, tool: f64, gap: f64) -> BuildPreset {
    let values = PresetValues { kerf: Some(tool), tool: Some(tool), gap: Some(gap), ..NONE };
    BuildPreset { of: PresetOf::Machine, id, label, values }
}

const fn sheet(id: &'static str, label: &'static str, size: [f64; 2]) -> BuildPreset {
    BuildPreset {
        of: PresetOf::Sheet,
        id,
        label,
        values: PresetValues { sheet: Some(size), ..NONE },
    }
}

/// The presets; those of the defaults of [`BuildSettings`](super::BuildSettings) are among them.
pub const BUILD_PRESETS: [BuildPreset; 25] = [
    material("paper", "Paper 0.2 mm", "paper", 0.2),
    material("card", "Card 0.5 mm", "card", 0.5),
    material("card-1.5", "Card 1.5 mm", "card", 1.5),
    material("mdf", "MDF 3 mm", "MDF", 3.0),
    // APA, Bending plywood: 5 ft for 1/4 inch, dry, parallel to the grain.
    bent(240.0, material("plywood-3", "Plywood 3 mm", "plywood", 3.0)),
    bent(240.0, material("plywood-4", "Plywood 4 mm", "plywood", 4.0)),
    bent(240.0, material("plywood-6", "Plywood 6 mm", "plywood", 6.0)),
    // Acrylite (Roehm), minimum cold formed radius of extruded and of cast sheet.
    bent(330.0, material("acrylic", "Acrylic 3 mm", "acrylic", 3.0)),
    // Half of 70 GPa over the 0.2 % proof stress of EN AW-5005 H14, 120 MPa: it springs back.
    bent(290.0, material("aluminium", "Aluminium 2 mm", "aluminium", 2.0)),
    // Sedak, cold bending of tempered glass.
    bent(1500.0, material("glass", "Glass 10 mm", "glass", 10.0)),
    machine("hand", "By hand", 0.0, 3.0),
    machine("plotter", "Knife plotter", 0.0, 1.0),
    machine("laser", "Laser", 0.15, 1.0),
    mill("mill", "CNC mill, 3 mm", 3.0, 6.0),
    mill("mill-6", "CNC mill, 6 mm", 6.0, 10.0),
    sheet("a4", "A4", [297.0, 210.0]),
    sheet("a3", "A3", [420.0, 297.0]),
    sheet("a2", "A2", [594.0, 420.0]),
    sheet("a1", "A1", [841.0, 594.0]),
    sheet("a0", "A0", [1189.0, 841.0]),
    sheet("600x400", "600 × 400 mm", [600.0, 400.0]),
    sheet("1200x600", "1200 × 600 mm", [1200.0, 600.0]),
    sheet("1220x610", "1220 × 610 mm", [1220.0, 610.0]),
    sheet("2440x1220", "2440 × 1220 mm", [2440.0, 1220.0]),
    sheet("3210x2250", "3210 × 2250 mm", [3210.0, 2250.0]),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::BuildSettings;

    #[test]
    fn presets_have_valid_values_and_ids_of_their_own_and_the_defaults_are_among_them() {
        let defaults = BuildSettings::default();
        let mut is_default = Vec::new();
        for preset in BUILD_PRESETS {
            let alike = BUILD_PRESETS.iter().filter(|other| other.id == preset.id);
            assert_eq!(alike.count(), 1, "{}", preset.id);
            let values = preset.settings().into_iter();
            let values = values.map(|(path, value)| (path.to_owned(), value)).collect();
            let settings = defaults.with_all(values).expect("it is valid");
            assert!(settings.gap >= settings.kerf, "{}", preset.id);
            is_default.extend((settings == defaults).then_some(preset.id));
        }
        assert_eq!(is_default, ["card", "hand", "a3"]);
    }
}
