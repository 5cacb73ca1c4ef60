//! Exported files, read back by other readers: their contents match the built parts, in mm.

use super::identities::revolution;
use super::{build, bytes_of, dxf, text_of};
use crate::support::grid::grid;
use shape_up::fabricate::file::{self, svg};
use shape_up::fabricate::sheet::{Inscription, Place, label};
use shape_up::fabricate::{Build, BuildFile, Stand};
use shape_up::math::plane::area;
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, Dxf, Order, Pieces, Product};
use shape_up::words::LengthUnit;

/// A vault in metres; at 1:10 it needs several sheets.
fn vault() -> Mesh {
    revolution(9, 7)
}

pub(super) fn settings() -> BuildSettings {
    BuildSettings { joint: 0.01, scale: 10.0, sheet: [300.0, 200.0], ..BuildSettings::default() }
}

/// Contents of the sheets and tables with this extension.
fn texts(build: &Build, ending: &str) -> Vec<String> {
    let is_asked = |file: &BuildFile| file.name.ends_with(ending) && !file.name.starts_with("key");
    let files = build.files(true).into_iter().filter(is_asked);
    files.map(|file| String::from_utf8(file.bytes).expect("it is text")).collect()
}

fn area_of_parts(build: &Build) -> f64 {
    build.parts.iter().map(|part| area(&part.outline)).sum()
}

fn assert_areas(found: f64, build: &Build) {
    let expected = area_of_parts(build);
    assert!((found - expected).abs() <= 1e-6 * expected, "{found} {expected}");
}

/// Layer and corners of an outline.
type Outline = (String, Vec<[f64; 2]>);

/// Closed polylines of a DXF, and the number of open ones.
fn polylines(text: &str) -> (Vec<Outline>, usize) {
    assert_eq!(dxf::variable(text, "$INSUNITS"), "4", "mm");
    assert_eq!(dxf::variable(text, "$MEASUREMENT"), "1", "metric");
    let (closed, open): (Vec<_>, Vec<_>) =
        dxf::polylines(text).into_iter().partition(|line| line.is_closed);
    (closed.into_iter().map(|line| (line.layer, line.points)).collect(), open.len())
}

#[test]
fn a_dxf_of_either_version_has_one_closed_outline_for_each_panel_in_mm() {
    for version in [Dxf::R2000, Dxf::R12] {
        let made = build(&vault(), &BuildSettings { dxf: version, ..settings() });
        let texts = texts(&made, ".dxf");
        assert!(texts.len() > 1 && texts.len() == made.layout.sheets.len());
        let mut outlines = Vec::new();
        for text in &texts {
            assert!(text.is_ascii() && !text.contains("NaN"), "{version:?}");
            let mut handles = dxf::handles(text);
            let count = handles.len();
            handles.sort();
            handles.dedup();
            assert_eq!(handles.len(), count, "every handle is there once");
            let (closed, open) = polylines(text);
            assert!(open > 0, "names are open lines");
            outlines.extend(closed);
        }
        assert_eq!(outlines.len(), made.names.len());
        assert!(outlines.iter().all(|(layer, _)| layer == "CUT"));
        assert_areas(outlines.iter().map(|(_, points)| area(points)).sum(), &made);
    }
}

#[test]
fn outlines_only_are_on_layer_0_and_nothing_else_is_there() {
    let made = build(&vault(), &BuildSettings { outlines_only: true, ..settings() });
    for text in texts(&made, ".dxf") {
        let (closed, open) = polylines(&text);
        assert_eq!(open, 0);
        assert!(closed.iter().all(|(layer, _)| layer == "0"));
    }
}

