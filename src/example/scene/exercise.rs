//! A lesson: an exercise with goals, which a student meets and hands in.

use super::parts::{constraint, each, fixed};
use crate::constraint::Element;
use crate::example::Example;
use crate::example::model::Canopy;
use crate::mesh::Mesh;
use crate::scene::{Goal, GoalOf, Lesson, Scene, Smoothness, SmoothnessOf, Weighting, Weights};

pub(super) const GLASS_ROOF: Example = Example {
    id: "lesson-glass-roof",
    title: "Lesson: a glass roof of flat panes",
    summary: "An exercise to hand in: every pane is to be flat to a millimetre, and the roof is to stay where the architect drew it. Run alone does not do it; the right weights do.",
    statement: "The worst pane, 9 mm from flat, comes within 3 mm, and the roof leaves its place by up to 6 cm: both goals are missed, and there are weights that meet both.",
    ending: "obj",
    make: glass_roof,
};

const TEXT: &str = "Each pane of this roof is to be one sheet of flat glass.
Make every pane flat to a millimetre, and keep the roof within 5 cm of where it was drawn.
Run it and see which goal is missed. Then change the weights of the energies until both are met, and hand in your results.";

/// Four feet stand still; the goals pull against each other.
fn glass_roof(scene: &mut Scene) -> Mesh {
    let roof = Canopy {
        panels: [20, 14],
        span: [20.0, 14.0],
        rise: 2.4,
        crown: 1.8,
        waist: 0.03,
        wave: 0.22,
    };
    let [nx, ny] = roof.panels.map(|n| n as u32);
    let last_row = ny * (nx + 1);
    scene.constraints = vec![constraint("plane", each(Element::Face), 1.0)];
    scene.handles = vec![fixed(vec![0, nx, last_row, last_row + nx])];
    scene.weights = Weights { shape: 1000.0, close: 10.0, smooth: 0.5 };
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    scene.solver.iterations = 2000;
    let goal = |measure: &str, at_most| Goal { of: GoalOf::Measure(measure.to_owned()), at_most };
    scene.lesson = Some(Lesson {
        text: TEXT.to_owned(),
        goals: vec![goal("planarity", 0.001), goal("surface", 0.05)],
        lock: Vec::new(),
    });
    roof.mesh()
}
