//! Identities of offsets and panels that hold for every mesh, with their tolerances.

use super::{build, exact, fit, metres};
use crate::support::grid::grid;
use crate::support::shared;
use shape_up::fabricate::offset::check;
use shape_up::fabricate::panel::lay_flat;
use shape_up::fabricate::{Build, PanelSurface, Stand};
use shape_up::math::plane::{area, rotated};
use shape_up::math::{Vec3, cosine, sine};
use shape_up::mesh::{Mesh, Ragged};
use shape_up::scene::{BuildSettings, OffsetKind, Up};

/// Quads of a surface of revolution about z: each is an isosceles trapezium, whose corners are on a
/// circle, and the four around a vertex are tangent to a cone.
pub(crate) fn revolution(around: u32, rows: u32) -> Mesh {
    grid(around, rows, |i, j| {
        let turns = f64::from(i) / 24.0;
        let s = f64::from(j) / f64::from(rows);
        let radius = 2.0 - 0.9 * s * s + 0.2 * s;
        [radius * cosine(turns), radius * sine(turns), 1.7 * s + 0.3 * s * s * s]
    })
}

/// The mesh with every position mapped by `map`.
fn moved(mesh: &Mesh, map: impl Fn([f64; 3]) -> [f64; 3]) -> Mesh {
    Mesh { positions: mesh.positions.iter().map(|&p| map(p)).collect(), ..mesh.clone() }
}

/// An inversion preserves circles but no symmetry.
pub(crate) fn inverted(mesh: &Mesh) -> Mesh {
    moved(mesh, |[x, y, z]| {
        let [x, y, z] = [x + 4.0, y + 1.0, z + 2.5];
        let scale = 10.0 / (x * x + y * y + z * z);
        [x * scale, y * scale, z * scale]
    })
}

#[test]
fn corners_of_circular_quads_keep_their_distance_exactly() {
    for mesh in [revolution(9, 7), inverted(&revolution(9, 7))] {
        let surface = PanelSurface::new(&mesh).unwrap();
        let axes = exact(&surface, OffsetKind::Corner);
        for distance in [0.3, -0.2] {
            let found = check(&surface, &axes, OffsetKind::Corner, distance);
            assert!(found.distance_error < 1e-11, "{}", found.distance_error);
            assert!(found.warp < 1e-10, "{}", found.warp);
        }
    }
}

#[test]
fn panels_of_a_conical_mesh_keep_their_distance_exactly_and_so_does_the_offset_of_the_offset() {
    let mesh = revolution(11, 6);
    let surface = PanelSurface::new(&mesh).unwrap();
    let axes = exact(&surface, OffsetKind::Face);
    let found = check(&surface, &axes, OffsetKind::Face, 0.25);
    assert!(found.distance_error < 1e-11 && found.warp < 1e-10, "{found:?}");
    let offset = |mesh: &Mesh, axes: &[Vec3<f64>], d: f64| {
        let mut mesh = mesh.clone();
        for (position, axis) in mesh.positions.iter_mut().zip(axes) {
            *position = (Vec3::from(*position) + *axis * d).into();
        }
        mesh
    };
    let once = offset(&mesh, &axes, 0.1);
    let of_once = exact(&PanelSurface::new(&once).unwrap(), OffsetKind::Face);
    let (twice, direct) = (offset(&once, &of_once, 0.15), offset(&mesh, &axes, 0.25));
    for (a, b) in twice.positions.iter().zip(&direct.positions) {
        assert!((Vec3::from(*a) - Vec3::from(*b)).length() < 1e-6);
    }
}

#[test]
fn a_kind_is_exact_where_the_shape_allows_it_whether_it_is_chosen_proposed_or_asked_for_later() {
    let exact = revolution(9, 7);
    let noisy = moved(&exact, |[x, y, z]| [x, y, z + 0.01 * sine(1.4 * x * y)]);
    for (mesh, is_exact) in [(exact, true), (noisy, false)] {
        let build = |kind| build(&mesh, &BuildSettings { kind, ..BuildSettings::default() });
        let choices = build(None).choices();
        for (kind, choice) in OffsetKind::ALL.into_iter().zip(&choices) {
            let own = build(Some(kind));
            assert_eq!(own.choices(), choices, "{kind:?}");
            let offset = own.card().offset.unwrap();
            assert_eq!((offset.kind, offset.exact), (kind, choice.exact));
            assert_eq!(offset.warp_mm, choice.warp_mm);
        }
        let found = choices.iter().map(|choice| choice.exact).collect::<Vec<_>>();
        assert_eq!(found, [is_exact, is_exact, false]);
    }
}

