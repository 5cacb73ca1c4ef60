//! The view without a GPU: framing, picking, selection boxes, dragging.

use glam::{DVec3, Vec2, Vec3};
use shape_up::view::appearance::ColourMap;
use shape_up::view::camera::UpAxis;
use shape_up::view::gizmo::DragDirection;
use shape_up::view::pictures::{flat_map, follow, show_flipped};
use shape_up::view::state::{Changes, FittedShape, Outline, ViewState};

pub(crate) const CANVAS: Vec2 = Vec2::new(900.0, 600.0);

/// Offsets and indices.
type Rows = (Vec<u32>, Vec<u32>);

/// A sheet of `n` by `n` quads, ten units wide, curved by `height`.
fn sheet(n: u32, at: DVec3, height: impl Fn(f64, f64) -> f64) -> (Rows, Vec<f64>) {
    let mut positions = Vec::new();
    for j in 0..=n {
        for i in 0..=n {
            let (x, y) = (f64::from(i) / f64::from(n), f64::from(j) / f64::from(n));
            positions.extend((at + DVec3::new(10.0 * x, 10.0 * y, height(x, y))).to_array());
        }
    }
    let mut indices = Vec::new();
    for j in 0..n {
        for i in 0..n {
            let a = j * (n + 1) + i;
            indices.extend([a, a + 1, a + n + 2, a + n + 1]);
        }
    }
    (((0..=n * n).map(|f| 4 * f).collect(), indices), positions)
}

/// The rectangle with two opposite corners.
pub(crate) fn rectangle(a: Vec2, b: Vec2) -> Outline {
    Outline::new(vec![a, Vec2::new(b.x, a.y), b, Vec2::new(a.x, b.y)])
}

pub(crate) fn state(n: u32, height: impl Fn(f64, f64) -> f64) -> ViewState {
    let (faces, positions) = sheet(n, DVec3::ZERO, height);
    let mut state = ViewState::default();
    state.resize(CANVAS);
    state.set_mesh(faces, (vec![], vec![]), &positions).unwrap();
    state
}

pub(crate) fn bump(x: f64, y: f64) -> f64 {
    48.0 * x * (1.0 - x) * y * (1.0 - y)
}

/// Two floors, ten by ten, one above the other: the lower one is vertices 0 to 3 and face 0.
pub(crate) fn two_floors() -> ViewState {
    let mut positions = Vec::new();
    for z in [0.0, 4.0] {
        positions.extend([0.0, 0.0, z, 10.0, 0.0, z, 10.0, 10.0, z, 0.0, 10.0, z]);
    }
    let mut state = ViewState::default();
    state.resize(CANVAS);
    state.set_mesh((vec![0, 4, 8], (0..8).collect()), (vec![], vec![]), &positions).unwrap();
    state
}

#[test]
fn a_new_mesh_fills_the_canvas() {
    let state = state(8, bump);
    let eye = state.camera().eye();
    let at: Vec<Vec2> = state.mesh().positions.iter().map(|&p| eye.project(p).0).collect();
    let low = at.iter().copied().reduce(Vec2::min).unwrap();
    let high = at.iter().copied().reduce(Vec2::max).unwrap();
    assert!(low.min_element() > 0.0 && (CANVAS - high).min_element() > 0.0, "{low} {high}");
    let filled = (high - low) / CANVAS;
    assert!(filled.max_element() > 0.85, "{filled}");
}

#[test]
fn an_untouched_view_follows_the_canvas_and_a_touched_one_stays() {
    let mut state = state(8, bump);
    let first = state.camera();
    state.resize(Vec2::new(300.0, 800.0));
    assert!(state.camera().distance > 1.5 * first.distance);
    state.orbit(10.0, 0.0);
    let turned = state.camera();
    state.resize(CANVAS);
    assert_eq!(state.camera().distance, turned.distance);
}

