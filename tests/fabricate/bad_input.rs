//! Meshes that cannot be built completely: one sentence for each, and the parts that are possible.

use super::identities::revolution;
use super::{build, metres, text_of};
use crate::support::grid::grid;
use crate::support::long_or;
use crate::support::shared;
use shape_up::fabricate::panel::is_simple;
use shape_up::fabricate::{Build, Stand, unit_of};
use shape_up::math::{cosine, sine};
use shape_up::mesh::{Mesh, Ragged};
use shape_up::scene::{BuildSettings, Names, OffsetKind, Product};

pub(super) fn faces(faces: &[&[u32]], positions: &[[f64; 3]]) -> Mesh {
    let mut mesh = Mesh { positions: positions.to_vec(), ..Mesh::default() };
    faces.iter().for_each(|face| mesh.faces.push(face));
    mesh
}

#[test]
fn points_and_curves_have_no_panels() {
    let points = Mesh { positions: vec![[0.0; 3], [1.0; 3]], ..Mesh::default() };
    let mut curves = points.clone();
    curves.curves.push(&[0, 1]);
    let tets = Mesh { positions: vec![[0.0; 3]; 4], tets: vec![[0, 1, 2, 3]], ..Mesh::default() };
    let none = Mesh::default();
    for (mesh, what) in
        [(points, "points"), (curves, "curves"), (tets, "tetrahedra"), (none, "points")]
    {
        let fault =
            Build::new(&mesh, &BuildSettings::default(), metres(), &Stand::default()).unwrap_err();
        assert!(fault.0.contains(what) && fault.0.contains("expected"), "{fault}");
    }
}

#[test]
fn faces_that_run_the_other_way_are_turned() {
    let mesh = revolution(6, 4);
    let mut mixed = Mesh { faces: Ragged::new(), ..mesh.clone() };
    for (face, f) in mesh.faces.iter().zip(0..) {
        let own = face.iter().copied();
        let turned: Vec<u32> = if f % 5 == 2 { own.rev().collect() } else { own.collect() };
        mixed.faces.push(&turned);
    }
    let (own, found) =
        (build(&mesh, &BuildSettings::default()), build(&mixed, &BuildSettings::default()));
    assert_eq!((own.surface.turned, found.surface.turned), (0, 5));
    assert_eq!(found.card().offset.unwrap().kind, own.card().offset.unwrap().kind);
    assert!(found.faults.is_empty());
}

/// A strip of eight quads with one side.
fn moebius() -> Mesh {
    let n = 8;
    let mut mesh = grid(n, 1, |i, j| {
        let turns = f64::from(i) / f64::from(n);
        let (c, s) = (cosine(turns), sine(turns));
        let (d, u) = (cosine(0.5 * turns), sine(0.5 * turns));
        let w = f64::from(j) - 0.5;
        [(3.0 + w * d) * c, (3.0 + w * d) * s, w * u]
    });
    // Glues the last column to the first one, upside down: a Moebius strip.
    let mut faces = Ragged::new();
    for face in mesh.faces.iter() {
        let glued = |v: u32| match v {
            8 => 9,
            17 => 0,
            v => v,
        };
        faces.push(&face.iter().map(|&v| glued(v)).collect::<Vec<_>>());
    }
    mesh.faces = faces;
    mesh
}

#[test]
fn a_moebius_strip_is_cut_and_has_no_offset() {
    let made = build(&moebius(), &BuildSettings::default());
    assert_eq!(made.parts.len(), 8);
    assert!(
        made.offset.is_none() && made.faults[0].0.contains("one side only"),
        "{:?}",
        made.faults
    );
    assert!(made.card().check[0].value.is_none());
}

#[test]
fn panels_that_are_folded_over_leave_no_offset() {
    let mut mesh = grid(3, 3, |i, j| [f64::from(i), f64::from(j), 0.0]);
    // An inner vertex that is moved past its neighbour.
    mesh.positions[5] = [2.6, 2.5, 0.0];
    let made = build(&mesh, &BuildSettings::default());
    assert!(made.offset.is_none() && made.faults[0].0.contains("folded over"), "{:?}", made.faults);
    assert_eq!(made.parts.len(), 9);
    // By the name that it has on the sheets.
    let rows = build(&mesh, &BuildSettings { names: Names::Rows, ..BuildSettings::default() });
    assert!(rows.faults[0].0.contains(&rows.names[4]), "{:?} {:?}", rows.faults, rows.names);
}

