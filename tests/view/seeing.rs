//! Display modes of the view: parallel projection, ghost and ground, the measuring tape.

use super::stage::{CANVAS, rectangle};
use glam::{DVec3, Vec2};
use shape_up::view::appearance::LineKind;
use shape_up::view::camera::CameraProjection;
use shape_up::view::gizmo::DragDirection;
use shape_up::view::overlay::SurfaceLines;
use shape_up::view::state::{Display, RegionMode, ViewState};

/// Two floors, ten by ten, four apart: the lower one is vertices 0 to 3 and face 0.
fn floors() -> Vec<f64> {
    let floor = |z| [0.0, 0.0, z, 10.0, 0.0, z, 10.0, 10.0, z, 0.0, 10.0, z];
    [0.0, 4.0].into_iter().flat_map(floor).collect()
}

fn state() -> ViewState {
    let mut state = ViewState::default();
    state.resize(CANVAS);
    state.set_mesh((vec![0, 4, 8], (0..8).collect()), (vec![], vec![]), &floors()).unwrap();
    state
}

fn parallel() -> ViewState {
    let mut state = state();
    state.set_parallel(true);
    state
}

#[test]
fn seen_from_above_in_parallel_the_upper_floor_covers_the_lower_one_exactly() {
    let mut state = parallel();
    state.preset("top").unwrap();
    let eye = state.camera().eye();
    for below in 0..4 {
        let [a, b] = [below, below + 4].map(|v| eye.project(state.mesh().positions[v]).0);
        assert!((a - b).length() < 1e-2, "{a} {b}");
    }
    // The floor fills the height of the canvas except for the margin.
    let corner = eye.project(state.mesh().positions[4]).0;
    assert!((corner.y - CANVAS.y).abs() < 0.06 * CANVAS.y);
    assert_eq!(state.pick_face(CANVAS * 0.5), Some(1));
    state.preset("bottom").unwrap();
    assert_eq!(state.pick_face(CANVAS * 0.5), Some(0));
}

#[test]
fn a_shape_much_larger_than_the_model_is_in_front_of_the_eye_and_within_its_depth() {
    // The circle of a shallow arc was cut off where it left the depth of the model, and of the sphere of
    // a shallow cap the far side was drawn where the near one passed the eye.
    for kind in [0.0, 1.0] {
        let mut state = parallel();
        let [(near, far), (before, behind)] = [true, false].map(|shows| {
            state.set_display(Display { shapes: shows, ..state.display() });
            state.set_shapes(&[kind, 5.0, 5.0, 4.0, 0.0, 0.0, 1.0, 80.0]).unwrap();
            state.depth_range()
        });
        assert!(far - near > 100.0 && near > 0.0, "{near} {far}");
        assert!(behind - before < 40.0, "{before} {behind}");
    }
}

#[test]
fn the_ground_stays_where_it_is_when_the_original_is_known() {
    // The shadow of a mesh that had risen jumped when the grid was switched on.
    let mut state = state();
    let risen: Vec<f64> = floors().chunks(3).flat_map(|p| [p[0], p[1], p[2] + 3.0]).collect();
    state.set_positions(&risen).unwrap();
    let before = state.floor();
    assert!(before < -2.0);
    state.set_rest(&floors()).unwrap();
    assert_eq!(state.floor(), before);
}

#[test]
fn another_model_of_the_same_faces_keeps_its_digits_wherever_it_is() {
    let mut state = state();
    let here = state.mesh().positions.clone();
    state.marks_mut().select(vec![3], vec![]).unwrap();
    let site = [2_679_500.0, 1_247_250.0, 408.0];
    let there: Vec<f64> = floors().iter().zip(site.iter().cycle()).map(|(a, b)| a + b).collect();
    state.set_mesh((vec![0, 4, 8], (0..8).collect()), (vec![], vec![]), &there).unwrap();
    assert_eq!(state.mesh().positions, here);
    assert!(state.changes().mesh && state.appearance().selected_vertices.is_empty());
}

#[test]
fn in_parallel_everything_can_be_pointed_at_and_taken_with_a_box() {
    let mut state = parallel();
    for side in ["home", "isometric", "front", "left"] {
        state.preset(side).unwrap();
        let mut shown = 0;
        for vertex in 0..8 {
            if let Some(at) = state.screen(vertex) {
                shown += 1;
                let found = state.pick_vertex(at, 4.0).unwrap();
                let there = state.screen(found).unwrap();
                assert!((there - at).length() < 1e-2, "{side}, vertex {vertex}");
            }
        }
        assert!(shown >= 4, "{side}");
    }
    state.preset("isometric").unwrap();
    let all = rectangle(Vec2::ZERO, CANVAS);
    assert_eq!(state.vertices_in(&all, true).len(), 8);
    let seen = state.vertices_in(&all, false);
    let expected: Vec<u32> = (0..8).filter(|&v| state.screen(v).is_some()).collect();
    assert_eq!(seen, expected);
    // The corner of the lower floor behind the upper floor is not selected.
    assert!(!seen.contains(&3) && seen.contains(&4));
    let taking = RegionMode { touching: true, through: false };
    assert_eq!(state.faces_in(&all, taking), [0, 1]);
}

