//! Display options: projection, occlusion, section, ghost, ground, layer, bands, tape.

use super::view::View;
use crate::view::appearance::{Bands, ColourMap, LineKind};
use crate::view::line_drawing::line_drawing;
use crate::view::overlay::{SurfaceLines, scale_bar};
use crate::web::thrown;
use wasm_bindgen::prelude::*;

/// Number of colours that sample a continuous colour map.
const STOPS: usize = 32;

#[wasm_bindgen]
impl View {
    /// Selects parallel or perspective projection.
    #[wasm_bindgen(js_name = setParallel)]
    pub fn set_parallel(&mut self, parallel: bool) {
        self.model().set_parallel(parallel);
    }

    /// Returns the visible lines of the model as an SVG file for print.
    ///
    /// # Errors
    /// If nothing of the model is in the picture.
    #[wasm_bindgen(js_name = lineDrawing)]
    pub fn line_drawing(&mut self) -> Result<String, JsValue> {
        line_drawing(self.model()).map_err(thrown)
    }

    /// Sets the strength of the ambient occlusion, from 0 (none) to 1.
    #[wasm_bindgen(js_name = setOcclusion)]
    pub fn set_occlusion(&mut self, amount: f32) {
        self.model().set_occlusion(amount);
    }

    /// Cuts the model open with a plane across an axis of the file (0 to 2), at a fraction `part`
    /// of its extent, from 0 to 1. The side before the plane along the axis is kept, or the other
    /// one if `is_turned`. Without an axis the whole model is shown.
    ///
    /// # Errors
    /// An axis that does not exist.
    #[wasm_bindgen(js_name = setSection)]
    pub fn set_section(
        &mut self,
        axis: Option<usize>,
        part: f32,
        is_turned: bool,
    ) -> Result<(), JsValue> {
        let plane = axis.map(|axis| (axis, part, is_turned));
        self.model().set_section(plane).map_err(thrown)
    }

    /// Sets the colour map for values on all faces: `viridis`, `cividis`, `turbo`, `grey`, or
    /// `diverging` about the value `middle` (viridis without `middle`).
    ///
    /// # Errors
    /// Any other name.
    #[wasm_bindgen(js_name = setColourMap)]
    pub fn set_colour_map(&mut self, name: &str, middle: Option<f32>) -> Result<(), JsValue> {
        let map = ColourMap::named(name).map_err(thrown)?;
        self.model().appearance_mut().set_map(map, middle);
        Ok(())
    }

    /// Sets the positions of the mesh as it was opened, #V by 3, for ghost, ground and tape.
    ///
    /// # Errors
    /// A wrong number of vertices, or a coordinate that is not finite.
    #[wasm_bindgen(js_name = setRest)]
    pub fn set_rest(&mut self, positions: &[f64]) -> Result<(), JsValue> {
        self.model().set_rest(positions).map_err(thrown)
    }

    /// Shows or hides the ghost of the mesh as it was opened, and the grid on the ground.
    #[wasm_bindgen(js_name = setSurroundings)]
    pub fn set_surroundings(&mut self, ghost: bool, ground: bool) {
        self.model().set_surroundings(ghost, ground);
    }

    /// Shows a layer beside the surface: #V by 3 points, or none to hide it; with the edges (two
    /// vertices each) and vertices that fail.
    ///
    /// # Errors
    /// Arrays that do not fit the mesh; the old layer stays.
    #[wasm_bindgen(js_name = setLayer)]
    pub fn set_layer(
        &mut self,
        points: &[f64],
        failed_edges: &[u32],
        failed_vertices: Vec<u32>,
    ) -> Result<(), JsValue> {
        self.model().set_layer(points, failed_edges, failed_vertices).map_err(thrown)
    }

    /// Replaces the lines over the surface: polyline `k` has the points (#points by 3) from
    /// `offsets[k]` to `offsets[k + 1]`. The first `count` follow the larger principal curvature.
    ///
    /// # Errors
    /// Arrays that do not fit together; the old lines stay.
    #[wasm_bindgen(js_name = setSurfaceLines)]
    pub fn set_surface_lines(
        &mut self,
        points: &[f64],
        offsets: Vec<u32>,
        count: usize,
    ) -> Result<(), JsValue> {
        let lines = SurfaceLines::new(points, offsets, count).map_err(thrown)?;
        self.model().set_surface_lines(lines);
        Ok(())
    }