#[test]
fn a_panel_that_crosses_itself_is_not_cut_and_named() {
    let bow = [[0.0; 3], [2.0, 0.0, 0.0], [0.5, 1.0, 0.0], [2.0, 1.0, 0.0]];
    let report = build(&faces(&[&[0, 1, 2, 3]], &bow), &BuildSettings::default()).report();
    assert_eq!(
        (report.placed, report.not_cut),
        (0, vec!["P0: laid flat it crosses itself".into()])
    );
}

#[test]
fn an_edge_of_three_panels_leaves_no_offset() {
    let positions = [[0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [-1.0, 0.1, 0.0], [0.1, 1.0, 0.0]];
    let mesh = faces(&[&[0, 1, 2], &[0, 1, 3], &[0, 1, 4]], &positions);
    let made = build(&mesh, &BuildSettings::default());
    assert!(made.offset.is_none() && made.faults[0].0.contains("more than two panels"));
    assert_eq!(made.parts.len(), 3);
}

#[test]
fn edges_and_panels_without_size_are_survived() {
    let mut mesh = grid(3, 3, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * i)]);
    mesh.positions[6] = mesh.positions[5];
    let made = build(&mesh, &BuildSettings { joint: 0.01, ..BuildSettings::default() });
    assert_eq!(made.names.len(), 9);
    let report = made.report();
    assert!(serde_json::to_string(&report).is_ok());
    // All vertices coincide.
    let flat = faces(&[&[0, 1, 2]], &[[1.0; 3]; 3]);
    let report = build(&flat, &BuildSettings::default()).report();
    assert_eq!((report.placed, report.not_cut.len(), report.sheets), (0, 1, 0));
}

#[test]
fn several_parts_and_triangles_are_built() {
    let mut mesh = grid(2, 2, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * j)]);
    let n = mesh.positions.len() as u32;
    mesh.positions.extend([[9.0, 0.0, 0.0], [10.0, 0.0, 0.0], [9.0, 1.0, 0.5], [50.0; 3]]);
    mesh.faces.push(&[n, n + 1, n + 2]);
    for kind in OffsetKind::ALL {
        let made = build(&mesh, &BuildSettings { kind: Some(kind), ..BuildSettings::default() });
        let report = made.report();
        assert_eq!((report.components, report.nodes, report.placed), (2, 12, 5));
        // A vertex without panels has no axis.
        let axes = &made.offset.as_ref().unwrap().0.axes;
        assert_eq!(<[f64; 3]>::from(axes[n as usize + 3]), [0.0; 3]);
    }
}

#[test]
fn settings_out_of_range_are_named() {
    let mesh = grid(1, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    for (settings, key) in [
        (BuildSettings { scale: 0.0, ..BuildSettings::default() }, "build.scale"),
        (BuildSettings { joint: f64::NAN, ..BuildSettings::default() }, "build.joint"),
        (BuildSettings { distance: Some(0.0), ..BuildSettings::default() }, "build.distance"),
        (BuildSettings { margin: 200.0, ..BuildSettings::default() }, "build.margin"),
    ] {
        let fault = Build::new(&mesh, &settings, metres(), &Stand::default()).unwrap_err();
        assert!(fault.0.starts_with(key) && fault.0.contains("expected"), "{fault}");
    }
}

#[test]
fn real_and_awkward_meshes_are_built_without_a_panic() {
    for folder in ["meshes", "meshes/awkward"] {
        let Some(path) = shared::path(folder) else { return };
        let files = std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path());
        for path in files.filter(|path| path.is_file()) {
            let bytes = std::fs::read(&path).unwrap();
            // The largest files take too long for what they test.
            if bytes.len() > long_or(150_000, 30_000) {
                continue;
            }
            let Ok(read) = shape_up::mesh::read(&path.to_string_lossy(), &bytes) else { continue };
            if shape_up::mesh::first_out_of_range(&read.mesh.positions).is_some() {
                continue;
            }
            let own = BuildSettings { kind: Some(OffsetKind::Face), ..BuildSettings::default() };
            if let Ok(made) = Build::new(&read.mesh, &own, metres(), &Stand::default()) {
                let text = serde_json::to_string(&made.report()).unwrap();
                assert!(!text.contains("NaN"), "{}", path.display());
                assert!(super::without_nan(&made));
            }
        }
    }
}

