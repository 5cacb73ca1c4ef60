//! New meshes for the page, and the files of the examples: the page makes them when they are opened,
//! so that a visit neither fetches nor keeps them, and its build writes them all.

use super::values::{Js, plain, plains};
use super::{log_panics, mesh_of, rows_of, thrown};
use crate::generate::{CurveLabel, NEW_KINDS, NewKind, SpanCurve, SpanError, example, fill, loft};
use crate::mesh::{Mesh, write_obj_with};
use crate::scene::{NamedEnum, UnitsAndUp, Up};
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// Returns the kinds of new meshes.
#[wasm_bindgen(js_name = newKinds)]
pub fn new_kinds() -> Result<Vec<Js<NewKind>>, JsValue> {
    log_panics();
    plains(NEW_KINDS)
}

/// Returns a mesh of a kind as OBJ text; `sizes` are in the order in which the kind declares them.
///
/// # Errors
/// An unknown kind, or a size out of its range.
#[wasm_bindgen(js_name = newMesh)]
pub fn new_mesh(kind: &str, sizes: &[f64], units: &str) -> Result<String, JsValue> {
    let kind = NewKind::of(kind).ok_or_else(|| thrown(format!("unknown kind {kind:?}")))?;
    Ok(obj(&kind.mesh(sizes).map_err(thrown)?, units, Up::Z))
}

/// The curves of a mesh, to be spanned by surfaces.
#[wasm_bindgen]
pub struct NewSpans {
    curves: Vec<SpanCurve>,
    units: String,
    up: Up,
}

#[wasm_bindgen]
impl NewSpans {
    /// Reads the curves of a mesh of `positions`, `#V by 3`, with faces and polylines as offsets
    /// and indices; `up` is its up axis, z or y.
    #[wasm_bindgen(constructor)]
    pub fn new(
        positions: &[f64],
        face_offsets: &[u32],
        face_indices: &[u32],
        curve_offsets: &[u32],
        curve_indices: &[u32],
        units: String,
        up: String,
    ) -> NewSpans {
        let mut mesh = mesh_of(positions, face_offsets, face_indices);
        mesh.curves = rows_of(curve_offsets, curve_indices);
        NewSpans { curves: SpanCurve::all(&mesh), units, up: Up::of_word(&up).unwrap_or_default() }
    }

    /// Returns the polylines of the mesh, then the boundaries of its faces.
    pub fn curves(&self) -> Result<Vec<Js<CurveLabel>>, JsValue> {
        plains(&SpanCurve::labels(&self.curves))
    }

    /// Returns the surface between two curves, or inside the first if there is no second, with
    /// panels of the given size, as the text of an OBJ file.
    ///
    /// # Errors
    /// Why there is no such surface, in one sentence.
    pub fn mesh(&self, first: usize, second: Option<usize>, size: f64) -> Result<String, JsValue> {
        let mesh = self.surface(first, second, size).map_err(thrown)?;
        Ok(obj(&mesh, &self.units, self.up))
    }

    fn surface(&self, first: usize, second: Option<usize>, size: f64) -> Result<Mesh, SpanError> {
        let up = self.up.direction();
        let first = SpanCurve::of(&self.curves, first)?;
        match second {
            Some(second) => loft(first, SpanCurve::of(&self.curves, second)?, size, up),
            None => fill(first, size, up),
        }
    }
}

/// Returns the text of an OBJ file, with comments that state unit and up axis.
pub(super) fn obj(mesh: &Mesh, units: &str, up: Up) -> String {
    let comments = UnitsAndUp::comments(units, Some(up), mesh);
    write_obj_with(mesh, &mesh.positions, &[], &comments)
}

/// Returns the bytes of an example's scene or mesh by the name of the file.
///
/// # Errors
/// If no example has a file of that name.
#[wasm_bindgen(js_name = exampleFile)]
pub fn example_file(name: &str) -> Result<Vec<u8>, JsValue> {
    let text = example::example_file(name);
    Ok(text.ok_or_else(|| thrown(format!("there is no example file {name:?}")))?.into_bytes())
}

/// The names and texts of some files.
#[derive(Serialize, Tsify)]
pub struct NamedTexts(Vec<(String, String)>);

/// Returns the files of all examples.
///
/// # Errors
/// None: the texts are plain strings.
#[wasm_bindgen(js_name = exampleFiles)]
pub fn example_files() -> Result<Js<NamedTexts>, JsValue> {
    plain(&NamedTexts(example::example_files()))
}
