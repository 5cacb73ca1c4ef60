//! The shape, its offset and its beams in space, as groups of one mesh in the unit and the
//! coordinates of the model.

use crate::fabricate::beam::Prism;
use crate::fabricate::build::{Build, beam_name};
use crate::math::Vec3;
use crate::mesh::{Group, GroupKeyword, Mesh};

/// Panels, the offset, and every prism by its name; none if no beams are made.
pub(in crate::fabricate) fn solids(build: &Build) -> Option<Mesh> {
    let frame = build.frame.as_ref()?;
    let (axes, _) = build.offset.as_ref()?;
    let mut mesh = Mesh::default();
    let faces = || build.surface.faces.iter().map(<[u32]>::to_vec);
    let moved = |by: f64| -> Vec<Vec3<f64>> {
        build.surface.positions.iter().zip(&axes.axes).map(|(p, n)| *p + *n * by).collect()
    };
    let centre = build.surface.centre;
    add(&mut mesh, "panels", &moved(0.0), centre, faces());
    add(&mut mesh, "offset", &moved(build.distance()), centre, faces());
    for (edge, prism) in build.surface.edges.iter().zip(&frame.prisms) {
        if let Some(prism) = prism {
            let faces = Prism::faces();
            add(&mut mesh, &beam_name(edge.ends), &prism.corners, centre, faces);
        }
    }
    Some(mesh)
}

fn add(
    mesh: &mut Mesh,
    name: &str,
    points: &[Vec3<f64>],
    centre: Vec3<f64>,
    faces: impl IntoIterator<Item = Vec<u32>>,
) {
    let first = mesh.positions.len() as u32;
    mesh.positions.extend(points.iter().map(|&point| <[f64; 3]>::from(point + centre)));
    let first_face = mesh.faces.len() as u32;
    for face in faces {
        mesh.faces.push(&face.iter().map(|v| v + first).collect::<Vec<_>>());
    }
    let faces = (first_face..mesh.faces.len() as u32).collect();
    let (name, keyword) = (name.to_owned(), GroupKeyword::Group);
    mesh.groups.push(Group { name, keyword, faces, curves: Vec::new() });
}
