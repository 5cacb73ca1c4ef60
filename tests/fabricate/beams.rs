//! Fins, prisms and nodes.

use super::identities::revolution;
use super::{build, dxf, length, text_of};
use crate::support::grid::grid;
use shape_up::fabricate::beam::{EndCut, cut_back, end_cuts, node_types, nodes};
use shape_up::fabricate::sheet::{Inscription, NamePlace, label, strokes};
use shape_up::fabricate::{BUILD_NUMBERS, Build, BuildFile, PanelSurface, Stand};
use shape_up::math::Vec3;
use shape_up::math::plane::area;
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, OffsetKind, Product};
use shape_up::scene::{UnitsAndUp, Up};
use shape_up::words::LengthUnit;

fn settings() -> BuildSettings {
    BuildSettings {
        product: Product::Fins,
        kind: Some(OffsetKind::Face),
        distance: Some(0.2),
        scale: 10.0,
        thickness: 3.0,
        sheet: [600.0, 400.0],
        ..BuildSettings::default()
    }
}

pub(crate) fn cube() -> Mesh {
    let mut mesh = Mesh::default();
    let sign = |bit: u32| if bit == 0 { -1.0 } else { 1.0 };
    mesh.positions = (0..8).map(|v| [sign(v & 1), sign(v & 2), sign(v & 4)]).collect();
    for face in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    {
        mesh.faces.push(&face);
    }
    mesh
}

#[test]
fn fins_of_an_exact_offset_are_flat_and_as_long_as_the_nodes_leave_them() {
    for distance in [0.2, -0.15] {
        let made =
            build(&revolution(9, 7), &BuildSettings { distance: Some(distance), ..settings() });
        let frame = made.frame.as_ref().unwrap();
        assert_eq!(frame.fins.len(), made.surface.edges.len());
        let axes = &made.offset.as_ref().unwrap().0.axes;
        for (fin, edge) in frame.fins.iter().zip(&made.surface.edges) {
            let fin = fin.as_ref().unwrap();
            assert!(fin.flattening_error < 1e-9);
            let (t, length) = (made.surface.direction(edge), made.surface.length(edge));
            let slopes = edge.ends.map(|v| axes[v as usize].dot(t));
            let height = distance * (axes[edge.ends[0] as usize] - t * slopes[0]).length();
            // A trapezium between the two cuts.
            let base = length - fin.cut_back[0] - fin.cut_back[1];
            let top = base + distance * (slopes[1] - slopes[0]);
            let expected = 0.5 * (base + top) * height.abs();
            assert!((area(&fin.outline) - expected).abs() < 1e-9, "{}", area(&fin.outline));
        }
    }
}

#[test]
fn plates_of_a_node_touch_and_do_not_meet() {
    let made = build(&revolution(9, 7), &settings());
    let thickness = 0.03;
    for node in made.frame.as_ref().unwrap().nodes.iter().flatten() {
        let n = node.spokes.len();
        let across = |v: Vec3<f64>| v - node.axis * v.dot(node.axis);
        let mut least = f64::INFINITY;
        for k in 0..n {
            let own = across(node.spokes[k].along);
            let own = own * (1.0 / own.length());
            for other in [(k + 1) % n, (k + n - 1) % n].map(|k| across(node.spokes[k].along)) {
                if own.dot(other) < -0.99 * other.length() {
                    continue;
                }
                // Distance of the plate's corner on the side of the neighbour from the neighbour's
                // middle plane.
                let other = other * (1.0 / other.length());
                let side = node.axis.cross(own);
                let side = side * side.dot(other).signum();
                let corner = own * cut_back(node, k, thickness) + side * (0.5 * thickness);
                let off = (corner - other * corner.dot(other)).length();
                assert!(off >= 0.5 * thickness - 1e-12, "{off}");
                least = least.min(off);
            }
        }
        assert!(least - 0.5 * thickness < 1e-12 || n < 3, "no longer than needed: {least}");
    }
}

