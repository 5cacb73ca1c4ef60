//! A workshop that has nothing but the files: it reads the letters on the sheets and the tables, cuts,
//! folds and joins, must find the surface again within a millimetre at full size, and each part where the
//! key drawings show it.

mod files;
mod fins;
mod key;
mod letters;
mod outline;
mod panels;
mod paper;
mod shape;
mod splices;

use super::build;
use super::identities::inverted;
use crate::support::grid::grid;
use files::Files;
use shape_up::fabricate::Build;
use shape_up::math::{cosine, sine};
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, Fold, Join, Names, OffsetKind, Pieces, Product};

/// Quads of a closed surface of revolution about z, without symmetry after an inversion, which preserves
/// circles: the corners of each quad are on one.
fn turned(around: u32, rows: u32, profile: impl Fn(f64) -> [f64; 2]) -> Mesh {
    let mut mesh = grid(around, rows, |i, j| {
        let turns = f64::from(i) / f64::from(around);
        let [radius, height] = profile(f64::from(j) / f64::from(rows));
        [radius * cosine(turns), radius * sine(turns), height]
    });
    let faces: Vec<Vec<u32>> = mesh.faces.iter().map(<[u32]>::to_vec).collect();
    // The last column is the first one.
    let width = around + 1;
    let column = |v: u32| if v % width == around { v - around } else { v };
    let number = |v: u32| column(v) / width * around + column(v) % width;
    mesh.positions = (0..(rows + 1) * around)
        .map(|v| mesh.positions[(v / around * width + v % around) as usize])
        .collect();
    mesh.faces =
        faces.iter().map(|face| face.iter().map(|&v| number(v)).collect::<Vec<_>>()).collect();
    inverted(&mesh)
}

/// A dome with an opening at its top.
fn dome() -> Mesh {
    turned(14, 6, |s| [2.0 * cosine(0.2 * s), 2.0 * sine(0.2 * s)])
}

/// A tube with a waist.
fn tube() -> Mesh {
    turned(10, 7, |s| [1.2 + 0.9 * (s - 0.5) * (s - 0.5), 3.0 * s])
}

fn of(product: Product) -> BuildSettings {
    BuildSettings { product, scale: 20.0, ..BuildSettings::default() }
}

/// Only what can be said of a build by its files.
fn files(made: &Build) -> Files {
    assert_eq!(made.not_cut, []);
    assert!(made.layout.too_large.is_empty());
    Files::of(made)
}

#[test]
fn panels_with_a_joint_and_a_kerf_make_the_dome_again() {
    for (names, scale) in [(Names::Index, 10.0), (Names::Assembly, 25.0), (Names::Index, 100.0)] {
        let own = BuildSettings { joint: 0.01, kerf: 0.2, names, scale, ..of(Product::Panels) };
        let files = files(&build(&dome(), &own));
        let found = panels::assemble(&files);
        key::assert_shows(&files, &found);
        found.assert_is(&dome());
        let (parts, _) = files.parts();
        let arrows = parts.iter().filter(|part| part.arrow.is_some()).count();
        assert!(scale > 10.0 || 3 * arrows > parts.len(), "{arrows} arrows");
    }
}

#[test]
fn panels_with_their_inside_up_make_the_dome_again_whole_or_in_pieces() {
    for (scale, splice) in [(10.0, 0.0), (0.8, 24.0)] {
        let (joint, kerf, print_inside) = (0.01, 0.2, true);
        let own = BuildSettings { scale, splice, joint, kerf, print_inside, ..of(Product::Panels) };
        let files = files(&build(&dome(), &own));
        let found = panels::assemble(&files);
        key::assert_shows(&files, &found);
        found.assert_is(&dome());
        // As its names are read, a sheet is the mirror image of what is seen from outside.
        let outside = BuildSettings { print_inside: false, ..own };
        let turns = |files: &Files| {
            let rows = files.table("panels.csv");
            rows.rows().map(|row| row.text("turn_deg").to_owned()).collect::<Vec<_>>()
        };
        assert_ne!(turns(&files), turns(&Files::of(&build(&dome(), &outside))));
    }
}

#[test]
fn panels_that_are_thick_have_their_bevels_at_their_edges() {
    let (scale, sheet) = (5.0, [2440.0, 1220.0]);
    let own = BuildSettings { joint: 0.01, thickness: 4.0, scale, sheet, ..of(Product::Panels) };
    let made = build(&dome(), &own);
    let files = files(&made);
    panels::assemble(&files).assert_is(&dome());
    let (parts, beside) = files.parts();
    let written: usize = parts.iter().map(|part| outline::bevels(&part.texts).count()).sum();
    let inner = made.surface.edges.iter().filter(|edge| !edge.is_rim()).count();
    assert!(written > inner, "{written} of {}", 2 * inner);
    assert!(beside.iter().any(|text| text.text.contains("BEVEL IN DEGREES")));
    for row in files.table("edges.csv").rows().filter(|row| !row.text("fold_deg").is_empty()) {
        assert!((2.0 * row.number("bevel_deg") - row.number("fold_deg")).abs() < 1e-5);
    }
    // Thin ones have none.
    let thin = build(&dome(), &BuildSettings { thickness: 0.5, ..own });
    assert!(thin.parts.iter().flat_map(|part| &part.bevels).all(Option::is_none));
}

