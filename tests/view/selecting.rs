//! Pointing and selecting in the view: vertices, edges and faces, in boxes and by clicks.

use super::stage::{CANVAS, bump, rectangle, state, two_floors};
use crate::support::time::takes_less;
use glam::Vec2;
use shape_up::view::state::{Display, RegionMode, ViewState};

const TOUCHING: RegionMode = RegionMode { touching: true, through: false };
const WHOLE: RegionMode = RegionMode { touching: false, through: false };
#[test]
fn every_vertex_that_is_shown_can_be_pointed_at() {
    let state = state(10, bump);
    let mut shown = 0;
    for vertex in 0..state.counts().0 as u32 {
        if let Some(at) = state.screen(vertex) {
            shown += 1;
            assert_eq!(state.pick_vertex(at + Vec2::new(1.0, -1.0), 6.0), Some(vertex));
        }
    }
    assert!(shown > 80, "{shown} of 121 vertices are seen");
    assert_eq!(state.pick_vertex(Vec2::ONE, 6.0), None);
    assert_eq!(state.screen(100_000), None);
}

#[test]
fn vertices_that_are_not_drawn_are_not_selected() {
    let mut state = ViewState::default();
    state.resize(CANVAS);
    let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.6, 0.0]].concat();
    state.set_mesh((vec![0, 3], vec![0, 1, 2]), (vec![], vec![]), &positions).unwrap();
    state.preset("top").unwrap();
    let stray = state.camera().eye().project(state.mesh().positions[3]).0;
    let everything = rectangle(Vec2::ZERO, CANVAS);
    assert_eq!(state.pick_vertex(stray, 3.0), None);
    assert_eq!(state.vertices_in(&everything, true), [0, 1, 2]);
    state.set_display(Display { vertices: true, ..state.display() });
    assert_eq!(state.pick_vertex(stray, 3.0), Some(3));
    assert_eq!(state.vertices_in(&everything, true), [0, 1, 2, 3]);
}

#[test]
fn the_surface_hides_vertices_but_not_handles() {
    let mut state = two_floors();
    state.preset("top").unwrap();
    let below = state.camera().eye().project(state.mesh().positions[0]).0;
    assert_eq!(state.screen(0), None);
    assert_eq!(state.pick_vertex(below, 3.0), None);
    state.set_handles(&[0], &[0], &[0.0; 3]).unwrap();
    assert_eq!(state.pick_handle(below + Vec2::X, 8.0), Some(0));
    assert_eq!(state.pick_handle(CANVAS * 0.5, 8.0), None);
    assert_eq!(state.pick_face(CANVAS * 0.5), Some(1));
    state.preset("bottom").unwrap();
    assert_eq!(state.pick_face(CANVAS * 0.5), Some(0));
    assert!(state.screen(0).is_some());
}

#[test]
fn a_click_on_a_panel_that_hides_very_many_vertices_tries_few_triangles() {
    let (mut state, positions) = (ViewState::default(), hidden_sheet(60));
    state.resize(CANVAS);
    let quads = positions.len() / 12;
    let rows = ((0..=quads as u32).map(|f| 4 * f).collect(), (0..4 * quads as u32).collect());
    state.set_mesh(rows, (vec![], vec![]), &positions).unwrap();
    state.preset("top").unwrap();
    let at = state.camera().eye().project(state.mesh().positions[0]).0;
    let panel = || assert_eq!(state.pick_face(at), Some(quads as u32 - 1));
    let hidden = || assert_eq!(state.pick_vertex(at, 8.0), None);
    // Thousands of vertices are near, and all triangles.
    takes_less(60.0, hidden, panel);
}

/// `n` by `n` quads, a tenth of a unit wide, below a panel ten units wide.
fn hidden_sheet(n: u32) -> Vec<f64> {
    let quad = |[x, y, z]: [f64; 3], side: f64| {
        [x, y, z, x + side, y, z, x + side, y + side, z, x, y + side, z]
    };
    let side = 0.1 / f64::from(n);
    let small = (0..n * n).map(|k| [f64::from(k % n) * side, f64::from(k / n) * side, 0.0]);
    let mut positions: Vec<f64> = small.flat_map(|at| quad(at, side)).collect();
    positions.extend(quad([-5.0, -5.0, 1.0], 10.0));
    positions
}

#[test]
fn a_box_around_everything_takes_what_is_in_front() {
    let mut state = two_floors();
    state.preset("top").unwrap();
    assert_eq!(state.vertices_in(&rectangle(Vec2::ZERO, CANVAS), false), [4, 5, 6, 7]);
    assert_eq!(state.faces_in(&rectangle(CANVAS, Vec2::ZERO), WHOLE), [1]);
    assert_eq!(state.faces_in(&rectangle(Vec2::ZERO, CANVAS), TOUCHING), [1]);
    state.preset("bottom").unwrap();
    assert_eq!(state.vertices_in(&rectangle(CANVAS, Vec2::ZERO), false), [0, 1, 2, 3]);
}

