//! Ways to change a shape while its hard constraints stay met: what holds of every mode and of every step.

#[path = "support/grid.rs"]
mod grid;
#[path = "support/hard.rs"]
mod hard;

use grid::grid;
use hard::Case;
use shape_up::math::Vec3;
use shape_up::mesh::{Mesh, Point};
use shape_up::solve::{Handle, Hold, Require, SLIDE, ShapeSpace, Variation};

/// A part of a torus along its lines of curvature, on which all circles are met; symmetric in x and y.
fn torus(n: u32) -> Mesh {
    grid(n, n, |i, j| {
        let angle = |k: u32, range: f64| range * (f64::from(k) / f64::from(n) - 0.5);
        let (a, b) = (angle(i, 1.6), angle(j, 1.2));
        let radius = 3.0 + b.cos();
        [radius * a.sin(), b.sin(), radius * a.cos()]
    })
}

fn exact_case(mesh: Mesh, kind: &str) -> (Case, Vec<Point>) {
    let case = Case::new(mesh).on_faces(kind, Require::Exact);
    let mut exact = case.exact(&case.soft());
    exact.run().expect("its systems are regular");
    assert!(exact.answer().met);
    let positions = exact.positions();
    (case, positions)
}

/// With all modes, and, where they are asked for, their ranges.
fn space(case: &Case, shape: &[Point], ranges: bool) -> ShapeSpace {
    let mut space = case.shape_space(shape);
    while (ranges || !space.has_modes()) && space.step().expect("its systems are regular") {}
    space
}

fn longest(ways: &[Point]) -> f64 {
    ways.iter().map(|&way| Vec3::from(way).length()).fold(0.0, f64::max)
}

fn difference(a: &[Point], b: &[Point]) -> Vec<Point> {
    a.iter().zip(b).map(|(a, b)| (Vec3::from(*a) - Vec3::from(*b)).into()).collect()
}

fn dot(a: &[Point], b: &[Point]) -> f64 {
    a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a * b).sum()
}

#[test]
fn a_short_step_leaves_the_constraints_by_its_square_only() {
    for kind in ["plane", "circle"] {
        let (case, shape) = exact_case(torus(6), kind);
        let space = space(&case, &shape, false);
        assert_eq!(space.modes().len(), 8);
        for k in 0..8 {
            // Central: what is even in the step cancels, and leaves what is across.
            let step = 1e-6;
            let mut coefficients = [0.0; 8];
            let mut distance = |c: f64| {
                coefficients[k] = c;
                space.measure(&space.towards(&coefficients)).max_distance / case.size()
            };
            let [short, long] = [step, 10.0 * step].map(&mut distance);
            assert!(short <= 1e-6 * step + 1e-11 * step.sqrt(), "{kind}, mode {k}: {short:e}");
            assert!(long <= 1e-4 * 10.0 * step, "{kind}, mode {k}: {long:e}");
        }
    }
}

#[test]
fn print_modes() {
    for file in std::env::var("MESHES").unwrap_or_default().split_whitespace() {
        let (name, kind) = file.split_once(':').unwrap();
        let mesh = if let Some(n) = name.strip_prefix("torus") {
            torus(n.parse().unwrap())
        } else {
            shape_up::mesh::read(
                name,
                &std::fs::read(format!("/work/shared/meshes/{name}")).unwrap(),
            )
            .unwrap()
            .mesh
        };
        let (case, shape) = exact_case(mesh, kind);
        let begun = std::time::Instant::now();
        let mut space = case.shape_space(&shape);
        let made = begun.elapsed();
        let mut n = 0;
        while !space.has_modes() {
            space.step().unwrap();
            n += 1;
        }
        println!(
            "{file} {} vertices: made {made:?}, {n} iterations, modes after {:?}",
            shape.len(),
            begun.elapsed()
        );
        let begun = std::time::Instant::now();
        while space.step().unwrap() {
            n += 1
        }
        println!("  ranges {:?} {n}", begun.elapsed());
        for mode in space.modes().to_vec() {
            println!("  {:.4e} {:?}", mode.stiffness, mode.range.unwrap());
        }
        for k in 0..space.modes().len() {
            let mut c = vec![0.0; 8];
            c[k] = 0.02;
            let lin = space.measure(&space.towards(&c)).max_distance / case.size();
            c[k] = 1e-5;
            let tan = space.measure(&space.towards(&c)).max_distance / case.size();
            c[k] = 0.02;
            let begun = std::time::Instant::now();
            let r = space.go(&c).unwrap();
            println!(
                "  {k}: lin {lin:.2e} tan(1e-5) {tan:.2e} part {} after {:.2e} moved {:.4} edge {:?} {:?}",
                r.part,
                r.answer.max_distance / case.size(),
                r.answer.moved.max / case.size(),
                r.answer.shortest_edge,
                begun.elapsed()
            );
        }
    }
}
