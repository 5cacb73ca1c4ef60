//! Parts on sheets: which of them fit or are cut into pieces, the holes cut out of them, and lines that
//! they share.

use super::files::settings;
use super::{build, dxf, text_of};
use crate::support::grid::grid;
use shape_up::fabricate::SettingValue;
use shape_up::fabricate::{Build, BuildFile, Splice};
use shape_up::math::cosine_and_sine_of_degrees;
use shape_up::math::plane::{Point2, area, bounds, distance, minus};
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
    assert_eq!((report.holes, report.left_out.dropped_holes), (0, 4));
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
    assert_eq!(made.left_out.dropped_names, 0);
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
                let file = single.iter().find(|file| file.name == name).expect("it is there");
                std::str::from_utf8(&file.bytes).expect("it is text")
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

/// The lengths of all lines of the sheets as DXF, SVG and PDF, in mm.
fn lengths_of_cuts(made: &Build) -> [f64; 3] {
    let length = |points: &[[f64; 2]], is_closed: bool| {
        let more = if is_closed { points.first() } else { None };
        let all: Vec<_> = points.iter().chain(more).collect();
        all.windows(2).map(|ends| distance(*ends[0], *ends[1])).sum::<f64>()
    };
    let mut found = [0.0; 3];
    for BuildFile { name, bytes } in made.files(true) {
        let text = || std::str::from_utf8(&bytes).expect("it is text");
        if name.ends_with(".dxf") {
            let lines = dxf::polylines(text());
            found[0] += lines.iter().map(|line| length(&line.points, line.is_closed)).sum::<f64>();
        } else if name.starts_with("sheet-") {
            let paths = text().split(" d=\"").skip(1).map(|rest| rest.split('"').next().unwrap());
            for line in paths.flat_map(|path| path.split('M').skip(1)) {
                let point = |pair: &str| {
                    let (x, y) = pair.split_once(',').unwrap();
                    [x, y].map(|x| x.parse::<f64>().unwrap())
                };
                let points: Vec<_> = line.trim_end_matches('Z').split('L').map(point).collect();
                found[1] += length(&points, line.ends_with('Z'));
            }
        } else if name == "sheets.pdf" {
            let document = lopdf::Document::load_mem(&bytes).expect("it is PDF");
            let mut points: Vec<[f64; 2]> = Vec::new();
            for page in document.get_pages().values() {
                let content = document.get_and_decode_page_content(*page).unwrap();
                for operation in &content.operations {
                    let at = |k: usize| f64::from(operation.operands[k].as_float().unwrap());
                    match &*operation.operator {
                        "m" => points = vec![[at(0), at(1)]],
                        "l" => points.push([at(0), at(1)]),
                        end @ ("s" | "S") => found[2] += length(&points, end == "s"),
                        _ => {}
                    }
                }
            }
        }
    }
    found
}

#[test]
fn parts_without_a_gap_are_cut_once_along_the_lines_that_they_share() {
    // Two columns and three rows of squares fill the sheet.
    let mesh = grid(2, 3, |i, j| [f64::from(i), f64::from(j), 0.0]);
    for (kerf, gap, lines) in [(0.0, 0.0, 17.0), (0.2, 0.0, 17.0), (0.0, 1.0, 24.0)] {
        let made = build(
            &mesh,
            &BuildSettings {
                scale: 25.0,
                sheet: [92.0, 133.0],
                joint: 0.0,
                outlines_only: true,
                kerf,
                gap,
                ..BuildSettings::default()
            },
        );
        let expected = lines * (40.0 + kerf);
        for found in lengths_of_cuts(&made) {
            assert!((found - expected).abs() < 0.1, "{kerf} {gap}: {found} {expected}");
        }
        let report = made.report();
        assert_eq!(report.sheets, 1);
        assert!((report.cut_length_mm - expected).abs() < 0.1, "{}", report.cut_length_mm);
    }
}

