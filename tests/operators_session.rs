//! Stories of single operators in a session: what people ask of them, not how they do it.

#[path = "support/grid.rs"]
mod grid;

use grid::grid;
use shape_up::mesh::{Mesh, Point};
use shape_up::scene::Scene;
use shape_up::session::Session;

/// The positions after solving a scene on `mesh` with `rest` after the mesh.
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

/// Nine by nine vertices, a unit apart, four to each side of the origin.
fn square() -> Mesh {
    grid(8, 8, |i, j| [f64::from(i) - 4.0, f64::from(j) - 4.0, 0.0])
}

/// Where a vertex of the square comes to lie.
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
