//! Fig. 5: a freeform roof whose panels become planar, or circular.

use super::parts::{constraint, each};
use crate::constraint::Element;
use crate::example::Example;
use crate::example::model::{Hall, honeycomb};

use crate::mesh::Mesh;
use crate::scene::{BoundaryCloseness, Scene, Weights};

pub(super) const PLANAR: Example = Example {
    id: "fig-05-planar",
    title: "Hall of flat panels",
    summary: "Colour the panels by planarity and run: two thousand bent panels become flat, and the roof keeps its shape.",
    statement: "With the paper's weights the mean planarity error e_p falls from 1.8e-8 to less than 2e-9.",
    ending: "obj",
    make: |scene| quads(scene, "plane"),
};

pub(super) const CIRCULAR: Example = Example {
    id: "fig-05-circular",
    title: "Hall of circular panels",
    summary: "Colour the panels by circularity and run: the four corners of each panel come to lie on a circle, which makes them flat as well.",
    statement: "With the paper's weights the mean circularity error e_c falls from 9e-6 to less than 5e-9.",
    ending: "obj",
    make: |scene| quads(scene, "circle"),
};

pub(super) const MIXED: Example = Example {
    id: "fig-05-mixed",
    title: "Hall of hexagons and other polygons",
    summary: "Nothing here is limited to quads: hexagons, pentagons, heptagons and the pieces along the border all come closer to circles by the same rule.",
    statement: "With the paper's weights the mean circularity error e_c falls from 8e-6 to less than 5e-7.",
    ending: "obj",
    make: mixed,
};

fn quads(scene: &mut Scene, kind: &str) -> Mesh {
    shaped(scene, kind);
    Hall::default().mesh()
}

fn mixed(scene: &mut Scene) -> Mesh {
    const WIDTH: f64 = 1.5;
    let hall = Hall::default();
    shaped(scene, "circle");
    // Rows of hexagons are closer together than hexagons are wide.
    let rows = (hall.length / (0.866 * WIDTH)) as usize;
    honeycomb(
        rows,
        |u| (hall.girth(u) / WIDTH) as usize,
        |u, v| {
            let [u, v] = hall.askew(u, v);
            hall.point(u, v)
        },
    )
}

/// Applies the weights of Fig. 5. The boundary stays close to its own curve: the paper has a
/// similar energy for it (section 4).
fn shaped(scene: &mut Scene, kind: &str) {
    scene.constraints = vec![constraint(kind, each(Element::Face), 1.0)];
    scene.weights = Weights { shape: 5.0, close: 10.0, smooth: 2.0 };
    scene.solver.iterations = 500;
    scene.closeness.boundary = Some(BoundaryCloseness::default());
}
