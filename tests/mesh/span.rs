//! Meshes between curves of a file: on the curves, sound, independent of the direction of the
//! curves, and refused if they are impossible.

use shape_up::generate::{SpanCurve, SpanError, fill, loft};
use shape_up::math::{Vec3, cosine, sine, twice_vector_area};
use shape_up::mesh::{Mesh, Point, Topology, diagnose};

const UP: Point = [0.0, 0.0, 1.0];

/// Polylines with separate vertices; a closed one repeats its first vertex.
fn curves(polylines: &[(Vec<Point>, bool)]) -> Vec<SpanCurve> {
    let mut mesh = Mesh::default();
    for (points, closed) in polylines {
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(points);
        let mut curve: Vec<u32> = (first..mesh.positions.len() as u32).collect();
        if *closed {
            curve.push(first);
        }
        mesh.curves.push(&curve);
    }
    SpanCurve::all(&mesh)
}

fn arch(n: u32, y: f64, rise: f64) -> Vec<Point> {
    let at = |k: u32| 0.5 * f64::from(k) / f64::from(n);
    (0..=n).map(|k| [-8.0 * cosine(at(k)), y, rise * sine(at(k))]).collect()
}

fn circle(n: u32, radius: f64, z: f64, turn: f64) -> Vec<Point> {
    let at = |k: u32| turn + f64::from(k) / f64::from(n);
    (0..n).map(|k| [radius * cosine(at(k)), radius * sine(at(k)), z]).collect()
}

fn reversed(points: &[Point]) -> Vec<Point> {
    points.iter().rev().copied().collect()
}

fn assert_sound(mesh: &Mesh) {
    assert!(diagnose(mesh).is_empty(), "{:?}", diagnose(mesh));
    let topology = Topology::new(mesh);
    assert!(topology.edge_faces().iter().all(|faces| (1..=2).contains(&faces.len())));
    // Adjacent faces have the same orientation: no side occurs twice in the same direction.
    let mut sides: Vec<[u32; 2]> = mesh
        .faces
        .iter()
        .flat_map(|face| (0..face.len()).map(|k| [face[k], face[(k + 1) % face.len()]]))
        .collect();
    let count = sides.len();
    sides.sort_unstable();
    sides.dedup();
    assert_eq!(sides.len(), count);
}

fn area(mesh: &Mesh) -> f64 {
    let corners = |face: &[u32]| -> Vec<_> {
        face.iter().map(|&v| Vec3::from(mesh.positions[v as usize])).collect()
    };
    mesh.faces.iter().map(|face| 0.5 * twice_vector_area(corners(face)).length()).sum()
}

#[test]
fn a_loft_goes_from_curve_to_curve_whichever_way_they_run() {
    let [low, high] = [arch(24, 0.0, 3.0), arch(40, 15.0, 6.0)];
    let made = |a: &[Point], b: &[Point]| {
        let curves = curves(&[(a.to_vec(), false), (b.to_vec(), false)]);
        loft(&curves[0], &curves[1], 1.5, UP).unwrap()
    };
    let mesh = made(&low, &high);
    assert_sound(&mesh);
    assert_eq!(mesh.faces.len() % 10, 0, "15 m in rows of 1.5");
    // Its ends are exactly at the ends of the curves.
    for end in [low[0], low[24], high[0], high[40]] {
        assert!(mesh.positions.contains(&end));
    }
    // Every vertex is between the two curves, and faces are counterclockwise seen from above.
    assert!(mesh.positions.iter().all(|p| p[1] >= 0.0 && p[1] <= 15.0 && p[2] >= -1e-12));
    for other in [made(&low, &reversed(&high)), made(&reversed(&low), &high), made(&high, &low)] {
        assert_sound(&other);
        assert!((area(&other) - area(&mesh)).abs() < 1e-9 * area(&mesh));
    }
    assert_eq!(made(&low, &high), mesh, "it is deterministic");
}

