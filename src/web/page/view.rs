//! The page's view: a canvas and what is shown on it.
//!
//! Screen positions are CSS pixels from the upper left corner of the canvas. Coordinates are those
//! of the file. Exceptions are an `Error` whose message is one complete line.

use crate::view::appearance::{ColourScale, RowColours, ValueAxis};
use crate::view::gpu::{Device, DeviceError, Loss, Placement, Renderer};
use crate::view::model::ProjectionMarks;
use crate::view::pictures::Pictures;
use crate::view::state::{Display, ViewState};
use crate::web::{log_panics, thrown};
use glam::Vec2;
use std::sync::Arc;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;
use wgpu::SurfaceTarget;

/// A view on one canvas.
#[wasm_bindgen]
#[derive(Debug)]
pub struct View {
    /// Model and flat map, without a GPU.
    pub(super) pictures: Pictures,
    pixel_ratio: f32,
    /// The position of the canvas in a larger picture, if the canvas is one tile of it.
    tile: Option<Placement>,
    renderer: Renderer,
    backend: &'static str,
    canvas: HtmlCanvasElement,
    context_lost: Closure<dyn FnMut()>,
}

impl Drop for View {
    fn drop(&mut self) {
        let listener = self.context_lost.as_ref().unchecked_ref();
        // An error means that the listener is already gone: nothing is left to do.
        let _ = self.canvas.remove_event_listener_with_callback(CONTEXT_LOST, listener);
    }
}

const CONTEXT_LOST: &str = "webglcontextlost";

const BACKENDS: &[&str] = &[
    #[cfg(feature = "view-webgpu")]
    "webgpu",
    #[cfg(feature = "view-webgl2")]
    "webgl2",
];

/// Opens the requested backend; returns the device and the name of the backend.
async fn open(
    canvas: &HtmlCanvasElement,
    backend: &str,
) -> Result<(Device, &'static str), DeviceError> {
    let target = SurfaceTarget::Canvas(canvas.clone());
    match backend {
        #[cfg(feature = "view-webgpu")]
        "webgpu" => Ok((Device::webgpu(target).await?, "webgpu")),
        #[cfg(feature = "view-webgl2")]
        "webgl2" => Ok((Device::webgl2(target).await?, "webgl2")),
        _ => {
            let known = BACKENDS.join(" or ");
            Err(DeviceError(format!("backend \"{backend}\", expected {known}")))
        }
    }
}

/// Dispatches, on a loss of the WebGPU device, the event that browsers dispatch for WebGL.
async fn tell_loss(loss: Arc<Loss>, canvas: HtmlCanvasElement) {
    loss.wait().await;
    if let Ok(event) = web_sys::Event::new(CONTEXT_LOST) {
        // It fails if the event is already being dispatched.
        let _ = canvas.dispatch_event(&event);
    }
}

#[wasm_bindgen]
impl View {
    /// Opens a view on a canvas without a context. `backend` is `webgpu` or `webgl2`, as built in.
    ///
    /// # Errors
    /// Rejects without an adapter, with the reason.
    pub async fn create(canvas: HtmlCanvasElement, backend: String) -> Result<View, JsValue> {
        log_panics();
        let (device, backend) = open(&canvas, &backend).await.map_err(thrown)?;
        device.device.on_uncaptured_error(Arc::new(|error| {
            web_sys::console::error_1(&format!("view: {error}").into());
        }));
        let loss = device.loss();
        let context_lost = Closure::<dyn FnMut()>::new(move || loss.happen());
        canvas.add_event_listener_with_callback(
            CONTEXT_LOST,
            context_lost.as_ref().unchecked_ref(),
        )?;
        if backend == "webgpu" {
            wasm_bindgen_futures::spawn_local(tell_loss(device.loss(), canvas.clone()));
        }
        Ok(View {
            pictures: Pictures::default(),
            pixel_ratio: 1.0,
            tile: None,
            renderer: Renderer::new(device),
            backend,
            canvas,
            context_lost,
        })
    }

    /// `webgpu` or `webgl2`.
    pub fn backend(&self) -> String {
        self.backend.to_owned()
    }

    /// Sets the size of the canvas in physical pixels, limited to what the adapter allows. If the
    /// camera has not moved since the view was fitted, the view is fitted again.
    pub fn resize(&mut self, width: u32, height: u32, device_pixel_ratio: f32) {
        self.renderer.device.resize(width, height);
        self.tile = None;
        self.pixel_ratio = if device_pixel_ratio > 0.0 { device_pixel_ratio } else { 1.0 };
        self.pictures.resize(Vec2::new(width as f32, height as f32) / self.pixel_ratio);
    }

