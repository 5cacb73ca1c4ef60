//! Surfaces prepared for the map: parts, refinement, features, and what is refused.

use super::surfaces::{parametric, plate, torus, tube};
use shape_up::math::{Vec3, cosine, sine};
use shape_up::mesh::{Mesh, Ragged};
use shape_up::quads::{
    Boundary, InputParts, InputSurface, MapOptions, PanelSize, Prepared, RemeshError, Side,
    Triangulation,
};

fn options() -> MapOptions {
    MapOptions::of_size(PanelSize::Count(100))
}

/// The parts that can be covered: all of them.
fn surfaces(mesh: &Mesh) -> Vec<InputSurface> {
    let InputParts { surfaces, staying, .. } = InputSurface::parts(mesh, &[]).unwrap();
    assert!(staying.is_empty(), "{staying:?}");
    surfaces
}

fn prepared(mesh: &Mesh, size: f64) -> Prepared {
    let parts = surfaces(mesh);
    assert_eq!(parts.len(), 1);
    parts[0].prepare(2.0, size, &options()).unwrap()
}

/// Two triangles to each square of a grid.
fn sheet(n: u32, at: impl Fn(f64, f64) -> [f64; 3]) -> Mesh {
    parametric([n, n], [false, false], at)
}

#[test]
fn triangles_are_short_and_features_are_apart() {
    let roof = sheet(6, |u, v| [6.0 * u, 6.0 * v, 3.0 - (6.0 * u - 3.0).abs()]);
    for (mesh, size) in [(plate(), 0.3), (tube(), 0.4), (torus(), 0.5), (roof.clone(), 0.7)] {
        let whole: f64 = surfaces(&mesh).iter().map(InputSurface::area).sum();
        let Prepared { surface, .. } = prepared(&mesh, size);
        let area = |t: usize| 0.5 * surface.area_vector(t).length();
        let area: f64 = (0..surface.triangles.len()).map(area).sum();
        assert!((area - whole).abs() < 1e-12 * whole, "nothing is lost");
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
    let creases = |surface: &Triangulation| {
        let on_crease = |side: &Side| surface.is_feature(*side) && surface.across(*side).is_some();
        surface.sides().filter(on_crease).count()
    };
    assert!(creases(&prepared(&roof, 0.7).surface) > 0, "the ridge is a crease");
    let parts = surfaces(&roof);
    let smooth = parts[0].prepare(2.0, 0.7, &MapOptions { crease: None, ..options() }).unwrap();
    assert_eq!(creases(&smooth.surface), 0);
    let cut = MapOptions { boundary: Boundary::Cut, crease: None, ..options() };
    let cut = parts[0].prepare(2.0, 0.7, &cut).unwrap();
    assert!(cut.surface.feature.as_flattened().iter().all(|is| !is), "a cut boundary is none");
}

/// The normal of a thin triangle is that of rounding: its sides were creases that the grid had to follow.
#[test]
fn a_thin_triangle_makes_no_crease() {
    // A plate whose diagonal has vertices beside it, a little above.
    let mut mesh = sheet(6, |u, v| [10.0 * u, 10.0 * v, 0.0]);
    let mut faces = Ragged::default();
    for face in mesh.faces.iter() {
        let at = |k: usize| Vec3::from(mesh.positions[face[k % 3] as usize]);
        let diagonal = (0..3).find(|&k| {
            let along = at(k + 1) - at(k);
            along.x > 0.0 && along.y > 0.0 && face[(k + 1) % 3] % 7 == face[(k + 1) % 3] / 7
        });
        let Some(k) = diagonal else {
            faces.push(face);
            continue;
        };
        let [a, b, c] = [0, 1, 2].map(|j| face[(k + j) % 3]);
        let middle = mesh.positions.len() as u32;
        mesh.positions.push(((at(k) + at(k + 1)) * 0.5 + Vec3::new(0.0, 0.0, 2e-6)).into());
        faces.push(&[a, middle, c]);
        faces.push(&[middle, b, c]);
        faces.push(&[a, b, middle]);
    }
    assert_eq!(faces.len(), mesh.faces.len() + 12);
    mesh.faces = faces;
    let surface = prepared(&mesh, 0.5).surface;
    let inner = |side: &Side| surface.across(*side).is_some() && surface.is_feature(*side);
    assert_eq!(surface.sides().filter(inner).count(), 0);
}

#[test]
fn a_sharp_corner_is_that_of_one_panel() {
    // A rhombus of 40 and 140 degrees: an angle below 45 degrees rounds to no corner at all.
    let rhombus = sheet(12, |u, v| {
        [5.0 * u + 5.0 * v * cosine(40.0 / 360.0), 5.0 * v * sine(40.0 / 360.0), 0.0]
    });
    let found = super::panels(&rhombus, 120).unwrap();
    super::check(&rhombus, &found);
    for corner in [rhombus.positions[0], rhombus.positions[rhombus.positions.len() - 1]] {
        let at = |v: &u32| found.mesh.positions[*v as usize] == corner;
        assert_eq!(found.mesh.faces.iter().filter(|face| face.iter().any(at)).count(), 1);
    }
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
    let parts = surfaces(&two);
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
    assert_eq!(surfaces(&mixed)[0].area(), 1.0);
}

#[test]
fn what_cannot_be_remeshed_is_refused_with_the_place() {
    let error = |mesh: &Mesh| match InputSurface::parts(mesh, &[]) {
        Ok(parts) => parts.staying[0].error.clone(),
        Err(error) => error,
    };
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
    let part = &surfaces(&tube())[0];
    let size = |size: f64| part.prepare(2.0, size, &options()).map(|_| ());
    assert!(
        matches!(size(1e-3), Err(RemeshError::SizeTooSmall { least }) if size(least) == Ok(()))
    );
    assert!(matches!(size(f64::NAN), Err(RemeshError::SizeTooSmall { .. })));
    let Err(RemeshError::SizeTooLarge { greatest, .. }) = size(50.0) else { panic!("too large") };
    assert_eq!(size(greatest), Ok(()));
}
