//! The exact pass: the limit `mu -> 0` without a choice of `mu`, and whether it is worthwhile.

use super::newton::{Stage, add_faces, descend, energy};
use super::system::{System, identity_and_outer};
use crate::fabricate::surface::{PanelSurface, unit};
use crate::math::{Vec3, symmetric_eigen};
use crate::scene::OffsetKind;
use nalgebra::DMatrix;

/// The weight of a proximal step.
const PROXIMAL: f64 = 1e-6;
/// Number of proximal steps.
const PROXIMAL_STEPS: usize = 10;
/// If exact axes of beams exist, the energy without the term of `mu` falls with `mu^2`. If it does
/// not fall to this fraction when `mu` falls to a tenth, there are none.
const FALLS: f64 = 0.3;
/// Smallest `mu` for axes of beams.
const LEAST_MU: f64 = 1e-8;
/// Relative eigenvalue below which normals at a vertex are coplanar or equal up to rounding.
const ONE_PLANE: f64 = 1e-12;

/// The axes of the exact pass. Axes of beams start at the least-squares axes `fitted` of weight
/// `mu`.
pub(super) fn exact_pass(
    system: &mut System,
    surface: &PanelSurface,
    kind: OffsetKind,
    (mu, fitted): (f64, Vec<Vec3<f64>>),
) -> Vec<Vec3<f64>> {
    if kind == OffsetKind::Edge {
        return of_beams(system, surface, (mu, fitted));
    }
    let mut axes = surface.normals.clone();
    system.reset(PROXIMAL, &axes);
    for edge in surface.real_edges() {
        let t = surface.direction(edge);
        let [i, j] = edge.ends;
        let (own, across) = match kind {
            OffsetKind::Corner => ((1.0, 0.0), (-1.0, 2.0)),
            _ => ((1.0, -1.0), (-1.0, 1.0)),
        };
        system.add(i, identity_and_outer(own.0, own.1, t));
        system.add(j, identity_and_outer(own.0, own.1, t));
        system.couple(i, j, identity_and_outer(across.0, across.1, t));
    }
    let of_faces = (kind == OffsetKind::Face).then(|| add_faces(system, surface));
    if !system.factor() {
        return axes;
    }
    for _ in 0..PROXIMAL_STEPS {
        system.set_rhs(PROXIMAL, &axes);
        for &(v, pull) in of_faces.iter().flatten() {
            system.add_rhs(v, pull);
        }
        axes = system.solve();
        if kind == OffsetKind::Corner {
            axes.iter_mut().for_each(|axis| *axis = unit(*axis));
        }
    }
    axes
}

/// The axes of beams, with `mu` falling by tens.
fn of_beams(
    system: &mut System,
    surface: &PanelSurface,
    (mut mu, mut axes): (f64, Vec<Vec3<f64>>),
) -> Vec<Vec3<f64>> {
    let kind = OffsetKind::Edge;
    let mut left = energy(surface, kind, 0.0, &axes);
    while mu > 2.0 * LEAST_MU {
        mu *= 0.1;
        let stage = if mu <= 2.0 * LEAST_MU { Stage::Last } else { Stage::Intermediate };
        axes = descend(system, surface, kind, mu, axes, stage);
        let energy = energy(surface, kind, 0.0, &axes);
        if energy > FALLS * left {
            break;
        }
        left = energy;
    }
    axes
}

/// Returns false if no axes can have distance errors below `tolerance` at the distance `depth`.
/// Only panels are tested: at each vertex, how far the planes around it are from touching a common
/// cone.
pub(super) fn can_be_exact(
    surface: &PanelSurface,
    kind: OffsetKind,
    depth: f64,
    tolerance: f64,
) -> bool {
    if kind != OffsetKind::Face {
        return true;
    }
    let mut around: Vec<Vec<Vec3<f64>>> = vec![Vec::new(); surface.positions.len()];
    for (face, f) in surface.faces.iter().zip(0..) {
        let normal = surface.normal(f);
        // A panel without area has no plane.
        if normal != Vec3::zero() {
            face.iter().for_each(|&v| around[v as usize].push(normal));
        }
    }
    // The largest error is at least the root mean square.
    around.iter().all(|normals| {
        let most = tolerance * tolerance * normals.len() as f64;
        normals.len() <= 3 || depth * depth * cone_error(normals) <= most
    })
}

/// The minimum over `n` of the sum of `(N . n - 1)^2` over some unit normals `N`; infinite unless all
/// are finite.
fn cone_error(normals: &[Vec3<f64>]) -> f64 {
    let mut matrix = DMatrix::zeros(3, 3);
    let mut sum = Vec3::zero();
    for &normal in normals {
        let n = [normal.x, normal.y, normal.z];
        for r in 0..3 {
            (0..3).for_each(|c| matrix[(r, c)] += n[r] * n[c]);
        }
        sum += normal;
    }
    let Some((values, vectors)) = symmetric_eigen(&matrix) else { return f64::INFINITY };
    let mut axis = Vec3::zero();
    for (value, direction) in values.iter().zip(vectors.column_iter()) {
        if *value > ONE_PLANE * values[0] {
            let direction = Vec3::new(direction[0], direction[1], direction[2]);
            axis += direction * (direction.dot(sum) / value);
        }
    }
    normals.iter().map(|normal| normal.dot(axis) - 1.0).map(|error| error * error).sum()
}
