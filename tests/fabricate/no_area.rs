//! Panels without area, of which nothing is made, and what lies beside them.

use super::bad_input::faces;
use super::identities::revolution;
use super::{build, text_of};
use crate::support::grid::grid;
use shape_up::fabricate::Build;
use shape_up::math::plane::area;
use shape_up::mesh::{Mesh, Ragged};
use shape_up::scene::{BuildSettings, Fold, OffsetKind, Product};

/// The mesh with a panel without area: a triangle along an edge, whose third corner divides the
/// edge.
fn with_a_panel_without_area(mesh: Mesh, [a, b]: [u32; 2], share: f64) -> Mesh {
    let c = mesh.positions.len() as u32;
    let [from, to] = [a, b].map(|v| mesh.positions[v as usize]);
    let between = std::array::from_fn(|k| from[k] + share * (to[k] - from[k]));
    let mut all = Mesh { faces: Ragged::new(), ..mesh.clone() };
    all.positions.push(between);
    for face in mesh.faces.iter() {
        let mut own = face.to_vec();
        if let Some(k) = (0..4).find(|&k| (face[k], face[(k + 1) % 4]) == (a, b)) {
            own.insert(k + 1, c);
        }
        all.faces.push(&own);
    }
    all.faces.push(&[a, b, c]);
    all
}

#[test]
fn a_panel_without_area_leaves_the_offset_of_the_others_exact() {
    for share in [0.2, 0.3, 0.4, 0.5, 0.6, 0.7] {
        let own = BuildSettings { kind: Some(OffsetKind::Face), ..BuildSettings::default() };
        let mesh = with_a_panel_without_area(revolution(9, 7), [32, 33], share);
        let report = build(&mesh, &own).report();
        assert_eq!(report.card.problems, Vec::<String>::new(), "{share}");
        assert_eq!(report.not_cut, ["P63: it has no area"]);
        assert!(report.card.offset.unwrap().exact, "{share}");
    }
}

#[test]
fn no_panel_is_told_to_meet_one_that_is_not_there() {
    let plain = revolution(9, 7);
    let own = BuildSettings { kind: Some(OffsetKind::Face), ..BuildSettings::default() };
    let (a, b) = (32, 33);
    let made = build(&with_a_panel_without_area(plain.clone(), [a, b], 0.4), &own);
    let expected = build(&plain, &own);
    let edge = |made: &Build, ends: [u32; 2]| {
        made.surface.edges.iter().position(|edge| edge.ends == ends).unwrap() as u32
    };
    let [left, right] = expected.surface.edges[edge(&expected, [a, b]) as usize].panels;
    let (left, right) = (left.unwrap(), right.unwrap());
    let c = plain.positions.len() as u32;
    assert_eq!(made.surface.neighbours_across(edge(&made, [a, b]), right), [left]);
    for ends in [[a, c], [b, c]] {
        assert_eq!(made.surface.neighbours_across(edge(&made, ends), left), [right]);
    }
    // What is written on the panel is the same.
    let right = right as usize;
    assert_eq!(made.parts[right].engraved, expected.parts[right].engraved);
}