#[test]
fn in_parallel_a_drag_follows_the_cursor() {
    let mut state = parallel();
    let at = state.camera().eye().project(state.mesh().positions[5]).0;
    let by = Vec2::new(-80.0, 45.0);
    let to = at + by;
    state.hold_vertex(5, Some(at)).unwrap();
    let way = state.constrain_move(DragDirection::Screen, by).unwrap();
    let target = state.mesh().exact[5] + way.as_dvec3();
    let seen = state.camera().eye().project(state.mesh().relative(target)).0;
    assert!((seen - to).length() < 0.05, "{seen} {to}");
}

#[test]
fn in_parallel_a_zoom_holds_what_is_under_the_cursor_and_nothing_is_cut_off() {
    let mut state = parallel();
    let cursor = state.screen(4).unwrap();
    for _ in 0..30 {
        state.zoom(1.3, cursor);
        let at = state.camera().eye().project(state.mesh().positions[4]).0;
        assert!((at - cursor).length() < 0.5, "{at} {cursor}");
        let (near, far) = state.depth_range();
        let eye = state.camera().eye();
        for &point in &state.mesh().positions {
            let (_, depth) = eye.project(point);
            assert!(near < depth && depth < far, "{near} {depth} {far}");
        }
    }
}

#[test]
fn the_parallel_eye_stays_behind_a_mesh_that_grows() {
    let mut state = parallel();
    let before = state.camera().projection;
    let grown: Vec<f64> = floors().into_iter().map(|x| 40.0 * x).collect();
    state.set_positions(&grown).unwrap();
    let eye = state.camera().eye();
    assert!(state.mesh().positions.iter().all(|&point| eye.project(point).1 > 0.0));
    assert_ne!(state.camera().projection, before);
}

#[test]
fn back_in_perspective_the_view_is_as_it_was() {
    let mut state = state();
    state.orbit(40.0, 12.0);
    let before = state.camera();
    state.set_parallel(true);
    assert!(matches!(state.camera().projection, CameraProjection::Parallel { .. }));
    state.set_parallel(false);
    assert_eq!(state.camera(), before);
}

#[test]
fn the_ghost_stays_where_the_mesh_was() {
    let mut state = state();
    state.set_surroundings(true, false);
    assert!(state.surrounding_lines().is_empty());
    state.set_rest(&floors()).unwrap();
    let ghost: Vec<_> = state.surrounding_points().collect();
    let lines = state.surrounding_lines();
    assert_eq!((ghost.len(), lines.len()), (8, 8));
    assert!(lines.iter().all(|line| line[2] == LineKind::Ghost as u32));
    let moved: Vec<f64> = floors().into_iter().map(|x| x + 3.0).collect();
    state.set_positions(&moved).unwrap();
    assert!(state.surrounding_points().eq(ghost.iter().copied()));
    // Parts far from the mesh are not clipped.
    let away: Vec<f64> = floors().into_iter().map(|x| x + 300.0).collect();
    state.set_positions(&away).unwrap();
    state.fit();
    let (_, far) = state.depth_range();
    let eye = state.camera().eye();
    assert!(ghost.iter().all(|&point| eye.project(point).1 < far));
    assert!(state.set_rest(&[0.0; 3]).is_err());
}

#[test]
fn the_ground_lies_below_and_goes_with_another_mesh() {
    let mut state = state();
    state.set_rest(&floors()).unwrap();
    state.take_changes();
    state.set_surroundings(false, true);
    assert!(state.changes().view);
    assert_eq!(state.around().grid_step(), Some(1.0));
    let floor = -2.0;
    assert!(state.surrounding_points().all(|point| point.z < floor));
    assert!(state.surrounding_lines().iter().all(|line| line[2] == LineKind::Ground as u32));
    // The shadow lay below the shape that had moved, and the grid below the one at rest.
    let lowered: Vec<f64> =
        floors().chunks(3).flat_map(|p| [p[0], p[1], 3.0 * p[2] - 1.0]).collect();
    state.set_positions(&lowered).unwrap();
    let floor = state.floor();
    assert!(floor < state.mesh().positions.iter().map(|point| point.z).fold(0.0, f32::min));
    assert!(state.surrounding_points().all(|point| (point.z - floor).abs() < 1e-5));
    state.set_positions(&floors()).unwrap();
    assert!(state.surrounding_points().all(|point| point.z > floor));
    // Neither grid nor ghost is sent again for a shape that is only wider.
    state.take_changes();
    let wider: Vec<f64> = floors().chunks(3).flat_map(|p| [2.0 * p[0], p[1], p[2]]).collect();
    state.set_positions(&wider).unwrap();
    assert!(state.changes().positions && !state.changes().around);
    let one = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    state.set_mesh((vec![0, 3], vec![0, 1, 2]), (vec![], vec![]), &one).unwrap();
    assert_eq!(state.around().grid_step(), None);
    assert_eq!(state.surrounding_points().count(), 0);
}

