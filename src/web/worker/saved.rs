//! Undo history and unfinished work as bytes, for a restart, and the results of a student.

use super::solver::Solver;
use crate::fabricate::BUILD_NUMBERS;
use crate::web::{plain_object, thrown};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// Returns the steps of undo and redo, which belong to the current scene or, during a run or
    /// drag, to the scene before it.
    #[wasm_bindgen(js_name = savedHistory)]
    pub fn saved_history(&self) -> Result<Vec<u8>, JsValue> {
        Ok(self.open()?.saved_history())
    }

    /// Returns the progress of the current run or drag.
    #[wasm_bindgen(js_name = savedProgress)]
    pub fn saved_progress(&self) -> Result<Vec<u8>, JsValue> {
        Ok(self.open()?.saved_progress())
    }

    /// Restores the saved history and progress of the scene that was just opened; either may be
    /// empty. Restores as much as it can, even if it returns an error.
    pub fn restore(&mut self, history: &[u8], progress: &[u8]) -> Result<(), JsValue> {
        self.open_mut()?.restore(history, progress).map_err(thrown)
    }

    /// Returns the numbers of the build that a lesson may bound.
    #[wasm_bindgen(js_name = buildNumbers, unchecked_return_type = "BuildNumber[]")]
    pub fn build_numbers(&self) -> Result<JsValue, JsValue> {
        plain_object(&BUILD_NUMBERS)
    }

    /// Stores numbers of the build of the current shape: `ids` and as many `values`.
    #[wasm_bindgen(js_name = setBuildNumbers)]
    pub fn set_build_numbers(&mut self, ids: Vec<String>, values: &[f64]) -> Result<(), JsValue> {
        let numbers = ids.into_iter().zip(values.iter().copied()).collect();
        self.open_mut()?.set_build_numbers(numbers);
        Ok(())
    }

    /// Returns the file that `student` hands in.
    pub fn results(&mut self, student: &str, time: &str) -> Result<String, JsValue> {
        let results = self.open_mut()?.results(student, time);
        let results = results.ok_or_else(|| thrown("the scene has no lesson"))?;
        Ok(results.to_json())
    }
}
