//! Circles, lines and planes through curves and points: Fig. 6, shapes of circular meshes and of
//! webs of circles under handles; curves on a mesh (section 4.1); points without faces.

use super::parts::{constraint, each, fixed, moved};
use crate::constraint::{Element, Selector, Set};
use crate::generate::example::Example;
use crate::generate::model::{Lantern, Net, Tower, pavilion};
use crate::mesh::Mesh;
use crate::scene::{ClosenessTo, Scene, Smoothness, SmoothnessOf, Weighting, Weights};

pub(super) const LANTERN: Example = Example {
    id: "fig-06-exploration",
    title: "Lantern, pulled out of the round",
    summary: "The rim is lifted, widened and tilted: the panels change in size and position, but their corners stay on circles.",
    statement: "All corners stay within 2 cm of the circles of their panels, and the panels are less than 4 mm from circular on average.",
    make: lantern,
};

pub(super) const WEB: Example = Example {
    id: "fig-06-web",
    title: "Web of circular arcs",
    summary: "Every line of edges, in both directions, bends to one circular arc while the handles pull, and the panels keep their proportions.",
    statement: "The lines, up to 6 m from circles once the handles have moved, come within 10 cm of them.",
    make: web,
};

fn lantern(scene: &mut Scene) -> Mesh {
    let mesh = Lantern::mesh();
    // With circles alone the few panels near a handle would absorb all of its displacement. Similar
    // rings at a small weight spread it.
    let rings = Selector::Each { element: Element::Ring, within: None, radius: 2 };
    scene.constraints =
        vec![constraint("circle", each(Element::Face), 10.0), constraint("similar", rings, 0.05)];
    scene.closeness.to = ClosenessTo::None;
    // The ground is fixed; the rim is lifted, widened, tilted and moved aside.
    scene.handles = vec![
        fixed(Lantern::ring(0).collect()),
        moved(&mesh, Lantern::ring(Lantern::ROWS).collect(), |[x, y, z]| {
            [1.25 * x + 1.5, 1.25 * y, z + 0.25 * x + 3.0]
        }),
    ];
    mesh
}

fn web(scene: &mut Scene) -> Mesh {
    let mesh = Net::mesh();
    scene.constraints = vec![
        constraint("circle", each(Element::Curve), 10.0),
        constraint("similar", each(Element::Face), 1.0),
    ];
    scene.closeness.to = ClosenessTo::None;
    let [nx, ny] = Net::PANELS.map(|n| n as u32);
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

pub(super) const SLABS: Example = Example {
    id: "curves-slabs",
    title: "Tower of flat slabs and round ribs",
    summary: "Every second line around the wavy tower becomes flat, as a floor slab has to be, and the lines between become circles; the panels follow.",
    statement: "Slabs that are up to 57 cm from a plane come within 2 mm of one; ribs that are up to 1 m from a circle come within 5 mm of one.",
    make: slabs,
};

pub(super) const POINTS: Example = Example {
    id: "points-pavilion",
    title: "Pavilion of points, surveyed and set right",
    summary: "There are no faces here, only groups of inaccurate points: those of the dome settle on a sphere, those of floor and wall on planes, those of each column on a line.",
    statement: "Points that are up to 35 cm from the sphere, plane or line of their group come within 5 mm of it.",
    make: points,
};

fn slabs(scene: &mut Scene) -> Mesh {
    let tower = Tower::default();
    let of = |first: usize| -> Vec<u32> {
        (0..=tower.rows).skip(first).step_by(2).flat_map(|k| tower.ring(k)).collect()
    };
    let lines = |name: &str| Selector::Each {
        element: Element::Curve,
        within: Some(name.to_owned()),
        radius: 0,
    };
    for (name, vertices) in [("slabs", of(0)), ("ribs", of(1))] {
        scene.sets.insert(name.to_owned(), Set { vertices: vertices.into(), ..Set::default() });
    }
    scene.constraints =
        vec![constraint("plane", lines("slabs"), 1.0), constraint("circle", lines("ribs"), 1.0)];
    scene.handles = vec![fixed(tower.ring(0).collect())];
    scene.weights = Weights { shape: 100.0, close: 0.05, smooth: 0.5 };
    scene.solver.iterations = 500;
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    tower.mesh()
}

fn points(scene: &mut Scene) -> Mesh {
    let (mesh, groups) = pavilion();
    for (name, vertices) in groups {
        let kind = match name.as_str() {
            "dome" => "sphere",
            "floor" | "wall" => "plane",
            _ => "line",
        };
        scene.constraints.push(constraint(kind, Selector::Set(name.clone()), 1.0));
        scene.sets.insert(name, Set { vertices: vertices.into(), ..Set::default() });
    }
    // There is no surface to stay close to: each point stays close to its rest position.
    scene.closeness.to = ClosenessTo::Rest;
    scene.weights = Weights { shape: 100.0, close: 1.0, smooth: 0.0 };
    mesh
}
