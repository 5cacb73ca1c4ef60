//! Quads whose opposite sides have the same sum, `|s0| + |s2| = |s1| + |s3|`: Pitot's condition for
//! quads whose sides touch a circle. Here the sides need not lie in one plane.
//!
//! The closest such points `x` to points `v` are `x_k = v_k +- l (n_(k-1) + n_k)`, with plus for
//! even `k`, the unit directions `n_k` of the sides of `x` and a Lagrange multiplier `l`. With the
//! sides `w_k` of `v` and the two vectors `p = l (n0 + n2)` and `q = l (n1 + n3)`, this means
//!
//! ```text
//! n0 and n2 are the directions of w0 - q and w2 - q, n1 and n3 those of w1 + p and w3 + p
//! 8 l = |w0 - q| + |w2 - q| - |w1 + p| - |w3 + p|
//! ```
//!
//! These are six equations for `p` and `q`; Newton's method for them needs only a 3x3 inverse.

use crate::constraint::Projection;
use crate::constraint::kinds::line::Line;
use crate::math::{Lane, Vec3, centre, in_range, largest_coordinate};

/// Newton's iteration for `p` and `q`.
#[derive(Clone, Copy)]
struct Newton<S> {
    /// The sides of `v`.
    w: [Vec3<S>; 4],
    /// The required difference between the sums of opposite sides.
    difference: S,
    /// One, or minus one if a side points opposite to `w0 - q` and so on.
    signs: [S; 4],
    p: Vec3<S>,
    q: Vec3<S>,
}

/// The sides of `x` given by `p` and `q`.
struct Sides<S> {
    /// Directions, and signed lengths of `w0 - q`, `w1 + p`, `w2 - q`, `w3 + p`.
    n: [Vec3<S>; 4],
    m: [S; 4],
    /// The multiplier.
    l: S,
    /// The residuals of the equations for `p` and `q`.
    off: [Vec3<S>; 2],
}

impl<S: Lane> Newton<S> {
    #[inline(always)]
    fn new(v: &[Vec3<S>]) -> Self {
        let w = [v[1] - v[0], v[2] - v[1], v[3] - v[2], v[0] - v[3]];
        let signs = [S::one(); 4];
        Newton { w, difference: S::zero(), signs, p: Vec3::zero(), q: Vec3::zero() }
    }

    #[inline(always)]
    fn sides(&self) -> Sides<S> {
        let Newton { w, difference, signs, p, q } = *self;
        let y = [w[0] - q, w[1] + p, w[2] - q, w[3] + p];
        let m: [S; 4] = std::array::from_fn(|k| y[k].length() * signs[k]);
        let n: [Vec3<S>; 4] = std::array::from_fn(|k| y[k] * (S::one() / m[k]));
        let l = (m[0] + m[2] - m[1] - m[3] - difference) * S::splat(0.125);
        let off = [p - (n[0] + n[2]) * l, q - (n[1] + n[3]) * l];
        Sides { n, m, l, off }
    }

    /// Makes one Newton step from the current sides.
    #[inline(always)]
    fn step(&mut self, sides: &Sides<S>) {
        let Sides { n, m, l, off } = sides;
        let l = *l;
        let inverse = m.map(|m| S::one() / m);
        // l times the second derivatives of |w_i - q| + |w_j - q|, times x.
        let bend = |i: usize, j: usize, x: Vec3<S>| {
            let along = n[i] * (n[i].dot(x) * inverse[i]) + n[j] * (n[j].dot(x) * inverse[j]);
            (x * (inverse[i] + inverse[j]) - along) * l
        };
        let bend0 = |x: Vec3<S>| bend(0, 2, x);
        let bend1 = |x: Vec3<S>| bend(1, 3, x);
        let (a, b) = (n[0] + n[2], n[1] + n[3]);
        // dp + bend0 dq - a dl = -off0,  dq - bend1 dp - b dl = -off1,  8 dl = -a.dq - b.dp.
        let (zero, one) = (S::zero(), S::one());
        let [c0, c1, c2] = [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(|e| {
            let e = Vec3::new(e[0], e[1], e[2]);
            e + bend1(bend0(e))
        });
        let (r0, r1, r2) = (c1.cross(c2), c2.cross(c0), c0.cross(c1));
        // At least one: the identity plus a product of two positive semidefinite matrices.
        let determinant = one / c0.dot(r0);
        let solve = |x: Vec3<S>| Vec3::new(r0.dot(x), r1.dot(x), r2.dot(x)) * determinant;
        let q0 = solve(-off[1] - bend1(off[0]));
        let q1 = solve(b + bend1(a));
        let p0 = -off[0] - bend0(q0);
        let p1 = a - bend0(q1);
        let dl = -(a.dot(q0) + b.dot(p0)) / (S::splat(8.0) + a.dot(q1) + b.dot(p1));
        self.q += q0 + q1 * dl;
        self.p += p0 + p1 * dl;
    }
}

impl Newton<f64> {
    fn run(&mut self, steps: usize) {
        for _ in 0..steps {
            let sides = self.sides();
            self.step(&sides);
        }
    }

