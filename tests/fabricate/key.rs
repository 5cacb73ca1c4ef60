//! Key drawings: every part has its name where it is.

use super::identities::revolution;
use super::{build, metres, text_of};
use crate::support::grid::grid;
use shape_up::fabricate::file::Drawing;
use shape_up::fabricate::sheet::{Role, strokes, text_width};
use shape_up::fabricate::{Build, Stand};
use shape_up::mesh::{Mesh, Ragged};
use shape_up::scene::{BuildSettings, Product};
use std::collections::BTreeSet;

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
    let [drawing, side] = &key[..] else { panic!("{} drawings", key.len()) };
    assert_eq!(drawing.title, "KEY 1/2, NOT TO BE CUT, SEEN FROM ABOVE");
    // It rises to one corner, and faces the other.
    assert_eq!(side.title, "KEY 2/2, NOT TO BE CUT, SEEN FROM -X -Y, ABOVE");
    assert_eq!(names(side).len(), mesh.faces.len());
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
    let key = build(&mesh, &BuildSettings::default()).key(true);
    assert!(
        ["P6", "P7", "P8", "P9", "P10", "P11"].iter().all(|own| !all_names(&key).contains(*own))
    );
    assert_eq!(all_names(&key).len(), 6);
    assert!(key[0].title.ends_with(", WITHOUT 6 NAMES THAT NO VIEW SHOWS"));
    // On every page, however narrow.
    for Drawing { lines, size: [width, _], .. } in &key {
        assert!(
            lines.iter().flat_map(|line| &line.points).all(|[x, _]| (0.0..=*width).contains(x))
        );
    }
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
