//! Single operators in a session: the results that users expect, not the method.

use crate::support::grid::grid;
use shape_up::math::{Vec3, cosine, sine};
use shape_up::mesh::{Mesh, Point, Surface, Topology, hinges, stars};
use shape_up::scene::Scene;
use shape_up::session::Session;

/// A solved session of a scene on `mesh` with the keys in `rest` appended.
fn solved(mesh: &Mesh, rest: &str) -> Session {
    let text = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }}, {rest},
              "solver": {{ "iterations": 1000, "tolerance": 1e-14 }} }}"#
    );
    let scene = Scene::from_json(&text).expect("the scene is valid");
    let mut session = Session::open(scene, mesh.clone()).expect("it is regular");
    session.solve(false).expect("positions stay finite");
    session
}

fn distance(a: Point, b: Point) -> f64 {
    (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt()
}

/// Nine by nine vertices at unit distance, centred at the origin.
fn square() -> Mesh {
    grid(8, 8, |i, j| [f64::from(i) - 4.0, f64::from(j) - 4.0, 0.0])
}

/// Map of a vertex of the square to its expected position.
type Image = fn(Point) -> Point;

#[test]
fn what_is_done_to_one_side_of_a_symmetric_roof_is_done_to_the_others() {
    let held = r#""handles": [{ "vertices": [0, 8, 72, 80], "fixed": true },
                              { "vertices": [30], "targets": [[-1.5, -0.5, 2]] }],
                  "weights": { "shape": 1000, "smooth": 1 }"#;
    let mirror: &[Image] = &[|[x, y, z]| [-x, y, z]];
    let quarters: &[Image] = &[|[x, y, z]| [-y, x, z], |[x, y, z]| [y, -x, z]];
    for (of, images) in
        [(r#""mirror": [1, 0, 0]"#, mirror), (r#""axis": [0, 0, 1], "fold": 4"#, quarters)]
    {
        let on = r#""on": { "vertices": "0-80" }"#;
        let row = format!(r#"{held}, "constraints": [{{ "kind": "symmetry", {on}, {of} }}]"#);
        let found = solved(&square(), &row).positions();
        assert!(found[30][2] > 0.5, "the handle pulls: {:?}", found[30]);
        let rest = square().positions;
        for (v, p) in rest.iter().zip(&found) {
            for image in images {
                let other = rest.iter().position(|u| distance(*u, image(*v)) < 0.5);
                let there = found[other.expect("the grid is symmetric")];
                let off = distance(image(*p), there);
                assert!(off < 0.01, "{of}: {v:?} is at {p:?}, its image at {there:?}");
            }
        }
    }
}

#[test]
fn a_symmetry_says_how_many_vertices_have_an_image() {
    let found = |mirror: &str, on: &str| {
        let row = format!(
            r#""constraints": [{{ "kind": "plane", "on": "faces" }},
                 {{ "kind": "symmetry", "on": {{ "vertices": "{on}" }}, "mirror": {mirror} }}]"#
        );
        let rows = solved(&square(), &row).report().unpaired;
        rows.iter()
            .map(|row| (row.constraint, row.paired.vertices, row.paired.of))
            .collect::<Vec<_>>()
    };
    // All vertices, a side without its middle plus one vertex, and a direction without symmetry.
    assert_eq!(found("[1, 0, 0]", "0-80"), []);
    assert_eq!(found("[1, 0, 0]", "0-3,5-8,20"), [(1, 8, 9)]);
    assert_eq!(found("[1, 0.2, 0]", "0-3,5-9"), [(1, 0, 9)]);
}

/// Returns whether a vertex is on the border of the square.
fn is_border(v: usize) -> bool {
    [v % 9, v / 9].iter().any(|&k| k == 0 || k == 8)
}

#[test]
fn a_border_glides_along_its_sides_while_the_inside_is_pulled() {
    let row = |more: &str| {
        format!(
            r#""constraints": [{{ "kind": "on-curve", "on": "boundary", "weight": 10 }}],
               "handles": [{{ "vertices": [20], "targets": [[0, 0, 0]] }}],
               "weights": {{ "shape": 100, "smooth": 1 }}{more}"#
        )
    };
    let mesh = square();
    let session = solved(&mesh, &row(""));
    assert!(session.report().pinned.is_empty(), "the border holds all: {:?}", session.report());
    let found = session.positions();
    for v in (0..81).filter(|&v| is_border(v)) {
        let (rest, found) = (mesh.positions[v], found[v]);
        let [x, y] = [0, 1].map(|i| (rest[i].abs() == 4.0, (found[i] - rest[i]).abs()));
        // Nothing moves across a side; the pull shows along it. A corner belongs to two sides.
        for (is_across, moved) in [x, y] {
            assert!(!is_across || moved < 0.01, "{rest:?} has left the border: {found:?}");
        }
    }
    assert!(distance(found[2], mesh.positions[2]) > 0.1, "it glides: {:?}", found[2]);
    for corner in [0, 8, 72, 80] {
        assert!(distance(found[corner], mesh.positions[corner]) < 0.01, "{:?}", found[corner]);
    }
}

#[test]
fn a_longest_edge_of_a_boundary_is_a_gap_only_if_the_row_says_so() {
    let places = [[0., 0.], [1., 1.], [2., 1.], [3., 0.]].map(|[x, y]| [x, y, 0.0]).to_vec();
    let mesh =
        Mesh { positions: places, faces: [[0, 1, 2, 3]].iter().collect(), ..Mesh::default() };
    let gap = |closed: &str| {
        let row = format!(r#"{{ "kind": "on-curve", "on": "boundary", "closed": "{closed}" }}"#);
        let session = solved(&mesh, &format!(r#""constraints": [{row}]"#));
        let members = &session.rows()[0].constraints.members;
        let [first, last] = [0, 3].map(|k| mesh.positions[members.row(0)[k] as usize]);
        distance(first, last)
    };
    assert_eq!(gap("no"), 3.0);
    assert!(gap("auto") < 2.0);
}

/// A strip of quads between two concentric rings of `n` vertices; the outer one is the unit circle.
fn annulus(n: u32) -> Mesh {
    let mut mesh = grid(n, 1, |i, j| {
        let (turn, radius) = (f64::from(i % n) / f64::from(n), 1.0 - 0.4 * f64::from(j));
        [radius * cosine(turn), radius * sine(turn), 0.0]
    });
    // Identifies the last column with the first.
    let around = |v: u32| v / (n + 1) * (n + 1) + v % (n + 1) % n;
    let faces = mesh.faces.iter().map(|face| face.iter().map(|&v| around(v)).collect::<Vec<_>>());
    mesh.faces = faces.collect();
    mesh
}

#[test]
fn a_rim_glides_on_the_spline_through_its_vertices() {
    let n = 16;
    let mesh = annulus(n);
    let rim = (0..n as usize).filter(|v| *v != 0);
    let glided = |between: &str| {
        let on = format!(r#"{{ "vertices": "0-{}" }}"#, n - 1);
        let row = format!(
            r#""constraints": [{{ "kind": "on-curve", "on": {on}, "closed": "yes", "between": "{between}" }}],
               "handles": [{{ "vertices": [0], "targets": [[0.96, 0.4, 0]] }},
                           {{ "vertices": "17-32", "fixed": true }}],
               "weights": {{ "shape": 1000, "smooth": 1 }}"#
        );
        solved(&mesh, &row).positions()
    };
    // Greatest distance of a rim vertex from the unit circle, the rest shape of the rim.
    let off = |found: &[Point]| {
        let away = rim.clone().map(|v| (Vec3::from(found[v]).length() - 1.0).abs());
        away.fold(0.0, f64::max)
    };
    let [straight, spline] = ["straight", "spline"].map(glided);
    assert!(distance(spline[1], mesh.positions[1]) > 0.1, "it glides: {:?}", spline[1]);
    // Sides of a 16-gon are up to 0.019 inside the circle, cubics through its corners 2e-4.
    let [straight, spline] = [off(&straight), off(&spline)];
    assert!(spline < 3e-3 && straight > 5.0 * spline, "{straight} {spline}");
}

#[test]
fn a_spline_keeps_its_corners_and_is_straight_between_two_of_them() {
    // An L of five vertices: a corner in the middle, a straight side, and a side of one segment.
    let places = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [3.0, 2.0]];
    let positions: Vec<Point> = places.iter().map(|[x, y]| [*x, *y, 0.0]).collect();
    let curve: Vec<u32> = (0..5).collect();
    let mesh = Mesh { positions, curves: [curve].into_iter().collect(), ..Mesh::default() };
    let row = r#""constraints": [{ "kind": "on-curve", "on": "curves", "between": "spline" }],
                 "handles": [{ "vertices": [1], "targets": [[1.6, 0.5, 0.3]], "weight": 0.01 }]"#;
    let found = solved(&mesh, row).positions();
    for v in [0, 2, 3, 4] {
        assert!(distance(found[v], mesh.positions[v]) < 1e-9, "{v}: {:?}", found[v]);
    }
    let [x, y, z] = found[1];
    assert!(x > 1.5 && y.abs() < 0.01 && z.abs() < 0.01, "{:?}", found[1]);
}

#[test]
fn a_place_is_kept_with_and_without_mean_centring() {
    let mesh = square();
    let found = |mean_centring: bool| {
        let text = format!(
            r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }},
                  "constraints": [{{ "kind": "on-curve", "on": "boundary" }}],
                  "weights": {{ "shape": 1, "smooth": 0.1 }},
                  "solver": {{ "mean_centring": {mean_centring}, "iterations": 50 }} }}"#
        );
        let scene = Scene::from_json(&text).expect("the scene is valid");
        let mut session = Session::open(scene, mesh.clone()).expect("it is regular");
        session.solve(false).expect("positions stay finite");
        session.positions()
    };
    assert_eq!(found(true), found(false), "there is no mean to take");
}

#[test]
fn some_vertices_stay_on_the_surface_while_the_others_leave_it() {
    // A saddle; the middle of its border is pulled outwards and up.
    let mesh = grid(8, 8, |i, j| {
        let (x, y) = (f64::from(i) - 4.0, f64::from(j) - 4.0);
        [x, y, 0.1 * x * y]
    });
    let session = solved(
        &mesh,
        r#""constraints": [{ "kind": "on-surface", "on": { "vertices": "9-71" }, "weight": 10 }],
           "handles": [{ "vertices": [4], "targets": [[0.5, -6, 3]] }],
           "weights": { "shape": 100, "smooth": 1 }"#,
    );
    assert!(session.report().pinned.is_empty(), "the surface holds all: {:?}", session.report());
    let found = session.positions();
    let surface = Surface::new(&mesh.positions, &mesh);
    let away =
        |v: usize| distance(found[v], surface.closest(found[v], &mut Surface::NO_HINT.clone()));
    let farthest = (9..72).map(away).fold(0.0, f64::max);
    assert!(farthest < 0.02, "a vertex on the surface is {farthest} away from it");
    assert!(away(4) > 1.0, "the handle is off the surface: {:?}", found[4]);
    assert!(distance(found[13], mesh.positions[13]) > 0.1, "it glides: {:?}", found[13]);
}

/// A bumpy square of triangles.
fn triangles() -> Mesh {
    let mut mesh = grid(5, 5, |i, j| {
        let bump = f64::from((i * 5 + j * 7) % 4);
        [f64::from(i) + 0.1 * bump, f64::from(j) - 0.06 * bump, 0.1 * bump]
    });
    mesh.faces = mesh.faces.iter().flat_map(|f| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]).collect();
    mesh
}

