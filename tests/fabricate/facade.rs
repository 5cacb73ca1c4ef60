//! What a facade asks for: panels with holes, their distance from the boundary of the model, strips over
//! the joints, and panels that bend more than their material takes.

use super::identities::revolution;
use super::{build, dxf, text_of, without_nan};
use crate::support::grid::grid;
use shape_up::fabricate::file::Drawing;
use shape_up::fabricate::sheet::Hole;
use shape_up::fabricate::{Build, CutPanel};
use shape_up::math::Vec3;
use shape_up::math::plane::{Point2, area, distance, is_inside};
use shape_up::mesh::{Mesh, Ragged};
use shape_up::scene::{BuildSettings, Product};

/// A wall of 4 by 3 m with a window, which is filled, and a door, which is not, and a panel beside it. The
/// wall is one face, over bridges.
fn wall() -> Mesh {
    let plan = [
        [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]],
        [[0.5, 1.0], [1.5, 1.0], [1.5, 2.0], [0.5, 2.0]],
        [[2.5, 0.5], [3.5, 0.5], [3.5, 2.5], [2.5, 2.5]],
        [[8.0, 0.0], [8.0, 3.0], [8.0, 4.0], [8.0, 4.0]],
    ];
    let positions = plan.concat().into_iter().map(|[x, y]| [x, y, 0.0]).collect();
    let faces = [[4, 5, 6, 7], [1, 12, 13, 2]].into_iter().collect();
    let untouched = [&WALL[..]].into_iter().collect();
    Mesh { positions, faces, untouched, ..Mesh::default() }
}

const WALL: [u32; 16] = [0, 1, 9, 8, 11, 10, 9, 1, 2, 3, 0, 4, 7, 6, 5, 4];

/// 1:20, with a joint of 1 mm on the sheet.
fn settings() -> BuildSettings {
    BuildSettings {
        scale: 20.0,
        joint: 0.02,
        kerf: 0.2,
        sheet: [600.0, 400.0],
        ..BuildSettings::default()
    }
}

fn openings(made: &Build, part: usize) -> Vec<&Hole> {
    made.parts[part].holes.iter().filter(|hole| hole.as_opening().is_some()).collect()
}

#[test]
fn a_face_with_holes_is_a_panel_with_holes_that_are_set_back_too() {
    let mut reversed = wall();
    reversed.untouched = [WALL.into_iter().rev().collect::<Vec<_>>()].iter().collect();
    for (mesh, turned) in [(wall(), 0), (reversed, 1)] {
        let made = build(&mesh, &settings());
        let report = made.report();
        assert_eq!((report.panels, report.placed, report.openings), (3, 3, 2));
        assert_eq!((report.not_cut, report.turned), (Vec::<String>::new(), turned));
        assert_eq!(report.card.problems, Vec::<String>::new());
        // Half the joint of 1 mm less half the kerf, out of the holes and into the outlines.
        let rectangle = |width: f64, height: f64| (width - 0.8) * (height - 0.8);
        let holes = [50.8 * 50.8, 50.8 * 100.8];
        let wall = rectangle(200.0, 150.0) - holes[0] - holes[1];
        let expected = [rectangle(50.0, 50.0), rectangle(200.0, 150.0), wall];
        for (part, expected) in made.parts.iter().zip(expected) {
            assert!((part.area() - expected).abs() < 1e-9, "{}: {}", part.name, part.area());
        }
        assert!((report.cut_area_mm2 - expected.iter().sum::<f64>()).abs() < 1e-9);
        let around = 4.0 * 49.2 + 2.0 * (2.0 * (199.2 + 149.2)) + 4.0 * 50.8 + 2.0 * (50.8 + 100.8);
        assert!((report.cut_length_mm - around).abs() < 1e-9, "{}", report.cut_length_mm);
        // The window and the wall name each other; the door has nothing.
        let found = openings(&made, 2);
        let beyond = |hole: &Hole| hole.neighbours.iter().flatten().cloned().collect::<Vec<_>>();
        let mut named: Vec<_> = found.iter().map(|hole| beyond(hole)).collect();
        named.sort();
        assert_eq!(named, [vec![], vec!["P0".to_owned(); 4]]);
        assert_eq!(made.parts[0].neighbours, vec![Some("P2".to_owned()); 4]);
        assert!(found.iter().all(|hole| area(&hole.outline()) > 0.0));
        assert!(without_nan(&made));
    }
}

