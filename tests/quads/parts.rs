//! Several parts, parts that touch, surfaces with one side, closed creases, and refusals.

use super::surfaces::{parametric, roof, torus, tube, vault};
use super::{check, panels, with};
use crate::support::shared;
use shape_up::math::{Vec3, cosine, sine};
use shape_up::mesh::{Edited, Mesh, Point, Surface, Topology};
use shape_up::quads::{
    InputSurface, MapOptions, PanelSize, RemeshError, RemeshNote, RemeshStage, Remesher, remesh,
};

/// Both meshes in one.
fn both(first: &Mesh, second: &Mesh, moved: Point) -> Mesh {
    let mut mesh = first.clone();
    let count = first.positions.len() as u32;
    mesh.positions.extend(second.positions.iter().map(|p| [0, 1, 2].map(|k| p[k] + moved[k])));
    for face in second.faces.iter() {
        let face: Vec<u32> = face.iter().map(|v| v + count).collect();
        mesh.faces.push(&face);
    }
    mesh
}

#[test]
fn each_part_has_its_share_of_the_panels() {
    let mesh = both(&torus(), &tube(), [10.0, 0.0, 0.0]);
    let found = panels(&mesh, 400).unwrap();
    check(&mesh, &found);
    assert_eq!(found.measures.irregular.inside, 0);
    assert!((340..=460).contains(&found.measures.quads), "{}", found.measures.quads);
}

#[test]
fn a_ring_thinner_than_a_panel_does_not_vanish() {
    // No faces at all have the Euler characteristic and the loops of a torus.
    let ring = parametric([60, 12], [true, true], |u, v| {
        let radius = 1.0 + 0.05 * cosine(v);
        [radius * cosine(u), radius * sine(u), 0.05 * sine(v)]
    });
    for size in [0.3, 0.5, 0.65] {
        match with(&ring, MapOptions::of_size(PanelSize::Length(size))) {
            Ok(found) => {
                assert!(!found.mesh.faces.is_empty(), "{size}");
                assert_eq!((found.measures.euler, found.measures.loops), (0, 0), "{size}");
            }
            Err(error) => assert!(
                matches!(error, RemeshError::NotFollowed { .. } | RemeshError::SizeTooLarge { .. }),
                "{size}: {error}"
            ),
        }
    }
}

#[test]
fn the_limit_of_panels_is_that_of_all_parts_together() {
    let mesh = both(&tube(), &tube(), [10.0, 0.0, 0.0]);
    let refused = panels(&mesh, 150_000).unwrap_err();
    assert!(matches!(refused, RemeshError::SizeTooSmall { .. }), "{refused}");
}

/// A bowl whose lowest point is at the origin and is its first vertex.
fn bowl(upwards: f64) -> Mesh {
    let mut mesh = Mesh::default();
    mesh.positions.push([0.0; 3]);
    let (around, rings) = (24, 8);
    for ring in 1..=rings {
        for k in 0..around {
            let (turn, radius) = (f64::from(k) / f64::from(around), f64::from(ring) / 4.0);
            let height = upwards * 0.2 * radius * radius;
            mesh.positions.push([radius * cosine(turn), 1.3 * radius * sine(turn), height]);
        }
    }
    let name = |ring: u32, k: u32| 1 + (ring - 1) * around + k % around;
    for k in 0..around {
        mesh.faces.push(&[0, name(1, k), name(1, k + 1)]);
        for ring in 1..rings {
            let [a, b] = [name(ring, k), name(ring, k + 1)];
            let [c, d] = [name(ring + 1, k + 1), name(ring + 1, k)];
            mesh.faces.push(&[a, d, c]);
            mesh.faces.push(&[a, c, b]);
        }
    }
    mesh
}