    /// Makes the canvas one tile of a picture of `width` by `height` pixels. `part` is the left and
    /// top edge of the tile in the picture, and its width and height. `resize` ends this.
    #[wasm_bindgen(js_name = setTile)]
    pub fn set_tile(&mut self, width: u32, height: u32, device_pixel_ratio: f32, part: &[u32]) {
        let &[left, top, across, down] = part else { return };
        self.renderer.device.resize(across, down);
        self.pixel_ratio = if device_pixel_ratio > 0.0 { device_pixel_ratio } else { 1.0 };
        let canvas = self.renderer.device.size();
        let at = (-(left as i32), -(top as i32));
        self.tile = Some(Placement { size: (width, height), at, canvas });
        self.pictures.resize(Vec2::new(width as f32, height as f32) / self.pixel_ratio);
        self.model().view_changed();
    }

    /// Shows a mesh: faces and curves as offsets and indices, #V by 3 positions. A mesh with
    /// another topology is framed from the three-quarter view, without marks.
    ///
    /// # Errors
    /// Arrays that do not fit together; the old mesh stays.
    #[wasm_bindgen(js_name = setMesh)]
    pub fn set_mesh(
        &mut self,
        face_offsets: Vec<u32>,
        face_indices: Vec<u32>,
        curve_offsets: Vec<u32>,
        curve_indices: Vec<u32>,
        positions: &[f64],
    ) -> Result<(), JsValue> {
        let faces = (face_offsets, face_indices);
        let curves = (curve_offsets, curve_indices);
        self.pictures.set_mesh(faces, curves, positions).map_err(thrown)
    }

    /// Moves the vertices, #V by 3.
    ///
    /// # Errors
    /// A wrong number of vertices, or a coordinate that is not finite.
    #[wasm_bindgen(js_name = setPositions)]
    pub fn set_positions(&mut self, positions: &[f64]) -> Result<(), JsValue> {
        self.model().set_positions(positions).map_err(thrown)
    }

    /// Colours each face by its value, from `low` to `high`, linearly or logarithmically; faces
    /// within the tolerance keep the material. NaN is grey; null restores the plain material.
    ///
    /// # Errors
    /// A wrong number of values.
    #[wasm_bindgen(js_name = setFaceValues)]
    pub fn set_face_values(
        &mut self,
        values: Option<Vec<f32>>,
        low: f64,
        high: f64,
        tolerance: Option<f32>,
        logarithmic: Option<bool>,
    ) -> Result<(), JsValue> {
        let axis = ValueAxis::new(low, high, logarithmic.unwrap_or_default());
        let scale = ColourScale { axis, tolerance };
        self.model().appearance_mut().set_values(values, scale).map_err(thrown)
    }

    /// Returns CSS colours of the model's colour map, which is that of its flat map too, from low to
    /// high, for a legend.
    #[wasm_bindgen(js_name = colourStops)]
    pub fn colour_stops(&self, count: usize) -> Vec<String> {
        self.pictures.model().appearance().map().stops(count)
    }

    /// Selects the light or the dark theme.
    #[wasm_bindgen(js_name = setTheme)]
    pub fn set_theme(&mut self, dark: bool) {
        self.model().set_dark(dark);
    }

    /// Sets a grey background, from 0 (black) to 1 (white), or the background of the theme.
    #[wasm_bindgen(js_name = setBackground)]
    pub fn set_background(&mut self, grey: Option<f32>) {
        self.model().set_background(grey);
    }

    /// Switches edges, vertex dots, fitted shapes, projected outlines, arrows, and what was computed for
    /// the shape (the layer beside it, the lines over it) on or off.
    #[wasm_bindgen(js_name = setDisplay)]
    pub fn set_display(
        &mut self,
        edges: bool,
        vertices: bool,
        shapes: bool,
        outlines: bool,
        arrows: bool,
        computed: bool,
    ) {
        let display = Display { edges, vertices, shapes, outlines, arrows, computed };
        self.model().set_display(display);
    }

    /// Sets all handles: vertices, states (0 soft, 1 fixed, 2 active), and #H by 3 targets.
    ///
    /// # Errors
    /// Arrays that do not fit together.
    #[wasm_bindgen(js_name = setHandles)]
    pub fn set_handles(
        &mut self,
        vertices: &[u32],
        states: &[u8],
        targets: &[f64],
    ) -> Result<(), JsValue> {
        self.model().set_handles(vertices, states, targets).map_err(thrown)
    }

    /// Sets the selected vertices and faces.
    ///
    /// # Errors
    /// An index out of range.
    #[wasm_bindgen(js_name = setSelection)]
    pub fn set_selection(&mut self, vertices: Vec<u32>, faces: Vec<u32>) -> Result<(), JsValue> {
        self.model().marks_mut().select(vertices, faces).map_err(thrown)
    }