#[test]
fn equally_many_points_are_joined_one_to_one() {
    let [low, high] = [arch(9, 0.0, 3.0), arch(9, 4.0, 5.0)];
    let curves = curves(&[(low.clone(), false), (high.clone(), false)]);
    let mesh = loft(&curves[0], &curves[1], 100.0, UP).unwrap();
    assert_eq!((mesh.positions.len(), mesh.faces.len()), (20, 9));
    assert!(low.iter().chain(&high).all(|point| mesh.positions.contains(point)));
}

#[test]
fn corners_of_a_curve_stay_corners() {
    let bent = vec![[0.0, 0.0, 0.0], [4.1, 0.0, 0.0], [4.1, 7.3, 0.0]];
    let other = vec![[0.0, 3.0, 5.0], [2.0, 3.0, 5.0], [2.0, 9.0, 5.0], [2.0, 11.0, 5.0]];
    let curves = curves(&[(bent.clone(), false), (other.clone(), false)]);
    let mesh = loft(&curves[0], &curves[1], 1.0, UP).unwrap();
    for corner in [bent[1], other[1]] {
        assert!(mesh.positions.contains(&corner), "{corner:?}");
    }
}

/// The first point of a frame, a corner, was there twice, and the first column of panels had no width.
#[test]
fn a_closed_curve_that_begins_on_a_corner_has_each_of_its_points_once() {
    let frame = [[-2.0, -2.0, 0.0], [2.0, -2.0, 0.0], [2.0, 2.0, 0.0], [-2.0, 2.0, 0.0]];
    let curves = curves(&[(frame.to_vec(), true), (circle(32, 2.0, 3.0, 0.0), true)]);
    let mesh = loft(&curves[0], &curves[1], 1.0, UP).unwrap();
    assert_sound(&mesh);
    assert!(frame.iter().all(|corner| mesh.positions.contains(corner)));
    for (k, &p) in mesh.positions.iter().enumerate() {
        let is_far = |&q: &Point| (Vec3::from(q) - Vec3::from(p)).length() > 0.3;
        assert!(mesh.positions[k + 1..].iter().all(is_far), "{p:?}");
    }
}

/// With fewer than four corners, all but the first were cut off.
#[test]
fn the_corners_of_a_half_disc_are_vertices() {
    for (steps, size) in [(12, 0.5), (17, 0.37), (24, 0.7)] {
        let half: Vec<Point> = (0..=steps)
            .map(|k| 0.5 * f64::from(k) / f64::from(steps))
            .map(|turn| [5.0 * cosine(turn), 5.0 * sine(turn), 0.0])
            .collect();
        let mesh = fill(&curves(&[(half.clone(), true)])[0], size, UP).unwrap();
        assert_sound(&mesh);
        for corner in [half[0], half[steps as usize]] {
            assert!(mesh.positions.contains(&corner), "{steps} {corner:?}");
        }
    }
}

#[test]
fn closed_curves_are_joined_where_they_are_nearest() {
    // Frustums: the second circle begins elsewhere, runs the other way, and has other points.
    for (second, points) in
        [(circle(32, 3.0, 6.0, 0.3), 32), (reversed(&circle(50, 3.0, 6.0, 0.7)), 50)]
    {
        let curves = curves(&[(circle(32, 5.0, 0.0, 0.0), true), (second, true)]);
        let mesh = loft(&curves[0], &curves[1], 1.0, UP).unwrap();
        assert_sound(&mesh);
        let topology = Topology::new(&mesh);
        assert_eq!(topology.boundary_loops().len(), 2);
        let exact = std::f64::consts::PI * 8.0 * (4.0_f64 + 36.0).sqrt();
        assert!((area(&mesh) / exact - 1.0).abs() < 0.02, "{points}: {} {exact}", area(&mesh));
    }
}

#[test]
fn closed_curves_of_very_many_points_are_joined_as_well_and_soon() {
    // All orders of all points would take minutes.
    let begun = std::time::Instant::now();
    let n = 50_000;
    let second = reversed(&circle(n, 3.0, 6.0, 0.3));
    let curves = curves(&[(circle(n, 5.0, 0.0, 0.0), true), (second, true)]);
    let mesh = loft(&curves[0], &curves[1], 100.0, UP).unwrap();
    let exact = std::f64::consts::PI * 8.0 * (4.0_f64 + 36.0).sqrt();
    assert!((area(&mesh) / exact - 1.0).abs() < 1e-6, "{} {exact}", area(&mesh));
    assert!(begun.elapsed().as_secs() < 20, "{:?}", begun.elapsed());
}

