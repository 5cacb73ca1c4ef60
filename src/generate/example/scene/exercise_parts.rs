//! Lessons on panels: new ones on any surface, beams on their edges, plates, a model of paper, and what
//! is free where they are exact.

use super::exercise::{beamed_roof, lesson, near_where_it_was, roof_on_feet, worst};
use super::parts::{constraint, each};
use crate::constraint::Element;
use crate::generate::example::Example;
use crate::generate::model::{Canopy, honeycomb};
use crate::generate::quads::grid;
use crate::mesh::Mesh;
use crate::scene::{
    BuildSettings, ConstraintSpec, Goal, GoalOf, Lock, OffsetKind, Product, Require, Scene,
};

pub(super) const SURFACE: Example = Example {
    id: "lesson-from-surface-to-panels",
    title: "Lesson: from any surface to panels",
    summary: "An exercise to hand in: a roof came as quads that follow nothing. Made circular as they are, they carry the roof away; new panels along its lines of curvature do not.",
    statement: "The corners, up to 82 mm from the circles of their panels, come within 1 mm, and one goal is missed: the roof leaves its surface by more than 1 m.",
    make: surface,
};

const SURFACE_TEXT: &str = "A grid laid over a plan, triangles from a scan, a surface meshed for drawing: such edges do not follow the shape. Panels with four corners on a circle lie along the lines of curvature, so a mesh across them has to move far. A surface has its lines of curvature before it has panels: lay the panels along them, and they have hardly to move.

1. Press Run. The panels become circular, but how far has the roof moved from its surface? Press Undo.
2. Under Open or make, in Change the mesh, press New panels. Look at the lines that the panels follow, and press Use these panels.
3. Under Shape, press Make panels circular, which looks for a shape in several ways. How far has the roof to move now?";

fn surface(scene: &mut Scene) -> Mesh {
    scene.set_opened_defaults();
    scene.constraints = vec![ConstraintSpec {
        require: Require::Within(0.001),
        ..constraint("circle", each(Element::Face), 1.0)
    }];
    scene.lesson = Some(lesson(
        SURFACE_TEXT,
        vec![worst("circularity", 0.001), worst("surface", 0.4)],
        &[Lock::Handles],
    ));
    grid([22, 22], |x, y| {
        let [u, v] = [x + y, x - y].map(|sum| sum * std::f64::consts::FRAC_1_SQRT_2);
        [9.0 * x, 9.0 * y, 5.0 - 2.6 * u * u - 0.8 * v * v]
    })
}

pub(super) const OFFSETS: Example = Example {
    id: "lesson-circles-and-offsets",
    title: "Lesson: offsets and beams",
    summary: "An exercise to hand in: beams are to stand on the edges of a roof, flat, and equally high at all nodes. They can if its panels are circular, exactly.",
    statement: "The corners of a panel, up to 155 mm from a circle, come within 1.2 mm, and beams are still warped by 0.3 mm: close is not exact.",
    make: offsets,
};

const OFFSETS_TEXT: &str = "A roof has thickness. Beams stand on its edges, and their other sides are the edges of a second layer, parallel to those of the first. Between two parallel edges a beam is flat, so that it can be cut from a plate, and the beams of a node meet in one axis, without twist. If the corners of every panel lie on a circle, there is such a layer whose nodes are all equally far from those of the first, an offset. Otherwise beams are warped, or the distance varies from node to node.

1. Press Build. The check measures the beams of the roof as it is drawn: Warped beams says how far the worst beam is from flat, Uneven offset how far the worst node is from the distance. Press a row to see where.
2. Press Run. The corners come close to circles and the beams close to flat, but the first goal is still missed.
3. Under Shape, press Circle in the list, and set Required to Exact. Warped beams and Uneven offset vanish together: there is an offset.";

/// A roof with beams on its edges.
fn offsets(scene: &mut Scene) -> Mesh {
    scene.constraints = vec![constraint("circle", each(Element::Face), 1.0)];
    near_where_it_was(scene);
    // Run alone leaves a millimetre.
    scene.weights.shape = 1000.0;
    scene.build = Some(Box::new(BuildSettings {
        product: Product::Fins,
        kind: Some(OffsetKind::Corner),
        distance: Some(-0.3),
        // Axes near the normals of the roof: what it lacks shows in the beams.
        follow: 1.0,
        ..BuildSettings::default()
    }));
    scene.lesson = Some(lesson(
        OFFSETS_TEXT,
        vec![of_build("beam_warp", 0.0001), worst("displacement", 0.6)],
        &[Lock::Weights, Lock::Handles, Lock::Mesh],
    ));
    beamed_roof()
}

/// A goal for a number of what is built, given by its id.
fn of_build(id: &str, at_most: f64) -> Goal {
    Goal { of: GoalOf::Build(id.to_owned()), at_most }
}

