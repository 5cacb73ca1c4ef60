//! Arrays of the session that the view draws: values of faces and vertices, fitted shapes, projections, and what
//! rows of constraints act on.

use super::solver::Solver;
use crate::constraint::Fitted;
use crate::session::{RowPalette, Shape};
use crate::web::plain::{indices, narrow, object};
use crate::web::thrown;
use js_sys::{Float32Array, Uint8Array};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// The values of a measure of faces, `#F`, in its unit.
    #[wasm_bindgen(js_name = faceValues)]
    pub fn face_values(&mut self, measure: &str) -> Result<Float32Array, JsValue> {
        let values = self.open_mut()?.face_values(measure);
        values.map(|values| narrow(&values)).ok_or_else(|| unknown(measure))
    }

    /// The fitted shapes to be drawn, eight numbers each: [`Fitted::numbers`].
    pub fn fitted(&self) -> Result<Float32Array, JsValue> {
        let shapes = self.open()?.solver().fitted();
        Ok(narrow(&shapes.iter().flat_map(Fitted::numbers).collect::<Vec<f64>>()))
    }

    /// The projections of the constraints at the current positions: per point its vertex
    /// (`vertices`), the way from there to the point (`ways`, `#points by 3`, units of the mesh), and
    /// one more than the place of its colour in `palette` (`colours`); `outlines` are pairs of points.
    pub fn projections(&mut self) -> Result<JsValue, JsValue> {
        let session = self.open_mut()?;
        let rows = session.row_palette();
        let found = session.projections();
        let colours: Vec<u8> = found.rows.iter().map(|&row| rows.places[row as usize]).collect();
        object([
            ("vertices", indices(&found.vertices)),
            ("ways", narrow(found.ways.as_flattened()).into()),
            ("colours", Uint8Array::from(&colours[..]).into()),
            ("outlines", indices(found.outlines.as_flattened())),
            ("palette", palette(&rows)),
        ])
    }

    /// The faces and vertices that row `constraint` acts on.
    pub fn members(&self, constraint: usize) -> Result<JsValue, JsValue> {
        let [faces, vertices] = self.open()?.members(constraint);
        object([("faces", indices(&faces)), ("vertices", indices(&vertices))])
    }

    /// The colour of the row of constraints that acts on each face and each vertex: `faces` (`#F`)
    /// and `vertices` (`#V`) are 0 where there is none, else one more than a place in `palette`,
    /// three numbers from 0 to 1 per colour.
    #[wasm_bindgen(js_name = rowColours)]
    pub fn row_colours(&self) -> Result<JsValue, JsValue> {
        let session = self.open()?;
        let acting = session.acting_rows();
        let rows = session.row_palette();
        let of_rows = |of: &[Option<u32>]| {
            let places = of.iter().map(|row| row.map_or(0, |row| rows.places[row as usize]));
            JsValue::from(Uint8Array::from(&places.collect::<Vec<u8>>()[..]))
        };
        object([
            ("faces", of_rows(&acting.faces)),
            ("vertices", of_rows(&acting.vertices)),
            ("palette", palette(&rows)),
        ])
    }

    /// The values of a measure of the faces of the original, `#F`, in its unit.
    #[wasm_bindgen(js_name = originalValues)]
    pub fn original_values(&mut self, measure: &str) -> Result<Float32Array, JsValue> {
        let values = self.open_mut()?.face_values_of(measure, Shape::Original);
        values.map(|values| narrow(&values)).ok_or_else(|| unknown(measure))
    }

    /// The values of the vertices, `#V`, whose largest the faces have in a measure; nothing where the
    /// measure is not of vertices.
    #[wasm_bindgen(js_name = cornerValues)]
    pub fn corner_values(&self, measure: &str) -> Result<Option<Float32Array>, JsValue> {
        let values = self.open()?.corner_values(measure);
        Ok(values.map(|values| narrow(&values)))
    }
}

fn unknown(measure: &str) -> JsValue {
    thrown(format!("unknown measure {measure:?}"))
}

/// Three parts from 0 to 1 per colour.
fn palette(rows: &RowPalette) -> JsValue {
    let parts = rows.colours.as_flattened().iter();
    let parts: Vec<f32> = parts.map(|&part| f32::from(part) / 255.0).collect();
    Float32Array::from(&parts[..]).into()
}
