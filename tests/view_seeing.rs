//! Ways of seeing, as a user meets them: parallel projection, ghost and ground, the measuring tape.
#![allow(clippy::unwrap_used, reason = "a helper that fails here fails its test")]
#![cfg(feature = "view")]

use glam::{DVec3, Vec2};
use shape_up::view::appearance::LineKind;
use shape_up::view::camera::Projection;
use shape_up::view::gizmo::Way;
use shape_up::view::state::{Changes, Outline, Stage, Taking};

const CANVAS: Vec2 = Vec2::new(900.0, 600.0);

/// Two floors, ten by ten, four apart: the lower one is vertices 0 to 3 and face 0.
fn floors() -> Vec<f64> {
    let floor = |z| [0.0, 0.0, z, 10.0, 0.0, z, 10.0, 10.0, z, 0.0, 10.0, z];
    [0.0, 4.0].into_iter().flat_map(floor).collect()
}

fn stage() -> Stage {
    let mut stage = Stage::default();
    stage.resize(CANVAS);
    stage.set_mesh((vec![0, 4, 8], (0..8).collect()), (vec![], vec![]), &floors()).unwrap();
    stage
}

fn parallel() -> Stage {
    let mut stage = stage();
    stage.set_parallel(true);
    stage
}

#[test]
fn seen_from_above_in_parallel_the_upper_floor_covers_the_lower_one_exactly() {
    let mut stage = parallel();
    stage.preset("top").unwrap();
    let eye = stage.camera.eye();
    for below in 0..4 {
        let [a, b] = [below, below + 4].map(|v| eye.project(stage.subject.positions[v]).0);
        assert!((a - b).length() < 1e-2, "{a} {b}");
    }
    // The floor fills the height of the canvas but for the margin.
    let corner = eye.project(stage.subject.positions[4]).0;
    assert!((corner.y - CANVAS.y).abs() < 0.06 * CANVAS.y);
    assert_eq!(stage.pick_face(CANVAS * 0.5), Some(1));
    stage.preset("bottom").unwrap();
    assert_eq!(stage.pick_face(CANVAS * 0.5), Some(0));
}

#[test]
fn in_parallel_everything_can_be_pointed_at_and_taken_with_a_box() {
    let mut stage = parallel();
    for side in ["home", "isometric", "front", "left"] {
        stage.preset(side).unwrap();
        let mut shown = 0;
        for vertex in 0..8 {
            if let Some(at) = stage.screen(vertex) {
                shown += 1;
                let found = stage.pick_vertex(at, 4.0).unwrap();
                let there = stage.screen(found).unwrap();
                assert!((there - at).length() < 1e-2, "{side}, vertex {vertex}");
            }
        }
        assert!(shown >= 4, "{side}");
    }
    stage.preset("isometric").unwrap();
    let all = Outline::around(Vec2::ZERO, CANVAS);
    assert_eq!(stage.vertices_in(&all, true).len(), 8);
    let seen = stage.vertices_in(&all, false);
    let expected: Vec<u32> = (0..8).filter(|&v| stage.screen(v).is_some()).collect();
    assert_eq!(seen, expected);
    // The lower floor's corner behind the upper floor is not taken.
    assert!(!seen.contains(&3) && seen.contains(&4));
    let taking = Taking { touching: true, through: false };
    assert_eq!(stage.faces_in(&all, taking), [0, 1]);
}

#[test]
fn in_parallel_a_drag_follows_the_cursor() {
    let mut stage = parallel();
    let at = stage.camera.eye().project(stage.subject.positions[5]).0;
    let by = Vec2::new(-80.0, 45.0);
    let to = at + by;
    stage.hold_vertex(5, Some(at)).unwrap();
    let way = stage.held_way(Way::Screen, by).unwrap();
    let target = stage.subject.exact[5] + way.as_dvec3();
    let seen = stage.camera.eye().project(stage.subject.relative(target)).0;
    assert!((seen - to).length() < 0.05, "{seen} {to}");
}

