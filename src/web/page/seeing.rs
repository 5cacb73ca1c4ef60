//! Ways of seeing beside the plain picture: projection, flights to views, ghost, ground, layer, bands, tape.

use super::view::View;
use crate::view::appearance::{Bands, LineKind};
use crate::view::overlay::{SurfaceLines, scale_bar};
use crate::view::svg::line_drawing::line_drawing;
use crate::web::thrown;
use wasm_bindgen::prelude::*;

/// Colours of the map that stand for all of it.
const STOPS: usize = 32;

#[wasm_bindgen]
impl View {
    /// Parallel projection, or perspective.
    #[wasm_bindgen(js_name = setParallel)]
    pub fn set_parallel(&mut self, parallel: bool) {
        self.pictures.set_parallel(parallel);
    }

    /// The lines of the model that are seen, as an SVG file for print.
    #[wasm_bindgen(js_name = lineDrawing)]
    pub fn line_drawing(&mut self) -> String {
        line_drawing(self.model())
    }

    /// Shows so much of it that what is near keeps light off, from 0 (none) to 1.
    #[wasm_bindgen(js_name = setOcclusion)]
    pub fn set_occlusion(&mut self, amount: f32) {
        self.model().set_occlusion(amount);
    }

    /// Cuts the model open across an axis of the file (0 to 2), at a part of the way through it from 0 to 1;
    /// kept is what comes before the plane along the axis, or after it when it is turned. Without an axis all
    /// is shown.
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

    /// The map of values when all of them have colours: `viridis`, `grey`, or `diverging` from both sides of a
    /// value in the middle, without which it is viridis.
    ///
    /// # Errors
    /// Any other name.
    #[wasm_bindgen(js_name = setColourMap)]
    pub fn set_colour_map(&mut self, name: &str, middle: Option<f32>) -> Result<(), JsValue> {
        self.model().set_colour_map(name, middle).map_err(thrown)
    }

    /// Prepares a flight from where the camera is now to where it is at `takeOff`; `fly` makes it.
    #[wasm_bindgen(js_name = planFlight)]
    pub fn plan_flight(&mut self) {
        self.pictures.plan_flight();
    }

    /// Puts the camera back to where the flight begins.
    #[wasm_bindgen(js_name = takeOff)]
    pub fn take_off(&mut self) {
        self.pictures.take_off();
    }

    /// Ends a flight where it leads.
    pub fn arrive(&mut self) {
        self.pictures.arrive();
    }

    /// Flies on to `part` of the way, from 0 to 1. Whether the flight goes on: it ends where it
    /// arrives, and when the camera is moved otherwise.
    pub fn fly(&mut self, part: f32) -> bool {
        self.pictures.fly(part)
    }

    /// Takes the positions of the mesh as it was opened, #V by 3: the ghost, the ground and the tape go
    /// by them.
    ///
    /// # Errors
    /// Another number of vertices, or a coordinate that is not finite.
    #[wasm_bindgen(js_name = setRest)]
    pub fn set_rest(&mut self, positions: &[f64]) -> Result<(), JsValue> {
        self.model().set_rest(positions).map_err(thrown)
    }

    /// Shows or hides the ghost of the mesh as it was opened, and the grid on the ground.
    #[wasm_bindgen(js_name = setSurroundings)]
    pub fn set_surroundings(&mut self, ghost: bool, ground: bool) {
        self.model().set_surroundings(ghost, ground);
    }

    /// Shows a layer beside the surface: #V by 3, or nothing for none; with the edges that fail, two vertices
    /// each, and the vertices that do.
    ///
    /// # Errors
    /// Arrays that do not fit the mesh; the layer stays.
    #[wasm_bindgen(js_name = setLayer)]
    pub fn set_layer(
        &mut self,
        points: &[f64],
        failed_edges: &[u32],
        failed_vertices: Vec<u32>,
    ) -> Result<(), JsValue> {
        self.model().set_layer(points, failed_edges, failed_vertices).map_err(thrown)
    }

    /// Shows lines over the surface instead of those before: polyline `k` goes through the points, #points by 3, from
    /// `offsets[k]` to `offsets[k + 1]`. The first `count` are along the larger principal curvature.
    ///
    /// # Errors
    /// Arrays that do not fit together; the lines stay.
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

