//! The declaration of every setting of Build. Forms, options of the command line, ranges, and the
//! list in `summary.csv` follow from this table: a new setting is a line here, its field in
//! [`BuildSettings`], and its use.

use super::choice::Product::{self, Fins, Panels, Paper};
use super::declared::{ABOVE_0, BuildForm, BuildGroup, BuildOption, BuildSetting, BuildUnit};
use super::settings::BuildSettings;
use BuildGroup::{Cutting, Files, Limits, Model, Offset, Parts, Types};
use BuildUnit::{Degrees, Mesh, Mm, Plain};

/// Largest length on the sheet or of the material in mm: larger ones are typing errors, at which
/// files would become too large.
const LONGEST: f64 = 1e5;
/// Largest other number.
const LARGEST: f64 = 1e9;
/// Smallest denominator of the scale.
const LEAST_SCALE: f64 = 1e-3;

const FROM_0: [f64; 2] = [0.0, LARGEST];
const POSITIVE: [f64; 2] = [ABOVE_0, LARGEST];
const ON_SHEET: [f64; 2] = [0.0, LONGEST];

const FLAT: &[Product] = &[Panels, Fins];

/// A setting of all products that has a value in every scene.
const fn setting(
    group: BuildGroup,
    id: &'static str,
    label: &'static str,
    form: BuildForm,
    summary: &'static str,
) -> BuildSetting {
    BuildSetting { id, label, summary, group, products: &Product::ALL, form, absent: "" }
}

const fn number(unit: BuildUnit, range: [f64; 2]) -> BuildForm {
    BuildForm::Number { unit, range }
}

const fn choice(options: &'static [BuildOption]) -> BuildForm {
    BuildForm::Choice { options }
}

const fn option(word: &'static str, label: &'static str, summary: &'static str) -> BuildOption {
    BuildOption { word, label, summary }
}

impl BuildSetting {
    /// The setting, of these products only.
    const fn of(self, products: &'static [Product]) -> BuildSetting {
        BuildSetting { products, ..self }
    }

    /// The setting, which may be absent and then stands for this.
    const fn or(self, absent: &'static str) -> BuildSetting {
        BuildSetting { absent, ..self }
    }
}

const PRODUCTS: BuildForm = choice(&[
    option("panels", "Panels", "Each panel, cut from flat sheet"),
    option("fins", "Fins along the edges", "Beams along the edges, cut from flat sheet"),
    option("paper", "Paper model", "Folded and glued from card"),
]);
const PIECES: BuildForm = choice(&[
    option("nets", "Nets", ""),
    option("strips", "Strips", ""),
    option("across", "Strips, other way", ""),
]);
const FOLDS: BuildForm = choice(&[
    option("crease", "Creased", "Paper with tabs, whose thickness does not count"),
    option("score", "Scored", "Card, cut half through: panels are shorter at ridges"),
    option("v-cut", "V-cut", "Card, grooved on the inside: panels are whole outside"),
    option("separate", "Separate", "Card, cut apart and taped: panels are shorter at ridges"),
]);
const JOINS: BuildForm = choice(&[
    option("tabs", "Tabs for glue", ""),
    option("slots", "Tongues in slots", "Without glue: tongues are pushed behind the neighbour"),
]);
const KINDS: BuildForm = choice(&[
    option("corner", "Corners", "Nodes keep their distance: exact on circular panels"),
    option("face", "Panels", "Planes of panels keep their distance: one thickness"),
    option("edge", "Beams", "All beams are equally high"),
]);
const ORDERS: BuildForm =
    choice(&[option("size", "Fewest sheets", ""), option("names", "By name", "")]);
const NAMES: BuildForm = choice(&[
    option("index", "P0, P1, P2 ...", ""),
    option("rows", "Rows and columns", "If the mesh is one grid of quads"),
    option(
        "assembly",
        "In order of assembly",
        "A1, A2 ... on the supports, B1 ... above; with fins, nodes N1, N2 ... too",
    ),
]);
const DXF: BuildForm =
    choice(&[option("r2000", "DXF 2000", ""), option("r12", "DXF R12, for old machines", "")]);
