//! The flat map of the model in the worker (paper section 4, Eq. 14).

use super::solver::{Solver, object, plain};
use super::thrown;
use crate::mesh::{Histogram, Mesh, write_obj_with_uv};
use crate::solve::{ConformalNorm, ConformalWeights, Parametrization, clock};
use js_sys::{Float32Array, Float64Array, Uint32Array};
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
    /// that have some of these, `parts`, `closedParts`,
    /// `eigenvalue`, and `seconds`, by part in `secondsOf`. `weights` and `norm` are the words of the command line.
    ///
    /// # Errors
    /// A mesh without faces, a surface without area, or an unknown word.
    pub fn parametrize(&self, weights: &str, norm: &str) -> Result<JsValue, JsValue> {
        let weights = of_word("weights", weights, &ConformalWeights::WORDS)?;
        let norm = of_word("norm", norm, &ConformalNorm::WORDS)?;
        let session = self.open()?;
        if session.mesh().faces.is_empty() {
            return Err(thrown("the mesh has no faces, expected a surface"));
        }
        let started = clock::now();
        let shape = Mesh { positions: session.positions(), ..session.mesh().clone() };
        let map = Parametrization::new(&shape, session.topology(), weights, norm)
            .map_err(|error| thrown(format!("the surface cannot be flattened: {error}")))?;
        let seconds = clock::now() - started;
        let errors = &map.errors;
        let of_faces: Vec<f32> = errors.of_faces.iter().map(|&error| error as f32).collect();
        let histogram = Histogram::new(&errors.of_faces, LEAST_RANGE, BARS);
        object([
            ("histogram", Uint32Array::from(&histogram.counts[..]).into()),
            ("high", histogram.high.into()),
            ("uv", Float64Array::from(map.uv.as_flattened()).into()),
            ("faceErrors", Float32Array::from(&of_faces[..]).into()),
            ("mean", errors.quasi_conformal.mean.into()),
            ("max", errors.quasi_conformal.max.into()),
            ("flipped", (errors.flipped as f64).into()),
            ("flippedFaces", Uint32Array::from(&errors.flipped_faces[..]).into()),
            ("parts", (map.parts as f64).into()),
            ("closedParts", (map.closed_parts as f64).into()),
            ("eigenvalue", map.eigenvalue.into()),
            ("seconds", seconds.into()),
            ("secondsOf", plain(&map.seconds)?),
        ])
    }

    /// The current shape as OBJ with the texture coordinates `uv` (`#V by 2`) of each vertex.
    ///
    /// # Errors
    /// Another number of coordinates.
    #[wasm_bindgen(js_name = objWithUv)]
    pub fn obj_with_uv(&self, uv: &[f64]) -> Result<String, JsValue> {
        let session = self.open()?;
        let (uv, rest) = uv.as_chunks::<2>();
        let vertices = session.mesh().positions.len();
        if uv.len() != vertices || !rest.is_empty() {
            let got = 2 * uv.len() + rest.len();
            return Err(thrown(format!("{got} texture coordinates, expected {}", 2 * vertices)));
        }
        Ok(write_obj_with_uv(session.mesh(), &session.positions(), uv))
    }
}

/// What a word of the command line stands for.
fn of_word<T: Copy>(what: &str, word: &str, words: &[(&str, T)]) -> Result<T, JsValue> {
    let known = || words.iter().map(|(word, _)| *word).collect::<Vec<_>>().join(", ");
    let found = words.iter().find(|(known, _)| *known == word).map(|(_, value)| *value);
    found.ok_or_else(|| thrown(format!("{what} \"{word}\", expected one of {}", known())))
}
