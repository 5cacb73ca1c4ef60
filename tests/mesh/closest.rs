//! The closest point of a surface against brute force, from every hint.

use crate::support::meshes::{mixed, wavy};
use proptest::prelude::*;
use shape_up::mesh::{ClosestPointCache, Mesh, Point, Ragged, Surface};

fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn distance(a: Point, b: Point) -> f64 {
    dot(sub(a, b), sub(a, b)).sqrt()
}

fn segment_distance(p: Point, a: Point, b: Point) -> f64 {
    let side = sub(b, a);
    let squared = dot(side, side);
    let t = if squared > 0.0 { (dot(sub(p, a), side) / squared).clamp(0.0, 1.0) } else { 0.0 };
    distance(p, [a[0] + t * side[0], a[1] + t * side[1], a[2] + t * side[2]])
}

/// Distance to a triangle: to the foot on its plane if the barycentric coordinates are positive,
/// else to the nearest side. Simple, and independent of the library.
fn triangle_distance(p: Point, [a, b, c]: [Point; 3]) -> f64 {
    let (u, v, w) = (sub(b, a), sub(c, a), sub(p, a));
    let (uu, uv, vv, wu, wv) = (dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v));
    let area = uu * vv - uv * uv;
    let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| segment_distance(p, from, to));
    let mut nearest = sides.into_iter().fold(f64::INFINITY, f64::min);
    if area > 1e-14 * uu * vv {
        let (s, t) = ((vv * wu - uv * wv) / area, (uu * wv - uv * wu) / area);
        if s >= 0.0 && t >= 0.0 && s + t <= 1.0 {
            let foot = [0, 1, 2].map(|k| a[k] + s * u[k] + t * v[k]);
            nearest = nearest.min(distance(p, foot));
        }
    }
    nearest
}

fn brute_force(mesh: &Mesh, p: Point) -> f64 {
    let at = |v: u32| mesh.positions[v as usize];
    let fans = mesh.faces.iter().flat_map(|face| {
        face[1..]
            .windows(2)
            .map(|side| triangle_distance(p, [at(face[0]), at(side[0]), at(side[1])]))
    });
    fans.fold(f64::INFINITY, f64::min)
}

fn size(mesh: &Mesh) -> f64 {
    let far = |p: &Point| p.iter().fold(0.0_f64, |far, x| far.max(x.abs()));
    mesh.positions.iter().map(far).fold(1e-300, f64::max)
}

/// Each vertex of a mesh, offset by `by` times a random step.
fn queries(mesh: &Mesh, steps: &[Point], by: f64) -> Vec<Point> {
    let around = mesh.positions.iter().zip(steps.iter().cycle());
    around.map(|(at, step)| [0, 1, 2].map(|k| at[k] + by * step[k])).collect()
}

/// The surface of a mesh: searched anew for each point, and prepared for searches from hints.
fn surfaces(mesh: &Mesh) -> [Surface; 2] {
    [Surface::new, Surface::for_iterations].map(|make| make(&mesh.positions, mesh))
}

fn steps() -> impl Strategy<Value = Vec<Point>> {
    prop::collection::vec(prop::array::uniform3(-1.0..1.0), 50)
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(48))]

    #[test]
    fn is_as_near_as_brute_force_finds_from_any_warm_start(mesh in mixed(), steps in steps()) {
        prop_assume!(!mesh.faces.is_empty());
        let tolerance = 1e-13 * size(&mesh);
        for (surface, by) in surfaces(&mesh).iter().flat_map(|surface| {
            [0.0, 1e-9, 1e-3, 0.1, 0.4, 1.0, 10.0].map(|by| (surface, by))
        }) {
            // Each search starts from the hint of another point.
            let mut hint = Surface::NO_HINT;
            for p in queries(&mesh, &steps, by) {
                let expected = brute_force(&mesh, p);
                let from_hint = surface.closest(p, &mut hint);
                prop_assert!((distance(p, from_hint) - expected).abs() <= tolerance);
                // The result is on the surface, up to the rounding at a thin face, and another
                // search from the same hint agrees.
                let off = brute_force(&mesh, from_hint);
                prop_assert!(off <= 10.0 * tolerance, "{off:e} off, with {tolerance:e} at {by}, {p:?}");
                let again = surface.closest(p, &mut hint.clone());
                prop_assert!((distance(p, again) - expected).abs() <= tolerance);
                let without = surface.closest(p, &mut Surface::NO_HINT.clone());
                prop_assert!((distance(p, without) - expected).abs() <= tolerance);
            }
        }
    }

    #[test]
    fn a_footing_changes_no_bit(mesh in mixed(), steps in steps()) {
        prop_assume!(!mesh.faces.is_empty());
        let surface = Surface::for_iterations(&mesh.positions, &mesh);
        let start = vec![(Surface::NO_HINT, ClosestPointCache::unknown(), Surface::NO_HINT); mesh.positions.len()];
        let mut left = start;
        // Each vertex moves, and its search starts from its own last hint.
        for by in [0.0, 0.01, 0.02, -0.1, 0.1, 0.4, -1.0, 0.4, 0.41] {
            for (p, (hint, footing, other)) in queries(&mesh, &steps, by).into_iter().zip(&mut left) {
                let found = surface.closest_from(p, hint, footing);
                prop_assert_eq!(found.map(f64::to_bits), surface.closest(p, other).map(f64::to_bits));
                prop_assert_eq!(*hint, *other);
            }
        }
    }

    #[test]
    fn moves_and_scales_with_the_mesh(
        mesh in mixed(),
        steps in steps(),
        scale in prop::sample::select(vec![1e-3, 1.0, 1e3]),
        offset in prop::array::uniform3(-100.0..100.0),
    ) {
        prop_assume!(!mesh.faces.is_empty());
        let map = |p: Point| [0, 1, 2].map(|k| scale * (p[k] + offset[k]));
        let mut moved = mesh.clone();
        moved.positions.iter_mut().for_each(|p| *p = map(*p));
        let (surface, other) =
            (Surface::new(&mesh.positions, &mesh), Surface::for_iterations(&moved.positions, &moved));
        for p in queries(&mesh, &steps, 0.3) {
            let a = distance(p, surface.closest(p, &mut Surface::NO_HINT.clone()));
            let b = distance(map(p), other.closest(map(p), &mut Surface::NO_HINT.clone()));
            prop_assert!((scale * a - b).abs() <= 1e-12 * size(&moved));
        }
    }

    #[test]
    fn folded_and_flattened_surfaces_are_searched_right(
        mesh in mixed(),
        steps in steps(),
        squeeze in prop::sample::select(vec![0.0, 1e-12, 1e-6, 1e-2]),
        axis in 0_usize..3,
    ) {
        prop_assume!(!mesh.faces.is_empty());
        // Mirroring half of the plan folds the surface over itself; squeezing makes slivers and
        // coplanar faces.
        let mut mesh = mesh;
        for p in &mut mesh.positions {
            p[0] = (p[0] - 2.0).abs();
            p[axis] *= squeeze;
        }
        for surface in surfaces(&mesh) {
            let mut hint = Surface::NO_HINT;
            for p in [0.0, 1e-4, 0.2].into_iter().flat_map(|by| queries(&mesh, &steps, by)) {
                // The second search may end in the region of the triangle that the first one found.
                for _ in 0..2 {
                    let found = distance(p, surface.closest(p, &mut hint));
                    prop_assert!((found - brute_force(&mesh, p)).abs() <= 2e-7 * size(&mesh));
                }
            }
        }
    }
}