#[test]
fn an_svg_is_in_mm_and_names_every_panel_once() {
    let made = build(&vault(), &settings());
    let (mut names, mut sum) = (Vec::new(), 0.0);
    for text in texts(&made, ".svg") {
        let document = roxmltree::Document::parse(&text).expect("it is XML");
        let root = document.root_element();
        assert_eq!(
            ["width", "height", "viewBox"].map(|key| root.attribute(key)),
            [Some("300mm"), Some("200mm"), Some("0 0 300 200")]
        );
        let group = |id: &str| root.children().find(|node| node.attribute("id") == Some(id));
        assert!(group("ENGRAVE").is_some());
        for path in group("CUT").unwrap().children().filter(|node| node.is_element()) {
            names.push(path.attribute("id").unwrap().to_owned());
            let line = path.attribute("d").unwrap();
            assert!(line.starts_with('M') && line.ends_with('Z'));
            let points = line.trim_matches(['M', 'Z']).split('L').map(|pair| {
                let (x, y) = pair.split_once(',').unwrap();
                // The y axis points down.
                [x.parse::<f64>().unwrap(), 200.0 - y.parse::<f64>().unwrap()]
            });
            sum += area(&points.collect::<Vec<_>>());
        }
    }
    names.sort();
    let mut expected = made.names.clone();
    expected.sort();
    assert_eq!(names, expected);
    assert_areas(sum, &made);
}

#[test]
fn a_pdf_has_a_page_for_each_sheet_at_one_to_one() {
    let made = build(&vault(), &settings());
    let bytes = bytes_of(&made, "sheets.pdf");
    let document = lopdf::Document::load_mem(&bytes).expect("it is PDF");
    let pages = document.get_pages();
    assert_eq!(pages.len(), made.layout.sheets.len());
    let (mut sum, mut closed, mut inflated) = (0.0, 0, 0);
    for page in pages.values() {
        inflated += document.get_page_content(*page).len();
        let own = document.get_dictionary(*page).unwrap();
        let media: Vec<f32> = own
            .get(b"MediaBox")
            .and_then(lopdf::Object::as_array)
            .unwrap()
            .iter()
            .map(|number| number.as_float().unwrap())
            .collect();
        assert!((media[2] - 300.0 * 72.0 / 25.4).abs() < 1e-3, "{media:?}");
        let content = document.get_and_decode_page_content(*page).unwrap();
        let mut points: Vec<[f64; 2]> = Vec::new();
        let mut scale = 0.0;
        for operation in &content.operations {
            let number = |k: usize| f64::from(operation.operands[k].as_float().unwrap());
            match &*operation.operator {
                "cm" => scale = number(0),
                "m" => points = vec![[number(0), number(1)]],
                "l" => points.push([number(0), number(1)]),
                "s" => {
                    closed += 1;
                    sum += area(&points) * (scale * 25.4 / 72.0) * (scale * 25.4 / 72.0);
                }
                _ => {}
            }
        }
    }
    assert_eq!(closed, made.names.len());
    assert_areas(sum, &made);
    // It is compressed: the key of 10,000 panels had 15 MB.
    assert!(2 * bytes.len() < inflated, "{} of {inflated}", bytes.len());
}

#[test]
fn tables_have_a_row_for_each_and_areas_that_add_up() {
    let made = build(&vault(), &settings());
    let files = made.files(true);
    assert!(files.iter().all(|file| BuildFile::is_name_of_one(&file.name)));
    let rows = |name: &str| -> Vec<Vec<String>> {
        let text = text_of(&made, name);
        assert!(text.ends_with("\r\n"));
        let lines = text.trim_end().split("\r\n");
        lines.map(|line| line.split(',').map(str::to_owned).collect()).collect()
    };
    let panels = rows("panels.csv");
    assert_eq!(panels.len(), 1 + made.names.len());
    assert!(panels.iter().all(|row| row.len() == panels[0].len()));
    let column = panels[0].iter().position(|name| name == "area_sheet_mm2").unwrap();
    assert_areas(panels[1..].iter().map(|row| row[column].parse::<f64>().unwrap()).sum(), &made);
    // Checks are of the building, as in the summary, whatever the scale.
    let column = panels[0].iter().position(|name| name == "flatness_mm").unwrap();
    let flatness = panels[1..].iter().map(|row| row[column].parse::<f64>().unwrap());
    let summary = rows("summary.csv");
    let worst = summary.iter().find(|row| row[0] == "Panel flatness").unwrap();
    assert_ne!(made.settings.scale, 1.0);
    assert!((flatness.fold(0.0, f64::max) - worst[1].parse::<f64>().unwrap()).abs() < 1e-5);
    assert_eq!(rows("edges.csv").len(), 1 + made.surface.edges.len());
    assert_eq!(rows("nodes.csv").len(), 1 + made.surface.positions.len());
}