#[test]
fn a_panel_in_pieces_fits_the_sheet_and_its_plates_are_drilled_with_it() {
    let mesh =
        grid(2, 1, |i, j| [f64::from(i) * if i == 2 { 3.0 } else { 1.0 }, f64::from(j), 0.0]);
    let own = BuildSettings {
        scale: 10.0,
        sheet: [200.0, 120.0],
        thickness: 1.5,
        hole: 4.0,
        kerf: 0.3,
        ..BuildSettings::default()
    };
    let whole = build(&mesh, &own);
    let advice = whole.words(&whole.report()).advice;
    let advised =
        advice.iter().flat_map(|advice| &advice.choices).find(|own| own.setting == "splice");
    let SettingValue::Number(splice) = advised.expect("it helps").value else { panic!() };
    let made = build(&mesh, &BuildSettings { splice, ..own });
    let report = made.report();
    assert_eq!((report.too_large.len(), report.spliced, report.plates), (0, 1, 2));
    assert_eq!((report.parts, report.placed, report.left_out.dropped_holes), (6, 6, 0));
    let words = made.words(&report);
    assert!(words.sheets.starts_with("6 parts on ") && words.sheets.ends_with("1 panel in pieces"));
    assert_eq!(words.advice, []);
    let names: Vec<&str> = made.parts.iter().map(|part| &*part.name).collect();
    assert_eq!(names, ["P0", "P1.1", "P1.2", "P1.3", "P1.1-2", "P1.2-3"]);
    for Splice { part, pieces, .. } in &made.splices {
        let plate = &made.parts[*part];
        assert_eq!(plate.holes.len(), 4);
        let on = |piece: &usize| {
            plate.holes.iter().filter(|hole| made.parts[*piece].holes.contains(hole)).count()
        };
        assert_eq!(pieces.each_ref().map(on), [2, 2]);
    }
    // The areas in the tables add up.
    let column = |name: &str, column: &str| {
        let text = text_of(&made, name);
        let mut lines = text.lines();
        let at = lines.next().unwrap().split(',').position(|name| name == column);
        let cell = |line: &str| line.split(',').nth(at.unwrap()).unwrap().parse::<f64>().unwrap();
        lines.map(cell).collect::<Vec<f64>>()
    };
    let [panels, plates] = ["panels.csv", "splices.csv"].map(|name| column(name, "area_sheet_mm2"));
    assert_eq!((panels.len(), plates.len()), (4, 2));
    let sum: f64 = panels.iter().chain(&plates).sum();
    assert!((sum - report.cut_area_mm2).abs() < 1e-3, "{sum}");
    assert!(text_of(&made, "summary.csv").contains("splice plates,2,"));
    // And plates are where the table says.
    let place = |part: usize| {
        let mut places = made.layout.sheets.iter().flat_map(|sheet| &sheet.places);
        places.find(|place| place.part == part).expect("it is on a sheet")
    };
    let [x, y, turn] =
        ["x_sheet_mm", "y_sheet_mm", "turn_deg"].map(|name| column("splices.csv", name));
    for (k, Splice { part, pieces, seam, .. }) in made.splices.iter().enumerate() {
        let put = |point: Point2| place(*part).to_sheet(point);
        let [low, _] = bounds(made.parts[*part].outline.iter().map(|&point| put(point)));
        assert!((low[0] - x[k]).abs() < 1e-3 && (low[1] - y[k]).abs() < 1e-3, "{low:?}");
        let [c, s] = cosine_and_sine_of_degrees(turn[k]);
        let aside = |point: Point2| {
            let step = minus(put(point), put(seam[0]));
            c * step[1] - s * step[0]
        };
        assert!(aside(seam[1]).abs() < 1e-3);
        let [one, other] = pieces.map(|piece| made.parts[piece].outline.iter().map(|&p| aside(p)));
        assert!(one.fold(0.0, f64::max) > 1.0 && other.fold(0.0, f64::min) < -1.0);
    }
}
