//! The build check: failures, their worst location, and suggestions.

use super::beams::cube;
use super::build;
use super::identities::revolution;
use crate::support::grid::grid;
use shape_up::fabricate::offset::closings;
use shape_up::fabricate::{AdvisedValue, BuildCard, CheckRow, PanelSurface, SettingValue, Worst};
use shape_up::math::{Vec3, cosine, sine};
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, CheckLimits, OffsetKind};

/// Quads that are neither flat nor circular.
fn wavy() -> Mesh {
    grid(8, 8, |i, j| {
        let (x, y) = (f64::from(i), f64::from(j));
        [x, y, 0.05 * x * x + 0.02 * x * y * (1.0 + 0.1 * y) + 0.2 * f64::from((7 * i + 5 * j) % 4)]
    })
}

fn row(rows: &[CheckRow], id: &str) -> CheckRow {
    rows.iter().find(|row| row.id == id).unwrap().clone()
}

#[test]
fn what_fails_is_listed_and_the_worst_of_it_is_named() {
    let own = BuildSettings { kind: Some(OffsetKind::Corner), ..BuildSettings::default() };
    let made = build(&wavy(), &own);
    let check = made.card().check;
    let failed = made.failed();
    let flatness = row(&check, "panel_flatness");
    assert_eq!(flatness.met, Some(false));
    assert_eq!(flatness.failed, failed.panels.len());
    let Worst::Panel(worst) = flatness.worst else { panic!("{:?}", flatness.worst) };
    assert!(failed.panels.contains(&worst));
    let flat = |f: u32| made.flat[f as usize].as_ref().unwrap().flatness;
    assert!((1000.0 * flat(worst) - flatness.value.unwrap()).abs() < 1e-12);
    for f in 0..made.flat.len() as u32 {
        assert_eq!(failed.panels.contains(&f), 1000.0 * flat(f) > flatness.limit.unwrap());
    }
    let warp = row(&check, "beam_warp");
    let Worst::Edge(ends) = warp.worst else { panic!("{:?}", warp.worst) };
    let edge = made.surface.edges.iter().position(|edge| edge.ends == ends).unwrap();
    let (_, found) = made.offset.as_ref().unwrap();
    assert!((1000.0 * found.beams[edge].warp - warp.value.unwrap()).abs() < 1e-12);

    // With limits that are never reached nothing fails.
    let limits = CheckLimits { warp: 1e9, distance: 1e9, lean: 180.0, flatness: 1e9, part: 0.0 };
    let made = build(&wavy(), &BuildSettings { limits, ..own });
    assert_eq!(made.failed(), shape_up::fabricate::Failed::default());
    assert!(made.card().tighten.suggestions.is_empty());
}

#[test]
fn a_limit_of_0_is_suggested_as_what_meets_it_and_not_as_0() {
    let limits = CheckLimits { warp: 0.0, distance: 0.0, flatness: 0.0, lean: 20.0, part: 0.0 };
    let tighten =
        build(&wavy(), &BuildSettings { limits, ..BuildSettings::default() }).card().tighten;
    assert!(tighten.suggestions.len() == 2, "{tighten:?}");
    // A scene refuses a tolerance of 0.
    assert!(tighten.suggestions.iter().all(|one| one.within > 0.0), "{tighten:?}");
}

#[test]
fn no_lean_is_judged_where_all_nodes_are_at_the_rim() {
    let strip = grid(6, 1, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * i)]);
    let lean = row(&build(&strip, &BuildSettings::default()).card().check, "lean");
    assert_eq!((lean.value, lean.met, lean.failed), (None, None, 0));
}

#[test]
fn the_lean_that_is_judged_is_that_of_an_inner_node() {
    let made = build(&wavy(), &BuildSettings::default());
    let lean = row(&made.card().check, "lean");
    let (axes, _) = made.offset.as_ref().unwrap();
    let angle = |v: usize| {
        let (axis, normal) = (axes.axes[v], made.surface.normals[v]);
        libm::atan2(axis.cross(normal).length(), axis.dot(normal)).to_degrees()
    };
    let Worst::Vertex(worst) = lean.worst else { panic!("{:?}", lean.worst) };
    let on_rim = |v: u32| made.surface.edges.iter().any(|e| e.is_rim() && e.ends.contains(&v));
    assert!(!on_rim(worst));
    assert!((angle(worst as usize) - lean.value.unwrap()).abs() < 1e-9);
    assert!(
        (0..axes.axes.len()).any(|v| angle(v) > lean.value.unwrap()),
        "one of the rim is larger"
    );
}