#[test]
fn a_filled_boundary_is_a_surface_with_that_boundary() {
    // A rectangle with bent sides, a circle in space, and an opening of a mesh.
    let mut loops: Vec<(Vec<Point>, usize)> = Vec::new();
    let mut frame: Vec<Point> = arch(20, 0.0, 3.0);
    frame.extend(reversed(&arch(20, 9.0, 5.0)));
    loops.push((frame, 4));
    loops.push((circle(48, 4.0, 2.0, 0.1), 0));
    for (points, corners) in loops {
        let curves = curves(&[(points.clone(), true)]);
        let mesh = fill(&curves[0], 0.8, UP).unwrap();
        assert_sound(&mesh);
        let topology = Topology::new(&mesh);
        assert_eq!(topology.boundary_loops().len(), 1);
        let rim: Vec<Point> =
            topology.boundary_loops().row(0).iter().map(|&v| mesh.positions[v as usize]).collect();
        // The rim is on the curve: it has its length, up to the chord error.
        let length = |points: &[Point]| {
            let ends = points.iter().zip(points.iter().cycle().skip(1));
            ends.map(|(&a, &b)| (Vec3::from(b) - Vec3::from(a)).length()).sum::<f64>()
        };
        assert!((length(&rim) / length(&points) - 1.0).abs() < 0.02);
        if corners == 4 {
            for k in [0, 20, 21, 41] {
                assert!(rim.contains(&points[k]), "corner {k}");
            }
        }
        let up = mesh.faces.iter().map(|face| {
            twice_vector_area(face.iter().map(|&v| Vec3::from(mesh.positions[v as usize]))).z
        });
        assert!(up.sum::<f64>() > 0.0, "seen from above counterclockwise");
    }
    // Boundary loops of a mesh are curves too, listed after its polylines.
    let grid = crate::support::grid::grid(6, 4, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let curves = SpanCurve::all(&grid);
    let words = SpanCurve::labels(&curves);
    assert_eq!(
        (words[0].label.as_str(), words[0].length, words[0].closed),
        ("Boundary 1", 20.0, true)
    );
    assert_eq!(fill(&curves[0], 1.0, UP).unwrap().faces.len(), 24);
}

#[test]
fn corners_are_taken_along_the_curve_however_sharp_they_are() {
    // The first and the third are the sharpest.
    let corners = vec![[0.0, 0.0, 0.0], [5.0, -2.0, 0.0], [10.5, 0.0, 0.0], [5.0, 2.5, 0.0]];
    let mesh = fill(&curves(&[(corners, true)])[0], 0.5, UP).unwrap();
    assert_sound(&mesh);
    assert!((area(&mesh) - 0.5 * 10.5 * 4.5).abs() < 1e-9, "{}", area(&mesh));
}

#[test]
fn a_point_at_the_one_before_and_ends_that_meet_make_no_difference() {
    let [low, high] = [arch(6, 0.0, 3.0), arch(9, 4.0, 5.0)];
    let lofted = |first: Vec<Point>| {
        let curves = curves(&[(first, false), (high.clone(), false)]);
        loft(&curves[0], &curves[1], 0.5, UP).unwrap()
    };
    let expected = lofted(low.clone());
    for k in [0, 3, 6] {
        let mut doubled = low.clone();
        doubled.insert(k, low[k]);
        assert_eq!(lofted(doubled), expected, "point {k}");
    }
    let frame = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 3.0, 0.0], [0.0, 3.0, 0.0]];
    let filled = |points: Vec<Point>, closed: bool| fill(&curves(&[(points, closed)])[0], 0.5, UP);
    let expected = filled(frame.clone(), true).unwrap();
    assert_eq!(expected.faces.len(), 48);
    let mut doubled = frame.clone();
    doubled.insert(1, frame[1]);
    assert_eq!(filled(doubled, true).unwrap(), expected, "a corner twice");
    let mut meeting = frame.clone();
    meeting.push(frame[0]);
    assert_eq!(filled(meeting.clone(), false).unwrap(), expected, "two vertices where it closes");
    assert_eq!(filled(meeting, true).unwrap(), expected, "and an edge between them");
}