const PAGES: BuildForm =
    choice(&[option("sheet", "Sheet size", ""), option("a4", "A4", ""), option("a3", "A3", "")]);

/// All settings of Build, in the order in which hosts list them.
pub const BUILD_SETTINGS: &[BuildSetting] = &[
    setting(Model, "product", "Make", PRODUCTS, "What is made of the shape."),
    setting(Model, "pieces", "Pieces", PIECES, "Nets, or strips of quads in one direction.")
        .of(&[Paper]),
    setting(
        Model,
        "seams",
        "Seams",
        BuildForm::Edges,
        "Edges that are cut and never folded, by their vertices: 3-4,4-9.",
    )
    .of(&[Paper]),
    setting(
        Parts,
        "fold",
        "Folds",
        FOLDS,
        "How folds are made; all but creases allow for the thickness, no tabs.",
    )
    .of(&[Paper]),
    setting(Parts, "join", "Cut edges", JOINS, "How the cut edges of creased paper are joined.")
        .of(&[Paper]),
    setting(Parts, "tab", "Tabs", number(Mm, ON_SHEET), "Height of tabs and tongues; 0 for none.")
        .of(&[Paper]),
    setting(
        Parts,
        "print_inside",
        "Print on the inside",
        BuildForm::Switch,
        "Prints the side that will be inside: mirrored, with readable names.",
    )
    .of(&[Panels, Paper]),
    setting(
        Model,
        "scale",
        "Scale 1 :",
        number(Plain, [LEAST_SCALE, LARGEST]),
        "The building is this many times as large as the model.",
    ),
    setting(
        Parts,
        "material",
        "Sheet label",
        BuildForm::Text,
        "The name of the material, in the title of the sheets.",
    ),
    setting(Parts, "thickness", "Thickness", number(Mm, ON_SHEET), "Thickness of the material."),
    setting(
        Parts,
        "bend",
        "Least bending radius",
        number(Plain, FROM_0),
        "In thicknesses; quads bent more are cut as two triangles. 0: none.",
    )
    .of(&[Panels]),
    setting(
        Parts,
        "sheet[0]",
        "Sheet width",
        number(Mm, [ABOVE_0, LONGEST]),
        "Width of a sheet of the material.",
    ),
    setting(
        Parts,
        "sheet[1]",
        "Sheet height",
        number(Mm, [ABOVE_0, LONGEST]),
        "Height of a sheet of the material.",
    ),
    setting(
        Parts,
        "joint",
        "Joint",
        number(Mesh, FROM_0),
        "Gap between neighbouring panels, in the unit of the mesh.",
    )
    .of(&[Panels]),
    setting(
        Parts,
        "setback",
        "Setback at boundary",
        number(Mesh, FROM_0),
        "From the boundary of the model to the panels, in the unit of the mesh.",
    )
    .of(&[Panels])
    .or("half the joint"),
    setting(
        Parts,
        "hole",
        "Holes",
        number(Mm, ON_SHEET),
        "Diameter of holes along edges and at the ends of fins; 0 for none.",
    )
    .of(FLAT),
    setting(
        Parts,
        "splice",
        "Splice plates",
        number(Mm, ON_SHEET),
        "Width of the plates that join the pieces of panels too large; 0: none.",
    )
    .of(&[Panels]),
    setting(
        Parts,
        "strip",
        "Cover strips",
        number(Mm, ON_SHEET),
        "Width of strips over the joints, listed with their lengths; 0: none.",
    )
    .of(&[Panels]),
    setting(
        Parts,
        "disc",
        "Node discs",
        number(Mm, ON_SHEET),
        "Diameter of the discs that join the fins of a node; 0 for none.",
    )
    .of(&[Fins])
    .or("the smallest that has room at each node"),
    setting(
        Parts,
        "clearance",
        "Clearance",
        number(Mm, ON_SHEET),
        "Play between node disc and fin, or tongue and slot, on each side.",
    )
    .of(&[Fins, Paper]),
    setting(Offset, "kind", "Measured at", KINDS, "What keeps its distance in the offset.")
        .or("the kind that is within the limits, or has the smallest errors"),
    setting(
        Offset,
        "distance",
        "Distance",
        number(Mesh, [-LARGEST, LARGEST]),
        "Distance of the offset and depth of beams, negative inwards.",
    )
    .or("a fifth of the mean edge"),
    setting(
        Offset,
        "follow",
        "Upright axes",
        number(Plain, POSITIVE),
        "More: axes are more upright. Less: beams are flatter.",
    ),
    setting(
        Cutting,
        "kerf",
        "Kerf",
        number(Mm, ON_SHEET),
        "Width of the cut: outlines are moved outwards by half of it.",
    ),
    setting(
        Cutting,
        "tool",
        "Tool",
        number(Mm, ON_SHEET),
        "Diameter of a milling tool, for reliefs in inner corners; 0 for none.",
    )
    .of(FLAT),
    setting(Cutting, "gap", "Gap", number(Mm, ON_SHEET), "Least space between parts on a sheet."),
    setting(
        Cutting,
        "margin",
        "Margin",
        number(Mm, ON_SHEET),
        "Margin without parts at the edges of a sheet.",
    ),
    setting(Cutting, "order", "Order", ORDERS, "The order of parts on the sheets."),
    setting(
        Cutting,
        "beam_width",
        "Beam width",
        number(Mesh, POSITIVE),
        "Width of the beams as solids, for 3D programs.",
    )
    .of(&[Fins])
    .or("a twentieth of the mean edge"),
    setting(
        Types,
        "alike",
        "Lengths within",
        number(Mm, FROM_0),
        "Panels and edges of one type differ by at most this, at full size.",
    )
    .of(FLAT),
    setting(
        Types,
        "alike_deg",
        "Angles within",
        number(Degrees, FROM_0),
        "Nodes of one type differ by at most this.",
    )
    .of(&[Fins]),
    setting(
        Types,
        "mirror",
        "Mirror images are alike",
        BuildForm::Switch,
        "Parts that are mirror images have one type: turn the sheet over.",
    )
    .of(FLAT),
    setting(
        Files,
        "names",
        "Names",
        NAMES,
        "Names of panels. Rows and columns: if the mesh is one grid of quads.",
    ),
    setting(Files, "dxf", "Drawings", DXF, "The version of the DXF files."),
    setting(Files, "page", "PDF pages", PAGES, "Larger sheets are printed on several pages."),
    setting(
        Files,
        "outlines_only",
        "Outlines only, without names",
        BuildForm::Switch,
        "Writes only outlines, on layer 0, as some workshops ask.",
    ),
    setting(
        Files,
        "one_file_each",
        "One file per part",
        BuildForm::Switch,
        "Also writes each part alone, without frame, into the folder parts.",
    ),
    setting(
        Limits,
        "limits.warp",
        "Warped beams",
        number(Mm, FROM_0),
        "Corners of a beam from its plane, at full size.",
    ),
    setting(
        Limits,
        "limits.distance",
        "Uneven offset",
        number(Mm, FROM_0),
        "Offset from its distance, at full size.",
    ),
    setting(
        Limits,
        "limits.lean",
        "Leaning nodes",
        number(Degrees, FROM_0),
        "Axis of a node from the normal of the surface.",
    ),
    setting(
        Limits,
        "limits.flatness",
        "Flatness",
        number(Mm, FROM_0),
        "Corners of a panel from its plane, at full size.",
    ),
    setting(
        Limits,
        "limits.part",
        "Least width",
        number(Mm, ON_SHEET),
        "Narrower parts on the sheet are named: letters have no room on them.",
    ),
];

