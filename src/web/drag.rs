//! Dragging handles, as the page tells of it.

use super::solver::Solver;
use super::thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// Drags handles: `phase` is "make", which makes the vertices handles first, or "start", then
    /// "move", "end" or "cancel"; `targets` is `#vertices by 3`.
    pub fn drag(&mut self, vertices: &[u32], targets: &[f64], phase: &str) -> Result<(), JsValue> {
        let session = self.open_mut()?;
        match phase {
            "make" => session.begin_drag_of_new(vertices.to_vec()).map_err(thrown)?,
            "start" => session.begin_drag(),
            _ => {}
        }
        // What was edited or undone meanwhile has ended it.
        if phase != "cancel" && session.is_dragging() {
            let (targets, _) = targets.as_chunks::<3>();
            session.drag(vertices.iter().copied().zip(targets.iter().copied()));
        }
        match phase {
            "end" => session.end_drag(true),
            "cancel" => session.end_drag(false),
            _ => {}
        }
        Ok(())
    }
}
