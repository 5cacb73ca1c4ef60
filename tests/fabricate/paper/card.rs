//! Card: plates with a thickness, folded at their hinges, have their outer faces on the panels of the mesh,
//! and keep apart.

use super::{model, scale, settings, waves};
use crate::fabricate::identities::revolution;
use crate::fabricate::{build, text_of};
use shape_up::fabricate::Build;
use shape_up::fabricate::panel::inset_sides;
use shape_up::fabricate::paper::PaperNet;
use shape_up::math::Vec3;
use shape_up::math::plane::{Point2, area};
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, Fold, Pieces};

type Point = Vec3<f64>;

const CARD: [Fold; 3] = [Fold::Score, Fold::VCut, Fold::Separate];
const THICKNESS: f64 = 1.0;
const THICKNESSES: [f64; 4] = [0.5, 1.0, 1.5, 2.0];

/// A frustum of a pyramid: three panels at every corner, folds of more and of less than a right angle.
fn frustum() -> Mesh {
    let corner = |k: u32| {
        let side = if k < 4 { 1.0 } else { 0.6 };
        let [x, y] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]][(k % 4) as usize];
        [side * x, side * y, if k < 4 { 0.0 } else { 1.0 }]
    };
    let faces =
        [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    let (positions, faces) = ((0..8).map(corner).collect(), faces.into_iter().collect());
    Mesh { positions, faces, ..Mesh::default() }
}

fn made(mesh: &Mesh, fold: Fold, thickness: f64) -> Build {
    build(mesh, &BuildSettings { scale: scale(mesh), fold, thickness, ..settings(Pieces::Nets) })
}

/// The plane of a piece in space: its origin, its axes, and its normal outwards.
#[derive(Clone, Copy)]
struct Frame {
    origin: Point,
    axes: [Point; 3],
}

impl Frame {
    fn at(&self, [u, v]: Point2, height: f64) -> Point {
        let [x, y, z] = self.axes;
        self.origin + x * u + y * v + z * height
    }

    /// Turned by an angle about a line.
    fn turned(&self, at: Point, along: Point, angle: f64) -> Frame {
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        let turn =
            |v: Point| v * cosine + along.cross(v) * sine + along * (along.dot(v) * (1.0 - cosine));
        Frame { origin: at + turn(self.origin - at), axes: self.axes.map(turn) }
    }
}

fn unit(v: Point) -> Point {
    v * (1.0 / v.length())
}

/// A side of a facet on its mesh, in mm of the sheet: its start, and the directions along it, into the
/// facet, and outwards.
fn on_mesh(made: &Build, net: &PaperNet, (f, k): (u32, u32)) -> [Point; 4] {
    let vertices = &net.facets[f as usize].vertices;
    let n = vertices.len();
    let at = |k: usize| made.surface.positions[vertices[k % n] as usize] * made.mm_of_sheet();
    let normal = unit((at(1) - at(0)).cross(at(2) - at(0)));
    let along = unit(at(k as usize + 1) - at(k as usize));
    [at(k as usize), along, normal.cross(along), normal]
}

/// How far before its edge a side ends at the inner faces.
fn expected_back(net: &PaperNet, (f, k): (u32, u32), thickness: f64) -> f64 {
    let joint = net.facets[f as usize].joints[k as usize];
    let fold = joint.map_or(0.0, |joint| net.joints[joint as usize].fold);
    thickness * libm::tan(0.5 * fold.max(0.0))
}

/// The frames of all facets: the first one of each piece is put on the mesh, and the others are folded.
fn folded(made: &Build, fold: Fold) -> Vec<Frame> {
    let (net, thickness) = (&model(made).net, made.settings.thickness);
    let mut frames: Vec<Option<Frame>> = vec![None; net.facets.len()];
    for piece in &model(made).pieces {
        let first = net.pieces[*piece as usize][0];
        let [at, along, inwards, normal] = on_mesh(made, net, (first, 0));
        let [p, q] = net.hinge((first, 0));
        let step = [q[0] - p[0], q[1] - p[1]];
        let [c, s] = step.map(|x| x / (step[0] * step[0] + step[1] * step[1]).sqrt());
        let (x, y) = (along * c - inwards * s, along * s + inwards * c);
        let back = if fold == Fold::VCut { 0.0 } else { expected_back(net, (first, 0), thickness) };
        let origin = at + inwards * back - x * p[0] - y * p[1];
        frames[first as usize] = Some(Frame { origin, axes: [x, y, normal] });
        let mut queue = vec![first];
        while let Some(f) = queue.pop() {
            let frame = frames[f as usize].unwrap();
            for k in 0..net.facets[f as usize].corners.len() as u32 {
                let Some((joint, (g, _))) = net.across((f, k)) else { continue };
                if !net.folded[joint as usize] || frames[g as usize].is_some() {
                    continue;
                }
                let angle = net.joints[joint as usize].fold;
                let is_inner = fold == Fold::Score && angle > 0.0;
                let height = if is_inner { -thickness } else { 0.0 };
                let [a, b] = net.hinge((f, k)).map(|end| frame.at(end, height));
                frames[g as usize] = Some(frame.turned(a, unit(b - a), angle));
                queue.push(g);
            }
        }
    }
    frames.into_iter().map(Option::unwrap).collect()
}