#[test]
fn past_the_safe_distance_the_edges_that_turn_round_fail() {
    let far = |distance| BuildSettings { distance: Some(distance), ..BuildSettings::default() };
    let mesh = revolution(9, 7);
    let safe = build(&mesh, &far(-0.1)).card().offset.unwrap().safe_distance_mm[0].unwrap();
    for (part, turned) in [(0.999, false), (1.001, true)] {
        let made = build(&mesh, &far(1e-3 * part * safe));
        let check = row(&made.card().check, "safe_distance");
        assert_eq!((check.met, check.failed > 0), (Some(!turned), turned));
        let (axes, layer) = (&made.offset.as_ref().unwrap().0, made.layer().unwrap());
        for (e, edge) in (0..).zip(&made.surface.edges) {
            let [a, b] = edge.ends.map(|v| Vec3::from(layer[v as usize]));
            let turns = (b - a).dot(made.surface.direction(edge)) < 0.0;
            assert!(!turns || made.failed().edges.contains(&e), "{e} {:?}", axes.kind);
        }
    }
}

#[test]
fn moving_the_layer_gives_the_check_of_that_distance() {
    let own = |distance| BuildSettings {
        kind: Some(OffsetKind::Corner),
        distance: Some(distance),
        ..BuildSettings::default()
    };
    let mut moved = build(&wavy(), &own(0.1));
    moved.move_layer(0.35);
    let direct = build(&wavy(), &own(0.35));
    assert_eq!(moved.report(), direct.report());
    assert_eq!(moved.layer(), direct.layer());
}

#[test]
fn circles_are_asked_for_where_corners_keep_the_distance_and_planes_for_flatness() {
    let kinds = |kind| {
        let own = BuildSettings { kind, ..BuildSettings::default() };
        let tighten = build(&wavy(), &own).card().tighten;
        tighten.suggestions.into_iter().map(|one| one.constraint).collect::<Vec<_>>()
    };
    assert_eq!(kinds(None), ["circle", "plane"]);
    assert_eq!(kinds(Some(OffsetKind::Corner)), ["circle", "plane"]);
    assert_eq!(kinds(Some(OffsetKind::Face)), ["plane"]);
    let all_met = build(&revolution(9, 7), &BuildSettings::default()).report();
    assert!(all_met.card.tighten.suggestions.is_empty());
}

/// What is said where no constraint is suggested.
fn otherwise(mesh: &Mesh, own: &BuildSettings) -> String {
    let tighten = build(mesh, own).card().tighten;
    assert!(tighten.suggestions.is_empty(), "{tighten:?}");
    tighten.otherwise
}

#[test]
fn nothing_is_suggested_that_does_not_remove_the_reason() {
    let of = |kind| BuildSettings { kind, ..BuildSettings::default() };
    // Triangles are circular and flat, and axes do not close around them.
    let wavy = wavy();
    let mut triangles = Mesh { positions: wavy.positions.clone(), ..Mesh::default() };
    for face in wavy.faces.iter() {
        triangles.faces.push(&face[..3]);
        triangles.faces.push(&[face[2], face[3], face[0]]);
    }
    for kind in [None, Some(OffsetKind::Face), Some(OffsetKind::Corner)] {
        let words = otherwise(&triangles, &of(kind));
        assert!(words.starts_with("No constraint on panels makes the offset exact: "), "{words}");
    }
    // Exact axes do not follow the surface, however upright they are asked for.
    let mut low = cube();
    low.positions.iter_mut().for_each(|[x, y, _]| (*x, *y) = (10.0 * *x, 10.0 * *y));
    let words = otherwise(&low, &of(Some(OffsetKind::Face)));
    assert!(words.starts_with("The offset is exact"), "{words}");
    let words = otherwise(&crate::support::grid::wall_on_floor(), &of(None));
    assert_eq!(words, "Every number that is available is within its limit.");
}

#[test]
fn what_is_advised_to_be_set_is_a_value_that_helps() {
    let own = |distance| BuildSettings { distance: Some(distance), ..BuildSettings::default() };
    let far = build(&revolution(9, 7), &own(-50.0)).card();
    let missed = |card: &BuildCard| {
        card.check.iter().any(|row| row.id == "safe_distance" && row.met == Some(false))
    };
    assert!(missed(&far));
    if let Some(AdvisedValue { setting, value: Some(SettingValue::Number(value)), .. }) =
        far.tighten.change
    {
        assert_eq!(setting, "distance");
        assert!(value < 0.0 && !missed(&build(&revolution(9, 7), &own(value)).card()), "{value}");
    } else {
        panic!("no distance is advised: {:?}", far.tighten);
    }
    // What is within its limits needs no change.
    assert_eq!(build(&revolution(9, 7), &BuildSettings::default()).card().tighten.change, None);
}

