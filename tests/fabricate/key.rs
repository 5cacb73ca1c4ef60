//! Key drawings: every part has its name where it is.

use super::identities::revolution;
use super::{build, metres, text_of};
use crate::support::grid::grid;
use shape_up::fabricate::file::Drawing;
use shape_up::fabricate::sheet::{Role, strokes, text_width};
use shape_up::fabricate::{Build, Stand};
use shape_up::math::plane::{area, bounds, distance, is_inside};
use shape_up::mesh::{Mesh, Ragged};
use shape_up::scene::{BuildSettings, Names, Product};
use std::collections::{BTreeMap, BTreeSet};

/// The names in a drawing, each with the middle of its letters.
fn names(drawing: &Drawing) -> Vec<(String, [f64; 2])> {
    let letters: Vec<_> = drawing.lines.iter().filter(|line| line.role == Role::Engrave).collect();
    let names = letters.chunk_by(|a, b| a.part == b.part).map(|lines| {
        let points = || lines.iter().flat_map(|line| &line.points);
        let middle = [0, 1].map(|k| {
            let low = points().map(|point| point[k]).fold(f64::INFINITY, f64::min);
            let high = points().map(|point| point[k]).fold(f64::NEG_INFINITY, f64::max);
            0.5 * (low + high)
        });
        (lines[0].part.clone(), middle)
    });
    names.collect()
}

fn all_names(drawings: &[Drawing]) -> BTreeSet<String> {
    drawings.iter().flat_map(names).map(|(name, _)| name).collect()
}

/// A box of six quads with these corners.
fn cuboid(low: f64, high: f64) -> Mesh {
    let positions = (0..8).map(|k| [k & 1, k >> 1 & 1, k >> 2].map(|at| [low, high][at])).collect();
    let faces: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    Mesh { positions, faces: faces.iter().map(|face| &face[..]).collect(), ..Mesh::default() }
}

#[test]
fn a_roof_is_seen_from_above_and_from_a_side_with_each_name_on_its_panel() {
    let mesh = grid(6, 4, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * j)]);
    let made = build(&mesh, &BuildSettings::default());
    let key = made.key(true);
    let [drawing, side, unrolled] = &key[..] else { panic!("{} drawings", key.len()) };
    assert_eq!(drawing.title, "KEY 1/3, NOT TO BE CUT, SEEN FROM ABOVE");
    // It rises to one corner, and faces the other.
    assert_eq!(side.title, "KEY 2/3, NOT TO BE CUT, SEEN FROM -X -Y, ABOVE");
    assert_eq!(unrolled.title, "KEY 3/3, NOT TO BE CUT, UNROLLED BY ROWS, SEEN FROM OUTSIDE");
    assert!([side, unrolled].iter().all(|own| names(own).len() == mesh.faces.len()));
    let found = names(drawing);
    assert_eq!(found.len(), mesh.faces.len());
    // One scale and one offset take the middles of all panels to their names.
    let middle = |face: usize| -> [f64; 2] {
        let row = mesh.faces.row(face);
        std::array::from_fn(|k| {
            row.iter().map(|&v| mesh.positions[v as usize][k]).sum::<f64>() / 4.0
        })
    };
    let at = |name: &str| found.iter().find(|(own, _)| own == name).expect("it is there").1;
    let scale = (at("P1")[0] - at("P0")[0]) / (middle(1)[0] - middle(0)[0]);
    assert!(scale > 10.0);
    for (face, name) in made.names.iter().enumerate() {
        for k in 0..2 {
            let off = at(name)[k] - at("P0")[k] - scale * (middle(face)[k] - middle(0)[k]);
            // Letters are not centred in their cells.
            assert!(off.abs() < 0.2 * scale, "{name}: {off}");
        }
    }
    for line in &drawing.lines {
        assert!(line.role != Role::Cut && !line.closed, "it is not to be cut");
        let inside = |[x, y]: &[f64; 2]| {
            (0.0..=drawing.size[0]).contains(x) && (0.0..=drawing.size[1]).contains(y)
        };
        assert!(line.points.iter().all(inside));
    }
}

