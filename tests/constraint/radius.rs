//! Circles and spheres of given radius: far from the radius of the vertices, at the limits, on
//! degenerate points, and their drawing.

use crate::support::project::project;
use crate::support::random::{Points, Random, centred, distance_squared, farthest, in_frame, size};
use serde_json::{Value, json};
use shape_up::constraint::{Fitted, Kind, KindVisitor, Projection};
use shape_up::math::Vec3;

struct Draw<'a>(&'a Points);

impl KindVisitor for Draw<'_> {
    type Output = Option<Fitted>;
    fn visit<P: Projection>(self, operator: &P) -> Option<Fitted> {
        operator.fitted(self.0)
    }
}

fn with_radius(id: &str, radius: Value) -> Kind {
    Kind::new(id, json!({ "radius": radius })).expect("the radius is valid")
}

/// Vertices near a unit circle in the xy plane, or a unit sphere; `cap` is the fraction of it that
/// is covered.
fn near_round(random: &mut Random, id: &str, n: usize, cap: f64, noise: f64) -> Points {
    let mut point = || {
        let v = random.vector();
        let v = if id == "circle" { Vec3::new(v.x, v.y, 0.0) } else { v };
        let (length, noise) = (v.length(), 1.0 + noise * random.uniform());
        (length > 0.1 && length <= 1.0 && v.x >= (1.0 - 2.0 * cap) * length)
            .then(|| v * (noise / length))
    };
    centred(&std::iter::repeat_with(&mut point).flatten().take(n).collect::<Points>())
}

/// Least sum of squared distances to a sphere of this radius, or if `flat` to a circle in the plane
/// z = 0 of the points: from many random centres, and long from the best of them, the centre is
/// iterated until the projections have the mean of the points.
fn least_distance_squared(points: &Points, flat: bool, radius: f64, random: &mut Random) -> f64 {
    let energy =
        |c: Vec3<f64>| -> f64 { points.iter().map(|v| ((*v - c).length() - radius).powi(2)).sum() };
    let iterated = |times: usize, start: Vec3<f64>| {
        (0..times).fold(start, |c, _| {
            let sum = points.iter().fold(Vec3::zero(), |sum, v| {
                let w = *v - c;
                sum + w * (1.0 / w.length())
            });
            -sum * (radius / points.len() as f64)
        })
    };
    let centres = (0..40).map(|_| {
        let v = random.vector() * (1.5 * radius);
        iterated(200, Vec3::new(v.x, v.y, if flat { 0.0 } else { v.z }))
    });
    let best = centres.min_by(|a, b| energy(*a).total_cmp(&energy(*b)));
    energy(iterated(20_000, best.expect("there are forty")))
}

#[test]
fn nearly_closest_also_where_the_radius_is_far_from_that_of_the_vertices() {
    for id in ["circle", "sphere"] {
        for (cap, radius, bound) in [
            (1.0, 0.5, 1e-4),
            (1.0, 1.0, 1e-4),
            (1.0, 1.4, 1e-4),
            (0.4, 0.5, 1e-4),
            (0.4, 2.0, 1e-4),
            (0.4, 5.0, 1e-4),
        ] {
            let (mut sum, mut worst) = (0.0, 0.0f64);
            for seed in 0..40 {
                let mut random = Random::new(seed);
                let points = near_round(&mut random, id, 10, cap, 0.1);
                let found = project(&with_radius(id, json!(radius)), &points, &points);
                let least = least_distance_squared(&points, id == "circle", radius, &mut random);
                let more = distance_squared(&points, &found) / least - 1.0;
                assert!(more >= -1e-6, "{id}, seed {seed}: the search found only {least}");
                sum += more;
                worst = worst.max(more);
            }
            let mean = sum / 40.0;
            println!("{id}, part {cap}, radius {radius}: excess mean {mean:.1e} max {worst:.1e}");
            assert!(mean <= bound, "{id}, part {cap}, radius {radius}: {mean:e} more");
        }
    }
}