#[test]
fn the_same_faces_only_move_and_keep_camera_and_marks() {
    let mut state = state(4, bump);
    state.orbit(50.0, 20.0);
    state.marks_mut().select(vec![3], vec![]).unwrap();
    state.set_rest(&sheet(4, DVec3::ZERO, bump).1).unwrap();
    let camera = state.camera();
    state.take_changes();
    let (faces, positions) = sheet(4, DVec3::ZERO, |x, y| 0.5 * bump(x, y));
    state.set_mesh(faces, (vec![], vec![]), &positions).unwrap();
    // The tape told the distance in the file that was open before.
    assert!(state.around().rest().is_empty());
    assert_eq!(state.camera(), camera);
    assert_eq!(state.appearance().selected_vertices, [3]);
    assert!(state.changes().positions && !state.changes().mesh);
    let (faces, positions) = sheet(5, DVec3::ZERO, bump);
    state.set_mesh(faces, (vec![], vec![]), &positions).unwrap();
    assert!(state.changes().mesh && state.appearance().selected_vertices.is_empty());
}

#[test]
fn nothing_to_draw_until_something_changes() {
    let mut state = state(4, bump);
    state.take_changes();
    assert!(!state.changes().any());
    state.zoom(1.2, CANVAS * 0.5);
    assert!(state.changes().any() && !state.changes().positions);
    state.take_changes();
    state.zoom(f32::NAN, CANVAS * 0.5);
    state.zoom(0.0, CANVAS * 0.5);
    assert!(!state.changes().any());
}

#[test]
fn what_one_looks_at_from_nearby_is_not_cut_off() {
    let mut state = state(4, |_, _| 0.0);
    state.preset("front").unwrap();
    state.move_camera(|camera| camera.tilt = 0.4);
    let middle = CANVAS * 0.5;
    for _ in 0..200 {
        state.zoom(1.1, middle);
    }
    let (near, _) = state.depth_range();
    let distance = state.camera().distance;
    assert!(near < 0.5 * distance, "{near} {distance}");
}

#[test]
fn boxes_follow_the_camera_and_the_mesh() {
    let mut state = state(4, |_, _| 0.0);
    state.preset("top").unwrap();
    assert_eq!(state.vertices_in(&rectangle(Vec2::ZERO, CANVAS), false).len(), 25);
    state.pan(CANVAS.x, 0.0);
    assert!(state.vertices_in(&rectangle(Vec2::ZERO, CANVAS), false).is_empty());
    state.fit();
    let (_, positions) = sheet(4, DVec3::new(1000.0, 0.0, 0.0), |_, _| 0.0);
    state.set_positions(&positions).unwrap();
    assert!(state.vertices_in(&rectangle(Vec2::ZERO, CANVAS), false).is_empty());
}

#[test]
fn a_dragged_vertex_lies_under_the_cursor_and_keeps_its_depth() {
    let site = DVec3::new(2_679_500.0, 1_247_250.0, 408.0);
    let (faces, positions) = sheet(6, site, bump);
    let mut state = ViewState::default();
    state.resize(CANVAS);
    state.set_mesh(faces, (vec![], vec![]), &positions).unwrap();
    let vertex = 24;
    let (before, depth) = state.camera().eye().project(state.mesh().positions[vertex as usize]);
    state.hold_vertex(vertex, Some(before)).unwrap();
    assert_eq!(state.constrain_move(DragDirection::Screen, Vec2::ZERO), Some(Vec3::ZERO));

    let by = Vec2::new(120.0, -45.0);
    let way = state.constrain_move(DragDirection::Screen, by).unwrap();
    let target = state.mesh().exact[vertex as usize] + way.as_dvec3();
    let (after, same_depth) = state.camera().eye().project(state.mesh().relative(target));
    assert!((after - before - by).length() < 0.01, "{after} {before}");
    assert!((same_depth - depth).abs() < 1e-3 * depth);
    assert!(state.hold_vertex(99, None).is_err());
}

