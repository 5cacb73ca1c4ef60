//! The property suite over the list of kinds, which covers a new kind automatically. With an
//! independent description in `support/shapes`, a kind is also compared with its set.

use crate::constraint::cases::{
    Case, assert_close, cases, centred_as, is_oriented, kind, kinds, scaled, sizes, told, turned,
};
use crate::support::degenerate::degenerate;
use crate::support::long_or;
use crate::support::minimise::least_distance_squared;
use crate::support::project::{Project, project};
use crate::support::random::{Points, Random, distance_squared, in_frame, size};
use crate::support::shapes::{NOISE, Shape, cloud, shapes};
use serde_json::{Value, json};
use shape_up::constraint::{Arity, Centring, Form, Info, KINDS, ParamValue};
use shape_up::math::{LANES, Vec3};

#[test]
fn every_kind_is_declared_for_people() {
    for info in KINDS {
        let id = info.id;
        assert!(id.bytes().all(|b| b.is_ascii_lowercase() || b == b'-'), "{id}: the id");
        assert!(!info.label.is_empty() && info.summary.ends_with('.'), "{id}: label or summary");
        assert_eq!(KINDS.iter().filter(|other| other.id == id).count(), 1, "{id} is there twice");
        assert_eq!(
            KINDS.iter().filter(|other| other.colour == info.colour).count(),
            1,
            "{id} shares its colour"
        );
        // Contrast of 3 : 1 with white and with #1e1e1e, as for graphics in WCAG 2.1.
        let [r, g, b] = info.colour.map(|c| (f64::from(c) / 255.0) * (f64::from(c) / 255.0));
        let luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
        assert!(1.05 / (luminance + 0.05) >= 3.0, "{id}: too light on white");
        assert!((luminance + 0.05) / (0.014 + 0.05) >= 3.0, "{id}: too dark on dark");
        if let Some(measure) = info.measure {
            assert!(["planarity", "circularity"].contains(&measure), "{id}: measure {measure}");
        }
        assert_eq!(shapes(info)[0].exact, info.exact, "{id}: whether it is exact");
        for param in info.params {
            let [least, greatest] = param.range;
            let (form, defaults) = match param.default {
                ParamValue::Number(number) => (Form::Number, vec![number]),
                ParamValue::Range(ends) => (Form::Range, ends.into_iter().flatten().collect()),
                ParamValue::Vector(_) => (Form::Vector, vec![]),
                ParamValue::Word(word) => (Form::Word(word), vec![]),
                ParamValue::Nothing => (Form::Nothing, vec![]),
            };
            assert!(param.forms.contains(&form), "{id}: the default of {} is no form", param.id);
            let declared = serde_json::to_value(param.default).expect("JSON");
            let parsed = kind(id, json!({})).params()[param.id].take();
            let number = |value: &Value| value.as_f64();
            assert!(
                declared == parsed
                    || (declared.is_number() && number(&declared) == number(&parsed)),
                "{id}: {} is {parsed} by default, and declared to be {declared}",
                param.id
            );
            let fits = defaults.iter().all(|default| (least..=greatest).contains(default));
            assert!(fits, "{id}: the default of {} is out of its range", param.id);
        }
    }
}

#[test]
fn points_that_have_the_shape_stay() {
    for case in told(40) {
        let mut random = Random::new(case.seed);
        let points = case.centred(&(case.shape.sample)(&mut random, &case.rest));
        let stayed = project(&case.kind, &case.rest, &points);
        assert_close(&case, "a point of the shape moved", &stayed, &points, 1e-11);
    }
}

#[test]
fn idempotent() {
    for case in cases(80) {
        let once = case.centred(&case.project());
        let twice = project(&case.kind, &case.rest, &once);
        assert_close(&case, "a second projection moved", &twice, &once, 1e-10);
    }
}