#[test]
fn bowls_that_touch_in_a_vertex_are_two_surfaces() {
    let mut mesh = both(&bowl(1.0), &bowl(-1.0), [0.0; 3]);
    let second = bowl(1.0).positions.len() as u32;
    // The lowest vertex of the second is that of the first.
    let name: Vec<u32> =
        (0..mesh.positions.len() as u32).map(|v| if v == second { 0 } else { v }).collect();
    mesh.faces.rename(&name);
    let found = panels(&mesh, 300).unwrap();
    assert_eq!((found.measures.euler, found.measures.loops), (2, 2));
    assert!(found.mesh.faces.iter().all(|face| face.len() == 4));
}

#[test]
fn a_surface_with_one_side_is_refused_with_a_place() {
    let (around, across) = (40_u32, 4_u32);
    let mut strip = parametric([around, across], [false, false], |u, v| {
        let (turn, width) = (u, v - 0.5);
        let radius = 3.0 + width * cosine(0.5 * turn);
        [radius * cosine(turn), radius * sine(turn), width * sine(0.5 * turn)]
    });
    // The last column is the first one, upside down.
    let last = |v: u32| v % (around + 1) == around;
    let name: Vec<u32> = (0..strip.positions.len() as u32)
        .map(|v| if last(v) { (across - v / (around + 1)) * (around + 1) } else { v })
        .collect();
    strip.faces.rename(&name);
    let refused = panels(&strip, 200).unwrap_err();
    assert!(matches!(refused, RemeshError::OneSided { .. }) && refused.place().is_some());
    assert!(refused.to_string().contains("one side"));
}

#[test]
fn a_closed_crease_is_a_line_of_the_panels() {
    // A hat: a flat brim, and a steep dome on it.
    let hat = parametric([48, 16], [true, false], |u, v| {
        let (radius, height) =
            if v <= 0.5 { (5.0 - 4.0 * v, 0.0) } else { (4.5 - 3.0 * v, 4.0 * v - 2.0) };
        [radius * cosine(u), radius * sine(u), height]
    });
    let found = panels(&hat, 300).unwrap();
    check(&hat, &found);
    let on_crease = |v: u32| {
        let [x, y, z] = found.mesh.positions[v as usize];
        z.abs() < 1e-9 && ((x * x + y * y).sqrt() - 3.0).abs() < 0.05
    };
    let topology = Topology::new(&found.mesh);
    let edges = topology.edges().iter().filter(|[a, b]| on_crease(*a) && on_crease(*b)).count();
    let vertices = (0..found.mesh.positions.len() as u32).filter(|&v| on_crease(v)).count();
    assert!(vertices >= 12 && edges == vertices, "{vertices} {edges}: one closed line");
    let options = MapOptions { crease: None, ..MapOptions::of_size(PanelSize::Count(300)) };
    check(&hat, &with(&hat, options).unwrap());
}

/// What is said to fit does, and has the unit.
pub(super) fn check_named_size(mesh: &Mesh, error: &RemeshError, fits: &str) {
    let words = error.words("m");
    let side = words.split(" sides of ").nth(1).expect("it names a size");
    let (number, rest) = side.split_once(' ').expect("it has a unit");
    assert_eq!(rest, format!("m {fits}"));
    let length: f64 = number.replace('−', "-").parse().expect("it is a number");
    let size = PanelSize::Length(length);
    let part = &InputSurface::parts(mesh, &[]).unwrap().surfaces[0];
    assert!(part.prepare(2.0, length, &MapOptions::of_size(size)).is_ok(), "{words}");
}

