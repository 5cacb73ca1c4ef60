//! The built parts as objects on layers: every part is present, at its position and size.

use super::glb::TWO_NOTCHES;
use super::identities::revolution;
use super::{build, text_of};
use shape_up::fabricate::{Build, SpatialPart};
use shape_up::math::plane::area;
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, Product};

fn made() -> Build {
    let own = BuildSettings { product: Product::Fins, thickness: 3.0, ..BuildSettings::default() };
    build(&revolution(9, 7), &own)
}

fn on<'a>(parts: &'a [SpatialPart], layer: &str) -> Vec<&'a SpatialPart> {
    parts.iter().filter(|part| part.layer == layer).collect()
}

#[test]
fn every_panel_beam_node_and_part_of_a_sheet_is_on_its_layer_by_name() {
    let made = made();
    let parts = made.spatial_parts(true);
    let names = |layer: &str| -> Vec<String> {
        on(&parts, layer).iter().map(|part| part.name.clone()).collect()
    };
    assert_eq!(names("Panels"), made.names);
    assert_eq!(names("Nodes").len(), made.surface.positions.len());
    let prisms = made.frame.as_ref().unwrap().prisms.iter().flatten().count();
    assert_eq!(names("Beams").len(), prisms);
    let mut cut = names("Sheets CUT");
    let mut expected: Vec<_> = made.parts.iter().map(|part| part.name.clone()).collect();
    cut.sort();
    expected.sort();
    assert_eq!(cut, expected);
    assert_eq!((on(&parts, "Surface").len(), on(&parts, "Offset").len()), (1, 1));
}

#[test]
fn sheets_have_their_real_size_beside_the_shape() {
    let made = made();
    let parts = made.spatial_parts(true);
    let cut = on(&parts, "Sheets CUT");
    // The mesh is in metres.
    let found: f64 = cut
        .iter()
        .map(|part| area(&part.points.iter().map(|p| [1e3 * p[0], 1e3 * p[1]]).collect::<Vec<_>>()))
        .sum();
    let expected = made.report().cut_area_mm2;
    assert!((found - expected).abs() < 1e-6 * expected, "{found} {expected}");
    let right = made.surface.positions.iter().map(|p| p.x + made.surface.centre.x);
    let right = right.fold(f64::NEG_INFINITY, f64::max);
    assert!(cut.iter().flat_map(|part| &part.points).all(|p| p[0] > right));
}