#[test]
fn panels_with_an_edge_without_length_are_cut_as_what_they_are() {
    // A quad with two coincident corners is a triangle, not an outline that crosses itself.
    let positions = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [2.0, 0.0, 0.0]];
    let made = build(&faces(&[&[0, 1, 2, 3], &[1, 4, 2]], &positions), &BuildSettings::default());
    assert_eq!(made.not_cut, []);
    assert_eq!(made.parts.iter().map(|part| part.outline.len()).collect::<Vec<_>>(), [3, 3]);
}

#[test]
fn sides_on_one_line_do_not_cross_despite_rounding() {
    // A rectangle with nine corners on each side, in many directions.
    for k in 0..40 {
        let (c, s) = (cosine(f64::from(k) / 77.0), sine(f64::from(k) / 77.0));
        let corner = |at: u32| {
            let share = f64::from(at % 10) / 10.0;
            let [x, y] = match at / 10 {
                0 => [0.9 * share, 0.0],
                1 => [0.9, 1.13 * share],
                2 => [0.9 * (1.0 - share), 1.13],
                _ => [0.0, 1.13 * (1.0 - share)],
            };
            [c * x - s * y, s * x + c * y]
        };
        assert!(is_simple(&(0..40).map(corner).collect::<Vec<_>>()), "{k}");
    }
}

#[test]
fn a_vertex_of_no_panel_far_away_costs_the_others_no_digits() {
    let mesh = revolution(6, 4);
    let mut stray = mesh.clone();
    stray.positions.push([1e7, -1e7, 0.0]);
    let own = build(&mesh, &BuildSettings::default()).surface;
    let mut found = build(&stray, &BuildSettings::default()).surface;
    assert_eq!(found.centre, own.centre);
    found.move_to(&stray.positions);
    assert_eq!(found.centre, own.centre);
}

#[test]
fn an_edge_of_three_panels_has_the_names_of_the_others_and_is_mentioned() {
    // Around the edge of vertices 0 and 1.
    let positions = [
        [0.0, 0.0, 0.0],
        [0.0, 8.0, 0.0],
        [6.0, 8.0, 0.0],
        [6.0, 0.0, 0.0],
        [-6.0, 0.0, 0.0],
        [-6.0, 8.0, 0.0],
        [0.0, 0.0, 6.0],
        [0.0, 8.0, 6.0],
    ];
    let mesh = faces(&[&[0, 3, 2, 1], &[0, 1, 5, 4], &[0, 1, 7, 6]], &positions);
    let settings = BuildSettings { hole: 3.0, ..BuildSettings::default() };
    let made = build(&mesh, &settings);
    let engraved = |build: &Build, k: usize| build.parts[k].engraved.len();
    // The name of each panel, and those of the two others.
    assert_eq!((made.left_out.dropped_names, made.left_out.dropped_holes), (0, 0));
    // However long the edge, no two of them lie opposite each other.
    let words = made.words(&made.report()).warnings;
    assert_eq!(words, ["6 holes are left out where panels do not meet one to one."]);
    assert!((0..3).all(|k| engraved(&made, k) > 5));
    let paper = build(&mesh, &BuildSettings { product: Product::Paper, ..settings });
    assert_eq!(paper.report().paper.unwrap().without_tab, ["P0/P1/P2"]);
    assert!((0..3).all(|k| engraved(&paper, k) > 5));
    let edges = text_of(&made, "edges.csv");
    assert!(edges.contains("B0-1,N0,N1,P1/P2,P0,"), "{edges}");
}

