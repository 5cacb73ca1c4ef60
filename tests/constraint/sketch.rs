//! The drawings of the kinds, and their colours.

use serde_json::json;
use shape_up::constraint::{Info, KINDS, Kind};

fn default(info: &Info) -> Kind {
    Kind::new(info.id, json!({})).unwrap_or_else(|error| panic!("{}: {error:?}", info.id))
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let [x, y] = [a[0] - b[0], a[1] - b[1]];
    (x * x + y * y).sqrt()
}

#[test]
fn every_kind_has_a_drawing_that_fills_the_unit_square() {
    for info in KINDS {
        let sketch = default(info).sketch();
        let id = info.id;
        assert_eq!(sketch.points.len(), sketch.projected.len(), "{id}");
        assert!(sketch.points.len() >= 2, "{id} draws {} points", sketch.points.len());
        assert!(sketch.lines.iter().flatten().all(|&i| i < sketch.points.len()), "{id}");
        let outlines = sketch.outlines.iter().flatten();
        let all: Vec<_> = sketch.points.iter().chain(&sketch.projected).chain(outlines).collect();
        let ends = [0, 1].map(|axis| {
            let along = all.iter().map(|point| point[axis]);
            [along.clone().fold(f64::INFINITY, f64::min), along.fold(f64::NEG_INFINITY, f64::max)]
        });
        assert!(ends.iter().all(|[low, high]| 0.0 <= *low && *high <= 1.0), "{id}: {ends:?}");
        let longest = ends.map(|[low, high]| high - low).into_iter().fold(0.0, f64::max);
        assert!(longest >= 1.0 - 1e-12, "{id}: {ends:?}");
        assert_eq!(sketch, default(info).sketch(), "{id}");
    }
}

#[test]
fn the_points_of_a_drawing_are_seen_to_move_but_stay_recognisable() {
    for info in KINDS {
        let sketch = default(info).sketch();
        let moved = sketch.points.iter().zip(&sketch.projected).map(|(a, b)| distance(*a, *b));
        let farthest = moved.fold(0.0, f64::max);
        assert!((0.03..0.7).contains(&farthest), "{}: {farthest}", info.id);
    }
}

/// The drawing shows the projection: four points of a square form a square on paper too, in an
/// oblique view.
#[test]
fn a_drawing_shows_the_shape() {
    let kind = |id| KINDS.iter().find(|info| info.id == id).map(default).expect("it is listed");
    let corners = kind("square").sketch().projected;
    let middle = |a: [f64; 2], b: [f64; 2]| [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
    let off = distance(middle(corners[0], corners[2]), middle(corners[1], corners[3]));
    assert!(off < 1e-12, "the diagonals halve each other but for {off}");

    let sphere = kind("sphere").sketch();
    let outline = &sphere.outlines[0];
    let centre = middle(outline[0], outline[outline.len() / 2]);
    let radius = distance(centre, outline[0]);
    assert!(outline.iter().all(|p| (distance(centre, *p) - radius).abs() < 1e-12));
    assert!(sphere.projected.iter().all(|p| distance(centre, *p) <= radius + 1e-12));
}

/// Paper Fig. 1: rigid areas are green, spheres red.
#[test]
fn areas_have_the_colours_of_the_first_figure() {
    let colour = |id: &str| KINDS.iter().find(|info| info.id == id).expect("it is listed").colour;
    let [red, green, blue] = colour("rigid");
    assert!(green > 2 * blue.max(red) - 20 && green > 120, "rigid is green");
    let [red, green, blue] = colour("sphere");
    assert!(red > 2 * green.max(blue), "a sphere is red");
}
