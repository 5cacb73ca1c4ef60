//! Conical vertex: an interior vertex of a conical mesh, whose faces have offsets at one distance
//! (Liu, Pottmann, Wallner, Yang and Wang 2006; the condition on angles is from Wang, Wallner and Liu,
//! "An angle criterion for conical mesh vertices", Journal for Geometry and Graphics 11 (2007)).
//!
//! For the angles `a_k` between consecutive edges the condition is `D = a_1 - a_2 + a_3 - a_4 = 0`.
//! With unit vectors `u_k` along the edges, `|u_k + u_(k+1)|` and `|u_k - u_(k+1)|` are twice the
//! cosine and the sine of half the angle, and products of such complex numbers give the cosine and
//! sine of `D / 2`. This works whether or not the angles around the vertex add up to a full turn.

use crate::constraint::{Arity, Element, Info, Projection};
use crate::math::{Lane, Vec3, largest_coordinate};
use serde::{Deserialize, Serialize};

/// A vertex and its four neighbours in order: the first and third angle between its edges have the
/// same sum as the second and fourth. If the four faces are flat, they touch a common cone.
///
/// Not exact: for vertices off by 1 %, 10 % or 30 % of the length of an edge the squared distance
/// is on average 2e-13, 3e-4 or 4e-7 greater than the least possible, and at most 3e-12, 8e-3 or
/// 1e-5 (25 vertices each). The condition holds if a neighbour coincides with the vertex.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Conical {}

impl Projection for Conical {
    const INFO: Info = Info {
        id: "conical",
        label: "Conical vertex",
        summary: "Both pairs of opposite angles at the vertex have the same sum, so that thick panels meet in one axis.",
        arity: Arity::Exactly(5),
        elements: &[Element::Star],
        exact: false,
        colour: [205, 85, 60],
        ..Info::PLAIN
    };

    const GUARDED: bool = true;

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let v: &[Vec3<S>; 5] = v.try_into().expect("it takes five points");
        let mut x = *v;
        let mut steps = 0..NEAR + ONTO;
        let angles = loop {
            let angles = Angles::of(&x);
            match steps.next() {
                Some(step) => x = angles.nearest(if step < NEAR { v } else { &x }, &x),
                None => break angles,
            }
        };
        projected.copy_from_slice(&x);
        let moved = (0..5).fold(S::zero(), |sum, k| sum + (x[k] - v[k]).length_squared());
        let [a, b, c, d] = angles.lengths;
        let (shortest, longest) = (a.min(b).min(c.min(d)), a.max(b).max(c.max(d)));
        let one = |yes: S, bound: S| yes.if_greater(bound, S::one(), S::zero());
        let accurate = one(S::splat(ROUNDING), angles.sine.abs())
            * one(angles.cosine, S::splat(0.1))
            * one(shortest * shortest * S::splat(MILD), moved)
            * one(shortest, S::splat(1e-40))
            * one(S::splat(1e40), longest);
        accurate.all_greater(S::zero())
    }

    /// Takes the nearest result of damped steps, or of merging the vertex with a neighbour.
    fn project_robust(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let unit = largest_coordinate(v);
        if unit == 0.0 {
            return;
        }
        let scaled: [Vec3<f64>; 5] =
            std::array::from_fn(|k| Vec3::new(v[k].x / unit, v[k].y / unit, v[k].z / unit));
        let distance =
            |x: &[Vec3<f64>; 5]| (0..5).map(|k| (x[k] - scaled[k]).length_squared()).sum::<f64>();
        let found = candidates(&scaled)
            .into_iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .expect("vertices that meet have the shape");
        v.iter_mut().zip(found).for_each(|(v, p)| *v = p * unit);
    }
}

/// Numbers of steps towards the closest points, then onto the shape.
const NEAR: usize = 10;
const ONTO: usize = 4;

/// Tolerance for the sine of `D / 2`, for edges much shorter than the coordinates.
const ROUNDING: f64 = 1e-12;

/// Greatest squared correction of the closed form, relative to the squared shortest edge.
const MILD: f64 = 0.25;

/// The angles around the vertex.
struct Angles<S> {
    /// The lengths of the edges.
    lengths: [S; 4],
    /// Cosine and sine of `D / 2`.
    cosine: S,
    sine: S,
    /// The gradient of `D` with respect to the five points.
    gradient: [Vec3<S>; 5],
}

