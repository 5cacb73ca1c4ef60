//! Sheets and the build check for the page.

use crate::fabricate::file::{SheetPicture, picture};
use crate::fabricate::{
    BUILD_NUMBERS, Build, BuildCard, BuildFile, BuildReport, BuildWords, CardWords, Choice, Fault,
    ReportView, SpatialPart, Stand, unit_of,
};
use crate::mesh::Mesh;
use crate::scene::{BUILD_PRESETS, BUILD_SETTINGS, BuildPreset, BuildSetting, BuildSettings, Up};
use crate::web::values::{AsIs, Js, flat, indices, plain, plains, read};
use crate::web::{log_panics, mesh_of, thrown};
use js_sys::{Float64Array, Uint8Array, Uint32Array};
use serde::{Deserialize, Serialize};
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// The presets, the declared settings and their defaults.
#[derive(Serialize, Tsify)]
pub struct BuildOffers {
    presets: &'static [BuildPreset],
    settings: &'static [BuildSetting],
    /// All of them.
    #[tsify(type = "Required<BuildSettings>")]
    defaults: BuildSettings,
}

/// The report, with its words.
#[derive(Serialize, Tsify)]
pub struct WordedReport {
    report: BuildReport,
    words: BuildWords,
}

/// The card, with its words.
#[derive(Serialize, Tsify)]
pub struct WordedCard {
    report: BuildCard,
    words: CardWords,
}

/// The errors of a kind of offset, with their words.
#[derive(Serialize, Tsify)]
pub struct WordedChoice {
    #[serde(flatten)]
    choice: Choice,
    words: String,
}

