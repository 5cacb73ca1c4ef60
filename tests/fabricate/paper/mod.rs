//! Paper models: no overlaps, hidden tabs, and folds and lengths of the shape.

mod card;
mod cut;
mod names;
mod seams;

use super::identities::revolution;
use super::{build, text_of};
use crate::support::grid::grid;
use crate::support::long_or;
use crate::support::shared;
use shape_up::fabricate::paper::{JointKind, PaperModel};
use shape_up::fabricate::{Build, Stand};
use shape_up::math::plane::{Point2, area, bounds};
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, Fold, Join, Pieces, Product};

pub(super) fn settings(pieces: Pieces) -> BuildSettings {
    BuildSettings { product: Product::Paper, pieces, scale: 20.0, ..BuildSettings::default() }
}

pub(super) fn model(build: &Build) -> &PaperModel {
    build.paper.as_ref().unwrap()
}

/// Panels that are not flat, with ridges and valleys.
pub(super) fn waves() -> Mesh {
    grid(6, 5, |i, j| {
        let [x, y] = [f64::from(i), f64::from(j)];
        [x, y, 0.35 * f64::from((i + j) % 2) + 0.05 * x * y]
    })
}

fn dodecahedron() -> Option<Mesh> {
    shared::mesh("gc_dodecahedron_poly.obj")
}

/// The test cases: flat quads in both directions, panels that are not flat, a closed surface,
/// triangles.
pub(super) fn cases() -> Vec<(&'static str, Mesh, Pieces)> {
    let mut cases = vec![
        ("nets", revolution(9, 7), Pieces::Nets),
        ("closed rings", revolution(24, 5), Pieces::Nets),
        ("strips", revolution(9, 7), Pieces::Strips),
        ("across", revolution(24, 5), Pieces::Across),
        ("creased nets", waves(), Pieces::Nets),
        ("creased strips", waves(), Pieces::Strips),
        ("a plane", grid(5, 4, |i, j| [f64::from(i), f64::from(j), 0.0]), Pieces::Nets),
    ];
    if let Some(mesh) = dodecahedron() {
        cases.push(("pentagons", mesh, Pieces::Nets));
    }
    for name in ["halftunnel.off", "compas_hypar.obj"] {
        if let Some(mesh) = shared::mesh(name) {
            cases.push((name, mesh.clone(), Pieces::Strips));
            cases.push((name, mesh, Pieces::Nets));
        }
    }
    cases
}

/// The scale at which the mean edge is 30 mm long.
pub(super) fn scale(mesh: &Mesh) -> f64 {
    let made = build(mesh, &BuildSettings::default());
    made.surface.mean_edge() * 1000.0 / 30.0
}

fn made(mesh: &Mesh, pieces: Pieces) -> Build {
    build(mesh, &BuildSettings { scale: scale(mesh), ..settings(pieces) })
}

/// Common area of two polygons, the second of them convex, by clipping (Sutherland, Hodgman).
fn common_area(polygon: &[Point2], convex: &[Point2]) -> f64 {
    let mut left = polygon.to_vec();
    for k in 0..convex.len() {
        let (p, q) = (convex[k], convex[(k + 1) % convex.len()]);
        let side = |r: Point2| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
        let mut next = Vec::new();
        for i in 0..left.len() {
            let (a, b) = (left[i], left[(i + 1) % left.len()]);
            let (s, t) = (side(a), side(b));
            if s >= 0.0 {
                next.push(a);
            }
            if (s > 0.0 && t < 0.0) || (s < 0.0 && t > 0.0) {
                let share = s / (s - t);
                next.push([0, 1].map(|x| a[x] + share * (b[x] - a[x])));
            }
        }
        left = next;
    }
    area(&left)
}