#[test]
fn both_panels_of_a_seam_of_a_one_sided_strip_have_a_name_there() {
    let mesh = moebius();
    let made = build(&mesh, &BuildSettings::default());
    assert!(made.surface.one_sided.is_some());
    let unpaired: Vec<_> = made.surface.unpaired().collect();
    let [(edge, panels)] = &unpaired[..] else { panic!("it has one seam") };
    let others = |f: u32| made.surface.others(*edge, f).collect::<Vec<_>>();
    assert_eq!((others(panels[0]), others(panels[1])), (vec![panels[1]], vec![panels[0]]));
    let paper =
        build(&mesh, &BuildSettings { product: Product::Paper, ..BuildSettings::default() });
    let [one, other] = [panels[0], panels[1]].map(|f| &*paper.names[f as usize]);
    let report = paper.report().paper.unwrap();
    assert_eq!(report.unpaired, [format!("{one}/{other}")]);
    assert!(report.without_tab.ends_with(&report.unpaired), "{:?}", report.without_tab);
}

#[test]
fn an_edge_without_length_has_no_holes() {
    // Two triangles of quads with two coincident corners, which share that side only.
    let positions = [
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [0.0, 4.0, 0.0],
        [8.0, 0.0, 0.0],
        [8.0, 4.0, 0.0],
    ];
    let mesh = faces(&[&[0, 1, 2, 3], &[2, 1, 4, 5]], &positions);
    let made = build(&mesh, &BuildSettings { hole: 3.0, ..BuildSettings::default() });
    assert_eq!(made.not_cut, []);
    assert!(made.parts.iter().all(|part| part.holes.is_empty()), "{:?}", made.parts[0].holes);
    assert_eq!(made.left_out.dropped_holes, 0);
}

#[test]
fn a_ridge_that_shrank_to_a_point_has_no_fold_and_no_beam() {
    // A steep hip roof. The slopes on both sides of its ridge are 117 degrees from each other.
    let [a, b] = [[0.0, 0.0, 1.6], [0.0, 0.0, 1.6]];
    let ground = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
    let positions = [a, b, ground[0], ground[1], ground[2], ground[3]];
    let roof = faces(&[&[2, 3, 1, 0], &[3, 4, 1], &[4, 5, 0, 1], &[5, 2, 0]], &positions);
    let (kind, product) = (Some(OffsetKind::Edge), Product::Fins);
    let own = BuildSettings { kind, product, thickness: 3.0, ..BuildSettings::default() };
    let made = build(&roof, &own);
    let report = made.report();
    let hip = made.surface.edges.iter().find_map(|edge| made.surface.fold(edge)).expect("a hip");
    let fold = report.fold_deg.expect("hips");
    assert!(fold.iter().all(|fold| (fold - hip.to_degrees()).abs() < 1e-9), "{fold:?}");
    assert!(report.no_least_joint == [""; 2] && report.least_joint_mm[1].is_some(), "{report:?}");
    // No beam has an end that stands on the point with another height than its hip.
    let offset = report.card.offset.expect("an outside");
    assert!(offset.exact && offset.distance_error_mm < 1e-3, "{offset:?}");
    assert_eq!(report.frame.expect("fins").without_prism, 0);
}

#[test]
fn the_largest_change_by_laying_flat_is_found_on_panels_of_any_number_of_corners() {
    // The rim of a saddle: neighbours and opposite corners hardly change their distance, corners a
    // quarter apart do.
    let saddle = |n: u32| {
        let corner = |k: u32| {
            let turns = f64::from(k) / f64::from(n);
            [cosine(turns), sine(turns), 0.1 * cosine(2.0 * turns)]
        };
        let positions: Vec<_> = (0..n).map(corner).collect();
        let all: Vec<u32> = (0..n).collect();
        build(&faces(&[&all], &positions), &BuildSettings::default()).report().flattening_error_mm
    };
    let expected = saddle(100);
    assert!(expected > 10.0, "{expected}");
    for n in [200, 400, 2000] {
        let found = saddle(n);
        assert!((found - expected).abs() < 1e-2 * expected, "{n}: {found} {expected}");
    }
}