#[test]
fn the_boundary_of_a_wall_on_a_floor_is_open() {
    let curves = SpanCurve::all(&crate::support::grid::wall_on_floor());
    let labels = SpanCurve::labels(&curves);
    let found: Vec<_> = labels.iter().map(|label| (label.closed, label.length)).collect();
    assert_eq!(found, [(true, 8.0), (false, 3.0)]);
    assert_eq!(fill(&curves[1], 0.5, UP), Err(SpanError::Open));
}

#[test]
fn a_surface_looks_up_along_the_up_axis_of_its_file() {
    let frame = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 0.0, 3.0], [0.0, 0.0, 3.0]];
    let line = |z: f64| (vec![[0.0, 0.0, z], [3.0, 0.0, z]], false);
    let curves = curves(&[line(0.0), line(2.0), (frame.clone(), true), (reversed(&frame), true)]);
    for up in [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]] {
        let lofts = [[0, 1], [1, 0]].map(|[a, b]| loft(&curves[a], &curves[b], 0.5, up));
        let fills = [2, 3].map(|k| fill(&curves[k], 0.5, up));
        for mesh in lofts.into_iter().chain(fills) {
            let mesh = mesh.unwrap();
            let corners = mesh.faces.row(0).iter().map(|&v| Vec3::from(mesh.positions[v as usize]));
            assert!(twice_vector_area(corners).dot(Vec3::from(up)) > 0.0, "{up:?}");
        }
    }
}

