//! The flat map of the copy (paper section 4.3, Eq. 14).

use super::model_copy::ModelCopy;
use crate::mesh::Histogram;
use crate::scene::NamedEnum;
use crate::solve::{ConformalNorm, ConformalWeights, FewerFlips, clock};
use crate::web::plain::{indices, narrow, object, of_word, plain};
use crate::web::thrown;
use js_sys::Float64Array;
use wasm_bindgen::prelude::*;

/// The colour range of a map is at least this wide: a difference of one per cent is hardly visible.
const LEAST_RANGE: [f64; 2] = [1.0, 1.01];
const BARS: usize = 24;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** Weights of polygons, and what the norm of a map is over: the words of the command line. */
export type MapWeights = "inverse-area" | "one" | "lscm";
export type MapNorm = "boundary" | "vertices";
/**
 * A conformal flat map (Eq. 14). The quasi-conformal error of a triangle is the ratio of its larger
 * to its smaller stretch: 1 if angles are preserved.
 */
export interface Parametrization {
    /** `#V by 2`, in the unit of the mesh. */
    uv: Float64Array;
    /** `#F`: the largest error of a face's triangles; NaN without area. */
    faceErrors: Float32Array;
    /** Faces by error, in bins of equal width from 1 to `high`; the last one includes all above. */
    histogram: Uint32Array;
    /** The 99th percentile of the errors. */
    high: number;
    /** The mean error, weighted by area. */
    mean: number;
    max: number;
    /** The number of flipped triangles, and the faces that have them. */
    flipped: number;
    flippedFaces: Uint32Array;
    /** The number of connected components, and of those without a boundary, which have no map without folds. */
    parts: number;
    closedParts: number;
    /** The number of faces that are not on the map: without area, or with the vertices of another face. */
    leftOut: number;
    eigenvalue: number;
    seconds: number;
    secondsOf: Record<"assemble" | "order" | "factor" | "iterate", number>;
}
/** Settings whose flat map has fewer flipped triangles, with their number and the mean error. */
export interface FewerFlips {
    weights: MapWeights;
    norm: MapNorm;
    flipped: number;
    mean: number;
}
"#;

#[wasm_bindgen]
impl ModelCopy {
    /// Computes the flat map of the current shape.
    ///
    /// `weights` and `norm` are the words of the command line.
    ///
    /// # Errors
    /// A mesh without faces, a surface without area, or an unknown word.
    #[wasm_bindgen(unchecked_return_type = "Parametrization")]
    pub fn parametrize(
        &self,
        #[wasm_bindgen(unchecked_param_type = "MapWeights")] weights: &str,
        #[wasm_bindgen(unchecked_param_type = "MapNorm")] norm: &str,
    ) -> Result<JsValue, JsValue> {
        let weights: ConformalWeights = of_word("weights", weights)?;
        let norm: ConformalNorm = of_word("norm", norm)?;
        let session = &self.session;
        if session.mesh().faces.is_empty() {
            return Err(thrown("the mesh has no faces, expected a surface"));
        }
        let started = clock::now();
        let map = session
            .parametrize(weights, norm)
            .map_err(|error| thrown(format!("the surface cannot be flattened: {error}")))?;
        let seconds = clock::now() - started;
        let errors = &map.errors;
        let histogram = Histogram::new(&errors.of_faces, LEAST_RANGE, BARS);
        object([
            ("histogram", indices(&histogram.counts)),
            ("high", histogram.high.into()),
            ("uv", Float64Array::from(map.uv.as_flattened()).into()),
            ("faceErrors", narrow(&errors.of_faces).into()),
            ("mean", errors.quasi_conformal.mean.into()),
            ("max", errors.quasi_conformal.max.into()),
            ("flipped", (errors.flipped as f64).into()),
            ("flippedFaces", indices(&errors.flipped_faces)),
            ("parts", (map.parts as f64).into()),
            ("closedParts", (map.closed_parts as f64).into()),
            ("leftOut", (map.left_out.len() as f64).into()),
            ("eigenvalue", map.eigenvalue.into()),
            ("seconds", seconds.into()),
            ("secondsOf", plain(&map.seconds)?),
        ])
    }

    /// Returns the weights and norm whose flat map of the current shape flips the fewest triangles,
    /// among those that flip fewer than `flipped`; null if no choice flips fewer. It computes the maps
    /// of all choices.
    #[wasm_bindgen(js_name = fewerFlips, unchecked_return_type = "FewerFlips | null")]
    pub fn fewer_flips(&self, flipped: usize) -> Result<JsValue, JsValue> {
        match self.session.fewer_flips(flipped) {
            None => Ok(JsValue::NULL),
            Some(FewerFlips { weights, norm, flipped, mean }) => object([
                ("weights", weights.word().into()),
                ("norm", norm.word().into()),
                ("flipped", (flipped as f64).into()),
                ("mean", mean.into()),
            ]),
        }
    }
}
