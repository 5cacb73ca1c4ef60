//! Where new panels meet the boundary: followed or cut, and which is the better choice.

use crate::session::panel_layout::{USUAL, laid_out, opened, vault};
use shape_up::math::{cosine, sine};
use shape_up::mesh::Mesh;
use shape_up::quads::{Boundary, MapOptions, PanelSize};
use shape_up::session::{LayoutSettings, PanelLayout};

#[test]
fn a_boundary_across_the_lines_of_curvature_cuts_panels_if_they_then_move_less() {
    let session = opened(vault(12, true));
    let wanted = |boundary| {
        let settings = LayoutSettings { count: Some(100), boundary, ..USUAL };
        laid_out(&session, &settings)
    };
    let said =
        |layout: &PanelLayout| layout.notes.iter().map(|note| &note.words[..]).collect::<String>();
    let cut = wanted(None);
    assert_eq!(cut.boundary, Some(Boundary::Cut));
    let words = said(&cut);
    let other = "The panels are cut at the boundary: along it, they would move about ";
    assert!(words.starts_with(other), "{words}");
    // The same length as in the comparison of both.
    let mut layouts = session.panel_layouts(&[]).expect("a surface");
    let settings = LayoutSettings { count: Some(100), ..USUAL };
    let both = layouts.at_boundaries(&settings, &mut |_| ());
    let (_, moves) = both[0].words.split_once(", will ").expect("a forecast");
    assert!(words.ends_with(&format!(" would {moves}.")), "{words} {moves}");
    let followed = wanted(Some(Boundary::Followed));
    assert_eq!((followed.boundary, said(&followed)), (Some(Boundary::Followed), String::new()));
    let along = opened(vault(12, false));
    assert_eq!(laid_out(&along, &settings).boundary, Some(Boundary::Followed));
}

/// A low dome over a star with three teeth, so narrow that panels cannot follow its outline.
fn star(moved: f64) -> Mesh {
    let (columns, rings) = (6, 4);
    let mut mesh = Mesh::default();
    mesh.positions.push([moved, 0.0, 1.0]);
    for ring in 1..=rings {
        let share = f64::from(ring) / f64::from(rings);
        for k in 0..columns {
            let turns = f64::from(k) / f64::from(columns);
            let radius = 4.0 * share * if k % 2 == 1 { 0.15 } else { 1.0 };
            let (x, y) = (radius * cosine(turns), radius * sine(turns));
            mesh.positions.push([moved + x, y, 1.0 - share * share]);
        }
    }
    let name = |ring: u32, k: u32| 1 + (ring - 1) * columns + k % columns;
    for k in 0..columns {
        mesh.faces.push(&[0, name(1, k), name(1, k + 1)]);
        for ring in 1..rings {
            let inner = [name(ring, k), name(ring, k + 1)];
            let outer = [name(ring + 1, k), name(ring + 1, k + 1)];
            mesh.faces.push(&[inner[0], outer[0], outer[1]]);
            mesh.faces.push(&[inner[0], outer[1], inner[1]]);
        }
    }
    mesh
}

/// The part that only cut panels cover stayed as it was, since the other one could be covered.
#[test]
fn a_part_that_panels_cover_only_if_they_are_cut_is_covered() {
    let mut mesh = star(20.0);
    let first = mesh.positions.len() as u32;
    let other = vault(10, false);
    mesh.positions.extend(&other.positions);
    for face in other.faces.iter() {
        mesh.faces.push(&face.iter().map(|v| first + v).collect::<Vec<u32>>());
    }
    let session = opened(mesh);
    let mut layouts = session.panel_layouts(&[]).unwrap();
    let mut staying = |boundary| {
        let size = PanelSize::Length(0.5);
        let found = layouts.remesh(&MapOptions::of_size(size), boundary, &mut |_| ());
        let (found, boundary) = found.unwrap();
        let words = found.notes.into_iter().map(|note| note.words);
        (found.staying > 0, boundary, words.filter(|words| words.contains("cover less")).count())
    };
    assert_eq!(staying(Some(Boundary::Followed)), (true, Some(Boundary::Followed), 0));
    assert_eq!(staying(None), (false, Some(Boundary::Cut), 1));
}

#[test]
fn both_choices_at_the_boundary_are_forecast() {
    let session = opened(vault(12, true));
    let mut layouts = session.panel_layouts(&[]).expect("a surface");
    let settings = LayoutSettings { count: Some(100), ..USUAL };
    let found = layouts.at_boundaries(&settings, &mut |_| ());
    let choices: Vec<Boundary> = found.iter().map(|one| one.boundary).collect();
    assert_eq!(choices, [Boundary::Followed, Boundary::Cut]);
    let pattern = |words: &str| words.contains(" panels, will move about ");
    assert!(found.iter().all(|one| pattern(&one.words)), "{found:?}");
    let large = LayoutSettings { size: Some(100.0), ..USUAL };
    let found = layouts.at_boundaries(&large, &mut |_| ());
    assert!(found.iter().all(|one| one.words == "not possible"), "{found:?}");
}

/// The choice at the boundary was offered for a closed surface.
#[test]
fn a_closed_surface_beside_a_vertex_without_a_position_has_no_choice_at_the_boundary() {
    let corner = |k: u32| [k & 1, k >> 1 & 1, k >> 2].map(f64::from);
    let mut mesh = Mesh { positions: (0..8).map(corner).collect(), ..Mesh::default() };
    let sides =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    mesh.faces = sides.iter().collect();
    mesh.positions.push([0.5; 3]);
    mesh.unplaced = vec![8];
    let session = opened(mesh);
    let mut layouts = session.panel_layouts(&[]).expect("a surface");
    assert_eq!(layouts.at_boundaries(&USUAL, &mut |_| ()), []);
}