pub(super) const HEXAGONS: Example = Example {
    id: "lesson-stiffness-of-hexagons",
    title: "Lesson: the stiffness of hexagons",
    summary: "An exercise to hand in: a shell of hexagonal plates. Its frame alone would fold; its plates make it stiff, once every one is exactly flat.",
    statement: "The plates, up to 7.7 mm from flat, come within 1 mm, and one goal is missed: close is not exact.",
    make: hexagons,
};

const HEXAGONS_TEXT: &str = "Three bars meet in each node of this shell. As a frame with hinges it folds: n nodes can move in 3 n ways, and there are only 1.5 n bars. If the hexagons are plates, it stands, because three planes have one point in common. That is why shells of bars are made of triangles, and shells of plates of hexagons. But a plate has to be flat.

1. Under Check, set Colour by to Planarity, and press Run. The plates become nearly flat, but the first goal is missed.
2. Under Shape, press Plane in the list, and set Required to Exact. The plates become flat at once.
3. Look at the shapes: where the shell bends more in one direction, flat hexagons become narrow in the other.";

fn hexagons(scene: &mut Scene) -> Mesh {
    scene.constraints = vec![constraint("plane", each(Element::Face), 1.0)];
    near_where_it_was(scene);
    let exact = Goal { of: GoalOf::Constraint("Plane".to_owned()), at_most: 0.0 };
    scene.lesson = Some(lesson(
        HEXAGONS_TEXT,
        vec![exact, worst("displacement", 0.25)],
        &[Lock::Weights, Lock::Handles, Lock::Mesh],
    ));
    honeycomb(12, |_| 10, |u, v| [7.0 * u, 6.0 * v, 4.0 - 2.4 * u * u - 1.2 * v * v])
}

pub(super) const PAPER: Example = Example {
    id: "lesson-paper-model",
    title: "Lesson: a model of paper",
    summary: "An exercise to hand in: a roof becomes a model of card, on two sheets of A4, to print, cut, fold and glue.",
    statement: "The worst panel, 4.8 mm from flat, comes within 1 mm; at 1:50 the model needs more than two sheets, at 1:100 no more.",
    make: paper,
};

const PAPER_TEXT: &str = "A model of paper shows in an hour what a screen does not. Flat panels are cut together as strips or nets, folded along their edges, and glued at tabs. A panel that is not flat does not lie on the table: it has to be creased along its diagonal.

1. Press Run: every panel becomes flat to less than a millimetre.
2. Press Build, and look at the sheets: red lines are cut, blue ones are folded away from you, dashed ones towards you. The name on a tab is that of the panel to which it is glued.
3. In Scale, choose one at which the model fits on two sheets. In Pieces, compare Nets with Strips: which can you fold more easily?
4. Press Save drawings and tables, print sheets.pdf at 100 %, and build it.";

fn paper(scene: &mut Scene) -> Mesh {
    let roof = Canopy {
        panels: [20, 14],
        span: [20.0, 14.0],
        rise: 2.4,
        crown: 2.0,
        waist: 0.04,
        wave: 0.12,
    };
    scene.constraints = vec![constraint("plane", each(Element::Face), 1.0)];
    near_where_it_was(scene);
    scene.build = Some(Box::new(BuildSettings {
        product: Product::Paper,
        sheet: [297.0, 210.0],
        ..BuildSettings::default()
    }));
    scene.lesson = Some(lesson(
        PAPER_TEXT,
        vec![of_build("panel_flatness", 0.001), of_build("sheets", 2.0)],
        &[Lock::Weights, Lock::Handles, Lock::Mesh],
    ));
    roof.mesh()
}

pub(super) const EXACT: Example = Example {
    id: "lesson-exact-and-variations",
    title: "Lesson: exact, and what is still free",
    summary: "An exercise to hand in: all panes of a roof are exactly flat, and still it can take other shapes. Find one whose panes have better corners.",
    statement: "The panes, up to 9 mm from flat, become exactly flat, and one goal is missed: some corners are 25 degrees from right angles.",
    make: exact,
};

const EXACT_TEXT: &str = "What is exact is not yet decided. Each flat pane is a condition on its four corners, and a roof has more freedom than its panes have conditions: it can move in many ways in which all of them stay flat. These are its variations, and to choose among them is design.

1. Press Run. All panes become flat, to less than a millionth of a millimetre.
2. Under Check, set Colour by to Angle error. Where are the panes farthest from rectangles?
3. Under Move, press Variations. Each slider is a way to move in which panes stay flat, the softest first. Find one with which no angle is more than 23.5 degrees from a right one, and keep it.";

fn exact(scene: &mut Scene) -> Mesh {
    scene.constraints = vec![ConstraintSpec {
        require: Require::Exact,
        ..constraint("plane", each(Element::Face), 1.0)
    }];
    let flat = Goal { of: GoalOf::Constraint("Plane".to_owned()), at_most: 0.0 };
    scene.lesson = Some(lesson(
        EXACT_TEXT,
        vec![flat, worst("angles", 23.5)],
        &[Lock::Constraints, Lock::Handles, Lock::Mesh],
    ));
    roof_on_feet(scene)
}