#[test]
fn mitres_of_neighbours_meet_in_planes_through_the_axis_and_edge_offsets_have_no_step() {
    let made = build(&cube(), &BuildSettings { kind: Some(OffsetKind::Edge), ..settings() });
    let frame = made.frame.as_ref().unwrap();
    assert!(frame.largest_step().unwrap().0 < 1e-12);
    for (node, cuts) in frame.nodes.iter().flatten().zip(&frame.cuts) {
        let n = cuts.len();
        for k in 0..n {
            let (left, right) = (cuts[k].corners[0], cuts[(k + 1) % n].corners[1]);
            assert!((left - right).length() < 1e-12 && left.dot(node.axis).abs() < 1e-12);
            assert!((cuts[k].mitre_deg[0] - 60.0).abs() < 1e-9, "three beams, 120 degrees apart");
        }
    }
}

#[test]
fn prisms_are_closed_flat_and_as_large_as_they_should_be() {
    let made = build(&revolution(9, 7), &BuildSettings { beam_width: Some(0.02), ..settings() });
    let frame = made.frame.as_ref().unwrap();
    let faces = shape_up::fabricate::beam::Prism::faces();
    for (prism, edge) in frame.prisms.iter().zip(&made.surface.edges) {
        let corners = prism.as_ref().unwrap().corners;
        let mut volume = 0.0;
        for face in &faces {
            let at = |k: usize| corners[face[k] as usize];
            let normal = (1..face.len() - 1)
                .map(|k| (at(k) - at(0)).cross(at(k + 1) - at(0)))
                .fold(Vec3::zero(), |sum, n| sum + n);
            let unit = normal * (1.0 / normal.length());
            for k in 1..face.len() {
                assert!((at(k) - at(0)).dot(unit).abs() < 1e-10);
            }
            volume += at(0).dot(normal) / 6.0;
        }
        let height = made.offset.as_ref().unwrap().1.edge_distance;
        let length = made.surface.length(edge);
        let (low, high) = (0.5 * length * 0.02 * height[0], 1.5 * length * 0.02 * height[1]);
        assert!(volume > low && volume < high, "{volume} {low} {high}");
    }
}

#[test]
fn nodes_of_a_surface_of_revolution_have_a_type_for_each_row_and_rim() {
    let made = build(&revolution(9, 7), &settings());
    let frame = made.frame.as_ref().unwrap();
    // Eight rings of nodes; on each, the inner ones are equal and the two end ones are mirror
    // images.
    assert_eq!(node_types(&frame.nodes, 1e-6, true).leaders.len(), 16);
    assert_eq!(node_types(&frame.nodes, 1e-6, false).leaders.len(), 24);
    let all = node_types(&frame.nodes, 360.0, false);
    assert_eq!(all.leaders.len(), 3, "two, three and four beams");
    assert_eq!(all.counts.iter().sum::<u32>(), 80);
    for node in frame.nodes.iter().flatten() {
        assert!((node.gaps_deg().sum::<f64>() - 360.0).abs() < 1e-9);
        let places = node.spokes.iter().map(|spoke| node.spoke_index(spoke.edge).unwrap());
        assert!(places.eq(0..node.spokes.len()));
    }
}

