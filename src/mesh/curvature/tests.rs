//! Lines of curvature traced on meshes of surfaces with known lines.

use super::field::SurfacePoint;
use super::trace::{CurvatureLine, comes_back};
use super::{CurvatureField, Family};
use crate::math;
use crate::mesh::{Mesh, Point, Topology};
use std::collections::BTreeMap;

const FAMILIES: [Family; 2] = [Family::Larger, Family::Smaller];

fn field(mesh: &Mesh) -> CurvatureField {
    CurvatureField::new(&mesh.positions, mesh, &Topology::new(mesh))
}

/// A closed quad mesh of a torus, whose edges are at an angle to the circles of the torus.
fn torus(around: u32, along: u32) -> Mesh {
    net([around, along], [true, true], |u, v| {
        let (u, v) = (u + 0.04 * math::sine(v), v + u);
        let radius = 3.0 + math::cosine(v);
        [radius * math::cosine(u), radius * math::sine(u), math::sine(v)]
    })
}

/// An ellipsoid with semi-axes 3, 2 and 1.5: the sides of a cube, of n by n quads each, projected
/// onto it.
fn ellipsoid(n: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let mut known = BTreeMap::new();
    let half = 0.5 * f64::from(n);
    let mut vertex = |mesh: &mut Mesh, lattice: [u32; 3]| {
        *known.entry(lattice).or_insert_with(|| {
            let [x, y, z] = lattice.map(|k| math::sine(0.125 * (f64::from(k) / half - 1.0)));
            let length = (x * x + y * y + z * z).sqrt();
            mesh.positions.push([3.0 * x / length, 2.0 * y / length, 1.5 * z / length]);
            mesh.positions.len() as u32 - 1
        })
    };
    for axis in 0..3 {
        for side in [0, n] {
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let mut face = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| {
                    let mut lattice = [side; 3];
                    (lattice[(axis + 1) % 3], lattice[(axis + 2) % 3]) = (i, j);
                    vertex(&mut mesh, lattice)
                });
                if side == 0 {
                    face.reverse();
                }
                mesh.faces.push(&face);
            }
        }
    }
    mesh
}

