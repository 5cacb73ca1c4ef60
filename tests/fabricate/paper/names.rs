//! Names on the pieces of a paper model: on their panels, on their tabs, or beside pieces without
//! room; names that fit nowhere are reported.

use super::{cases, model, scale, settings};
use crate::fabricate::identities::revolution;
use crate::fabricate::{build, text_of};
use crate::support::grid::grid;
use shape_up::fabricate::paper::write_names;
use shape_up::fabricate::sheet::Place;
use shape_up::math::plane::Point2;
use shape_up::scene::{BuildSettings, Pieces};

fn contains(outline: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let crosses = |&k: &usize| {
        let (p, q) = (outline[k], outline[(k + 1) % outline.len()]);
        (p[1] > y) != (q[1] > y) && x < p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
    };
    (0..outline.len()).filter(crosses).count() % 2 == 1
}

/// Distance of a point from a segment.
fn to_segment([x, y]: Point2, [a, b]: Point2, [c, d]: Point2) -> f64 {
    let (u, v) = (c - a, d - b);
    let along = (((x - a) * u + (y - b) * v) / (u * u + v * v)).clamp(0.0, 1.0);
    crate::fabricate::length([x - a - along * u, y - b - along * v])
}

#[test]
fn a_piece_says_which_it_is_on_a_panel_that_has_room_for_that() {
    // The panels at the ends are narrow.
    let x = [0.0, 0.02, 1.0, 2.0, 3.0, 3.02];
    let mesh = grid(5, 1, |i, j| [x[i as usize], f64::from(j), 0.05 * x[i as usize].powi(2)]);
    let made = build(&mesh, &settings(Pieces::Nets));
    assert_eq!(made.parts.len(), 1);
    let engraved = |name: &str| {
        let mut part = made.parts[0].clone();
        (part.name, part.engraved) = (name.to_owned(), Vec::new());
        write_names(&mut part, (model(&made), 0), &made.names, false, [1.0, 0.0]);
        part.engraved
    };
    assert_ne!(engraved("S1"), engraved("S777"));
}

#[test]
fn names_lie_on_their_panels_and_their_tabs() {
    for print_inside in [false, true] {
        let made =
            build(&revolution(6, 4), &BuildSettings { print_inside, ..settings(Pieces::Nets) });
        assert_eq!((made.left_out.dropped_names, made.left_out.small_names), (0, 0));
        for part in &made.parts {
            for &point in part.engraved.iter().flatten() {
                assert!(contains(&part.outline, point), "{}", part.name);
            }
        }
    }
}

#[test]
fn pieces_with_panels_too_small_for_their_names_are_counted_and_not_their_panels() {
    let own = BuildSettings { scale: 80.0, ..settings(Pieces::Nets) };
    let made = build(&revolution(9, 7), &own);
    assert!(
        made.left_out.small_names > 0 && made.left_out.small_names <= made.parts.len(),
        "{}",
        made.left_out.small_names
    );
}

#[test]
fn no_letter_is_cut_through() {
    for (name, mesh, pieces) in cases() {
        for print_inside in [false, true] {
            let own = BuildSettings { scale: scale(&mesh), print_inside, ..settings(pieces) };
            let made = build(&mesh, &own);
            for part in &made.parts {
                let n = part.outline.len();
                for &point in part.engraved.iter().flatten() {
                    let nearest = (0..n)
                        .map(|k| to_segment(point, part.outline[k], part.outline[(k + 1) % n]))
                        .fold(f64::INFINITY, f64::min);
                    assert!(nearest > 0.3, "{name}, {}: {nearest} mm", part.name);
                }
            }
        }
    }
}

#[test]
fn a_piece_without_room_for_its_name_has_it_beside_itself_and_on_no_other() {
    // Edges of 7 mm.
    let mesh = revolution(24, 7);
    let scale = scale(&mesh) * 30.0 / 7.0;
    let made = build(&mesh, &BuildSettings { scale, ..settings(Pieces::Strips) });
    let (low, high) = (made.settings.margin, made.settings.sheet.map(|x| x - made.settings.margin));
    let mut beside = 0;
    for sheet in &made.layout.sheets {
        let on_sheet = |points: &[[f64; 2]], place: &Place| -> Vec<[f64; 2]> {
            points.iter().map(|&point| place.to_sheet(point)).collect()
        };
        let outlines: Vec<_> = (sheet.places.iter())
            .map(|place| on_sheet(&made.parts[place.part].outline, place))
            .collect();
        for (k, place) in sheet.places.iter().enumerate() {
            let lines = made.parts[place.part].engraved.iter();
            let outside: Vec<_> = lines
                .flat_map(|line| on_sheet(line, place))
                .filter(|&point| !contains(&outlines[k], point))
                .collect();
            let mut part = made.parts[place.part].clone();
            let unnamed =
                write_names(&mut part, (model(&made), place.part), &made.names, false, place.turn);
            assert!(unnamed.piece || outside.is_empty(), "{} is named twice", part.name);
            beside += usize::from(!outside.is_empty());
            for point in outside {
                assert!((0..2).all(|x| point[x] >= low && point[x] <= high[x]), "{point:?}");
                assert!(!outlines.iter().any(|other| contains(other, point)), "{point:?}");
            }
        }
    }
    assert!(beside > 0, "nothing is written there");
}

#[test]
fn a_piece_without_room_for_its_name_anywhere_is_told_by_that_name() {
    // Edges of 7 mm, on sheets without room for a name between the pieces.
    let mesh = revolution(24, 7);
    let scale = scale(&mesh) * 30.0 / 7.0;
    let own = BuildSettings {
        scale,
        sheet: [50.0, 50.0],
        gap: 0.5,
        margin: 1.0,
        ..settings(Pieces::Strips)
    };
    let made = build(&mesh, &own);
    let report = made.report();
    assert!(!report.unnamed.is_empty() && report.unnamed.len() < report.parts, "{report:?}");
    let rows = |name: &str, cell: &str| -> Vec<String> {
        let text = text_of(&made, name);
        let lines = text.lines().filter(|line| line.contains(cell));
        lines.map(|line| line.split(',').next().unwrap().to_owned()).collect()
    };
    let mut told = report.unnamed.clone();
    told.sort();
    let mut nowhere = rows("pieces.csv", ",nowhere,");
    nowhere.sort();
    assert_eq!(told, nowhere);
    // A piece whose name is beside it has more lines than the names of its panels.
    for (k, part) in made.parts.iter().enumerate() {
        let mut bare = part.clone();
        bare.engraved.clear();
        let turn =
            made.layout.places(made.parts.len())[k].map_or([1.0, 0.0], |(_, place)| place.turn);
        let missing = write_names(&mut bare, (model(&made), k), &made.names, false, turn);
        let is_beside = part.engraved.len() > bare.engraved.len();
        assert_eq!(told.contains(&part.name), missing.piece && !is_beside, "{}", part.name);
    }
    let plain = build(&mesh, &BuildSettings { outlines_only: true, ..made.settings.clone() });
    assert!(plain.report().unnamed.is_empty(), "no names are asked for");
}
