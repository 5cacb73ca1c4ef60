//! A copy of the open model.

use crate::session::{ExactTrial, FileReader, OpenedFile, Remedies, Session, Variations};
use crate::web::plain::plain;
use crate::web::worker::ForecastWords;
use crate::web::{log_panics, thrown};
use wasm_bindgen::prelude::*;

/// A copy of the open model, and what is tried on it.
#[wasm_bindgen]
pub struct ModelCopy {
    pub(super) session: Session,
    pub(super) trial: Option<Trial>,
    pub(super) variations: Option<Variations>,
}

/// What is being tried.
pub(super) enum Trial {
    Exact(Box<ExactTrial>),
    Remedies(Box<Remedies>),
}

#[wasm_bindgen]
impl ModelCopy {
    /// Opens the text of a scene with its mesh, which the solver has at this generation.
    ///
    /// # Errors
    /// As opening the scene; not expected, since it is open in the solver.
    #[wasm_bindgen(constructor)]
    pub fn new(scene: &str, generation: u32) -> Result<ModelCopy, JsValue> {
        log_panics();
        let file = FileReader::default().read("copy.json", scene.as_bytes()).map_err(thrown)?;
        let OpenedFile { scene, mesh, .. } = file;
        let session = Session::open_copy(scene, mesh, generation).map_err(thrown)?;
        Ok(ModelCopy { session, trial: None, variations: None })
    }

    /// Returns in words how far making panels of one shape will move the mesh, and a change of the
    /// mesh that would reduce it; null if no shape is offered.
    #[wasm_bindgen(unchecked_return_type = "ForecastWords | null")]
    pub fn forecast(&self) -> Result<JsValue, JsValue> {
        plain(&self.session.forecast().as_ref().map(ForecastWords::of))
    }
}
