//! The example scenes: clean meshes, scenes that fit them, and something to optimise.

mod exercise;
mod gallery;
mod solved;
mod statements;

use shape_up::generate::example::EXAMPLES;
use shape_up::generate::example::{example_file, example_files};
use shape_up::generate::model::{Canopy, Dome, Mounds};
use shape_up::mesh::{Mesh, Point, Topology, components, diagnose, read, write_medit, write_obj};
use shape_up::scene::Scene;

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Twice the vector area of a polygon.
fn area_vector(points: &[Point]) -> Point {
    let mut sum = [0.0; 3];
    for k in 0..points.len() {
        let (a, b) =
            (minus(points[k], points[0]), minus(points[(k + 1) % points.len()], points[0]));
        for (i, total) in sum.iter_mut().enumerate() {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            *total += a[j] * b[k] - a[k] * b[j];
        }
    }
    sum
}

/// Number of boundary loops of the mesh of an example.
fn loops(id: &str) -> usize {
    match id {
        "dome" | "fig-01-triangles" | "fig-06-exploration" | "fig-09-polygons" => 2,
        "curves-slabs" | "other-transfer" | "other-spline" | "lesson-curvature-and-panels" => 2,
        "ring-pavilion" | "chalice-roof" => 2,
        "fig-01-tets" | "fig-07-quality" | "fig-08-protrusions" | "points-pavilion" => 0,
        "fig-10-collapse" | "fig-10-random" => 0,
        id if id.starts_with("fig-08-bar") => 0,
        _ => 1,
    }
}

fn meshes() -> Vec<(&'static str, Mesh, usize)> {
    let examples = EXAMPLES.iter().map(|e| (e.id, e.build().1, loops(e.id)));
    let small = [
        ("small canopy", Canopy { panels: [1, 2], ..Canopy::default() }.mesh(), 1),
        ("small dome", Dome { meridians: 4, rows: [0, 0] }.mesh(), 2),
        ("small mounds", Mounds { rows: 4, ..Mounds::default() }.mesh(), 1),
    ];
    examples.chain(small).collect()
}

#[test]
fn meshes_are_manifold_and_in_one_piece() {
    for (name, mesh, loops) in meshes() {
        assert_eq!(diagnose(&mesh), [], "{name}");
        assert_eq!(Topology::new(&mesh).boundary_loops().len(), loops, "{name}");
        if !mesh.faces.is_empty() {
            let tets = mesh.tets.iter().map(|tet| tet.as_slice());
            let labels = components(mesh.positions.len(), mesh.faces.iter().chain(tets));
            // The same vault twice, for comparison.
            let pieces = if name == "lesson-curvature-and-panels" { 2 } else { 1 };
            let most = labels.iter().max().copied().unwrap_or_default() as usize;
            assert_eq!(most + 1, pieces, "{name}");
        }
        let flat = mesh.positions.as_flattened();
        assert!(flat.iter().all(|x| x.is_finite()), "{name}");
    }
}

#[test]
fn twelve_models_stand_first_of_which_four_have_new_panels_on_a_surface_of_triangles() {
    let built: Vec<_> = EXAMPLES[..13].iter().map(|example| example.build().0).collect();
    assert!(EXAMPLES[12].id.starts_with("fig-"));
    assert!(EXAMPLES[..12].iter().all(|example| !example.id.starts_with("fig-")));
    assert!(built.iter().all(|scene| scene.lesson.is_none()));
    let has_surface = |scene: &&Scene| scene.closeness.target.is_some();
    assert_eq!(built[..12].iter().filter(has_surface).count(), 4);
}

