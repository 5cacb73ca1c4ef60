//! Picking under the cursor and inside an outline, and canvas positions of vertices.

use super::view::View;
use crate::view::state::{Outline, RegionMode};
use glam::Vec2;
use wasm_bindgen::prelude::*;

/// Creates an outline from the x and y of each corner.
fn outline(corners: &[f32]) -> Outline {
    let (corners, _) = corners.as_chunks::<2>();
    Outline::new(corners.iter().map(|&[x, y]| Vec2::new(x, y)).collect())
}

#[wasm_bindgen]
impl View {
    /// Returns the visible vertex nearest to the cursor.
    #[wasm_bindgen(js_name = pickVertex)]
    pub fn pick_vertex(&self, x: f32, y: f32, radius: f32) -> Option<u32> {
        self.pictures.model().pick_vertex(Vec2::new(x, y), radius)
    }

    /// Returns the vertex of the handle nearest to the cursor, hidden or not.
    #[wasm_bindgen(js_name = pickHandle)]
    pub fn pick_handle(&self, x: f32, y: f32, radius: f32) -> Option<u32> {
        self.pictures.model().pick_handle(Vec2::new(x, y), radius)
    }

    /// Returns the face under the cursor.
    #[wasm_bindgen(js_name = pickFace)]
    pub fn pick_face(&self, x: f32, y: f32) -> Option<u32> {
        self.pictures.model().pick_face(Vec2::new(x, y))
    }

    /// Returns the visible edge nearest to the cursor, by its index in `setEdges`.
    #[wasm_bindgen(js_name = pickEdge)]
    pub fn pick_edge(&mut self, x: f32, y: f32, radius: f32) -> Option<u32> {
        self.model().pick_edge(Vec2::new(x, y), radius)
    }

    /// Returns vertices inside a screen polygon (x, y per corner); with `through`, hidden ones too.
    #[wasm_bindgen(js_name = verticesIn)]
    pub fn vertices_in(&mut self, corners: &[f32], through: bool) -> Vec<u32> {
        self.model().vertices_in(&outline(corners), through)
    }

    /// Returns the edges inside a polygon on the screen; with `touching`, also those partly inside.
    #[wasm_bindgen(js_name = edgesIn)]
    pub fn edges_in(&mut self, corners: &[f32], touching: bool, through: bool) -> Vec<u32> {
        self.model().edges_in(&outline(corners), RegionMode { touching, through })
    }

    /// Returns the faces inside a polygon on the screen; with `touching`, also those partly inside.
    #[wasm_bindgen(js_name = facesIn)]
    pub fn faces_in(&mut self, corners: &[f32], touching: bool, through: bool) -> Vec<u32> {
        self.model().faces_in(&outline(corners), RegionMode { touching, through })
    }

    /// Returns the canvas position of a vertex; undefined if hidden, outside, or unknown.
    pub fn screen(&self, vertex: u32) -> Option<Vec<f64>> {
        self.pictures.model().screen(vertex).map(|at| vec![f64::from(at.x), f64::from(at.y)])
    }
}
