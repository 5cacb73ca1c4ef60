//! Subdivision: counts, Euler number, manifoldness, orientation, limits against closed forms, and
//! creases.

use crate::support::grid::grid;
use crate::support::{meshes, shared};
use proptest::prelude::*;
use shape_up::math::{cosine, sine};
use shape_up::mesh::{
    Edited, KEPT_TURN, Mesh, Scheme, SubdivideError, Subdivision, Topology, read,
};
use std::collections::BTreeMap;

const SCHEMES: [Scheme; 3] = [Scheme::CatmullClark, Scheme::Linear, Scheme::Loop];

fn subdivision(scheme: Scheme, levels: u32) -> Subdivision {
    Subdivision { scheme, levels, keep: KEPT_TURN }
}

fn subdivided(mesh: &Mesh, how: Subdivision) -> Edited {
    how.apply(mesh, &Topology::new(mesh)).expect("it can be subdivided")
}

/// The Euler number: vertices - edges + faces.
pub(crate) fn euler(mesh: &Mesh, topology: &Topology) -> i64 {
    mesh.positions.len() as i64 - topology.edges().len() as i64 + mesh.faces.len() as i64
}

/// Greatest number of face sides in the same direction between two vertices.
pub(crate) fn most_alike(mesh: &Mesh) -> usize {
    let mut sides = BTreeMap::new();
    for face in mesh.faces.iter() {
        for k in 0..face.len() {
            *sides.entry([face[k], face[(k + 1) % face.len()]]).or_insert(0) += 1;
        }
    }
    sides.into_values().max().unwrap_or(0)
}

pub(crate) fn most_faces(topology: &Topology) -> usize {
    topology.edge_faces().iter().map(<[u32]>::len).max().unwrap_or(0)
}

pub(crate) fn boundary_edges(topology: &Topology) -> usize {
    topology.edge_faces().iter().filter(|faces| faces.len() == 1).count()
}

