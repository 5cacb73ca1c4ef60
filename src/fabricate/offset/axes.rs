//! Node axes: the exact ones where there are any, else those of the least-squares fit.
//!
//! With `P_e x = x - (x . t_e) t_e`, what is minimised is
//!
//! ```text
//! E(n) = sum_e |P_e (n_j - n_i)|^2 + D(n) + mu sum_i |n_i - N_i|^2
//! corner  D = sum_i (|n_i| - 1)^2
//! face    D = sum over corners (i, f) of (N_f . n_i - 1)^2
//! edge    D = sum over edges, both ends, of (|P_e n_i| - 1)^2
//! ```
//!
//! by Newton steps from `n = N`. With `u` the direction of `x` in the last step, `(|x| - 1)^2` has the Hessian
//! `u u' + c (I - u u')`, `c = 1 - 1 / |x|`; the second part takes `x` itself to zero, so that it changes the
//! matrix of Gauss-Newton, where `|x| - 1` is `u . x - 1`, and not its right-hand side. Where `c < 0` makes the
//! matrix indefinite, it is left out: Gauss-Newton takes some steps more. All terms are without unit; `mu` trades
//! flat beams for upright axes.
//!
//! The exact pass is `mu -> 0` without a choice of `mu`: proximal steps, ten times with one factor (corner and
//! face). For corners it minimises `sum_e |n_j - R_e n_i|^2` with the reflections `R_e = I - 2 t_e t_e'`
//! among unit vectors: its matrix is a connection Laplacian, and where circles close all around its zero modes
//! are the exact axes. Carrying an axis from vertex to vertex by `R_e` instead would twist the last beams by
//! degrees on a mesh whose circles are off by a thousandth.

use super::kind::OffsetKind;
use super::system::{System, across_edge, identity_and_outer, outer};
use crate::fabricate::surface::{PanelSurface, unit};
use crate::math::Vec3;

/// The weight of a proximal step.
const PROXIMAL: f64 = 1e-6;
/// Proximal steps of an exact pass.
const PROXIMAL_STEPS: usize = 10;
/// Steps at most; corners take about 5, edges 10, and several times as many without second derivatives.
const MOST_STEPS: usize = 300;
/// On a shape with exact axes of beams the energy without `mu` falls with `mu^2`. Where it does not fall to this
/// part of it for a tenth of `mu`, there are none.
const FALLS: f64 = 0.3;
/// The fit has ended when no axis moves by more in a step: with second derivatives, which double the digits, and
/// without.
const STILL: [f64; 2] = [1e-7, 1e-12];
/// An exact axis leans at most so many degrees more than the most leaning of the fit.
const MOST_LEAN: f64 = 30.0;

/// The axes of an offset.
#[derive(Clone, Debug)]
pub struct Axes {
    /// `#V` node axes; zero at vertices of no panel.
    pub axes: Vec<Vec3<f64>>,
    /// The elements that keep their distance.
    pub kind: OffsetKind,
    /// Whether they come from the exact pass.
    pub exact: bool,
}

/// The exact axes where beam warp and distance error at the distance `depth` stay below `tolerance` and
/// no axis leans much more than the fit's; else the fit.
pub fn node_axes(
    surface: &PanelSurface,
    kind: OffsetKind,
    mu: f64,
    depth: f64,
    tolerance: f64,
) -> Axes {
    let system = &mut System::new(surface);
    let fitted = descend(system, surface, kind, mu, surface.normals.clone());
    let exact = exact_by(system, surface, kind);
    let errors = |axes: &[Vec3<f64>]| super::check(surface, axes, kind, depth);
    let (of_fit, of_exact) = (errors(&fitted), errors(&exact));
    let is_met = of_exact.warp <= tolerance
        && of_exact.distance_error <= tolerance
        && of_exact.lean_deg <= of_fit.lean_deg + MOST_LEAN;
    Axes { axes: if is_met { exact } else { fitted }, kind, exact: is_met }
}

/// The least-squares axes with the weight `mu` of following the surface.
pub fn fit(surface: &PanelSurface, kind: OffsetKind, mu: f64) -> Vec<Vec3<f64>> {
    let mut system = System::new(surface);
    descend(&mut system, surface, kind, mu, surface.normals.clone())
}

/// The axes of the exact pass: what it leaves on a mesh without exact axes is of no use.
pub fn exact(surface: &PanelSurface, kind: OffsetKind) -> Vec<Vec3<f64>> {
    exact_by(&mut System::new(surface), surface, kind)
}

fn exact_by(system: &mut System, surface: &PanelSurface, kind: OffsetKind) -> Vec<Vec3<f64>> {
    let mut axes = surface.normals.clone();
    if kind == OffsetKind::Edge {
        let (mut mu, mut left) = (1.0, f64::INFINITY);
        for _ in 0..9 {
            axes = descend(system, surface, kind, mu, axes);
            let energy = energy(surface, kind, 0.0, &axes);
            if energy > FALLS * left {
                break;
            }
            (mu, left) = (0.1 * mu, energy);
        }
        return axes;
    }
    system.begin(PROXIMAL, &axes);
    for edge in &surface.edges {
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
        system.aim(PROXIMAL, &axes);
        for &(v, pull) in of_faces.iter().flatten() {
            system.pull(v, pull);
        }
        axes = system.solve();
        if kind == OffsetKind::Corner {
            axes.iter_mut().for_each(|axis| *axis = unit(*axis));
        }
    }
    axes
}

