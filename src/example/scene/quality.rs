//! Fig. 7: the quality of a quad mesh with creases and corners.

use super::parts::{constraint, each, fixed};
use crate::constraint::Element;
use crate::example::Example;
use crate::example::model::Archway;
use crate::mesh::Mesh;
use crate::scene::{Scene, Weights};

pub(super) const ARCHWAY: Example = Example {
    id: "fig-07-quality",
    title: "Gatehouse of better quads",
    summary: "Uneven panels become more like squares: corners of panels glide over the surface, those on a crease only along it, and those where creases meet stay in place.",
    statement: "Of all corners of panels, 30 per cent are within 10 degrees of a right angle before, and more than 90 per cent after; vertices on a crease stay within 5 mm of it.",
    ending: "obj",
    make: archway,
};

fn archway(scene: &mut Scene) -> Mesh {
    let mesh = Archway::default().mesh();
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