#[test]
fn nearly_closest_for_rings_arcs_and_lines_of_any_flatness_size_and_place() {
    // The search began in the plane of the points, where the energy of a sphere has a saddle: an
    // arc of its equator moved by a fortieth of the radius.
    let radius = 5.0;
    for seed in 0..6 {
        let mut random = Random::new(seed);
        for (own, part) in [(5.0, 1.0), (4.5, 1.0), (2.0, 1.0), (7.0, 1.0), (5.0, 0.25), (4.0, 0.1)]
        {
            for (bent, noise) in [(0.0, 0.0), (0.0, 1e-12), (0.0, 1e-6), (0.0, 1e-2), (1e-3, 0.0)] {
                let points: Points = (0..12)
                    .map(|i| {
                        let t = f64::from(i) / 12.0 * part * std::f64::consts::TAU;
                        let height = bent * libm::sin(3.0 * t) + noise * random.uniform();
                        Vec3::new(own * libm::cos(t), own * libm::sin(t), height)
                    })
                    .collect();
                nearly_closest(&centred(&points), radius, &mut random, (own, part, bent, noise));
            }
        }
        let line: Points = (0..8).map(|i| Vec3::new(f64::from(i).sqrt(), 0.0, 0.0)).collect();
        nearly_closest(&centred(&line), radius, &mut random, (0.0, 0.0, 0.0, 0.0));
    }
}

fn nearly_closest(points: &Points, radius: f64, random: &mut Random, case: (f64, f64, f64, f64)) {
    let is_flat = points.iter().all(|v| v.z == 0.0);
    for id in ["sphere", "circle"].into_iter().filter(|id| *id == "sphere" || is_flat) {
        let least = least_distance_squared(points, id == "circle", radius, random);
        let frame = random.frame();
        for (scale, away) in [(1.0, 0.0), (1e-8, 0.0), (1e8, 0.0), (1.0, 1e6)] {
            let shift = Vec3::new(away, -away, away);
            let placed: Points =
                points.iter().map(|v| in_frame(frame, *v) * scale + shift).collect();
            let placed = centred(&placed);
            let kind = with_radius(id, json!(radius * scale));
            let found = project(&kind, &placed, &placed);
            let error = distance_squared(&placed, &found) / (scale * scale);
            // Coordinates far away are rounded.
            let rounding = points.len() as f64 * (1e-11f64 + 1e-14 * away).powi(2);
            let bound = least * (1.0 + 1e-6) + rounding;
            assert!(
                error <= bound,
                "{id} {case:?}, times {scale}, {away} away: {error:e}, least {least:e}"
            );
        }
    }
}

#[test]
fn limits_change_nothing_where_the_radius_is_within() {
    for id in ["circle", "sphere"] {
        let free = Kind::new(id, json!({})).expect("defaults are valid");
        for seed in 0..100 {
            let points = near_round(&mut Random::new(seed), id, 7, 1.0, 0.05);
            let expected = project(&free, &points, &points);
            for limits in [json!([0.5, 1.5]), json!([null, null]), json!([0.5, null])] {
                let found = project(&with_radius(id, limits), &points, &points);
                assert_eq!(found, expected, "{id}, seed {seed}");
            }
            let at_least = project(&with_radius(id, json!([1.2, null])), &points, &points);
            let exactly = project(&with_radius(id, json!(1.2)), &points, &points);
            assert_eq!(at_least, exactly, "{id}, seed {seed}");
        }
    }
}

