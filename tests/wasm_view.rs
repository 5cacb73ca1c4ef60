//! The page's view in a real browser: it draws, and it returns positions on the screen.
#![allow(clippy::unwrap_used, reason = "a helper that fails here fails its test")]
#![cfg(all(target_arch = "wasm32", feature = "view"))]

use shape_up::web::page::View;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};
use web_sys::HtmlCanvasElement;

wasm_bindgen_test_configure!(run_in_browser);

/// Backend of the tested variant.
const BACKEND: &str = if cfg!(feature = "view-webgl2") { "webgl2" } else { "webgpu" };

const WIDTH: u32 = 320;
const HEIGHT: u32 = 240;

fn new_canvas() -> HtmlCanvasElement {
    let document = web_sys::window().unwrap().document().unwrap();
    document.create_element("canvas").unwrap().unchecked_into()
}

/// Opens a view that lives to the end of all tests: when a device of WebGPU is collected while another
/// draws, Chromium with software rendering hangs (one run in four).
async fn open(canvas: &HtmlCanvasElement) -> &'static mut View {
    let view = View::create(canvas.clone(), BACKEND.to_owned()).await.unwrap();
    let view = Box::leak(Box::new(view));
    view.resize(WIDTH, HEIGHT, 1.0);
    show_tent(view);
    view
}

/// Shows a square of two by two quads with its middle raised.
fn show_tent(view: &mut View) {
    let indices = vec![0, 1, 4, 3, 1, 2, 5, 4, 3, 4, 7, 6, 4, 5, 8, 7];
    view.set_mesh(vec![0, 4, 8, 12, 16], indices, vec![], vec![], &tent()).unwrap();
}

/// Vertices of the tent.
fn tent() -> Vec<f64> {
    let mut positions = flat_square();
    positions[14] = 1.0;
    positions
}

/// Three by three vertices in a plane.
fn flat_square() -> Vec<f64> {
    (0..9).flat_map(|v| [f64::from(v % 3), f64::from(v / 3), 0.0]).collect()
}

/// RGBA bytes of the canvas; valid only in the same task as the drawing.
fn pixels(canvas: &HtmlCanvasElement) -> Vec<u8> {
    let copy = new_canvas();
    copy.set_width(canvas.width());
    copy.set_height(canvas.height());
    let flat = copy.get_context("2d").unwrap().unwrap();
    let flat = flat.unchecked_into::<web_sys::CanvasRenderingContext2d>();
    flat.draw_image_with_html_canvas_element(canvas, 0.0, 0.0).unwrap();
    let (width, height) = (f64::from(copy.width()), f64::from(copy.height()));
    flat.get_image_data(0.0, 0.0, width, height).unwrap().data().0
}

fn differing(a: &[u8], b: &[u8]) -> usize {
    a.chunks(4).zip(b.chunks(4)).filter(|(p, q)| p != q).count()
}

fn distinct_colours(pixels: &[u8]) -> usize {
    let mut colours: Vec<&[u8]> = pixels.chunks(4).collect();
    colours.sort_unstable();
    colours.dedup();
    colours.len()
}

fn message(error: &JsValue) -> String {
    error.unchecked_ref::<js_sys::Error>().message().into()
}

#[wasm_bindgen_test]
async fn draws_a_mesh_once_and_again_only_when_something_changed() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    assert_eq!(view.backend(), BACKEND);
    assert!(view.needs_draw());
    assert!(view.draw().unwrap());
    assert!(distinct_colours(&pixels(&canvas)) > 20);
    assert!(!view.needs_draw());
    assert!(!view.draw().unwrap());
    view.orbit(40.0, 10.0);
    assert!(view.needs_draw() && view.draw().unwrap());
}

