//! Variations of a shape whose hard constraints stay met: properties of every mode and of every
//! step.

use crate::support::grid::grid;
use crate::support::hard::Case;
use libm::{cos, sin};
use shape_up::math::Vec3;
use shape_up::mesh::{Mesh, Point};
use shape_up::solve::{
    BoundaryRequire, Handle, Hold, Require, Requirements, SLIDE, SetupCache, ShapeSpace, Solver,
};

/// A part of a torus along its lines of curvature, on which all circles are met; symmetric in x and
/// y.
fn torus(n: u32) -> Mesh {
    grid(n, n, |i, j| {
        let angle = |k: u32, range: f64| range * (f64::from(k) / f64::from(n) - 0.5);
        let (a, b) = (angle(i, 1.6), angle(j, 1.2));
        let radius = 3.0 + cos(b);
        [radius * sin(a), sin(b), radius * cos(a)]
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

/// The shape space with all modes and, if requested, their ranges.
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
fn a_step_stays_tangent_to_a_millionth_of_it() {
    for kind in ["plane", "circle"] {
        let (case, shape) = exact_case(torus(6), kind);
        let space = space(&case, &shape, false);
        assert_eq!(space.modes().len(), 8);
        for k in 0..8 {
            let mut coefficients = [0.0; 8];
            let mut distance = |coefficient: f64| {
                coefficients[k] = coefficient;
                space.measure(&space.towards(&coefficients)).max_distance / case.size()
            };
            // The curvature error grows with the square of the step; at this small step the rest is
            // an error of the tangent.
            let step = 1e-6;
            assert!(distance(step) <= 1e-6 * step + 1e-11 * step.sqrt(), "{kind}, mode {k}");
        }
    }
}

#[test]
fn modes_are_the_softest_first_apart_from_motions_and_from_each_other() {
    let (case, shape) = exact_case(torus(6), "circle");
    let space = space(&case, &shape, false);
    let modes = space.modes();
    let order = modes.windows(2).all(|pair| pair[0].stiffness <= pair[1].stiffness);
    assert!(order && modes[0].stiffness > 0.0);
    let mean = shape.iter().fold(Vec3::zero(), |sum, &p| sum + Vec3::from(p) * (1.0 / 49.0));
    let motion = |of: &dyn Fn(Vec3<f64>) -> Vec3<f64>| -> Vec<Point> {
        shape.iter().map(|&p| of(Vec3::from(p) - mean).into()).collect()
    };
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
    let mut motions = vec![motion(&|p| p)];
    for axis in axes {
        motions.push(motion(&|_| axis));
        motions.push(motion(&|p| axis.cross(p)));
    }
    for (k, mode) in modes.iter().enumerate() {
        let d = &mode.displacement;
        assert!((longest(d) / space_size(&case) - 1.0).abs() < 1e-12);
        let others = motions.iter().chain(modes[..k].iter().map(|mode| &mode.displacement));
        for other in others {
            let cosine = dot(d, other) / (dot(d, d) * dot(other, other)).sqrt();
            assert!(cosine.abs() < 1e-4, "mode {k}: {cosine}");
        }
    }
}

/// Diagonal of the bounding box, the unit of the coefficients.
fn space_size(case: &Case) -> f64 {
    let side = |c: usize| {
        let values = || case.mesh.positions.iter().map(|p| p[c]);
        values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min)
    };
    (0..3).map(|c| side(c) * side(c)).sum::<f64>().sqrt()
}

#[test]
fn steps_and_sums_of_them_end_on_the_constraints_and_nothing_stays() {
    for kind in ["plane", "circle"] {
        let (case, shape) = exact_case(torus(8), kind);
        let mut space = space(&case, &shape, true);
        let ranges: Vec<[f64; 2]> = space.modes().iter().flat_map(|mode| mode.range).collect();
        assert_eq!(ranges.len(), 8, "every range is found");
        for (k, [least, greatest]) in ranges.iter().enumerate() {
            assert!((-SLIDE..=0.0).contains(least) && (0.0..=SLIDE).contains(greatest));
            let mut alone = [0.0; 8];
            for end in [*least, *greatest] {
                alone[k] = end;
                let reached = space.move_along(&alone).expect("its systems are regular");
                assert!(end == 0.0 || reached.part == 1.0, "{kind}: mode {k} to {end}");
                assert!(reached.answer.met && reached.answer.max_distance <= 1e-12 * case.size());
                assert!(reached.answer.shortest_edge.expect("a guard") >= 0.3 * (1.0 - 1e-9));
            }
        }
        let sum = [0.02, -0.015, 0.0, 0.01, 0.0, 0.0, 0.0, 0.0];
        let reached = space.move_along(&sum).expect("its systems are regular");
        assert!(reached.part == 1.0 && reached.answer.met);
        assert!(reached.answer.moved.max >= 0.01 * case.size());
        // The same step from the same shape gives the same bits, and a step of zero leaves every
        // bit.
        assert_eq!(space.move_along(&sum).expect("regular").positions, reached.positions);
        assert_eq!(space.move_along(&[0.0; 8]).expect("regular").positions, shape);
        // A step of zero from there leaves the shape.
        let again = self::space(&case, &reached.positions, false).move_along(&[0.0; 8]);
        assert_eq!(again.expect("regular").positions, reached.positions);
    }
}

#[test]
fn modes_turn_and_grow_with_the_shape() {
    let (case, shape) = exact_case(torus(6), "circle");
    let plain = space(&case, &shape, false);
    // A rotation about y and x with rational entries, three times the size, and far away.
    let moved = |p: &Point| {
        let q = [0.8 * p[0] + 0.6 * p[2], p[1], -0.6 * p[0] + 0.8 * p[2]];
        let r = [q[0], 0.28 * q[1] - 0.96 * q[2], 0.96 * q[1] + 0.28 * q[2]];
        r.map(|x| 3.0 * x + 40.0)
    };
    let mesh =
        Mesh { positions: case.mesh.positions.iter().map(moved).collect(), ..case.mesh.clone() };
    let other = Case::new(mesh).on_faces("circle", Require::Exact);
    let there: Vec<Point> = shape.iter().map(moved).collect();
    let turned = space(&other, &there, false);
    for (a, b) in plain.modes().iter().zip(turned.modes()) {
        assert!((a.stiffness - b.stiffness).abs() <= 1e-3 * a.stiffness);
        let way = |p: &Point| {
            let [end, start] = [moved(p), moved(&[0.0; 3])];
            [0, 1, 2].map(|c| end[c] - start[c])
        };
        let turned: Vec<Point> = a.displacement.iter().map(way).collect();
        let cosine = dot(&turned, &b.displacement)
            / (dot(&turned, &turned) * dot(&b.displacement, &b.displacement)).sqrt();
        assert!(cosine > 0.99, "{cosine}: up to the sign, which is by the shape");
    }
}

#[test]
fn symmetric_shapes_have_symmetric_ways() {
    let n = 8;
    let (case, shape) = exact_case(torus(n), "circle");
    let mut space = space(&case, &shape, false);
    let at = |i: u32, j: u32| (j * (n + 1) + i) as usize;
    let image = |v: usize, c: usize| {
        let (i, j) = (v as u32 % (n + 1), v as u32 / (n + 1));
        if c == 0 { at(n - i, j) } else { at(i, n - j) }
    };
    let mirrored = |ways: &[Point], c: usize| -> Vec<Point> {
        let way = |v: usize| {
            let mut way = ways[image(v, c)];
            way[c] = -way[c];
            way
        };
        (0..ways.len()).map(way).collect()
    };
    let mut symmetric = 0;
    for k in 0..8 {
        let d = space.modes()[k].displacement.clone();
        let mut sign = [0.0; 2];
        for c in 0..2 {
            let image = mirrored(&d, c);
            sign[c] = dot(&d, &image) / dot(&d, &d);
            assert!((sign[c].abs() - 1.0).abs() < 1e-6, "mode {k} about {c}: {}", sign[c]);
        }
        if sign.iter().all(|sign| *sign > 0.0) {
            symmetric += 1;
            let mut alone = [0.0; 8];
            alone[k] = 0.03;
            let there = space.move_along(&alone).expect("regular").positions;
            for c in 0..2 {
                let off = longest(&difference(&there, &mirrored(&there, c)));
                assert!(off <= 1e-6 * case.size(), "mode {k} about {c}: {off:e}");
            }
        }
    }
    assert!(symmetric > 0, "some way keeps all of the symmetry");
}

#[test]
fn what_is_fixed_stays_and_what_is_within_stays_within() {
    let (mut case, shape) = exact_case(torus(6), "plane");
    case.handles = [0_u32, 6, 42, 48]
        .map(|vertex| Handle { vertex, target: shape[vertex as usize], hold: Hold::Fixed })
        .to_vec();
    let within = 1e-3 * case.size();
    for require in [Require::Exact, Require::Within(within)] {
        case.requires = vec![require];
        let mut space = space(&case, &shape, false);
        let reached =
            space.move_along(&[0.03, 0.02, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]).expect("regular");
        assert!(reached.part > 0.0 && reached.answer.met);
        for handle in &case.handles {
            let v = handle.vertex as usize;
            assert_eq!(reached.positions[v], shape[v]);
        }
    }
}

#[test]
fn shapes_without_ways_and_degenerate_ones_end_too() {
    let cases = [
        Mesh::default(),
        Mesh { positions: vec![[1.0; 3]; 5], ..Mesh::default() },
        grid(3, 3, |_, _| [0.0; 3]),
        grid(3, 3, |i, _| [f64::from(i), 0.0, 0.0]),
        grid(1, 1, |i, j| [f64::from(i), f64::from(j), 0.0]),
    ];
    for mesh in cases {
        let shape = mesh.positions.clone();
        let mut case = Case::new(mesh).on_faces("circle", Require::Exact);
        for all_fixed in [false, true] {
            if all_fixed {
                let fixed = |(vertex, &target)| Handle { vertex, target, hold: Hold::Fixed };
                case.handles = (0..).zip(&shape).map(fixed).collect();
            }
            let mut space = space(&case, &shape, true);
            let coefficients = vec![0.01; space.modes().len()];
            let reached = space.move_along(&coefficients).expect("regular");
            let finite = |points: &[Point]| points.as_flattened().iter().all(|x| x.is_finite());
            assert!(finite(&reached.positions));
            assert!(space.modes().iter().all(|mode| finite(&mode.displacement)));
            assert!(!all_fixed || space.modes().is_empty());
        }
    }
}

#[test]
fn corners_that_closeness_to_the_boundary_fixes_stay_in_every_variation() {
    let (case, shape) = exact_case(torus(6), "circle");
    let mut problem = case.problem();
    problem.boundary_closeness.require = BoundaryRequire::Soft;
    let requirements = Requirements {
        rows: &case.requires,
        shortest_edge: case.shortest_edge,
        iterations: Requirements::ITERATIONS,
    };
    let space = ShapeSpace::new(&problem, &requirements, &[], &shape, SetupCache::default());
    let mut space = space.expect("its systems are regular");
    while !space.has_modes() && space.step().expect("its systems are regular") {}
    let reached = space.move_along(&[0.03, 0.02, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]).expect("regular");
    assert!(reached.part > 0.0 && reached.answer.met);
    assert!(longest(&difference(&reached.positions, &shape)) > 0.01);
    // What a solver of the same problem would move the corners back from.
    for corner in [0, 6, 42, 48] {
        assert_eq!(reached.positions[corner], shape[corner]);
    }
}

#[test]
fn corners_of_the_boundary_are_those_of_the_kept_shape() {
    let case = Case::new(grid(3, 3, |i, j| [f64::from(i), f64::from(j), 0.0]));
    let kept: Vec<Point> = case.mesh.positions.iter().map(|&[x, y, _]| [x, y, 1.0]).collect();
    let mut problem = case.problem();
    problem.design = Some(&kept);
    problem.boundary_closeness.require = BoundaryRequire::Soft;
    let solver = Solver::new(&problem, SetupCache::default(), Vec::new(), &kept);
    let mut solver = solver.expect("the problem is regular");
    solver.step().expect("positions stay finite");
    assert!(longest(&difference(&solver.positions().collect::<Vec<_>>(), &kept)) < 1e-12);
}