#[test]
fn incircles_of_neighbouring_triangles_come_to_touch() {
    let mesh = triangles();
    // Distance from `a` to the point where the incircle of `abc` touches `ab`.
    let touching = |at: &[Point], [a, b, c]: [u32; 3]| {
        let side = |u: u32, v: u32| distance(at[u as usize], at[v as usize]);
        0.5 * (side(a, b) + side(a, c) - side(b, c))
    };
    let gap = |at: &[Point]| {
        let hinges = hinges(&mesh, &Topology::new(&mesh)).into_iter();
        let gaps = hinges.map(|[a, b, c, d]| touching(at, [a, b, c]) - touching(at, [a, b, d]));
        gaps.fold(0.0f64, |worst, gap| worst.max(gap.abs()))
    };
    let row = r#""constraints": [{ "kind": "tangent-incircles", "on": "hinges" }]"#;
    let found = solved(&mesh, row).positions();
    let (before, after) = (gap(&mesh.positions), gap(&found));
    assert!(before > 0.1 && after < 1e-5, "incircles were {before} apart, and are {after}");
}

#[test]
fn opposite_angles_around_each_vertex_come_to_the_same_sum() {
    let mesh = grid(5, 5, |i, j| {
        let (x, y) = (f64::from(i) - 2.5, f64::from(j) - 2.5);
        [x + 0.1 * y * y, y - 0.05 * x * y, 0.2 * x * x - 0.1 * x * y]
    });
    let off = |at: &[Point]| {
        let stars = stars(&mesh, &Topology::new(&mesh));
        let offs = stars.iter().map(|star| {
            let edges: Vec<Vec3<f64>> = star[1..]
                .iter()
                .map(|&v| Vec3::from(at[v as usize]) - Vec3::from(at[star[0] as usize]))
                .collect();
            let angle = |k: usize| angle(edges[k], edges[(k + 1) % 4]);
            (angle(0) - angle(1) + angle(2) - angle(3)).abs()
        });
        offs.fold(0.0, f64::max)
    };
    let row = r#""constraints": [{ "kind": "conical", "on": "stars" },
                                 { "kind": "plane", "on": "faces" }]"#;
    let found = solved(&mesh, row).positions();
    let (before, after) = (off(&mesh.positions), off(&found));
    assert!(before > 0.1 && after < 1e-3, "sums were {before} apart, and are {after}");
}

#[expect(clippy::disallowed_methods, reason = "independent of the operator")]
fn angle(a: Vec3<f64>, b: Vec3<f64>) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}