    /// Returns the points if their opposite sides have the same sum.
    fn found(&self, v: &[Vec3<f64>]) -> Option<[Vec3<f64>; 4]> {
        let mut x = [Vec3::zero(); 4];
        points(v, &self.sides(), &mut x);
        (difference(&x).abs() <= 1e-13).then_some(x)
    }
}

/// Writes the points with sides `sides`.
#[inline(always)]
fn points<S: Lane>(v: &[Vec3<S>], sides: &Sides<S>, projected: &mut [Vec3<S>]) {
    let Sides { n, l, .. } = sides;
    let l = *l;
    projected[0] = v[0] + (n[3] + n[0]) * l;
    projected[1] = v[1] - (n[0] + n[1]) * l;
    projected[2] = v[2] + (n[1] + n[2]) * l;
    projected[3] = v[3] - (n[2] + n[3]) * l;
}

/// The number of Newton steps of the closed form.
const STEPS: usize = 5;

/// Writes the closest points to `v` whose opposite sides have the same sum; false if they are not
/// found, or might not be the closest. Not inlined, so that all kinds share one instance.
#[inline(never)]
pub(crate) fn closest<S: Lane>(v: &[Vec3<S>; 4], projected: &mut [Vec3<S>; 4]) -> bool {
    let mut newton = Newton::new(v);
    let size = newton.w.iter().fold(S::zero(), |sum, w| sum + w.length_squared());
    let mut steps = 0..STEPS;
    let sides = loop {
        let sides = newton.sides();
        match steps.next() {
            Some(_) => newton.step(&sides),
            None => break sides,
        }
    };
    points(v, &sides, projected);
    let off = sides.off[0].length_squared() + sides.off[1].length_squared();
    let [a, b, c, d] = sides.m;
    let shortest = a.min(b).min(c.min(d));
    let one = |yes: S, bound: S| yes.if_greater(bound, S::one(), S::zero());
    let accurate = one(size * S::splat(1e-28), off)
        * one(shortest * S::splat(MILD), sides.l.abs())
        * in_range(size, size, S::one());
    accurate.all_greater(S::zero())
}

/// Corrections below this fraction of the shortest side are the least.
const MILD: f64 = 0.1;

/// As [`closest`], slower and for all finite points.
pub(crate) fn project_robust(v: &mut [Vec3<f64>]) {
    let mean = centre(v);
    let unit = largest_coordinate(v);
    if unit == 0.0 {
        return;
    }
    let scaled: Vec<_> = v.iter().map(|p| Vec3::new(p.x / unit, p.y / unit, p.z / unit)).collect();
    let found = candidates(&scaled)
        .into_iter()
        .min_by(|a, b| distance(&scaled, a).total_cmp(&distance(&scaled, b)));
    let found = found.expect("vertices that meet have the shape");
    v.iter_mut().zip(found).for_each(|(v, p)| *v = mean + p * unit);
}

fn distance(v: &[Vec3<f64>], x: &[Vec3<f64>; 4]) -> f64 {
    v.iter().zip(x).map(|(v, x)| (*v - *x).length_squared()).sum()
}

/// The difference between the sums of opposite sides.
fn difference(v: &[Vec3<f64>]) -> f64 {
    let [a, b, c, d] = std::array::from_fn(|k| (v[(k + 1) % 4] - v[k]).length());
    a + c - b - d
}

/// The number of stages in which the difference is reduced, and of iterations from other starts.
const STAGES: usize = 32;

/// Returns a start for the iteration for `p` and `q`: their values at a point with the shape not
/// far from `x`, and from `v` if that is near. Each step linearises the difference.
fn approach(v: &[Vec3<f64>], mut x: [Vec3<f64>; 4]) -> [Vec3<f64>; 2] {
    let mut ends = [Vec3::zero(); 2];
    for _ in 0..STAGES {
        let n: [Vec3<f64>; 4] = std::array::from_fn(|k| {
            (x[(k + 1) % 4] - x[k]).length_and_direction().1.unwrap_or(Vec3::zero())
        });
        let sign = [1.0, -1.0, 1.0, -1.0];
        let gradient: [Vec3<f64>; 4] = std::array::from_fn(|k| (n[(k + 3) % 4] + n[k]) * -sign[k]);
        let square: f64 = gradient.iter().map(|g| g.length_squared()).sum();
        let linear: f64 = (0..4).map(|k| gradient[k].dot(v[k] - x[k])).sum();
        let l = if square > 0.0 { (difference(&x) + linear) / square } else { 0.0 };
        for k in 0..4 {
            // Half a step: full steps need not converge if the sides turn much.
            x[k] = (x[k] + v[k] - gradient[k] * l) * 0.5;
        }
        ends = [(n[0] + n[2]) * l, (n[1] + n[3]) * l];
    }
    ends
}

/// Returns candidates for the closest points to `v`.
fn candidates(v: &[Vec3<f64>]) -> Vec<[Vec3<f64>; 4]> {
    let initial = difference(v);
    let mut found = Vec::new();
    if initial.abs() <= 1e-15 {
        found.push([v[0], v[1], v[2], v[3]]);
        return found;
    }
    // Continuation from the points themselves, reducing the difference in stages.
    let mut newton = Newton::new(v);
    for stage in (0..STAGES).rev() {
        newton.difference = initial * stage as f64 / STAGES as f64;
        newton.run(STEPS);
    }
    found.extend(newton.found(v));
    // From nearby points that have the shape, approached from the points and perturbed copies.
    for k in 0..4 {
        for beside in [0.0, 0.1, -0.1] {
            let mut x = [v[0], v[1], v[2], v[3]];
            x[k] += (x[(k + 1) % 4] - x[k]) * beside;
            x[(k + 2) % 4] += (x[(k + 1) % 4] - x[k]).cross(x[(k + 2) % 4] - x[k]) * beside;
            let start = approach(v, x);
            for [a, b] in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
                let mut newton = Newton::new(v);
                [newton.p, newton.q] = start;
                newton.signs = if initial > 0.0 { [1.0, a, 1.0, b] } else { [a, 1.0, b, 1.0] };
                newton.run(STAGES);
                found.extend(newton.found(v));
            }
        }
    }
    // Two consecutive vertices coincide on the segment between the other two, or three coincide.
    for k in 0..4 {
        let [a, b, c, d] = [k, k + 1, k + 2, k + 3].map(|k| k % 4);
        let both = (v[a] + v[b]) * 0.5;
        let mut line = [both, both, v[c], v[d]];
        let mean = centre(&mut line);
        Line::default().project_robust(&[], &mut line);
        if (line[2] - line[0]).dot(line[3] - line[0]) <= 0.0 {
            let mut x = [Vec3::zero(); 4];
            [a, b, c, d].iter().zip(line).for_each(|(&k, p)| x[k] = mean + p);
            found.push(x);
        }
        let mut x = [(v[a] + v[b] + v[c]) * (1.0 / 3.0); 4];
        x[d] = v[d];
        found.push(x);
    }
    found
}