#[test]
fn feasible_by_an_independent_check() {
    for case in told(80) {
        let residual = (case.shape.residual)(&case.centred(&case.project()), &case.rest);
        assert!(residual <= 1e-11, "{case}: the projection misses the shape by {residual:e}");
        let residual = (case.shape.residual)(&case.points, &case.rest);
        let may_fit = case.n <= 4;
        assert!(may_fit || residual > 1e-8, "{case}: the check takes anything: {residual:e}");
    }
}

#[test]
fn equivariant_under_rigid_motion() {
    for case in cases(80) {
        let mut random = Random::new(case.seed + 1);
        let (frame, offset) = (random.frame(), random.vector() * 10.0);
        let placed = case.kind.info().centring == Centring::Placed;
        let motion = |v| in_frame(frame, v) + offset;
        let mut moved = if is_oriented(&case.kind) {
            case.with(motion, motion)
        } else {
            case.with(motion, |r| r)
        };
        moved.kind = turned(&case.kind, frame);
        (moved.points, moved.rest) = (case.centred(&moved.points), case.centred(&moved.rest));
        let at = if placed { offset } else { Vec3::zero() };
        let expected: Points = case.project().iter().map(|v| in_frame(frame, *v) + at).collect();
        assert_close(&case, "turned", &moved.project(), &expected, 1e-9);
    }
}

/// Only the shape of the rest points counts, not their position.
#[test]
fn the_place_of_the_rest_shape_does_not_matter() {
    for case in cases(40).into_iter().filter(|case| !is_oriented(&case.kind)) {
        let frame = Random::new(case.seed + 1).frame();
        let turned = case.with(|v| v, |r| in_frame(frame, r));
        assert_close(&case, "rest shape turned", &turned.project(), &case.project(), 1e-9);
    }
}

#[test]
fn equivariant_under_scale() {
    for case in cases(40) {
        for scale in [1e-6, 1e-3, 3.0, 1e6] {
            let kind = scaled(&case.kind, scale);
            let scaled = Case { kind, ..case.with(|v| v * scale, |v| v * scale) };
            let expected: Points = case.project().iter().map(|v| *v * scale).collect();
            assert_close(
                &scaled,
                &format!("scaled by {scale}"),
                &scaled.project(),
                &expected,
                1e-10,
            );
        }
    }
}

#[test]
fn equivariant_under_relabelling() {
    for case in cases(80) {
        for order in (case.shape.relabellings)(&mut Random::new(case.seed), case.n) {
            let pick = |points: &Points| -> Points { order.iter().map(|&i| points[i]).collect() };
            let found = project(&case.kind, &pick(&case.rest), &pick(&case.points));
            assert_close(&case, "relabelled", &found, &pick(&case.project()), 1e-9);
        }
    }
}

/// Bit for bit: a lane performs the same operations as a scalar, in the same order, and IEEE 754
/// defines their results. A lane that needs the accurate path does not disturb its neighbours.
#[test]
fn lanes_and_scalars_give_the_same_bits() {
    let cases = cases(80);
    let bits = |points: &Points| -> Vec<[u64; 3]> {
        points.iter().map(|v| <[f64; 3]>::from(*v).map(f64::to_bits)).collect()
    };
    for pair in cases.chunks(LANES) {
        if pair.iter().any(|case| case.n != pair[0].n || case.kind != pair[0].kind) {
            continue;
        }
        let collinear = pair[0].with(|v| Vec3::new(v.x, v.x, v.x), |v| v);
        for (first, others) in [(&pair[0], &pair[1..]), (&collinear, &pair[1..])] {
            let all: Vec<&Case> = std::iter::once(first).chain(others).collect();
            let rest: Vec<Points> = all.iter().map(|case| case.rest.clone()).collect();
            let mut found: Vec<Points> = all.iter().map(|case| case.points.clone()).collect();
            first.kind.visit(Project { rest: &rest, points: &mut found });
            for (case, found) in all.iter().zip(&found) {
                assert_eq!(bits(found), bits(&case.project()), "{case}: the lane differs");
            }
        }
    }
}

