//! Dragging handles, as the page tells of it.

use super::solver::Solver;
use crate::session::check_targets;
use crate::web::thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// Drags handles: `phase` is "make", which makes the vertices handles first, or "start", then
    /// "move", "end" or "cancel"; `targets` is `#vertices by 3`, or empty where none moves.
    ///
    /// # Errors
    /// An unknown phase, or targets that are not one for each vertex, not finite or too far out: nothing
    /// moves then, and an "end" keeps the move before.
    pub fn drag(&mut self, vertices: &[u32], targets: &[f64], phase: &str) -> Result<(), JsValue> {
        let session = self.open_mut()?;
        let (targets, rest) = targets.as_chunks::<3>();
        if !rest.is_empty() {
            let numbers = 3 * targets.len() + rest.len();
            return Err(thrown(format!("found {numbers} coordinates, expected three per target")));
        }
        // Before handles are made for it; without targets none moves.
        let checked = if targets.is_empty() { Ok(()) } else { check_targets(vertices, targets) };
        let checked = checked.map_err(thrown);
        let moves = vertices.iter().copied().zip(targets.iter().copied());
        match phase {
            "make" => {
                checked?;
                session.begin_drag_of_new(vertices.to_vec()).map_err(thrown)?;
                session.drag(moves).map_err(thrown)
            }
            "start" => {
                checked?;
                session.begin_drag();
                session.drag(moves).map_err(thrown)
            }
            // What was edited or undone meanwhile has ended it.
            "move" | "end" | "cancel" if !session.is_dragging() => Ok(()),
            "move" => {
                checked?;
                session.drag(moves).map_err(thrown)
            }
            "end" => {
                let moved = checked.and_then(|()| session.drag(moves).map_err(thrown));
                session.end_drag(true);
                moved
            }
            "cancel" => {
                session.end_drag(false);
                Ok(())
            }
            other => Err(thrown(format!(
                "found the phase {other:?}, expected make, start, move, end or cancel"
            ))),
        }
    }
}