#[test]
fn what_is_not_seen_from_above_is_named_from_the_sides() {
    let made = build(&cuboid(0.0, 1.0), &BuildSettings::default());
    let key = made.key(true);
    assert_eq!(all_names(&key), made.names.iter().cloned().collect());
    // The bottom is seen from nowhere else; a wall is on the side that is named for it.
    assert_eq!(names(&key[0]).len(), 1);
    let from = |title: &str| {
        let drawing = key.iter().find(|drawing| drawing.title.ends_with(title));
        drawing.map(|drawing| all_names(std::slice::from_ref(drawing)))
    };
    assert_eq!(from("BELOW"), Some(BTreeSet::from(["P0".to_owned()])));
    let [east, west] = [("+X", "P5"), ("-X", "P4")];
    for (side, wall) in [east, west] {
        let views = key.iter().filter(|drawing| drawing.title.contains(side));
        for drawing in views {
            assert!(names(drawing).iter().any(|(name, _)| name == wall), "{}", drawing.title);
        }
    }
}

#[test]
fn what_is_hidden_from_all_sides_is_said() {
    let (mut mesh, inner) = (cuboid(0.0, 3.0), cuboid(1.0, 2.0));
    let faces: Vec<Vec<u32>> =
        inner.faces.iter().map(|face| face.iter().map(|v| v + 8).collect()).collect();
    mesh.positions.extend(inner.positions);
    mesh.faces = mesh.faces.iter().map(<[u32]>::to_vec).chain(faces).collect::<Ragged>();
    // Panels are on the last drawing, on which they are unrolled.
    let key = build(&mesh, &BuildSettings::default()).key(true);
    let views = all_names(&key[..key.len() - 1]);
    assert!(["P6", "P7", "P8", "P9", "P10", "P11"].iter().all(|own| !views.contains(*own)));
    assert_eq!((views.len(), all_names(&key).len()), (6, 12));
    assert!(key.iter().all(|own| !own.title.contains("WITHOUT")));
    // Fins are in no other.
    let fins = BuildSettings { product: Product::Fins, ..BuildSettings::default() };
    let made = build(&mesh, &fins);
    let key = made.key(true);
    let hidden = made.fins.len() + mesh.positions.len() - all_names(&key).len();
    assert!(hidden >= 20, "{hidden}");
    let said = format!(", WITHOUT {hidden} NAMES THAT NO VIEW SHOWS");
    assert!(key[0].title.ends_with(&said), "{}", key[0].title);
    // On every page, however narrow.
    for Drawing { lines, size: [width, _], .. } in &key {
        assert!(
            lines.iter().flat_map(|line| &line.points).all(|[x, _]| (0.0..=*width).contains(x))
        );
    }
}

/// The closed outlines of a drawing.
fn outlines(drawing: &Drawing) -> Vec<Vec<[f64; 2]>> {
    let lines = drawing.lines.iter().filter(|line| line.role == Role::Sheet);
    let closed = |points: &Vec<[f64; 2]>| points.len() > 3 && points.first() == points.last();
    let all = lines.map(|line| line.points.clone()).filter(closed);
    all.map(|points| points[1..].to_vec()).collect()
}

/// The unrolled panels by name, and millimetres per unit of the mesh.
fn unrolled(made: &Build) -> (BTreeMap<String, Vec<[f64; 2]>>, f64) {
    let drawing = made.key(true).pop().expect("there is a key");
    assert!(drawing.title.contains("UNROLLED BY ROWS"), "{}", drawing.title);
    let all = outlines(&drawing);
    let scale = {
        let drawn: f64 = all.iter().map(|own| area(own)).sum();
        let own: f64 = made.flat.iter().flatten().map(|own| area(&own.corners)).sum();
        (drawn / own).sqrt()
    };
    let on = |(name, at): (String, [f64; 2])| {
        let on: Vec<&Vec<[f64; 2]>> = all.iter().filter(|own| is_inside(own, at)).collect();
        assert_eq!(on.len(), 1, "{name} is on one panel, and no panel on another one");
        (name, on[0].clone())
    };
    (names(&drawing).into_iter().map(on).collect(), scale)
}

