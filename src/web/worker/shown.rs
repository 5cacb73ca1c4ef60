//! Arrays of the open model that the view draws: the mesh, positions, values of faces and vertices,
//! fitted shapes, projections, and the colours of the rows of constraints.

use super::solver::Solver;
use crate::constraint::Fitted;
use crate::session::{RowPalette, Shape};
use crate::web::thrown;
use crate::web::values::{AsIs, Js, indices, narrow, plain};
use js_sys::{Float32Array, Float64Array, Uint8Array, Uint32Array};
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// The connectivity of the mesh, as it is sent to the page.
#[derive(Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Connectivity {
    /// Where the corners of each face start, `#F + 1`.
    face_offsets: AsIs<Uint32Array>,
    /// The corners of all faces.
    face_indices: AsIs<Uint32Array>,
    /// Where the corners of each face that is left as it is start: their number plus one.
    untouched_offsets: AsIs<Uint32Array>,
    /// The corners of all faces that are left as they are.
    untouched_indices: AsIs<Uint32Array>,
    /// The vertices, ascending, whose positions are guesses, since the file has none.
    unplaced: AsIs<Uint32Array>,
    /// Where the vertices of each polyline start, `#curves + 1`.
    curve_offsets: AsIs<Uint32Array>,
    /// The vertices of all polylines.
    curve_indices: AsIs<Uint32Array>,
    /// `#E by 2`: the edges, in the numbering that selections use.
    edges: AsIs<Uint32Array>,
}

/// The values of a measure of faces.
#[derive(Serialize, Tsify)]
pub struct DrawnValues {
    /// `#F`, in the unit of the measure.
    values: AsIs<Float32Array>,
    /// The largest absolute value; rounding errors are 0.
    greatest: f64,
}

/// The projected points of all enabled constraints.
#[derive(Serialize, Tsify)]
pub struct DrawnProjections {
    /// `#points`: the vertex of each point.
    vertices: AsIs<Uint32Array>,
    /// `#points by 3`: from the vertex to the point, in the unit of the mesh.
    displacements: AsIs<Float32Array>,
    /// `#points`: an index in `palette` plus one.
    colours: AsIs<Uint8Array>,
    /// Pairs of points.
    outlines: AsIs<Uint32Array>,
    /// Three components from 0 to 1 per colour.
    palette: AsIs<Float32Array>,
}

/// The colour of the row of constraints that acts on each face and each vertex.
#[derive(Serialize, Tsify)]
pub struct DrawnRowColours {
    /// `#F`: 0 for none, else an index in `palette` plus one.
    faces: AsIs<Uint8Array>,
    /// `#V`: the same for constraints that cover no whole face.
    vertices: AsIs<Uint8Array>,
    /// Three components from 0 to 1 per colour.
    palette: AsIs<Float32Array>,
}

#[wasm_bindgen]
impl Solver {
    /// Returns the connectivity of the mesh.
    pub fn connectivity(&self) -> Result<Js<Connectivity>, JsValue> {
        let mesh = self.open()?.mesh();
        plain(&Connectivity {
            face_offsets: AsIs(self.face_offsets()?),
            face_indices: AsIs(self.face_indices()?),
            untouched_offsets: indices(mesh.untouched.offsets()),
            untouched_indices: indices(mesh.untouched.indices()),
            unplaced: indices(&mesh.unplaced),
            curve_offsets: indices(mesh.curves.offsets()),
            curve_indices: indices(mesh.curves.indices()),
            edges: AsIs(self.edges()?),
        })
    }

