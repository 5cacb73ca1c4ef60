//! Parts on sheets: which of them fit, and the holes cut out of them.

use super::files::settings;
use super::{build, dxf};
use crate::support::grid::grid;
use shape_up::fabricate::BuildFile;
use shape_up::math::plane::area;
use shape_up::mesh::{Mesh, Ragged};
use shape_up::scene::{BuildSettings, Names, Order, Product};

#[test]
fn a_part_that_fits_only_along_another_side_than_that_of_its_smallest_box_is_laid() {
    // The box along the base is 100 by 40 mm, the one along a leg 78 by 63 mm.
    let positions = vec![[0.0; 3], [10.0, 0.0, 0.0], [5.0, 4.0, 0.0]];
    let mut mesh = Mesh { positions, ..Mesh::default() };
    mesh.faces.push(&[0, 1, 2]);
    for sheet in [[80.0, 65.0], [65.0, 80.0]] {
        let own = BuildSettings {
            scale: 100.0,
            sheet,
            joint: 0.0,
            margin: 0.0,
            ..BuildSettings::default()
        };
        let made = build(&mesh, &own);
        assert!(made.layout.too_large.is_empty());
        let place = &made.layout.sheets[0].places[0];
        let on_sheet = made.parts[0].outline.iter().map(|&point| place.to_sheet(point));
        assert!(on_sheet.flatten().all(|x| x >= -1e-9));
        let on_sheet = made.parts[0].outline.iter().map(|&point| place.to_sheet(point));
        assert!(on_sheet.into_iter().all(|[x, y]| x <= sheet[0] && y <= sheet[1]));
    }
}

#[test]
fn parts_as_large_as_the_sheet_are_laid_despite_rounding() {
    let mut mesh = Mesh::default();
    for k in 0..20 {
        let [c, s] = [f64::from(k) / 7.0, 0.1].map(shape_up::math::cosine);
        let first = mesh.positions.len() as u32;
        let corners = [[0.0, 0.0], [1.22, 0.0], [1.22, 0.61], [0.0, 0.61]];
        let length = crate::fabricate::length([c, s]);
        let turned = corners.map(|[x, y]| [(c * x - s * y) / length, (s * x + c * y) / length]);
        mesh.positions.extend(turned.map(|[x, y]| [x + 3.0 * f64::from(k), y, 0.0]));
        mesh.faces.push(&[first, first + 1, first + 2, first + 3]);
    }
    let own = BuildSettings {
        scale: 1.0,
        sheet: [1220.0, 610.0],
        joint: 0.0,
        margin: 0.0,
        ..BuildSettings::default()
    };
    let report = build(&mesh, &own).report();
    assert_eq!((report.placed, report.too_large), (20, Vec::new()));
}