#[test]
fn a_panel_that_cannot_be_cut_is_not_said_to_be_too_small_for_a_joint_that_is_none() {
    let mut mesh = Mesh::default();
    // A slit of half a millimetre.
    let outline = [
        [0.0, 0.0],
        [100.0, 0.0],
        [100.0, 50.0],
        [50.5, 50.0],
        [50.5, 10.0],
        [50.0, 10.0],
        [50.0, 50.0],
        [0.0, 50.0],
    ];
    mesh.positions = outline.map(|[x, y]| [0.001 * x, 0.001 * y, 0.0]).into();
    mesh.faces.push(&[0, 1, 2, 3, 4, 5, 6, 7]);
    let own = BuildSettings { scale: 1.0, ..BuildSettings::default() };
    let why = |own: BuildSettings| build(&mesh, &own).not_cut[0].why;
    let kerf = why(BuildSettings { kerf: 1.0, ..own.clone() });
    assert!(kerf.contains("kerf") && !kerf.contains("joint"), "{kerf}");
    let joint = why(BuildSettings { joint: 0.06, ..own.clone() });
    assert!(joint.contains("joint"), "{joint}");
    assert_eq!(build(&mesh, &own).not_cut, []);
}

#[test]
fn parts_too_small_to_be_cut_are_named_and_not_placed() {
    let mesh = super::beams::cube();
    for product in Product::ALL {
        let own = BuildSettings { product, scale: 1e6, thickness: 0.0, ..BuildSettings::default() };
        let report = build(&mesh, &own).report();
        assert_eq!((report.placed, report.sheets), (0, 0), "{product:?}");
        assert!(!report.not_cut.is_empty(), "{product:?}");
        assert!(report.not_cut.iter().all(|why| why.contains("small")), "{:?}", report.not_cut);
        // No sign of a sum of nothing.
        assert!(report.cut_area_mm2.is_sign_positive() && report.cut_length_mm.is_sign_positive());
        let larger = BuildSettings { scale: 1e3, ..own };
        assert_eq!(build(&mesh, &larger).report().not_cut, Vec::<String>::new(), "{product:?}");
    }
}