#[test]
fn files_have_the_holes_and_no_bridges() {
    let made = build(&wall(), &settings());
    let lines = dxf::polylines(&text_of(&made, "sheet-01.dxf"));
    let mut holes: Vec<f64> = lines
        .iter()
        .filter(|line| line.layer == "HOLE" && line.is_closed)
        .map(|line| area(&line.points))
        .collect();
    holes.sort_by(f64::total_cmp);
    assert!((holes[0] - 50.8 * 50.8).abs() < 1e-3 && (holes[1] - 50.8 * 100.8).abs() < 1e-3);
    assert_eq!(holes.len(), 2);
    // Four sides of each, of which the panel beside it shares one.
    assert_eq!(text_of(&made, "edges.csv").lines().count(), 1 + 4 + 3 + 4 + 4);
    assert_eq!(made.report().edges, 15);
    let panels = text_of(&made, "panels.csv");
    let row = panels.lines().find(|row| row.starts_with("P2")).expect("it is there");
    assert!(
        row.contains(",12,") && row.contains("N0 N1 N2 N3 / N9 N8 N11 N10 / N4 N7 N6 N5"),
        "{row}"
    );
    let spatial = made.spatial_parts(true);
    let corners: Vec<usize> = spatial
        .iter()
        .filter(|own| own.layer == "Panels" && own.name == "P2")
        .map(|own| own.points.len())
        .collect();
    assert_eq!(corners, [4, 4, 4]);
    let surface = spatial.iter().find(|own| own.layer == "Surface").expect("it is there");
    let at = |v: u32| Vec3::from(surface.points[v as usize]);
    let filled = |own: &Vec<u32>| -> f64 {
        let [a, b] = [1, own.len() - 1].map(|k| at(own[k]) - at(own[0]));
        let c = at(own[own.len() / 2]) - at(own[0]);
        if own.len() == 3 {
            0.5 * a.cross(b).length()
        } else {
            0.5 * (a.cross(c) + c.cross(b)).length()
        }
    };
    let whole: f64 = surface.faces.iter().map(filled).sum();
    assert!((whole - (12.0 - 1.0 - 2.0 + 1.0 + 12.0)).abs() < 1e-9, "{whole}");
}

#[test]
fn the_panel_in_a_hole_is_named_at_its_sides_also_beside_reliefs_and_drilled_holes() {
    let mill = BuildSettings { kerf: 3.0, tool: 3.0, gap: 6.0, ..settings() };
    for own in [settings(), mill.clone(), BuildSettings { hole: 4.0, ..mill }] {
        let made = build(&wall(), &own);
        assert_eq!(made.left_out.dropped_names, 0, "{own:?}");
        // Letters on all sides of the window, outside of it.
        let window = made.cut[2].as_ref().expect("it is cut").whole[11..15].to_vec();
        for k in 0..4 {
            let [p, q] = [window[k], window[(k + 1) % 4]];
            let along = [0, 1].map(|x| (q[x] - p[x]) / distance(p, q));
            let is_beside = |at: Point2| {
                let [x, y] = [at[0] - p[0], at[1] - p[1]];
                let (far, away) = (along[0] * x + along[1] * y, along[0] * y - along[1] * x);
                (0.0..=distance(p, q)).contains(&far) && (0.0..12.0).contains(&away)
            };
            assert!(engraved(&made, 2).any(is_beside), "side {k}");
        }
    }
}

/// The lines on a part, as on its sheet.
fn engraved(made: &Build, part: usize) -> impl Iterator<Item = Point2> {
    made.parts[part].engraved.iter().flatten().copied()
}

