//! Trials in slices beside the worker's other work: of edits that help where constraints are not met, of being exact,
//! and of ways to change a shape that is.

use super::solver::Solver;
use crate::session::Remedies;
use crate::solve::{SLIDE, clock};
use crate::web::plain::{narrow, plain};
use crate::web::{log_panics, thrown};
use js_sys::{Float32Array, Float64Array};
use serde::Serialize;
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

    /// Begins to look for less energy among the shapes that meet what is required.
    #[wasm_bindgen(js_name = tryImprovement)]
    pub fn try_improvement(&mut self) -> Result<(), JsValue> {
        self.trial = self.open()?.improvement().map_err(thrown)?;
        Ok(())
    }

    /// Goes on with that for about so many milliseconds; whether there is more to do.
    pub fn advance(&mut self, milliseconds: f64) -> Result<bool, JsValue> {
        let Some((trial, session)) = self.trial.as_mut().zip(self.session.as_ref()) else {
            return Ok(false);
        };
        let until = clock::now() + 1e-3 * milliseconds;
        while trial.step(session).map_err(thrown)? {
            if clock::now() > until {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The cost of exactness; null where nothing is hard.
    pub fn offer(&mut self) -> Result<JsValue, JsValue> {
        let both = self.trial.as_mut().zip(self.session.as_ref());
        plain(&both.map(|(trial, session)| trial.offer(session)))
    }

    /// Takes the exact shape, as a step of undo or as a part of the last one; whether it was of the current shape
    /// still.
    pub fn accept(&mut self, joins: bool) -> Result<bool, JsValue> {
        let Some(trial) = self.trial.take() else { return Ok(false) };
        self.open_mut()?.make_exact(&trial, joins).map_err(thrown)
    }
}

/// How far the search for variations has come.
#[derive(Serialize, tsify::Tsify)]
#[tsify(missing_as_null)]
pub(crate) struct VariationProgress {
    /// How many there are; none while they are not found.
    found: Option<usize>,
    /// The least and the greatest coefficient of each that is possible, where it is known.
    ranges: Vec<Option<[f64; 2]>>,
    /// How far the coefficients go to either side.
    slide: f64,
    /// Whether there is more to find.
    more: bool,
}

#[wasm_bindgen]
impl Solver {
    /// Begins to look for ways to change the shape that is open; whether there can be any.
    #[wasm_bindgen(js_name = findVariations)]
    pub fn find_variations(&mut self) -> Result<bool, JsValue> {
        self.open_mut()?.leave_variation();
        self.variations = self.open()?.variations().map_err(thrown)?;
        Ok(self.variations.is_some())
    }

    /// Goes on with that for about so many milliseconds.
    #[wasm_bindgen(js_name = advanceVariations, unchecked_return_type = "VariationProgress")]
    pub fn advance_variations(&mut self, milliseconds: f64) -> Result<JsValue, JsValue> {
        let Some(variations) = &mut self.variations else { return Err(nothing_found()) };
        let until = clock::now() + 1e-3 * milliseconds;
        let mut more = true;
        while more && clock::now() < until {
            more = variations.step().map_err(thrown)?;
        }
        plain(&VariationProgress {
            found: variations.are_found().then(|| variations.modes().len()),
            ranges: variations.modes().iter().map(|mode| mode.range).collect(),
            slide: SLIDE,
            more,
        })
    }

    /// The displacement of one, `#V by 3`, for a coefficient of one.
    pub fn variation(&self, index: usize) -> Result<Float32Array, JsValue> {
        let mut modes = self.variations.iter().flat_map(|variations| variations.modes());
        let mode = modes.nth(index).ok_or_else(nothing_found)?;
        Ok(narrow(mode.displacement.as_flattened()))
    }

    /// See [`crate::session::Session::show_variation`].
    #[wasm_bindgen(js_name = showVariation)]
    pub fn show_variation(&mut self, coefficients: &[f64]) -> Result<bool, JsValue> {
        let (Some(session), Some(variations)) = (&mut self.session, &mut self.variations) else {
            return Ok(false);
        };
        Ok(session.show_variation(variations, coefficients))
    }

    /// See [`crate::session::Session::reach_variation`].
    #[wasm_bindgen(js_name = reachVariation)]
    pub fn reach_variation(&mut self, coefficients: &[f64]) -> Result<Option<f64>, JsValue> {
        let (Some(session), Some(variations)) = (&mut self.session, &mut self.variations) else {
            return Ok(None);
        };
        session.reach_variation(variations, coefficients).map_err(thrown)
    }

    /// See [`crate::session::Session::keep_variation`].
    #[wasm_bindgen(js_name = keepVariation)]
    pub fn keep_variation(&mut self) -> Result<bool, JsValue> {
        let (Some(session), Some(variations)) = (&mut self.session, &mut self.variations) else {
            return Ok(false);
        };
        session.keep_variation(variations).map_err(thrown)
    }

    /// Goes back from a variation that is shown and not kept.
    #[wasm_bindgen(js_name = leaveVariation)]
    pub fn leave_variation(&mut self) -> Result<(), JsValue> {
        self.open_mut()?.leave_variation();
        Ok(())
    }

    /// The numbers of the variants that are kept.
    #[wasm_bindgen(js_name = variantTable, unchecked_return_type = "VariantRow[]")]
    pub fn variant_table(&mut self, tolerance: f64) -> Result<JsValue, JsValue> {
        plain(&self.open_mut()?.variant_table(tolerance).map_err(thrown)?)
    }

    /// The positions of one, `#V by 3`.
    #[wasm_bindgen(js_name = variantPositions)]
    pub fn variant_positions(&self, index: usize) -> Result<Float64Array, JsValue> {
        let kept = &self.open()?.document().variants.kept;
        let variant = kept.get(index).ok_or_else(nothing_found)?;
        Ok(Float64Array::from(variant.positions.as_flattened()))
    }

    /// The values of a measure of its faces, `#F`.
    #[wasm_bindgen(js_name = variantValues)]
    pub fn variant_values(&mut self, index: usize, measure: &str) -> Result<Float32Array, JsValue> {
        let values = self.open_mut()?.variant_values(index, measure).map_err(thrown)?;
        values.map(|values| narrow(&values)).ok_or_else(nothing_found)
    }
}

fn nothing_found() -> JsValue {
    thrown("there is no such variation")
}
