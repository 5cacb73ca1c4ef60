//! The flat map of the copy (paper section 4.3, Eq. 14).

use super::model_copy::ModelCopy;
use crate::mesh::Histogram;
use crate::solve::{ConformalNorm, ConformalWeights, FewerFlips, clock};
use crate::web::thrown;
use crate::web::values::{AsIs, Js, indices, narrow, plain, read};
use js_sys::{Float32Array, Float64Array, Uint32Array};
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// The colour range of a map is at least this wide: a difference of one per cent is hardly visible.
const LEAST_RANGE: [f64; 2] = [1.0, 1.01];
const BARS: usize = 24;

/// A conformal flat map (Eq. 14). The quasi-conformal error of a triangle is the ratio of its larger
/// to its smaller stretch: 1 if angles are preserved.
#[derive(Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct FlatMap {
    /// `#V by 2`, in the unit of the mesh.
    uv: AsIs<Float64Array>,
    /// `#F`: the largest error of a face's triangles; NaN without area.
    face_errors: AsIs<Float32Array>,
    /// Faces by error, in bins of equal width from 1 to `high`; the last one includes all above.
    histogram: AsIs<Uint32Array>,
    /// The 99th percentile of the errors.
    high: f64,
    /// The mean error, weighted by area.
    mean: f64,
    max: f64,
    /// The number of flipped triangles.
    flipped: usize,
    /// The faces that have them.
    flipped_faces: AsIs<Uint32Array>,
    /// The number of connected components.
    parts: usize,
    /// The number of those without a boundary, which have no map without folds.
    closed_parts: usize,
    /// The number of faces that are not on the map: without area, or with the vertices of another.
    left_out: usize,
    eigenvalue: f64,
    seconds: f64,
}

#[wasm_bindgen]
impl ModelCopy {
    /// Computes the flat map of the current shape.
    ///
    /// # Errors
    /// A mesh without faces, a surface without area.
    pub fn parametrize(
        &self,
        weights: Js<ConformalWeights>,
        norm: Js<ConformalNorm>,
    ) -> Result<Js<FlatMap>, JsValue> {
        let session = &self.session;
        if session.mesh().faces.is_empty() {
            return Err(thrown("the mesh has no faces, expected a surface"));
        }
        let started = clock::now();
        let map = session
            .parametrize(read(weights)?, read(norm)?)
            .map_err(|error| thrown(format!("the surface cannot be flattened: {error}")))?;
        let seconds = clock::now() - started;
        let errors = &map.errors;
        let histogram = Histogram::new(&errors.of_faces, LEAST_RANGE, BARS);
        plain(&FlatMap {
            uv: AsIs(Float64Array::from(map.uv.as_flattened())),
            face_errors: AsIs(narrow(&errors.of_faces)),
            histogram: indices(&histogram.counts),
            high: histogram.high,
            mean: errors.quasi_conformal.mean,
            max: errors.quasi_conformal.max,
            flipped: errors.flipped,
            flipped_faces: indices(&errors.flipped_faces),
            parts: map.parts,
            closed_parts: map.closed_parts,
            left_out: map.left_out.len(),
            eigenvalue: map.eigenvalue,
            seconds,
        })
    }

    /// Returns the weights and norm whose flat map of the current shape flips the fewest triangles,
    /// among those that flip fewer than `flipped`; undefined if no choice flips fewer. It computes the maps
    /// of all choices.
    #[wasm_bindgen(js_name = fewerFlips)]
    pub fn fewer_flips(&self, flipped: usize) -> Result<Option<Js<FewerFlips>>, JsValue> {
        self.session.fewer_flips(flipped).as_ref().map(plain).transpose()
    }
}
