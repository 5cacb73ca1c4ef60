//! Fig. 4, 5, 7 and 11: panels that become squares, flat, or circular.

use super::parts::{constraint, each, fixed};
use crate::constraint::Element;
use crate::generate::example::Example;
use crate::generate::model::{self, Hall, Patch, Strip, honeycomb};
use crate::mesh::Mesh;
use crate::scene::{Accelerator, BoundaryRequire, ClosenessTo, Scene, Weights};

pub(super) const PLANAR: Example = Example {
    id: "fig-05-planar",
    title: "Hall of flat panels",
    summary: "Colour the panels by planarity and run: two thousand bent panels become flat, and the roof keeps its shape.",
    statement: "With the paper's weights the panels, 8.5 mm from flat on average, come to less than 2.2 mm.",
    make: |scene| quads(scene, "plane"),
};

pub(super) const CIRCULAR: Example = Example {
    id: "fig-05-circular",
    title: "Hall of circular panels",
    summary: "Colour the panels by circularity and run: the four corners of each panel come to lie on a circle, which makes them flat as well.",
    statement: "With the paper's weights the panels, 22 cm from circular on average, come to less than 4 mm.",
    make: |scene| quads(scene, "circle"),
};

pub(super) const MIXED: Example = Example {
    id: "fig-05-mixed",
    title: "Hall of hexagons and other polygons",
    summary: "Nothing here is limited to quads: hexagons, pentagons, heptagons and the pieces along the border all come closer to circles by the same rule.",
    statement: "With the paper's weights the panels, 29 cm from circular on average, come to less than 5 cm.",
    make: mixed,
};

fn quads(scene: &mut Scene, kind: &str) -> Mesh {
    shaped(scene, kind);
    Hall::mesh()
}

fn mixed(scene: &mut Scene) -> Mesh {
    const WIDTH: f64 = 1.5;
    shaped(scene, "circle");
    // Rows of hexagons are closer together than hexagons are wide.
    let rows = (Hall::LENGTH / (0.866 * WIDTH)) as usize;
    honeycomb(
        rows,
        |u| (Hall::girth(u) / WIDTH) as usize,
        |u, v| {
            let [u, v] = Hall::askew(u, v);
            Hall::point(u, v)
        },
    )
}

/// Applies the weights of Fig. 5. The boundary stays close to its own curve: the paper has a
/// similar energy for it (section 4).
fn shaped(scene: &mut Scene, kind: &str) {
    scene.constraints = vec![constraint(kind, each(Element::Face), 1.0)];
    scene.weights = Weights { shape: 5.0, close: 10.0, smooth: 2.0 };
    scene.solver.iterations = 500;
    scene.closeness.boundary.require = BoundaryRequire::Soft;
}

pub(super) const SQUARES: Example = Example {
    id: "fig-04-squares",
    title: "Skew panels become squares",
    summary: "Press Half step, under Shape, Weights and solver, again and again: the local step finds the square that fits each panel best, and the global step moves each vertex close to the middle between the corners of its squares.",
    statement: "Corners that are up to 39 cm from the best square of their panel come within 2 cm in 200 plain iterations.",
    make: squares,
};

fn squares(scene: &mut Scene) -> Mesh {
    scene.constraints = vec![constraint("square", each(Element::Face), 1.0)];
    scene.weights = Weights { shape: 5.0, close: 1.0, smooth: 0.0 };
    // The global step moves vertices to a mean of their squares' corners and, with less weight, where
    // they were.
    scene.solver.accelerator = Accelerator::None;
    Patch::default().mesh()
}

pub(super) const ARCHWAY: Example = Example {
    id: "fig-07-quality",
    title: "Gatehouse with better quads",
    summary: "Uneven panels become more like squares: corners of panels glide over the surface, those on a crease only along it, and those where creases meet stay in place.",
    statement: "Of all corners of panels, 30 per cent are within 10 degrees of a right angle before, and more than 90 per cent after; vertices on a crease stay within 5 mm of it.",
    make: archway,
};

fn archway(scene: &mut Scene) -> Mesh {
    let mesh = model::archway();
    scene.constraints = vec![
        constraint("square", each(Element::Face), 1.0),
        // Each crease is a group. They are few and have to be kept, hence the large weight.
        constraint("on-curve", each(Element::Group), 100.0),
    ];
    let open = mesh.curves.iter().filter(|curve| curve.first() != curve.last());
    let mut corners: Vec<u32> = open.flat_map(|c| [c[0], c[c.len() - 1]]).collect();
    corners.sort_unstable();
    corners.dedup();
    scene.handles = vec![fixed(corners)];
    scene.weights = Weights { shape: 5.0, close: 1.0, smooth: 0.0 };
    mesh
}

pub(super) const STRIP: Example = Example {
    id: "fig-11-strip",
    title: "Strip with collapsing edges",
    summary: "Both long sides are fixed, and circular panels and fairness conflict in between: where both cannot be satisfied, edges shrink to almost nothing.",
    statement: "The corners, up to 38 mm from the circles of their panels, come within 7 mm, and the shortest edge falls from 24 cm to less than 2 cm.",
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
