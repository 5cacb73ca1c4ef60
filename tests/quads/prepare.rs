//! Surfaces prepared for the map: parts, refinement, features, and what is refused.

use super::surfaces::{parametric, plate, torus, tube};
use shape_up::math::{cosine, sine};
use shape_up::mesh::{Mesh, Ragged};
use shape_up::quads::{Boundary, InputSurface, MapOptions, PanelSize, Prepared, RemeshError};

fn options() -> MapOptions {
    MapOptions::of_size(PanelSize::Count(100))
}

fn prepared(mesh: &Mesh, size: f64) -> Prepared {
    let parts = InputSurface::components(mesh).unwrap();
    assert_eq!(parts.len(), 1);
    parts[0].prepare(size, &options()).unwrap()
}

/// Two triangles to each square of a grid.
fn sheet(n: u32, at: impl Fn(f64, f64) -> [f64; 3]) -> Mesh {
    parametric([n, n], [false, false], at)
}

#[test]
fn triangles_are_short_and_features_are_apart() {
    let roof = sheet(6, |u, v| [6.0 * u, 6.0 * v, 3.0 - (6.0 * u - 3.0).abs()]);
    for (mesh, size) in [(plate(), 0.3), (tube(), 0.4), (torus(), 0.5), (roof.clone(), 0.7)] {
        let whole: f64 =
            InputSurface::components(&mesh).unwrap().iter().map(InputSurface::area).sum();
        let Prepared { surface, .. } = prepared(&mesh, size);
        assert!((surface.area() - whole).abs() < 1e-12 * whole, "nothing is lost");
        let mut on_feature = vec![false; surface.positions.len()];
        for side in surface.sides().filter(|&side| surface.is_feature(side)) {
            on_feature[surface.corner(side.triangle, side.side)] = true;
            on_feature[surface.corner(side.triangle, side.side + 1)] = true;
        }
        for side in surface.sides() {
            assert!(surface.along(side).length() <= size, "no edge is longer than a panel");
            let ends = [0, 1].map(|k| on_feature[surface.corner(side.triangle, side.side + k)]);
            assert!(surface.is_feature(side) || ends != [true; 2], "features are apart");
            if let Some(back) = surface.across(side) {
                assert_eq!(surface.across(back), Some(side));
                assert_eq!(surface.is_feature(side), surface.is_feature(back));
            }
        }
        assert!(surface.feature.iter().all(|sides| sides.iter().filter(|&&is| is).count() < 2));
    }
    let notes = prepared(&roof, 0.7).notes;
    assert!(notes.creases > 0, "the ridge is a crease");
    let parts = InputSurface::components(&roof).unwrap();
    let smooth = parts[0].prepare(0.7, &MapOptions { crease: None, ..options() }).unwrap();
    assert_eq!(smooth.notes.creases, 0);
    let cut = MapOptions { boundary: Boundary::Cut, crease: None, ..options() };
    let cut = parts[0].prepare(0.7, &cut).unwrap();
    assert!(cut.surface.feature.as_flattened().iter().all(|is| !is), "a cut boundary is none");
}

#[test]
fn a_zigzag_boundary_has_no_more_corners_than_a_straight_one() {
    let straight = sheet(40, |u, v| [6.0 * u, 6.0 * v, 0.0]);
    let mut zigzag = straight.clone();
    for (k, point) in zigzag.positions.iter_mut().enumerate() {
        if point[1] == 0.0 && k % 2 == 1 {
            point[1] = -0.1;
        }
    }
    // Each edge turns by 67 degrees to the next.
    assert_eq!(prepared(&straight, 0.6).notes.corners.len(), 4);
    assert_eq!(prepared(&zigzag, 0.6).notes.corners.len(), 4);
}

#[test]
fn a_sharp_corner_is_a_wedge() {
    // A rhombus of 40 and 140 degrees.
    let rhombus = sheet(12, |u, v| {
        [5.0 * u + 5.0 * v * cosine(40.0 / 360.0), 5.0 * v * sine(40.0 / 360.0), 0.0]
    });
    assert_eq!(prepared(&rhombus, 0.4).notes.wedges, 2);
}

#[test]
fn touching_and_separate_parts_are_told_apart() {
    let one = sheet(4, |u, v| [u, v, 0.0]);
    let n = one.positions.len() as u32;
    // Another one beyond the corner (1, 1), which they share.
    let mut two = one.clone();
    two.positions.extend(one.positions.iter().map(|p| [p[0] + 1.0, p[1] + 1.0, p[2]]));
    for face in one.faces.iter() {
        let name = |v: u32| if v == 0 { n - 1 } else { v + n };
        two.faces.push(&[name(face[0]), name(face[1]), name(face[2])]);
    }
    let parts = InputSurface::components(&two).unwrap();
    assert_eq!(parts.iter().map(InputSurface::area).collect::<Vec<_>>(), [1.0, 1.0]);
    // Polygons are triangulated, and faces that are turned over are turned back.
    let mut mixed = Mesh { positions: one.positions.clone(), ..Mesh::default() };
    for (k, face) in one.faces.iter().enumerate() {
        let mut face = face.to_vec();
        if k % 3 == 0 {
            face.reverse();
        }
        mixed.faces.push(&face);
    }
    assert_eq!(InputSurface::components(&mixed).unwrap()[0].area(), 1.0);
}

#[test]
fn what_cannot_be_remeshed_is_refused_with_the_place() {
    let error = |mesh: &Mesh| InputSurface::components(mesh).unwrap_err();
    assert_eq!(error(&Mesh::default()), RemeshError::Empty);
    let flat = Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]],
        faces: Ragged::from_iter([[0, 1, 2]]),
        ..Mesh::default()
    };
    assert_eq!(error(&flat), RemeshError::Empty);
    let small = sheet(2, |u, v| [u, v, 0.0]);
    assert!(matches!(error(&small), RemeshError::TooFewTriangles { .. }));
    let mut book = sheet(4, |u, v| [u, v, 0.0]);
    book.positions.push([0.1, 0.1, 1.0]);
    book.faces.push(&[6, 7, 25]);
    let RemeshError::BranchingEdge { at, count: 1 } = error(&book) else { panic!("it branches") };
    assert_eq!([at.x, at.y], [0.375, 0.25]);
    // A strip that is turned over before it closes.
    let mut strip = Mesh::default();
    for i in 0..20 {
        let turn = f64::from(i) / 20.0;
        for side in [-0.3, 0.3] {
            let radius = 2.0 + side * cosine(0.5 * turn);
            strip.positions.push([
                radius * cosine(turn),
                radius * sine(turn),
                side * sine(0.5 * turn),
            ]);
        }
        let [a, b] = [2 * i, 2 * i + 1];
        let [c, d] = if i < 19 { [a + 2, b + 2] } else { [1, 0] };
        strip.faces.push(&[a, c, d]);
        strip.faces.push(&[a, d, b]);
    }
    assert!(matches!(error(&strip), RemeshError::OneSided { .. }));
    let part = &InputSurface::components(&tube()).unwrap()[0];
    let size = |size: f64| part.prepare(size, &options()).map(|_| ());
    assert!(
        matches!(size(1e-3), Err(RemeshError::SizeTooSmall { least }) if size(least) == Ok(()))
    );
    assert!(matches!(size(f64::NAN), Err(RemeshError::SizeTooSmall { .. })));
    let Err(RemeshError::SizeTooLarge { greatest, .. }) = size(50.0) else { panic!("too large") };
    assert_eq!(size(greatest), Ok(()));
}