#[test]
fn lines_of_the_ghost_and_of_the_ground_join_their_own_points() {
    let mut state = state();
    // Four vertices and five edges.
    let corners = [0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 9.0, 9.0, 0.0, 0.0, 9.0, 0.0];
    state.set_mesh((vec![0, 3, 6], vec![0, 1, 2, 0, 2, 3]), (vec![], vec![]), &corners).unwrap();
    state.set_rest(&corners).unwrap();
    state.set_surroundings(true, true);
    let points: Vec<_> = state.surrounding_points().collect();
    let lines = state.surrounding_lines();
    assert_eq!(lines.iter().filter(|line| line[2] == LineKind::Ghost as u32).count(), 5);
    for [a, b, kind] in lines {
        let is_ground = kind == LineKind::Ground as u32;
        assert!([a, b].iter().all(|&end| (points[end as usize].z < 0.0) == is_ground));
    }
}

#[test]
fn the_tape_measures_now_and_at_rest() {
    let mut state = state();
    state.set_tape(&[0, 6]).unwrap();
    let measured = state.measured().unwrap();
    assert_eq!((measured.now, measured.rest), (DVec3::new(10.0, 10.0, 4.0), None));
    state.set_rest(&floors()).unwrap();
    let mut moved = floors();
    moved[18] = 10.5;
    state.set_positions(&moved).unwrap();
    let measured = state.measured().unwrap();
    assert_eq!(measured.now, DVec3::new(10.5, 10.0, 4.0));
    assert_eq!(measured.rest, Some(DVec3::new(10.0, 10.0, 4.0)));
    state.set_tape(&[3]).unwrap();
    assert_eq!(state.measured(), None);
    assert!(state.set_tape(&[0, 99]).is_err() && state.set_tape(&[0, 1, 2]).is_err());
    let one = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    state.set_mesh((vec![0, 3], vec![0, 1, 2]), (vec![], vec![]), &one).unwrap();
    assert!(state.tape().is_empty());
}

#[test]
fn a_layer_is_joined_to_the_surface_and_what_fails_is_drawn_over_it() {
    let mut state = state();
    let above: Vec<f64> =
        floors().chunks(3).flat_map(|point| [point[0], point[1], point[2] + 1.0]).collect();
    state.set_layer(&above, &[0, 1], vec![3]).unwrap();
    let points: Vec<_> = state.layer_points().collect();
    let lines = state.layer_lines();
    let of = |kind: LineKind| lines.iter().filter(move |line| line[2] == kind as u32);
    assert_eq!(of(LineKind::Layer).count(), 8 + 8, "edges of the layer, and posts");
    // The beam of an edge with its four sides, and a post.
    assert_eq!(of(LineKind::Failed).count(), 4 + 1);
    assert!(lines[..16].iter().all(|line| line[2] == LineKind::Layer as u32));
    for line in lines.iter().filter(|line| line[1] == line[0] + 8) {
        let post = points[line[0] as usize] - points[line[1] as usize];
        assert!((post.length() - 1.0).abs() < 1e-6);
    }
    assert!(state.set_layer(&above[..9], &[], vec![]).is_err());
    assert!(state.set_layer(&above, &[0, 8], vec![]).is_err());
    assert_eq!(state.layer_lines().len(), lines.len(), "what does not fit changes nothing");
    // A new mesh does not keep the layer of the previous one.
    state.set_mesh((vec![0, 3], vec![0, 1, 2]), (vec![], vec![]), &floors()[..9]).unwrap();
    assert!(state.layer_lines().is_empty());
}