#[test]
fn faces_that_are_left_as_they_are_are_mentioned() {
    let mut mesh = grid(1, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    mesh.untouched.push(&[0, 1, 2, 0, 3, 1]);
    let made = build(&mesh, &BuildSettings::default());
    let report = made.report();
    assert_eq!((report.panels, report.placed), (1, 1));
    let said = |words: &[String]| words.iter().any(|words| words.contains("1 face has the same"));
    assert!(said(&report.card.problems), "{:?}", report.card.problems);
}

#[test]
fn a_closed_surface_that_faces_inwards_is_said_to_and_no_other() {
    let cube = super::beams::cube();
    let mut reversed = Mesh { faces: Ragged::new(), ..cube.clone() };
    cube.faces.iter().for_each(|face| {
        reversed.faces.push(&face.iter().rev().copied().collect::<Vec<_>>());
    });
    // A hollow cube: the smaller one faces the hole.
    let mut hollow = cube.clone();
    let inner = cube.positions.iter().map(|point| point.map(|x| 0.5 * x));
    hollow.positions.extend(inner);
    for face in reversed.faces.iter() {
        hollow.faces.push(&face.iter().map(|v| v + 8).collect::<Vec<_>>());
    }
    let mut open = Mesh { faces: Ragged::new(), ..reversed.clone() };
    reversed.faces.iter().skip(1).for_each(|face| open.faces.push(face));
    let two = reversed.clone();
    // A smaller cube beside it, which its volume alone does not show.
    let mut beside = hollow.clone();
    beside.positions[8..].iter_mut().for_each(|point| point[0] += 5.0);
    let all =
        [(cube, false), (reversed, true), (hollow.clone(), false), (open, false), (beside, true)];
    for (mesh, is_inside_out) in all {
        let problems = build(&mesh, &BuildSettings::default()).card().problems;
        assert_eq!(problems.iter().any(|words| words.contains("inwards")), is_inside_out);
    }
    // Two that both face inwards are turned by one press.
    let mut both = two.clone();
    both.positions.extend(two.positions.iter().map(|[x, y, z]| [x + 5.0, *y, *z]));
    for face in two.faces.iter() {
        both.faces.push(&face.iter().map(|v| v + 8).collect::<Vec<_>>());
    }
    // So is one beside a vertex that has no face.
    let mut stray = two.clone();
    stray.positions.push([9.0; 3]);
    // And a solid with a hole, inside out as a whole.
    let mut solid = hollow.clone();
    solid.faces =
        hollow.faces.iter().map(|face| face.iter().rev().copied().collect::<Vec<_>>()).collect();
    for mesh in [&both, &stray, &solid] {
        let problems = build(mesh, &BuildSettings::default()).card().problems;
        assert!(problems[0].ends_with("apply Flip faces, in Edit mesh."), "{problems:?}");
    }
    // An open part beside it, or a cube that faces outwards and shares a vertex with it, would be
    // flipped too.
    let mut roof = Mesh { faces: two.faces.clone(), ..both };
    roof.faces.push(&[8, 9, 11, 10]);
    let mut touching = two.clone();
    let corner = two.positions[0];
    let mirrored = two.positions.iter().map(|p| [0, 1, 2].map(|k| 2.0 * corner[k] - p[k]));
    touching.positions.extend(mirrored);
    for face in two.faces.iter() {
        let own = face.iter().map(|&v| if v == 0 { 0 } else { v + 8 });
        touching.faces.push(&own.collect::<Vec<_>>());
    }
    for mesh in [&roof, &touching] {
        let problems = build(mesh, &BuildSettings::default()).card().problems;
        let is_said = problems.iter().any(|words| words.contains("in the program that it comes"));
        assert!(is_said, "{problems:?}");
    }
}

#[test]
fn flat_layers_joined_at_their_rim_face_nowhere() {
    // In tilted planes, so that their volume is a rounding error, of either sign.
    let corners = [[0.0, 0.0], [1.1, 0.2], [1.3, 1.7], [-0.1, 0.9]];
    for tilt in 1..9 {
        let at = corners.map(|[x, y]| [x, y, 0.1 * f64::from(tilt) * x + 0.7 * y]);
        for [a, b, c, d] in [[0, 1, 2, 3], [3, 2, 1, 0]] {
            let mesh = faces(&[&[a, b, c], &[a, c, d], &[a, d, b], &[b, d, c]], &at);
            let problems = build(&mesh, &BuildSettings::default()).card().problems;
            assert!(!problems.iter().any(|words| words.contains("inwards")), "{problems:?}");
        }
    }
}

#[test]
fn parts_too_narrow_to_be_cut_are_named_and_not_placed() {
    // A row of quads with one of a thousandth of a millimetre in it, turned.
    let x = [0.0, 1.0, 1.0 + 2e-5, 2.0];
    let mesh = grid(3, 1, |i, j| {
        let (x, y) = (x[i as usize], f64::from(j));
        [0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, 0.1 * x]
    });
    for product in Product::ALL {
        let own =
            BuildSettings { product, scale: 20.0, thickness: 0.0, ..BuildSettings::default() };
        let report = build(&mesh, &own).report();
        let expected = if product == Product::Fins { 2 } else { 1 };
        assert_eq!(report.not_cut.len(), expected, "{product:?} {:?}", report.not_cut);
        assert!(report.not_cut.iter().all(|why| why.contains("narrow")), "{:?}", report.not_cut);
    }
}

#[test]
fn a_unit_that_is_not_known_is_no_metre() {
    assert_eq!(unit_of("in").map(|unit| unit.metres), Ok(0.0254));
    assert_eq!(unit_of("").map(|unit| unit.symbol), Ok("m"));
    for symbol in ["inches", "M", "km", " m"] {
        let fault = unit_of(symbol).unwrap_err();
        assert!(
            fault.0.contains(symbol) && fault.0.contains("m or cm or mm or ft or in"),
            "{fault}"
        );
    }
}