#[test]
fn holes_are_narrower_by_the_kerf_and_are_cuts_too() {
    let mesh = grid(2, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let plain = BuildSettings { kerf: 0.5, ..settings() };
    let own = BuildSettings { hole: 4.0, ..plain.clone() };
    let made = build(&mesh, &own);
    let radii: Vec<f64> =
        made.parts.iter().flat_map(|part| part.holes.iter().map(|hole| hole.radius)).collect();
    assert_eq!(radii, [1.75; 4]);
    let around = 4.0 * 1.75 * std::f64::consts::TAU;
    let without = build(&mesh, &plain).report().cut_length_mm;
    assert!((made.report().cut_length_mm - without - around).abs() < 1e-9);
    // Holes narrower than the kerf cannot be cut.
    let narrow = build(&mesh, &BuildSettings { hole: 0.5, ..plain });
    let report = narrow.report();
    assert_eq!((report.holes, report.dropped_holes), (0, 4));
    let words = narrow.words(&report).warnings;
    assert!(
        words.contains(&"4 holes are left out: no wider than the kerf.".to_owned()),
        "{words:?}"
    );
}

#[test]
fn parts_in_the_order_of_names_are_in_rows_and_columns_where_names_are() {
    // Its first face is in the middle, and it has more than 26 rows.
    let mut mesh = grid(28, 27, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let mut faces: Vec<Vec<u32>> = mesh.faces.iter().map(<[u32]>::to_vec).collect();
    faces.rotate_left(40);
    mesh.faces = Ragged::new();
    faces.iter().for_each(|face| mesh.faces.push(face));
    let own = BuildSettings {
        order: Order::Names,
        names: Names::Rows,
        outlines_only: true,
        ..settings()
    };
    let made = build(&mesh, &own);
    let places = made.layout.sheets.iter().flat_map(|sheet| &sheet.places);
    let found: Vec<(usize, &str)> = places
        .map(|place| &*made.parts[place.part].name)
        .map(|name| (name.find('-').unwrap(), name))
        .collect();
    assert!(found.len() == 756 && found.is_sorted(), "{found:?}");
}

#[test]
fn a_part_that_fits_only_on_the_diagonal_of_the_sheet_is_laid_there() {
    // 460 by 20 mm on a sheet of 420 by 297 mm.
    let positions = vec![[0.0; 3], [0.46, 0.0, 0.0], [0.46, 0.02, 0.0], [0.0, 0.02, 0.0]];
    let mut mesh = Mesh { positions, ..Mesh::default() };
    mesh.faces.push(&[0, 1, 2, 3]);
    let own = BuildSettings { scale: 1.0, ..BuildSettings::default() };
    let made = build(&mesh, &own);
    assert!(made.layout.too_large.is_empty());
    let place = &made.layout.sheets[0].places[0];
    for [x, y] in made.parts[0].outline.iter().map(|&point| place.to_sheet(point)) {
        assert!(x >= 5.0 - 1e-6 && y >= 5.0 - 1e-6 && x <= 415.0 + 1e-6 && y <= 292.0 + 1e-6);
    }
}

#[test]
fn a_panel_with_an_edge_shorter_than_the_joint_is_cut_without_it() {
    // The corner between two others of a plate is cut off by a millimetre.
    let positions = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.999], [0.999, 1.0], [0.0, 1.0], [2.0, 0.0]];
    let positions = positions.map(|[x, y]| [x, y, 0.0]).to_vec();
    let mut mesh = Mesh { positions, ..Mesh::default() };
    [&[0, 1, 2, 3, 4][..], &[1, 5, 2]].iter().for_each(|face| mesh.faces.push(face));
    let own =
        BuildSettings { scale: 1.0, joint: 0.01, sheet: [1500.0; 2], ..BuildSettings::default() };
    let made = build(&mesh, &own);
    assert_eq!(made.not_cut, []);
    let outline = &made.parts[0].outline;
    assert_eq!(outline.len(), 4);
    let found = area(outline);
    assert!((found - 990.0 * 990.0).abs() < 1e-6, "{found}");
    // The name of the neighbour is written, and holes are opposite each other.
    assert_eq!(made.dropped_names, 0);
    let with_holes = build(&mesh, &BuildSettings { hole: 8.0, ..own });
    assert!(with_holes.parts.iter().all(|part| part.holes.len() == 2));
}

#[test]
fn each_part_is_a_drawing_of_its_own_too_if_asked_and_nothing_else_changes() {
    let mesh = grid(3, 2, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * j)]);
    for product in [Product::Panels, Product::Fins, Product::Paper] {
        // A sheet too small for all but a few.
        let plain = BuildSettings { product, sheet: [110.0, 80.0], ..settings() };
        let made = build(&mesh, &BuildSettings { one_file_each: true, ..plain.clone() });
        let (single, others): (Vec<BuildFile>, Vec<BuildFile>) =
            made.files(true).into_iter().partition(|file| file.name.starts_with("parts/"));
        let before = build(&mesh, &plain).files(true);
        let is_same = |(a, b): (&BuildFile, &BuildFile)| a == b || a.name == "summary.csv";
        assert!(others.len() == before.len() && others.iter().zip(&before).all(is_same));
        assert_eq!(single.len(), 2 * made.parts.len());
        for part in &made.parts {
            let text = |kind: &str| {
                let name = format!("parts/{}.{kind}", part.name);
                &single.iter().find(|file| file.name == name).expect("it is there").text
            };
            let lines = dxf::polylines(text("dxf"));
            assert!(lines.iter().all(|line| line.layer != "SHEET"));
            let outline: Vec<_> = lines.iter().filter(|line| line.layer == "CUT").collect();
            let [outline] = outline[..] else { panic!("one outline") };
            let low = [0, 1]
                .map(|k| outline.points.iter().map(|point| point[k]).fold(f64::INFINITY, f64::min));
            assert!(low.iter().all(|x| x.abs() < 1e-6), "{low:?}");
            let [own, found] = [&part.outline, &outline.points].map(|points| area(points));
            assert!((own - found).abs() < 1e-4 * own, "{own} {found}");
            assert!(text("svg").contains(&format!("<path id=\"{}\"", part.name)));
        }
    }
}