#[test]
fn models_are_moderate_and_have_no_slivers() {
    for example in EXAMPLES {
        let (id, mesh) = (example.id, example.build().1);
        assert!((250..=3000).contains(&mesh.positions.len()), "{id}: {}", mesh.positions.len());
        for (f, face) in mesh.faces.iter().enumerate() {
            let points: Vec<Point> = face.iter().map(|&v| mesh.positions[v as usize]).collect();
            let sides = (0..points.len()).map(|k| minus(points[(k + 1) % points.len()], points[k]));
            let long = sides.map(|side| dot(side, side)).fold(0.0, f64::max);
            let area = area_vector(&points);
            let area = dot(area, area).sqrt() / 2.0;
            assert!(area > 0.05 * long, "{id}: face {f} has {area} on a side of {}", long.sqrt());
        }
    }
}

#[test]
fn the_polygons_of_fig_5_are_mixed() {
    let mesh = |id: &str| EXAMPLES.iter().find(|e| e.id == id).expect("there is one").build().1;
    let quads = mesh("fig-05-circular");
    assert!((1900..2200).contains(&quads.faces.len()));
    assert!(quads.faces.iter().all(|face| face.len() == 4));
    let mixed = mesh("fig-05-mixed");
    let corners = |n: usize| mixed.faces.iter().filter(|face| face.len() == n).count();
    assert!(corners(6) > 900 && corners(5) > 50 && corners(4) > 20 && corners(7) > 10);
    assert_eq!((4..=7).map(corners).sum::<usize>(), mixed.faces.len());
}

#[test]
fn panels_face_up_and_are_neither_slivers_nor_out_of_scale() {
    for (name, mesh, _) in meshes().into_iter().take(3) {
        for (f, face) in mesh.faces.iter().enumerate() {
            let points: Vec<Point> = face.iter().map(|&v| mesh.positions[v as usize]).collect();
            let area = area_vector(&points);
            assert!(area[2] > 0.0, "{name}: face {f} faces down");
            let sides: Vec<f64> = (0..points.len())
                .map(|k| minus(points[(k + 1) % points.len()], points[k]))
                .map(|side| dot(side, side).sqrt())
                .collect();
            let (short, long) =
                sides.iter().fold((f64::MAX, 0.0f64), |(s, l), &x| (s.min(x), l.max(x)));
            assert!(short > 0.3 && long < 4.0, "{name}: face {f} has sides {short} to {long} m");
            let area = dot(area, area).sqrt() / 2.0;
            assert!(area > 0.15 * long * long, "{name}: face {f} is a sliver of {area} square m");
        }
    }
}

#[test]
fn the_dome_has_quads_and_a_row_of_pentagons() {
    let dome = Dome::default();
    let mesh = dome.mesh();
    let corners = |n: usize| mesh.faces.iter().filter(|face| face.len() == n).count();
    assert_eq!(corners(5), dome.meridians);
    assert_eq!(corners(4) + corners(5), mesh.faces.len());
}

#[test]
fn meshes_and_scenes_come_back_from_their_files() {
    let mut ids = Vec::new();
    for example in EXAMPLES {
        let (scene, mesh) = example.build();
        let text = scene.to_json(&mesh);
        assert_eq!(Scene::from_json(&text).unwrap(), scene, "{text}");
        scene.validate(&mesh).unwrap();
        let text = match mesh.tets.is_empty() {
            true => write_obj(&mesh, &mesh.positions),
            false => write_medit(&mesh),
        };
        let again = read(&example.mesh_file(), text.as_bytes()).unwrap();
        assert_eq!(again.mesh, mesh, "{}", example.id);
        assert!(again.problems.is_empty(), "{}: {:?}", example.id, again.problems);
        ids.push(example.id);
    }
    assert_eq!(ids[0], "canopy", "the page opens the first");
    let figures: Vec<_> = ids.iter().filter(|id| id.starts_with("fig-")).collect();
    assert!(figures.is_sorted_by_key(|id| &id[..6]), "by the figures of the paper: {ids:?}");
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), EXAMPLES.len());
}

#[test]
fn a_single_file_of_an_example_is_the_one_that_is_written_with_all() {
    for (name, text) in example_files() {
        let single = example_file(&name);
        assert!(single == Some(text) || name == "index.json" && single.is_none(), "{name}");
    }
    assert_eq!(example_file("canopy"), None);
}
