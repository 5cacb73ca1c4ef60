//! Picking under the cursor and inside an outline, and the places of vertices on the canvas.

use super::view::View;
use crate::view::state::{Outline, Taking};
use glam::Vec2;
use wasm_bindgen::prelude::*;

/// From x and y of each corner.
fn outline(corners: &[f32]) -> Outline {
    let (corners, _) = corners.as_chunks::<2>();
    Outline::new(corners.iter().map(|&[x, y]| Vec2::new(x, y)).collect())
}

#[wasm_bindgen]
impl View {
    /// The visible vertex nearest to the cursor.
    #[wasm_bindgen(js_name = pickVertex)]
    pub fn pick_vertex(&self, x: f32, y: f32, radius: f32) -> Option<u32> {
        self.pictures.model().pick_vertex(Vec2::new(x, y), radius)
    }

    /// The vertex of the handle nearest to the cursor, hidden or not.
    #[wasm_bindgen(js_name = pickHandle)]
    pub fn pick_handle(&self, x: f32, y: f32, radius: f32) -> Option<u32> {
        self.pictures.model().pick_handle(Vec2::new(x, y), radius)
    }

    /// The face under the cursor.
    #[wasm_bindgen(js_name = pickFace)]
    pub fn pick_face(&self, x: f32, y: f32) -> Option<u32> {
        self.pictures.model().pick_face(Vec2::new(x, y))
    }

    /// The visible edge nearest to the cursor, by its place in `setEdges`.
    #[wasm_bindgen(js_name = pickEdge)]
    pub fn pick_edge(&mut self, x: f32, y: f32, radius: f32) -> Option<u32> {
        self.model().pick_edge(Vec2::new(x, y), radius)
    }

    /// Vertices inside a polygon on the screen (x and y of each corner); with `through` hidden ones too.
    #[wasm_bindgen(js_name = verticesIn)]
    pub fn vertices_in(&mut self, corners: &[f32], through: bool) -> Vec<u32> {
        self.model().vertices_in(&outline(corners), through)
    }

    /// Edges inside a polygon on the screen; with `touching` also those partly inside.
    #[wasm_bindgen(js_name = edgesIn)]
    pub fn edges_in(&mut self, corners: &[f32], touching: bool, through: bool) -> Vec<u32> {
        self.model().edges_in(&outline(corners), Taking { touching, through })
    }

    /// Faces inside a polygon on the screen; with `touching` also those partly inside.
    #[wasm_bindgen(js_name = facesIn)]
    pub fn faces_in(&mut self, corners: &[f32], touching: bool, through: bool) -> Vec<u32> {
        self.model().faces_in(&outline(corners), Taking { touching, through })
    }

    /// Where a vertex is on the canvas; nothing when it is hidden, outside, or not there.
    pub fn screen(&self, vertex: u32) -> Option<Vec<f64>> {
        self.pictures.model().screen(vertex).map(|at| vec![f64::from(at.x), f64::from(at.y)])
    }
}