#[test]
fn no_letter_is_in_a_hole_or_across_it() {
    // Also if nothing but a frame is left around the window.
    let mut frame = wall();
    for (v, at) in [[0.12, 0.12], [3.88, 0.12], [3.88, 2.88], [0.12, 2.88]].into_iter().enumerate()
    {
        frame.positions[4 + v] = [at[0], at[1], 0.0];
    }
    frame.untouched = [&[0, 1, 2, 3, 0, 4, 7, 6, 5, 4][..]].into_iter().collect();
    for mesh in [wall(), frame] {
        let made = build(&mesh, &BuildSettings { hole: 2.0, ..settings() });
        let part = &made.parts[2];
        assert_ne!(part.named.words(), "nowhere");
        assert!(engraved(&made, 2).count() > 4);
        for hole in openings(&made, 2) {
            let outline = hole.outline();
            let is_beside = |name: &str| part.named.words() == name;
            for line in &part.engraved {
                let on_part = line.iter().any(|&at| is_inside(&part.outline, at));
                assert!(on_part || is_beside("beside it"));
                assert!(!line.iter().any(|&at| is_inside(&outline, at)), "{:?}", part.name);
            }
            // Nor a drilled hole.
            for drilled in part.holes.iter().filter(|other| other.slot.is_none()) {
                assert!(!is_inside(&outline, drilled.centre));
                assert!(outline.iter().all(|&at| distance(at, drilled.centre) > 2.0));
            }
        }
    }
}

#[test]
fn parts_are_laid_beside_a_panel_with_holes_and_what_is_alone_is_built() {
    let made = build(&wall(), &settings());
    for sheet in &made.layout.sheets {
        let outlines: Vec<Vec<Point2>> = (sheet.places.iter())
            .map(|own| made.parts[own.part].outline.iter().map(|&p| own.to_sheet(p)).collect())
            .collect();
        for (k, one) in outlines.iter().enumerate() {
            let others = outlines.iter().enumerate().filter(|(other, _)| *other != k);
            others.for_each(|(_, other)| assert!(!one.iter().any(|&p| is_inside(other, p))));
        }
    }
    let alone = Mesh { faces: Ragged::new(), ..wall() };
    assert_eq!(build(&alone, &settings()).report().placed, 1);
}

#[test]
fn what_still_cannot_be_made_of_a_panel_with_holes_is_said() {
    // A joint as wide as what is between the door and the edge.
    let wide = build(&wall(), &BuildSettings { joint: 0.6, ..settings() });
    assert_eq!(wide.not_cut[0].part, "P2");
    assert!(wide.not_cut[0].why.contains("beside a hole"), "{:?}", wide.not_cut);
    let paper = build(&wall(), &BuildSettings { product: Product::Paper, ..settings() }).report();
    assert!(paper.not_cut.iter().any(|why| why.starts_with("P2: it has a hole")), "{paper:?}");
    // A hole that reaches over the outline.
    let mut beyond = wall();
    beyond.positions[7] = [-0.5, 2.0, 0.0];
    let made = build(&beyond, &settings());
    assert!(made.not_cut.iter().any(|not| not.part == "P2"), "{:?}", made.not_cut);
}

#[test]
fn pieces_of_a_panel_larger_than_the_sheet_have_its_holes() {
    let small = BuildSettings { sheet: [180.0, 180.0], splice: 12.0, ..settings() };
    let made = build(&wall(), &small);
    let cut = made.cut[2].as_ref().expect("it is cut");
    assert_eq!(cut.pieces, 2);
    let holes: Vec<usize> = cut.parts().map(|part| openings(&made, part).len()).collect();
    assert_eq!(holes, [1, 1]);
    // Every seam crosses a window that reaches from end to end: the panel is too large, and nothing is
    // advised that does not help.
    let mut long = wall();
    for (v, x) in [(4, 0.1), (5, 3.9), (6, 3.9), (7, 0.1)] {
        long.positions[v][0] = x;
    }
    long.untouched = [&[0, 1, 2, 3, 0, 4, 7, 6, 5, 4][..]].into_iter().collect();
    for splice in [0.0, 12.0] {
        let made = build(&long, &BuildSettings { splice, ..small.clone() });
        let report = made.report();
        assert!(report.too_large.contains(&"P2".to_owned()), "{:?}", report.too_large);
        let advice = made.words(&report).advice;
        assert!(advice.iter().all(|own| own.choices.iter().all(|one| one.setting != "splice")));
    }
}