/// A convex plate: its outer and its inner corners.
struct Plate([Vec<Point>; 2]);

impl Plate {
    fn new(net: &PaperNet, f: u32, frame: &Frame, (fold, thickness): (Fold, f64)) -> Plate {
        let outer = net.corners(f);
        let sides = 0..outer.len() as u32;
        let backs: Vec<f64> = sides.map(|k| expected_back(net, (f, k), thickness)).collect();
        let inner = match fold {
            Fold::VCut => inset_sides(&outer, &backs).unwrap(),
            _ => outer.clone(),
        };
        let put = |own: &[Point2], height| own.iter().map(|&p| frame.at(p, height)).collect();
        Plate([put(&outer, 0.0), put(&inner, -thickness)])
    }

    /// The directions of its edges, and the normals of its faces.
    fn edges_and_normals(&self) -> [Vec<Point>; 2] {
        let Plate([outer, inner]) = self;
        let n = outer.len();
        let around = (0..n).map(|k| outer[(k + 1) % n] - outer[k]);
        let across = (0..n).map(|k| inner[k] - outer[k]);
        let sides = around.clone().zip(across.clone()).map(|(u, v)| u.cross(v));
        let top = (outer[1] - outer[0]).cross(outer[2] - outer[0]);
        [around.chain(across).collect(), sides.chain([top]).collect()]
    }

    /// How far two plates overlap: the least distance by which one is to be moved until they do not.
    fn overlap(&self, other: &Plate) -> f64 {
        let ([edges, normals], [others, more]) =
            (self.edges_and_normals(), other.edges_and_normals());
        let crossed =
            edges.iter().flat_map(|&u| others.iter().map(move |&v| unit(u).cross(unit(v))));
        let axes = normals.into_iter().chain(more).map(unit).chain(crossed);
        let along = |plate: &Plate, axis: Point| {
            let values = plate.0.iter().flatten().map(|p| p.dot(axis));
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
                [low.min(x), high.max(x)]
            })
        };
        let depth = |axis: Point| {
            let ([a, b], [c, d]) = (along(self, axis), along(other, axis));
            (b - c).min(d - a)
        };
        axes.filter(|axis| axis.length() > 1e-3)
            .map(|axis| depth(unit(axis)))
            .fold(f64::INFINITY, f64::min)
    }
}

#[test]
fn plates_that_are_folded_at_their_hinges_have_their_outer_faces_on_the_mesh_and_keep_apart() {
    // Where planes that are moved inwards meet in one point at each vertex, and where they do not.
    for (mesh, is_conical) in [(frustum(), true), (revolution(9, 7), true), (waves(), false)] {
        for (fold, thickness) in CARD.iter().flat_map(|&fold| THICKNESSES.map(|own| (fold, own))) {
            let made = made(&mesh, fold, thickness);
            let net = &model(&made).net;
            let frames = folded(&made, fold);
            let mut cut_back = 0;
            for (f, frame) in (0..).zip(&frames) {
                for k in 0..net.facets[f as usize].corners.len() as u32 {
                    let [at, _, inwards, normal] = on_mesh(&made, net, (f, k));
                    let back = expected_back(net, (f, k), thickness);
                    let expected = if fold == Fold::VCut { 0.0 } else { back };
                    cut_back += usize::from(back > 0.01);
                    for end in net.ends((f, k)) {
                        let away = frame.at(end, 0.0) - at;
                        assert!(away.dot(normal).abs() < 1e-6, "{fold:?} {}", away.dot(normal));
                        let error = away.dot(inwards) - expected;
                        assert!(error.abs() < 1e-6, "{fold:?} {f} {k}: {error}");
                    }
                }
            }
            assert!(cut_back > 0);
            let plates: Vec<Plate> = (0..)
                .zip(&frames)
                .map(|(f, frame)| Plate::new(net, f, frame, (fold, thickness)))
                .collect();
            let mut worst = [0.0_f64; 2];
            for (i, one) in plates.iter().enumerate() {
                for (j, other) in plates[..i].iter().enumerate() {
                    let mut joints = net.facets[i].joints.iter().flatten();
                    let is_beside = joints.any(|joint| {
                        net.joints[*joint as usize].sides.iter().any(|(f, _)| *f as usize == j)
                    });
                    let kind = usize::from(!is_beside);
                    worst[kind] = worst[kind].max(one.overlap(other));
                }
            }
            println!("{fold:?} {thickness}: overlap {worst:?} mm");
            assert!(worst[0] < 1e-6, "{fold:?} {thickness}: {worst:?}");
            let most = if is_conical { 1e-6 } else { thickness };
            assert!(worst[1] < most, "{fold:?} {thickness}: {worst:?}");
        }
    }
}

