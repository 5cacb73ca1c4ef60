//! Fig. 4: quads that become squares.

use super::parts::{constraint, each};
use crate::constraint::Element;
use crate::example::Example;
use crate::example::model::Patch;
use crate::mesh::Mesh;
use crate::scene::{Accelerator, Scene, Weights};

pub(super) const SQUARES: Example = Example {
    id: "fig-04-squares",
    title: "Skew panels become squares",
    summary: "Press Half step again and again: the local step finds the square that fits each panel best, and the global step moves each vertex to the middle between the corners of its squares.",
    statement: "Corners that are up to 39 cm from the best square of their panel come within 2 cm in 200 plain iterations.",
    ending: "obj",
    make: squares,
};

fn squares(scene: &mut Scene) -> Mesh {
    scene.constraints = vec![constraint("square", each(Element::Face), 1.0)];
    scene.weights = Weights { shape: 5.0, close: 1.0, smooth: 0.0 };
    // As in the paper, the global step moves vertices to the mean of their squares' corners.
    scene.solver.accelerator = Accelerator::None;
    Patch::default().mesh()
}
