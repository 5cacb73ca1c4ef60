//! What is cut of paper: outlines with a kerf, and tongues with their slots.

use super::{cases, model, scale, settings, waves};
use crate::fabricate::identities::revolution;
use crate::fabricate::{build, text_of};
use shape_up::fabricate::Build;
use shape_up::fabricate::paper::{JointKind, PaperModel, Tongue};
use shape_up::math::Vec3;
use shape_up::math::plane::{Point2, area, cross, distance, dot, is_inside, minus};
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, Fold, Join, Pieces};

fn away(line: &[Point2], point: Point2) -> f64 {
    let n = line.len();
    let to = |k: usize| {
        let (p, q) = (line[k], line[(k + 1) % n]);
        let (along, at) = (minus(q, p), minus(point, p));
        let share = (dot(at, along) / dot(along, along).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        distance(at, along.map(|x| share * x))
    };
    (0..n).map(to).fold(f64::INFINITY, f64::min)
}

/// Whether two sides that are no neighbours cross by more than files and machines tell.
fn crosses(line: &[Point2]) -> bool {
    const LEAST: f64 = 1e-3;
    let n = line.len();
    let beside = |p: Point2, q: Point2, r: Point2| {
        cross(minus(q, p), minus(r, p)) / distance(p, q).max(f64::MIN_POSITIVE)
    };
    let are_apart = |a: f64, b: f64| a * b < 0.0 && a.abs().min(b.abs()) > LEAST;
    (0..n).any(|i| {
        (i + 2..n).filter(|&j| (j + 1) % n != i).any(|j| {
            let [a, b, c, d] = [i, i + 1, j, j + 1].map(|k| line[k % n]);
            are_apart(beside(a, b, c), beside(a, b, d))
                && are_apart(beside(c, d, a), beside(c, d, b))
        })
    })
}

/// Points along a closed line.
fn along(line: &[Point2], count: u32) -> Vec<Point2> {
    let n = line.len();
    let at = |k: usize, share: f64| {
        let (p, q) = (line[k], line[(k + 1) % n]);
        [0, 1].map(|x| p[x] + share * (q[x] - p[x]))
    };
    let shares = (0..count).map(|i| (f64::from(i) + 0.5) / f64::from(count));
    shares.flat_map(|share| (0..n).map(move |k| at(k, share))).collect()
}

#[test]
fn outlines_of_paper_are_half_the_kerf_outside_and_cross_nothing_and_folds_stay() {
    for (name, mesh, pieces) in cases() {
        for (fold, kerf) in
            [(Fold::Crease, 0.15), (Fold::Crease, 0.4), (Fold::Score, 0.15), (Fold::Separate, 0.15)]
        {
            let own =
                BuildSettings { scale: scale(&mesh), fold, thickness: 1.0, ..settings(pieces) };
            // The same nets, also with less room on the sheet.
            let own = BuildSettings { sheet: [2000.0; 2], ..own };
            let plain = build(&mesh, &own);
            let made = build(&mesh, &BuildSettings { kerf, tool: kerf, ..own });
            assert_eq!(made.parts.len(), plain.parts.len(), "{name}");
            for (part, plain) in made.parts.iter().zip(&plain.parts) {
                let words = format!("{name}, {fold:?}, {kerf}, {}", part.name);
                assert_eq!(
                    (&part.ridges, &part.valleys),
                    (&plain.ridges, &plain.valleys),
                    "{words}"
                );
                assert!(!crosses(&part.outline), "{words}");
                // What is cut takes nothing but in gaps that are too narrow, of which it takes as much
                // from both sides.
                for point in along(&part.outline, 3) {
                    let to = away(&plain.outline, point);
                    assert!(to <= 1.25 * kerf + 1e-9, "{words}: {to}");
                    let is_outside = !is_inside(&plain.outline, point) || to < 0.02;
                    assert!(is_outside, "{words}: {to} inside at {point:?}");
                }
                let (mut full, mut all) = (0, 0);
                for point in along(&plain.outline, 7) {
                    let to = away(&part.outline, point);
                    assert!(to < 0.5 * kerf + 0.1, "{words}: {to}");
                    all += 1;
                    full += usize::from(to > 0.5 * kerf - 1e-6);
                }
                assert!(fold != Fold::Crease || 10 * full > 8 * all, "{words}: {full} of {all}");
                assert!(area(&part.outline) > area(&plain.outline), "{words}");
            }
            assert!(made.layout.too_large.is_empty(), "{name}");
        }
    }
}

#[test]
fn a_piece_as_large_as_the_sheet_lies_on_it_with_its_kerf() {
    // Two squares of 100 mm, which fit with tabs but not with a kerf.
    let mesh = super::two_squares(5.0);
    for (kerf, pieces) in [(0.0, 1), (0.3, 2)] {
        let own = BuildSettings { scale: 50.0, tab: 0.0, kerf, ..settings(Pieces::Nets) };
        let made = build(&mesh, &BuildSettings { sheet: [210.5, 130.0], ..own });
        assert_eq!(made.parts.len(), pieces, "{kerf}");
        assert!(made.layout.too_large.is_empty(), "{kerf}");
    }
}

#[test]
fn a_cut_that_is_too_wide_for_the_slits_of_nets_is_told_and_not_allowed_for() {
    let mesh = super::two_squares(5.0);
    let [thin, wide] = [0.0, 3.0]
        .map(|kerf| build(&mesh, &BuildSettings { scale: 50.0, kerf, ..settings(Pieces::Nets) }));
    assert_eq!(thin.parts[0].outline, wide.parts[0].outline);
    assert!(thin.faults.is_empty());
    assert!(wide.faults[0].to_string().starts_with("a cut that is 3 mm wide"), "{:?}", wide.faults);
}

/// Two surfaces with slots: one of flat quads, and one of triangles.
fn surfaces() -> [(Mesh, Pieces); 2] {
    [(revolution(9, 7), Pieces::Strips), (waves(), Pieces::Nets)]
}

fn with_slots(mesh: &Mesh, pieces: Pieces) -> BuildSettings {
    let join = Join::Slots;
    BuildSettings { scale: scale(mesh), join, thickness: 0.5, ..settings(pieces) }
}

fn tongues(model: &PaperModel) -> impl Iterator<Item = &Tongue> {
    model.joint_kinds.iter().filter_map(|kind| match kind {
        JointKind::Tongue(own) => Some(own),
        _ => None,
    })
}

/// Where a place along a side of a facet is on the surface, in mm of the sheet.
fn in_space(made: &Build, (f, k): (u32, u32), along: f64) -> Vec3<f64> {
    let vertices = &model(made).net.facets[f as usize].vertices;
    let at = |k: u32| {
        made.surface.positions[vertices[k as usize % vertices.len()] as usize] * made.mm_of_sheet()
    };
    let (p, q) = (at(k), at(k + 1));
    p + (q - p) * (along / (q - p).length())
}

#[test]
fn every_tongue_finds_its_slot_when_the_model_is_folded() {
    for (mesh, pieces) in surfaces() {
        for (thickness, clearance, kerf, print_inside) in
            [(0.2, 0.1, 0.0, false), (0.5, 0.1, 0.15, true), (0.5, 0.05, 0.9, false)]
        {
            let own = BuildSettings {
                thickness,
                clearance,
                kerf,
                print_inside,
                ..with_slots(&mesh, pieces)
            };
            let made = build(&mesh, &own);
            let model = model(&made);
            let net = &model.net;
            let part = |(f, _): (u32, u32)| {
                let piece = net.piece_of[f as usize];
                &made.parts[model.pieces.iter().position(|&own| own == piece).unwrap()]
            };
            let mut count = 0;
            for tongue in tongues(model) {
                count += 1;
                assert_eq!(tongue.number, count);
                // On the edge: both ends of the slot are as far from the tongue as it has play.
                let slot = tongue.slot.map(|along| in_space(&made, tongue.flange.side, along));
                let root = tongue.root.map(|along| in_space(&made, tongue.side, along));
                for (end, other) in slot.into_iter().zip([root[1], root[0]]) {
                    let play = (end - other).length();
                    assert!((play - clearance).abs() < 0.02, "{play}");
                }
                let [wide, long] = [tongue.root, tongue.slot].map(|[from, to]| to - from);
                assert!((long - wide - 2.0 * clearance).abs() < 1e-9 && wide >= 5.0 - 1e-9);
                assert!(
                    (tongue.width - (thickness + 2.0 * clearance).max(kerf + 0.1)).abs() < 1e-9
                );
                assert!(tongue.length >= 3.0 - 1e-9);
                // The slot is a hole that is narrower by the kerf, and away from all other lines.
                let holes = &part(tongue.flange.side).holes;
                let expected = (long - kerf) * (tongue.width - kerf);
                let is_own = |area_of: f64| (area_of - expected).abs() < 1e-6;
                assert!(holes.iter().any(|hole| is_own(area(&hole.outline()))), "{expected}");
                // The tongue lies behind its neighbour.
                let behind =
                    neighbour_seen_from(made_corners(model, tongue.flange.side), tongue, model);
                for &corner in &tongue.corners(net)[1..5] {
                    assert!(is_inside(&behind, corner), "{corner:?} {behind:?}");
                    assert!(away(&behind, corner) > 0.25, "{}", away(&behind, corner));
                }
            }
            let report = made.report().paper.unwrap();
            assert_eq!(report.tongues, count as usize);
            assert!(report.tongues > 20 && report.tongues > 3 * report.tabs, "{report:?}");
            for part in &made.parts {
                for hole in &part.holes {
                    let slot = hole.outline();
                    assert!(area(&slot) > 0.0, "{}", part.name);
                    for &corner in &slot {
                        assert!(is_inside(&part.outline, corner));
                        assert!(
                            away(&part.outline, corner) > 1.9,
                            "{}",
                            away(&part.outline, corner)
                        );
                    }
                    for line in part.ridges.iter().chain(&part.valleys) {
                        for i in 0..=50 {
                            let share = f64::from(i) / 50.0;
                            let point =
                                [0, 1].map(|x| line[0][x] + share * (line[1][x] - line[0][x]));
                            assert!(!is_inside(&slot, point) || away(&slot, point) < 1e-6);
                        }
                    }
                }
            }
            let rows = text_of(&made, "tongues.csv").lines().count() - 1;
            assert_eq!(rows, report.tongues);
            let said = made.words(&made.report()).sheets;
            assert!(said.contains(&format!("{count} tongues")), "{said}");
        }
    }
}

/// The corners of the facet of a side, with those of the side first.
fn made_corners(model: &PaperModel, (f, k): (u32, u32)) -> Vec<Point2> {
    let mut corners = model.net.corners(f);
    corners.rotate_left(k as usize);
    corners
}

/// The facet with the slot, unfolded over the side of a tongue.
fn neighbour_seen_from(there: Vec<Point2>, tongue: &Tongue, model: &PaperModel) -> Vec<Point2> {
    let [p, q] = model.net.ends(tongue.side);
    let unit = |v: Point2| v.map(|x| x / (dot(v, v)).sqrt());
    let (u, v) = (unit(minus(there[1], there[0])), unit(minus(p, q)));
    let put = |point: Point2| {
        let at = minus(point, there[0]);
        let [x, y] = [dot(at, u), cross(u, at)];
        [q[0] + x * v[0] - y * v[1], q[1] + x * v[1] + y * v[0]]
    };
    there.iter().map(|&point| put(point)).collect()
}

#[test]
fn where_a_tongue_has_no_room_there_is_a_tab_and_it_is_told() {
    // Edges of 6 mm have no room for a tongue of 5 mm between two margins of 2 mm.
    let mesh = revolution(9, 7);
    let own = with_slots(&mesh, Pieces::Strips);
    let made = build(&mesh, &BuildSettings { scale: 5.0 * own.scale, tab: 4.0, ..own });
    let report = made.report();
    let paper = report.paper.as_ref().unwrap();
    assert!(paper.tabs > paper.tongues, "{paper:?}");
    let warnings = made.words(&report).warnings;
    let told = warnings.iter().any(|own| own.starts_with("No room for ") && own.contains("tongue"));
    assert!(told, "{warnings:?}");
    // Card that is not creased has none.
    let own = BuildSettings { fold: Fold::Score, ..with_slots(&mesh, Pieces::Strips) };
    let paper = build(&mesh, &own).report().paper.unwrap();
    assert_eq!((paper.tongues, paper.tabs), (0, 0));
}