#[test]
fn no_text_of_a_scene_is_a_formula_in_a_table() {
    let material = "=HYPERLINK(\"x\")".to_owned();
    let made = build(&vault(), &BuildSettings { material, ..settings() });
    let summary = text_of(&made, "summary.csv");
    assert!(summary.contains(",\"'=HYPERLINK(\"\"x\"\")\","), "{summary}");
    assert_eq!(file::text_field("=1+1"), "'=1+1");
}

#[test]
fn every_name_is_once_on_its_panel_and_every_inner_edge_is_named_from_both_sides() {
    // Panels with room for all names.
    let mesh = grid(4, 3, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * j)]);
    let made = build(&mesh, &BuildSettings { sheet: [900.0, 900.0], scale: 10.0, ..settings() });
    assert_eq!((made.left_out.dropped_names, made.left_out.small_names), (0, 0));
    let inner = made.surface.edges.iter().filter(|edge| !edge.is_rim()).count();
    let mut named = 0;
    for (f, name) in made.names.iter().enumerate() {
        let sides = made.surface.sides.row(f);
        let neighbours: Vec<_> = sides
            .iter()
            .map(|&e| made.surface.edges[e as usize].across(f as u32))
            .map(|across| across.map(|g| made.names[g as usize].clone()))
            .collect();
        let cut = made.cut[f].as_ref().unwrap();
        let outline = &made.parts[cut.part].outline;
        let (arrow, turn) = (Some([0.6, 0.8]), [1.0, 0.0]);
        let (side_names, holes) = (&neighbours[..], &[][..]);
        let own = Inscription {
            outline,
            name,
            neighbours: side_names,
            bevels: &[],
            is_oriented: false,
            arrow,
            turn,
            holes,
        };
        let labels = label(own);
        let mut texts = labels.texts.clone();
        assert_eq!(texts.remove(0), *name);
        let mut expected: Vec<_> = neighbours.into_iter().flatten().collect();
        named += texts.len();
        expected.sort();
        texts.sort();
        assert_eq!(texts, expected);
    }
    assert_eq!(named, 2 * inner);
}

#[test]
fn names_stand_on_their_feet_on_the_sheet_though_parts_do_not() {
    let made = build(&vault(), &settings());
    let places: Vec<_> = made.layout.sheets.iter().flat_map(|sheet| &sheet.places).collect();
    assert_eq!(places.len(), made.parts.len());
    // A name begins with a P, whose first stroke goes up.
    let upwards = |place: &&Place| {
        let stem = &made.parts[place.part].engraved[0];
        let [[x, y], [u, v]] = [stem[0], stem[1]].map(|point| place.to_sheet(point));
        let length = crate::fabricate::length([u - x, v - y]);
        [(u - x) / length, (v - y) / length]
    };
    for place in &places {
        let [x, y] = upwards(place);
        // Rotated to the left at most, so that it reads upwards.
        assert!(x < 0.25 && y > -0.25, "{x} {y}");
    }
    assert!(places.iter().any(|place| place.turn_deg().abs() > 100.0), "some lie on their heads");
}

#[test]
fn engraved_lines_stay_inside_of_their_outline() {
    let made = build(&vault(), &settings());
    for part in &made.parts {
        for point in part.engraved.iter().flatten() {
            assert!(is_inside(&part.outline, *point), "{}", part.name);
        }
    }
}