#[test]
fn the_offset_of_a_shape_that_moves_is_that_of_a_new_build() {
    let before = revolution(9, 7);
    let after = moved(&before, |[x, y, z]| [x, y, z + 0.01 * sine(1.4 * x * y)]);
    for kind in OffsetKind::ALL.map(Some).into_iter().chain([None]) {
        let of_kind = |kind| BuildSettings { kind, ..BuildSettings::default() };
        let mut made = build(&before, &of_kind(kind));
        let shown = made.card().offset.unwrap().kind;
        made.reshape(&after.positions);
        let again = build(&after, &of_kind(Some(shown)));
        assert_eq!(made.card().offset, again.card().offset);
        assert_eq!(made.card().check, again.card().check);
        assert_eq!(made.layer(), again.layer());
    }
    // An inner vertex past its neighbour, then back.
    let mut folded = before.positions.clone();
    let inner = 3 * 10 + 4;
    folded[inner] = std::array::from_fn(|k| 2.2 * folded[inner + 1][k] - 1.2 * folded[inner][k]);
    let mut made = build(&before, &BuildSettings::default());
    made.reshape(&folded);
    assert!(made.card().offset.is_none() && made.card().problems[0].contains("folded over"));
    made.reshape(&before.positions);
    assert!(made.card().offset.is_some() && made.card().problems.is_empty());
}

#[test]
fn three_flat_panels_at_every_vertex_have_an_exact_offset_of_panels() {
    let Some(mesh) = shared::mesh("gc_dodecahedron_poly.obj") else { return };
    // Affine images of flat panels are flat.
    let mesh = moved(&mesh, |[x, y, z]| [1.3 * x + 0.2 * y, y - 0.4 * z, 0.7 * z + 0.1 * x]);
    let surface = PanelSurface::new(&mesh).unwrap();
    let found = check(&surface, &exact(&surface, OffsetKind::Face), OffsetKind::Face, 0.2);
    // The file has seven digits.
    assert!(found.distance_error < 1e-6 && found.warp < 1e-6, "{found:?}");
}

#[test]
fn axes_do_not_depend_on_place_size_numbering_or_first_corners() {
    let mesh =
        moved(&inverted(&revolution(7, 5)), |[x, y, z]| [x, y, z + 0.01 * (9.0 * x * y).abs()]);
    let n = mesh.positions.len();
    for kind in OffsetKind::ALL {
        let own = fit(&PanelSurface::new(&mesh).unwrap(), kind, 0.01);
        for scale in [1e-3, 1.0, 1e3] {
            // A right-angle rotation about z, a translation, and a scale.
            let other = moved(&mesh, |[x, y, z]| [scale * (5.0 - y), scale * (x - 3.0), scale * z]);
            let found = fit(&PanelSurface::new(&other).unwrap(), kind, 0.01);
            for (a, b) in own.iter().zip(&found) {
                assert!((Vec3::new(-a.y, a.x, a.z) - *b).length() < 1e-9, "{kind:?} {scale}");
            }
        }
        let renamed: Vec<u32> = (0..n as u32).map(|v| (v * 7 + 3) % n as u32).collect();
        let mut other = Mesh { positions: mesh.positions.clone(), ..Mesh::default() };
        (0..n).for_each(|v| other.positions[renamed[v] as usize] = mesh.positions[v]);
        for (face, f) in mesh.faces.iter().zip(0..) {
            let turned = (0..face.len()).map(|k| face[(k + f) % face.len()]);
            other.faces.push(&turned.map(|v| renamed[v as usize]).collect::<Vec<_>>());
        }
        let found = fit(&PanelSurface::new(&other).unwrap(), kind, 0.01);
        for (v, axis) in own.iter().enumerate() {
            assert!((*axis - found[renamed[v] as usize]).length() < 1e-9, "{kind:?} {v}");
        }
    }
}