#[test]
fn no_fin_runs_along_a_bridge() {
    let own = BuildSettings { product: Product::Fins, distance: Some(0.2), ..settings() };
    let made = build(&wall(), &own);
    assert_eq!((made.fins.len(), made.not_cut.len()), (15, 0), "{:?}", made.not_cut);
    let bridges = ["B1-9,", "B0-4,"];
    for table in ["fins.csv", "beams.csv", "edges.csv", "node-beams.csv"] {
        let text = text_of(&made, table);
        assert!(bridges.iter().all(|name| !text.contains(name)), "{table}");
    }
    // The faces of the model are there as they came.
    let obj = text_of(&made, "beams.obj");
    assert!(obj.lines().any(|line| line.starts_with("f ") && line.split(' ').count() == 17));
    let key: Vec<Drawing> = made.key(true);
    assert!(!key.is_empty());
}

#[test]
fn a_setback_moves_the_sides_at_the_boundary_and_no_others() {
    let mesh = grid(2, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let of = |setback| BuildSettings { setback, kerf: 0.0, ..settings() };
    let parts = |setback| build(&mesh, &of(setback)).parts;
    assert_eq!(parts(None), parts(Some(0.01)));
    for (setback, inner) in [(0.0, [49.5, 50.0]), (0.05, [47.0, 45.0])] {
        for part in parts(Some(setback)) {
            let found = area(&part.outline);
            assert!((found - inner[0] * inner[1]).abs() < 1e-9, "{setback}: {found}");
        }
    }
    // Around a hole with nothing in it, too: the door, and the window without its panel.
    let empty = Mesh { faces: [[1, 12, 13, 2]].into_iter().collect(), ..wall() };
    let made = build(&empty, &BuildSettings { setback: Some(0.1), ..of(None) });
    let mut found: Vec<f64> = openings(&made, 1).iter().map(|hole| area(&hole.outline())).collect();
    found.sort_by(f64::total_cmp);
    assert!((found[0] - 60.0 * 60.0).abs() < 1e-9 && (found[1] - 60.0 * 110.0).abs() < 1e-9);
}

#[test]
fn panels_of_one_type_are_cut_alike() {
    let mesh = grid(4, 4, |i, j| [f64::from(i), f64::from(j), 0.0]);
    // With half the joint at the boundary all are alike; else four corners, eight at one side, four inside.
    for (setback, mirror, counts) in [
        (None, false, vec![16]),
        (Some(0.01), false, vec![16]),
        (Some(0.1), false, vec![4, 8, 4]),
        (Some(0.1), true, vec![4, 8, 4]),
    ] {
        let made = build(&mesh, &BuildSettings { setback, mirror, kerf: 0.0, ..settings() });
        assert_eq!(made.types.counts, counts, "{setback:?}");
        for (kind, cut) in made.types.of.iter().zip(&made.cut) {
            let leader = made.types.leaders[kind.unwrap() as usize] as usize;
            let size = |cut: &CutPanel| area(&made.parts[cut.part].outline);
            let [own, first] = [cut, &made.cut[leader]].map(|cut| size(cut.as_ref().unwrap()));
            assert!((own - first).abs() < 1e-9, "{own} {first}");
        }
    }
    // Corners of a row of rectangles are set back at three sides, which half a turn puts on each other.
    let row = grid(3, 1, |i, j| [2.0 * f64::from(i), f64::from(j), 0.0]);
    let own = BuildSettings { setback: Some(0.1), ..settings() };
    assert_eq!(build(&row, &own).types.counts, [2, 1]);
}

#[test]
fn sides_in_line_are_set_back_alike() {
    // Beside a smaller panel, one side of the large one is half inner, half boundary.
    let positions =
        [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0], [0.0, 2.0], [3.0, 0.0], [3.0, 1.0]];
    let positions = positions.map(|[x, y]| [x, y, 0.0]).to_vec();
    let mut mesh = Mesh { positions, ..Mesh::default() };
    mesh.faces.push(&[0, 1, 2, 3, 4]);
    mesh.faces.push(&[1, 5, 6, 2]);
    let own = BuildSettings { setback: Some(0.1), kerf: 0.0, ..settings() };
    let made = build(&mesh, &own);
    assert_eq!(made.not_cut, []);
    // 0.1 m on all sides.
    assert!((area(&made.parts[0].outline) - 90.0 * 90.0).abs() < 1e-9);
}