/// Whether the point is inside a convex, counterclockwise outline.
fn is_inside(outline: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    (0..outline.len()).all(|k| {
        let ([a, b], [c, d]) = (outline[k], outline[(k + 1) % outline.len()]);
        (c - a) * (y - b) - (d - b) * (x - a) > 0.0
    })
}

#[test]
fn parts_lie_on_their_sheet_and_keep_the_gap() {
    for order in [Order::Size, Order::Names] {
        let own = BuildSettings { order, ..settings() };
        let made = build(&vault(), &own);
        assert!(made.layout.too_large.is_empty());
        for sheet in &made.layout.sheets {
            let outlines: Vec<Vec<[f64; 2]>> = sheet
                .places
                .iter()
                .map(|place| {
                    made.parts[place.part].outline.iter().map(|&p| place.to_sheet(p)).collect()
                })
                .collect();
            let (low, high) = (own.margin - 1e-9, own.sheet.map(|size| size - own.margin + 1e-9));
            for [x, y] in outlines.iter().flatten() {
                assert!(*x >= low && *y >= low && *x <= high[0] && *y <= high[1]);
            }
            for (i, a) in outlines.iter().enumerate() {
                for b in &outlines[..i] {
                    assert!(distance(a, b) >= own.gap - 1e-9, "{order:?}");
                }
            }
        }
        if order == Order::Names {
            let all = made.layout.sheets.iter().flat_map(|sheet| &sheet.places);
            let parts: Vec<usize> = all.map(|place| place.part).collect();
            assert!(parts.windows(2).all(|pair| pair[0] < pair[1]), "names stay in order");
        }
    }
}

#[test]
fn trapezoids_lie_alternately_and_cover_most_of_the_sheet() {
    // Much narrower at the top: arranged by bounding boxes they would cover two thirds of a row.
    let cone = grid(24, 2, |i, j| {
        let (turns, radius) = (f64::from(i) / 24.0, 1.0 + 2.0 * f64::from(j));
        let (c, s) = (shape_up::math::cosine(turns), shape_up::math::sine(turns));
        [radius * c, radius * s, -0.5 * radius]
    });
    let own = BuildSettings { scale: 15.0, sheet: [600.0, 320.0], ..settings() };
    let made = build(&cone, &own);
    let area_of = |place: &Place| area(&made.parts[place.part].outline);
    let first: f64 = made.layout.sheets[0].places.iter().map(area_of).sum();
    assert!(made.layout.sheets.len() > 1 && first > 0.75 * 600.0 * 320.0, "{first}");
}

#[test]
fn arcs_lie_in_each_other() {
    // A ring of paper, cut into arc-shaped strips: by bounding boxes each would fill a sheet.
    let ring = grid(24, 1, |i, j| {
        let (turns, radius) = (0.25 * f64::from(i) / 24.0, 10.0 + f64::from(j));
        [radius * shape_up::math::cosine(turns), radius * shape_up::math::sine(turns), 0.0]
    });
    let mut rings = Mesh::default();
    for k in 0..4 {
        let first = rings.positions.len() as u32;
        rings.positions.extend(ring.positions.iter().map(|&[x, y, _]| [x, y, 5.0 * f64::from(k)]));
        for face in ring.faces.iter() {
            rings.faces.push(&face.iter().map(|v| v + first).collect::<Vec<_>>());
        }
    }
    let own = BuildSettings {
        product: Product::Paper,
        pieces: Pieces::Across,
        scale: 50.0,
        ..BuildSettings::default()
    };
    let made = build(&rings, &own);
    assert_eq!((made.parts.len(), made.layout.sheets.len()), (4, 1));
    let outlines: Vec<Vec<[f64; 2]>> = made.layout.sheets[0]
        .places
        .iter()
        .map(|place| made.parts[place.part].outline.iter().map(|&p| place.to_sheet(p)).collect())
        .collect();
    for (i, a) in outlines.iter().enumerate() {
        for b in &outlines[..i] {
            assert!(!cross(a, b) && between_sides(a, b) >= own.gap - 1e-9);
        }
    }
}