/// The shape that is drawn is the one that the vertices are projected to.
#[test]
fn what_is_drawn_has_the_given_radius_and_all_projections() {
    for seed in 0..100 {
        for (id, n) in [("circle", 4), ("circle", 9), ("sphere", 4), ("sphere", 9)] {
            for cap in [1.0, 0.3] {
                let mut random = Random::new(seed);
                let place = random.vector();
                let points: Points = near_round(&mut random, id, n, cap, 0.1)
                    .iter()
                    .map(|v| place + *v + random.vector() * 0.05)
                    .collect();
                let middle = points[0] - centred(&points)[0];
                let kind = with_radius(id, json!([0.7, 0.8]));
                let found = project(&kind, &points, &centred(&points));
                let (centre, normal, radius) = match kind.visit(Draw(&points)) {
                    Some(Fitted::Circle { centre, normal, radius }) => (centre, normal, radius),
                    Some(Fitted::Sphere { centre, radius }) => (centre, Vec3::zero(), radius),
                    None => panic!("{id}, seed {seed}: nothing is drawn"),
                };
                assert!(
                    (0.7 - 1e-15..=0.8 + 1e-15).contains(&radius),
                    "{id}, seed {seed}: radius {radius}"
                );
                for p in &found {
                    let from_centre = *p + middle - centre;
                    let error = (from_centre.length() - radius).abs();
                    assert!(error <= 1e-12, "{id}, seed {seed}: {error:e} off the shape");
                    assert!(from_centre.dot(normal).abs() <= 1e-12, "{id}, seed {seed}: height");
                }
            }
        }
    }
}

#[test]
fn degenerate_places_are_as_documented() {
    let frame = Random::new(3).frame();
    let placed = |points: &[Vec3<f64>]| -> Points {
        centred(&points.iter().map(|v| in_frame(frame, *v)).collect::<Points>())
    };
    let line = placed(&[-1.0, -0.5, 0.0, 0.5, 1.0].map(|x| Vec3::new(x, 0.0, 0.0)));
    let square = placed(
        &[(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, y)| Vec3::new(x, y, 0.0)),
    );
    let equal = vec![Vec3::zero(); 5];
    let apart = |points: &Points, id: &str, radius: f64| {
        farthest(&project(&with_radius(id, json!(radius)), points, points), points)
    };
    for id in ["circle", "sphere"] {
        assert_eq!(apart(&equal, id, 2.0), 0.0, "{id}: coincident vertices moved");
        // The arc over the line is as high as its sagitta, and no vertex moves as far as that.
        let (moved, sagitta) = (apart(&line, id, 2.0), 2.0 - 3.0f64.sqrt());
        assert!(moved > 0.2 * sagitta && moved < sagitta, "{id}: a line moved by {moved}");
        assert!(apart(&line, id, 1e7) <= 1e-14, "{id}: a straight line moved");
    }
    // These are on a sphere of any radius that is large enough.
    assert!(apart(&square, "sphere", 1.6) <= 1e-3, "a square moved");
    assert!(apart(&square, "sphere", 1e7) <= 1e-14, "a square moved");
    let line_drawn = with_radius("circle", json!(1e7)).visit(Draw(&line));
    assert_eq!(line_drawn, None, "a line is drawn as a circle");
    let point = project(&with_radius("circle", json!(0)), &square, &square);
    assert!(size(&point) <= 1e-15, "with a radius of zero all meet: {point:?}");
}

#[test]
fn a_radius_of_zero_takes_all_points_to_their_mean() {
    // A point at the centre has no direction, and its distance was divided by the radius.
    let cross = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [0.0, 0.0]];
    let line = [[-1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [-2.0, 0.0]];
    for points in [cross, line, [[0.0; 2]; 5]] {
        for scale in [1.0, 1e-160, 1e-320, 1e150] {
            let points: Points = points.map(|[x, y]| Vec3::new(x * scale, y * scale, 0.0)).to_vec();
            for (id, radius) in [("circle", json!(0)), ("sphere", json!([0, 0]))] {
                let found = project(&with_radius(id, radius), &points, &points);
                let far = found.iter().map(|v| v.length()).fold(0.0, f64::max);
                assert!(far <= 1e-12 * scale, "{id}, {points:?}: {found:?}");
            }
        }
    }
}
