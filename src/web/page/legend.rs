//! The legend of the colours of faces.

use super::view::View;
use crate::view::appearance::{Bars, Coloured, RangeChoice, ValueAxis, ValueSpread};
use crate::web::thrown;
use wasm_bindgen::prelude::*;

/// The range of the colours, and the distribution of the values.
#[wasm_bindgen(getter_with_clone)]
#[derive(Clone, Debug)]
pub struct LegendNumbers {
    /// The values at the first and at the last colour.
    pub range: Vec<f64>,
    /// The values at the ends of the axis.
    pub axis: Vec<f64>,
    /// The positions on the axis, from 0 to 1: of the ends of the range, and of the tolerance if there
    /// is one.
    pub places: Vec<f64>,
    /// The number of faces per bar, #bars.
    pub counts: Vec<u32>,
    /// The greatest absolute value.
    pub greatest: f64,
    /// The same bars for the original shape, if it is known.
    #[wasm_bindgen(js_name = originalCounts)]
    pub original_counts: Option<Vec<u32>>,
    /// The greatest absolute value of the original shape, if it is known.
    #[wasm_bindgen(js_name = originalGreatest)]
    pub original_greatest: Option<f64>,
    /// The number of faces with a value.
    pub faces: u32,
    /// The number of faces within the tolerance; all without one.
    pub within: u32,
}

#[wasm_bindgen]
impl View {
    /// Chooses the range of the colours for values of the faces, #F, and counts them. `original`: of
    /// the original shape, if known. `coloured`: which values have colours, `all`, `beyond` the
    /// tolerance, or `signed` for values of both signs. `bounds`: the bound below which values are
    /// rounding errors; then start and end of the range and end of the axis, NaN for those that are
    /// automatic.
    ///
    /// # Errors
    /// Any other name, or another number of bounds.
    #[wasm_bindgen(js_name = legendNumbers)]
    pub fn legend_numbers(
        &self,
        values: &[f32],
        original: Option<Vec<f32>>,
        coloured: &str,
        logarithmic: bool,
        tolerance: Option<f64>,
        bounds: &[f64],
    ) -> Result<LegendNumbers, JsValue> {
        let coloured = match coloured {
            "all" => Coloured::All,
            "beyond" => Coloured::Beyond,
            "signed" => Coloured::Signed,
            _ => return Err(thrown(format!("unknown values {coloured:?}"))),
        };
        let &[rounding, low, high, top] = bounds else {
            return Err(thrown(format!("found {} bounds, expected four", bounds.len())));
        };
        let [low, high, top] = [low, high, top].map(|end| (!end.is_nan()).then_some(end));
        let choice = RangeChoice { coloured, logarithmic, tolerance, rounding, low, high, top };
        let ValueSpread { range, axis, now, original, faces, within } =
            ValueSpread::new(values, original.as_deref(), &choice);
        let places = range.into_iter().chain(tolerance).map(|value| axis.part(value)).collect();
        let (original_counts, original_greatest) =
            original.map(|Bars { counts, greatest }| (counts, greatest)).unzip();
        Ok(LegendNumbers {
            range: range.to_vec(),
            axis: vec![axis.low, axis.high],
            places,
            counts: now.counts,
            greatest: now.greatest,
            original_counts,
            original_greatest,
            faces,
            within,
        })
    }

    /// Returns the value at a position, from 0 to 1, of the axis of a legend.
    #[wasm_bindgen(js_name = valueOnAxis)]
    pub fn value_on_axis(&self, low: f64, high: f64, logarithmic: bool, part: f64) -> f64 {
        ValueAxis::new(low, high, logarithmic).value(part)
    }
}
