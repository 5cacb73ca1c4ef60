//! A press finds the same shape where the input differs in nothing that matters: in noise, the order
//! of vertices and faces, position, orientation and unit. Near a limit rounding used to decide.

use super::search::{opened, press, saddle, sheared};
use crate::support::long_or;
use crate::support::random::Random;
use crate::support::shared;
use shape_up::math::Vec3;
use shape_up::mesh::{Mesh, Point, Topology};
use shape_up::session::{Level, Verdict};

/// Noise relative to the mean edge.
const NOISE: f64 = 1e-6;

/// Shapes are the same up to this fraction of the mean edge.
const SAME: f64 = 1e-3;

/// A mesh that differs in nothing that matters.
struct Other {
    what: &'static str,
    mesh: Mesh,
    /// The vertex of the mesh that each vertex of the original became.
    vertex: Vec<u32>,
    /// The place of a point of it in the original.
    back: Box<dyn Fn(Point) -> Point>,
}

fn others(mesh: &Mesh) -> Vec<Other> {
    let n = mesh.positions.len() as u32;
    let edge = Topology::new(mesh).mean_edge(&mesh.positions);
    let mut random = Random::new(40);
    let moved = |by: &dyn Fn(Point) -> Point| Mesh {
        positions: mesh.positions.iter().map(|&p| by(p)).collect(),
        ..mesh.clone()
    };
    let with_faces =
        |faces: Vec<Vec<u32>>| Mesh { faces: faces.into_iter().collect(), ..mesh.clone() };
    let faces: Vec<Vec<u32>> = mesh.faces.iter().map(<[u32]>::to_vec).collect();
    let mut noisy = mesh.clone();
    for x in noisy.positions.as_flattened_mut() {
        *x += NOISE * edge * random.uniform();
    }
    // The vertices from last to first.
    let reversed = Mesh {
        positions: mesh.positions.iter().rev().copied().collect(),
        ..with_faces(faces.iter().map(|f| f.iter().map(|v| n - 1 - v).collect()).collect())
    };
    let rolled = |face: &Vec<u32>| [&face[1..], &face[..1]].concat();
    let flipped = |face: &Vec<u32>| face.iter().rev().copied().collect();
    let [c, s] = [0.8, 0.6];
    let same: Vec<u32> = (0..n).collect();
    let other = |what, mesh, back: Box<dyn Fn(Point) -> Point>| Other {
        what,
        mesh,
        vertex: same.clone(),
        back,
    };
    vec![
        other("noise", noisy, Box::new(|p| p)),
        Other { vertex: (0..n).rev().collect(), ..other("vertices", reversed, Box::new(|p| p)) },
        other("faces", with_faces(faces.iter().rev().cloned().collect()), Box::new(|p| p)),
        other("starts", with_faces(faces.iter().map(rolled).collect()), Box::new(|p| p)),
        other("flips", with_faces(faces.iter().map(flipped).collect()), Box::new(|p| p)),
        other("mirror", moved(&|[x, y, z]| [-x, y, z]), Box::new(|[x, y, z]| [-x, y, z])),
        other(
            "turned",
            moved(&|[x, y, z]| [c * x - s * y, s * x + c * y, z]),
            Box::new(move |[x, y, z]| [c * x + s * y, c * y - s * x, z]),
        ),
        other(
            "far",
            moved(&|[x, y, z]| [x + 1e6, y - 1e6, z]),
            Box::new(|[x, y, z]| [x - 1e6, y + 1e6, z]),
        ),
        other("large", moved(&|p| p.map(|x| 1000.0 * x)), Box::new(|p| p.map(|x| x / 1000.0))),
    ]
}

fn solved(mesh: Mesh, kind: &str) -> (Verdict, Vec<Point>) {
    let mut session = opened(mesh);
    let verdict = press(&mut session, kind);
    (verdict, session.positions())
}

/// Returns what differs between a press on the mesh and on the others.
fn differences(name: &str, mesh: &Mesh, kind: &str) -> Vec<String> {
    let edge = Topology::new(mesh).mean_edge(&mesh.positions);
    let (first, shape) = solved(mesh.clone(), kind);
    let mut different = Vec::new();
    for Other { what, mesh, vertex, back } in others(mesh) {
        let (verdict, positions) = solved(mesh, kind);
        let far = shape
            .iter()
            .zip(&vertex)
            .map(|(&p, &v)| (Vec3::from(p) - Vec3::from(back(positions[v as usize]))).length());
        let far = far.fold(0.0, f64::max) / edge;
        let is_good = first.attempts.first().is_some_and(|tried| tried.level == Level::Good);
        if (&verdict.chosen, verdict.level) != (&first.chosen, first.level) {
            different.push(format!(
                "{name} {kind} {what}: {} {:?} instead of {} {:?}",
                verdict.chosen, verdict.level, first.chosen, first.level
            ));
        } else if is_good && far > SAME {
            different.push(format!("{name} {kind} {what}: {far} edges away"));
        }
    }
    different
}

#[test]
fn noise_order_and_position_do_not_change_what_is_chosen() {
    let mut different = differences("sheared", &sheared(8, saddle, 0.4, 0.3), "circle");
    // On these, one to five of the nine used to end otherwise.
    for (name, kind) in [
        ("compas_hypar.obj", "circle"),
        ("compas_hypar.obj", "plane"),
        ("chebyshev_sphere.obj", "plane"),
    ] {
        let Some(mesh) = shared::mesh(name) else { continue };
        different.extend(differences(name, &mesh, kind));
    }
    assert!(different.is_empty(), "{different:#?}");
}

/// Only with `LONG` set: small meshes take seconds each, the largest minutes.
#[test]
fn noise_order_and_position_change_nothing_on_real_meshes() {
    if long_or(false, true) {
        return;
    }
    let mut different = Vec::new();
    let mut count = 0;
    for folder in ["meshes", "cases"] {
        for (name, mesh) in shared::meshes_in(folder) {
            if mesh.faces.iter().all(|face| face.len() < 4) || mesh.positions.len() > 1000 {
                continue;
            }
            for kind in ["circle", "plane"] {
                different.extend(differences(&name, &mesh, kind));
                count += 9;
            }
        }
    }
    assert!(different.is_empty(), "{} of {count}: {different:#?}", different.len());
}
