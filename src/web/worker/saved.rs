//! Steps of undo and unfinished work as bytes, to go on after a restart, and what a student hands in.

use super::solver::Solver;
use crate::fabricate::BUILD_NUMBERS;
use crate::web::{plain_object, thrown};
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

    /// The numbers of what is built that a lesson may bound.
    #[wasm_bindgen(js_name = buildNumbers)]
    pub fn build_numbers(&self) -> Result<JsValue, JsValue> {
        plain_object(&BUILD_NUMBERS)
    }

    /// Takes over numbers of what is built of the shape as it is: `ids` and as many `values`.
    #[wasm_bindgen(js_name = tellBuild)]
    pub fn tell_build(&mut self, ids: Vec<String>, values: &[f64]) -> Result<(), JsValue> {
        let numbers = ids.into_iter().zip(values.iter().copied()).collect();
        self.open_mut()?.tell_build(numbers);
        Ok(())
    }

    /// The file that `student` hands in.
    pub fn results(&mut self, student: &str, time: &str) -> Result<String, JsValue> {
        let results = self.open_mut()?.results(student, time);
        let results = results.ok_or_else(|| thrown("the scene has no lesson"))?;
        Ok(results.to_json())
    }
}