#[test]
fn sheets_lie_as_low_as_the_shape_and_their_lines_are_cut_once() {
    let mut mesh = crate::support::grid::grid(3, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    mesh.positions.iter_mut().for_each(|[_, _, z]| *z += 408.0);
    let own = BuildSettings { gap: 0.0, joint: 0.0, ..BuildSettings::default() };
    let made = build(&mesh, &own);
    let parts = made.spatial_parts(true);
    let cut = on(&parts, "Sheets CUT");
    let points = || cut.iter().flat_map(|part| &part.points);
    let low = parts.iter().filter(|part| !part.layer.starts_with("Sheets"));
    let low = low.flat_map(|part| &part.points).map(|p| p[2]).fold(f64::INFINITY, f64::min);
    assert!((low - 408.0).abs() < 1.0 && points().all(|p| p[2] == low), "{low}");
    let length: f64 = (cut.iter())
        .map(|part| {
            let closing = part.points.first().filter(|_| part.closed);
            let around: Vec<_> = part.points.iter().chain(closing).collect();
            let side = |ends: &[&[f64; 3]]| {
                let [x, y] = [0, 1].map(|k| 1e3 * (ends[1][k] - ends[0][k]));
                (x * x + y * y).sqrt()
            };
            around.windows(2).map(side).sum::<f64>()
        })
        .sum();
    let expected = made.report().cut_length_mm;
    assert!((length - expected).abs() < 1e-6 * expected, "{length} {expected}");
}

#[test]
fn a_vertex_of_no_panel_is_in_no_file_and_moves_no_sheet() {
    let own = BuildSettings { product: Product::Fins, thickness: 3.0, ..BuildSettings::default() };
    let plain = revolution(5, 4);
    // Before the others, so that every number changes.
    let mut stray = Mesh { positions: vec![[1e6; 3]], ..Mesh::default() };
    stray.positions.extend(&plain.positions);
    for face in plain.faces.iter() {
        stray.faces.push(&face.iter().map(|v| v + 1).collect::<Vec<_>>());
    }
    let [without, with] = [&plain, &stray].map(|mesh| build(mesh, &own));
    for up in [true, false] {
        let parts = [&without, &with].map(|made| made.spatial_parts(up));
        // Names are longer, and have more strokes on the sheets.
        let points = parts.each_ref().map(|parts| {
            let of_shape = parts.iter().filter(|part| !part.layer.starts_with("Sheets"));
            of_shape.map(|part| part.points.len()).collect::<Vec<_>>()
        });
        assert_eq!(points[0], points[1]);
        let far = parts[1].iter().flat_map(|part| &part.points).flatten();
        assert!(far.fold(0.0_f64, |most, x| most.max(x.abs())) < 1e3);
    }
    let beams = |made: &Build| {
        text_of(made, "beams.obj").lines().filter(|line| line.starts_with("v ")).count()
    };
    assert_eq!(beams(&without), beams(&with));
}

#[test]
fn y_up_is_turned_so_that_z_is() {
    let made = made();
    let [z_up, y_up] = [true, false].map(|up| made.spatial_parts(up));
    let ([x, y, z], turned) = (z_up[0].points[5], y_up[0].points[5]);
    assert_eq!(turned, [x, -z, y]);
}

#[test]
fn panels_with_notches_and_many_corners_are_triangles() {
    let positions = TWO_NOTCHES.map(|[x, y]| [x, y, 0.0]).to_vec();
    let mut mesh = Mesh { positions, ..Mesh::default() };
    mesh.faces.push(&[0, 1, 2, 3, 4, 5, 6, 7]);
    let parts = build(&mesh, &BuildSettings::default()).spatial_parts(true);
    for layer in ["Surface", "Offset"] {
        let own = on(&parts, layer);
        let [SpatialPart { points, faces, .. }] = own[..] else { panic!("{layer}") };
        let areas = faces.iter().map(|face| {
            let corners: Vec<_> =
                face.iter().map(|&v| [points[v as usize][0], points[v as usize][1]]).collect();
            area(&corners)
        });
        let areas: Vec<f64> = areas.collect();
        assert!(areas.len() == 6 && areas.iter().all(|own| *own > 0.0), "{layer} {areas:?}");
    }
}

#[test]
fn panels_are_groups_of_their_names_over_the_nodes() {
    let mesh = revolution(9, 7);
    for product in [Product::Panels, Product::Paper] {
        let made = build(&mesh, &BuildSettings { product, ..BuildSettings::default() });
        let text = text_of(&made, "panels.obj");
        assert!(text.contains("# its first vertex is node N0"), "{}", &text[..200]);
        let read = shape_up::mesh::read("panels.obj", text.as_bytes()).unwrap().mesh;
        assert_eq!(
            (read.positions.len(), read.faces.len()),
            (mesh.positions.len(), mesh.faces.len())
        );
        for (face, name) in (0..).zip(&made.names) {
            let own = read.groups.iter().find(|group| group.name == *name);
            assert_eq!(own.map(|group| &*group.faces), Some(&[face][..]), "{name}");
        }
        let away = |(p, q): (&[f64; 3], &[f64; 3])| {
            (0..3).map(|k| (p[k] - q[k]).abs()).fold(0.0, f64::max)
        };
        assert!(read.positions.iter().zip(&mesh.positions).all(|pair| away(pair) < 1e-9));
    }
}
