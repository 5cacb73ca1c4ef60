//! Fig. 9: conformal parametrisation. The scenes have no constraints; the page's `Flatten` and the
//! command line's `parametrize` flatten their meshes.

use crate::generate::example::Example;
use crate::generate::finish::opened;
use crate::generate::model::{self, Mounds};
use crate::mesh::Mesh;
use crate::scene::Scene;

pub(super) const MASK: Example = Example {
    id: "fig-09-conformal",
    title: "Mask, flattened",
    summary: "Press Flatten: the squares of the flat map change in size over the nose and the eyes, but their angles stay right angles.",
    statement: "The map of the uneven triangles has a mean angle distortion of less than 1.05 (1 keeps all angles), and none is turned over.",
    make: mask,
};

pub(super) const POLYGONS: Example = Example {
    id: "fig-09-polygons",
    title: "Mounds with an opening, flattened",
    summary: "Press Flatten: the mesh of hexagons and other polygons, with a hole in one mound, becomes flat; each polygon keeps its shape as well as it can.",
    statement: "The map of the polygons has a mean angle distortion of less than 1.1 (1 keeps all angles), and none is turned over.",
    make: polygons,
};

fn mask(_: &mut Scene) -> Mesh {
    model::mask()
}

fn polygons(_: &mut Scene) -> Mesh {
    let mounds = Mounds { heights: [16.0, 10.0], ..Mounds::default() };
    let [[x, y], _] = Mounds::MIDDLES;
    opened(&mounds.mesh(), |p| {
        let (dx, dy) = (p[0] - x, p[1] - y);
        dx * dx + dy * dy < 9.0
    })
}
