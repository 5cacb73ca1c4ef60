//! Models without polygons: curves on a mesh (paper section 4.1), and points without faces.

use super::parts::{constraint, fixed};
use crate::constraint::{Element, Selector, Set};
use crate::example::Example;
use crate::example::model::{Pavilion, Tower};
use crate::mesh::Mesh;
use crate::scene::{ClosenessTo, Scene, Smoothness, SmoothnessOf, Weighting, Weights};

pub(super) const SLABS: Example = Example {
    id: "curves-slabs",
    title: "Tower of flat slabs and round ribs",
    summary: "Every second line around the wavy tower becomes flat, as a floor slab has to be, and the lines between become circles; the panels follow.",
    statement: "Slabs that are up to 57 cm from a plane come within 2 mm of one; ribs that are up to 1 m from a circle come within 5 mm of one.",
    ending: "obj",
    make: slabs,
};

pub(super) const POINTS: Example = Example {
    id: "points-pavilion",
    title: "Pavilion of points, surveyed and set right",
    summary: "There are no faces here, only groups of inaccurate points: those of the dome settle on a sphere, those of floor and wall on planes, those of each column on a line.",
    statement: "Points that are up to 35 cm from the sphere, plane or line of their group come within 5 mm of it.",
    ending: "obj",
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
        scene.sets.insert(name.to_owned(), Set { vertices, faces: Vec::new() });
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
    let (mesh, groups) = Pavilion::default().cloud();
    for (name, vertices) in groups {
        let kind = match name.as_str() {
            "dome" => "sphere",
            "floor" | "wall" => "plane",
            _ => "line",
        };
        scene.constraints.push(constraint(kind, Selector::Set(name.clone()), 1.0));
        scene.sets.insert(name, Set { vertices, faces: Vec::new() });
    }
    // There is no surface to stay close to: each point stays close to its rest position.
    scene.closeness.to = ClosenessTo::Rest;
    scene.weights = Weights { shape: 100.0, close: 1.0, smooth: 0.0 };
    mesh
}
