//! Meshes to begin with.

use super::solver::Solver;
use crate::begin::{NEW_KINDS, NewKind};
use crate::mesh::write_obj;
use crate::scene::{UnitsAndUp, Up};
use crate::web::plain::plain;
use crate::web::thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// The kinds of meshes to begin with.
    #[wasm_bindgen(js_name = newKinds, unchecked_return_type = "NewKind[]")]
    pub fn new_kinds(&self) -> Result<JsValue, JsValue> {
        plain(&NEW_KINDS)
    }

    /// A mesh of a kind with these sizes, in the order in which it declares them, as the text of an OBJ file.
    #[wasm_bindgen(js_name = newMesh)]
    pub fn new_mesh(&self, kind: &str, sizes: &[f64], units: &str) -> Result<String, JsValue> {
        let kind = NewKind::of(kind).ok_or_else(|| thrown(format!("unknown kind {kind:?}")))?;
        let mesh = kind.mesh(sizes).map_err(thrown)?;
        Ok(UnitsAndUp::comments(units, Up::Z) + &write_obj(&mesh, &mesh.positions))
    }
}