    /// Returns where the corners of each face start, `#F + 1`.
    #[wasm_bindgen(js_name = faceOffsets)]
    pub fn face_offsets(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.open()?.mesh().faces.offsets()))
    }

    /// Returns the corners of all faces.
    #[wasm_bindgen(js_name = faceIndices)]
    pub fn face_indices(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.open()?.mesh().faces.indices()))
    }

    /// Returns the edges of the mesh: `#E by 2` vertices, in the numbering that selections use.
    pub fn edges(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.open()?.topology().edges().as_flattened()))
    }

    /// Writes the current positions, `#V by 3`.
    #[wasm_bindgen(js_name = writePositions)]
    pub fn write_positions(&self, out: &Float64Array) -> Result<(), JsValue> {
        out.copy_from(self.open()?.positions().as_flattened());
        Ok(())
    }

    /// Returns the positions of the original, `#V by 3`.
    #[wasm_bindgen(js_name = originalPositions)]
    pub fn original_positions(&self) -> Result<Float64Array, JsValue> {
        Ok(Float64Array::from(self.open()?.mesh().positions.as_flattened()))
    }

    /// Returns the positions of a variant, `#V by 3`.
    #[wasm_bindgen(js_name = variantPositions)]
    pub fn variant_positions(&self, index: usize) -> Result<Float64Array, JsValue> {
        let kept = &self.open()?.document().variants.kept;
        let variant = kept.get(index).ok_or_else(|| thrown("there is no such variation"))?;
        Ok(Float64Array::from(variant.positions.as_flattened()))
    }

    /// Returns the values of a measure of faces.
    #[wasm_bindgen(js_name = faceValues)]
    pub fn face_values(&mut self, measure: &str) -> Result<Js<DrawnValues>, JsValue> {
        let (values, greatest) =
            self.open_mut()?.face_values_and_greatest(measure).ok_or_else(|| unknown(measure))?;
        plain(&DrawnValues { values: AsIs(narrow(&values)), greatest })
    }

    /// Returns the values of a measure on the faces of the original, `#F`, in its unit.
    #[wasm_bindgen(js_name = originalValues)]
    pub fn original_values(&mut self, measure: &str) -> Result<Float32Array, JsValue> {
        let values = self.open_mut()?.face_values_of(measure, &Shape::Original);
        values.map(|values| narrow(&values)).ok_or_else(|| unknown(measure))
    }

    /// Returns the values of the vertices, `#V`, of which each face has the largest as its value;
    /// undefined if the measure has no vertex values.
    #[wasm_bindgen(js_name = cornerValues)]
    pub fn corner_values(&self, measure: &str) -> Result<Option<Float32Array>, JsValue> {
        let values = self.open()?.corner_values(measure);
        Ok(values.map(|values| narrow(&values)))
    }

    /// Returns the fitted shapes to be drawn, eight numbers each: [`Fitted::numbers`]. The centres
    /// are in file coordinates, which single precision would round.
    pub fn fitted(&self) -> Result<Float64Array, JsValue> {
        let shapes = self.open()?.solver().fitted();
        Ok(Float64Array::from(&shapes.iter().flat_map(Fitted::numbers).collect::<Vec<f64>>()[..]))
    }

    /// Returns the projections of the constraints at the current positions.
    pub fn projections(&mut self) -> Result<Js<DrawnProjections>, JsValue> {
        let session = self.open_mut()?;
        let row_palette = session.row_palette();
        let found = session.projections();
        let colours: Vec<u8> =
            found.rows.iter().map(|&row| row_palette.of_row[row as usize]).collect();
        plain(&DrawnProjections {
            vertices: indices(&found.vertices),
            displacements: AsIs(narrow(found.displacements.as_flattened())),
            colours: AsIs(Uint8Array::from(&colours[..])),
            outlines: indices(found.outlines.as_flattened()),
            palette: palette(&row_palette),
        })
    }

    /// Returns the colour of the row of constraints that acts on each face and each vertex.
    #[wasm_bindgen(js_name = rowColours)]
    pub fn row_colours(&self) -> Result<Js<DrawnRowColours>, JsValue> {
        let session = self.open()?;
        let acting = session.acting_rows();
        let row_palette = session.row_palette();
        let of_rows = |of: &[Option<u32>]| {
            let colours =
                of.iter().map(|row| row.map_or(0, |row| row_palette.of_row[row as usize]));
            AsIs(Uint8Array::from(&colours.collect::<Vec<u8>>()[..]))
        };
        plain(&DrawnRowColours {
            faces: of_rows(&acting.faces),
            vertices: of_rows(&acting.vertices),
            palette: palette(&row_palette),
        })
    }
}

fn unknown(measure: &str) -> JsValue {
    thrown(format!("unknown measure {measure:?}"))
}

/// Returns the palette as three components from 0 to 1 per colour.
fn palette(rows: &RowPalette) -> AsIs<Float32Array> {
    let parts = rows.colours.as_flattened().iter();
    let parts: Vec<f32> = parts.map(|&part| f32::from(part) / 255.0).collect();
    AsIs(Float32Array::from(&parts[..]))
}
