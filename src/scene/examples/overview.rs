//! Fig. 1: circles, rigid areas, a sphere and handles on one polygon mesh.

use super::{Example, constraint, each, fixed, moved};
use crate::constraint::{Element, Selector, Set};
use crate::mesh::Mesh;
use crate::mesh::generate::Mounds;
use crate::scene::{Scene, Smoothness, SmoothnessOf, Weighting, Weights};

pub(super) const OVERVIEW: Example = Example {
    id: "fig-01-overview",
    title: "Circles, a rigid area and a sphere together",
    summary: "Every polygon becomes circular and the top of the wide mound settles on a sphere, while a handle pulls up the narrow one, whose top stays rigid.",
    statement: "The mean circularity error e_c falls from 2e-6 to less than 5e-7; the crown, up to 50 cm from a sphere, comes within 2 cm of one; the rigid area keeps its shape within 3 cm.",
    ending: "obj",
    make: overview,
};

fn overview(scene: &mut Scene) -> Mesh {
    let mesh = Mounds::default().mesh();
    // The squared distance of a vertex from a place, in plan.
    let distance = |v: u32, at: [f64; 2]| {
        let [x, y, _] = mesh.positions[v as usize];
        (x - at[0]) * (x - at[0]) + (y - at[1]) * (y - at[1])
    };
    let faces = |at: [f64; 2], radius: f64| -> Vec<u32> {
        let is_near = |face: &[u32]| face.iter().all(|&v| distance(v, at) < radius * radius);
        (0..).zip(mesh.faces.iter()).filter(|(_, face)| is_near(face)).map(|(f, _)| f).collect()
    };
    let [wide, narrow] = Mounds::MIDDLES;
    for (name, faces) in [("crown", faces(wide, 6.5)), ("rigid", faces(narrow, 4.0))] {
        scene.sets.insert(name.to_owned(), Set { vertices: Vec::new(), faces });
    }
    scene.constraints = vec![
        constraint("circle", each(Element::Face), 1.0),
        constraint("sphere", Selector::Set("crown".to_owned()), 5.0),
        constraint("rigid", Selector::Set("rigid".to_owned()), 20.0),
    ];
    // The short sides rest on walls, and the cells at the top of the narrow mound are pulled.
    let all = || 0..mesh.positions.len() as u32;
    let walls = all().filter(|&v| mesh.positions[v as usize][0].abs() == 20.0).collect();
    let grip = all().filter(|&v| distance(v, narrow) < 1.5 * 1.5).collect();
    scene.handles = vec![fixed(walls), moved(&mesh, grip, |[x, y, z]| [x - 1.0, y, z + 3.0])];
    scene.weights = Weights { shape: 10.0, close: 0.1, smooth: 0.1 };
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    mesh
}
