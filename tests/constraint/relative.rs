//! Relative shapes (paper section 3.2) against the paper's methods, implemented with nalgebra, and
//! their special cases.

use crate::support::random::{Points, Random, centred, distance_squared, farthest, in_frame, size};
use nalgebra::{DMatrix, Matrix3, SymmetricEigen, Vector3};
use serde_json::{Value, json};
use shape_up::constraint::{Kind, KindVisitor, Projection};
use shape_up::math::Vec3;

fn project(id: &str, params: Value, rest: &Points, points: &Points) -> Points {
    let kind = Kind::new(id, params).expect("the parameters are valid");
    crate::support::project::project(&kind, rest, points)
}

/// Points in a box with these sides.
fn cloud(random: &mut Random, n: usize, sides: [f64; 3]) -> Points {
    let points: Points = (0..n)
        .map(|_| random.vector())
        .map(|v| Vec3::new(v.x * sides[0], v.y * sides[1], v.z * sides[2]))
        .collect();
    centred(&points)
}

/// The rest points, rotated at random and disturbed.
fn moved(random: &mut Random, rest: &Points, noise: f64) -> Points {
    let frame = random.frame();
    let points: Points =
        rest.iter().map(|r| in_frame(frame, *r) + random.vector() * noise).collect();
    centred(&points)
}

fn vector(v: Vec3<f64>) -> Vector3<f64> {
    Vector3::new(v.x, v.y, v.z)
}

/// Umeyama 1991: rotation and scale.
fn umeyama(rest: &Points, points: &Points) -> (Matrix3<f64>, f64) {
    let h: Matrix3<f64> =
        points.iter().zip(rest).map(|(v, r)| vector(*v) * vector(*r).transpose()).sum();
    let svd = h.svd(true, true);
    let (u, vt) = (svd.u.expect("asked for"), svd.v_t.expect("asked for"));
    let mut signs = Vector3::repeat(1.0);
    if (u * vt).determinant() < 0.0 {
        signs[svd.singular_values.imin()] = -1.0;
    }
    let rotation = u * Matrix3::from_diagonal(&signs) * vt;
    let square: f64 = rest.iter().map(|r| r.length_squared()).sum();
    (rotation, svd.singular_values.dot(&signs) / square)
}

fn image(m: Matrix3<f64>, rest: &Points) -> Points {
    rest.iter().map(|r| m * vector(*r)).map(|p| Vec3::new(p.x, p.y, p.z)).collect()
}

#[test]
fn rigid_and_similar_agree_with_umeyama() {
    for sides in [[1.0, 1.0, 1.0], [1.0, 0.3, 0.1], [1.0, 0.5, 0.0]] {
        for seed in 0..1000 {
            let mut random = Random::new(seed);
            let rest = cloud(&mut random, 3 + seed as usize % 6, sides);
            let points = moved(&mut random, &rest, [0.01, 0.1, 0.5][seed as usize % 3]);
            let (rotation, scale) = umeyama(&rest, &points);
            for (id, expected) in [("rigid", rotation), ("similar", rotation * scale)] {
                let found = project(id, json!({}), &rest, &points);
                let error = farthest(&found, &image(expected, &rest));
                assert!(error <= 1e-9, "{id}, {sides:?}, seed {seed}: off by {error:e}");
            }
        }
    }
}

struct ClosedForm<'a>(&'a Points, &'a Points);

impl KindVisitor for ClosedForm<'_> {
    type Output = bool;
    fn visit<P: Projection>(self, operator: &P) -> bool {
        operator.closed_form(self.0, self.1, &mut self.1.clone())
    }
}