#[test]
fn cover_strips_leave_room_for_each_other_at_nodes() {
    let flat = grid(3, 3, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let own = BuildSettings { scale: 10.0, strip: 50.0, ..BuildSettings::default() };
    let made = build(&flat, &own);
    let report = made.report();
    // Four between two inner nodes, eight from the boundary.
    assert_eq!((report.strips, report.dropped_strips), (12, 0));
    assert!((report.strip_length_mm - (4.0 * 50.0 + 8.0 * 75.0)).abs() < 1e-9);
    let table = text_of(&made, "strips.csv");
    assert_eq!(table.lines().count(), 13);
    assert!(
        table.lines().any(|row| row.starts_with("B5-6,N5,N6,") && row.contains(",50,50,25,25,0"))
    );
    assert!(made.words(&report).sheets.contains("12 cover strips"));
    // At 120 mm there is no room between two inner nodes.
    let wide = build(&flat, &BuildSettings { strip: 120.0, ..own.clone() });
    assert_eq!((wide.report().strips, wide.report().dropped_strips), (8, 4));
    let none = build(&flat, &BuildSettings { strip: 0.0, ..own });
    assert!(none.files(true).iter().all(|file| file.name != "strips.csv"));
}

#[test]
fn cover_strips_overlap_on_no_panel() {
    let own = BuildSettings { scale: 10.0, strip: 12.0, ..BuildSettings::default() };
    let mut pentagons = wall();
    pentagons.positions[2] = [4.5, 3.5, 0.0];
    for mesh in [revolution(9, 7), pentagons] {
        let made = build(&mesh, &own);
        let strips = made.strips();
        assert!(strips.iter().any(|own| own.length > 0.0));
        let model = made.mm_of_sheet();
        for f in 0..made.names.len() {
            let face = made.surface.faces.row(f);
            let corner = |k: usize| {
                made.flat[f].as_ref().expect("it has an area").corners[k % face.len()]
                    .map(|x| x * model)
            };
            // What lies on this panel of each strip: from `start` along a direction, and how long.
            let halves: Vec<(Point2, Point2, f64)> = (0..face.len())
                .filter_map(|k| {
                    let e = made.surface.sides.row(f)[k];
                    let own = strips.iter().find(|own| own.edge == e && own.length > 0.0)?;
                    let (p, q) = (corner(k), corner(k + 1));
                    let along = [0, 1].map(|x| (q[x] - p[x]) / distance(p, q));
                    let first = made.surface.edges[e as usize].ends[0] == face[k];
                    let back = own.cut_back[usize::from(!first)];
                    Some(([0, 1].map(|x| p[x] + back * along[x]), along, own.length))
                })
                .collect();
            let is_in = |point: Point2, (start, [c, s], length): (Point2, Point2, f64)| {
                let [x, y] = [point[0] - start[0], point[1] - start[1]];
                let (along, in_depth) = (c * x + s * y, c * y - s * x);
                along > 1e-6 && along < length - 1e-6 && in_depth > 1e-6 && in_depth < 6.0 - 1e-6
            };
            for (k, own) in halves.iter().enumerate() {
                let (start, [c, s], length) = *own;
                for (i, j) in (0..=20).flat_map(|i| (0..=10).map(move |j| (i, j))) {
                    let (x, y) = (length * f64::from(i) / 20.0, 0.6 * f64::from(j));
                    let point = [start[0] + c * x - s * y, start[1] + s * x + c * y];
                    let others = halves.iter().enumerate().filter(|(other, _)| *other != k);
                    others.for_each(|(_, other)| assert!(!is_in(point, *other), "panel {f}"));
                }
            }
        }
    }
}

/// Panels of a metre, all bent to a radius of 10 m.
fn saddle() -> Mesh {
    grid(4, 4, |i, j| {
        let [x, y] = [f64::from(i) - 2.0, f64::from(j) - 2.0];
        [x, y, 0.1 * x * y]
    })
}

fn glass(bend: f64) -> BuildSettings {
    BuildSettings {
        thickness: 10.0,
        scale: 1.0,
        sheet: [3210.0, 2250.0],
        joint: 0.02,
        bend,
        ..BuildSettings::default()
    }
}

#[test]
fn panels_bent_beyond_the_least_radius_are_cut_as_two_triangles() {
    let made = build(&saddle(), &glass(1500.0));
    let report = made.report();
    assert_eq!((report.panels, report.halved, report.placed), (16, 16, 32));
    assert_eq!(report.not_cut, Vec::<String>::new());
    assert!(report.flattening_error_mm < 1e-9, "{}", report.flattening_error_mm);
    let names: Vec<&str> = made.parts.iter().map(|part| &*part.name).collect();
    assert_eq!((names[0], names[15], names[16], names[31]), ("P0.1", "P15.1", "P0.2", "P15.2"));
    let words = made.words(&report);
    assert!(
        words.warnings.iter().any(|words| words.starts_with("16 panels are cut as two triangles"))
    );
    assert!(words.sheets.starts_with("32 parts"), "{}", words.sheets);
    let order = made.order();
    // The triangles name each other, have a joint between them and are of the same face.
    for f in 0..16 {
        let [first, other] = [&made.parts[f], &made.parts[f + 16]];
        let has = |part: &shape_up::fabricate::sheet::CutPart, name: &str| {
            part.neighbours.iter().flatten().any(|own| own == name)
        };
        assert!(has(first, &other.name) && has(other, &first.name));
        assert_eq!([f as u32, f as u32 + 16].map(|panel| made.face_of(panel)), [Some(f as u32); 2]);
        // One after the other in the order of assembly.
        assert_eq!(order[f] + 1, order[f + 16]);
    }
    let inset = |[a, b, c]: [f64; 3]| {
        let s = 0.5 * (a + b + c);
        let whole = (s * (s - a) * (s - b) * (s - c)).sqrt();
        let radius = whole / s;
        whole * (1.0 - 10.0 / radius) * (1.0 - 10.0 / radius)
    };
    let at = |v: u32| made.surface.at(v);
    for (part, face) in made.parts.iter().zip(made.surface.faces.iter()) {
        let sides = [0, 1, 2].map(|k| 1000.0 * (at(face[(k + 1) % 3]) - at(face[k])).length());
        assert!((part.area() - inset(sides)).abs() < 1e-6 * part.area(), "{}", part.name);
    }
    let row = &report.card.check[4];
    assert!(row.met == Some(true) && row.value < Some(1e-9), "{row:?}");
    assert!(without_nan(&made));
}

#[test]
fn panels_bent_less_or_without_a_limit_stay_as_they_are() {
    let whole = build(&saddle(), &glass(0.0));
    for own in [
        glass(990.0),
        BuildSettings { thickness: 0.0, ..glass(1500.0) },
        // A tenth as thick, as for a model at 1:10.
        BuildSettings { thickness: 1.0, ..glass(1500.0) },
    ] {
        let made = build(&saddle(), &own);
        assert_eq!((made.halves.len(), &made.names), (0, &whole.names));
        assert_eq!(made.parts.len(), 16);
    }
    // At 1:10, 1 mm takes as much.
    let model = BuildSettings { thickness: 1.0, scale: 10.0, ..glass(1500.0) };
    assert_eq!(build(&saddle(), &model).halves.len(), 16);
    // Other products crease panels, or have none.
    for product in [Product::Fins, Product::Paper] {
        assert_eq!(build(&saddle(), &BuildSettings { product, ..glass(1500.0) }).halves.len(), 0);
    }
}

#[test]
fn triangles_and_panels_with_holes_are_told_apart() {
    let mut mesh = wall();
    mesh.positions[13][2] = 0.3;
    let made = build(&mesh, &BuildSettings { scale: 20.0, ..glass(1500.0) });
    let names: Vec<&str> = made.names.iter().map(|name| &**name).collect();
    assert_eq!(names, ["P0", "P1.1", "P1.2", "P2"]);
    let faces = [0, 1, 2, 3].map(|panel| made.face_of(panel));
    assert_eq!(faces, [Some(0), Some(1), Some(1), None]);
    assert!(made.surface.has_holes(3) && !made.surface.has_holes(2));
    assert_eq!(made.report().panels, 3);
}
