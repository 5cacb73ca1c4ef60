//! Trials in slices beside the worker's other work: of edits that help where constraints are not met, and of being
//! exact.

use super::solver::Solver;
use crate::session::{ExactTrial, Remedies};
use crate::solve::clock;
use crate::web::plain::plain;
use crate::web::{log_panics, thrown};
use wasm_bindgen::prelude::*;

/// Trials of changes on a copy of the model that is open.
#[wasm_bindgen(js_name = RemedyTrials)]
pub struct RemedyTrials {
    remedies: Remedies,
}

#[wasm_bindgen(js_class = RemedyTrials)]
impl RemedyTrials {
    /// Begins; `solver` is only read now.
    #[wasm_bindgen(constructor)]
    pub fn new(solver: &Solver) -> Result<RemedyTrials, JsValue> {
        log_panics();
        let remedies = Remedies::new(solver.open()?).map_err(thrown)?;
        Ok(RemedyTrials { remedies })
    }

    /// Goes on for about so many milliseconds; whether there is more to try.
    pub fn advance(&mut self, milliseconds: f64) -> Result<bool, JsValue> {
        let until = clock::now() + 1e-3 * milliseconds;
        while self.remedies.step().map_err(thrown)? {
            if clock::now() >= until {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Those that help, the greatest help first.
    #[wasm_bindgen(unchecked_return_type = "Remedy[]")]
    pub fn found(&self) -> Result<JsValue, JsValue> {
        plain(&self.remedies.found())
    }
}

#[wasm_bindgen]
impl Solver {
    /// Begins to try what it would cost to be exact, from the shape that is open on.
    #[wasm_bindgen(js_name = tryExact)]
    pub fn try_exact(&mut self) -> Result<(), JsValue> {
        self.trial = self.open()?.exact_trial().map_err(thrown)?;
        Ok(())
    }

    /// Goes on with that for about so many milliseconds; whether there is more to do.
    pub fn advance(&mut self, milliseconds: f64) -> Result<bool, JsValue> {
        let Some(trial) = &mut self.trial else { return Ok(false) };
        let until = clock::now() + 1e-3 * milliseconds;
        while trial.step().map_err(thrown)? {
            if clock::now() > until {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// What it costs; null where nothing is asked within a distance.
    pub fn offer(&mut self) -> Result<JsValue, JsValue> {
        plain(&self.trial.as_mut().map(ExactTrial::offer))
    }

    /// Takes the exact shape, as a step of undo or as a part of the last one; whether it was of the current shape
    /// still.
    pub fn accept(&mut self, joins: bool) -> Result<bool, JsValue> {
        let Some(trial) = self.trial.take() else { return Ok(false) };
        self.open_mut()?.make_exact(&trial, joins).map_err(thrown)
    }
}