#[test]
fn exact_projections_are_never_farther_than_brute_force_finds() {
    for case in told(long_or(12, 5)).filter(|case| case.shape.exact && case.n <= 10) {
        let found = distance_squared(&case.points, &case.project());
        let Shape { parameters, closest, .. } = case.shape;
        let least = least_distance_squared(&case.points, &case.rest, parameters, closest, 20);
        let rounding = 1e-24 * size(&case.points).powi(2);
        assert!(found <= least * (1.0 + 1e-9) + rounding, "{case}: {found:e}, least {least:e}");
        assert!(
            least <= found * (1.0 + 1e-6) + rounding,
            "{case}: brute force found only {least:e}"
        );
    }
}

/// The bounds are in `support/shapes`; the measured values are printed (`--nocapture`).
#[test]
fn approximate_projections_stay_within_their_stated_excess() {
    for (kind, shape) in
        kinds().into_iter().filter(|(_, shape)| !shape.exact && shape.tells_the_set)
    {
        let Info { id, centring, .. } = *kind.info();
        let Shape { rest, sample, parameters, closest, excess, .. } = shape;
        let sizes = match kind.info().arity {
            Arity::AtLeast(_) => [8, 12],
            Arity::Exactly(n) => [n, n],
        };
        for (noise, bound) in NOISE.into_iter().zip(excess) {
            for n in sizes {
                let (mut sum, mut worst) = (0.0, 0.0f64);
                let seeds = long_or(25, 8);
                for seed in 0..seeds {
                    let mut random = Random::new(seed);
                    let rest = centred_as(centring, &rest(&mut Random::new(!seed), n));
                    let shape = sample(&mut random, &rest);
                    let disturbed: Points =
                        shape.iter().map(|v| *v + random.vector() * noise).collect();
                    let points = centred_as(centring, &disturbed);
                    let found = distance_squared(&points, &project(&kind, &rest, &points));
                    let least = least_distance_squared(&points, &rest, parameters, closest, 20);
                    let more = found / least - 1.0;
                    assert!(
                        more <= bound,
                        "{id}, n = {n}, seed {seed}, noise {noise}: {more:e} more"
                    );
                    assert!(
                        more >= -1e-6,
                        "{id}, n = {n}, seed {seed}: brute force found only {least}"
                    );
                    sum += more;
                    worst = worst.max(more);
                }
                println!(
                    "{id} n={n} noise {noise}: excess mean {:.1e} max {worst:.1e}",
                    sum / seeds as f64
                );
            }
        }
    }
}

#[test]
fn finite_and_feasible_on_degenerate_input() {
    for (kind, shape) in kinds() {
        let info = kind.info();
        for n in sizes(info) {
            let rest = centred_as(info.centring, &(shape.rest)(&mut Random::new(1), n));
            for (name, set) in degenerate(n) {
                let points = centred_as(info.centring, &set);
                for scale in [1.0, 1e-200, 1e-310, 1e200, 1e290] {
                    let scaled: Points = points.iter().map(|v| *v * scale).collect();
                    let found = project(&kind, &rest, &scaled);
                    let coordinates = found.iter().flat_map(|v| <[f64; 3]>::from(*v));
                    let finite = coordinates.into_iter().all(f64::is_finite);
                    assert!(finite, "{}, n = {n}, {name} times {scale}: {found:?}", info.id);
                }
                let projected = project(&kind, &rest, &points);
                let found = centred_as(info.centring, &projected);
                // All points coincide, up to rounding.
                if size(&found) <= 1e-15 * size(&projected) || !shape.tells_the_set {
                    continue;
                }
                let residual = (shape.residual)(&found, &rest);
                assert!(
                    residual <= 1e-10,
                    "{}, n = {n}, {name}: misses the shape by {residual:e}",
                    info.id
                );
            }
        }
    }
}

