//! Fig. 6: exploring shapes of circular meshes and of webs of circles by dragging handles.

use super::parts::{constraint, each, fixed, moved};
use crate::constraint::{Element, Selector};
use crate::example::Example;
use crate::example::model::{Lantern, Net};
use crate::mesh::Mesh;
use crate::scene::{ClosenessTo, Scene};

pub(super) const LANTERN: Example = Example {
    id: "fig-06-exploration",
    title: "Lantern, pulled out of the round",
    summary: "The rim is lifted, widened and tilted: the panels change in size and position, but their corners stay on circles.",
    statement: "All corners stay within 2 cm of the circles of their panels, with a mean circularity error e_c of less than 5e-8.",
    ending: "obj",
    make: lantern,
};

pub(super) const WEB: Example = Example {
    id: "fig-06-web",
    title: "Web of circular arcs",
    summary: "Every line of edges, in both directions, bends to one circular arc while the handles pull, and the panels keep their proportions.",
    statement: "The lines, up to 6 m from circles once the handles have moved, come within 10 cm of them.",
    ending: "obj",
    make: web,
};

fn lantern(scene: &mut Scene) -> Mesh {
    let lantern = Lantern::default();
    let mesh = lantern.mesh();
    // With circles alone the few panels near a handle would absorb all of its displacement. Similar
    // rings at a small weight spread it.
    let rings = Selector::Each { element: Element::Ring, within: None, radius: 2 };
    scene.constraints =
        vec![constraint("circle", each(Element::Face), 10.0), constraint("similar", rings, 0.05)];
    scene.closeness.to = ClosenessTo::None;
    // The ground is fixed; the rim is lifted, widened, tilted and moved aside.
    scene.handles = vec![
        fixed(lantern.ring(0).collect()),
        moved(&mesh, lantern.ring(lantern.rows).collect(), |[x, y, z]| {
            [1.25 * x + 1.5, 1.25 * y, z + 0.25 * x + 3.0]
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
    // The corners are fixed; the middle of one long side is lifted and pulled out, the other
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