    /// CSS colours of the lines along the larger and the smaller principal curvature, for a legend.
    #[wasm_bindgen(js_name = lineColours)]
    pub fn line_colours(&self) -> Vec<String> {
        let model = self.pictures.model();
        let css = |kind: LineKind| {
            let [r, g, b, _] = model.colour_over_surface(kind).map(|part| 255.0 * part);
            format!("rgb({r:.0} {g:.0} {b:.0})")
        };
        [LineKind::Larger, LineKind::Smaller].map(css).to_vec()
    }

    /// From one line of the grid on the ground to the next, in the unit of the file; nothing where there
    /// is no grid.
    #[wasm_bindgen(js_name = gridStep)]
    pub fn grid_step(&self) -> Option<f64> {
        self.pictures.model().around().grid_step()
    }

    /// The longest bar of round length that is at most `most` CSS pixels long: its length in the unit
    /// of the file, and how long it is.
    #[wasm_bindgen(js_name = scaleBar)]
    pub fn scale_bar(&self, most: f64) -> Vec<f64> {
        let bar = scale_bar(&self.pictures.model().camera(), most);
        vec![bar.length, bar.pixels]
    }

    /// Shows values of faces in bands, or gradually.
    #[wasm_bindgen(js_name = setBands)]
    pub fn set_bands(&mut self, in_bands: bool) {
        self.pictures.set_in_bands(in_bands);
    }

    /// Tells the values of the vertices, #V, whose greatest those of the faces are; null where they are
    /// not of vertices.
    ///
    /// # Errors
    /// Another number of values than vertices.
    #[wasm_bindgen(js_name = setCornerValues)]
    pub fn set_corner_values(&mut self, values: Option<Vec<f32>>) -> Result<(), JsValue> {
        self.model().set_corner_values(values).map_err(thrown)
    }

    /// From one limit of the bands to the next, in the unit of the values, or of their logarithm to the
    /// base 10; nothing without bands. Of the
    /// left (0) or right (1) of two pictures, if a side is given; so in what follows.
    #[wasm_bindgen(js_name = bandStep)]
    pub fn band_step(&self, side: Option<usize>) -> Option<f64> {
        self.bands(side).map(|bands| bands.step)
    }

    /// The limits of the bands, as parts of the range from 0 to 1; none without bands.
    #[wasm_bindgen(js_name = bandLimits)]
    pub fn band_limits(&self, side: Option<usize>) -> Vec<f64> {
        self.bands(side).map_or_else(Vec::new, |bands| bands.limits.clone())
    }

    /// CSS colours of what the range is painted with: one for each band, or evenly over the map.
    #[wasm_bindgen(js_name = rampColours)]
    pub fn ramp_colours(&self, side: Option<usize>) -> Vec<String> {
        let appearance = self.pictures.appearance(side);
        let map = appearance.map();
        appearance.bands().map_or_else(|| map.stops(STOPS), |bands| bands.colours(map))
    }

    fn bands(&self, side: Option<usize>) -> Option<&Bands> {
        self.pictures.appearance(side).bands()
    }

    /// Spans the measuring tape between two vertices; one is where it begins, none takes it away.
    ///
    /// # Errors
    /// A vertex that does not exist, or more than two.
    #[wasm_bindgen(js_name = setTape)]
    pub fn set_tape(&mut self, vertices: &[u32]) -> Result<(), JsValue> {
        self.model().set_tape(vertices).map_err(thrown)
    }

    /// The vector along the tape, in the unit of the file: x, y, z now, and at rest if that is known;
    /// nothing unless it spans two vertices.
    pub fn measured(&self) -> Option<Vec<f64>> {
        let measured = self.pictures.model().measured()?;
        let mut numbers = measured.now.to_array().to_vec();
        numbers.extend(measured.rest.iter().flat_map(|rest| rest.to_array()));
        Some(numbers)
    }

    /// Where the middle of the tape is on the canvas, hidden or not; nothing without a tape, and where
    /// it is behind the eye.
    #[wasm_bindgen(js_name = tapeMiddle)]
    pub fn tape_middle(&self) -> Option<Vec<f32>> {
        self.pictures.model().tape_middle().map(|at| at.to_array().to_vec())
    }
}
