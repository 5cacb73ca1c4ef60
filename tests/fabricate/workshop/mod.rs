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
    }
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
