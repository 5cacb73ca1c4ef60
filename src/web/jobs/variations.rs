//! The search for variations of the shape of the copy, and varied shapes, for
//! [`crate::web::worker::Solver::show_variation`].

use super::SLICE;
use super::model_copy::ModelCopy;
use crate::session::{ExactReport, Variations};
use crate::solve::{SLIDE, clock};
use crate::web::thrown;
use crate::web::values::{AsIs, Js, flat, narrow, plain};
use js_sys::{Float32Array, Float64Array};
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// The progress of the search for variations.
#[derive(Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct VariationProgress {
    /// The number of variations; none until the search has found them.
    found: Option<usize>,
    /// The least and greatest possible coefficient of each variation, if known.
    ranges: Vec<Option<[f64; 2]>>,
    /// Bound on the absolute value of the coefficients.
    slide: f64,
    /// Whether the search continues.
    more: bool,
}

/// A varied shape that was brought back onto the constraints.
#[derive(Serialize, Tsify)]
pub struct VariedShape {
    /// `#V by 3`.
    positions: AsIs<Float64Array>,
    /// See [`crate::session::Varied::part`].
    part: f64,
    report: ExactReport,
}

#[wasm_bindgen]
impl ModelCopy {
    /// Begins to search for variations of the shape; returns whether there can be any.
    #[wasm_bindgen(js_name = findVariations)]
    pub fn find_variations(&mut self) -> Result<bool, JsValue> {
        self.variations = self.session.variations().map_err(thrown)?;
        Ok(self.variations.is_some())
    }

    /// Continues the search for a slice.
    #[wasm_bindgen(js_name = advanceVariations)]
    pub fn advance_variations(&mut self) -> Result<Js<VariationProgress>, JsValue> {
        let variations = self.varied()?;
        let more = clock::repeat(SLICE, || variations.step()).map_err(thrown)?;
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

    /// See [`Variations::towards`].
    pub fn towards(&mut self, coefficients: &[f64]) -> Result<Float64Array, JsValue> {
        Ok(flat(&self.varied()?.towards(coefficients)))
    }

    /// See [`Variations::go`]; the positions are `#V by 3`.
    pub fn go(&mut self, coefficients: &[f64]) -> Result<Js<VariedShape>, JsValue> {
        let varied = self.varied()?.go(coefficients).map_err(thrown)?;
        let positions = AsIs(flat(&varied.positions));
        plain(&VariedShape { positions, part: varied.part, report: varied.report })
    }
}

impl ModelCopy {
    fn varied(&mut self) -> Result<&mut Variations, JsValue> {
        self.variations.as_mut().ok_or_else(no_variation)
    }
}

fn no_variation() -> JsValue {
    thrown("there is no such variation")
}
