//! Trials in slices beside the worker's other work: edits that may help if constraints are not met,
//! exact solutions, and variations of a shape.

use super::solver::Solver;
use crate::session::Remedies;
use crate::solve::{SLIDE, clock};
use crate::web::plain::{narrow, plain};
use crate::web::{log_panics, thrown};
use js_sys::{Float32Array, Float64Array};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// Trials of edits on a copy of the open model.
#[wasm_bindgen(js_name = RemedyTrials)]
pub struct RemedyTrials {
    remedies: Remedies,
}

#[wasm_bindgen(js_class = RemedyTrials)]
impl RemedyTrials {
    /// Begins the trials; `solver` is read only during this call.
    #[wasm_bindgen(constructor)]
    pub fn new(solver: &Solver) -> Result<RemedyTrials, JsValue> {
        log_panics();
        let remedies = Remedies::new(solver.open()?).map_err(thrown)?;
        Ok(RemedyTrials { remedies })
    }

    /// Continues for about the given time; returns whether there is more to try.
    pub fn advance(&mut self, milliseconds: f64) -> Result<bool, JsValue> {
        clock::repeat(1e-3 * milliseconds, || self.remedies.step()).map_err(thrown)
    }

    /// Returns the edits that help, the most effective first.
    #[wasm_bindgen(unchecked_return_type = "Remedy[]")]
    pub fn found(&self) -> Result<JsValue, JsValue> {
        plain(&self.remedies.found())
    }
}

#[wasm_bindgen]
impl Solver {
    /// Begins a trial, from the current shape, to meet exactly what is met within a distance.
    #[wasm_bindgen(js_name = tryExact)]
    pub fn try_exact(&mut self) -> Result<(), JsValue> {
        self.trial = self.open()?.exact_trial().map_err(thrown)?;
        Ok(())
    }

    /// Begins to search the shapes that meet the requirements for one of lower energy.
    #[wasm_bindgen(js_name = tryImprovement)]
    pub fn try_improvement(&mut self) -> Result<(), JsValue> {
        self.trial = self.open()?.improvement().map_err(thrown)?;
        Ok(())
    }

    /// Continues the trial for about the given time; returns whether there is more to do.
    pub fn advance(&mut self, milliseconds: f64) -> Result<bool, JsValue> {
        let Some((trial, session)) = self.trial.as_mut().zip(self.session.as_ref()) else {
            return Ok(false);
        };
        clock::repeat(1e-3 * milliseconds, || trial.step(session)).map_err(thrown)
    }

    /// Returns the cost of exactness; null without a trial of the current shape and problem.
    #[wasm_bindgen(unchecked_return_type = "ExactOffer | null")]
    pub fn offer(&mut self) -> Result<JsValue, JsValue> {
        let both = self.trial.as_mut().zip(self.session.as_ref());
        plain(&both.and_then(|(trial, session)| trial.offer(session)))
    }

    /// Applies the shape of the trial, as a step of undo or as part of the last one (`joins`);
    /// returns whether the trial still belonged to the current shape.
    pub fn accept(&mut self, joins: bool) -> Result<bool, JsValue> {
        let Some(trial) = self.trial.take() else { return Ok(false) };
        self.open_mut()?.make_exact(&trial, joins).map_err(thrown)
    }
}

/// The progress of the search for variations.
#[derive(Serialize, tsify::Tsify)]
#[tsify(missing_as_null)]
pub(crate) struct VariationProgress {
    /// The number of variations; none until the search has found them.
    found: Option<usize>,
    /// The least and greatest possible coefficient of each variation, if known.
    ranges: Vec<Option<[f64; 2]>>,
    /// Bound on the absolute value of the coefficients.
    slide: f64,
    /// Whether the search continues.
    more: bool,
}

#[wasm_bindgen]
impl Solver {
    /// Begins to search for variations of the open shape; returns whether there can be any.
    #[wasm_bindgen(js_name = findVariations)]
    pub fn find_variations(&mut self) -> Result<bool, JsValue> {
        self.open_mut()?.leave_variation();
        self.variations = self.open()?.variations().map_err(thrown)?;
        Ok(self.variations.is_some())
    }

    /// Continues the search for about the given time.
    #[wasm_bindgen(js_name = advanceVariations, unchecked_return_type = "VariationProgress")]
    pub fn advance_variations(&mut self, milliseconds: f64) -> Result<JsValue, JsValue> {
        let Some(variations) = &mut self.variations else { return Err(no_variation()) };
        let more = clock::repeat(1e-3 * milliseconds, || variations.step()).map_err(thrown)?;
        plain(&VariationProgress {
            found: variations.are_found().then(|| variations.modes().len()),
            ranges: variations.modes().iter().map(|mode| mode.range).collect(),
            slide: SLIDE,
            more,
        })
    }

    /// Returns the displacement of a variation, `#V by 3`, for a coefficient of 1.
    pub fn variation(&self, index: usize) -> Result<Float32Array, JsValue> {
        let mut modes = self.variations.iter().flat_map(|variations| variations.modes());
        let mode = modes.nth(index).ok_or_else(no_variation)?;
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

    /// See [`crate::session::Session::project_variation`].
    #[wasm_bindgen(js_name = projectVariation)]
    pub fn project_variation(&mut self, coefficients: &[f64]) -> Result<Option<f64>, JsValue> {
        let (Some(session), Some(variations)) = (&mut self.session, &mut self.variations) else {
            return Ok(None);
        };
        session.project_variation(variations, coefficients).map_err(thrown)
    }

    /// See [`crate::session::Session::keep_variation`].
    #[wasm_bindgen(js_name = keepVariation)]
    pub fn keep_variation(&mut self) -> Result<bool, JsValue> {
        let (Some(session), Some(variations)) = (&mut self.session, &mut self.variations) else {
            return Ok(false);
        };
        session.keep_variation(variations).map_err(thrown)
    }

    /// Restores the shape from before a variation that is shown but not kept.
    #[wasm_bindgen(js_name = leaveVariation)]
    pub fn leave_variation(&mut self) -> Result<(), JsValue> {
        self.open_mut()?.leave_variation();
        Ok(())
    }

    /// Returns the numbers of the variants that were kept.
    #[wasm_bindgen(js_name = variantTable, unchecked_return_type = "VariantRow[]")]
    pub fn variant_table(&mut self, tolerance: f64) -> Result<JsValue, JsValue> {
        plain(&self.open_mut()?.variant_table(tolerance).map_err(thrown)?)
    }

    /// Returns the positions of a variant, `#V by 3`.
    #[wasm_bindgen(js_name = variantPositions)]
    pub fn variant_positions(&self, index: usize) -> Result<Float64Array, JsValue> {
        let kept = &self.open()?.document().variants.kept;
        let variant = kept.get(index).ok_or_else(|| thrown("there is no such variant"))?;
        Ok(Float64Array::from(variant.positions.as_flattened()))
    }
}

fn no_variation() -> JsValue {
    thrown("there is no such variation")
}