/// Quads over the unit square of parameters, in turns, closed or open; seam vertices are not
/// duplicated.
fn net([n, m]: [u32; 2], closed: [bool; 2], point: impl Fn(f64, f64) -> Point) -> Mesh {
    let columns = if closed[0] { n } else { n + 1 };
    let rows = if closed[1] { m } else { m + 1 };
    let mut mesh = Mesh::default();
    for j in 0..rows {
        for i in 0..columns {
            mesh.positions.push(point(f64::from(i) / f64::from(n), f64::from(j) / f64::from(m)));
        }
    }
    let at = |i: u32, j: u32| (j % rows) * columns + i % columns;
    for j in 0..m {
        for i in 0..n {
            mesh.faces.push(&[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    mesh
}

/// The line through a point until it comes within an edge of an earlier part of itself.
fn line_through(
    field: &CurvatureField,
    point: SurfacePoint,
    family: Family,
) -> Option<CurvatureLine> {
    field.line_until(point, family, |points| comes_back(points, field.mean_edge()))
}

/// The lines of both families through every `every`-th face.
fn some_lines(mesh: &Mesh, every: usize) -> [Vec<CurvatureLine>; 2] {
    let field = field(mesh);
    let points: Vec<_> = field.centres().step_by(every).collect();
    FAMILIES.map(|family| {
        points.iter().filter_map(|&point| line_through(&field, point, family)).collect()
    })
}

/// Range of a quantity along a line.
fn spread(line: &CurvatureLine, quantity: impl Fn(Point) -> f64) -> f64 {
    let values = line.positions().map(quantity);
    let (low, high) =
        values.fold((f64::MAX, f64::MIN), |(low, high), value| (low.min(value), high.max(value)));
    high - low
}

/// Spread of the angle around the tube, as a point of the unit circle, or of the angle around the
/// axis, whichever is less: one of them is constant on a line of curvature.
fn off_the_circles(line: &CurvatureLine) -> f64 {
    let tube = |[x, y, z]: Point| [(x * x + y * y).sqrt() - 3.0, z];
    let around = |[x, y, _]: Point| {
        let length = (x * x + y * y).sqrt();
        [x / length, y / length]
    };
    let of = |quantity: &dyn Fn(Point) -> [f64; 2]| {
        [0, 1].map(|k| spread(line, |point| quantity(point)[k])).into_iter().fold(0.0, f64::max)
    };
    of(&tube).min(of(&around))
}

#[test]
fn on_a_torus_lines_of_curvature_tend_to_its_circles() {
    // A line that drifts by more than half an edge per turn is not closed, and continues for at
    // most a turn.
    let measured = |n: u32| {
        let lines = some_lines(&torus(2 * n, n), (n * n / 6) as usize).concat();
        let closed = lines.iter().filter(|line| line.closed).count();
        (lines.iter().map(off_the_circles).fold(0.0, f64::max), closed, lines.len())
    };
    let [(coarse, ..), (fine, closed, all)] = [72, 128].map(measured);
    println!("off the circles: {coarse:e} {fine:e}, {closed} of {all} closed");
    assert!(fine < 0.5 * coarse && fine < 0.1);
    assert!(all >= 20 && 4 * closed >= 3 * all, "{closed} of {all}");
}

#[test]
fn on_an_ellipsoid_lines_of_curvature_are_closed_confocal_curves() {
    // Lines of curvature are the intersections with confocal quadrics: one ellipsoidal coordinate
    // is constant along each.
    let coordinates = |[x, y, z]: Point| {
        let [a, b, c] = [9.0, 4.0, 2.25];
        // The two roots other than 0 of x^2/(a-t) + y^2/(b-t) + z^2/(c-t) = 1.
        let sum = a + b + c - x * x - y * y - z * z;
        let product = a * b + b * c + c * a - x * x * (b + c) - y * y * (a + c) - z * z * (a + b);
        let root = (0.25 * sum * sum - product).max(0.0).sqrt();
        [0.5 * sum - root, 0.5 * sum + root]
    };
    let error = |n: u32| {
        let lines = some_lines(&ellipsoid(n), (n * n / 4) as usize).concat();
        let closed = lines.iter().filter(|line| line.closed);
        let drifts = closed.clone().map(|line| {
            let [low, high] = [0, 1].map(|k| spread(line, |point| coordinates(point)[k]));
            low.min(high)
        });
        // Open lines end at the umbilics, at x = 2.58.
        let ends = lines.iter().filter(|line| !line.closed).flat_map(|line| {
            let ends: Vec<Point> = line.positions().collect();
            [ends[0], ends[ends.len() - 1]]
        });
        for [x, ..] in ends {
            assert!((2.3..2.9).contains(&x.abs()), "{n}: a line ends at {x}");
        }
        assert!(4 * closed.clone().count() >= 3 * lines.len(), "{n}: {}", closed.count());
        drifts.fold(0.0, f64::max)
    };
    let [coarse, fine] = [12, 36].map(error);
    println!("off the confocal quadrics: {coarse:e} {fine:e}");
    assert!(fine < 0.25 * coarse && fine < 0.1);
}

#[test]
fn on_a_cylinder_and_a_saddle_lines_of_curvature_are_as_known() {
    // A quarter of a cylinder, with triangles at an angle to its lines.
    let mesh = net([24, 40], [false, false], |u, v| {
        let turn = 0.25 * u + 0.05 * v;
        [2.0 * math::cosine(turn), 2.0 * math::sine(turn), 3.0 * v]
    });
    for (family, lines) in FAMILIES.into_iter().zip(some_lines(&mesh, 37)) {
        for line in lines {
            let straight = spread(&line, |[x, ..]| x).max(spread(&line, |[_, y, _]| y));
            let off = match family {
                Family::Larger => spread(&line, |[.., z]| z),
                Family::Smaller => straight,
            };
            assert!(off < 0.01 && !line.closed, "{family:?}: {off}");
        }
    }
    // z = x^2 - y^2: the lines through the middle are the parabolas over the axes.
    let mesh = net([41, 37], [false, false], |u, v| {
        let (x, y) = (1.6 * u - 0.8 + 0.1 * v, 1.6 * v - 0.8 - 0.1 * u);
        [x, y, x * x - y * y]
    });
    let field = field(&mesh);
    let far = |point: &SurfacePoint| point.at.x.abs() + point.at.y.abs();
    let middle = field.centres().min_by(|a, b| far(a).total_cmp(&far(b)));
    let point = middle.expect("it has faces");
    let mut off = FAMILIES.map(|family| {
        let line = line_through(&field, point, family).expect("it has a direction");
        assert!(line.points.len() > 100);
        [0, 1].map(|k| line.positions().map(|point| point[k].abs()).fold(0.0, f64::max))
    });
    off.sort_by(|a, b| a[0].total_cmp(&b[0]));
    assert!(off[0][0] < 0.08 && off[0][1] > 0.6 && off[1][1] < 0.08 && off[1][0] > 0.6, "{off:?}");
}

#[test]
fn a_vertex_without_a_face_does_not_enlarge_the_surface() {
    let mut mesh = torus(60, 24);
    let alone = field(&mesh).diameter();
    assert!((alone - 8.0).abs() < 0.1, "{alone}");
    mesh.positions.push([1e6, 0.0, 0.0]);
    assert_eq!(field(&mesh).diameter(), alone);
}

#[test]
fn spaced_lines_keep_their_distance_and_cover_the_surface() {
    let mesh = torus(60, 24);
    let field = field(&mesh);
    for family in FAMILIES {
        let distance = 0.8;
        let lines = field.spaced_lines(family, distance);
        let points: Vec<Vec<Point>> = lines.iter().map(|line| line.positions().collect()).collect();
        let gap = |a: &Point, b: &Point| {
            a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
        };
        for (i, one) in points.iter().enumerate() {
            for other in &points[..i] {
                let nearest = one.iter().flat_map(|a| other.iter().map(|b| gap(a, b)));
                // A line that ends near another one is up to half the distance and a step away from
                // it.
                assert!(nearest.fold(f64::MAX, f64::min) > 0.3 * distance);
            }
        }
        for centre in field.centres() {
            let at = Point::from(centre.at);
            let nearest = points.iter().flatten().map(|point| gap(&at, point));
            assert!(nearest.fold(f64::MAX, f64::min) < 1.6 * distance);
        }
    }
}

#[test]
fn a_sphere_and_a_plane_have_no_lines_and_no_strokes() {
    let round = net([24, 12], [true, false], |u, v| {
        let v = 0.05 + 0.4 * v;
        [math::sine(v) * math::cosine(u), math::sine(v) * math::sine(u), math::cosine(v)]
    });
    let flat = net([9, 9], [false, false], |u, v| [u, v, 0.0]);
    for mesh in [round, flat] {
        let field = field(&mesh);
        for family in FAMILIES {
            assert!(field.strokes(family).is_empty());
            assert!(field.spaced_lines(family, 0.2).is_empty());
        }
    }
}

#[test]
fn lines_depend_neither_on_the_unit_nor_on_how_faces_turn() {
    let mesh = torus(96, 48);
    let mut other = mesh.clone();
    other.positions.iter_mut().for_each(|p| *p = p.map(|x| 1000.0 * x));
    other.faces =
        mesh.faces.iter().map(|face| face.iter().rev().copied().collect::<Vec<_>>()).collect();
    let [a, b] = [&mesh, &other].map(|mesh| some_lines(mesh, 31));
    assert_eq!(a.each_ref().map(Vec::len), b.each_ref().map(Vec::len));
    for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
        assert_eq!(a.closed, b.closed);
        assert!((a.points.len() as f64 / b.points.len() as f64 - 1.0).abs() < 0.05);
    }
}

#[test]
fn strokes_lie_along_the_edges_of_a_net_that_follows_the_lines() {
    let mesh = net([36, 16], [true, true], |u, v| {
        let radius = 3.0 + math::cosine(v);
        [radius * math::cosine(u), radius * math::sine(u), math::sine(v)]
    });
    let field = field(&mesh);
    for family in FAMILIES {
        let strokes = field.strokes(family);
        assert_eq!(strokes.len(), mesh.faces.len());
        for [[x, y, z], [u, v, w]] in strokes {
            let way = [u - x, v - y, w - z];
            let length = way.iter().map(|x| x * x).sum::<f64>().sqrt();
            // Component across the plane through the axis and the midpoint.
            let [a, b] = [0.5 * (x + u), 0.5 * (y + v)];
            let around = (a * way[1] - b * way[0]).abs() / ((a * a + b * b).sqrt() * length);
            // Either around the axis, or in a plane through it.
            let off = around.min((1.0 - around * around).max(0.0).sqrt());
            assert!(off < 1e-6, "{off}");
        }
    }
}