#[test]
fn the_gizmo_is_in_the_middle_of_the_selected_handles() {
    let mut state = state(6, bump);
    let at = |vertex: usize| state.mesh().exact[vertex];
    let targets = [at(16), at(32) + DVec3::Z, at(0)];
    let numbers: Vec<f64> = targets.iter().flat_map(|target| target.to_array()).collect();
    state.set_handles(&[16, 32, 0], &[0, 0, 1], &numbers).unwrap();
    state.marks_mut().select(vec![16, 20, 32], vec![]).unwrap();
    assert!(state.gizmo().is_none(), "it is not wanted yet");
    state.take_changes();
    state.want_gizmo(|wanted| wanted.shown = true);
    assert!(state.changes().view);
    let middle = state.mesh().relative((targets[0] + targets[1]) * 0.5);
    let expected = state.camera().eye().project(middle).0;
    assert!((state.gizmo().unwrap().middle - expected).length() < 1e-2);

    let upwards = state.gizmo().unwrap().best(DragDirection::Axis(2)).unwrap();
    assert_eq!(state.gizmo().unwrap().pick(upwards), Some(DragDirection::Axis(2)));
    state.hold_gizmo(upwards);
    let way = state.constrain_move(DragDirection::Axis(2), Vec2::new(0.0, -50.0)).unwrap();
    assert!(way.x == 0.0 && way.y == 0.0 && way.z > 0.0);

    state.marks_mut().select(vec![20], vec![]).unwrap();
    assert!(state.gizmo().is_none(), "a selected vertex is no handle");
}

#[test]
fn a_zoom_keeps_the_surface_under_the_cursor() {
    let mut state = state(6, bump);
    let vertex = 24;
    let before = state.screen(vertex).unwrap();
    for _ in 0..10 {
        state.zoom(1.25, before);
    }
    assert!((state.screen(vertex).unwrap() - before).length() < 1.0);
    for _ in 0..400 {
        state.zoom(1.25, before);
    }
    assert!(state.camera().distance > 0.0);
    let (near, far) = state.depth_range();
    assert!(near > 0.0 && near < far);
}

#[test]
fn changing_the_vertical_axis_frames_again() {
    let mut state = state(6, bump);
    state.set_up(UpAxis::Y);
    let eye = state.camera().eye();
    assert_eq!(eye.right.y, 0.0);
    for &point in &state.mesh().positions {
        let (at, depth) = eye.project(point);
        assert!(depth > 0.0 && at.min(CANVAS - at).min_element() > 0.0);
    }
}

#[test]
fn frames_some_vertices_closely() {
    let mut state = state(20, bump);
    let whole = state.camera().distance;
    state.fit_vertices(&[0, 1, 21, 22]).unwrap();
    assert!(state.camera().distance < 0.3 * whole);
    assert!(state.screen(0).is_some());
    assert!(state.fit_vertices(&[9999]).is_err());
    let before = state.camera();
    state.fit_vertices(&[]).unwrap();
    assert_eq!(state.camera(), before);
}

#[test]
fn handles_that_do_not_fit_are_refused_and_the_old_ones_stay() {
    let mut state = state(2, bump);
    state.set_handles(&[1, 2], &[0, 2], &[0.0; 6]).unwrap();
    state.take_changes();
    for (vertices, states, targets) in [
        (&[1, 99][..], &[0, 0][..], &[0.0; 6][..]),
        (&[1, 2], &[0], &[0.0; 6]),
        (&[1, 2], &[0, 3], &[0.0; 6]),
        (&[1, 2], &[0, 0], &[0.0; 3]),
        (&[1, 2], &[0, 0], &[0.0, 0.0, 0.0, 0.0, f64::NAN, 0.0]),
    ] {
        assert!(state.set_handles(vertices, states, targets).is_err());
    }
    assert_eq!(state.handles().len(), 2);
    assert!(!state.changes().any());
    // A moved target changes only the targets: the vertices and the dots stay the same.
    state.set_handles(&[1, 2], &[0, 2], &[1.0; 6]).unwrap();
    assert_eq!(state.changes(), Changes { targets: true, ..Changes::default() });
}

