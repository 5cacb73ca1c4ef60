//! Boundary curves: corners, the closest point, and the effect of boundary closeness on a shape.

use crate::support::drag;
use crate::support::meshes::grid;
use crate::support::random::Random;
use proptest::prelude::*;
use shape_up::generate::model::Dome;
use shape_up::math::{Vec3, cosine};
use shape_up::mesh::{BoundaryCurves, Mesh, Point, Ragged, Surface, Topology};
use shape_up::scene::Scene;
use shape_up::session::{Edit, Session};

fn curves(mesh: &Mesh, corners: f64) -> BoundaryCurves {
    BoundaryCurves::new(&mesh.positions, &Topology::new(mesh), cosine(corners / 360.0))
}

/// Point of a closed polyline closest to `p`, by brute force over its segments.
fn closest_of_all(polyline: &[Vec3<f64>], p: Vec3<f64>) -> Vec3<f64> {
    let ends = polyline.iter().zip(polyline.iter().cycle().skip(1));
    let points = ends.map(|(&a, &b)| {
        let along = b - a;
        let t = (p - a).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
        a + along * t.clamp(0.0, 1.0)
    });
    let nearer = |a: &Vec3<f64>, b: &Vec3<f64>| (*a - p).length().total_cmp(&(*b - p).length());
    points.min_by(nearer).expect("a polyline has segments")
}

#[test]
fn the_closest_point_is_that_of_brute_force_and_of_the_own_loop() {
    let mesh = Dome::default().mesh();
    let topology = Topology::new(&mesh);
    let boundary = curves(&mesh, 45.0);
    assert_eq!(boundary.curves.len(), 2, "the eaves and the hole");
    let mut random = Random::new(7);
    for (curve, one) in boundary.curves.iter().zip(topology.boundary_loops().iter()) {
        let at = |v: &u32| Vec3::from(mesh.positions[*v as usize]);
        let polyline: Vec<_> = one.iter().map(at).collect();
        let mut hint = Surface::NO_HINT;
        let mut p = polyline[0];
        for k in 0..500 {
            // Mostly small moves, as those of vertices, and some large ones.
            let size = if k % 10 == 0 { 20.0 } else { 0.3 };
            p = closest_of_all(&polyline, p) + random.vector() * size;
            let found = Vec3::from(curve.curve.closest(p.into(), &mut hint));
            let expected = closest_of_all(&polyline, p);
            let (found, expected) = ((found - p).length(), (expected - p).length());
            assert!((found - expected).abs() <= 1e-12 * 20.0, "{p:?}: {found}, {expected}");
        }
    }
}

#[test]
fn corners_are_where_the_boundary_turns() {
    let square = grid(3, 3, |i, j| [f64::from(i), f64::from(j), 0.0]);
    assert_eq!(curves(&square, 45.0).corners, [0, 3, 12, 15]);
    assert_eq!(curves(&square, 89.0).corners, [0, 3, 12, 15]);
    assert!(curves(&square, 91.0).corners.is_empty());
    assert!(curves(&square, 180.0).corners.is_empty());
    // Without its last panel the outline has a reflex corner.
    let notched = Mesh { faces: square.faces.iter().take(8).collect(), ..square.clone() };
    assert_eq!(curves(&notched, 45.0).corners, [0, 3, 10, 11, 12, 14]);
    // Two vertices at the same point: the turn is measured between the edges next to them.
    let mut doubled = square.clone();
    doubled.positions[1] = doubled.positions[0];
    assert_eq!(curves(&doubled, 45.0).corners, [0, 1, 3, 12, 15]);
    // 48 vertices on the eaves; the greatest turn is at the rounded corners.
    let dome = Dome::default().mesh();
    assert!(curves(&dome, 45.0).corners.is_empty());
    assert!(!curves(&dome, 10.0).corners.is_empty());
    // The same corners at any scale and far from the origin.
    for (scale, offset) in [(1e-6, 0.0), (1e6, 0.0), (1.0, 1e6)] {
        let mut moved = dome.clone();
        moved.positions.as_flattened_mut().iter_mut().for_each(|x| *x = *x * scale + offset);
        assert_eq!(curves(&moved, 10.0).corners, curves(&dome, 10.0).corners, "{scale} {offset}");
    }
}

#[test]
fn a_vertex_on_two_loops_and_the_end_of_an_open_row_are_corners() {
    // Two squares that share one vertex.
    let positions = [[0., 0.], [1., 0.], [1., 1.], [0., 1.], [2., 1.], [2., 2.], [1., 2.]];
    let mesh = Mesh {
        positions: positions.map(|[x, y]| [x, y, 0.0]).to_vec(),
        faces: Ragged::from_iter([[0, 1, 2, 3], [2, 4, 5, 6]]),
        ..Mesh::default()
    };
    assert_eq!(curves(&mesh, 180.0).corners, [2]);
    // Three triangles at one edge: each has an open boundary chain between the ends of the edge.
    let fins = Mesh {
        positions: vec![[0., 0., 0.], [1., 0., 0.], [0.5, 1., 0.], [0.5, -1., 0.], [0.5, 0., 1.]],
        faces: Ragged::from_iter([[0, 1, 2], [0, 1, 3], [0, 1, 4]]),
        ..Mesh::default()
    };
    assert_eq!(curves(&fins, 180.0).corners, [0, 1]);
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(64))]

    #[test]
    fn each_boundary_vertex_is_a_corner_or_on_one_curve(
        mesh in crate::support::meshes::mixed(),
        corners in 0.0..180.0f64,
    ) {
        let topology = Topology::new(&mesh);
        let boundary = curves(&mesh, corners);
        let mut found: Vec<u32> = boundary.curves.iter().flat_map(|c| c.vertices.clone()).collect();
        found.extend(&boundary.corners);
        found.sort_unstable();
        let mut expected = topology.boundary_loops().indices().to_vec();
        expected.sort_unstable();
        expected.dedup();
        prop_assert_eq!(found, expected);
    }
}

