//! Limits of hard constraints: too many points, none that weigh, and tolerances of different size.

use crate::solve::exact::{bumps, run};
use crate::support::grid::grid;
use crate::support::hard::Case;
use crate::support::random::Random;
use serde_json::json;
use shape_up::math;
use shape_up::solve::{Handle, Hold, Require, Weights};
use std::cell::RefCell;

#[test]
fn what_is_too_large_to_be_exact_is_said_beforehand() {
    let mesh = bumps(67);
    let all: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    // One plane through all vertices couples every pair of vertices.
    let asked = |require| {
        let case = Case::new(mesh.clone()).with("plane", json!({}), [all.clone()], require);
        (case.nearest(0), case)
    };
    let (nearest, case) = asked(Require::Exact);
    let nearest = nearest.expect("it is too large");
    assert!((0.9e-5..2e-5).contains(&(nearest / case.size())), "{nearest}");
    let (_, answer) = run(&case, &case.mesh.positions);
    assert!(answer.max_distance <= nearest && answer.block_factors == 0);
    assert_eq!(asked(Require::Within(0.1)).0, None, "a tolerance needs no polish");
    let panels = Case::new(bumps(8)).on_faces("plane", Require::Exact);
    assert_eq!(panels.nearest(1000), None);
    assert!(panels.nearest(7_000_000).is_some(), "a factor of half a gigabyte");
    // Normal spaces cost the cube of the number of points.
    for (n, is_too_large) in [(20, false), (25, true)] {
        let mesh = bumps(n);
        let all: Vec<u32> = (0..mesh.positions.len() as u32).collect();
        let case = Case::new(mesh).with("plane", json!({}), [all], Require::Exact);
        assert_eq!(case.nearest(0).is_some(), is_too_large, "{n}");
    }
    // The guard is exact where edges may not become shorter at all: it was taken for what was asked.
    let mesh = bumps(25);
    let all: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    let mut case = Case::new(mesh).with("plane", json!({}), [all], Require::Within(0.1));
    case.shortest_edge = Some(1.0);
    let exact = case.exact(&case.mesh.positions);
    assert!(!exact.can_polish() && !exact.answer().too_large);
}

#[test]
fn means_of_large_constraints_without_weight_are_no_unknowns() {
    let mesh = bumps(6);
    let all: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    for require in [Require::Soft, Require::Exact] {
        let mut case = Case::new(mesh.clone())
            .with("plane", json!({}), [all.clone()], Require::Soft)
            .with("plane", json!({}), [all.clone()], require);
        case.weights.shape = 0.0;
        let soft = case.soft();
        assert!(!require.is_hard() || run(&case, &soft).1.met);
    }
}

#[test]
fn a_larger_tolerance_is_met_wherever_a_smaller_one_is() {
    // On these meshes steps to the edge of what is tolerated end before it; steps to the shapes
    // themselves do not.
    for seed in [1, 2, 4] {
        let noise = RefCell::new(Random::new(seed));
        let mesh = grid(23, 23, |i, j| {
            let (x, y) = (f64::from(i), f64::from(j));
            let off = |most: f64| most * noise.borrow_mut().uniform();
            let height = math::sine(0.0477 * x) * math::cosine(0.0398 * y);
            [x + off(0.2), y + off(0.2), height + off(0.5)]
        });
        let is_met = |require| {
            let mut case = Case::new(mesh.clone()).on_faces("circle", require);
            case.weights = Weights { shape: 1000.0, close: 1.0, smooth: 1.0 };
            run(&case, &case.soft()).1.met
        };
        let met = [Require::Exact, Require::Within(0.01), Require::Within(0.05)].map(is_met);
        assert_eq!(met, [true; 3], "{seed}");
    }
}

#[test]
fn an_edge_between_fixed_vertices_is_not_guarded() {
    // Its ends are nearer than allowed, and nothing can be done about it.
    let mut case = Case::new(bumps(12)).on_faces("plane", Require::Within(0.01));
    let at = case.mesh.positions[0];
    let fixed = |vertex, target| Handle { vertex, target, hold: Hold::Fixed };
    case.handles = vec![fixed(0, at), fixed(1, [at[0] + 0.1, at[1], at[2]])];
    let (_, answer) = run(&case, &case.soft());
    assert!(answer.met && answer.on_guard.is_empty(), "{answer:?}");
    assert_eq!(answer.block_factors, 0, "a tolerance needs no polish");
}
