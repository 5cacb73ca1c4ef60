//! The files of a build: drawings of the sheets, the key to their parts, tables, solids.

use super::build::Build;
use super::file::{Drawing, dxf, pdf, svg};
use super::sheet::{CutPart, Place};
use super::space::{PRESENTATION, assembled, named_panels, solids};
use super::tables;
use crate::mesh::write_obj_with;
use crate::scene::{BuildSettings, UnitsAndUp, Up};

/// The folder of the files of single parts.
pub const PARTS: &str = "parts";

/// A file to be saved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BuildFile {
    /// Its name; those of single parts begin with the folder [`PARTS`] and a slash.
    pub name: String,
    /// Its content. Texts are ASCII, except for the names of materials in tables, which are UTF-8.
    pub bytes: Vec<u8>,
}

impl BuildFile {
    /// Whether a file of this name may be of a build, of any product and number of sheets, without
    /// those of single parts.
    pub fn is_name_of_one(name: &str) -> bool {
        let of_sheet = name.strip_prefix("sheet-").and_then(|rest| rest.split_once('.'));
        let is_sheet = of_sheet.is_some_and(|(number, kind)| {
            number.len() >= 2
                && number.bytes().all(|digit| digit.is_ascii_digit())
                && ["svg", "dxf"].contains(&kind)
        });
        let is_key = name.strip_prefix("key-").and_then(|rest| rest.strip_suffix(".svg"));
        is_sheet
            || is_key.is_some_and(|number| number.parse::<u8>().is_ok())
            || ["sheets.pdf", "key.pdf", "panels.obj", "beams.obj", "plates.obj", PRESENTATION]
                .contains(&name)
            || tables::NAMES.contains(&name)
    }
}

impl Build {
    /// All files: a drawing of each sheet and, if asked, of each part in two formats, all sheets as PDF,
    /// the key, the tables, the panels by name or the beams, with node discs all plates as they are
    /// assembled, and the shape for presentations. `z_up` is whether z is up in the mesh; else y is.
    pub fn files(&self, z_up: bool) -> Vec<BuildFile> {
        let drawings: Vec<Drawing> = self.drawings().into_iter().map(Drawing::cut_once).collect();
        let (single, mut files) = (self.drawings_of_parts(), Vec::new());
        let mut add =
            |name: &str, bytes: Vec<u8>| files.push(BuildFile { name: name.into(), bytes });
        for drawing in drawings.iter().chain(&single) {
            let layers = !self.settings.outlines_only;
            add(&format!("{}.svg", drawing.name), svg(drawing).into());
            let text = dxf(drawing, self.settings.dxf, layers);
            add(&format!("{}.dxf", drawing.name), text.into());
        }
        if !drawings.is_empty() {
            add("sheets.pdf", pdf(&drawings, self.printed_page().size()));
            let key = self.key(z_up);
            key.iter().for_each(|own| add(&format!("{}.svg", own.name), svg(own).into()));
            add("key.pdf", pdf(&key, None));
        }
        for (name, text) in tables::all(self) {
            add(name, text.into());
        }
        let meshes = [
            (
                "panels.obj",
                named_panels(self),
                Some("its first vertex is node N0, the next one N1, and so on"),
            ),
            ("beams.obj", solids(self), None),
            ("plates.obj", assembled(self), None),
        ];
        for (name, mesh, note) in meshes {
            let Some(mesh) = mesh else { continue };
            let up = if z_up { Up::Z } else { Up::Y };
            let mut comments = UnitsAndUp::comments(self.unit.symbol, Some(up), &mesh);
            comments.extend(note.map(str::to_owned));
            add(name, write_obj_with(&mesh, &mesh.positions, &[], &comments).into());
        }
        add(PRESENTATION, self.presentation(z_up));
        files
    }

    /// Each part alone, rotated as on its sheet; none unless they are asked for.
    fn drawings_of_parts(&self) -> Vec<Drawing> {
        let BuildSettings { one_file_each, outlines_only, .. } = self.settings;
        if !one_file_each {
            return Vec::new();
        }
        let places = self.layout.places(self.parts.len());
        let drawn = |(part, place): (&CutPart, &Option<(usize, Place)>)| {
            let turn = place.map_or([1.0, 0.0], |(_, place)| place.turn);
            let name = format!("{PARTS}/{}", part.name);
            Drawing::of_part(name, part, turn, outlines_only).cut_once()
        };
        self.parts.iter().zip(&places).map(drawn).collect()
    }
}