/// A flat grid of 8 by 8 quads that is finer at one corner.
fn graded() -> Mesh {
    let at = |k: u32| f64::from(k * (k + 4)) / 12.0;
    grid(8, 8, |i, j| [at(i), at(j), 0.0])
}

/// Square panels, so that vertices move far along the border; a circle on the border, and a handle
/// that lifts the middle.
fn shaped(closeness: &str) -> Session {
    let scene = Scene::from_json(&format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }},
            "constraints": [{{ "kind": "square", "on": "faces" }},
                            {{ "kind": "circle", "on": "boundary" }}],
            "handles": [{{ "vertices": [40], "targets": [[3, 3, 3]], "weight": 1 }}],
            "weights": {{ "shape": 1, "close": 1e-3 }}, "closeness": {{ {closeness} }},
            "solver": {{ "iterations": 400 }} }}"#
    ));
    Session::open(scene.expect("the scene is valid"), graded()).expect("it is regular")
}

const HELD: &str =
    r#""boundary": { "corners": 45 }, "weights": [{ "on": "boundary", "weight": 1e9 }]"#;

/// Greatest distance of a border vertex from the line of its side, and its greatest displacement
/// along the side.
fn border_moves(positions: &[Point]) -> [f64; 2] {
    let rest = graded().positions;
    let [mut off, mut along] = [0.0f64; 2];
    for k in 0..=8 {
        // For each side, the vertex and the coordinate along the side.
        for (v, i) in [(k, 0), (72 + k, 0), (9 * k, 1), (9 * k + 8, 1)] {
            let moved: [f64; 3] = std::array::from_fn(|c| (positions[v][c] - rest[v][c]).abs());
            off = off.max(moved[1 - i]).max(moved[2]);
            along = along.max(moved[i]);
        }
    }
    [off, along]
}

#[test]
fn a_straight_border_stays_straight_and_its_corners_stay() {
    let mut free = shaped("");
    free.solve(false).expect("positions stay finite");
    assert!(border_moves(&free.positions())[0] > 0.1, "the forces bend a border that is free");

    let mut held = shaped(HELD);
    held.solve(false).expect("positions stay finite");
    let positions = held.positions();
    let [off, along] = border_moves(&positions);
    assert!(off < 1e-6, "the border is straight: {off}");
    assert!(along > 0.3, "its vertices glide: {along}");
    for corner in [0, 8, 72, 80] {
        assert_eq!(positions[corner], graded().positions[corner], "a corner stays to the last bit");
    }
    assert!(held.report().pinned.is_empty(), "corners are no pins");
    let inside = positions.iter().map(|p| p[2].abs()).fold(0.0, f64::max);
    assert!(inside > 0.1, "the interior is not held by the border: {inside}");
}

#[test]
fn a_corner_that_becomes_a_handle_follows_it_and_comes_back() {
    let mut session = shaped(HELD);
    let corner = graded().positions[80];
    session.edit(Edit::AddHandles { vertices: vec![80], fixed: false }).expect("it fits");
    session.begin_drag();
    drag(&mut session, [(80, [corner[0] + 1.0, corner[1] + 1.0, 0.0])])
        .expect("the targets are near");
    for _ in 0..3 {
        session.step().expect("positions stay finite");
    }
    session.end_drag(true);
    assert!(session.positions()[80] != corner, "it is no longer fixed");
    session.edit(Edit::RemoveHandles { vertices: vec![80] }).expect("it fits");
    assert_eq!(session.positions()[80], corner);
    session.undo().expect("undo works");
    assert!(session.positions()[80] != corner, "undo gives it back to its handle");
    // A fixed handle takes precedence over the boundary.
    session.edit(Edit::AddHandles { vertices: vec![0], fixed: true }).expect("it fits");
    session.begin_drag();
    drag(&mut session, [(0, [-1.0, 0.0, 0.0])]).expect("the targets are near");
    assert_eq!(session.positions()[0], [-1.0, 0.0, 0.0]);
}

#[test]
fn the_interior_is_as_close_to_the_surface_as_without() {
    // Half a unit off the surface everywhere: the term of every vertex is the same with and without
    // the boundary, except for the corners, which are back at their positions.
    let raised: Vec<Point> = graded().positions.iter().map(|&[x, y, z]| [x, y, z + 0.5]).collect();
    let close = |closeness: &str| {
        let mut scene = shaped(closeness).scene();
        scene.current = Some(raised.clone());
        Session::open(scene, graded()).expect("it is regular").solver().energy().close
    };
    assert!((close("") - 81.0 * 0.25).abs() < 1e-12);
    assert!((close(r#""boundary": {}"#) - 77.0 * 0.25).abs() < 1e-12);
    assert!((close(r#""to": "none", "boundary": {}"#) - 28.0 * 0.25).abs() < 1e-12);
}