/// If many points are equally close, any of them is accepted, but none that is farther.
#[test]
fn exact_projections_are_closest_on_degenerate_input_too() {
    for (kind, shape) in kinds().into_iter().filter(|(_, shape)| shape.exact && shape.tells_the_set)
    {
        let Info { id, centring, .. } = *kind.info();
        for n in sizes(kind.info()).into_iter().filter(|n| *n <= 6) {
            let rest = centred_as(centring, &(shape.rest)(&mut Random::new(1), n));
            for (name, set) in degenerate(n) {
                // Twice: far away, the first mean has a rounding error.
                let points = centred_as(centring, &centred_as(centring, &set));
                if size(&points) == 0.0 {
                    continue;
                }
                let found = distance_squared(&points, &project(&kind, &rest, &points)).sqrt();
                let Shape { parameters, closest, .. } = shape;
                let least =
                    least_distance_squared(&points, &rest, parameters, closest, long_or(5, 3))
                        .sqrt();
                let rounding = 1e-14 * size(&points);
                assert!(
                    found <= least * (1.0 + 1e-9) + rounding,
                    "{id}, n = {n}, {name}: {found:e}, least {least:e}"
                );
            }
        }
    }
}

#[test]
fn finite_with_a_degenerate_rest_shape() {
    for (kind, _) in kinds() {
        let Info { centring, .. } = *kind.info();
        for n in sizes(kind.info()) {
            let points = centred_as(centring, &cloud(&mut Random::new(2), n, 1.0));
            for (name, set) in degenerate(n) {
                for scale in [1.0, 1e-200, 1e-310, 1e200, 1e290] {
                    let rest: Points =
                        centred_as(centring, &set).iter().map(|v| *v * scale).collect();
                    let found = project(&kind, &rest, &points);
                    let mut coordinates = found.iter().flat_map(|v| <[f64; 3]>::from(*v));
                    assert!(
                        coordinates.all(f64::is_finite),
                        "{}, n = {n}, rest {name} times {scale}: {found:?}",
                        kind.info().id
                    );
                }
            }
        }
    }
}

/// Paper Appendix A: the gradient of the proximity function is `2 (x - P(x))`.
#[test]
fn exact_projections_have_the_gradient_of_appendix_a() {
    for case in cases(20).into_iter().filter(|case| case.shape.exact) {
        let proximity = |points: &Points| {
            let points = case.centred(points);
            distance_squared(&points, &project(&case.kind, &case.rest, &points))
        };
        let projected = case.project();
        let step = 1e-6;
        for i in 0..case.n.min(5) {
            let mut numerical = [0.0; 3];
            for (k, axis) in
                [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into_iter().enumerate()
            {
                let (mut above, mut below) = (case.points.clone(), case.points.clone());
                above[i] += Vec3::from(axis) * step;
                below[i] -= Vec3::from(axis) * step;
                numerical[k] = (proximity(&above) - proximity(&below)) / (2.0 * step);
            }
            let gradient = (case.points[i] - projected[i]) * 2.0;
            let error = (gradient - Vec3::from(numerical)).length() / size(&case.points);
            assert!(error <= 1e-7, "{case}: vertex {i}: off by {error:e}");
        }
    }
}

/// The set of a shape is translation-invariant, so the closest point to centred points is centred.
#[test]
fn centring_a_projection_again_brings_it_nearer() {
    for case in cases(80) {
        let projected = case.project();
        let again = case.centred(&projected);
        if case.shape.exact {
            assert_close(&case, "not centred", &projected, &again, 1e-11);
        }
        let (before, after) =
            (distance_squared(&case.points, &projected), distance_squared(&case.points, &again));
        let rounding = 1e-14 * size(&case.points).powi(2);
        assert!(after <= before + rounding, "{case}: centring went from {before:e} to {after:e}");
    }
}