/// The facets, tabs, flanges and tongues of a piece.
fn polygons(model: &PaperModel, piece: u32) -> Vec<Vec<Point2>> {
    let facets = model.net.pieces[piece as usize].iter();
    let mut all: Vec<Vec<Point2>> = facets.map(|&f| model.net.corners(f)).collect();
    all.extend(model.tabs(piece).map(|tab| tab.corners.to_vec()));
    all.extend(model.slots(piece).map(|tongue| tongue.flange.corners.to_vec()));
    all.extend(model.tongues(piece).map(|tongue| tongue.corners(&model.net).to_vec()));
    all
}

/// Checks that no piece overlaps itself, and that its outline holds its facets and tabs.
pub(super) fn assert_whole(name: &str, made: &Build) {
    let model = model(made);
    assert_eq!(made.parts.len(), model.pieces.len(), "{name}");
    for (part, &piece) in made.parts.iter().zip(&model.pieces) {
        let all = polygons(model, piece);
        for (i, a) in all.iter().enumerate() {
            for b in &all[..i] {
                // Panels that count as flat are up to 0.02 mm off; an edge is 30 mm long.
                let common = common_area(a, b);
                assert!(common < 0.5, "{name}, {}: {common}", part.name);
            }
        }
        let expected: f64 = all.iter().map(|own| area(own)).sum();
        let found = area(&part.outline);
        assert!(
            (found - expected).abs() < 1e-3 * expected,
            "{name}, {}: {found} {expected}",
            part.name
        );
        assert!(!crosses_itself(&part.outline), "{name}, {}", part.name);
    }
}

#[test]
fn no_piece_overlaps_itself_and_its_outline_holds_its_facets_and_tabs() {
    let ways = [(Fold::Crease, Join::Tabs), (Fold::Score, Join::Tabs), (Fold::Crease, Join::Slots)];
    for ((name, mesh, pieces), (fold, join)) in
        cases().iter().flat_map(|own| ways.map(|way| (own, way)))
    {
        let (scale, thickness) = (scale(mesh), 1.0);
        let own = BuildSettings { scale, fold, join, thickness, ..settings(*pieces) };
        assert_whole(name, &build(mesh, &own));
    }
}

#[test]
fn paper_is_cut_with_a_knife_whatever_tool_was_set_before() {
    // The settings of a mill are kept while paper is made: it got reliefs in its inner corners.
    let own = BuildSettings { product: Product::Paper, ..BuildSettings::default() };
    let milled = BuildSettings { tool: 3.0, ..own.clone() };
    let outlines = |settings: &BuildSettings| -> Vec<Vec<Point2>> {
        build(&waves(), settings).parts.into_iter().map(|part| part.outline).collect()
    };
    assert_eq!(outlines(&milled), outlines(&own));
}

/// Whether two non-adjacent sides cross.
fn crosses_itself(polygon: &[Point2]) -> bool {
    let n = polygon.len();
    let side = |p: Point2, q: Point2, r: Point2| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    (0..n).any(|i| {
        (i + 2..n).filter(|&j| (j + 1) % n != i).any(|j| {
            let ([a, b], [c, d]) =
                ([polygon[i], polygon[i + 1]], [polygon[j], polygon[(j + 1) % n]]);
            side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
        })
    })
}

#[test]
fn flat_panels_meet_at_their_hinges_and_cut_pairs_are_equally_long() {
    for (mesh, pieces) in [(revolution(9, 7), Pieces::Nets), (revolution(24, 5), Pieces::Across)] {
        let made = made(&mesh, pieces);
        let model = model(&made);
        for (joint, folded) in model.net.joints.iter().zip(&model.net.folded) {
            let [[p, q], [r, s]] = joint.sides.map(|side| model.net.ends(side));
            let distance =
                |a: Point2, b: Point2| ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt();
            assert!((distance(p, q) - distance(r, s)).abs() < 1e-9);
            if *folded {
                assert!(distance(p, s) < 1e-9 && distance(q, r) < 1e-9);
            }
            let edge = &made.surface.edges[joint.edge.unwrap() as usize];
            assert!((joint.fold - made.surface.fold(edge).unwrap()).abs() < 1e-12);
        }
    }
}

