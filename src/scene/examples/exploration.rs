//! Fig. 6: shapes of circular meshes and of webs of circles, found by pulling at handles.

use super::{Example, constraint, each, fixed, moved};
use crate::constraint::{Element, Selector};
use crate::mesh::Mesh;
use crate::mesh::generate::{Lantern, Net};
use crate::scene::{ClosenessTo, Scene};

pub(super) const LANTERN: Example = Example {
    id: "fig-06-exploration",
    title: "Lantern, pulled out of the round",
    summary: "Drag the blue handles on the rim: no panel keeps its size or place, but all of them keep circles through their corners.",
    statement: "S",
    ending: "obj",
    make: lantern,
};

pub(super) const WEB: Example = Example {
    id: "fig-06-web",
    title: "Web of circular arcs",
    summary: "Every line of edges, in both directions, bends to one circular arc while the handles pull, and the panels keep their proportions.",
    statement: "S",
    ending: "obj",
    make: web,
};

fn lantern(scene: &mut Scene) -> Mesh {
    let lantern = Lantern::default();
    let mesh = lantern.mesh();
    // Circles alone would let the few panels at a handle take up all of its move: that rings keep
    // their proportions, at a small weight, spreads it.
    let rings = Selector::Each { element: Element::Ring, within: None, radius: 1 };
    scene.constraints =
        vec![constraint("circle", each(Element::Face), 10.0), constraint("similar", rings, 0.02)];
    scene.closeness.to = ClosenessTo::None;
    // The ground stays; the rim is moved aside, drawn out, and tilted.
    scene.handles = vec![
        fixed(lantern.ring(0).collect()),
        moved(&mesh, lantern.ring(lantern.rows).collect(), |[x, y, z]| {
            [1.2 * x + 4.0, 0.95 * y, z + 0.3 * x + 1.5]
        }),
    ];
    mesh
}

fn web(scene: &mut Scene) -> Mesh {
    let net = Net::default();
    let mesh = net.mesh();
    scene.constraints = vec![
        constraint("circle", each(Element::Curve), 10.0),
        constraint("similar", each(Element::Face), 1.0),
    ];
    scene.closeness.to = ClosenessTo::None;
    let [nx, ny] = net.panels.map(|n| n as u32);
    let vertex = |i: u32, j: u32| j * (nx + 1) + i;
    // The corners stay; the middle of one long side is lifted and pulled out, that of the other
    // lowered.
    let corners = vec![vertex(0, 0), vertex(nx, 0), vertex(0, ny), vertex(nx, ny)];
    let [front, back] = [0, ny].map(|j| (nx / 2 - 1..=nx / 2 + 1).map(|i| vertex(i, j)).collect());
    scene.handles = vec![
        fixed(corners),
        moved(&mesh, front, |[x, y, z]| [x, y - 5.0, z + 5.0]),
        moved(&mesh, back, |[x, y, z]| [x, y, z - 3.0]),
    ];
    mesh
}