#[test]
fn a_section_lets_one_see_and_take_what_was_behind() {
    let mut state = parallel();
    state.preset("top").unwrap();
    let middle = CANVAS * 0.5;
    assert_eq!((state.pick_face(middle), state.screen(0)), (Some(1), None));
    // A section across z, just below the upper floor.
    state.set_section(Some((2, 0.9, false))).unwrap();
    assert_eq!(state.pick_face(middle), Some(0));
    let corner = state.screen(0).unwrap();
    assert_eq!(state.pick_vertex(corner, 4.0), Some(0));
    assert!((4..8).all(|vertex| state.screen(vertex).is_none()));
    let all = rectangle(Vec2::ZERO, CANVAS);
    assert_eq!(state.vertices_in(&all, false), [0, 1, 2, 3]);
    state.set_section(Some((2, 0.9, true))).unwrap();
    assert_eq!(state.pick_face(middle), Some(1));
    assert!(state.set_section(Some((3, 0.5, false))).is_err());
    // A new mesh has no section.
    let other = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    state.set_mesh((vec![0, 3], vec![0, 1, 2]), (vec![], vec![]), &other).unwrap();
    assert_eq!(state.camera().section, None);
}

#[test]
fn a_line_drawing_ends_at_the_section() {
    let mut state = parallel();
    state.preset("top").unwrap();
    let drawn = |state: &ViewState| shape_up::view::line_drawing::line_drawing(state).unwrap();
    let whole = drawn(&state);
    // Only the left half remains, so the drawing is narrower.
    state.set_section(Some((0, 0.5, false))).unwrap();
    let half = drawn(&state);
    // Greatest x at which a line begins.
    let right = |svg: &str| {
        let begins = svg.split('M').skip(1).filter_map(|line| line.split([' ', '-']).next());
        begins.filter_map(|x| x.parse::<f64>().ok()).fold(0.0, f64::max)
    };
    assert!(right(&half) < 0.7 * right(&whole), "{} {}", right(&half), right(&whole));
}

#[test]
fn a_turntable_turns_the_model_in_front_of_the_eye() {
    let mut state = state();
    let before = state.camera();
    let middle = |state: &ViewState| state.camera().eye().project(glam::Vec3::ZERO).0;
    let at = middle(&state);
    for _ in 0..8 {
        state.spin(std::f32::consts::TAU / 8.0);
        assert!((middle(&state) - at).length() < 0.5);
    }
    let after = state.camera().eye();
    assert!((after.forward - before.eye().forward).length() < 1e-4);
    assert!((after.at - before.eye().at).length() < 1e-2 * before.distance);
}

#[test]
fn lines_over_the_surface_are_of_two_kinds_and_go_with_the_mesh() {
    let mut state = state();
    state.take_changes();
    let points = [0.0, 0.0, 4.0, 5.0, 0.0, 4.0, 10.0, 0.0, 4.0, 0.0, 5.0, 4.0, 10.0, 5.0, 4.0];
    let lines = SurfaceLines::new(&points, vec![0, 3, 5], 1).unwrap();
    state.set_surface_lines(lines);
    let (lines, places) = state.surface_lines();
    let [larger, smaller] = [LineKind::Larger, LineKind::Smaller].map(|kind| kind as u32);
    assert_eq!(lines, [[0, 1, larger], [1, 2, larger], [3, 4, smaller]]);
    assert!(((places[2] - places[0]).length() - 10.0).abs() < 1e-5);
    assert!(state.take_changes().lines && !state.changes().lines, "they are drawn once");
    assert!(SurfaceLines::new(&points, vec![0, 3, 6], 1).is_err());
    assert!(SurfaceLines::new(&points[..4], vec![0, 1], 1).is_err());
    assert!(SurfaceLines::new(&[f64::NAN; 3], vec![0, 1], 1).is_err());
    // A new mesh does not keep the lines of the previous one.
    state.set_mesh((vec![0, 3], vec![0, 1, 2]), (vec![], vec![]), &floors()[..9]).unwrap();
    assert!(state.changes().lines && state.surface_lines() == (vec![], vec![]));
}

#[test]
fn a_stray_vertex_far_away_keeps_the_eye_and_the_depths_near() {
    // In parallel projection the eye was as far away as that vertex, and lost all digits.
    let at = DVec3::new(2_679_500.0, 1_247_250.0, 408.0);
    let seen = |is_stray: bool| {
        let places = floors();
        let mut positions: Vec<f64> =
            places.chunks(3).flat_map(|p| (DVec3::from_slice(p) + at).to_array()).collect();
        positions.extend(if is_stray { [0.0; 3] } else { at.to_array() });
        let mut state = ViewState::default();
        state.resize(CANVAS);
        state.set_mesh((vec![0, 4, 8], (0..8).collect()), (vec![], vec![]), &positions).unwrap();
        state.set_rest(&positions).unwrap();
        state.set_surroundings(true, true);
        state.set_parallel(true);
        (state.camera().projection, state.depth_range())
    };
    assert_eq!(seen(true), seen(false));
}