    /// Sets the edges that can be picked, as pairs of vertices, in this order. A new mesh has none.
    ///
    /// # Errors
    /// A vertex that does not exist.
    #[wasm_bindgen(js_name = setEdges)]
    pub fn set_edges(&mut self, ends: &[u32]) -> Result<(), JsValue> {
        self.model().set_edges(ends).map_err(thrown)
    }

    /// Sets the selected edges, by their indices in `setEdges`.
    ///
    /// # Errors
    /// An edge that does not exist.
    #[wasm_bindgen(js_name = setSelectedEdges)]
    pub fn set_selected_edges(&mut self, edges: &[u32]) -> Result<(), JsValue> {
        self.model().select_edges(edges).map_err(thrown)
    }

    /// Sets the edges along which a paper model is cut, as pairs of vertices.
    ///
    /// # Errors
    /// A vertex that does not exist.
    #[wasm_bindgen(js_name = setSeams)]
    pub fn set_seams(&mut self, ends: &[u32]) -> Result<(), JsValue> {
        self.model().set_seams(ends).map_err(thrown)
    }

    /// Marks vertices and faces with a colour, whose components are from 0 to 1.
    ///
    /// # Errors
    /// An index out of range.
    #[wasm_bindgen(js_name = setTint)]
    pub fn set_tint(
        &mut self,
        vertices: Vec<u32>,
        faces: Vec<u32>,
        red: f32,
        green: f32,
        blue: f32,
    ) -> Result<(), JsValue> {
        self.model().marks_mut().tint(vertices, faces, [red, green, blue]).map_err(thrown)
    }

    /// Colours faces and vertices by the row of constraints that acts on them: per face (#F) and
    /// per vertex (#V) 0, or an index into the palette plus one; three components from 0 to 1 per
    /// colour. Empty arrays remove all colours. Values of faces take precedence over row colours.
    ///
    /// # Errors
    /// Arrays that do not fit together.
    #[wasm_bindgen(js_name = setRowColours)]
    pub fn set_row_colours(
        &mut self,
        faces: Vec<u8>,
        vertices: Vec<u8>,
        palette: &[f32],
    ) -> Result<(), JsValue> {
        let counts = self.pictures.model().counts();
        let rows = RowColours::new(faces, vertices, palette, counts).map_err(thrown)?;
        self.model().marks_mut().rows = rows;
        Ok(())
    }

    /// Sets the fitted shapes, eight numbers each: kind (0 circle, else sphere), centre, normal, radius.
    ///
    /// # Errors
    /// A length that is not a multiple of eight.
    #[wasm_bindgen(js_name = setShapes)]
    pub fn set_shapes(&mut self, shapes: &[f64]) -> Result<(), JsValue> {
        self.model().set_shapes(shapes).map_err(thrown)
    }

    /// Sets the projections of the constraints: the vertex of each point, its displacement from
    /// that vertex (#points by 3), the index of its colour in the palette plus one, the outlines as
    /// pairs of points, and the palette, three components from 0 to 1 per colour.
    ///
    /// # Errors
    /// Arrays that do not fit together.
    #[wasm_bindgen(js_name = setProjections)]
    pub fn set_projections(
        &mut self,
        vertices: &[u32],
        displacements: &[f32],
        colours: &[u8],
        outlines: &[u32],
        palette: &[f32],
    ) -> Result<(), JsValue> {
        let (count, _) = self.pictures.model().counts();
        let projections =
            ProjectionMarks::new(vertices, displacements, colours, outlines, palette, count);
        self.model().set_projections(projections.map_err(thrown)?);
        Ok(())
    }

    /// Returns whether anything has changed since the last `draw`.
    #[wasm_bindgen(js_name = needsDraw)]
    pub fn needs_draw(&self) -> bool {
        self.pictures.has_changes()
    }

    /// Draws if anything has changed; returns whether it did.
    ///
    /// # Errors
    /// The device is lost; the page then creates a new view on a new canvas.
    pub fn draw(&mut self) -> Result<bool, JsValue> {
        let (model, map) = self.pictures.to_draw();
        self.renderer.draw(model, map, self.pixel_ratio, self.tile).map_err(thrown)
    }

    /// Returns whether the last computed occlusion fits the current picture, and so costs nothing.
    #[wasm_bindgen(js_name = occlusionFits)]
    pub fn occlusion_fits(&self) -> bool {
        let size = self.tile.map_or(self.renderer.device.size(), |tile| tile.size);
        self.renderer.occlusion_fits(self.pictures.model(), size)
    }
}

impl View {
    pub(super) fn model(&mut self) -> &mut ViewState {
        self.pictures.model_mut()
    }
}