#[test]
fn what_cannot_be_remeshed_is_refused_with_the_reason() {
    let refused = |mesh: &Mesh, size: PanelSize| {
        with(mesh, MapOptions::of_size(size)).map(|_| ()).unwrap_err()
    };
    assert_eq!(refused(&Mesh::default(), PanelSize::Count(100)), RemeshError::Empty);
    let mut one =
        Mesh { positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], ..Mesh::default() };
    one.faces.push(&[0, 1, 2]);
    let few = refused(&one, PanelSize::Count(100));
    assert!(matches!(few, RemeshError::TooFewTriangles { .. }), "{few}");
    let filled = Mesh { tets: vec![[0, 1, 2, 3]], ..tube() };
    assert_eq!(refused(&filled, PanelSize::Count(100)), RemeshError::Tetrahedra);
    let large = refused(&tube(), PanelSize::Length(5.0));
    assert!(matches!(large, RemeshError::SizeTooLarge { .. }), "{large}");
    let small = refused(&tube(), PanelSize::Length(1e-6));
    assert!(matches!(small, RemeshError::SizeTooSmall { .. }), "{small}");
    for (error, fits) in [(&large, "or less"), (&small, "or more")] {
        check_named_size(&tube(), error, fits);
    }
    // A third sheet along a line of the vault.
    let mut branching = vault();
    branching.positions.push([4.0, 3.0, 9.0]);
    let fin = branching.positions.len() as u32 - 1;
    branching.faces.push(&[100, 101, fin]);
    let found = refused(&branching, PanelSize::Count(100));
    assert!(matches!(found, RemeshError::BranchingEdge { count: 1, .. }), "{found}");
}

/// The vertices of the last `count` faces.
fn last_faces(mesh: &Mesh, count: usize) -> Vec<Vec<Point>> {
    let point = |&v: &u32| mesh.positions[v as usize];
    let faces = mesh.faces.iter().skip(mesh.faces.len() - count);
    faces.map(|face| face.iter().map(point).collect()).collect()
}

#[test]
fn a_part_that_cannot_be_covered_stays_as_it_is_and_is_named() {
    // Two lids of four triangles, and a tube that is smaller than a panel.
    let lid = parametric([2, 1], [false, false], |u, v| [u, v, 0.1 * u]);
    let thin =
        parametric([12, 6], [true, false], |u, v| [0.05 * cosine(u), 0.05 * sine(u), 0.1 * v]);
    let mut mesh = both(&tube(), &lid, [40.0, 0.0, 0.0]);
    mesh = both(&mesh, &lid, [50.0, 0.0, 0.0]);
    mesh = both(&mesh, &thin, [60.0, 0.0, 0.0]);
    let found = panels(&mesh, 200).unwrap();
    let staying = 2 * lid.faces.len() + thin.faces.len();
    assert_eq!(found.staying, staying);
    assert_eq!(last_faces(&found.mesh, staying), last_faces(&mesh, staying));
    assert_eq!(found.measures.quads, found.mesh.faces.len() - staying);
    assert_eq!((found.measures.euler, found.measures.loops), (0, 2), "those of the tube");
    let words: Vec<&str> = found.notes.iter().map(|note| &note.words[..]).collect();
    assert!(words.contains(&"2 small parts stay as they are"), "{words:?}");
    let large = words.iter().find(|words| words.starts_with("1 part stays as it is: "));
    assert!(large.is_some_and(|words| words.contains("too large")), "{words:?}");
    let far = |point: &Point| point[0] > 30.0;
    assert!(found.notes.iter().all(|note| note.places.iter().all(far)));

    // A face whose two halves touch in one place: it was there twice.
    let hourglass = [[0., 0.], [1., 0.], [0.5, 1.], [1., 2.], [0., 2.], [0.5, 1.]];
    let hourglass = Mesh {
        positions: hourglass.map(|[x, y]| [40.0 + x, y, 0.0]).to_vec(),
        faces: [[0, 1, 2, 3, 4, 5]].iter().collect(),
        ..Mesh::default()
    };
    assert_eq!(panels(&both(&tube(), &hourglass, [0.0; 3]), 200).unwrap().staying, 1);

    // What would leave most of it is refused.
    let most = both(&lid, &thin, [2.0, 0.0, 0.0]);
    let refused = panels(&most, 200).map(|_| ()).unwrap_err();
    assert!(matches!(refused, RemeshError::TooFewTriangles { .. }), "{refused}");
}

