//! The search for edits that help where constraints are not met, in slices beside the worker's other work.

use super::solver::Solver;
use crate::session::Remedies;
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
    pub fn found(&self) -> Result<JsValue, JsValue> {
        plain(&self.remedies.found())
    }
}