#[test]
fn fitted_shapes_come_into_view_coordinates_with_all_their_digits() {
    let mut state = state(2, |_, _| 0.0);
    state.set_shapes(&[0.0, 5.0, 5.0, 1.0, 0.0, 0.0, 1.0, 2.0]).unwrap();
    assert_eq!(state.shapes(), [FittedShape::Circle(Vec3::Z, Vec3::Z, 2.0)]);
    state.set_shapes(&[1.0, f64::NAN, 5.0, 1.0, 0.0, 0.0, 1.0, 2.0]).unwrap();
    assert!(state.shapes().is_empty());
    assert!(state.set_shapes(&[0.0; 7]).is_err());
    // At site coordinates, the centre is rounded only relative to that of the view.
    let (faces, positions) = sheet(2, DVec3::splat(2.0e9), |_, _| 0.0);
    state.set_mesh(faces, (vec![], vec![]), &positions).unwrap();
    let [x, y, z] = [5.25, 5.0, 1.0].map(|at| 2.0e9 + at);
    state.set_shapes(&[0.0, x, y, z, 0.0, 0.0, 1.0, 2.0]).unwrap();
    assert_eq!(state.shapes(), [FittedShape::Circle(Vec3::new(0.25, 0.0, 1.0), Vec3::Z, 2.0)]);
}

#[test]
fn meshes_without_faces_or_points_can_be_looked_at() {
    let mut state = ViewState::default();
    state.resize(CANVAS);
    state.set_mesh((vec![], vec![]), (vec![], vec![]), &[]).unwrap();
    assert!(state.vertices_in(&rectangle(Vec2::ZERO, CANVAS), false).is_empty());
    assert_eq!(state.pick_face(CANVAS * 0.5), None);
    let points = [0.0, 0.0, 0.0, 1.0, 2.0, 3.0];
    state.set_mesh((vec![], vec![]), (vec![0, 2], vec![0, 1]), &points).unwrap();
    assert_eq!(state.vertices_in(&rectangle(Vec2::ZERO, CANVAS), false), [0, 1]);
    let at = state.screen(1).unwrap();
    assert_eq!(state.pick_vertex(at, 5.0), Some(1));
    state.zoom(2.0, at);
    let bad = state.set_mesh((vec![0, 3], vec![0, 1, 7]), (vec![], vec![]), &points);
    assert!(bad.unwrap_err().to_string().contains("found 7"));
}

#[test]
fn a_flat_map_is_seen_from_above_without_distortion() {
    let model = state(4, |x, y| 3.0 * x * y);
    let uv: Vec<f64> = (0..25).flat_map(|v| [100.0 + f64::from(v % 5), f64::from(v / 5)]).collect();
    let (mut map, checks) = flat_map(&model, &uv, &[]).unwrap();
    assert_eq!(checks.extent(), Vec2::splat(4.0));
    map.resize(CANVAS);
    let at = |map: &ViewState, v: u32| map.screen(v).unwrap();
    // The first coordinate points right, the second up, and the scale is uniform.
    let [origin, right, up] = [0, 4, 20].map(|v| at(&map, v));
    let (along, across) = (right - origin, up - origin);
    assert!(along.x > 100.0 && along.y.abs() < 0.1 && across.x.abs() < 0.1, "{along} {across}");
    assert!((along.x + across.y).abs() < 0.1);
    let before = at(&map, 12);
    map.pan(30.0, -12.0);
    assert!((at(&map, 12) - before - Vec2::new(30.0, -12.0)).length() < 0.1);
    map.zoom(2.0, at(&map, 12));
    assert!((at(&map, 12) - before - Vec2::new(30.0, -12.0)).length() < 0.1);
    assert!(flat_map(&model, &uv[..40], &[]).is_err());
}

#[test]
fn a_flat_map_has_the_marks_and_the_theme_of_the_model() {
    let mut model = state(2, |_, _| 0.0);
    let (mut map, _) = flat_map(&model, &[0.0; 18], &[]).unwrap();
    map.take_changes();
    model.take_changes();
    follow(&mut map, &model);
    assert!(!map.changes().any());
    model.marks_mut().select(vec![], vec![3]).unwrap();
    model.set_dark(true);
    model.appearance_mut().set_map(ColourMap::Cividis, None);
    follow(&mut map, &model);
    // The legend beside both is of this map.
    assert_eq!(map.appearance().map(), model.appearance().map());
    assert!(map.changes().appearance && map.changes().view && map.is_dark());
    assert_eq!(map.appearance().bytes(4)[14], 255);
}