/// Pairs of id and value.
#[derive(Serialize, Tsify)]
pub struct NumbersById(Vec<(&'static str, f64)>);

/// The unit of a shape, and how it stands.
#[derive(Deserialize, Tsify)]
pub struct Site {
    /// The unit of the mesh, empty if it has none.
    symbol: String,
    /// Whether z is up, else y.
    z_up: bool,
    /// The vertices that are held where they are.
    held: Vec<u32>,
}

/// A file to be saved by the page.
#[derive(Serialize, Tsify)]
pub struct NamedFile {
    name: String,
    bytes: AsIs<Uint8Array>,
}

/// Returns the presets, the declared settings and their defaults.
#[wasm_bindgen(js_name = buildOffers)]
pub fn build_offers() -> Result<Js<BuildOffers>, JsValue> {
    log_panics();
    let defaults = BuildSettings::default();
    plain(&BuildOffers { presets: &BUILD_PRESETS, settings: BUILD_SETTINGS, defaults })
}

/// The offset as the view shows it.
#[derive(Serialize, Tsify)]
pub struct OffsetLayer {
    /// `#V by 3`; empty if no offset is offered.
    points: AsIs<Float64Array>,
    /// The edges whose beams exceed a limit, as pairs of vertices.
    edges: AsIs<Uint32Array>,
    /// The vertices whose axes do.
    vertices: AsIs<Uint32Array>,
    /// The panels that do.
    panels: AsIs<Uint32Array>,
}

/// The parts of a shape.
#[wasm_bindgen]
pub struct Builder {
    build: Build,
    /// Whether z is up, else y.
    z_up: bool,
}

#[wasm_bindgen]
impl Builder {
    /// Makes the parts of a mesh of `positions`, `#V by 3`, and faces: face `f` has the corners
    /// from `offsets[f]` to `offsets[f + 1]` of `indices`. `unplaced` are the vertices whose positions
    /// are guesses; the last faces, `untouched` many, are those that are left as they are. `settings` are
    /// those of the key `build` of a scene.
    ///
    /// # Errors
    /// A mesh without faces or with guessed corners, a unit that is not known, or a setting out of its
    /// range, in one sentence.
    #[wasm_bindgen(constructor)]
    pub fn new(
        positions: &[f64],
        offsets: &[u32],
        indices: &[u32],
        unplaced: Vec<u32>,
        untouched: usize,
        settings: Js<BuildSettings>,
        site: Js<Site>,
    ) -> Result<Builder, JsValue> {
        let settings: BuildSettings = read(settings)?;
        let Site { symbol, z_up, held } = read(site)?;
        let stand = Stand { up: if z_up { Up::Z } else { Up::Y }, held };
        let all = mesh_of(positions, offsets, indices);
        let count = all.faces.len().saturating_sub(untouched);
        let faces = all.faces.iter().take(count).collect();
        let untouched = all.faces.iter().skip(count).collect();
        let mesh = Mesh { faces, unplaced, untouched, ..all };
        let build = unit_of(&symbol).and_then(|unit| Build::new(&mesh, &settings, unit, &stand));
        let said = |fault: Fault| thrown(fault.sentence());
        Ok(Builder { build: build.map_err(said)?, z_up })
    }

    /// Returns all numbers, as in the report of the command line, and their words.
    pub fn report(&self) -> Result<Js<WordedReport>, JsValue> {
        let report = self.build.report();
        plain(&WordedReport { words: self.build.words(&report), report })
    }

    /// Returns the numbers and words of the card, which is updated while the shape moves.
    pub fn card(&self) -> Result<Js<WordedCard>, JsValue> {
        let report = self.build.card();
        plain(&WordedCard { words: self.build.card_words(&report), report })
    }

    /// Returns the first sheets as pictures, at most `count`.
    pub fn sheets(&self, count: usize) -> Result<Vec<Js<SheetPicture>>, JsValue> {
        let failed = self.build.failed_sides(&self.build.failed());
        let shown = failed.iter().enumerate().take(count);
        let pictures = shown.map(|(k, failed)| {
            let mut own = picture(&self.build.drawing(k), failed);
            own.panels.iter_mut().for_each(|panels| *panels = self.faces_of(panels));
            own
        });
        plains(&pictures.collect::<Vec<_>>())
    }

    /// Returns the numbers that a lesson may bound, as pairs of id and value, lengths in the unit
    /// of the mesh. Numbers that do not apply are left out.
    pub fn numbers(&self) -> Result<Js<NumbersById>, JsValue> {
        let known = BUILD_NUMBERS.iter().zip(self.build.numbers());
        let known = known.filter_map(|(number, value)| Some((number.id, value?)));
        plain(&NumbersById(known.collect()))
    }

    /// Returns the offset.
    pub fn layer(&self) -> Result<Js<OffsetLayer>, JsValue> {
        let failed = self.build.failed();
        let ends = |&e: &u32| self.build.surface.edges[e as usize].ends;
        plain(&OffsetLayer {
            points: AsIs(flat(&self.build.layer().unwrap_or_default())),
            edges: indices(&failed.edges.iter().flat_map(ends).collect::<Vec<_>>()),
            vertices: indices(&failed.nodes),
            panels: indices(&self.faces_of(&failed.panels)),
        })
    }

    /// The faces that the view has of some panels.
    fn faces_of(&self, panels: &[u32]) -> Vec<u32> {
        panels.iter().filter_map(|&panel| self.build.face_of(panel)).collect()
    }

    /// Sets another distance of the offset, with the same axes and parts.
    #[wasm_bindgen(js_name = moveLayer)]
    pub fn move_layer(&mut self, distance: f64) {
        self.build.move_layer(distance);
    }

    /// Computes the offset of another shape of the same mesh, `#V by 3`; parts and sheets stay.
    pub fn reshape(&mut self, positions: &[f64]) {
        self.build.reshape(positions.as_chunks().0);
    }

    /// Returns the errors of each kind of offset.
    pub fn choices(&self) -> Result<Vec<Js<WordedChoice>>, JsValue> {
        let choices = self.build.choices().into_iter();
        let worded = choices.map(|choice| WordedChoice { words: choice.words(), choice });
        plains(&worded.collect::<Vec<_>>())
    }

    /// Returns the build as objects on layers, for CAD programs.
    #[wasm_bindgen(js_name = spatialParts)]
    pub fn spatial_parts(&self) -> Result<Vec<Js<SpatialPart>>, JsValue> {
        plains(&self.build.spatial_parts(self.z_up))
    }

    /// Returns the report as an HTML document. `camera` has its turn about the up axis and its downward
    /// tilt, in radians. An empty `link` is left out.
    #[wasm_bindgen(js_name = reportPage)]
    pub fn report_page(&self, title: String, camera: Option<Vec<f64>>, link: String) -> String {
        let camera = camera.and_then(|camera| <[f64; 2]>::try_from(camera).ok());
        self.build.report_page(&ReportView { title, z_up: self.z_up, camera, link })
    }

    /// Returns all files: `name` and `bytes`.
    pub fn files(&self) -> Result<Vec<Js<NamedFile>>, JsValue> {
        let files = self.build.files(self.z_up).into_iter();
        let named = files.map(|BuildFile { name, bytes }| NamedFile {
            name,
            bytes: AsIs(Uint8Array::from(&bytes[..])),
        });
        plains(&named.collect::<Vec<_>>())
    }
}
