//! The flat map of the model in the worker (paper section 4.3, Eq. 14).

use super::solver::Solver;
use crate::mesh::Histogram;
use crate::scene::NamedEnum;
use crate::solve::{ConformalNorm, ConformalWeights, FewerFlips, clock};
use crate::web::plain::{indices, narrow, object, plain};
use crate::web::thrown;
use js_sys::Float64Array;
use wasm_bindgen::prelude::*;

/// The colours of a map span at least this: a difference of one per cent is hardly seen in a shape.
const LEAST_RANGE: [f64; 2] = [1.0, 1.01];
/// Bars of the histogram of errors.
const BARS: usize = 24;

#[wasm_bindgen]
impl Solver {
    /// The flat map of the current shape: `uv` (`#V by 2`, units of the mesh), `faceErrors` (`#F`, the
    /// greatest quasi-conformal error of the triangles of each face, not a number without area), `mean`
    /// (weighted by area) and `max` of the error, `histogram` (faces, from 1 up to `high`), `flipped` triangles, `flippedFaces`
    /// that have some of these, `parts`, `closedParts`, `leftOut` faces without area or on the same vertices
    /// as another,
    /// `eigenvalue`, and `seconds`, by part in `secondsOf`. `weights` and `norm` are the words of the command line.
    ///
    /// # Errors
    /// A mesh without faces, a surface without area, or an unknown word.
    pub fn parametrize(&self, weights: &str, norm: &str) -> Result<JsValue, JsValue> {
        let weights: ConformalWeights = of_word("weights", weights)?;
        let norm: ConformalNorm = of_word("norm", norm)?;
        let session = self.open()?;
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

    /// The weights and norm whose flat map of the current shape turns fewest triangles over, of those that
    /// turn fewer than `flipped`: `weights`, `norm`, `flipped` and `mean`, as [`Solver::parametrize`] has them. Null
    /// where all turn as many. It makes every map that there is.
    ///
    /// # Errors
    /// No model is open.
    #[wasm_bindgen(js_name = fewerFlips)]
    pub fn fewer_flips(&self, flipped: usize) -> Result<JsValue, JsValue> {
        match self.open()?.fewer_flips(flipped) {
            None => Ok(JsValue::NULL),
            Some(FewerFlips { weights, norm, flipped, mean }) => object([
                ("weights", weights.word().into()),
                ("norm", norm.word().into()),
                ("flipped", (flipped as f64).into()),
                ("mean", mean.into()),
            ]),
        }
    }

    /// The current shape as OBJ with the texture coordinates `uv` (`#V by 2`) of each vertex.
    ///
    /// # Errors
    /// Another number of coordinates.
    #[wasm_bindgen(js_name = objWithUv)]
    pub fn obj_with_uv(&self, uv: &[f64]) -> Result<String, JsValue> {
        let session = self.open()?;
        let (pairs, rest) = uv.as_chunks::<2>();
        if !rest.is_empty() {
            let numbers = uv.len();
            return Err(thrown(format!("{numbers} texture coordinates, expected pairs of them")));
        }
        session.obj_with_uv(pairs).map_err(thrown)
    }
}

/// The choice that a word of the command line names.
pub(super) fn of_word<T: NamedEnum>(what: &str, word: &str) -> Result<T, JsValue> {
    let unknown = || thrown(format!("{what} \"{word}\", expected one of {}", T::list(", ")));
    T::of_word(word).ok_or_else(unknown)
}
