//! Lessons on projections, circles and lines of curvature, and an exercise without instructions, with
//! goals that students achieve and hand in.

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

pub(super) const CIRCLES: Example = Example {
    id: "lesson-circles",
    title: "Lesson: circles",
    summary: "An exercise to hand in: flat panels are not yet circular. Put the corners of every panel on a circle, and see what that does to its shape and to the roof.",
    statement: "The panels, up to 9.2 mm from flat, come within 1 mm; their corners stay up to 146 mm from circles, and one goal is missed.",
    make: circles,
};

const CIRCLES_TEXT: &str = "Three points always lie on a circle. Each further corner has to meet two conditions: to lie in the plane of the others, and to lie on their circle. So a circular panel is flat, but a flat panel need not be circular. In a circular panel of four corners, opposite angles add up to 180 degrees. A rectangle is circular, and so is a trapezoid with equal legs; a rhombus is not, unless it is a square.

The projection of a panel fits a plane to its corners, and then a circle to their images in that plane. The circle is near, though not always the nearest (section 3.1 of the paper).

1. The list under Shape has one constraint, Plane. Press Run. Under Check, set Colour by to Planarity, then to Circularity: the panels are flat, and their corners are still centimetres from circles.
2. Under Shape, press Make panels circular. Circle takes the place of Plane in the list. Look at both colours again: what is circular is flat as well.
3. Set Colour by to Moved. Two conditions for each panel, in place of one, leave the roof less freedom, and it has to move further.";

/// A roof whose panels are to be flat, until the student makes them circular.
fn circles(scene: &mut Scene) -> Mesh {
    scene.constraints = vec![constraint("plane", each(Element::Face), 1.0)];
    near_where_it_was(scene);
    scene.lesson = Some(lesson(
        CIRCLES_TEXT,
        vec![worst("circularity", 0.001), worst("displacement", 0.6)],
        &[Lock::Handles, Lock::Mesh],
    ));
    beamed_roof()
}

/// A roof whose panels come near circles by a move of half a metre.
pub(super) fn beamed_roof() -> Mesh {
    let roof = Canopy {
        panels: [20, 14],
        span: [18.0, 13.0],
        rise: 2.6,
        crown: 1.6,
        waist: 0.03,
        wave: 0.1,
    };
    roof.mesh()
}

pub(super) const CURVATURE: Example = Example {
    id: "lesson-curvature-and-panels",
    title: "Lesson: lines of curvature, and why circles follow them",
    summary: "An exercise to hand in: two vaults of the same shape, with edges along the lines of curvature on the left and across them on the right. Both get circular panels, but only one has to move.",
    statement: "The left vault is circular from the start and stays; the corners of the right one, up to 17 mm from circles, come within 4 mm, and one goal is missed.",
    make: curvature,
};

const CURVATURE_TEXT: &str = "Two vaults of the same shape. On the left the edges follow its lines of curvature, the directions in which it bends most and least; on the right they cross them.

Why do circles follow these lines? The axis of a circular panel is the line through the centre of its circle, perpendicular to its plane. Every point of the axis is equally far from all corners. Neighbouring panels share two corners, so both of their axes lie in the plane of all points that are equally far from these two: the axes meet, or are parallel. They stand for the normals of the surface. On a smooth surface, though, the normals at neighbouring points meet in two directions only, and these are the lines of curvature. In all other directions they pass each other.

1. Under Check, set Colour by to Off the lines of curvature. Which vault follows them?
2. Colour by Circularity. On the left all panels are circular, though no constraint has acted yet.
3. Under Shape, press Circle in the list, and set Required to Within. All corners come within 1 mm of circles.
4. Colour by Moved. The left vault has not moved; the right one had to turn its edges. Exact moves it further: try it, and see which goal is missed.";

fn curvature(scene: &mut Scene) -> Mesh {
    scene.constraints = vec![constraint("circle", each(Element::Face), 1.0)];
    near_where_it_was(scene);
    // Run alone leaves some millimetres.
    scene.weights.shape = 2000.0;
    let circular = GoalOf::Beyond { measure: "circularity".to_owned(), tolerance: 0.001 };
    scene.lesson = Some(lesson(
        CURVATURE_TEXT,
        vec![Goal { of: circular, at_most: 0.0 }, worst("displacement", 1.0)],
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

/// A vault of 10 m by 10 m, moved along x, whose edges deviate by `turn`, in turns, from its lines of
/// curvature. It is a part of a torus: an arch along x, which is revolved about an axis far below.
/// Panels along the lines of curvature are trapezoids with equal legs, which are circular.
fn vault(turn: f64, along: f64) -> Mesh {
    /// Radii of the arch, and of its crown about the axis.
    const RADII: [f64; 2] = [8.0, 40.0];
    let [c, s] = [cosine(turn), sine(turn)];
    grid([12, 12], |x, y| {
        let [across, lengthwise] = [c * x - s * y, s * x + c * y].map(|at| 5.0 * at);
        // Angles in turns, as the functions take them.
        let [a, b] =
            [across / RADII[0], lengthwise / RADII[1]].map(|at| at / std::f64::consts::TAU);
        let from_axis = RADII[1] - RADII[0] * (1.0 - cosine(a));
        let height = from_axis * cosine(b) - RADII[1] + 2.4;
        [RADII[0] * sine(a) + along, from_axis * sine(b), height]
    })
}

pub(super) const GLASS_ROOF: Example = Example {
    id: "lesson-glass-roof",
    title: "Exercise: a glass roof of flat panes",
    summary: "An exercise to hand in: make every pane flat to a millimetre, and keep the roof where the architect drew it. Run alone is not enough; the right weights are.",
    statement: "The worst pane, 9 mm from flat, comes within 3 mm, and the roof moves by up to 6 cm: both goals are missed, but some weights meet both.",
    make: glass_roof,
};

const GLASS_TEXT: &str = "Each pane of this roof will be one flat sheet of glass.
Make every pane flat to a millimetre, and keep the roof within 5 cm of where it was drawn.
Press Run and see which goals are missed. Then open Shape, Weights and solver, and change the weights until both are satisfied. Hand in your results.";

/// A roof with two conflicting goals.
fn glass_roof(scene: &mut Scene) -> Mesh {
    scene.constraints = vec![constraint("plane", each(Element::Face), 1.0)];
    scene.lesson =
        Some(lesson(GLASS_TEXT, vec![worst("planarity", 0.001), worst("surface", 0.05)], &[]));
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