#[test]
fn reversing_all_faces_negates_the_axes() {
    let mesh = revolution(6, 4);
    let mut other = Mesh { faces: Ragged::new(), ..mesh.clone() };
    mesh.faces.iter().for_each(|face| {
        other.faces.push(&face.iter().rev().copied().collect::<Vec<_>>());
    });
    for kind in OffsetKind::ALL {
        let [a, b] = [&mesh, &other].map(|mesh| fit(&PanelSurface::new(mesh).unwrap(), kind, 0.01));
        for (a, b) in a.iter().zip(&b) {
            assert!((*a + *b).length() < 1e-12, "{kind:?}");
        }
    }
}

#[test]
fn a_saltbox_is_not_folded_over_at_its_sharp_ridge() {
    // Slopes of 65 degrees, 2 m and 5 m long.
    let mesh = grid(6, 2, |i, j| {
        let along = [-2.0, 0.0, 5.0][j as usize];
        let turns = 65.0 / 360.0;
        [f64::from(i), along * cosine(turns), -f64::abs(along) * sine(turns)]
    });
    let report = build(&mesh, &BuildSettings::default()).report();
    assert!(report.card.offset.is_some(), "{:?}", report.card.problems);
    assert_eq!(report.card.problems, [""; 0]);
}

#[test]
fn the_first_side_of_a_reversed_panel_is_still_that_of_its_face_in_the_mesh() {
    let mut mesh = Mesh { faces: Ragged::new(), ..revolution(6, 4) };
    for (face, f) in revolution(6, 4).faces.iter().zip(0..) {
        let back = face.iter().rev().copied().collect::<Vec<_>>();
        mesh.faces.push(if f % 5 == 0 { &back } else { face });
    }
    let surface = PanelSurface::new(&mesh).unwrap();
    assert_eq!(surface.turned, 5);
    for (face, (panel, sides)) in
        mesh.faces.iter().zip(surface.faces.iter().zip(surface.sides.iter()))
    {
        let ends = |side: &[u32]| [side[0].min(side[1]), side[0].max(side[1])];
        assert_eq!(
            ends(panel),
            ends(face),
            "rotations are counted from the first edge in the model"
        );
        assert_eq!(surface.edges[sides[0] as usize].ends, ends(face));
    }
}

#[test]
fn arrows_point_up_the_slope_and_on_level_panels_to_the_top_of_the_plan() {
    let flat = grid(2, 2, |i, j| [f64::from(i), f64::from(j), 0.02 * f64::from(i)]);
    for (up, upwards, north) in
        [(Up::Z, [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]), (Up::Y, [0.0, 1.0, 0.0], [0.0, 0.0, -1.0])]
    {
        let [upwards, north] = [upwards, north].map(Vec3::from);
        // The axes of a mesh with y up.
        let stood = |mesh: &Mesh| {
            let at = mesh.positions.iter().map(|&[x, y, z]| match up {
                Up::Z => [x, y, z],
                Up::Y => [x, z, -y],
            });
            Mesh { positions: at.collect(), ..mesh.clone() }
        };
        let mut level = 0;
        for mesh in [stood(&revolution(6, 4)), stood(&flat)] {
            let stand = Stand { up, ..Stand::default() };
            let made = Build::new(&mesh, &BuildSettings::default(), metres(), &stand).unwrap();
            for (flat, cut) in made.flat.iter().flatten().zip(made.cut.iter().flatten()) {
                let arrow = made.parts[cut.part].arrow.unwrap();
                let [x, y] = rotated(arrow, [cut.turn[0], -cut.turn[1]]);
                let way = flat.axes[0] * x + flat.axes[1] * y;
                let normal = flat.axes[0].cross(flat.axes[1]);
                let is_level = normal.dot(upwards) > 0.997;
                level += usize::from(is_level);
                let to = if is_level { north } else { upwards };
                assert!((way.length() - 1.0).abs() < 1e-12 && way.dot(to) > 0.0, "{way:?}");
                assert!(way.dot(normal.cross(to)).abs() < 1e-12, "{way:?} is not the steepest");
            }
        }
        assert!(level >= 4, "{level}");
    }
}

