//! Handles dragged by the page.

use super::solver::Solver;
use crate::scene::NamedEnum;
use crate::session::DragPhase;
use crate::web::thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// Drags handles. `phase` is "start", or "make" to turn the vertices into handles first; then
    /// "move", "end" or "cancel". `targets` is `#vertices by 3`, or empty if none moves.
    ///
    /// # Errors
    /// An unknown phase, or targets that are not one per vertex, not finite or too far out. Nothing
    /// moves then, and an "end" keeps the last move.
    pub fn drag(&mut self, vertices: &[u32], targets: &[f64], phase: &str) -> Result<(), JsValue> {
        let session = self.open_mut()?;
        let (targets, rest) = targets.as_chunks::<3>();
        if !rest.is_empty() {
            let numbers = 3 * targets.len() + rest.len();
            return Err(thrown(format!("found {numbers} coordinates, expected three per target")));
        }
        let phase = DragPhase::of_word(phase).ok_or_else(|| {
            thrown(format!("found the phase {phase:?}, expected {}", DragPhase::list(", ")))
        })?;
        session.drag_through(phase, vertices, targets).map_err(thrown)
    }
}