#[test]
fn faces_that_a_flat_map_turns_over_are_outlined_on_it_alone() {
    let model = state(2, |_, _| 0.0);
    let uv = [0.0; 18];
    let (map, _) = flat_map(&model, &uv, &[0, 1]).unwrap();
    // The outline of two adjacent quads, including their common side.
    assert_eq!(map.flipped(), [[0, 1], [0, 3], [1, 2], [1, 4], [2, 5], [3, 4], [4, 5]]);
    assert!(model.flipped().is_empty());
    assert!(flat_map(&model, &uv, &[4]).is_err());
}

#[test]
fn what_a_flat_map_turns_over_is_shown_large_and_from_its_front() {
    // Two facing floors: the lower one hides the upper one from below.
    let mut model = two_floors();
    let uv: Vec<f64> = (0..8).flat_map(|v| [f64::from(v % 4 / 2), f64::from(v / 4)]).collect();
    let uv: Vec<f64> = uv.iter().map(|x| x * 50.0).collect();
    let (mut map, _) = flat_map(&model, &uv, &[]).unwrap();
    map.resize(CANVAS);
    model.preset("bottom").unwrap();
    assert_eq!(model.screen(4), None);
    let (before, small) = (model.camera(), map.camera());
    show_flipped(&mut map, &mut model);
    assert!(model.camera() == before && map.camera() == small, "there is nothing to show");

    let (mut map, _) = flat_map(&model, &uv, &[1]).unwrap();
    map.resize(CANVAS);
    show_flipped(&mut map, &mut model);
    for v in 4..8 {
        assert!(model.screen(v).is_some() && map.screen(v).is_some(), "{v}");
    }
    let large = |state: &ViewState| (state.screen(6).unwrap() - state.screen(4).unwrap()).length();
    assert!(large(&model) > 0.5 * CANVAS.y, "{}", large(&model));
    // Seen along its normal, it is as wide as it is high.
    let side = |a: u32, b: u32| (model.screen(a).unwrap() - model.screen(b).unwrap()).length();
    assert!((side(4, 5) - side(5, 6)).abs() < 1.0);
}

#[test]
fn a_kept_camera_comes_back_in_another_window_too() {
    let mut first = state(4, bump);
    first.orbit(70.0, 25.0);
    first.pan(40.0, -10.0);
    let kept = first.camera_numbers();
    let mut second = state(4, bump);
    second.place_camera(&kept);
    assert_eq!(second.camera(), first.camera());

    // A camera that frames everything does so in a narrower window too.
    let mut framed = state(4, bump);
    framed.preset("top").unwrap();
    let mut narrow = state(4, bump);
    narrow.resize(Vec2::new(300.0, 600.0));
    narrow.place_camera(&framed.camera_numbers());
    framed.resize(Vec2::new(300.0, 600.0));
    assert_eq!(narrow.camera(), framed.camera());

    // Invalid numbers change nothing.
    second.place_camera(&[0.0; 3]);
    second.place_camera(&[f64::NAN; 7]);
    second.place_camera(&[0.0; 7]);
    assert_eq!(second.camera(), first.camera());
}

#[test]
fn a_drag_turns_about_what_is_under_the_cursor() {
    let mut state = state(6, bump);
    let vertex = 24;
    let before = state.screen(vertex).unwrap();
    state.begin_turn(before);
    state.turn(60.0, 10.0);
    assert!((state.screen(vertex).unwrap() - before).length() < 1.0);
    // Beside the model the camera turns about the middle of the model, however it was panned
    // before.
    let mut other = self::state(6, bump);
    other.pan(80.0, 30.0);
    let middle = |state: &ViewState| {
        let low = state.mesh().positions.iter().copied().reduce(Vec3::min).unwrap();
        let high = state.mesh().positions.iter().copied().reduce(Vec3::max).unwrap();
        state.camera().eye().project((low + high) * 0.5).0
    };
    let before = middle(&other);
    other.begin_turn(Vec2::new(2.0, 2.0));
    other.turn(-90.0, 5.0);
    assert!((middle(&other) - before).length() < 1.0);
}