/// The mesh `one`, and `other` beside it.
fn beside(one: &Mesh, other: &Mesh) -> Mesh {
    let (mut mesh, first) = (one.clone(), one.positions.len() as u32);
    mesh.positions.extend(other.positions.iter().map(|[x, y, z]| [x + 20.0, *y, *z]));
    for face in other.faces.iter() {
        mesh.faces.push(&face.iter().map(|v| v + first).collect::<Vec<_>>());
    }
    mesh
}

#[test]
fn circles_are_suggested_unless_another_part_cannot_be_exact_either_way() {
    let wavy = wavy();
    let split = |positions: &[[f64; 3]]| {
        let mut mesh = Mesh { positions: positions.to_vec(), ..Mesh::default() };
        for face in wavy.faces.iter() {
            mesh.faces.push(&face[..3]);
            mesh.faces.push(&[face[2], face[3], face[0]]);
        }
        mesh
    };
    let own = BuildSettings { kind: Some(OffsetKind::Corner), ..BuildSettings::default() };
    // Circles remove the reason from the quads only.
    let flat: Vec<_> = wavy.positions.iter().map(|[x, y, _]| [*x, *y, 0.0]).collect();
    let [curved, flat] = [split(&wavy.positions), split(&flat)];
    for mesh in [beside(&wavy, &curved), beside(&curved, &wavy)] {
        let limits = CheckLimits { flatness: 1e9, ..CheckLimits::default() };
        let words = otherwise(&mesh, &BuildSettings { limits, ..own.clone() });
        assert!(words.contains("that have an odd number of edges"), "{words}");
    }
    // Axes close around triangles in one plane.
    for mesh in [beside(&wavy, &flat), beside(&flat, &wavy)] {
        let tighten = build(&mesh, &own).card().tighten;
        assert_eq!(tighten.suggestions.first().map(|one| one.constraint), Some("circle"));
    }
}

#[test]
fn sides_that_fail_are_on_the_sheet_with_their_panel() {
    let limits = CheckLimits { warp: 0.1, lean: 5.0, ..CheckLimits::default() };
    let made = build(&wavy(), &BuildSettings { limits, ..BuildSettings::default() });
    let failed = made.failed();
    assert!(!failed.edges.is_empty() && !failed.nodes.is_empty(), "{failed:?}");
    let sides: usize =
        made.failed_sides(&failed).iter().flatten().filter(|line| line.len() == 2).count();
    let panels = |&e: &u32| made.surface.edges[e as usize].panels.iter().flatten().count();
    assert_eq!(sides, failed.edges.iter().map(panels).sum::<usize>());
    for (sheet, lines) in made.layout.sheets.iter().zip(made.failed_sides(&failed)) {
        let corners: Vec<[f64; 2]> = sheet
            .places
            .iter()
            .flat_map(|place| {
                made.cut[place.part].as_ref().unwrap().whole.iter().map(|&p| place.to_sheet(p))
            })
            .collect();
        let near = |p: &[f64; 2]| {
            corners.iter().any(|q| (p[0] - q[0]).abs().max((p[1] - q[1]).abs()) < 1e-9)
        };
        assert!(lines.iter().flatten().all(near));
    }
}

#[test]
fn circles_are_asked_for_although_one_quad_is_split() {
    let wavy = wavy();
    let mut split = Mesh { positions: wavy.positions.clone(), ..Mesh::default() };
    for (face, f) in wavy.faces.iter().zip(0..) {
        let halves = [&face[..3], &[face[2], face[3], face[0]]];
        let pieces: &[&[u32]] = if f == 20 { &halves } else { &[face] };
        pieces.iter().for_each(|piece| split.faces.push(piece));
    }
    let flat = CheckLimits { flatness: 1e9, ..CheckLimits::default() };
    for limits in [CheckLimits::default(), flat] {
        let own =
            BuildSettings { kind: Some(OffsetKind::Corner), limits, ..BuildSettings::default() };
        let tighten = build(&split, &own).card().tighten;
        assert_eq!(tighten.suggestions.first().map(|one| one.constraint), Some("circle"));
    }
}

/// Why the offset of this kind is not exact.
fn why_not(mesh: &Mesh, kind: OffsetKind) -> String {
    let made = build(mesh, &BuildSettings { kind: Some(kind), ..BuildSettings::default() });
    made.card().offset.unwrap().why_not
}

