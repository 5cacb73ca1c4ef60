//! Lessons on projections, and on what they do to a design: exercises with goals that students
//! achieve and hand in.

use super::parts::{constraint, each, fixed};
use crate::constraint::Element;
use crate::generate::example::Example;
use crate::generate::model::Canopy;
use crate::generate::quads::grid;
use crate::math::{cosine, sine};
use crate::mesh::Mesh;
use crate::scene::{
    ClosenessTo, Goal, GoalOf, Lesson, Lock, Scene, Smoothness, SmoothnessOf, Weighting, Weights,
};

pub(super) const PROJECTION: Example = Example {
    id: "lesson-what-a-projection-is",
    title: "Lesson: what a projection is",
    summary: "An exercise to hand in: the tiles of a crumpled sheet become squares by two simple steps in turn, and you say how far the sheet may move.",
    statement: "The tiles, up to 38 cm from squares, come within 4 cm, and one goal is missed: closeness holds the corners back.",
    make: projection,
};

const PROJECTION_TEXT: &str = "A constraint says what a part shall be: here, each tile a square. The projection of a tile is its nearest square: the smallest change after which the constraint holds (Figure 2 of the paper). Tiles share corners, and each asks them to be elsewhere. What is to be made small is a sum of squared distances, each with its weight: from the corners to these squares, and to where they were.

Two steps in turn do that (Figure 3). The local step projects each tile by itself. The global step puts all corners where the sum is least as long as no square turns or changes its size. Neither can make the sum larger, though single distances may grow. Where all constraints can hold at once, it can come to zero; where they cannot, the corners end as near to all as possible, in the sense of least squares.

1. Under Shape, in Weights and solver, press Half step a few times. After the local step you see the squares, and nothing has moved; after the global step the corners have.
2. Press Run. The tiles do not become squares: closeness asks each corner to stay where it was, and weights decide between the two.
3. Under Shape, in Weights and solver, make the Close weight smaller until all corners are within 10 mm of their squares. With 0 they become squares, but nothing holds the sheet any longer.";

/// A crumpled sheet of tiles.
fn projection(scene: &mut Scene) -> Mesh {
    const TILES: usize = 15;
    scene.constraints = vec![constraint("square", each(Element::Face), 1.0)];
    scene.weights = Weights { shape: 1.0, close: 0.1, smooth: 0.0 };
    scene.closeness.to = ClosenessTo::Rest;
    scene.solver.iterations = 2000;
    scene.lesson = Some(lesson(
        PROJECTION_TEXT,
        vec![
            Goal { of: GoalOf::Constraint("Square".to_owned()), at_most: 0.01 },
            worst("displacement", 0.6),
        ],
        &[Lock::Constraints, Lock::Handles, Lock::Mesh],
    ));
    let side = 0.5 * TILES as f64;
    grid([TILES; 2], |x, y| {
        let crumpled = |k: f64| {
            let waves = [17.31 * x + 29.7 * y + 0.31 * k, 11.9 * x * y - 23.1 * y + 0.57 * k];
            0.18 * waves.map(sine).iter().sum::<f64>()
        };
        [side * x + crumpled(1.0), side * y + crumpled(2.0), crumpled(3.0)]
    })
}

pub(super) const GLASS_ROOF: Example = Example {
    id: "lesson-glass-roof",
    title: "Lesson: a glass roof of flat panes",
    summary: "An exercise to hand in: make every pane flat to a millimetre, and keep the roof where the architect drew it. Run alone is not enough; the right weights are.",
    statement: "The worst pane, 9 mm from flat, comes within 3 mm, and the roof moves by up to 6 cm: both goals are missed, but some weights meet both.",
    make: glass_roof,
};

const TEXT: &str = "Each pane of this roof will be one flat sheet of glass.
Make every pane flat to a millimetre, and keep the roof within 5 cm of where it was drawn.
Press Run and see which goals are missed. Then open Shape, Weights and solver, and change the weights until both are satisfied. Hand in your results.";

/// A roof with two conflicting goals.
fn glass_roof(scene: &mut Scene) -> Mesh {
    scene.constraints = vec![constraint("plane", each(Element::Face), 1.0)];
    scene.lesson = Some(lesson(TEXT, vec![worst("planarity", 0.001), worst("surface", 0.05)], &[]));
    roof_on_feet(scene)
}

/// A roof on four fixed feet, with weights that leave room to improve them.
pub(super) fn roof_on_feet(scene: &mut Scene) -> Mesh {
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
    scene.handles = vec![fixed(vec![0, nx, last_row, last_row + nx])];
    scene.weights = Weights { shape: 1000.0, close: 10.0, smooth: 0.5 };
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    scene.solver.iterations = 2000;
    roof.mesh()
}