/// Whether any sides of the two polygons cross.
fn cross(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    let sides = |polygon: &[[f64; 2]]| -> Vec<[[f64; 2]; 2]> {
        (0..polygon.len()).map(|k| [polygon[k], polygon[(k + 1) % polygon.len()]]).collect()
    };
    let turn = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    let others = sides(b);
    sides(a).iter().any(|&[p, q]| {
        others.iter().any(|&[r, s]| {
            turn(p, q, r) * turn(p, q, s) < 0.0 && turn(r, s, p) * turn(r, s, q) < 0.0
        })
    })
}

/// Distance between two convex polygons; negative if they overlap.
fn distance(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let inside = a.iter().any(|&p| is_inside(b, p)) || b.iter().any(|&p| is_inside(a, p));
    if inside { -1.0 } else { between_sides(a, b) }
}

/// Least distance of a corner of `a` or `b` to a side of the other polygon.
fn between_sides(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let corner_to_side = |p: [f64; 2], a: [f64; 2], b: [f64; 2]| {
        let (s, t) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
        let share = ((s[0] * t[0] + s[1] * t[1]) / (s[0] * s[0] + s[1] * s[1])).clamp(0.0, 1.0);
        let off = [t[0] - share * s[0], t[1] - share * s[1]];
        (off[0] * off[0] + off[1] * off[1]).sqrt()
    };
    let between = |a: &[[f64; 2]], b: &[[f64; 2]]| {
        let sides = (0..b.len()).map(|k| (b[k], b[(k + 1) % b.len()]));
        let all =
            sides.flat_map(|(p, q)| a.iter().map(move |&corner| corner_to_side(corner, p, q)));
        all.fold(f64::INFINITY, f64::min)
    };
    between(a, b).min(between(b, a))
}

#[test]
fn holes_lie_opposite_each_other_and_nothing_is_written_over_them() {
    let mesh = grid(4, 3, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * j)]);
    let own = BuildSettings { hole: 4.0, sheet: [900.0, 900.0], scale: 10.0, ..settings() };
    let made = build(&mesh, &own);
    let inner = made.surface.edges.iter().filter(|edge| !edge.is_rim()).count();
    let report = made.report();
    assert_eq!((report.holes, report.left_out.dropped_holes), (4 * inner, 0));
    for part in &made.parts {
        for hole in &part.holes {
            let outline = hole.outline();
            assert!(outline.iter().all(|&corner| is_inside(&part.outline, corner)));
            let away = |[x, y]: [f64; 2]| {
                crate::fabricate::length([x - hole.centre[0], y - hole.centre[1]])
            };
            assert!(part.engraved.iter().flatten().all(|&point| away(point) > hole.radius));
        }
    }
    // Holes across an edge match: the joint is between them, and each is 1.5 diameters from its
    // side.
    for (edge, e) in made.surface.edges.iter().zip(0..) {
        let [Some(f), Some(g)] = edge.panels else { continue };
        let along = |f: u32| -> Vec<f64> {
            let cut = made.cut[f as usize].as_ref().unwrap();
            let k = made.surface.sides.row(f as usize).iter().position(|&s| s == e).unwrap();
            let (p, q) = (cut.whole[k], cut.whole[(k + 1) % cut.whole.len()]);
            let length = crate::fabricate::length([q[0] - p[0], q[1] - p[1]]);
            let t = [(q[0] - p[0]) / length, (q[1] - p[1]) / length];
            let local = made.parts[cut.part].holes.iter().map(|hole| {
                let [x, y] = [hole.centre[0] - p[0], hole.centre[1] - p[1]];
                [x * t[0] + y * t[1], x * -t[1] + y * t[0]]
            });
            let beside = local.filter(|[_, y]| (y - (0.5 + 6.0)).abs() < 1e-9);
            // As fractions: non-planar panels are slightly longer or shorter on the sheet.
            let mut found: Vec<f64> = beside.map(|[x, _]| x / length).collect();
            found.sort_by(f64::total_cmp);
            found
        };
        let [a, b] = [along(f), along(g)];
        assert_eq!((a.len(), b.len()), (2, 2));
        assert!((a[0] - (1.0 - b[1])).abs() < 1e-9 && (a[1] - (1.0 - b[0])).abs() < 1e-9);
    }
    let [text] = &texts(&made, ".dxf")[..] else { panic!("one sheet") };
    let (closed, _) = polylines(text);
    assert_eq!(closed.iter().filter(|(layer, _)| layer == "HOLE").count(), 4 * inner);
    // Panels that are too small have no holes, and the number of missing holes is reported.
    let small = build(&mesh, &BuildSettings { scale: 100.0, ..own }).report();
    assert_eq!((small.holes, small.left_out.dropped_holes), (0, 4 * inner));
}