#[test]
fn panels_cut_as_two_triangles_make_the_saddle_again() {
    let saddle = grid(5, 4, |i, j| {
        let [x, y] = [f64::from(i) - 1.3, 1.1 * f64::from(j) - 2.0];
        [x, y, 0.1 * x * y + 0.01 * x * x * x]
    });
    let own = BuildSettings { joint: 0.01, kerf: 0.2, bend: 1500.0, ..of(Product::Panels) };
    let made = build(&saddle, &own);
    assert_eq!(made.halves.len(), 20);
    let files = files(&made);
    let found = panels::assemble(&files);
    key::assert_shows(&files, &found);
    found.assert_is(&saddle);
}

#[test]
fn panels_larger_than_the_sheet_make_the_dome_again_from_pieces_joined_by_plates() {
    for (names, scale, hole) in [(Names::Index, 0.5, 0.0), (Names::Assembly, 0.8, 5.0)] {
        let own = BuildSettings {
            splice: 24.0,
            joint: 0.01,
            kerf: 0.2,
            names,
            scale,
            hole,
            ..of(Product::Panels)
        };
        let made = build(&dome(), &own);
        assert!(!build(&dome(), &BuildSettings { splice: 0.0, ..own }).layout.too_large.is_empty());
        // Some of them in columns and rows.
        let most = made.cut.iter().flatten().map(|cut| cut.pieces).max();
        assert!(most >= Some(4), "{most:?}");
        let files = files(&made);
        let found = panels::assemble(&files);
        key::assert_shows(&files, &found);
        found.assert_is(&dome());
    }
}

#[test]
fn pieces_of_paper_make_the_dome_again() {
    for pieces in [Pieces::Nets, Pieces::Strips, Pieces::Across] {
        for print_inside in [false, true] {
            let (scale, sheet) = (5.0, [1000.0, 700.0]);
            let own = BuildSettings { pieces, print_inside, scale, sheet, ..of(Product::Paper) };
            let files = files(&build(&dome(), &own));
            let found = paper::assemble(&files);
            key::assert_shows(&files, &found);
            found.assert_is(&dome());
        }
    }
}

#[test]
fn pieces_cut_along_seams_make_the_dome_again() {
    // From the rim to the opening at one side, and around between the third row and the fourth.
    let mesh = dome();
    let surface = build(&mesh, &of(Product::Paper)).surface;
    let seams: Vec<[u32; 2]> = surface.edges.iter().map(|edge| edge.ends).collect();
    let seams = seams.into_iter().filter(|ends| {
        let [a, b] = ends.map(|v| [v % 14, v / 14]);
        (a[0] == 0 && b[0] == 0) || (a[1] == 3 && b[1] == 3)
    });
    let seams: std::rc::Rc<[[u32; 2]]> = seams.collect();
    assert_eq!(seams.len(), 6 + 14);
    for fold in [Fold::Crease, Fold::Score] {
        for pieces in [Pieces::Nets, Pieces::Strips, Pieces::Across] {
            let (scale, sheet, seams) = (5.0, [1000.0, 700.0], seams.clone());
            let of = of(Product::Paper);
            let own = BuildSettings { pieces, scale, sheet, seams, fold, thickness: 0.5, ..of };
            let made = build(&mesh, &own);
            assert_eq!(made.report().paper.map(|paper| paper.seams), Some(20));
            paper::assemble(&files(&made)).assert_is(&mesh);
        }
    }
}

#[test]
fn paper_with_a_kerf_makes_the_dome_again_with_glue_and_with_tongues_in_slots() {
    for (join, pieces, kerf, print_inside) in [
        (Join::Tabs, Pieces::Nets, 0.15, false),
        (Join::Slots, Pieces::Nets, 0.0, false),
        (Join::Slots, Pieces::Across, 0.0, true),
    ] {
        let (scale, sheet) = (5.0, [1000.0, 700.0]);
        let of = of(Product::Paper);
        let own = BuildSettings { join, pieces, kerf, print_inside, scale, sheet, ..of };
        let made = build(&dome(), &own);
        assert_eq!(made.report().paper.unwrap().tongues > 0, join == Join::Slots);
        let files = files(&made);
        let found = paper::assemble(&files);
        key::assert_shows(&files, &found);
        found.assert_is(&dome());
    }
}

#[test]
fn card_makes_the_dome_again_however_it_is_folded() {
    let folds = [Fold::Score, Fold::VCut, Fold::Separate];
    let cuts = [(0.5, 0.15), (1.0, 0.0), (1.5, 0.0), (2.0, 0.15)];
    for (fold, (thickness, kerf)) in folds.iter().flat_map(|&fold| cuts.map(|cut| (fold, cut))) {
        for print_inside in [false, true] {
            let (scale, sheet) = (5.0, [1000.0, 700.0]);
            let of = of(Product::Paper);
            let own = BuildSettings { fold, print_inside, scale, sheet, thickness, kerf, ..of };
            paper::assemble(&files(&build(&dome(), &own))).assert_is(&dome());
        }
    }
}

#[test]
fn fins_make_the_tube_again_outwards_and_inwards_with_and_without_room_for_more_than_their_names() {
    for (distance, scale) in [(0.1, 8.0), (-0.1, 8.0), (-0.06, 16.0), (0.06, 16.0)] {
        let own = BuildSettings {
            kind: Some(OffsetKind::Corner),
            distance: Some(distance),
            kerf: 0.2,
            thickness: 1.5,
            scale,
            ..of(Product::Fins)
        };
        let files = files(&build(&tube(), &own));
        let found = fins::assemble(&files);
        key::assert_shows(&files, &found);
        found.assert_is(&tube());
    }
}