#[test]
fn card_hangs_together_where_it_hinges() {
    let pieces = |fold| made(&frustum(), fold, THICKNESS).parts.len();
    assert_eq!([Fold::Crease, Fold::Score, Fold::VCut, Fold::Separate].map(pieces), [1, 1, 1, 6]);
    let pieces = |fold| made(&in_line(), fold, THICKNESS).parts.len();
    assert_eq!([Fold::Crease, Fold::Score, Fold::VCut, Fold::Separate].map(pieces), [1, 2, 1, 3]);
}

/// A panel with two neighbours in line, of which one is steeper: it ends before both alike, and the other
/// one has no hinge.
fn in_line() -> Mesh {
    let positions = vec![
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [2.0, 1.0, 0.0],
        [2.0, 2.0, 0.0],
        [0.0, 2.0, 0.0],
        [3.0, 0.0, -0.5],
        [3.0, 1.0, -0.5],
        [3.0, 1.0, -2.0],
        [3.0, 2.0, -2.0],
    ];
    let mut mesh = Mesh { positions, ..Mesh::default() };
    [&[0, 1, 2, 3, 4][..], &[1, 5, 6, 2], &[2, 7, 8, 3]]
        .iter()
        .for_each(|face| mesh.faces.push(face));
    mesh
}

#[test]
fn card_that_ends_farther_than_its_fold_asks_is_written_and_told() {
    for fold in CARD {
        let made = made(&in_line(), fold, THICKNESS);
        let report = made.report();
        let warnings = made.words(&report).warnings;
        let told =
            warnings.iter().any(|words| words.ends_with("in line with a steeper one: P0 at P1."));
        assert_eq!(told, fold != Fold::VCut, "{fold:?}: {warnings:?}");
        let text = text_of(&made, "joins.csv");
        let net = &model(&made).net;
        for (joint, row) in net.joints.iter().zip(text.lines().skip(1)) {
            let cells: Vec<f64> =
                row.rsplitn(4, ',').take(3).map(|cell| cell.parse().unwrap()).collect();
            let [b, a, asked] = cells[..] else { panic!("{row}") };
            assert!(
                (asked - expected_back(net, joint.sides[0], THICKNESS)).abs() < 1e-3,
                "{fold:?}: {row}"
            );
            let is_further = fold != Fold::VCut && joint.sides[1].0 == 1;
            assert_eq!([a > asked + 0.1, b > asked + 0.1], [is_further, false], "{fold:?}: {row}");
            // The first panel is a square, of which one side is cut back.
            let side = 2.0 * made.mm_of_sheet();
            let cut = if fold == Fold::VCut { 0.0 } else { a };
            assert!((area(&net.corners(0)) - side * (side - cut)).abs() < 1e-3 * side, "{row}");
        }
    }
}

#[test]
fn panels_that_are_not_flat_are_said_to_be_creased_or_cut_apart_as_they_are() {
    for (fold, word) in [(Fold::Score, "creased"), (Fold::Separate, "cut apart")] {
        let made = made(&waves(), fold, THICKNESS);
        let warnings = made.words(&made.report()).warnings;
        let expected = format!("30 panels are not flat and {word} along a diagonal.");
        assert!(warnings.contains(&expected), "{warnings:?}");
    }
}

#[test]
fn card_that_is_too_thick_for_its_folds_is_told() {
    for fold in [Fold::Crease, Fold::Score, Fold::VCut, Fold::Separate] {
        for (thickness, is_too_thick) in [(THICKNESS, false), (40.0, fold != Fold::Crease)] {
            let made = made(&frustum(), fold, thickness);
            let report = made.report();
            let warnings = made.words(&report).warnings;
            let told = warnings.iter().any(|words| words.starts_with("Card of 40 mm is too thick"));
            assert_eq!(told, is_too_thick, "{fold:?}: {warnings:?}");
            assert_eq!(report.paper.unwrap().too_thick.is_empty(), !is_too_thick);
        }
    }
}