#[wasm_bindgen_test]
async fn every_switch_changes_the_picture() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    view.draw().unwrap();
    let mut before = pixels(&canvas);
    let mut check = |view: &mut View, what: &str| {
        assert!(view.draw().unwrap(), "{what}: nothing was drawn");
        let after = pixels(&canvas);
        let count = differing(&before, &after);
        assert!(count > 20, "{what}: only {count} pixels differ");
        before = after;
    };
    view.set_display(true, true, false, false, false, true);
    check(view, "vertices");
    view.set_display(false, false, false, false, false, true);
    check(view, "no edges");
    let two_colours = [0.1, 0.3, 0.9, 0.9, 0.2, 0.2];
    view.set_row_colours(vec![1, 2, 0, 0], vec![], &two_colours).unwrap();
    check(view, "colours of rows on faces");
    view.set_row_colours(vec![1, 2, 0, 0], vec![0, 0, 0, 0, 2, 1, 0, 0, 0], &two_colours).unwrap();
    check(view, "colours of rows on vertices");
    view.set_face_values(Some(vec![0.0, 0.3, 0.6, f32::NAN]), 0.0, 1.0, None, None).unwrap();
    check(view, "values");
    view.set_display(true, false, false, false, false, true);
    check(view, "edges between values");
    view.set_display(false, false, false, false, false, true);
    check(view, "no edges between values");
    view.set_selection(vec![4], vec![1]).unwrap();
    view.set_edges(&[0, 1, 1, 4]).unwrap();
    view.set_selected_edges(&[1]).unwrap();
    check(view, "selection");
    view.set_seams(&[3, 4]).unwrap();
    check(view, "seam");
    view.set_tint(vec![0, 1], vec![0], 0.1, 0.7, 0.2).unwrap();
    check(view, "tint");
    view.set_handles(&[2, 6], &[0, 1], &[2.0, 0.0, 0.5, 0.0, 2.0, 0.0]).unwrap();
    check(view, "handles");
    view.set_shapes(&[0.0, 1.0, 1.0, 0.5, 0.0, 0.0, 1.0, 0.8]).unwrap();
    view.set_display(false, false, true, false, false, true);
    check(view, "circle");
    view.set_shapes(&[1.0, 1.0, 1.0, 0.5, 0.0, 0.0, 1.0, 1.1]).unwrap();
    check(view, "sphere");
    // The raised middle moves down, the middle of a side moves up.
    let displacements = [0.0, 0.0, -0.6, 0.5, 0.0, 0.4];
    view.set_projections(&[4, 1], &displacements, &[1, 2], &[0, 1], &two_colours).unwrap();
    view.set_display(false, false, false, true, false, true);
    check(view, "outlines");
    view.set_display(false, false, false, false, true, true);
    check(view, "arrows");
    view.set_theme(true);
    check(view, "dark");
    view.set_up("y").unwrap();
    check(view, "up");
    view.preset("top").unwrap();
    check(view, "preset");
    view.zoom(2.0, 100.0, 100.0);
    check(view, "zoom");
    view.pan(30.0, 20.0);
    check(view, "pan");
    view.fit();
    check(view, "fit");
}

#[wasm_bindgen_test]
async fn within_the_tolerance_faces_look_as_without_values() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    let drawn = |view: &mut View| {
        view.draw().unwrap();
        pixels(&canvas)
    };
    let plain = drawn(view);
    let values = || Some(vec![0.0, 0.01, 0.3, 0.6]);
    view.set_face_values(values(), 0.0, 1.0, Some(1.0), None).unwrap();
    assert_eq!(differing(&plain, &drawn(view)), 0);
    // Two of four faces are beyond this limit.
    view.set_face_values(values(), 0.01, 1.0, Some(0.01), None).unwrap();
    let beyond = drawn(view);
    assert!(differing(&plain, &beyond) > 100);
    view.set_face_values(values(), 0.01, 1.0, Some(0.01), Some(true)).unwrap();
    assert!(differing(&beyond, &drawn(view)) > 100, "by logarithms");
    view.set_face_values(values(), 0.0, 1.0, None, None).unwrap();
    assert!(differing(&plain, &drawn(view)) > differing(&plain, &beyond), "all values");
    // In bands through the faces, too: if all vertices are within the limit, nothing is coloured.
    view.set_bands(true);
    view.set_corner_values(Some(vec![0.005; 9])).unwrap();
    view.set_face_values(Some(vec![0.005; 4]), 0.01, 1.0, Some(0.01), None).unwrap();
    assert_eq!(differing(&plain, &drawn(view)), 0);
}