impl BuildSettings {
    /// Checks that every number is finite and in its declared range.
    pub(super) fn check_numbers(&self) -> Result<(), (&'static str, String)> {
        let own = serde_json::to_value(self).unwrap_or_default();
        let is_number = |it: &&BuildSetting| matches!(it.form, BuildForm::Number { .. });
        for setting in BUILD_SETTINGS.iter().filter(is_number) {
            // In JSON a number that is not finite is null, as an absent one.
            let null = || match setting.id {
                "disc" => self.disc,
                "setback" => self.setback,
                "distance" => self.distance,
                "beam_width" => self.beam_width,
                _ => Some(f64::NAN),
            };
            let number = setting.value_in(&own).as_f64().or_else(null);
            if let Some(fault) = number.and_then(|number| setting.fault(number)) {
                return Err((setting.id, fault));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::SceneError;
    use serde_json::{Map, Value, json};

    /// A value of a setting other than its default.
    fn other(setting: &BuildSetting) -> Value {
        let now = BuildSettings::default().value(setting);
        match setting.form {
            BuildForm::Number { .. } => json!(now.as_f64().unwrap_or(0.0) + 2.0),
            BuildForm::Choice { options } => json!(options[options.len() - 1].word),
            BuildForm::Switch => json!(now != json!(true)),
            BuildForm::Text => json!("oak"),
            BuildForm::Edges => json!([[0, 1], [5, 4]]),
        }
    }

    /// The paths of all values of a scene's settings.
    fn paths(value: &Value, path: &str, found: &mut Vec<String>) {
        match value {
            Value::Object(entries) => {
                for (key, value) in entries {
                    let dot = if path.is_empty() { "" } else { "." };
                    paths(value, &format!("{path}{dot}{key}"), found);
                }
            }
            Value::Array(values) if !values.is_empty() => {
                for (k, value) in values.iter().enumerate() {
                    paths(value, &format!("{path}[{k}]"), found);
                }
            }
            _ => found.push(path.to_owned()),
        }
    }

    #[test]
    fn every_key_of_a_scene_is_declared_once() {
        let all = serde_json::to_value(BuildSettings::default()).expect("it is plain");
        let mut known = Vec::new();
        paths(&all, "", &mut known);
        let mut declared: Vec<_> = BUILD_SETTINGS.iter().map(|one| one.id.to_owned()).collect();
        known.sort();
        declared.sort();
        assert_eq!(known, declared);
    }

    /// The default settings with another value of one.
    fn with(setting: &BuildSetting, value: Value) -> Result<BuildSettings, SceneError> {
        BuildSettings::default().with_all(Map::from_iter([(setting.id.to_owned(), value)]))
    }

    #[test]
    fn every_setting_can_be_changed_and_is_read_back() {
        for setting in BUILD_SETTINGS {
            let value = other(setting);
            let changed = with(setting, value.clone()).expect(setting.id);
            assert_ne!(changed, BuildSettings::default(), "{}", setting.id);
            let read = changed.value(setting);
            assert_eq!((read.as_f64(), read.as_str()), (value.as_f64(), value.as_str()));
            let text = serde_json::to_string(&changed).expect("it is plain");
            assert_eq!(serde_json::from_str::<BuildSettings>(&text).expect("it is ours"), changed);
        }
    }

    #[test]
    fn every_word_is_one_of_the_scene_and_only_some_settings_may_be_absent() {
        for setting in BUILD_SETTINGS {
            if let BuildForm::Choice { options } = setting.form {
                for option in options {
                    let changed = with(setting, json!(option.word));
                    assert_eq!(changed.expect("it is known").value(setting), json!(option.word));
                }
            }
            let absent = with(setting, Value::Null);
            assert_eq!(absent.is_ok(), !setting.absent.is_empty(), "{}", setting.id);
        }
    }

    #[test]
    fn numbers_out_of_range_are_refused_at_their_place() {
        for setting in BUILD_SETTINGS {
            let BuildForm::Number { range: [least, most], .. } = setting.form else { continue };
            for wrong in [2.0 * most, if least < 0.0 { 0.0 } else { least - 1.0 }] {
                let refused = with(setting, json!(wrong));
                let words = refused.expect_err(setting.id).message;
                assert!(words.starts_with("found ") && words.contains("expected "), "{words}");
            }
            assert!(setting.fault(f64::NAN).is_some() && setting.fault(most).is_none());
        }
    }
}