/// They vanished, and with them what joined their neighbours.
#[test]
fn faces_without_area_stay_with_their_part() {
    // A sheet with a fin, and a face that closes the gap to a vertex on one of its sides; and two such
    // faces alone.
    let mut sheet = parametric([4, 4], [false, false], |u, v| [u, v, 0.0]);
    sheet.positions.extend([[0.125, 0.0, 0.0], [0.4, 0.4, 1.0]]);
    let first = sheet.faces.iter().position(|face| face.contains(&0) && face.contains(&1));
    let mut faces: Vec<Vec<u32>> = sheet.faces.iter().map(<[u32]>::to_vec).collect();
    let cut = faces.remove(first.expect("it has an edge there"));
    let apex = *cut.iter().find(|v| **v > 1).expect("a third corner");
    faces.extend([vec![0, 25, apex], vec![25, 1, apex], vec![0, 1, 25], vec![6, 7, 26]]);
    sheet.faces = faces.iter().collect();
    let flat = Mesh {
        positions: [0.0, 1.0, 2.0, 3.0].map(|x| [x, 0.0, 0.0]).to_vec(),
        faces: [[0, 1, 2], [1, 2, 3]].iter().collect(),
        ..Mesh::default()
    };
    let others = both(&sheet, &flat, [5.0, 0.0, 0.0]);
    let found = panels(&both(&tube(), &others, [40.0, 0.0, 0.0]), 200).unwrap();
    assert_eq!(found.staying, sheet.faces.len() + 2);
    let sorted = |mesh: &Mesh, moved: f64| {
        let mut faces: Vec<_> = last_faces(mesh, found.staying);
        faces.iter_mut().flatten().for_each(|point| point[0] += moved);
        faces.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
        faces
    };
    assert_eq!(sorted(&found.mesh, 0.0), sorted(&others, 40.0));
    let words: Vec<&str> = found.notes.iter().map(|note| &note.words[..]).collect();
    assert!(words.contains(&"1 small part stays as it is"), "{words:?}");
    let branching =
        "1 part stays as it is: three or more faces meet in an edge: split the surface there";
    assert!(words.contains(&branching), "{words:?}");
}

/// The first one was named, whatever its size.
#[test]
fn if_no_part_can_be_covered_the_largest_is_named() {
    let lid = parametric([2, 1], [false, false], |u, v| [u, v, 0.1 * u]);
    let mut branching = vault();
    branching.positions.push([4.0, 3.0, 9.0]);
    let fin = branching.positions.len() as u32 - 1;
    branching.faces.push(&[100, 101, fin]);
    let refused = panels(&both(&lid, &branching, [40.0, 0.0, 0.0]), 200).map(|_| ()).unwrap_err();
    assert!(matches!(refused, RemeshError::BranchingEdge { .. }), "{refused}");
}

#[test]
fn faces_that_are_to_stay_do() {
    let mesh = vault();
    let stay: Vec<u32> = (0..40).collect();
    let options = MapOptions::of_size(PanelSize::Count(150));
    let mut remesher = Remesher::beside(&mesh, &stay).unwrap();
    let found = remesher.remesh(&options, "m", &mut |_| ()).unwrap();
    assert_eq!(found.staying, 40);
    let kept: Vec<Vec<Point>> = last_faces(&mesh, mesh.faces.len()).drain(..40).collect();
    assert_eq!(last_faces(&found.mesh, 40), kept);
    assert!(found.notes.is_empty(), "{:?}", found.notes);
}

/// Vertices that the panels miss were near to the other wall.
#[test]
fn faces_that_stay_change_no_measure_of_the_panels() {
    let options = MapOptions::of_size(PanelSize::Length(1.5));
    let mut alone = Remesher::new(&vault()).unwrap();
    let expected = alone.remesh(&options, "m", &mut |_| ()).unwrap().measures;
    let missed = expected.distance.from_input;
    let walls = both(&vault(), &vault(), [0.0, 0.0, -0.3 * missed]);
    let inner: Vec<u32> = (0..walls.faces.len() as u32).skip(walls.faces.len() / 2).collect();
    let mut outer = Remesher::beside(&walls, &inner).unwrap();
    assert_eq!(outer.remesh(&options, "m", &mut |_| ()).unwrap().measures, expected);
}