#[wasm_bindgen_test]
async fn moved_vertices_are_seen_and_can_be_pointed_at() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    view.draw().unwrap();
    let before = pixels(&canvas);
    let at = view.screen(4).unwrap();
    let (x, y) = (at[0] as f32, at[1] as f32);
    assert_eq!(view.pick_vertex(x, y, 8.0), Some(4));
    view.hold_vertex(4, Some(x), Some(y)).unwrap();
    let way = view.constrain_move("screen", 30.0, 20.0).unwrap().unwrap();
    let mut positions = tent();
    positions[12..15].iter_mut().zip(&way).for_each(|(place, by)| *place += by);
    view.set_positions(&positions).unwrap();
    view.draw().unwrap();
    assert!(differing(&before, &pixels(&canvas)) > 200);
    let moved = view.screen(4).unwrap();
    assert!((moved[0] - at[0] - 30.0).abs() < 0.1 && (moved[1] - at[1] - 20.0).abs() < 0.1);
    assert!(view.pick_face(moved[0] as f32, moved[1] as f32 + 5.0).is_some());
    let (width, height) = (WIDTH as f32, HEIGHT as f32);
    let whole = [0.0, 0.0, width, 0.0, width, height, 0.0, height];
    assert!(view.vertices_in(&whole, false).contains(&4));
}

#[wasm_bindgen_test]
async fn without_faces_curves_are_drawn_and_without_curves_dots() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    view.set_mesh(vec![], vec![], vec![0, 3], vec![0, 4, 8], &flat_square()).unwrap();
    assert!(view.draw().unwrap());
    let curves = pixels(&canvas);
    assert!(distinct_colours(&curves) > 3);
    view.set_mesh(vec![], vec![], vec![], vec![], &flat_square()).unwrap();
    assert!(view.draw().unwrap());
    let dots = pixels(&canvas);
    assert!(distinct_colours(&dots) > 3 && differing(&curves, &dots) > 50);
}

#[wasm_bindgen_test]
async fn wrong_input_is_thrown_with_a_complete_message() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    let wrong = view.set_positions(&[0.0; 5]).unwrap_err();
    assert_eq!(message(&wrong), "positions: 5 entries, expected 27");
    let wrong = view.set_up("x").unwrap_err();
    assert_eq!(message(&wrong), "up: \"x\", expected z or y");
    assert!(view.set_face_values(Some(vec![1.0]), 0.0, 1.0, None, None).is_err());
    assert!(view.set_projections(&[9], &[0.0; 3], &[1], &[], &[0.0; 3]).is_err());
    let wrong = view.set_row_colours(vec![1; 4], vec![], &[]).unwrap_err();
    assert_eq!(message(&wrong), "colours of faces: found 1, expected an index below 1");
    assert!(view.draw().unwrap());
    let nothing = View::create(canvas.clone(), "vulkan".to_owned()).await.unwrap_err();
    assert_eq!(message(&nothing), format!("backend \"vulkan\", expected {BACKEND}"));
}

#[wasm_bindgen_test]
async fn a_huge_canvas_is_clamped_and_drawn() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    view.resize(40_000, 20, 2.0);
    assert!(canvas.width() < 40_000);
    view.resize(WIDTH, HEIGHT, 2.0);
    assert_eq!((canvas.width(), canvas.height()), (WIDTH, HEIGHT));
    assert!(view.draw().unwrap());
    assert!(distinct_colours(&pixels(&canvas)) > 20);
}

#[wasm_bindgen_test]
async fn a_lost_context_is_thrown_by_draw() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    view.draw().unwrap();
    canvas.dispatch_event(&web_sys::Event::new("webglcontextlost").unwrap()).unwrap();
    view.orbit(1.0, 1.0);
    assert!(message(&view.draw().unwrap_err()).contains("lost"));
}