/// The speed depends on it: common shapes do not need the careful path. Regular solids, whose
/// singular values are equal, are the hard case.
#[test]
fn the_closed_form_serves_ordinary_shapes() {
    let corners = |i: usize| [(i & 1), (i >> 1) & 1, (i >> 2) & 1].map(|bit| bit as f64);
    let cube: Points = centred(&(0..8).map(|i| Vec3::from(corners(i))).collect::<Points>());
    let tet: Points = centred(&[0, 3, 5, 6].map(|i| Vec3::from(corners(i))));
    let quad: Points = centred(&[0, 1, 3, 2].map(|i| Vec3::from(corners(i))));
    let slat: Points = quad.iter().map(|v| Vec3::new(v.x, v.y * 0.05, v.z)).collect();
    let kind = Kind::new("rigid", json!({})).expect("defaults are valid");
    for (name, rest) in [("cube", cube), ("tet", tet), ("quad", quad), ("slat", slat)] {
        for noise in [0.0, 1e-9, 1e-6, 1e-4, 1e-2, 0.1] {
            let noise = noise * size(&rest) * if name == "slat" { 0.05 } else { 1.0 };
            let mut careful = 0;
            for seed in 0..200 {
                let points = moved(&mut Random::new(seed), &rest, noise);
                careful += usize::from(!kind.visit(ClosedForm(&rest, &points)));
            }
            println!("{name}, noise {noise:e}: {careful} of 200 need the careful path");
            assert!(careful <= 4, "{name}, noise {noise:e}: {careful} of 200");
        }
    }
}

#[test]
fn a_mirror_image_is_not_the_same_shape() {
    let mut random = Random::new(7);
    let rest = cloud(&mut random, 5, [1.0, 0.7, 0.4]);
    let mirrored: Points = rest.iter().map(|r| Vec3::new(r.x, r.y, -r.z)).collect();
    for id in ["rigid", "similar"] {
        let found = project(id, json!({}), &rest, &mirrored);
        let volume = |p: &Points| p[0].dot(p[1].cross(p[2]));
        assert!(volume(&found) * volume(&rest) > 0.0, "{id} has flipped over");
        assert!(farthest(&found, &mirrored) > 0.1, "{id} took the mirror image");
    }
    // In a plane a mirror image is the same shape seen from behind.
    let flat: Points = rest.iter().map(|r| Vec3::new(r.x, r.y, 0.0)).collect();
    let behind: Points = flat.iter().map(|r| Vec3::new(r.x, -r.y, 0.0)).collect();
    for id in ["rigid", "similar", "planar-similar"] {
        let found = project(id, json!({}), &flat, &behind);
        assert!(farthest(&found, &behind) <= 1e-12, "{id}");
    }
}

#[test]
fn the_scale_stays_within_its_limits_and_is_the_best_there() {
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let rest = cloud(&mut random, 6, [1.0, 1.0, 1.0]);
        let size = 0.2 + 1.5 * (random.uniform() + 1.0);
        let points: Points = moved(&mut random, &rest, 0.1).iter().map(|v| *v * size).collect();
        let (rotation, best) = umeyama(&rest, &points);
        let limits = [
            [None, None],
            [Some(0.8), None],
            [None, Some(1.5)],
            [Some(0.8), Some(1.5)],
            [Some(1.0), Some(1.0)],
            [None, Some(0.0)],
        ];
        for [least, greatest] in limits {
            let found = project("similar", json!({ "scale": [least, greatest] }), &rest, &points);
            let scale = best.max(least.unwrap_or(0.0)).min(greatest.unwrap_or(f64::INFINITY));
            let error = farthest(&found, &image(rotation * scale, &rest));
            assert!(error <= 1e-9, "{least:?} to {greatest:?}, seed {seed}: off by {error:e}");
        }
        let fixed = project("similar", json!({ "scale": [1, 1] }), &rest, &points);
        let rigid = project("rigid", json!({}), &rest, &points);
        assert!(farthest(&fixed, &rigid) <= 1e-12, "scale one is rigid");
    }
}