#[test]
fn vertices_are_on_their_own_surface() {
    for name in ["halftunnel.off", "bunny_poly.obj", "horse_quad.obj", "decimated-knight.off"] {
        let Some(mesh) = crate::support::shared::mesh(name) else { continue };
        let surface = Surface::for_iterations(&mesh.positions, &mesh);
        for &p in &mesh.positions {
            let mut hint = Surface::NO_HINT;
            for _ in 0..2 {
                assert!(
                    distance(p, surface.closest(p, &mut hint)) <= 1e-14 * size(&mesh),
                    "{name}"
                );
            }
        }
    }
}

#[test]
fn curves_stand_for_a_mesh_without_faces_and_points_for_one_without_either() {
    let positions = vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [5.0, 5.0, 5.0]];
    let curves = Ragged::from_iter([[0, 1, 2]]);
    let polyline = Mesh { positions, curves, ..Mesh::default() };
    let surface = Surface::for_iterations(&polyline.positions, &polyline);
    let mut hint = Surface::NO_HINT;
    for _ in 0..2 {
        assert_eq!(surface.closest([0.5, -1.0, 0.25], &mut hint), [0.5, 0.0, 0.0]);
        assert_eq!(surface.closest([3.0, 1.5, 0.0], &mut hint), [2.0, 1.5, 0.0]);
        assert_eq!(surface.closest([5.0, 5.0, 5.0], &mut hint), [2.0, 2.0, 0.0]);
    }
    let points = Mesh { curves: Ragged::new(), ..polyline };
    let surface = Surface::for_iterations(&points.positions, &points);
    for _ in 0..2 {
        assert_eq!(surface.closest([1.5, 0.5, 0.0], &mut hint), [2.0, 0.0, 0.0]);
        assert_eq!(surface.closest([9.0, 5.0, 5.0], &mut hint), [5.0, 5.0, 5.0]);
    }
    let nothing = Surface::for_iterations(&[], &Mesh::default());
    assert_eq!(nothing.closest([1.0, 2.0, 3.0], &mut hint), [1.0, 2.0, 3.0]);
}

#[test]
fn ten_thousand_triangles_around_one_corner_are_no_burden() {
    // The neighbourhood list of each triangle would contain all others.
    let mut fan = Mesh { positions: vec![[0.0; 3]], ..Mesh::default() };
    for k in 0..10_000_u32 {
        let t = f64::from(k) / 10_000.0;
        fan.positions.push([1.0 - 2.0 * t, t * (1.0 - t), t * t]);
        if k > 0 {
            fan.faces.push(&[0, k, k + 1]);
        }
    }
    let surface = Surface::for_iterations(&fan.positions, &fan);
    let mut hint = Surface::NO_HINT;
    for p in [[0.1, 0.1, 0.1], [0.1, 0.11, 0.1], [-3.0, 0.0, 0.0], [0.0; 3]] {
        let found = distance(p, surface.closest(p, &mut hint));
        assert!((found - brute_force(&fan, p)).abs() < 1e-7);
    }
}

#[test]
fn a_search_ends_where_coordinates_are_not_finite() {
    let mesh = wavy(1, 1);
    let surface = Surface::for_iterations(&mesh.positions, &mesh);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut hint = Surface::NO_HINT;
        surface.closest([bad, 0.0, 0.0], &mut hint);
        assert_eq!(surface.closest([0.0, 0.0, 0.0], &mut hint), [0.0, 0.0, 0.0]);
    }
}