#[wasm_bindgen_test]
async fn a_flat_map_shares_the_canvas_and_goes_away_again() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    view.resize(600, 300, 1.0);
    view.draw().unwrap();
    let alone = pixels(&canvas);
    assert!(view.map_region().is_none());
    let uv: Vec<f64> = (0..9).flat_map(|v| [f64::from(v % 3), f64::from(v / 3)]).collect();
    view.set_map(&uv, &[]).unwrap();
    assert_eq!(view.map_region().unwrap(), [300.0, 0.0, 300.0, 300.0]);
    assert!(view.draw().unwrap());
    let plain = pixels(&canvas);
    assert!(differing(&alone, &plain) > 5000);
    assert!(!view.needs_draw());

    // Numbers of differing pixels in the left and the right half of the picture.
    let sides = |a: &[u8], b: &[u8]| {
        let differs = |left: bool| {
            let of_side = |&(k, _): &(usize, _)| (k % 600 < 300) == left;
            let both = a.chunks(4).zip(b.chunks(4)).enumerate();
            both.filter(of_side).filter(|(_, (p, q))| p != q).count()
        };
        [differs(true), differs(false)]
    };
    view.set_map_looks(8.0, true, false, None, 1.0, 2.0).unwrap();
    view.draw().unwrap();
    let [model, map] = sides(&plain, &pixels(&canvas));
    assert!(model > 2000 && map == 0, "{model} {map}");
    view.set_map_looks(8.0, false, false, Some(vec![1.0, 1.5, 2.0, f32::NAN]), 1.0, 2.0).unwrap();
    view.draw().unwrap();
    let coloured = pixels(&canvas);
    let [model, map] = sides(&plain, &coloured);
    assert!(model == 0 && map > 2000, "{model} {map}");
    view.pan_map(20.0, 0.0);
    view.zoom_map(1.5, 150.0, 150.0);
    view.draw().unwrap();
    let [model, map] = sides(&coloured, &pixels(&canvas));
    assert!(model == 0 && map > 2000, "{model} {map}");
    // The map does not prevent picking on the model.
    let at = view.screen(4).unwrap();
    assert_eq!(view.pick_vertex(at[0] as f32, at[1] as f32, 12.0), Some(4));

    assert!(view.set_map(&uv[..8], &[]).is_err());
    view.clear_map();
    view.draw().unwrap();
    assert_eq!(differing(&alone, &pixels(&canvas)), 0);
}

#[wasm_bindgen_test]
async fn faces_that_the_flat_map_turns_over_are_outlined_in_red() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    view.resize(600, 300, 1.0);
    let uv: Vec<f64> = (0..9).flat_map(|v| [f64::from(v % 3), f64::from(v / 3)]).collect();
    let red = |view: &mut View| {
        view.draw().unwrap();
        let drawn = pixels(&canvas);
        let is_red = |p: &&[u8]| p[0] > 180 && p[1] < 90 && p[2] < 90;
        let of_side = |left: bool| {
            let side = drawn.chunks(4).enumerate().filter(|(k, _)| (k % 600 < 300) == left);
            side.filter(|(_, p)| is_red(p)).count()
        };
        [of_side(true), of_side(false)]
    };
    view.set_map(&uv, &[]).unwrap();
    assert_eq!(red(view), [0, 0]);
    view.set_map(&uv, &[2]).unwrap();
    let [model, map] = red(view);
    assert!(model == 0 && map > 300, "{model} {map}");
    // Closer up, its outline is longer.
    view.show_flipped();
    let [_, nearer] = red(view);
    assert!(nearer > map, "{nearer} {map}");
    assert!(view.set_map(&uv, &[4]).is_err());
}

#[wasm_bindgen_test]
async fn another_mesh_takes_the_flat_map_away() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    view.set_map(&[0.0; 18], &[]).unwrap();
    show_tent(view);
    assert!(view.map_region().is_some(), "the same faces only move");
    view.set_mesh(vec![0, 3], vec![0, 1, 2], vec![], vec![], &flat_square()[..9]).unwrap();
    assert!(view.map_region().is_none());
    assert!(view.draw().unwrap());
}