#[test]
fn panels_that_are_not_flat_are_the_reason_where_three_planes_touch_a_cone_anyway() {
    let mut bent = cube();
    bent.positions[7] = [1.3, 1.2, 1.1];
    let why = why_not(&bent, OffsetKind::Face);
    assert!(why.contains("not flat") && !why.contains("one point"), "{why}");
    let why = why_not(&wavy(), OffsetKind::Face);
    assert!(why.contains("one point") && !why.contains("not flat"), "{why}");
    // A U round a notch: at each vertex at most three panels meet, and do so in one point. The ends of
    // the bottom of the notch are held by three panels each.
    let height = |i: u32, j: u32| [0.0, 0.3, -0.2, 0.5][i as usize] + [0.0, 0.1, 0.8][j as usize];
    let whole = grid(3, 2, |i, j| [f64::from(i), f64::from(j), height(i, j)]);
    let mut notched = Mesh { positions: whole.positions.clone(), ..Mesh::default() };
    whole
        .faces
        .iter()
        .enumerate()
        .filter(|(f, _)| *f != 4)
        .for_each(|(_, face)| notched.faces.push(face));
    let why = why_not(&notched, OffsetKind::Face);
    assert!(why.contains("leave beam B") || why.contains("leave node N"), "{why}");
}

/// The numbers of all parts were compared at once, and a cube hid the openings of a ring.
#[test]
fn openings_through_a_part_are_found_whatever_the_other_parts_are() {
    // All quads of a torus, or those of a tube.
    let ring = |across: u32| {
        let mut mesh = grid(5, 3, |i, j| {
            let (turns, other) = (f64::from(i) / 6.0, f64::from(j) / 4.0);
            let radius = 3.0 + cosine(other);
            [radius * cosine(turns), radius * sine(turns), sine(other)]
        });
        let at = |i: u32, j: u32| i % 6 + 6 * (j % 4);
        let quads = (0..across).flat_map(|j| (0..6).map(move |i| (i, j)));
        let quads = quads.map(|(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        mesh.faces = quads.collect();
        mesh
    };
    let all = [(ring(4), true), (ring(3), true), (cube(), false), (revolution(9, 7), false)];
    for (mesh, has_openings) in all {
        for mesh in [beside(&mesh, &cube()), mesh] {
            let surface = PanelSurface::new(&mesh).unwrap();
            let found = closings(&surface);
            let has: Vec<bool> = found.parts.iter().map(|own| own.has_openings).collect();
            // The cube, if it is there, comes after the other part.
            assert_eq!(has[found.part_of[mesh.faces.row(0)[0] as usize] as usize], has_openings);
            let others = usize::from(has_openings);
            assert_eq!(has.iter().filter(|own| **own).count(), others, "{} parts", surface.parts);
        }
    }
}

#[test]
fn the_kind_that_meets_all_limits_is_the_default_whatever_the_size() {
    // Both kinds are exact but for rounding; axes of corners lean.
    for name in ["cases/pavilion.obj", "cases/pavilion_x07.obj"] {
        let Some(path) = crate::support::shared::path(name) else { return };
        let bytes = std::fs::read(path).unwrap();
        let mesh = shape_up::mesh::read(name, &bytes).unwrap().mesh;
        let report = build(&mesh, &BuildSettings::default()).report();
        assert_eq!(report.card.offset.unwrap().kind, OffsetKind::Face, "{name}");
        assert!(report.card.check.iter().all(|row| row.met == Some(true)), "{name}");
    }
    // Where both meet the limits exactly, it is that of panels at every size.
    for size in [0.1, 0.3, 0.7, 1.0, 3.0] {
        let mut mesh = revolution(9, 7);
        mesh.positions.iter_mut().flatten().for_each(|x| *x *= size);
        let report = build(&mesh, &BuildSettings::default()).report();
        assert_eq!(report.card.offset.unwrap().kind, OffsetKind::Face, "{size}");
    }
}

#[test]
fn what_is_exact_but_for_rounding_meets_limits_of_0() {
    let limits = CheckLimits { warp: 0.0, distance: 0.0, ..CheckLimits::default() };
    for kind in [OffsetKind::Face, OffsetKind::Corner] {
        let own = BuildSettings { kind: Some(kind), limits, ..BuildSettings::default() };
        let report = build(&revolution(9, 7), &own).report();
        assert!(report.card.offset.unwrap().exact, "{kind:?}");
        for id in ["beam_warp", "distance_error"] {
            let row = row(&report.card.check, id);
            assert_eq!((row.met, row.failed), (Some(true), 0), "{row:?}");
        }
    }
    let report = build(&wavy(), &BuildSettings { limits, ..BuildSettings::default() }).report();
    assert_eq!(row(&report.card.check, "beam_warp").met, Some(false));
}