#[test]
fn panels_beside_one_without_area_meet_each_other_in_folds_joints_holes_paper_and_tables() {
    // A roof of 90 degrees with triangles on its ridge, which has one corner on one of its sides and
    // three on the other.
    let ridge = [0.0, 8.0, 2.0, 5.0].map(|y| [0.0, y, 4.0]);
    let eaves = [[-4.0, 0.0, 0.0], [-4.0, 8.0, 0.0], [4.0, 0.0, 0.0], [4.0, 8.0, 0.0]];
    let positions = [ridge, eaves].concat();
    let (west, east) = ([4, 0, 1, 5], [6, 7, 1, 3, 2, 0]);
    let mesh = faces(&[&west, &east, &[0, 2, 1], &[2, 3, 1]], &positions);
    let own = BuildSettings { hole: 3.0, thickness: 3.0, ..BuildSettings::default() };
    let made = build(&mesh, &own);
    let report = made.report();
    // 2 T tan 45 degrees.
    let fold = report.fold_deg.expect("a ridge");
    assert!(fold.iter().all(|fold| (fold - 90.0).abs() < 1e-9), "{fold:?}");
    assert_eq!(report.least_joint_mm[0], None);
    assert!((report.least_joint_mm[1].expect("inside") - 6.0).abs() < 1e-9, "{report:?}");
    // Two on the side of the west, and two on each of the three sides of the east.
    assert_eq!(
        (report.holes, report.left_out.dropped_holes, report.left_out.unpaired_holes),
        (0, 0, 8)
    );
    let edges = text_of(&made, "edges.csv");
    let of_ridge = ["B0-1", "B0-2", "B2-3", "B1-3", "B1-2"];
    for line in of_ridge.map(|name| edges.lines().find(|line| line.starts_with(name)).unwrap()) {
        assert!(line.contains("P0") && line.contains("P1") && line.contains(",90,"), "{line}");
    }
    let paper = build(&mesh, &BuildSettings { product: Product::Paper, ..own.clone() });
    assert_eq!(paper.report().paper.unwrap().without_tab, ["P0/P1"]);
    assert_eq!(paper.paper.unwrap().unpaired.len(), 4);
    // Card ends before the ridge, T tan 45 degrees, and is not joined there.
    let card = BuildSettings { product: Product::Paper, fold: Fold::Score, ..own };
    let card = build(&mesh, &card);
    let [long, high] = [8.0, 32.0_f64.sqrt()].map(|x| x * card.mm_of_sheet());
    for part in &card.parts {
        assert!((area(&part.outline) - long * (high - 3.0)).abs() < 1e-6, "{:?}", part.outline);
    }
    let report = card.report();
    let warnings = card.words(&report).warnings;
    let told = "Not joined along their edges: P0/P1.".to_owned();
    assert!(warnings.contains(&told), "{warnings:?}");
    // A panel that is twisted has no area either, and no others lie along its edges.
    let ring = [[3.0, 0.0, 0.0], [-1.5, 2.6, 0.0], [-1.5, -2.6, 0.0]];
    let twisted = [ring, ring.map(|[x, y, _]| [x, y, 3.0])].concat();
    let mesh = faces(&[&[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 3, 0, 5]], &twisted);
    assert_eq!(build(&mesh, &BuildSettings::default()).surface.unpaired().count(), 0);
}

#[test]
fn panels_behind_one_without_area_at_the_rim_do_not_meet_along_it() {
    // The rim from the first to the third vertex is divided by the second.
    let positions = [[0.0; 3], [2.0, 0.0, 0.0], [4.0, 0.0, 0.0], [2.0, 2.0, 0.0]];
    let mesh = faces(&[&[0, 1, 3], &[1, 2, 3], &[0, 2, 1]], &positions);
    let made = build(&mesh, &BuildSettings { product: Product::Paper, ..Default::default() });
    assert_eq!(made.surface.unpaired().collect::<Vec<_>>(), []);
    let paper = made.report().paper.unwrap();
    assert_eq!((paper.without_tab, paper.unpaired), (Vec::new(), Vec::new()));
}

#[test]
fn two_beams_in_one_direction_are_no_fins_of_any_thickness() {
    let own = BuildSettings {
        product: Product::Fins,
        kind: Some(OffsetKind::Face),
        thickness: 0.0,
        sheet: [900.0, 900.0],
        ..BuildSettings::default()
    };
    let straight = grid(3, 3, |i, j| [f64::from(i), f64::from(j), 0.25 * f64::from(i * i)]);
    let straight = with_a_panel_without_area(straight, [5, 6], 0.5);
    let made = build(&straight, &own);
    assert!(made.not_cut.iter().any(|not| not.part == "B5-6"), "{:?}", made.not_cut);
    assert!(!serde_json::to_string(&made.report()).unwrap().contains("NaN"));
    assert!(super::without_nan(&made));
}
