//! The current state as an OBJ file and as a scene.

use super::state::{RestMesh, SolvedScene, grouped};
use crate::mesh::{Weld, write_obj};
use crate::scene::{Scene, UnitsAndUp};

/// Returns the current shape as the text of an OBJ file, with its unit and axis if known.
pub(super) fn obj(scene: &SolvedScene, rest: &RestMesh) -> String {
    comments(scene) + &write_obj(rest.mesh(), scene.positions())
}

/// As [`obj`], with the vertices and faces of the file before it was welded to `rest`.
pub(super) fn obj_unwelded(scene: &SolvedScene, rest: &RestMesh, weld: &Weld) -> String {
    let positions = weld.original_positions(rest.positions(), scene.positions());
    comments(scene) + &write_obj(&weld.original, &positions)
}

fn comments(scene: &SolvedScene) -> String {
    let document = scene.document();
    UnitsAndUp::comments(&document.units, document.up)
}

/// Returns the document with its handles, and with current positions if they differ from the
/// design, or without a design from the rest positions.
pub(super) fn whole_scene(scene: &SolvedScene, rest: &RestMesh) -> Scene {
    let mut whole = scene.document().clone();
    let positions = scene.positions();
    let design = whole.variants.design_positions().unwrap_or(rest.positions());
    whole.current = (**positions != *design).then(|| positions.to_vec());
    whole.handles = grouped(scene.handles());
    whole
}