/// Checks that hold for every mesh and every scheme.
fn check(mesh: &Mesh, how: Subdivision) {
    let topology = Topology::new(mesh);
    let counts = match how.counts(mesh, &topology) {
        Ok(counts) => counts,
        Err(refused) => return assert_eq!(how.apply(mesh, &topology), Err(refused)),
    };
    let Edited { mesh: refined, origins } = subdivided(mesh, how);
    let after = Topology::new(&refined);
    let found = (refined.positions.len(), refined.faces.len());
    assert_eq!((counts.vertices, counts.faces), found, "what it said beforehand");
    assert_eq!(euler(&refined, &after), euler(mesh, &topology));
    // Loops that touch can be split in several ways, so edges are counted: their number doubles.
    assert_eq!(boundary_edges(&after), boundary_edges(&topology) << how.levels);
    // Parts of one face share edges.
    assert_eq!(most_faces(&after), most_faces(&topology).max(2));
    assert_eq!(most_alike(&refined), most_alike(mesh), "faces run as they did");
    assert_eq!(origins.positions.apply(&mesh.positions).len(), refined.positions.len());
    for row in origins.positions.rows().skip(mesh.positions.len()) {
        let sum: f64 = row.iter().map(|(_, weight)| weight).sum();
        assert!((sum - 1.0).abs() < 1e-12, "an affine combination: {sum}");
    }
    for (v, between) in origins.between.iter().enumerate().take(mesh.positions.len()) {
        assert_eq!(between, [v as u32], "what came stays first");
    }
    assert!(refined.positions.as_flattened().iter().all(|x| x.is_finite()));
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(48))]

    #[test]
    fn counts_euler_number_boundary_and_orientation_are_right(mesh in meshes::mixed(), levels in 1..3_u32) {
        SCHEMES.into_iter().for_each(|scheme| check(&mesh, subdivision(scheme, levels)));
    }

    #[test]
    fn levels_at_once_are_levels_one_by_one_where_nothing_is_sharp(mesh in meshes::triangles()) {
        prop_assume!(!mesh.faces.is_empty());
        for scheme in SCHEMES {
            let how = Subdivision { scheme, levels: 1, keep: 180.0 };
            let twice = subdivided(&subdivided(&mesh, how).mesh, how).mesh;
            let at_once = subdivided(&mesh, Subdivision { levels: 2, ..how }).mesh;
            prop_assert_eq!(&at_once.faces, &twice.faces);
            for (a, b) in at_once.positions.as_flattened().iter().zip(twice.positions.as_flattened()) {
                prop_assert!((a - b).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn a_paraboloid_rises_as_the_spline_of_its_squares_does() {
    // The uniform cubic B-spline with coefficients i^2 is x^2 + 1/3; after k levels the rise is
    // (1 - 4^-k) of 1/3.
    let mesh = grid(10, 10, |i, j| {
        let (x, y) = (f64::from(i) - 5.0, f64::from(j) - 5.0);
        [x, y, 0.01 * (x * x + y * y)]
    });
    let [middle, on_boundary, corner] = [5 * 11 + 5, 5, 0];
    for levels in 1..=4 {
        let Edited { mesh: refined, .. } =
            subdivided(&mesh, subdivision(Scheme::CatmullClark, levels));
        let part = 1.0 - 0.25_f64.powi(levels as i32);
        assert!((refined.positions[middle][2] - 0.01 * 2.0 / 3.0 * part).abs() < 1e-14);
        let rises = refined.positions[on_boundary][2] - mesh.positions[on_boundary][2];
        assert!((rises - 0.01 / 3.0 * part).abs() < 1e-14, "a curve of its own");
        assert_eq!(refined.positions[corner], mesh.positions[corner]);
    }
}

#[test]
fn triangles_rise_as_the_box_spline_does() {
    // On the lattice of equilateral triangles a level adds 3/8 of the squared edge length: 1/2 in
    // the limit.
    let lattice = grid(10, 10, |i, j| {
        let (x, y) =
            (f64::from(i) + 0.5 * f64::from(j) - 7.5, (f64::from(j) - 5.0) * 0.75_f64.sqrt());
        [x, y, 0.01 * (x * x + y * y)]
    });
    let mut mesh = Mesh { positions: lattice.positions, ..Mesh::default() };
    for face in lattice.faces.iter() {
        mesh.faces.push(&[face[0], face[1], face[3]]);
        mesh.faces.push(&[face[1], face[2], face[3]]);
    }
    for levels in 1..=4 {
        let Edited { mesh: refined, .. } = subdivided(&mesh, subdivision(Scheme::Loop, levels));
        let expected = 0.01 * 0.5 * (1.0 - 0.25_f64.powi(levels as i32));
        assert!((refined.positions[5 * 11 + 5][2] - expected).abs() < 1e-14);
    }
}

pub(crate) fn cube() -> Mesh {
    let text = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n\
                f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    read("cube.obj", text.as_bytes()).expect("it is a mesh").mesh
}

#[test]
fn a_cube_stays_a_cube_or_becomes_round() {
    let Edited { mesh: sharp, .. } = subdivided(&cube(), subdivision(Scheme::CatmullClark, 3));
    let farthest = |p: &[f64; 3]| p.iter().fold(0.0, |far: f64, x| far.max(x.abs()));
    assert!(sharp.positions.iter().all(|p| (farthest(p) - 1.0).abs() < 1e-15));
    // The limit of a corner of three quads is (9 v + 4 sum e + sum f) / 24.
    let round = Subdivision { scheme: Scheme::CatmullClark, levels: 6, keep: 180.0 };
    let Edited { mesh: round, .. } = subdivided(&cube(), round);
    assert!(round.positions[6].iter().all(|x| (x - 0.5).abs() < 1e-3), "{:?}", round.positions[6]);
}

#[test]
fn a_crease_stays_sharp_at_every_level_and_runs_smoothly_along_itself() {
    // A roof with a bent ridge: its sides meet at 100 degrees.
    let ridge = 5.0 / 6.0;
    let roof = grid(2, 6, |i, j| {
        let (across, along) = (f64::from(i) - 1.0, f64::from(j));
        [across, along, -across.abs() / ridge + 0.02 * along * along]
    });
    let how = Subdivision { scheme: Scheme::CatmullClark, levels: 3, keep: KEPT_TURN };
    let Edited { mesh: refined, origins } = subdivided(&roof, how);
    let on_ridge = |between: &[u32]| between.len() < 3 && between.iter().all(|v| v % 3 == 1);
    let ridge = origins.between.iter().zip(&refined.positions).filter(|(b, _)| on_ridge(b));
    assert_eq!(ridge.clone().count(), 6 * 8 + 1);
    // Three levels of the spline with coefficients i^2, away from the ends.
    let rises = 0.02 / 3.0 * (1.0 - 0.25_f64.powi(3));
    for (_, [x, y, z]) in ridge.filter(|(_, p)| p[1] > 1.0 && p[1] < 5.0) {
        assert!(x.abs() < 1e-14 && (z - 0.02 * y * y - rises).abs() < 1e-12, "{y}: {z}");
    }
}

/// Its sides were creases: the rounded surface had a seam there.
#[test]
fn a_thin_triangle_makes_no_crease() {
    let text = |height: &str| {
        format!(
            "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 2 {height}\nf 1 2 3\nf 1 5 4\nf 5 3 4\nf 1 3 5\n"
        )
    };
    let refined = |height: &str| {
        let mesh = read("thin.obj", text(height).as_bytes()).expect("it is a mesh").mesh;
        subdivided(&mesh, subdivision(Scheme::Loop, 2)).mesh.positions
    };
    // One without area has no angle to its neighbours.
    for (a, b) in refined("0.000002").iter().zip(refined("0")) {
        assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-5), "{a:?} {b:?}");
    }
}

/// All triangles of the strips are thin, and none is one that rounding tilts: the ridge was rounded.
#[test]
fn a_ridge_between_narrow_strips_stays_a_crease() {
    // A gable roof, each strip 1 mm longer than the one before it.
    let mut mesh = Mesh::default();
    for k in 0..5u32 {
        let (half, across) = (10.0 + 0.0005 * f64::from(k), 0.01 * (f64::from(k) - 2.0));
        mesh.positions.extend([-half, half].map(|x| [x, across, -across.abs()]));
        if k > 0 {
            let [a, b, c, d] = [2 * k - 2, 2 * k - 1, 2 * k, 2 * k + 1];
            mesh.faces.push(&[a, b, d]);
            mesh.faces.push(&[a, d, c]);
        }
    }
    let refined = subdivided(&mesh, subdivision(Scheme::Loop, 1)).mesh;
    let on_ridge = refined.positions.iter().filter(|p| p[0].abs() < 1.0 && p[2].abs() < 1e-9);
    assert_eq!(on_ridge.count(), 1);
}

#[test]
fn linear_keeps_the_shape_and_its_area() {
    let flat = grid(3, 2, |i, j| [f64::from(i), f64::from(j) + 0.2 * f64::from(i), 0.0]);
    let Edited { mesh: refined, .. } = subdivided(&flat, subdivision(Scheme::Linear, 2));
    assert_eq!(&refined.positions[..flat.positions.len()], &flat.positions[..]);
    let area = |mesh: &Mesh| -> f64 {
        let twice = |face: &[u32]| -> f64 {
            let at = |k: usize| mesh.positions[face[k % face.len()] as usize];
            (0..face.len()).map(|k| at(k)[0] * at(k + 1)[1] - at(k + 1)[0] * at(k)[1]).sum()
        };
        mesh.faces.iter().map(twice).sum::<f64>() / 2.0
    };
    assert!((area(&refined) - area(&flat)).abs() < 1e-12);
    // Triangles stay triangles.
    let mut triangle = Mesh { positions: flat.positions, ..Mesh::default() };
    triangle.faces.push(&[0, 1, 4]);
    let Edited { mesh: refined, .. } = subdivided(&triangle, subdivision(Scheme::Linear, 1));
    assert_eq!(refined.faces.len(), 4);
    assert!(refined.faces.iter().all(|face| face.len() == 3));
}

#[test]
fn groups_and_curves_go_along() {
    let text = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\ng left\nf 1 2 5 4\ng right\nf 2 3 6 5\nl 1 2 3\n";
    let mesh = read("two.obj", text.as_bytes()).expect("it is a mesh").mesh;
    let Edited { mesh: refined, origins } = subdivided(&mesh, subdivision(Scheme::Linear, 1));
    assert_eq!(origins.faces.indices(), [0, 0, 0, 0, 1, 1, 1, 1]);
    let groups: Vec<_> = refined.groups.iter().map(|g| (&*g.name, g.faces.clone())).collect();
    assert_eq!(groups, [("left", vec![0, 1, 2, 3]), ("right", vec![4, 5, 6, 7])]);
    let along: Vec<f64> =
        refined.curves.row(0).iter().map(|&v| refined.positions[v as usize][0]).collect();
    assert_eq!(along, [0.0, 0.5, 1.0, 1.5, 2.0]);
}

#[test]
fn a_mesh_that_cannot_be_subdivided_is_refused_with_the_reason() {
    let quad = grid(1, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let refused = |mesh: &Mesh, how: Subdivision| how.counts(mesh, &Topology::new(mesh)).err();
    let mut tets = quad.clone();
    tets.tets.push([0, 1, 2, 3]);
    let mut twice = quad.clone();
    twice.faces.push(&[0, 1, 0]);
    let linear = subdivision(Scheme::Linear, 1);
    // Each new vertex at a face depends on all its corners, unless it is a mean of two.
    let corners = 5000;
    let round = |k: u32| [cosine(f64::from(k) / 5e3), sine(f64::from(k) / 5e3), 0.0];
    let large = Mesh {
        positions: (0..corners).map(round).collect(),
        faces: [(0..corners).collect::<Vec<u32>>()].iter().collect(),
        ..Mesh::default()
    };
    assert_eq!(refused(&large, linear), None);
    for (mesh, how, why) in [
        (&quad, subdivision(Scheme::Loop, 1), SubdivideError::NotTriangles(1)),
        (&tets, linear, SubdivideError::Tetrahedra),
        (&twice, linear, SubdivideError::Repeated(1)),
        (&Mesh::default(), linear, SubdivideError::Nothing),
        (&large, subdivision(Scheme::Linear, 2), SubdivideError::LargeFaces(5000)),
        (&large, subdivision(Scheme::CatmullClark, 1), SubdivideError::LargeFaces(5000)),
        (&quad, subdivision(Scheme::Linear, 0), SubdivideError::Levels(0)),
        (&quad, Subdivision { keep: f64::NAN, ..linear }, SubdivideError::Turn),
    ] {
        assert_eq!(refused(mesh, how), Some(why));
        assert!(!why.to_string().is_empty());
    }
    let large = grid(40, 40, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let most = refused(&large, subdivision(Scheme::Linear, 6));
    assert!(matches!(most, Some(SubdivideError::TooMany)), "{most:?}");
}

#[test]
fn the_meshes_of_others_go_through_every_scheme() {
    let Some(folder) = shared::path("meshes") else { return };
    for entry in std::fs::read_dir(folder).expect("it is a folder") {
        let path = entry.expect("it can be listed").path();
        let Ok(bytes) = std::fs::read(&path) else { continue };
        let Ok(file) = read(&path.to_string_lossy(), &bytes) else { continue };
        let topology = Topology::new(&file.mesh);
        let manifold = most_faces(&topology) <= 2;
        for scheme in SCHEMES {
            let how = subdivision(scheme, 1);
            if manifold && file.mesh.positions.len() < 30_000 {
                check(&file.mesh, how);
            }
        }
    }
}