    /// Returns CSS colours of the lines along larger and smaller principal curvature, for a legend.
    #[wasm_bindgen(js_name = lineColours)]
    pub fn line_colours(&self) -> Vec<String> {
        let model = self.pictures.model();
        let css = |kind: LineKind| {
            let [r, g, b, _] = model.colour_over_surface(kind).map(|part| 255.0 * part);
            format!("rgb({r:.0} {g:.0} {b:.0})")
        };
        [LineKind::Larger, LineKind::Smaller].map(css).to_vec()
    }

    /// Returns the spacing of the ground grid, in the unit of the file; undefined without a grid.
    #[wasm_bindgen(js_name = gridStep)]
    pub fn grid_step(&self) -> Option<f64> {
        self.pictures.model().around().grid_step()
    }

    /// Returns the longest scale bar of round length that is at most `most` CSS pixels long: its
    /// length in the unit of the file, and in pixels.
    #[wasm_bindgen(js_name = scaleBar)]
    pub fn scale_bar(&self, most: f64) -> Vec<f64> {
        let bar = scale_bar(&self.pictures.model().camera(), most);
        vec![bar.length, bar.pixels]
    }

    /// Shows values of faces in bands, or continuously.
    #[wasm_bindgen(js_name = setBands)]
    pub fn set_bands(&mut self, in_bands: bool) {
        self.model().appearance_mut().set_in_bands(in_bands);
    }

    /// Sets the values of the vertices, #V, of which each face has the largest as its value; null
    /// if the measure has no vertex values.
    ///
    /// # Errors
    /// A wrong number of values.
    #[wasm_bindgen(js_name = setCornerValues)]
    pub fn set_corner_values(&mut self, values: Option<Vec<f32>>) -> Result<(), JsValue> {
        self.model().appearance_mut().set_corners(values).map_err(thrown)
    }

    /// Returns the spacing of the band limits, in the unit of the values or of their log10;
    /// undefined without bands.
    #[wasm_bindgen(js_name = bandStep)]
    pub fn band_step(&self) -> Option<f64> {
        self.bands().map(|bands| bands.step)
    }

    /// Returns the limits of the bands, as fractions of the range; empty without bands.
    #[wasm_bindgen(js_name = bandLimits)]
    pub fn band_limits(&self) -> Vec<f64> {
        self.bands().map_or_else(Vec::new, |bands| bands.limits.clone())
    }

    /// Returns the CSS colours of the range: one per band, or evenly spaced samples of the map.
    #[wasm_bindgen(js_name = rampColours)]
    pub fn ramp_colours(&self) -> Vec<String> {
        let appearance = self.pictures.model().appearance();
        let map = appearance.map();
        appearance.bands().map_or_else(|| map.stops(STOPS), |bands| bands.colours(map))
    }

    fn bands(&self) -> Option<&Bands> {
        self.pictures.model().appearance().bands()
    }

    /// Spans the measuring tape between two vertices. One vertex marks its start; none removes it.
    ///
    /// # Errors
    /// A vertex that does not exist, or more than two.
    #[wasm_bindgen(js_name = setTape)]
    pub fn set_tape(&mut self, vertices: &[u32]) -> Result<(), JsValue> {
        self.model().set_tape(vertices).map_err(thrown)
    }

    /// Returns the vector along the tape, in the unit of the file: x, y, z now, then at rest if
    /// known; undefined unless the tape spans two vertices.
    pub fn measured(&self) -> Option<Vec<f64>> {
        let measured = self.pictures.model().measured()?;
        let mut numbers = measured.now.to_array().to_vec();
        numbers.extend(measured.rest.iter().flat_map(|rest| rest.to_array()));
        Some(numbers)
    }

    /// Returns the canvas position of the middle of the tape, hidden or not; undefined without a
    /// tape or behind the eye.
    #[wasm_bindgen(js_name = tapeMiddle)]
    pub fn tape_middle(&self) -> Option<Vec<f32>> {
        self.pictures.model().tape_middle().map(|at| at.to_array().to_vec())
    }
}