pub(super) const OFFSETS: Example = Example {
    id: "lesson-circles-and-offsets",
    title: "Lesson: circles and offsets, why circular",
    summary: "An exercise to hand in: put the corners of every panel of a roof exactly on a circle, because only then do its nodes have axes.",
    statement: "The corners of a panel, up to 155 mm from a circle, come within 1 mm, and one goal is missed: close is not exact.",
    make: offsets,
};

const OFFSETS_TEXT: &str = "A roof has thickness: a second layer runs at a constant distance from the first, with parallel edges. If the corners of every panel lie on a circle, there is a second layer whose nodes are all equally far from those below. Each beam is then a flat strip, and beams meet in the axis of their node, without twist.

1. Press Run. The corners come close to circles, but the first goal is missed: close leaves every node a little twisted.
2. Under Shape, press Circle in the list, and set Required to Exact. The corners move onto their circles at once.
3. Under Check, set Colour by to Moved. Circular panels move the roof most where edges are far from the lines of curvature.";

fn offsets(scene: &mut Scene) -> Mesh {
    let roof = Canopy {
        panels: [20, 14],
        span: [18.0, 13.0],
        rise: 2.6,
        crown: 1.6,
        waist: 0.03,
        wave: 0.1,
    };
    scene.constraints = vec![constraint("circle", each(Element::Face), 1.0)];
    near_where_it_was(scene);
    let exact = Goal { of: GoalOf::Constraint("Circle".to_owned()), at_most: 0.0 };
    scene.lesson = Some(lesson(
        OFFSETS_TEXT,
        vec![exact, worst("displacement", 0.6)],
        &[Lock::Weights, Lock::Handles, Lock::Mesh],
    ));
    roof.mesh()
}

pub(super) const CURVATURE: Example = Example {
    id: "lesson-curvature-and-panels",
    title: "Lesson: curvature and panels",
    summary: "An exercise to hand in: two vaults of the same shape, with edges along the lines of curvature on the left and across them on the right. Both get flat panels, but only one has to move.",
    statement: "The left vault is flat from the start and stays; the panels of the right one, up to 7.6 mm from flat, come within 2 mm, and one goal is missed.",
    make: curvature,
};

const CURVATURE_TEXT: &str = "Two vaults of the same shape. On the left the edges follow the directions in which the vault bends most and least; on the right they cross them.

1. Under Check, set Colour by to Off the lines of curvature. Which vault follows them?
2. Colour by Planarity. On the left all panels are flat, though no constraint has acted yet.
3. Under Shape, press Plane in the list, and set Required to Within. All panels come within 1 mm of flat.
4. Colour by Moved. The left vault has not moved; the right one had to, for its panels to become flat. Exact moves it further: try it, and see which goal is missed.";

fn curvature(scene: &mut Scene) -> Mesh {
    scene.constraints = vec![constraint("plane", each(Element::Face), 1.0)];
    near_where_it_was(scene);
    let flat = GoalOf::Beyond { measure: "planarity".to_owned(), tolerance: 0.001 };
    scene.lesson = Some(lesson(
        CURVATURE_TEXT,
        vec![Goal { of: flat, at_most: 0.0 }, worst("displacement", 0.96)],
        &[Lock::Weights, Lock::Handles, Lock::Mesh],
    ));
    // The edges of one vault are along its lines of curvature, those of the other across them.
    let mut both = vault(0.0, -6.5);
    let other = vault(1.0 / 12.0, 6.5);
    let first = both.positions.len() as u32;
    both.positions.extend(other.positions);
    for face in other.faces.iter() {
        both.faces.push(&face.iter().map(|v| v + first).collect::<Vec<_>>());
    }
    both
}

/// A vault over a square of 10 m, moved along x, whose edges deviate by `turn`, in turns, from its
/// lines of curvature.
fn vault(turn: f64, along: f64) -> Mesh {
    let [c, s] = [cosine(turn), sine(turn)];
    grid([12, 12], |x, y| {
        let [u, v] = [c * x - s * y, s * x + c * y];
        [5.0 * x + along, 5.0 * y, 2.4 - 1.5 * u * u - 0.25 * v * v]
    })
}

/// A lesson in which students may not change the parts `lock`.
pub(super) fn lesson(text: &str, goals: Vec<Goal>, lock: &[Lock]) -> Lesson {
    Lesson { text: text.to_owned(), goals, lock: lock.to_vec(), given: None }
}

/// Keeps vertices near their original positions, at weights small beside the constraints.
pub(super) fn near_where_it_was(scene: &mut Scene) {
    scene.weights = Weights { shape: 10_000.0, close: 1.0, smooth: 1.0 };
    scene.closeness.to = ClosenessTo::Rest;
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
}

/// A goal for the worst face in a measure, given by its id.
pub(super) fn worst(measure: &str, at_most: f64) -> Goal {
    Goal { of: GoalOf::Measure(measure.to_owned()), at_most }
}