#[test]
fn what_cannot_be_is_refused_with_the_reason() {
    let line = |y: f64| vec![[0.0, y, 0.0], [3.0, y, 0.0]];
    let known = curves(&[
        (line(0.0), false),
        (line(2.0), false),
        (circle(12, 2.0, 0.0, 0.0), true),
        (vec![[1.0; 3], [1.0; 3]], false),
    ]);
    assert!(loft(&known[0], &known[1], 0.5, UP).is_ok());
    assert_eq!(loft(&known[0], &known[2], 0.5, UP), Err(SpanError::OneClosed));
    assert_eq!(loft(&known[0], &known[0], 0.5, UP), Err(SpanError::Same));
    // The same curve from elsewhere: from its other end, or as the boundary of faces.
    let backwards = curves(&[(reversed(&line(0.0)), false)]);
    assert_eq!(loft(&known[0], &backwards[0], 0.5, UP), Err(SpanError::Same));
    let mut grid = crate::support::grid::grid(6, 4, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let rim: Vec<u32> = Topology::new(&grid).boundary_loops().row(0).to_vec();
    grid.curves.push(&[&rim[3..], &rim[..4]].concat());
    let both = SpanCurve::all(&grid);
    assert_eq!(loft(&both[0], &both[1], 0.5, UP), Err(SpanError::Same));
    assert_eq!(loft(&known[0], &known[1], 0.0, UP), Err(SpanError::Size(0.0)));
    assert!(matches!(loft(&known[0], &known[1], 1e-4, UP), Err(SpanError::TooManyFaces(_))));
    assert_eq!(fill(&known[0], 0.5, UP), Err(SpanError::Open));
    assert!(matches!(fill(&known[2], 1e-4, UP), Err(SpanError::TooManyFaces(_))));
    assert_eq!(SpanCurve::of(&known, 3), Err(SpanError::NoLength));
    assert_eq!(SpanCurve::of(&known, 9), Err(SpanError::Missing { asked: 9, found: 4 }));
    let one = SpanCurve::of(&known[..1], 1).unwrap_err().to_string();
    assert_eq!(one, "there is no curve 1: the file has 1 curve or boundary, counted from 0");
    // A star whose arms overlap in a Coons patch.
    let star: Vec<Point> = (0..16)
        .map(|k| {
            let radius = if k % 2 == 0 { 5.0 } else { 0.6 };
            let turn = f64::from(k) / 16.0;
            [radius * cosine(turn), radius * sine(turn), 0.0]
        })
        .collect();
    assert_eq!(fill(&curves(&[(star, true)])[0], 0.3, UP), Err(SpanError::Folded));
}

/// Points computed in two ways differ by rounding.
#[test]
fn ends_that_meet_but_for_rounding_do() {
    let mut round = circle(24, 2.0, 0.0, 0.0);
    round.push([2.0, -4.9e-16, 0.0]);
    assert!(curves(&[(round, false)])[0].is_closed());

    let [a, b] = [0.1 + 0.2, 0.3];
    let corners = [[[0.0; 3]; 2], [[a, 0.0, 0.0], [b, 0.0, 0.0]], [[b, b, 0.0], [a, a, 0.0]]];
    let sides = (0..3).map(|k| (vec![corners[k][1], corners[(k + 1) % 3][0]], false));
    assert!(curves(&sides.collect::<Vec<_>>())[3].is_closed());

    // A mark in the same file, shorter than their distance.
    let corners = [[0.0; 3], [10.0, 0.0, 0.0], [10.0, 10.0, 0.0]];
    let side = |k: usize| vec![corners[k], corners[(k + 1) % 3].map(|x| x + 1e-6)];
    let mark = vec![[5.0, 5.0, 0.0], [5.0, 5.0, 1e-3]];
    let lines: Vec<_> = [side(0), side(1), side(2), mark].map(|line| (line, false)).to_vec();
    assert!(curves(&lines)[4].is_closed());

    // A step that is lost in the length of its curve.
    let mut arc: Vec<Point> = circle(40, 10.0, 0.0, 0.0)[..11].to_vec();
    arc[10][0] = 6.1e-16;
    arc.push([0.0, 10.0, 0.0]);
    let other = circle(32, 12.0, 0.0, 0.0)[..9].to_vec();
    let known = curves(&[(arc, false), (other, false)]);
    let mesh = loft(&known[0], &known[1], 2.0, UP).expect("both are open");
    let has = |point: Point| {
        let near = |at: &Point| (Vec3::from(*at) - Vec3::from(point)).length() < 1e-12;
        mesh.positions.iter().any(near)
    };
    assert!(mesh.positions.iter().flatten().all(|x| x.is_finite()));
    assert!(has([0.0, 10.0, 0.0]) && has([10.0, 0.0, 0.0]));
}

/// Four edges drawn one by one, in any direction, as most programs write them, were no curve to fill.
#[test]
fn polylines_that_close_together_are_one_curve_more() {
    let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 3.0, 1.0], [0.0, 3.0, 0.0]];
    let side = |k: usize| vec![corners[k], corners[(k + 1) % 4]];
    let drawn = [side(2), reversed(&side(0)), side(1), reversed(&side(3))];
    let open = [vec![[9.0, 0.0, 0.0], [9.0, 1.0, 0.0]], vec![[9.0, 1.0, 0.0], [9.0, 2.0, 0.0]]];
    let polylines: Vec<_> = drawn.iter().chain(&open).map(|line| (line.clone(), false)).collect();
    let all = curves(&polylines);
    let closed: Vec<bool> = all.iter().map(SpanCurve::is_closed).collect();
    assert_eq!(closed, [false, false, false, false, false, false, true]);
    let labels = SpanCurve::labels(&all);
    assert_eq!(labels[6].label, "Joined curves 1");
    let sloped = 10.0f64.sqrt();
    assert!((labels[6].length - (4.0 + sloped + 17.0f64.sqrt() + 3.0)).abs() < 1e-12);
    let mesh = fill(&all[6], 1.0, UP).expect("it is closed");
    assert_sound(&mesh);
    for corner in corners {
        assert!(mesh.positions.contains(&corner), "{corner:?}");
    }

    // Where three lines meet, none goes on.
    let star = [side(0), side(1), side(2), side(3), vec![corners[0], [0.0, 0.0, 5.0]]];
    let star: Vec<_> = star.iter().map(|line| (line.clone(), false)).collect();
    assert!(!curves(&star).iter().any(SpanCurve::is_closed));
}