/// Seen from above, a bump hides nothing; its rim is the outline.
#[test]
fn a_box_misses_no_vertex_of_a_sheet_seen_from_above() {
    let mut state = state(60, bump);
    state.preset("top").unwrap();
    assert_eq!(state.vertices_in(&rectangle(Vec2::ZERO, CANVAS), false).len(), 61 * 61);
    assert_eq!(state.faces_in(&rectangle(Vec2::ZERO, CANVAS), WHOLE).len(), 60 * 60);
}

#[test]
fn a_window_takes_whole_faces_and_a_crossing_takes_touched_ones() {
    let mut state = state(4, |_, _| 0.0);
    state.preset("top").unwrap();
    let at = |vertex: u32| state.screen(vertex).unwrap();
    // From the centre of face 0 to the centre of face 10: face 5 is between them.
    let from = (at(0) + at(6)) * 0.5;
    let to = (at(12) + at(18)) * 0.5;
    assert_eq!(state.faces_in(&rectangle(from, to), WHOLE), [5]);
    assert_eq!(state.faces_in(&rectangle(from, to), TOUCHING), [0, 1, 2, 4, 5, 6, 8, 9, 10]);
    let inside = (from + Vec2::ONE, from + Vec2::splat(3.0));
    assert_eq!(state.faces_in(&rectangle(inside.0, inside.1), TOUCHING), [0]);
    assert!(state.faces_in(&rectangle(inside.0, inside.1), WHOLE).is_empty());
    let aside = Vec2::new(4.0, 4.0);
    assert!(state.faces_in(&rectangle(aside, aside * 2.0), TOUCHING).is_empty());
}

#[test]
fn through_takes_what_the_surface_hides() {
    let mut state = two_floors();
    state.preset("top").unwrap();
    let all = rectangle(Vec2::ZERO, CANVAS);
    let through = |touching| RegionMode { touching, through: true };
    assert_eq!(state.vertices_in(&all, true).len(), 8);
    assert_eq!(state.faces_in(&all, through(false)), [0, 1]);
    // Corners and sides of both floors, then the four columns between them.
    let floors = [0, 1, 1, 2, 2, 3, 0, 3, 4, 5, 5, 6, 6, 7, 4, 7];
    state.set_edges(&[&floors[..], &[0, 4, 1, 5, 2, 6, 3, 7]].concat()).unwrap();
    assert_eq!(state.edges_in(&all, WHOLE), [4, 5, 6, 7]);
    assert_eq!(state.edges_in(&all, through(false)).len(), 12);
    assert!(state.set_edges(&[0, 9]).is_err() && state.set_edges(&[0, 1, 2]).is_err());
}

#[test]
fn an_edge_is_picked_where_it_is_visible_though_its_middle_is_hidden() {
    // A roof over the middle of a floor and of its edge 0-1.
    let floor = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 10.0, 0.0], [0.0, 10.0, 0.0]];
    let roof = [[3.0, -2.0, 1.0], [7.0, -2.0, 1.0], [7.0, 12.0, 1.0], [3.0, 12.0, 1.0]];
    let positions = [floor, roof].concat();
    for is_parallel in [false, true] {
        let mut state = ViewState::default();
        state.resize(CANVAS);
        let faces = (vec![0, 4, 8], (0..8).collect());
        state.set_mesh(faces, (vec![], vec![]), positions.as_flattened()).unwrap();
        state.set_parallel(is_parallel);
        state.preset("top").unwrap();
        state.set_edges(&[0, 1]).unwrap();
        let [from, to] = [0, 1].map(|vertex| state.screen(vertex).unwrap());
        assert_eq!(state.pick_edge(from.lerp(to, 0.1), 8.0), Some(0));
        assert_eq!(state.pick_edge(from.lerp(to, 0.5), 8.0), None);
    }
}

#[test]
fn an_edge_is_picked_where_it_is_seen_and_marked_by_its_number() {
    let mut state = state(4, |_, _| 0.0);
    state.preset("top").unwrap();
    state.set_edges(&[0, 1, 6, 7, 6, 11]).unwrap();
    let at = |state: &ViewState, vertex: u32| state.screen(vertex).unwrap();
    let middle = (at(&state, 6) + at(&state, 7)) * 0.5;
    assert_eq!(state.pick_edge(middle + Vec2::new(0.0, 3.0), 8.0), Some(1));
    let other = (at(&state, 6) + at(&state, 11)) * 0.5;
    assert_eq!(state.pick_edge(other, 8.0), Some(2));
    assert_eq!(state.pick_edge(middle + Vec2::new(0.0, 30.0), 8.0), None);
    // A stroke across the first edge touches it but does not contain it.
    let across = rectangle(middle - Vec2::splat(5.0), middle + Vec2::splat(5.0));
    assert_eq!(state.edges_in(&across, TOUCHING), [1]);
    assert!(state.edges_in(&across, WHOLE).is_empty());
    state.select_edges(&[2]).unwrap();
    assert_eq!(state.appearance().selected_edges, [[6, 11]]);
    assert!(state.select_edges(&[3]).is_err());
    // Edges along which paper is cut are marked beside them.
    state.set_seams(&[11, 6, 0, 1]).unwrap();
    assert!(state.set_seams(&[0, 25]).is_err() && state.set_seams(&[0]).is_err());
    assert_eq!(state.appearance().seams, [[11, 6], [0, 1]]);
    assert_eq!(state.appearance().selected_edges, [[6, 11]]);
}
