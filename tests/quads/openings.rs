//! Openings: those that panels run over, those that are named, and slits of triangles without area.

use super::parts::check_named_size;
use super::surfaces::{parametric, roof};
use super::{panels, with};
use shape_up::math::{Vec3, cosine, sine};
use shape_up::mesh::{Mesh, Ragged};
use shape_up::quads::{MapOptions, PanelSize, RemeshError, RemeshNote, Remesher};

/// The roof with an opening of this radius around its vertex 220, whose corners are pulled there.
fn with_bolt_hole(radius: f64) -> Mesh {
    let mut mesh = roof();
    let centre = Vec3::from(mesh.positions[220]);
    let fan: Vec<u32> = (0..)
        .zip(mesh.faces.iter())
        .filter(|(_, face)| face.contains(&220))
        .map(|(f, _)| f)
        .collect();
    let mut inner: Vec<(u32, u32)> = Vec::new();
    let mut faces = Ragged::default();
    for (f, face) in (0..).zip(mesh.faces.clone().iter()) {
        if !fan.contains(&f) {
            faces.push(face);
            continue;
        }
        let k = face.iter().position(|&v| v == 220).unwrap();
        let outer = [face[(k + 1) % 3], face[(k + 2) % 3]];
        let near = outer.map(|v| {
            inner.iter().find(|(of, _)| *of == v).map(|&(_, own)| own).unwrap_or_else(|| {
                let way = (Vec3::from(mesh.positions[v as usize]) - centre).direction_or_zero();
                mesh.positions.push((centre + way * radius).into());
                inner.push((v, mesh.positions.len() as u32 - 1));
                mesh.positions.len() as u32 - 1
            })
        });
        faces.push(&[outer[0], outer[1], near[1]]);
        faces.push(&[outer[0], near[1], near[0]]);
    }
    Mesh { faces, ..mesh }
}

/// The roof cut along an edge line of three edges, whose sides stay where they are.
fn with_crack(width: f64) -> Mesh {
    let mut mesh = roof();
    let lip = [219, 220];
    for &v in &lip {
        let [x, y, z] = mesh.positions[v as usize];
        mesh.positions.push([x, y + width, z]);
    }
    let first = mesh.positions.len() as u32 - 2;
    let above = |face: &[u32]| {
        let middle = face.iter().map(|&v| mesh.positions[v as usize][1]).sum::<f64>() / 3.0;
        middle > mesh.positions[220][1]
    };
    let renamed = |face: &[u32]| -> Vec<u32> {
        let name = |&v: &u32| lip.iter().position(|&it| it == v).map_or(v, |k| first + k as u32);
        face.iter().map(|v| if above(face) { name(v) } else { *v }).collect()
    };
    let faces = mesh.faces.iter().map(renamed).collect();
    Mesh { faces, ..mesh }
}

/// Refused at every size before, with sizes that contradicted each other.
#[test]
fn panels_run_over_openings_that_are_too_short_for_them() {
    for (name, mesh) in [
        ("hole", with_bolt_hole(0.016)),
        ("crack", with_crack(0.001)),
        ("closed crack", with_crack(0.0)),
    ] {
        let mesh = match name {
            "hole" => mesh,
            // Cracks of half a metre.
            _ => Mesh {
                positions: mesh.positions.iter().map(|p| p.map(|x| 0.2 * x)).collect(),
                ..mesh
            },
        };
        // The default of the hole; the cracks are less than two panels around, then less than four.
        let sizes = match name {
            "hole" => vec![PanelSize::Count(500)],
            _ => vec![PanelSize::Length(0.65), PanelSize::Length(0.4)],
        };
        for size in sizes {
            let found = with(&mesh, MapOptions::of_size(size));
            let found = found.unwrap_or_else(|error| panic!("{name}: {error}"));
            super::check_manifold(&found.mesh);
            assert_eq!((found.measures.euler, found.measures.loops), (1, 1), "{name}");
            assert_eq!(found.staying, 0, "{name}");
            let covered = |note: &&RemeshNote| note.words.starts_with("1 opening is too small");
            let note =
                found.notes.iter().find(covered).unwrap_or_else(|| panic!("{:?}", found.notes));
            let centre = mesh.positions[220];
            let off = (Vec3::from(note.places[0]) - Vec3::from(centre)).length();
            assert!(off < 0.3, "{name}: {off}");
        }
    }
}

/// A tube has no other way than through its ends.
#[test]
fn an_opening_that_is_no_hole_is_named() {
    let tube =
        parametric([16, 40], [true, false], |u, v| [0.1 * cosine(u), 0.1 * sine(u), 40.0 * v]);
    let refused = with(&tube, MapOptions::of_size(PanelSize::Length(0.5))).map(|_| ()).unwrap_err();
    let words = refused.words("m");
    assert!(words.starts_with("an opening is 0.62") && words.contains("close it"), "{words}");
    assert!(refused.place().is_some());
    check_named_size(&tube, &refused, "or less");
    // Sides that the area allowed but the openings did not were named.
    let refused = with(&tube, MapOptions::of_size(PanelSize::Length(3.0))).map(|_| ()).unwrap_err();
    assert!(matches!(refused, RemeshError::SizeTooLarge { .. }), "{refused}");
    check_named_size(&tube, &refused, "or less");
}

#[test]
fn an_opening_around_faces_that_stay_is_not_to_be_closed() {
    let mesh = roof();
    let options = MapOptions::of_size(PanelSize::Length(2.5));
    let refused = Remesher::beside(&mesh, &[420]).unwrap().remesh(&options, "m", &mut |_| ());
    let words = refused.map(|_| ()).unwrap_err().words("m");
    assert!(words.starts_with("an opening beside faces that stay is 3."), "{words}");
    assert!(words.ends_with("or less") && !words.contains("close it"), "{words}");
}

/// Triangles whose corners are on one line were dropped, which left a slit.
#[test]
fn triangles_without_area_leave_no_opening() {
    let mut mesh = roof();
    // Of every tenth face a side gets a vertex in its middle, and a sliver that closes the gap.
    let mut faces = Ragged::default();
    for (f, face) in (0..).zip(mesh.faces.iter()) {
        let [a, b, c] = [face[0], face[1], face[2]];
        if f % 10 != 3 {
            faces.push(face);
            continue;
        }
        let ends = [a, c].map(|v| Vec3::from(mesh.positions[v as usize]));
        mesh.positions.push(((ends[0] + ends[1]) * 0.5).into());
        let middle = mesh.positions.len() as u32 - 1;
        faces.push(&[a, b, middle]);
        faces.push(&[b, c, middle]);
        faces.push(&[a, middle, c]);
    }
    let mesh = Mesh { faces, ..mesh };
    for count in [100, 500] {
        let found = panels(&mesh, count).unwrap();
        super::check_manifold(&found.mesh);
        assert_eq!((found.measures.euler, found.measures.loops), (1, 1));
        assert!(found.notes.is_empty(), "{:?}", found.notes);
    }
}
