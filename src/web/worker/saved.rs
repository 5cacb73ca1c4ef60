//! Steps of undo and unfinished work as bytes, to go on after a restart, and what a student hands in.

use super::solver::Solver;
use crate::web::thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// The steps of undo and redo. They belong to the scene as it stands, or as it stood before the run or
    /// the drag that goes on.
    #[wasm_bindgen(js_name = savedHistory)]
    pub fn saved_history(&self) -> Result<Vec<u8>, JsValue> {
        Ok(self.open()?.saved_history())
    }

    /// How far the run or the drag that goes on has come.
    #[wasm_bindgen(js_name = savedProgress)]
    pub fn saved_progress(&self) -> Result<Vec<u8>, JsValue> {
        Ok(self.open()?.saved_progress())
    }

    /// Goes on where the scene that was just opened stood when it was saved; either may be empty. What
    /// can be restored is, also when an error says that something cannot.
    pub fn restore(&mut self, history: &[u8], progress: &[u8]) -> Result<(), JsValue> {
        self.open_mut()?.restore(history, progress).map_err(thrown)
    }

    /// The file that `student` hands in.
    pub fn results(&mut self, student: &str, time: &str) -> Result<String, JsValue> {
        let results = self.open_mut()?.results(student, time);
        let results = results.ok_or_else(|| thrown("the scene has no lesson"))?;
        Ok(results.to_json())
    }
}
