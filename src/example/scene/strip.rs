//! Fig. 11: a strip whose edges are made to collapse by fairness.

use super::parts::{constraint, each, fixed};
use crate::constraint::Element;
use crate::example::Example;
use crate::example::model::Strip;
use crate::mesh::Mesh;
use crate::scene::{ClosenessTo, Scene, Weights};

pub(super) const STRIP: Example = Example {
    id: "fig-11-strip",
    title: "Strip with collapsing edges",
    summary: "Both long sides are fixed, and circular panels and fairness conflict in between: where both cannot be satisfied, edges shrink to almost nothing.",
    statement: "The mean circularity error e_c falls from 3.5e-6 to less than 6e-8, and the shortest edge from 24 cm to less than 2 cm.",
    ending: "obj",
    make: strip,
};

fn strip(scene: &mut Scene) -> Mesh {
    let strip = Strip::default();
    scene.constraints = vec![constraint("circle", each(Element::Face), 1.0)];
    scene.weights = Weights { shape: 2000.0, close: 0.0, smooth: 1.0 };
    scene.solver.iterations = 500;
    scene.closeness.to = ClosenessTo::None;
    scene.handles = vec![fixed(strip.rails())];
    strip.mesh()
}
