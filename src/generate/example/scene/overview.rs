//! Fig. 1: circles, rigid areas, spheres and handles on polygons, triangles and tetrahedra.

use super::parts::{constraint, each, fixed, moved};
use crate::constraint::{Element, Selector, Set};
use crate::generate::example::Example;
use crate::generate::model::{Blocks, Mounds, Vase};
use crate::mesh::Mesh;
use crate::scene::{ClosenessTo, Scene, Smoothness, SmoothnessOf, Weighting, Weights};

pub(super) const OVERVIEW: Example = Example {
    id: "fig-01-overview",
    title: "Circles, a rigid area and a sphere together",
    summary: "Every polygon becomes circular and the top of the wide mound settles on a sphere, while a handle pulls up the narrow mound, whose top stays rigid.",
    statement: "The panels, 7 cm from circular on average, come to less than 3 cm; the crown, up to 50 cm from a sphere, comes within 2 cm of one; the rigid area keeps its shape within 3 cm.",
    make: overview,
};

pub(super) const TRIANGLES: Example = Example {
    id: "fig-01-triangles",
    title: "Vase with a round belly",
    summary: "On triangles: the belly settles on a sphere and the rim becomes a circle, while the rim is pulled over and the foot stays rigid.",
    statement: "The belly, up to 39 cm from a sphere, comes within 1 cm of one; the rim, up to 2.2 m from a circle when it is pulled, within 1 cm; the foot keeps its shape within 2 mm.",
    make: triangles,
};

pub(super) const TETRAHEDRA: Example = Example {
    id: "fig-01-tets",
    title: "Solid club with a round head",
    summary: "On tetrahedra: the skin of the square head swells to a sphere and two collars become circles, while the grip stays rigid and the head is raised.",
    statement: "The skin of the head, more than 2 m from a sphere when it is pulled, comes within 15 cm of one; the collars, up to 48 cm from circles, within 3 cm; the grip keeps its shape within 1 cm.",
    make: tetrahedra,
};

fn overview(scene: &mut Scene) -> Mesh {
    let mesh = Mounds::default().mesh();
    // The squared distance of a vertex from a point, in plan.
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
        scene.sets.insert(name.to_owned(), Set { faces: faces.into(), ..Set::default() });
    }
    scene.constraints = vec![
        constraint("circle", each(Element::Face), 1.0),
        constraint("sphere", Selector::Set("crown".to_owned()), 5.0),
        constraint("rigid", Selector::Set("rigid".to_owned()), 20.0),
    ];
    // The short sides rest on walls; the cells at the top of the narrow mound are pulled up.
    let all = || 0..mesh.positions.len() as u32;
    let walls = all().filter(|&v| mesh.positions[v as usize][0].abs() == 20.0).collect();
    let grip = all().filter(|&v| distance(v, narrow) < 1.5 * 1.5).collect();
    scene.handles = vec![fixed(walls), moved(&mesh, grip, |[x, y, z]| [x - 1.0, y, z + 3.0])];
    scene.weights = Weights { shape: 10.0, close: 0.1, smooth: 0.1 };
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    mesh
}

fn triangles(scene: &mut Scene) -> Mesh {
    let mesh = Vase::mesh();
    let rings =
        |rings: std::ops::RangeInclusive<u32>| -> Vec<u32> { rings.flat_map(Vase::ring).collect() };
    let (foot, rim) = (rings(0..=3), rings(Vase::ROWS..=Vase::ROWS));
    for (name, vertices) in [("foot", foot), ("belly", rings(6..=16)), ("rim", rim.clone())] {
        scene.sets.insert(name.to_owned(), Set { vertices: vertices.into(), ..Set::default() });
    }
    let stars = Selector::Each { element: Element::Ring, within: None, radius: 1 };
    scene.constraints = vec![
        constraint("sphere", Selector::Set("belly".to_owned()), 5.0),
        constraint("circle", Selector::Set("rim".to_owned()), 10.0),
        constraint("rigid", Selector::Set("foot".to_owned()), 20.0),
        constraint("similar", stars, 0.2),
    ];
    // The foot is fixed; one side of the rim is pulled.
    let lip = rim[0];
    scene.handles = vec![
        fixed(Vase::ring(0).collect()),
        moved(&mesh, vec![lip], |[x, y, z]| [x + 2.5, y, z - 0.5]),
    ];
    scene.weights = Weights { shape: 10.0, close: 0.0, smooth: 0.1 };
    scene.closeness.to = ClosenessTo::None;
    scene.smoothness = Smoothness { of: SmoothnessOf::Displacement, weighting: Weighting::Uniform };
    mesh
}

fn tetrahedra(scene: &mut Scene) -> Mesh {
    // The head is a cube of side six, the rest a bar of four by four along its middle.
    const SHAFT: u32 = 16;
    const HEAD: u32 = 6;
    let mesh = Blocks::new([SHAFT + HEAD, HEAD, HEAD], |[x, y, z]| {
        x >= SHAFT || [y, z].iter().all(|k| (1..HEAD - 1).contains(k))
    })
    .tetrahedra();
    let [shaft, head] = [SHAFT, HEAD].map(f64::from);
    let skin: std::collections::BTreeSet<u32> = mesh.faces.indices().iter().copied().collect();
    let select = |only_skin: bool, is_meant: &dyn Fn(f64) -> bool| -> Vec<u32> {
        let all = 0..mesh.positions.len() as u32;
        all.filter(|v| !only_skin || skin.contains(v))
            .filter(|&v| is_meant(mesh.positions[v as usize][0]))
            .collect()
    };
    let sets = [
        ("handle", select(false, &|x| x <= 4.0)),
        ("collar 1", select(true, &|x| x == 8.0)),
        ("collar 2", select(true, &|x| x == 12.0)),
        ("head", select(true, &|x| x >= shaft)),
    ];
    for (name, vertices) in sets {
        scene.sets.insert(name.to_owned(), Set { vertices: vertices.into(), ..Set::default() });
    }
    let set = |name: &str| Selector::Set(name.to_owned());
    scene.constraints = vec![
        constraint("sphere", set("head"), 10.0),
        constraint("circle", set("collar 1"), 40.0),
        constraint("circle", set("collar 2"), 40.0),
        constraint("rigid", set("handle"), 20.0),
        constraint("rigid", each(Element::Tet), 0.5),
    ];
    // The end of the grip is fixed, and the far side of the head is raised.
    let end = select(false, &|x| x == 0.0);
    let middle = [shaft + head, 0.5 * head, 0.5 * head];
    let tip = mesh.positions.iter().position(|&p| p == middle).expect("it is a corner of cubes");
    scene.handles =
        vec![fixed(end), moved(&mesh, vec![tip as u32], |[x, y, z]| [x - 1.5, y, z + 6.0])];
    scene.weights = Weights { shape: 10.0, close: 0.0, smooth: 0.0 };
    scene.closeness.to = ClosenessTo::None;
    mesh
}