#[test]
fn inside_the_safe_distance_no_edge_is_turned_and_outside_one_is() {
    let mesh = inverted(&revolution(9, 7));
    let surface = PanelSurface::new(&mesh).unwrap();
    let axes = fit(&surface, OffsetKind::Corner, 0.01);
    let turned = |d: f64| {
        let at = |v: u32| surface.at(v) + axes[v as usize] * d;
        let is_turned = |[i, j]: [u32; 2]| (at(j) - at(i)).dot(surface.at(j) - surface.at(i)) < 0.0;
        surface.edges.iter().filter(|edge| is_turned(edge.ends)).count()
    };
    let safe = check(&surface, &axes, OffsetKind::Corner, 0.1).safe_distance;
    assert!(safe.iter().flatten().count() > 0);
    for limit in safe.into_iter().flatten() {
        assert_eq!(turned(limit * (1.0 - 1e-9)), 0);
        assert!(turned(limit * (1.0 + 1e-9)) >= 1);
    }
}

#[test]
fn the_area_of_an_offset_panel_is_a_polynomial_of_the_distance() {
    let mesh = inverted(&revolution(5, 4));
    let surface = PanelSurface::new(&mesh).unwrap();
    let axes = exact(&surface, OffsetKind::Corner);
    for (face, f) in surface.faces.iter().zip(0..) {
        let n = surface.normal(f);
        let k = face.len();
        let sum = |a: &dyn Fn(usize) -> Vec3<f64>, b: &dyn Fn(usize) -> Vec3<f64>| {
            (0..k).map(|i| a(i).cross(b((i + 1) % k)).dot(n)).sum::<f64>()
        };
        let p = |i: usize| surface.at(face[i]);
        let s = |i: usize| axes[face[i] as usize];
        let (of_p, mixed, of_s) =
            (0.5 * sum(&p, &p), 0.25 * (sum(&p, &s) + sum(&s, &p)), 0.5 * sum(&s, &s));
        for d in [0.1, -0.2] {
            let q = |i: usize| p(i) + s(i) * d;
            let found = 0.5 * sum(&q, &q);
            assert!((found - (of_p + 2.0 * d * mixed + d * d * of_s)).abs() < 1e-10);
        }
    }
}

#[test]
fn every_flat_part_goes_back_to_its_place_in_space() {
    let mesh = moved(&inverted(&revolution(9, 7)), |[x, y, z]| [x + 5e4, y - 2e4, z]);
    let settings = BuildSettings { joint: 0.0, scale: 20.0, ..BuildSettings::default() };
    let made = build(&mesh, &settings);
    assert!(made.not_cut.is_empty() && made.layout.too_large.is_empty());
    let mut parts = 0;
    for sheet in &made.layout.sheets {
        for place in &sheet.places {
            let part = &made.parts[place.part];
            let f = part.panels[0] as usize;
            let (flat, cut) = (made.flat[f].as_ref().unwrap(), made.cut[f].as_ref().unwrap());
            let back = |[x, y]: [f64; 2], [c, s]: [f64; 2]| [c * x + s * y, c * y - s * x];
            for (&corner, &v) in part.outline.iter().zip(made.surface.faces.row(f)) {
                let [x, y] = place.to_sheet(corner);
                let on_sheet = [x - place.offset[0], y - place.offset[1]];
                let own =
                    back(back(on_sheet, place.turn), cut.turn).map(|x| x / made.mm_of_sheet());
                let point = flat.origin + flat.axes[0] * own[0] + flat.axes[1] * own[1];
                assert!((point - surface_point(&made, v)).length() < 1e-9, "{}", part.name);
            }
            parts += 1;
        }
    }
    assert_eq!(parts, mesh.faces.len());
}

fn surface_point(made: &Build, v: u32) -> Vec3<f64> {
    made.surface.at(v)
}

#[test]
fn flat_panels_keep_their_corner_distances_areas_and_angles() {
    let surface = PanelSurface::new(&revolution(9, 7)).unwrap();
    for f in 0..surface.faces.len() as u32 {
        let flat = lay_flat(&surface, f).unwrap();
        assert!(flat.flattening_error < 1e-11);
        assert!((area(&flat.corners) - surface.areas[f as usize].length()).abs() < 1e-11);
    }
}