#[wasm_bindgen_test]
async fn bands_isolines_and_the_ground_are_seen() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    view.preset("top").unwrap();
    view.set_rest(&flat_square()).unwrap();
    let show = |view: &mut View, k: f32| {
        let values = Some(vec![0.1 * k, 0.3 * k, 0.6 * k, 0.9 * k]);
        view.set_face_values(values, 0.0, f64::from(k), None, None).unwrap();
    };
    show(view, 20.0);
    view.draw().unwrap();
    let mut before = pixels(&canvas);
    let mut changes = |view: &mut View, what: &str| {
        assert!(view.draw().unwrap(), "{what}: nothing was drawn");
        let after = pixels(&canvas);
        let count = differing(&before, &after);
        assert!(count > 30, "{what}: {count} pixels differ");
        before = after;
    };
    assert_eq!(view.band_step(), None);
    view.set_bands(true);
    changes(view, "bands");
    assert_eq!(view.band_step(), Some(2.0));
    assert_eq!(view.ramp_colours().len(), view.band_limits().len() + 1);
    // Isolines follow the values of the vertices through the faces.
    view.set_corner_values(Some((0..9).map(|v| 2.0 * v as f32).collect())).unwrap();
    changes(view, "isolines");
    view.set_surroundings(false, true);
    changes(view, "ground");
    show(view, 1.0);
    assert_eq!(view.band_step(), Some(0.2));
}

#[wasm_bindgen_test]
async fn the_ghost_is_a_veil_that_never_stains_a_surface_in_the_same_place() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    view.set_rest(&tent()).unwrap();
    // Colours at the centres of the faces, away from all lines.
    let middles = |view: &View| {
        let drawn = pixels(&canvas);
        let colour = |face: [u32; 4]| {
            let at = face.map(|v| view.screen(v));
            let known: Vec<Vec<f64>> = at.into_iter().flatten().collect();
            (known.len() == 4).then(|| {
                let [x, y] = [0, 1].map(|axis| known.iter().map(|p| p[axis]).sum::<f64>() / 4.0);
                let place = 4 * (y as usize * WIDTH as usize + x as usize);
                drawn[place..place + 3].to_vec()
            })
        };
        [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]].map(colour)
    };
    let mut seen = 0;
    for parallel in [false, true] {
        view.set_parallel(parallel);
        for turn in 0..12 {
            view.orbit(13.0, if turn < 6 { 5.0 } else { -9.0 });
            let [without, with] = [false, true].map(|ghost| {
                view.set_surroundings(ghost, false);
                view.draw().unwrap();
                middles(view)
            });
            assert_eq!(without, with, "turn {turn}");
            seen += with.iter().flatten().count();
        }
    }
    assert!(seen > 40, "{seen}");

    // After the mesh has moved away, the original is visible in front of the mesh and beside it.
    view.set_surroundings(false, false);
    view.set_parallel(false);
    view.preset("top").unwrap();
    let sunken: Vec<f64> = tent().chunks(3).flat_map(|p| [p[0], p[1], p[2] - 1.5]).collect();
    view.set_positions(&sunken).unwrap();
    view.draw().unwrap();
    let without = middles(view);
    view.set_surroundings(true, false);
    view.draw().unwrap();
    for (before, after) in without.into_iter().zip(middles(view)) {
        assert_ne!(before, after);
    }
}

#[wasm_bindgen_test]
async fn projected_shapes_have_an_inside_where_they_lie_beside_their_faces() {
    let canvas = new_canvas();
    let view = open(&canvas).await;
    view.preset("top").unwrap();
    view.set_display(false, false, false, true, false, true);
    let ring = [0, 1, 1, 2, 2, 3, 0, 3];
    let show = |view: &mut View, up: f32| {
        let displacements = [0.0, 0.0, up].repeat(4);
        let blue = [0.1, 0.3, 0.9];
        view.set_projections(&[0, 1, 4, 3], &displacements, &[1; 4], &ring, &blue).unwrap();
        view.draw().unwrap();
        pixels(&canvas)
    };
    view.set_projections(&[], &[], &[], &[], &[]).unwrap();
    view.draw().unwrap();
    let bare = pixels(&canvas);
    let lying = differing(&bare, &show(view, 0.0));
    let clear = differing(&bare, &show(view, 0.4));
    // Only lines at first, then most of a quarter of the tent.
    assert!(lying > 50 && clear > 3 * lying, "{lying} {clear}");
}