#[test]
fn in_parallel_a_zoom_holds_what_is_under_the_cursor_and_nothing_is_cut_off() {
    let mut stage = parallel();
    let cursor = stage.screen(4).unwrap();
    for _ in 0..30 {
        stage.zoom(1.3, cursor);
        let at = stage.camera.eye().project(stage.subject.positions[4]).0;
        assert!((at - cursor).length() < 0.5, "{at} {cursor}");
        let (near, far) = stage.depth_range();
        let eye = stage.camera.eye();
        for &point in &stage.subject.positions {
            let (_, depth) = eye.project(point);
            assert!(near < depth && depth < far, "{near} {depth} {far}");
        }
    }
}

#[test]
fn the_parallel_eye_stays_behind_a_mesh_that_grows() {
    let mut stage = parallel();
    let before = stage.camera.projection;
    let grown: Vec<f64> = floors().into_iter().map(|x| 40.0 * x).collect();
    stage.set_positions(&grown).unwrap();
    let eye = stage.camera.eye();
    assert!(stage.subject.positions.iter().all(|&point| eye.project(point).1 > 0.0));
    assert_ne!(stage.camera.projection, before);
}

#[test]
fn back_in_perspective_the_view_is_as_it_was() {
    let mut stage = stage();
    stage.orbit(40.0, 12.0);
    let before = stage.camera;
    stage.set_parallel(true);
    assert!(matches!(stage.camera.projection, Projection::Parallel { .. }));
    stage.set_parallel(false);
    assert_eq!(stage.camera, before);
}

#[test]
fn the_ghost_stays_where_the_mesh_was() {
    let mut stage = stage();
    stage.set_surroundings(true, false);
    assert!(stage.surrounding_lines().is_empty());
    stage.set_rest(&floors()).unwrap();
    let ghost: Vec<_> = stage.surrounding_points().collect();
    let lines = stage.surrounding_lines();
    assert_eq!((ghost.len(), lines.len()), (8, 8));
    assert!(lines.iter().all(|line| line[2] == LineKind::Ghost as u32));
    let moved: Vec<f64> = floors().into_iter().map(|x| x + 3.0).collect();
    stage.set_positions(&moved).unwrap();
    assert!(stage.surrounding_points().eq(ghost.iter().copied()));
    // What is far from the mesh is not cut off.
    let away: Vec<f64> = floors().into_iter().map(|x| x + 300.0).collect();
    stage.set_positions(&away).unwrap();
    stage.fit();
    let (_, far) = stage.depth_range();
    let eye = stage.camera.eye();
    assert!(ghost.iter().all(|&point| eye.project(point).1 < far));
    assert!(stage.set_rest(&[0.0; 3]).is_err());
}

#[test]
fn the_ground_lies_below_and_goes_with_another_mesh() {
    let mut stage = stage();
    stage.set_rest(&floors()).unwrap();
    stage.changes = Changes::default();
    stage.set_surroundings(false, true);
    assert!(stage.changes.view);
    assert_eq!(stage.around.grid_step(), Some(1.0));
    let floor = -2.0;
    assert!(stage.surrounding_points().all(|point| point.z < floor));
    assert!(stage.surrounding_lines().iter().all(|line| line[2] == LineKind::Ground as u32));
    let one = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    stage.set_mesh((vec![0, 3], vec![0, 1, 2]), (vec![], vec![]), &one).unwrap();
    assert_eq!(stage.around.grid_step(), None);
    assert_eq!(stage.surrounding_points().count(), 0);
}

#[test]
fn the_tape_measures_now_and_at_rest() {
    let mut stage = stage();
    stage.set_tape(&[0, 6]).unwrap();
    let measured = stage.measured().unwrap();
    assert_eq!((measured.now, measured.rest), (DVec3::new(10.0, 10.0, 4.0), None));
    stage.set_rest(&floors()).unwrap();
    let mut moved = floors();
    moved[18] = 10.5;
    stage.set_positions(&moved).unwrap();
    let measured = stage.measured().unwrap();
    assert_eq!(measured.now, DVec3::new(10.5, 10.0, 4.0));
    assert_eq!(measured.rest, Some(DVec3::new(10.0, 10.0, 4.0)));
    stage.set_tape(&[3]).unwrap();
    assert_eq!(stage.measured(), None);
    assert!(stage.set_tape(&[0, 99]).is_err() && stage.set_tape(&[0, 1, 2]).is_err());
    let one = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    stage.set_mesh((vec![0, 3], vec![0, 1, 2]), (vec![], vec![]), &one).unwrap();
    assert!(stage.tape.is_empty());
}