/// Eq. 7 and 8 literally: `P = A (A^T A)^-1 A^T` of the flattened rest points, applied to the
/// flattened points, for both orientations of their plane.
fn eq_8(rest: &Points, points: &Points) -> Points {
    let flat = |points: &Points| {
        let scatter: Matrix3<f64> =
            points.iter().map(|p| vector(*p) * vector(*p).transpose()).sum();
        let eigen = SymmetricEigen::new(scatter);
        let normal = eigen.eigenvalues.imin();
        let [e, f] =
            [(normal + 1) % 3, (normal + 2) % 3].map(|k| eigen.eigenvectors.column(k).into_owned());
        let rows: Vec<[f64; 2]> =
            points.iter().map(|p| [vector(*p).dot(&e), vector(*p).dot(&f)]).collect();
        (e, f, rows)
    };
    let (_, _, rest) = flat(rest);
    let (e, f, rows) = flat(points);
    let [x, y] = rest[0];
    let square = x * x + y * y;
    let a = DMatrix::from_fn(2 * rest.len(), 2, |i, j| {
        let [p, q] = rest[i / 2];
        let (same, turned) = ((p * x + q * y) / square, (q * x - p * y) / square);
        [[same, -turned], [turned, same]][i % 2][j]
    });
    let inverse = (a.transpose() * &a).try_inverse().expect("it is regular");
    let projection = &a * inverse * a.transpose();
    let mut candidates = [1.0, -1.0].map(|side| {
        let b = DMatrix::from_fn(2 * rows.len(), 1, |i, _| rows[i / 2][i % 2] * [1.0, side][i % 2]);
        let p = &projection * b;
        (0..rows.len())
            .map(|i| e * p[2 * i] + f * (p[2 * i + 1] * side))
            .map(|p| Vec3::new(p.x, p.y, p.z))
            .collect::<Points>()
    });
    candidates.sort_by(|a, b| distance_squared(points, a).total_cmp(&distance_squared(points, b)));
    let [nearest, _] = candidates;
    nearest
}

#[test]
fn planar_similar_agrees_with_eq_8_also_for_rest_points_that_are_not_flat() {
    for seed in 0..1000 {
        let mut random = Random::new(seed);
        let rest = cloud(&mut random, 3 + seed as usize % 6, [1.0, 0.8, 0.2]);
        let points = moved(&mut random, &rest, 0.05);
        let found = project("planar-similar", json!({}), &rest, &points);
        let error = farthest(&found, &eq_8(&rest, &points));
        assert!(error <= 1e-9, "seed {seed}: off by {error:e}");
    }
}

#[test]
fn two_vertices_keep_their_distance() {
    let rest = vec![Vec3::new(1.5, 0.0, 0.0), Vec3::new(-1.5, 0.0, 0.0)];
    let points = vec![Vec3::new(0.0, 3.0, 4.0), Vec3::new(0.0, -3.0, -4.0)];
    let expected = vec![Vec3::new(0.0, 0.9, 1.2), Vec3::new(0.0, -0.9, -1.2)];
    assert!(farthest(&project("rigid", json!({}), &rest, &points), &expected) <= 1e-15);
    assert!(farthest(&project("similar", json!({}), &rest, &points), &points) <= 1e-14);
}

/// The paper's Fig. 10 starts with this case.
#[test]
fn collapsed_vertices_take_the_rest_shape_as_it_is() {
    let rest = cloud(&mut Random::new(3), 6, [1.0, 1.0, 1.0]);
    let collapsed = vec![Vec3::zero(); 6];
    assert_eq!(project("rigid", json!({}), &rest, &collapsed), rest);
    for id in ["similar", "planar-similar"] {
        assert_eq!(project(id, json!({}), &rest, &collapsed), collapsed);
    }
    let grown = project("similar", json!({ "scale": [0.5, null] }), &rest, &collapsed);
    let expected: Points = rest.iter().map(|r| *r * 0.5).collect();
    assert!(farthest(&grown, &expected) <= 1e-15);
}

#[test]
fn a_tetrahedron_that_is_flat_at_rest_becomes_a_positive_one() {
    for seed in 0..40 {
        let mut random = Random::new(seed);
        // Flat in a tilted plane: the sign of the rest volume is that of a rounding error.
        let flat = cloud(&mut random, 4, [1.0, 1.0, 0.0]);
        let rest = moved(&mut random, &flat, 0.0);
        let points = moved(&mut random, &rest, 0.3);
        let found = project("volume", json!({ "volume": 0.5 }), &rest, &points);
        let [a, b, c] = [1, 2, 3].map(|k| found[k] - found[0]);
        let volume = a.dot(b.cross(c)) / 6.0;
        assert!((volume - 0.5).abs() < 1e-9, "seed {seed}: {volume}");
    }
}