#[test]
fn tabs_hide_behind_the_neighbour() {
    for (name, mesh, pieces) in cases() {
        let made = made(&mesh, pieces);
        let model = model(&made);
        let mut tabs = 0;
        for (joint, kind) in model.net.joints.iter().zip(&model.joint_kinds) {
            let JointKind::Tab(tab) = kind else { continue };
            tabs += 1;
            let own = tab.side;
            let other = if joint.sides[0] == own { joint.sides[1] } else { joint.sides[0] };
            // In the frame of the edge, in which the tab points away from its piece and the
            // neighbour away from the edge.
            let [p, q] = model.net.ends(own);
            let [r, s] = model.net.ends(other);
            let frame = |at: Point2, to: Point2| {
                let length = ((to[0] - at[0]).powi(2) + (to[1] - at[1]).powi(2)).sqrt();
                let [c, d] = [(to[0] - at[0]) / length, (to[1] - at[1]) / length];
                move |[x, y]: Point2| {
                    let [x, y] = [x - at[0], y - at[1]];
                    [c * x + d * y, d * x - c * y]
                }
            };
            // The frame is a reflection.
            let back = |points: &[Point2], to_frame: &dyn Fn(Point2) -> Point2| -> Vec<Point2> {
                points.iter().rev().map(|&point| to_frame(point)).collect()
            };
            let tab = back(&tab.corners, &frame(p, q));
            let neighbour = back(&model.net.corners(other.0), &frame(s, r));
            let height = tab[1][1];
            assert!(height >= 2.0 - 1e-9, "{name}: {height}");
            let inside = common_area(&neighbour, &tab);
            assert!((inside - area(&tab)).abs() < 0.5, "{name}: {inside} {}", area(&tab));
        }
        assert!(tabs > 0 || name == "a plane", "{name}");
    }
}

#[test]
fn every_inner_edge_is_folded_or_glued_and_flat_quads_leave_no_edge_bare() {
    for (name, mesh, pieces) in cases() {
        let made = made(&mesh, pieces);
        let report = made.report().paper.unwrap();
        let inner = made.surface.edges.iter().filter(|edge| !edge.is_rim()).count();
        let of_edges = model(&made).net.joints.iter().filter(|joint| joint.edge.is_some()).count();
        assert_eq!(of_edges, inner, "{name}");
        let bare = report.without_tab.len();
        println!("{name}: {} pieces, {report:?}", made.parts.len());
        assert!(20 * bare <= inner, "{name}: {bare} of {inner}");
        assert!(made.layout.too_large.is_empty(), "{name}");
    }
}

#[test]
fn strips_of_a_ring_are_its_rows_and_its_columns() {
    let mesh = revolution(9, 7);
    let own = BuildSettings { scale: 40.0, ..settings(Pieces::Strips) };
    let (one, other) =
        (build(&mesh, &own), build(&mesh, &BuildSettings { pieces: Pieces::Across, ..own }));
    let mut counts = [one.parts.len(), other.parts.len()];
    counts.sort_unstable();
    assert_eq!(counts, [7, 9]);
    let panels = |made: &Build| made.parts.iter().map(|part| part.panels.len()).collect::<Vec<_>>();
    assert!(panels(&one).iter().all(|n| n * one.parts.len() == 63), "{:?}", panels(&one));
    assert!(panels(&other).iter().all(|n| n * other.parts.len() == 63), "{:?}", panels(&other));
}

#[test]
fn a_long_strip_is_split_at_the_page_and_every_piece_lies_on_it() {
    let mesh = revolution(24, 5);
    let own = BuildSettings { sheet: [297.0, 210.0], scale: 8.0, ..settings(Pieces::Strips) };
    let made = build(&mesh, &own);
    assert!(made.layout.too_large.is_empty() && made.layout.sheets.len() > 1);
    assert!(made.parts.iter().map(|part| part.panels.len()).sum::<usize>() == mesh.faces.len());
    for sheet in &made.layout.sheets {
        for place in &sheet.places {
            for [x, y] in made.parts[place.part].outline.iter().map(|&p| place.to_sheet(p)) {
                assert!(
                    x >= 5.0 - 1e-9 && y >= 5.0 - 1e-9 && x <= 292.0 + 1e-9 && y <= 205.0 + 1e-9
                );
            }
        }
    }
}