#[test]
fn the_shape_is_unrolled_row_above_row_with_each_panel_in_its_size() {
    for print_inside in [false, true] {
        let own =
            BuildSettings { names: Names::Assembly, print_inside, ..BuildSettings::default() };
        let made = build(&revolution(6, 5), &own);
        let (panels, scale) = unrolled(&made);
        assert_eq!(panels.len(), made.names.len());
        for (name, flat) in made.names.iter().zip(&made.flat) {
            let [own, drawn] = [area(&flat.as_ref().unwrap().corners), area(&panels[name])];
            // Counterclockwise as seen from outside; coordinates are rounded to hundredths.
            assert!((drawn / (scale * scale * own) - 1.0).abs() < 0.01, "{name}: {drawn}");
        }
        // The panels of a row hang together, to the right as they follow, and lie below those of the next.
        let mut below = 0.0;
        for row in &made.rows {
            let own: Vec<_> = row.iter().map(|&f| &panels[&made.names[f as usize]]).collect();
            for pair in own.windows(2) {
                let common = pair[0]
                    .iter()
                    .filter(|point| pair[1].iter().any(|other| distance(**point, *other) < 0.03));
                assert_eq!(common.count(), 2);
            }
            let [low, high] = bounds(own.into_iter().flatten().copied());
            assert!(low[1] > below);
            below = high[1];
        }
    }
}

#[test]
fn a_belt_of_triangles_is_unrolled_as_one_strip() {
    let mut mesh = revolution(6, 3);
    let halves = |face: &[u32]| [[face[0], face[1], face[2]], [face[2], face[3], face[0]]];
    mesh.faces = mesh.faces.iter().flat_map(halves).collect();
    let made = build(&mesh, &BuildSettings::default());
    let (panels, _) = unrolled(&made);
    assert_eq!(panels.len(), mesh.faces.len());
    let all: Vec<_> = panels.values().collect();
    let are_joined = |a: &Vec<[f64; 2]>, b: &Vec<[f64; 2]>| {
        let common =
            a.iter().filter(|point| b.iter().any(|other| distance(**point, *other) < 0.03));
        common.count() == 2
    };
    let pairs = (0..all.len()).flat_map(|k| (0..k).map(move |j| [j, k]));
    let joined = pairs.filter(|&[j, k]| are_joined(all[j], all[k])).count();
    // Each of the strips has one joint less than triangles.
    assert!(all.len() - joined <= 4, "{} {joined}", all.len());
}

