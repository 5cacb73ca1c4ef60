//! Meshes to begin with, for the page. They are in the module of parts, which comes when it is first asked for.

use super::{log_panics, plain_object as plain, thrown};
use crate::begin::{NEW_KINDS, NewKind, Plan};
use crate::mesh::{Mesh, write_obj};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// The surface over a drawn plan.
#[derive(Serialize, tsify::Tsify)]
struct NewPlan {
    /// Of an OBJ file.
    text: String,
    /// The vertices that it stands on where those are its corners alone; else none.
    feet: Vec<u32>,
}

/// The kinds of meshes to begin with.
///
/// # Errors
/// None: they are plain data.
#[wasm_bindgen(js_name = newKinds, unchecked_return_type = "NewKind[]")]
pub fn new_kinds() -> Result<JsValue, JsValue> {
    log_panics();
    plain(&NEW_KINDS)
}

/// A mesh of a kind with these sizes, in the order in which it declares them, as the text of an OBJ file.
///
/// # Errors
/// An unknown kind, or a size out of its limits.
#[wasm_bindgen(js_name = newMesh)]
pub fn new_mesh(kind: &str, sizes: &[f64], units: &str) -> Result<String, JsValue> {
    let kind = NewKind::of(kind).ok_or_else(|| thrown(format!("unknown kind {kind:?}")))?;
    Ok(obj(&kind.mesh(sizes).map_err(thrown)?, units))
}

/// The surface over a drawn plan.
///
/// # Errors
/// What is wrong with the plan, in one sentence.
#[wasm_bindgen(js_name = newPlan, unchecked_return_type = "NewPlan")]
pub fn new_plan(
    #[wasm_bindgen(unchecked_param_type = "Plan")] plan: JsValue,
    units: &str,
) -> Result<JsValue, JsValue> {
    let plan: Plan = serde_wasm_bindgen::from_value(plan).map_err(thrown)?;
    let surface = plan.surface().map_err(thrown)?;
    plain(&NewPlan { text: obj(&surface.mesh, units), feet: surface.feet })
}

fn obj(mesh: &Mesh, units: &str) -> String {
    format!("# units: {units}\n# up: z\n{}", write_obj(mesh, &mesh.positions))
}