#[test]
fn a_plane_is_one_piece_without_folds_or_slits() {
    let mesh = grid(5, 4, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let made = build(&mesh, &settings(Pieces::Nets));
    assert_eq!(
        (made.parts.len(), made.parts[0].ridges.len(), made.parts[0].valleys.len()),
        (1, 0, 0)
    );
    assert!((area(&made.parts[0].outline) - 20.0 * 2500.0).abs() < 1e-6);
}

#[test]
fn folds_of_rounding_are_neither_ridges_nor_valleys() {
    let mesh = grid(5, 4, |i, j| {
        let [x, y] = [f64::from(i) / 3.0, f64::from(j) / 3.0];
        [x, y, 0.3 * x + 0.7 * y]
    });
    let made = build(&mesh, &settings(Pieces::Nets));
    assert!(model(&made).net.joints.iter().any(|joint| joint.fold != 0.0));
    let report = made.report().paper.unwrap();
    assert_eq!((report.ridges, report.valleys), (0, 0));
    let joins = text_of(&made, "joins.csv");
    let folds: Vec<&str> =
        joins.lines().skip(1).map(|row| row.split(',').nth(6).unwrap()).collect();
    assert!(!folds.is_empty() && folds.iter().all(|fold| *fold == "flat"), "{folds:?}");
}

#[test]
fn without_tabs_none_is_missing() {
    for (tab, are_low) in [(0.0, false), (1.9, true)] {
        let made = build(&revolution(9, 7), &BuildSettings { tab, ..settings(Pieces::Strips) });
        let report = made.report();
        let warnings = made.words(&report).warnings;
        let are_said_low = warnings.iter().any(|own| own == "Tabs lower than 2 mm are not made.");
        let paper = report.paper.unwrap();
        assert_eq!((paper.tabs, paper.without_tab, are_said_low), (0, Vec::new(), are_low));
    }
}

#[test]
fn printed_on_the_inside_a_sheet_is_mirrored_and_ridges_are_valleys() {
    let mesh = revolution(9, 7);
    let own = settings(Pieces::Strips);
    let (outside, inside) =
        (build(&mesh, &own), build(&mesh, &BuildSettings { print_inside: true, ..own }));
    for (a, b) in outside.parts.iter().zip(&inside.parts) {
        assert!((area(&a.outline) - area(&b.outline)).abs() < 1e-9);
        assert_eq!(b.valleys.is_empty(), a.ridges.is_empty());
        assert_eq!(a.valleys.is_empty(), b.ridges.is_empty());
    }
    assert_eq!(outside.report().paper, inside.report().paper, "the model is the same");
}

#[test]
fn tabs_that_are_too_high_leave_panels_folded_together() {
    // Nothing was folded, since tabs on both sides would leave no room on the sheet.
    let high = BuildSettings { tab: 1000.0, ..settings(Pieces::Strips) };
    let made = build(&revolution(9, 7), &high);
    assert!(made.parts.len() < made.surface.faces.len() / 3, "{}", made.parts.len());
}

#[test]
fn tables_tell_what_becomes_of_every_edge() {
    let made = build(&revolution(9, 7), &settings(Pieces::Strips));
    let rows = |name: &str| text_of(&made, name).lines().count() - 1;
    let inner = made.surface.edges.iter().filter(|edge| !edge.is_rim()).count();
    assert_eq!((rows("pieces.csv"), rows("joins.csv")), (made.parts.len(), inner));
    // Where a piece is on its sheet is said of a point that is seen there.
    let pieces = text_of(&made, "pieces.csv");
    let place = made.layout.sheets[0].places[0];
    let part = &made.parts[place.part];
    let corner = bounds(part.outline.iter().map(|&point| place.to_sheet(point)))[0];
    let row = pieces.lines().nth(1 + place.part).unwrap();
    let cells: Vec<f64> =
        row.split(',').skip(4).take(3).map(|cell| cell.parse().unwrap()).collect();
    assert_eq!(cells[0], 1.0, "{row}");
    assert!((0..2).all(|k| (cells[1 + k] - corner[k]).abs() < 1e-3), "{row} {corner:?}");
}

#[test]
fn what_cannot_be_folded_is_told_and_the_rest_is_made() {
    // Triangles instead of quads.
    let mut triangles = Mesh { positions: revolution(6, 4).positions, ..Mesh::default() };
    for face in revolution(6, 4).faces.iter() {
        triangles.faces.push(&[face[0], face[1], face[2]]);
        triangles.faces.push(&[face[0], face[2], face[3]]);
    }
    let made = build(&triangles, &settings(Pieces::Strips));
    assert!(made.card().problems.iter().any(|problem| problem.contains("nets are made instead")));
    assert!(made.report().placed > 0);
    // A panel that crosses itself, a sound one beside it, and one without area.
    let positions =
        vec![[0.0; 3], [2.0, 0.0, 0.0], [0.5, 1.0, 0.0], [2.0, 1.0, 0.0], [3.0, 0.0, 0.0]];
    let mut mesh = Mesh { positions, ..Mesh::default() };
    [&[0, 1, 2, 3][..], &[1, 4, 3], &[4, 4, 4]].iter().for_each(|face| mesh.faces.push(face));
    let report = build(&mesh, &settings(Pieces::Nets)).report();
    assert_eq!((report.placed, report.not_cut.len()), (1, 2), "{:?}", report.not_cut);
    // Three panels at one edge, and no tabs.
    let positions = [[0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [-1.0, 0.1, 0.0], [0.1, 1.0, 0.0]];
    let mut mesh = Mesh { positions: positions.to_vec(), ..Mesh::default() };
    [[0, 1, 2], [0, 1, 3], [0, 1, 4]].iter().for_each(|face| mesh.faces.push(face));
    let report = build(&mesh, &BuildSettings { tab: 0.0, ..settings(Pieces::Nets) }).report();
    assert_eq!(report.placed, 3);
}

#[test]
fn real_and_awkward_meshes_are_folded_without_a_panic() {
    for folder in ["meshes", "meshes/awkward"] {
        let Some(path) = shared::path(folder) else { return };
        let files = std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path());
        for path in files.filter(|path| path.is_file()) {
            let bytes = std::fs::read(&path).unwrap();
            if bytes.len() > long_or(60_000, 15_000) {
                continue;
            }
            let Ok(read) = shape_up::mesh::read(&path.to_string_lossy(), &bytes) else { continue };
            if shape_up::mesh::first_out_of_range(&read.mesh.positions).is_some() {
                continue;
            }
            for product in [Product::Fins, Product::Paper] {
                let own = BuildSettings { product, ..settings(Pieces::Strips) };
                if let Ok(made) = Build::new(&read.mesh, &own, super::metres(), &Stand::default()) {
                    let text = serde_json::to_string(&made.report()).unwrap();
                    assert!(!text.contains("NaN"), "{}", path.display());
                    assert!(super::without_nan(&made));
                }
            }
        }
    }
}

#[test]
fn strips_that_are_longer_than_the_sheet_are_cut_evenly() {
    // 23 panels of 30 mm, of which about 13 fit on a sheet of A3.
    let vault = grid(23, 3, |i, j| [f64::from(i), f64::from(j), 0.002 * f64::from(i * i)]);
    let made = build(
        &vault,
        &BuildSettings { scale: 1000.0 / 30.0, tab: 6.0, ..settings(Pieces::Across) },
    );
    let mut lengths: Vec<usize> = made.parts.iter().map(|part| part.panels.len()).collect();
    lengths.sort_unstable();
    assert_eq!(lengths, [11, 11, 11, 12, 12, 12]);
}

#[test]
fn a_panel_with_coincident_corners_is_creased_and_joined_as_what_it_is() {
    // Warped, with a notch, and a warped quad below.
    let corners = [
        [0.0, 0.0, 0.0],
        [3.0, 0.0, 0.1],
        [3.0, 1.0, 0.0],
        [1.0, 1.0, 0.3],
        [1.0, 3.0, 0.0],
        [0.0, 3.0, 0.2],
        [3.0, -2.0, 0.1],
        [0.0, -2.0, 0.4],
    ];
    let joins = |positions: &[[f64; 3]], face: &[u32], below: &[u32]| {
        let mut mesh = Mesh { positions: positions.to_vec(), ..Mesh::default() };
        mesh.faces.push(face);
        mesh.faces.push(below);
        let made = build(&mesh, &settings(Pieces::Nets));
        let net = &model(&made).net;
        let edges = net.joints.iter().filter(|joint| joint.edge.is_some()).count();
        let area: f64 = net.facets.iter().map(|facet| area(&facet.corners)).sum();
        (edges, net.joints.len(), area)
    };
    let plain = joins(&corners, &[0, 1, 2, 3, 4, 5], &[0, 7, 6, 1]);
    for twice in 0..6_u32 {
        let positions = [&corners[..], &[corners[twice as usize]]].concat();
        for after in [0, 1] {
            let mut face = vec![0, 1, 2, 3, 4, 5];
            face.insert(twice as usize + after, 8);
            // The edge between both panels has the ends that face each other.
            let ends = match (twice, after) {
                (0, 1) => [8, 1],
                (1, 0) => [0, 8],
                _ => [0, 1],
            };
            let found = joins(&positions, &face, &[ends[0], 7, 6, ends[1]]);
            assert_eq!((found.0, found.1), (plain.0, plain.1), "{twice} {after}");
            assert!((found.2 - plain.2).abs() < 0.01 * plain.2, "{twice} {after}: {found:?}");
        }
    }
}

#[test]
fn no_piece_hangs_together_by_an_edge_too_short_to_hold_it() {
    // Two squares that share an edge of a hundredth of a millimetre on the sheet, and no other.
    let e = 0.0002;
    let positions = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, e, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [2.0, 0.0, 0.0],
        [2.0, -1.0, 0.0],
    ];
    let mut mesh = Mesh { positions, ..Mesh::default() };
    mesh.faces.push(&[0, 1, 2, 3, 4]);
    mesh.faces.push(&[2, 1, 6, 5]);
    assert_eq!(build(&mesh, &settings(Pieces::Nets)).parts.len(), 2);
    // As many panels around a short edge between them are one piece.
    let whole = grid(2, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    assert_eq!(build(&whole, &settings(Pieces::Nets)).parts.len(), 1);
}

/// Two squares with a small fold between them.
pub(super) fn two_squares(side: f64) -> Mesh {
    grid(2, 1, |i, j| [side * f64::from(i), side * f64::from(j), 0.1 * f64::from(i * i)])
}

#[test]
fn a_panel_that_fits_without_its_tabs_is_laid_without_the_tab_that_would_not_fit() {
    // Two squares of 188 mm on sheets with room for 190.
    let mesh = two_squares(9.4);
    let own = BuildSettings { scale: 50.0, sheet: [200.0; 2], ..settings(Pieces::Nets) };
    let report = build(&mesh, &own).report();
    assert_eq!((report.placed, report.too_large), (2, Vec::new()));
    assert_eq!(report.paper.unwrap().without_tab, ["P0/P1"]);
    // With a little more room one of both has it.
    let report = build(&mesh, &BuildSettings { sheet: [210.0; 2], ..own }).report();
    assert_eq!((report.placed, report.paper.unwrap().tabs), (2, 1));
}