#[test]
fn where_no_face_is_to_be_covered_the_reason_is_said() {
    let mut mesh = vault();
    let refused = |mesh: &Mesh, stay: &[u32]| Remesher::beside(mesh, stay).map(|_| ()).unwrap_err();
    let all: Vec<u32> = (0..mesh.faces.len() as u32).collect();
    assert_eq!(refused(&mesh, &all), RemeshError::AllStay);
    // All faces but one without area.
    mesh.faces.push(&[0, 1, 0]);
    assert_eq!(refused(&mesh, &all), RemeshError::AllStay);
    // Nothing was asked to stay, but no position is known.
    mesh.unplaced = (0..mesh.positions.len() as u32).collect();
    assert_eq!(refused(&mesh, &[]), RemeshError::Unplaced);
}

/// The opening around them was refused, as if they had been asked to stay.
#[test]
fn faces_at_a_vertex_without_a_position_are_left_out_and_said() {
    let mut mesh = roof();
    let at = mesh.positions[220];
    mesh.positions[220] = [at[0], at[1], at[2] - 40.0];
    mesh.unplaced = vec![220];
    let stay: Vec<u32> = (0..)
        .zip(mesh.faces.iter())
        .filter(|(_, face)| face.contains(&220))
        .map(|(f, _)| f)
        .collect();
    let found = with(&mesh, MapOptions::of_size(PanelSize::Length(4.5))).unwrap();
    assert_eq!((found.staying, found.measures.loops), (0, 1));
    let note = found.notes.iter().find(|note| note.words.contains("not a number")).unwrap();
    let said = format!("{} faces are left out, since they have a vertex", stay.len());
    assert!(note.words.starts_with(&said), "{}", note.words);
    assert!((Vec3::from(note.places[0]) - Vec3::from(at)).length() < 1.0, "{:?}", note.places);
    // Asked to stay, they do.
    let mut remesher = Remesher::beside(&mesh, &stay).unwrap();
    let options = MapOptions::of_size(PanelSize::Length(2.0));
    let beside = remesher.remesh(&options, "m", &mut |_| ()).unwrap();
    assert_eq!((beside.staying, beside.notes.len()), (stay.len(), 0), "{:?}", beside.notes);
    // No panel comes from them.
    let Edited { mesh: mut made, origins } = Edited::covering(&mesh, &found.mesh);
    origins.carry(&mesh, &mut made);
    assert!(made.unplaced.is_empty());
    assert!(origins.faces.indices().iter().all(|face| !stay.contains(face)));
}

#[test]
fn an_observer_sees_all_stages_in_order() {
    let options = MapOptions::of_size(PanelSize::Count(150));
    let mut stages: Vec<RemeshStage> = Vec::new();
    remesh(&vault(), &options, "m", &mut |stage| stages.push(stage)).unwrap();
    stages.dedup();
    assert!(stages.is_sorted() && stages.len() == 6, "{stages:?}");
}

#[test]
fn creases_that_are_dropped_are_named() {
    // Edges of a solid that are shorter than its panels: they were dropped silently.
    let Some(mesh) = shared::mesh("rhombitruncated_cubeoctahedron.off") else { return };
    let found = panels(&mesh, 400).unwrap();
    let dropped = |note: &&RemeshNote| note.words.contains("creases that are nearer to each other");
    let note = found.notes.iter().find(dropped).expect("some are");
    let surface = Surface::new(&mesh.positions, &mesh);
    for &place in &note.places {
        let foot = surface.closest(place, &mut Surface::NO_HINT.clone());
        assert!(
            (Vec3::from(place) - Vec3::from(foot)).length() < found.measures.edge.mean,
            "{place:?}"
        );
    }
}
