//! The three models that the page shows first.

use super::parts::{constraint, each, fixed};
use crate::constraint::{Element, Selector, Set};
use crate::generate::example::Example;
use crate::generate::model::{Canopy, Dome, Hypar};
use crate::mesh::Mesh;
use crate::scene::{
    ClosenessTo, ConstraintSpec, HANDLE_WEIGHT, HandleSpec, Hold, Require, Scene, Smoothness,
    SmoothnessOf, Weighting, Weights,
};

pub(super) const CANOPY: Example = Example {
    id: "canopy",
    title: "Canopy of circular panels",
    summary: "The corners of each panel come to lie exactly on a circle, while the blue handle lifts the edge over the entrance.",
    statement: "The corners, up to 43 cm from the circles of their panels, come to lie on them, to a millionth of a millimetre.",
    make: canopy,
};

pub(super) const DOME: Example = Example {
    id: "dome",
    title: "Dome with a hole",
    summary: "The panels become flatter, the oval rim of the hole becomes a true circle, and the rows around it settle on one sphere.",
    statement: "The crown, up to 19 cm from a sphere, comes within 1 cm of one; the rim, up to 50 cm from a circle, within 2 mm.",
    make: dome,
};

pub(super) const HYPAR: Example = Example {
    id: "hypar",
    title: "Hypar of straight beams",
    summary: "Every line of edges becomes straight, and on a saddle of straight lines no panel can be flat: the planarity error stops falling before it reaches zero.",
    statement: "Lines that are up to 1 m from straight come within 2 cm, and the panels stay warped, by 15 mm on average.",
    make: hypar,
};

fn canopy(scene: &mut Scene) -> Mesh {
    let canopy = Canopy::default();
    let mesh = canopy.mesh();
    let [nx, ny] = canopy.panels.map(|n| n as u32);
    let vertex = |i: u32, j: u32| j * (nx + 1) + i;
    scene.constraints = vec![ConstraintSpec {
        require: Require::Exact,
        ..constraint("circle", each(Element::Face), 1.0)
    }];
    let entrance = vertex(nx / 2, 0);
    let [x, y, z] = mesh.positions[entrance as usize];
    scene.handles = vec![
        fixed(vec![vertex(0, 0), vertex(nx, 0), vertex(0, ny), vertex(nx, ny)]),
        HandleSpec {
            vertices: vec![entrance],
            targets: Some(vec![[x, y - 0.6, z + 1.5]]),
            hold: Hold::Soft { weight: HANDLE_WEIGHT },
        },
    ];
    // Large enough that panels stay within the tolerance, a thousandth of an edge, during a drag.
    scene.weights = Weights { shape: 5000.0, close: 0.05, smooth: 1.0 };
    // The projection onto circles is not exact: the guard makes the total energy decrease.
    scene.solver.monotone = true;
    scene.solver.iterations = 800;
    scene.solver.tolerance = 1e-5;
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    mesh
}

fn dome(scene: &mut Scene) -> Mesh {
    let dome = Dome::default();
    let mesh = dome.mesh();
    let vertices = |rings: std::ops::Range<usize>| -> Vec<u32> {
        let of_ring = |(first, count)| first..first + count;
        rings.flat_map(|k| of_ring(dome.ring(k))).collect()
    };
    let last = dome.rings() - 1;
    let rings = [("crown", dome.rows[0] + 1..last + 1), ("rim", last..last + 1)];
    for (name, rings) in rings {
        let vertices = vertices(rings).into();
        scene.sets.insert(name.to_owned(), Set { vertices, ..Set::default() });
    }
    scene.constraints = vec![
        constraint("plane", each(Element::Face), 1.0),
        constraint("sphere", Selector::Set("crown".to_owned()), 1.0),
        constraint("circle", Selector::Set("rim".to_owned()), 1.0),
    ];
    // The four corners of the eaves stand on piers: three vertices each.
    let (first, count) = dome.ring(0);
    let piers = (0..4).flat_map(|corner| {
        let middle = count / 8 + corner * count / 4;
        (middle - 1..=middle + 1).map(move |i| first + i)
    });
    scene.handles = vec![fixed(piers.collect())];
    scene.weights = Weights { shape: 10.0, close: 0.05, smooth: 0.05 };
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    mesh
}

fn hypar(scene: &mut Scene) -> Mesh {
    scene.constraints = vec![
        constraint("line", each(Element::Curve), 1.0),
        constraint("plane", each(Element::Face), 0.1),
    ];
    // The beams along the sides are already straight.
    scene.handles = vec![fixed(Hypar::sides())];
    scene.weights = Weights { shape: 10.0, close: 0.0, smooth: 0.01 };
    scene.closeness.to = ClosenessTo::None;
    Hypar::mesh()
}