impl<S: Lane> Angles<S> {
    #[inline(always)]
    fn of(x: &[Vec3<S>; 5]) -> Self {
        let edges: [Vec3<S>; 4] = std::array::from_fn(|k| x[k + 1] - x[0]);
        let lengths = edges.map(|e| e.length());
        let u: [Vec3<S>; 4] = std::array::from_fn(|k| edges[k] * (S::one() / lengths[k]));
        let half = S::splat(0.5);
        let mut gradient = [Vec3::zero(); 5];
        let (mut cosine, mut sine) = (S::one(), S::zero());
        for k in 0..4 {
            let next = (k + 1) % 4;
            let sign = if k % 2 == 0 { S::one() } else { -S::one() };
            let (plus, minus) = (u[k] + u[next], u[k] - u[next]);
            let (c, s) = (plus.length() * half, minus.length() * half * sign);
            (cosine, sine) = (cosine * c - sine * s, sine * c + cosine * s);
            // Each end of an angle moves away from the other edge when the angle grows.
            let opposite = u[k].dot(u[next]);
            // Divided by the sine of the angle, 2 sin(a/2) cos(a/2).
            let turn = -(sign + sign) / (plus.length() * minus.length());
            let (away, back) = (u[next] - u[k] * opposite, u[k] - u[next] * opposite);
            gradient[k + 1] += away * (turn / lengths[k]);
            gradient[next + 1] += back * (turn / lengths[next]);
        }
        gradient[0] = -(gradient[1] + gradient[2] + gradient[3] + gradient[4]);
        Angles { lengths, cosine, sine, gradient }
    }

    /// Returns the points closest to `v` that satisfy `D = 0`, linearised at `x` with these angles.
    #[inline(always)]
    fn nearest(&self, v: &[Vec3<S>; 5], x: &[Vec3<S>; 5]) -> [Vec3<S>; 5] {
        let (mut square, mut slope) = (S::zero(), S::zero());
        for k in 0..5 {
            square += self.gradient[k].length_squared();
            slope += self.gradient[k].dot(v[k] - x[k]);
        }
        let step = (self.sine / self.cosine * S::splat(2.0) + slope) / square;
        // If the gradient is zero, the points have the shape, or none is nearer than others.
        let step = square.if_greater(S::zero(), step, S::zero());
        std::array::from_fn(|k| v[k] - self.gradient[k] * step)
    }
}

/// One step of the robust projection from `x` towards `v`.
#[inline(never)]
fn step(v: &[Vec3<f64>; 5], x: &[Vec3<f64>; 5]) -> [Vec3<f64>; 5] {
    Angles::of(x).nearest(v, x)
}

/// Returns candidates for the closest points to `v` that have the shape; at least one has it.
fn candidates(v: &[Vec3<f64>; 5]) -> Vec<[Vec3<f64>; 5]> {
    let has_shape = |x: &[Vec3<f64>; 5]| {
        let angles = Angles::of(x);
        angles.lengths.contains(&0.0) || (angles.sine.abs() <= ROUNDING && angles.cosine > 0.0)
    };
    if has_shape(v) {
        return vec![*v];
    }
    let mut found = Vec::new();
    for step_size in [1.0, 0.3, 0.1] {
        let mut x = *v;
        for _ in 0..ROBUST_STEPS {
            let next = step(v, &x);
            x = std::array::from_fn(|k| x[k] + (next[k] - x[k]) * step_size);
        }
        for _ in 0..ROBUST_STEPS {
            x = step(&x, &x);
        }
        found.push(x);
        // Directly onto the shape.
        let mut x = *v;
        for k in 0..ROBUST_STEPS {
            let next = step(&x, &x);
            let step_size = if 2 * k < ROBUST_STEPS { step_size } else { 1.0 };
            x = std::array::from_fn(|k| x[k] + (next[k] - x[k]) * step_size);
        }
        found.push(x);
    }
    for k in 1..5 {
        let mut x = *v;
        x[0] = (v[0] + v[k]) * 0.5;
        x[k] = x[0];
        found.push(x);
    }
    found.retain(has_shape);
    found
}

/// The number of steps of each phase of the robust projection.
const ROBUST_STEPS: usize = 40;