/// Adds `D` of faces, and gives what it adds to the right-hand side.
fn add_faces(system: &mut System, surface: &PanelSurface) -> Vec<(u32, Vec3<f64>)> {
    let mut pulls = Vec::new();
    for (face, f) in surface.faces.iter().zip(0..) {
        let normal = surface.normal(f);
        for &v in face {
            system.add(v, outer(normal));
            pulls.push((v, normal));
        }
    }
    pulls
}

/// Newton's method from `axes`; a step that would raise the energy is halved.
fn descend(
    system: &mut System,
    surface: &PanelSurface,
    kind: OffsetKind,
    mu: f64,
    mut axes: Vec<Vec3<f64>>,
) -> Vec<Vec3<f64>> {
    let mut lowest = energy(surface, kind, mu, &axes);
    for _ in 0..MOST_STEPS {
        let factored = [true, false].into_iter().find(|&curved| {
            assemble(system, surface, kind, mu, &axes, curved);
            system.factor()
        });
        let Some(curved) = factored else { break };
        let aim = system.solve();
        let mut share = 1.0;
        let (next, value) = loop {
            let towards = |(from, to): (&Vec3<f64>, &Vec3<f64>)| *from + (*to - *from) * share;
            let next: Vec<_> = axes.iter().zip(&aim).map(towards).collect();
            let value = energy(surface, kind, mu, &next);
            if value <= lowest * (1.0 + 1e-14) || share < 1e-4 {
                break (next, value);
            }
            share *= 0.5;
        };
        if value > lowest * (1.0 + 1e-14) || value.is_nan() {
            break;
        }
        let step = axes.iter().zip(&next).map(|(from, to)| (*to - *from).length());
        let step = step.fold(0.0, f64::max);
        (axes, lowest) = (next, value.min(lowest));
        let still = if curved && share == 1.0 { STILL[0] } else { STILL[1] };
        if step <= still || kind == OffsetKind::Face {
            break;
        }
    }
    axes
}

/// The system of one step; not `curved`, that of Gauss-Newton.
fn assemble(
    system: &mut System,
    surface: &PanelSurface,
    kind: OffsetKind,
    mu: f64,
    axes: &[Vec3<f64>],
    curved: bool,
) {
    // `c` of a vector of this length.
    let across_axis = |length: f64| if curved && length > 0.0 { 1.0 - 1.0 / length } else { 0.0 };
    system.begin(mu, &surface.normals);
    for edge in &surface.edges {
        let t = surface.direction(edge);
        let [i, j] = edge.ends;
        let across = identity_and_outer(1.0, -1.0, t);
        system.add(i, across);
        system.add(j, across);
        system.couple(i, j, identity_and_outer(-1.0, 1.0, t));
        if kind == OffsetKind::Edge {
            for v in edge.ends {
                let p = across_edge(axes[v as usize], t);
                let (u, c) = (unit(p), across_axis(p.length()));
                system.add(v, identity_and_outer(c, 1.0 - c, u));
                system.add(v, identity_and_outer(0.0, -c, t));
                system.pull(v, u);
            }
        }
    }
    match kind {
        OffsetKind::Corner => {
            for v in 0..axes.len() {
                if !system.is_excluded(v) {
                    let (u, c) = (unit(axes[v]), across_axis(axes[v].length()));
                    system.add(v as u32, identity_and_outer(c, 1.0 - c, u));
                    system.pull(v as u32, u);
                }
            }
        }
        OffsetKind::Face => {
            for (v, pull) in add_faces(system, surface) {
                system.pull(v, pull);
            }
        }
        OffsetKind::Edge => {}
    }
}

/// `E(n)`.
fn energy(surface: &PanelSurface, kind: OffsetKind, mu: f64, axes: &[Vec3<f64>]) -> f64 {
    let mut sum = 0.0;
    let square = |x: f64| x * x;
    for edge in &surface.edges {
        let t = surface.direction(edge);
        let [n, m] = edge.ends.map(|v| axes[v as usize]);
        sum += across_edge(m - n, t).length_squared();
        if kind == OffsetKind::Edge {
            sum += square(across_edge(n, t).length() - 1.0);
            sum += square(across_edge(m, t).length() - 1.0);
        }
    }
    for (axis, normal) in axes.iter().zip(&surface.normals) {
        sum += mu * (*axis - *normal).length_squared();
        if kind == OffsetKind::Corner && *normal != Vec3::zero() {
            sum += square(axis.length() - 1.0);
        }
    }
    if kind == OffsetKind::Face {
        for (face, f) in surface.faces.iter().zip(0..) {
            let normal = surface.normal(f);
            sum += face.iter().map(|&v| square(normal.dot(axes[v as usize]) - 1.0)).sum::<f64>();
        }
    }
    sum
}