#[test]
fn a_panel_that_is_larger_than_the_sheet_is_named_and_not_scaled() {
    let mesh =
        grid(2, 1, |i, j| [f64::from(i) * if i == 2 { 3.0 } else { 1.0 }, f64::from(j), 0.0]);
    let own = BuildSettings {
        scale: 10.0,
        sheet: [200.0, 120.0],
        joint: 0.0,
        ..BuildSettings::default()
    };
    let report = build(&mesh, &own).report();
    assert_eq!(report.too_large, ["P1"]);
    assert_eq!((report.placed, report.panels), (1, 2));
    assert!((report.cut_area_mm2 - 1e4).abs() < 1e-6);
    // Nothing of it is left out on the sheet that is said to be needed.
    let sheet = report.larger_sheet_mm.expect("it is too large");
    assert_eq!(sheet, [510.0, 110.0]);
    let report = build(&mesh, &BuildSettings { sheet, ..own.clone() }).report();
    assert_eq!((report.placed, report.larger_sheet_mm), (2, None));
    // No sheet may be that large.
    let report = build(&mesh, &BuildSettings { scale: 0.01, ..own }).report();
    assert_eq!((report.too_large.len(), report.larger_sheet_mm), (2, None));
}

#[test]
fn a_part_on_no_sheet_is_neither_named_nor_drilled() {
    // A panel of 100 mm between two of a metre.
    let x = [0.0, 1.0, 1.1, 2.1];
    let mesh = grid(3, 1, |i, j| [x[i as usize], 0.1 * f64::from(j), 0.0]);
    let own = BuildSettings { scale: 1.0, sheet: [200.0, 120.0], hole: 6.0, ..settings() };
    let made = build(&mesh, &BuildSettings { joint: 0.0, ..own });
    let report = made.report();
    assert_eq!((report.too_large, report.holes), (vec!["P0".to_owned(), "P2".to_owned()], 4));
    assert_eq!((report.left_out.dropped_names, report.left_out.small_names), (0, 0));
    let table =
        texts(&made, ".csv").into_iter().find(|text| text.starts_with("name,type")).unwrap();
    let at = table.lines().next().unwrap().split(',').position(|name| name == "name_written");
    let written: Vec<&str> =
        table.lines().skip(1).map(|row| row.split(',').nth(at.unwrap()).unwrap()).collect();
    assert_eq!(written, ["nowhere", "on it", "nowhere"]);
}

#[test]
fn the_unit_of_the_mesh_and_the_scale_decide_the_size_on_the_sheet() {
    let mesh = grid(1, 1, |i, j| [1000.0 * f64::from(i), 1000.0 * f64::from(j), 0.0]);
    let unit = LengthUnit::of("mm").unwrap();
    let own = BuildSettings { scale: 10.0, ..BuildSettings::default() };
    let made = Build::new(&mesh, &own, unit, &Stand::default()).unwrap();
    assert!((area(&made.parts[0].outline) - 1e4).abs() < 1e-6);
    let drawings = made.drawings();
    assert!(drawings[0].title.contains("SCALE 1:10") && drawings[0].title.contains("MODEL IN MM"));
    assert!(svg(&drawings[0]).contains(&drawings[0].title));
}