#[test]
fn fins_are_on_the_sheets_and_in_lists() {
    let made = build(&revolution(5, 4), &settings());
    let edges = made.surface.edges.len();
    let report = made.report();
    assert_eq!((report.parts, report.placed, report.not_cut.len()), (edges, edges, 0));
    let files = made.files(true);
    assert!(files.iter().all(|file| BuildFile::is_name_of_one(&file.name)));
    let outlines = files
        .iter()
        .filter(|file| file.name.ends_with(".dxf"))
        .flat_map(|file| dxf::polylines(std::str::from_utf8(&file.bytes).unwrap()))
        .filter(|line| line.is_closed);
    let sum: f64 = outlines.map(|line| area(&line.points)).sum();
    let expected: f64 = made.parts.iter().map(|part| area(&part.outline)).sum();
    assert!((sum - expected).abs() < 1e-6 * expected);
    let rows = |name: &str| text_of(&made, name).lines().count() - 1;
    assert_eq!((rows("fins.csv"), rows("beams.csv")), (edges, edges));
    assert_eq!(rows("node-beams.csv"), 2 * edges);
    let solids = text_of(&made, "beams.obj");
    assert_eq!(solids.lines().filter(|line| line.starts_with("g B")).count(), edges);
    let read = shape_up::mesh::read("beams.obj", solids.as_bytes()).unwrap();
    // Panels have their names, and each its own face.
    for (face, name) in (0..).zip(&made.names) {
        let own = read.mesh.groups.iter().find(|group| group.name == *name);
        assert_eq!(own.map(|group| &*group.faces), Some(&[face][..]), "{name}");
    }
    assert_eq!(read.mesh.faces.len(), 2 * made.surface.faces.len() + 8 * edges);
    for name in ["fins.csv", "beams.csv", "node-beams.csv", "node-types.csv", "beams.obj"] {
        assert!(!text_of(&made, name).contains("NaN"), "{name}");
    }
}

#[test]
fn beams_state_the_unit_and_the_up_axis_of_the_model() {
    let feet = LengthUnit::of("ft").unwrap();
    let made = Build::new(&revolution(5, 4), &settings(), feet, &Stand::default()).unwrap();
    for up in [Up::Y, Up::Z] {
        let files = made.files(up == Up::Z);
        let beams = files.iter().find(|file| file.name == "beams.obj").unwrap();
        let stated = UnitsAndUp::stated(&beams.bytes);
        assert_eq!(stated.units.as_deref(), Some("ft"));
        let read = shape_up::mesh::read("beams.obj", &beams.bytes).unwrap();
        assert_eq!(stated.up.unwrap_or_else(|| UnitsAndUp::guess_up(&read.mesh)), up);
    }
}

#[test]
fn what_is_no_fin_is_named_and_the_rest_is_cut() {
    let mut mesh = grid(3, 3, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * i)]);
    mesh.positions[6] = mesh.positions[5];
    let made = build(&mesh, &settings());
    let report = made.report();
    assert_eq!(report.not_cut, ["B5-6: its edge has no length"]);
    // It is no part that is missing, and no beam to saw.
    assert_eq!((report.placed + 1, report.parts), (report.edges, report.placed));
    let number = BUILD_NUMBERS.iter().position(|number| number.id == "sheets").unwrap();
    assert_eq!(made.numbers()[number], Some(report.sheets as f64));
    let saw_list = text_of(&made, "beams.csv");
    assert_eq!(saw_list.lines().count(), 1 + report.placed);
    // Plates as thick as the edges are long.
    let report = build(&mesh, &BuildSettings { thickness: 120.0, ..settings() }).report();
    assert!(report.not_cut.iter().any(|line| line.contains("it is cut away at its nodes")));
    assert!(!serde_json::to_string(&report).unwrap().contains("NaN"));
}