#[test]
fn a_panel_too_small_for_the_page_of_the_others_is_named_on_a_larger_one() {
    // Quads of 1 m and one of 0.3 m beside them.
    let mut mesh = grid(20, 20, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let first = mesh.positions.len() as u32;
    let corners = [[0.0, 0.0], [0.3, 0.0], [0.3, 0.3], [0.0, 0.3]];
    mesh.positions.extend(corners.map(|[x, y]| [20.1 + x, y, 0.0]));
    mesh.faces.push(&[first, first + 1, first + 2, first + 3]);
    let key = build(&mesh, &BuildSettings::default()).key(true);
    let titles: Vec<&str> = key.iter().map(|drawing| &*drawing.title).collect();
    assert_eq!(titles, ["KEY 1/1, NOT TO BE CUT, SEEN FROM ABOVE"]);
    assert!(all_names(&key).contains("P400") && key[0].size[0] < 421.0);
}

#[test]
fn what_is_not_made_has_no_mark() {
    // Between two quads one without area, and so an edge without length.
    let x = [0.0, 1.0, 1.0, 2.0];
    let mesh = grid(3, 1, |i, j| [x[i as usize], f64::from(j), 0.0]);
    for product in [Product::Panels, Product::Fins, Product::Paper] {
        let made = build(&mesh, &BuildSettings { product, ..BuildSettings::default() });
        let key = made.key(true);
        assert!(!made.not_cut.is_empty(), "{product:?}");
        assert_eq!(key[0].title, "KEY 1/1, NOT TO BE CUT, SEEN FROM ABOVE");
    }
}

#[test]
fn a_panel_that_is_cut_along_its_crease_has_the_names_of_both_pieces() {
    let mesh = grid(1, 1, |i, j| [f64::from(i), f64::from(j), 0.3 * f64::from(i * j)]);
    // Each half fits on a sheet, and both do not.
    let sheet = [1600.0, 850.0];
    let settings = BuildSettings {
        product: Product::Paper,
        scale: 1.0,
        tab: 0.0,
        sheet,
        ..BuildSettings::default()
    };
    let made = build(&mesh, &settings);
    assert_eq!((made.parts.len(), made.layout.too_large.len()), (2, 0));
    assert_eq!(all_names(&made.key(true)), BTreeSet::from(["S1/S2".to_owned()]));
}

#[test]
fn beams_and_nodes_are_named_and_the_axes_are_those_of_the_file() {
    let settings = BuildSettings { product: Product::Fins, ..BuildSettings::default() };
    let made = Build::new(&revolution(5, 4), &settings, metres(), &Stand::default()).unwrap();
    for z_up in [true, false] {
        let key = made.key(z_up);
        let found = all_names(&key);
        let beams = found.iter().filter(|name| name.starts_with('B')).count();
        let nodes = found.iter().filter(|name| name.starts_with('N')).count();
        assert_eq!(beams + nodes, made.surface.edges.len() + made.surface.positions.len());
        let other = if z_up { "Z" } else { "Y" };
        assert!(key.iter().all(|drawing| !drawing.title.contains(&format!("+{other}"))));
    }
}

#[test]
fn a_piece_of_paper_is_named_on_each_of_its_panels() {
    let settings =
        BuildSettings { product: Product::Paper, scale: 50.0, ..BuildSettings::default() };
    let made = build(&revolution(6, 5), &settings);
    let pieces: BTreeSet<String> = made.parts.iter().map(|part| part.name.clone()).collect();
    let key = made.key(true);
    assert_eq!(all_names(&key), pieces);
    let files: Vec<String> = made.files(true).into_iter().map(|file| file.name).collect();
    assert!(files.contains(&"key.pdf".to_owned()) && files.contains(&"key-1.svg".to_owned()));
}

#[test]
fn a_sheet_says_which_side_is_seen_and_what_its_arrows_mean() {
    let mesh = grid(3, 2, |i, j| [f64::from(i), f64::from(j), 0.0]);
    for (product, print_inside, words) in [
        (Product::Panels, false, "SEEN FROM OUTSIDE, ARROW: UP, IF LEVEL TO THE TOP OF KEY 1"),
        (
            Product::Fins,
            false,
            "FIN NAMES READ FROM FIRST TO SECOND NODE, OUTSIDE UP, MODEL EDGE AT THE BOTTOM, ARROW: TO THE SIDE AT THE EDGE OF THE MODEL",
        ),
        (Product::Paper, false, "SEEN FROM OUTSIDE"),
        (Product::Paper, true, "SEEN FROM INSIDE, MIRRORED"),
        (
            Product::Panels,
            true,
            "SEEN FROM INSIDE, MIRRORED, ARROW: UP, IF LEVEL TO THE TOP OF KEY 1",
        ),
    ] {
        let settings = BuildSettings { product, print_inside, ..BuildSettings::default() };
        let [_, height] = settings.sheet;
        let middle = 5.0 + 0.5 * text_width(words, 2.5);
        let drawings = build(&mesh, &settings).drawings();
        for letter in strokes(words, 2.5, [middle, height - 2.5], [1.0, 0.0]) {
            assert!(drawings[0].lines.iter().any(|line| line.points == letter), "{words}");
        }
    }
}

#[test]
fn a_legend_without_room_on_the_sheets_is_said_to_be_in_the_summary() {
    let mesh = grid(3, 2, |i, j| [f64::from(i), f64::from(j), 0.0]);
    for (margin, outlines_only, is_said) in
        [(5.0, false, false), (3.0, false, true), (3.0, true, false)]
    {
        let own = BuildSettings { margin, outlines_only, ..BuildSettings::default() };
        let made = build(&mesh, &own);
        let said = made.words(&made.report()).warnings.concat();
        assert_eq!(said.contains("no room for their legend"), is_said, "{margin}: {said}");
        let summary = text_of(&made, "summary.csv");
        assert!(summary.contains("\r\nlegend of the sheets,\"SEEN FROM OUTSIDE, ARROW: UP"));
    }
}