#[test]
fn the_cuts_of_a_beam_along_the_axis_of_its_node_are_numbers() {
    let mesh = grid(2, 2, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let surface = PanelSurface::new(&mesh).unwrap();
    let mut axes = vec![Vec3::new(0.0, 0.0, 1.0); 9];
    // Of the beam between the first two, the axes lie along it, or one does.
    for second in [Vec3::new(1.0, 0.0, 0.0), axes[1]] {
        (axes[0], axes[1]) = (Vec3::new(1.0, 0.0, 0.0), second);
        for node in nodes(&surface, &axes).iter().flatten() {
            for EndCut { mitre_deg, step, .. } in end_cuts(&surface, &axes, node, 0.1) {
                assert!(mitre_deg.iter().chain([&step]).all(|number| number.is_finite()));
            }
        }
    }
}

#[test]
fn fins_beyond_the_crossing_of_their_axes_are_not_said_to_be_cut_away_at_their_nodes() {
    // All axes of a cube with sides of 2 meet at its centre, and plates without thickness need no room.
    let own = BuildSettings { thickness: 0.0, ..settings() };
    let why = |distance| {
        let made = build(&cube(), &BuildSettings { distance: Some(distance), ..own.clone() });
        made.not_cut.iter().map(|not| not.why).collect::<Vec<_>>()
    };
    assert_eq!(why(-1.2), ["the axes of its nodes cross within its height"; 12]);
    assert_eq!(why(-0.9), [""; 0]);
    let thick = build(&cube(), &BuildSettings { thickness: 400.0, ..settings() });
    assert!(thick.not_cut[0].why.contains("cut away at its nodes"), "{:?}", thick.not_cut[0]);
}

#[test]
fn without_an_outside_there_are_no_fins_and_it_says_so() {
    let positions = [[0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [-1.0, 0.1, 0.0], [0.1, 1.0, 0.0]];
    let mut mesh = Mesh { positions: positions.to_vec(), ..Mesh::default() };
    [[0, 1, 2], [0, 1, 3], [0, 1, 4]].iter().for_each(|face| mesh.faces.push(face));
    let made = build(&mesh, &settings());
    assert!(made.parts.is_empty() && made.card().problems[0].contains("beams are not available"));
    let names: Vec<_> = made.files(true).into_iter().map(|file| file.name).collect();
    assert_eq!(names, ["edges.csv", "nodes.csv", "summary.csv", "model.glb"]);
}

#[test]
fn fins_have_a_hole_at_each_end_where_there_is_room() {
    let made = build(&cube(), &BuildSettings { hole: 5.0, ..settings() });
    let report = made.report();
    assert_eq!((report.holes, report.left_out.dropped_holes), (24, 0));
    for part in &made.parts {
        let [p, q] = [part.holes[0].centre, part.holes[1].centre];
        // More than half a metre apart at 1:10, on the middle line of the fin.
        assert!(length([p[0] - q[0], p[1] - q[1]]) > 50.0, "{}", part.name);
    }
    // One and a half diameters from the finished end, which is inside of what is cut.
    for kerf in [0.0, 2.0] {
        let made = build(&cube(), &BuildSettings { hole: 5.0, kerf, ..settings() });
        let part = &made.parts[0];
        for (hole, side) in part.holes.iter().zip([1, 3]) {
            let [p, q] = [side, side + 1].map(|k| part.outline[k % 4]);
            let along = [q[0] - p[0], q[1] - p[1]];
            let to = [hole.centre[0] - p[0], hole.centre[1] - p[1]];
            let away = (along[0] * to[1] - along[1] * to[0]) / length(along);
            assert!((away - 7.5 - 0.5 * kerf).abs() < 1e-9, "{kerf}: {away}");
        }
    }
    let none = build(&cube(), &BuildSettings { hole: 15.0, ..settings() }).report();
    assert_eq!((none.holes, none.left_out.dropped_holes), (0, 24));
}

#[test]
fn the_nodes_of_a_fin_are_named_beyond_the_holes_at_its_ends() {
    let of = |hole| {
        build(&revolution(9, 7), &BuildSettings { hole, scale: 8.0, distance: None, ..settings() })
    };
    let [plain, drilled] = [0.0, 2.0].map(of);
    assert!(drilled.parts.iter().all(|part| part.holes.len() == 2));
    assert_eq!([plain.left_out.small_names, drilled.left_out.small_names], [0, 0]);
    let letters = |name: &str| strokes(name, 1.0, [0.0; 2], [1.0, 0.0]).len();
    for part in plain.parts.iter().chain(&drilled.parts) {
        let nodes = part.name[1..].split('-').map(|node| letters(&format!("N{node}")));
        let expected = letters(&part.name) + nodes.sum::<usize>();
        assert!(part.engraved.len() >= expected, "{}: {expected}", part.name);
    }
    // What is drilled is no area of a part.
    let [whole, left] = [&plain, &drilled].map(|made| made.report().cut_area_mm2);
    let hole = 16.0 * shape_up::math::sine(1.0 / 32.0);
    let holes = drilled.report().holes as f64 * hole;
    assert!((whole - left - holes).abs() < 1e-6 * whole, "{whole} {left} {holes}");
}

#[test]
fn names_that_nobody_could_read_are_not_on_the_part() {
    let narrow = |width: f64, height: f64| {
        label(Inscription {
            outline: &[[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]],
            name: "B192-193",
            neighbours: &[None, Some("N193".to_owned()), None, Some("N192".to_owned())],
            bevels: &[],
            is_oriented: true,
            arrow: None,
            turn: [1.0, 0.0],
            holes: &[],
        })
    };
    // 2 mm, with room around them, need 3.4 mm.
    for (width, height) in [(4.0, 2.5), (4.0, 10.0), (40.0, 2.5), (40.0, 3.3)] {
        let found = narrow(width, height);
        assert_eq!((found.texts.len(), found.lines.len(), found.small), (0, 0, true));
    }
    let readable = narrow(40.0, 3.5);
    assert_eq!((&*readable.texts[0], readable.small), ("B192-193", false));
}

#[test]
fn a_short_fin_names_both_of_its_nodes_beside_its_long_name() {
    // A fin of the upper ring of a conical roof, in mm: there is no room for the node names between
    // its name and its ends.
    let outline = &[[0.0, 0.0], [25.99, 0.0], [24.65, 12.72], [1.34, 12.72]][..];
    let neighbours = &[None, Some("N193".to_owned()), None, Some("N192".to_owned())][..];
    for turn in [[1.0, 0.0], [-1.0, 0.0]] {
        let (name, arrow, holes) = ("B192-193", Some([0.0, -1.0]), &[][..]);
        let found = label(Inscription {
            outline,
            name,
            neighbours,
            bevels: &[],
            is_oriented: true,
            arrow,
            turn,
            holes,
        });
        assert_eq!((found.dropped, found.small, found.texts.len()), (0, false, 3));
    }
}

#[test]
fn sheets_are_counted_only_if_there_are_parts() {
    let sheets = |mesh: &Mesh| {
        let number = BUILD_NUMBERS.iter().position(|number| number.id == "sheets").unwrap();
        build(mesh, &settings()).numbers()[number]
    };
    assert_eq!(sheets(&cube()), Some(1.0));
    // A panel that is folded over leaves no offset, and no fins.
    let mut folded = grid(2, 2, |i, j| [f64::from(i), f64::from(j), 0.0]);
    folded.positions[4] = [3.0, 3.0, 0.0];
    assert_eq!(sheets(&folded), None);
}

#[test]
fn the_name_of_a_fin_says_how_it_lies_and_what_it_makes_needless_is_not_missed() {
    // Most are too narrow for the names of their nodes.
    let made = build(
        &revolution(9, 7),
        &BuildSettings { scale: 60.0, thickness: 0.5, distance: Some(0.12), ..settings() },
    );
    assert!(made.parts.len() > 100 && made.not_cut.is_empty());
    assert_eq!(made.left_out.dropped_names, 0);
    for part in made.parts.iter().filter(|part| part.named == NamePlace::OnPart) {
        let letters = strokes(&part.name, 1.0, [0.0; 2], [1.0, 0.0]);
        let [p, q] = [&part.engraved, &letters].map(|lines| {
            let last = &lines[letters.len() - 1];
            let [a, b] = [lines[0][0], last[last.len() - 1]];
            [b[0] - a[0], b[1] - a[1]]
        });
        // From the first node along the edge, which is the first side of the outline.
        let along = (p[0] * q[0] + p[1] * q[1]) / (length(p) * length(q));
        assert!(along > 0.9, "{}: {along}", part.name);
        let [a, b] = [part.outline[0], part.outline[1]];
        assert!(b[0] - a[0] > 0.99 * length([b[0] - a[0], b[1] - a[1]]), "{}", part.name);
    }
    // Rectangles, which may lie either way, are readable on their sheets.
    let made = build(&grid(5, 4, |i, j| [f64::from(i), 1.3 * f64::from(j), 0.0]), &settings());
    for place in made.layout.sheets.iter().flat_map(|sheet| &sheet.places) {
        assert!(place.turn[0] > 0.5 || place.turn[1] > 0.5, "{place:?}");
    }
}
