//! Untangling of patches around flipped triangles, with integers and the rest of the map held: a
//! regularised energy whose minimum has no flipped triangle if there is such a map (Garanzha, Kaporin,
//! Kudryavtseva, Protais, Ray and Sokolov 2021, *Foldover-free maps in 50 lines of code*).
//!
//! ```text
//! E = sum_t A_t (tr J^T J + det J^2 + 1) / chi(det J),   chi(D) = (D + sqrt(eps^2 + D^2)) / 2
//! ```
//!
//! J is the Jacobian from the triangle, in panels, to the plane; eps falls as the least determinant
//! rises to zero.

use super::budget::Budget;
use super::lbfgs::minimise;
use super::seams::Seams;
use super::snap::snapped;
use crate::quads::Triangulation;
use crate::quads::field::Frames;

/// Numbers of rings around flipped triangles, tried in turn.
const RINGS: [usize; 2] = [4, 9];
/// Most minimisations with one eps.
const ROUNDS: usize = 30;
/// Most steps of a minimisation.
const STEPS: usize = 60;
/// Minimisations go on as long as every few of them raise the least determinant.
const PATIENCE: usize = 6;
/// Twice the area in squares of panels below which a triangle counts as flipped while untangling;
/// far above the steps of fixed point.
const MARGIN: f64 = 1e-8;
/// Triangles of less than this height over their longest side are replaced by regular ones.
const THIN: f64 = 1e-3;

/// What untangling needs of a surface.
pub(super) struct Untangling<'a> {
    surface: &'a Triangulation,
    seams: &'a Seams,
    /// For each triangle its inverse rest shape: `J = [e1 e2] B`, with the sides of the mapped
    /// triangle from its first corner.
    rest: Vec<[[f64; 2]; 2]>,
    /// Area in squares of panels, times the factor of the scale.
    area: Vec<f64>,
    /// The triangles in whose corners each free unknown occurs.
    triangles: Vec<Vec<u32>>,
    /// Whether a free unknown may move.
    is_free: Vec<bool>,
}

impl<'a> Untangling<'a> {
    /// Prepares for panels of the side `size`.
    pub(super) fn new(
        surface: &'a Triangulation,
        frames: &Frames,
        seams: &'a Seams,
        size: f64,
    ) -> Untangling<'a> {
        let n = surface.triangles.len();
        let mut triangles = vec![Vec::new(); seams.is_integer.len()];
        for (t, classes) in seams.classes.iter().enumerate() {
            for class in classes {
                for &(k, _) in
                    [0, 1].iter().flat_map(|axis| &seams.sums[2 * *class as usize + axis])
                {
                    let list: &mut Vec<u32> = &mut triangles[k as usize];
                    if list.last() != Some(&(t as u32)) && !seams.is_integer[k as usize] {
                        list.push(t as u32);
                    }
                }
            }
        }
        let is_free = (0..seams.is_integer.len())
            .map(|k| !seams.is_integer[k] && !seams.pinned.contains(&(k as u32)))
            .collect();
        let shape = |t: usize| {
            let sides = [1, 2].map(|k| surface.at(t, k) - surface.at(t, 0));
            let [first, second] = sides.map(|side| frames.of(t, side) / size);
            let [a, b, c, d] = [first.re, second.re, first.im, second.im];
            let doubled = a * d - b * c;
            let (p, q) = (a - b, c - d);
            let longest = (a * a + c * c).max(b * b + d * d).max(p * p + q * q);
            let [a, b, c, d, doubled] = if doubled > THIN * longest {
                [a, b, c, d, doubled]
            } else {
                // A regular triangle of the same longest side.
                let side = longest.sqrt();
                let high = 0.75f64.sqrt() * side;
                [side, 0.5 * side, 0.0, high, side * high]
            };
            ([[d / doubled, -b / doubled], [-c / doubled, a / doubled]], 0.5 * doubled)
        };
        let (rest, area) = (0..n).map(shape).unzip();
        Untangling { surface, seams, rest, area, triangles, is_free }
    }

    /// Untangles patches around flipped triangles, as long as the budget allows. Patches that stay
    /// tangled are as before.
    pub(super) fn untangle(&self, values: &mut [f64], doubled: &mut [f64], budget: &mut Budget) {
        for rings in RINGS {
            let mut seen = vec![false; doubled.len()];
            for first in 0..doubled.len() {
                if doubled[first] > 0.0 || seen[first] || budget.is_spent() {
                    continue;
                }
                let patch = self.grow(first, rings, doubled);
                patch.iter().for_each(|&t| seen[t] = true);
                self.untangle_patch(&patch, values, doubled, budget);
            }
        }
    }

    /// The triangles within some rings of a flipped one, and of other flipped ones on the way.
    fn grow(&self, first: usize, rings: usize, doubled: &[f64]) -> Vec<usize> {
        let mut left = std::collections::BTreeMap::from([(first, rings)]);
        let mut queue = std::collections::VecDeque::from([first]);
        while let Some(t) = queue.pop_front() {
            let rest = left[&t];
            if rest == 0 {
                continue;
            }
            for next in self.surface.neighbours[t].iter().flatten() {
                let here = if doubled[next.triangle] <= 0.0 { rings } else { rest - 1 };
                if left.get(&next.triangle).is_none_or(|&known| known < here) {
                    left.insert(next.triangle, here);
                    queue.push_back(next.triangle);
                }
            }
        }
        left.into_keys().collect()
    }

    fn untangle_patch(
        &self,
        patch: &[usize],
        values: &mut [f64],
        doubled: &mut [f64],
        budget: &mut Budget,
    ) {
        let inside = |t: u32| patch.binary_search(&(t as usize)).is_ok();
        let mut unknowns: Vec<u32> = patch
            .iter()
            .flat_map(|&t| self.seams.classes[t])
            .flat_map(|class| [0, 1].map(|axis| &self.seams.sums[2 * class as usize + axis]))
            .flat_map(|row| row.iter().map(|&(k, _)| k))
            .filter(|&k| self.is_free[k as usize])
            .collect();
        unknowns.sort_unstable();
        unknowns.dedup();
        unknowns.retain(|&k| self.triangles[k as usize].iter().all(|&t| inside(t)));
        if unknowns.is_empty() {
            return;
        }
        let corners: Vec<[Corner; 3]> = patch
            .iter()
            .map(|&t| {
                self.seams.classes[t].map(|class| {
                    [0, 1].map(|axis| {
                        let row = &self.seams.sums[2 * class as usize + axis];
                        let mut line = Line { constant: 0.0, terms: Vec::new() };
                        for &(k, c) in row {
                            match unknowns.binary_search(&k) {
                                Ok(local) => line.terms.push((local, c)),
                                Err(_) => line.constant += c * values[k as usize],
                            }
                        }
                        line
                    })
                })
            })
            .collect();
        let problem = Patch { untangling: self, patch, corners };
        let mut x: Vec<f64> = unknowns.iter().map(|&k| values[k as usize]).collect();
        let before = patch.iter().filter(|&&t| doubled[t] <= 0.0).count();
        let mut eps = 1.0;
        let mut record = (f64::NEG_INFINITY, 0);
        for round in 0..ROUNDS {
            let (flips, least) = problem.determinants(&x);
            if least > 0.8 * record.0 || round == 0 {
                record = (least, round);
            }
            if (flips == 0 && round > 0) || round > record.1 + PATIENCE || budget.is_spent() {
                break;
            }
            let regular = (1e-12 + 0.04 * least.min(0.0) * least.min(0.0)).sqrt();
            eps = if round == 0 { regular } else { regular.min(eps) };
            let most = [STEPS, budget.visits_of(patch.len())];
            let calls = minimise(&mut x, most, |x, gradient| problem.energy(x, eps, gradient));
            budget.visit(calls * patch.len());
        }
        x.iter_mut().for_each(|value| *value = snapped(*value));
        let flips = problem.corners.iter().filter(|corners| cross(corners, &x) <= 0.0).count();
        if flips < before {
            unknowns.iter().zip(&x).for_each(|(&k, &value)| values[k as usize] = value);
            for (&t, corners) in patch.iter().zip(&problem.corners) {
                doubled[t] = cross(corners, &x);
            }
        }
    }
}

/// One coordinate: a constant and multiples of local unknowns.
struct Line {
    constant: f64,
    terms: Vec<(usize, f64)>,
}

impl Line {
    fn at(&self, x: &[f64]) -> f64 {
        self.terms.iter().fold(self.constant, |sum, &(k, c)| sum + c * x[k])
    }
}

type Corner = [Line; 2];

struct Patch<'a> {
    untangling: &'a Untangling<'a>,
    patch: &'a [usize],
    corners: Vec<[Corner; 3]>,
}

impl Patch<'_> {
    /// The number of triangles without positive area, and the least determinant.
    fn determinants(&self, x: &[f64]) -> (usize, f64) {
        let mut flips = 0;
        let mut least = f64::INFINITY;
        for (&t, corners) in self.patch.iter().zip(&self.corners) {
            let doubled = cross(corners, x);
            flips += usize::from(doubled <= MARGIN);
            let [[p, q], [r, s]] = self.untangling.rest[t];
            least = least.min(doubled * (p * s - q * r));
        }
        (flips, least)
    }

    /// The energy, to whose gradient those of the triangles are summed up.
    fn energy(&self, x: &[f64], eps: f64, gradient: &mut [f64]) -> f64 {
        gradient.fill(0.0);
        let mut sum = 0.0;
        for (&t, corners) in self.patch.iter().zip(&self.corners) {
            let [a, b, c] = points(corners, x);
            let e = [[b[0] - a[0], c[0] - a[0]], [b[1] - a[1], c[1] - a[1]]];
            let rest = self.untangling.rest[t];
            // J = E B
            let j = [0, 1].map(|r| [0, 1].map(|k| e[r][0] * rest[0][k] + e[r][1] * rest[1][k]));
            let det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
            let root = (eps * eps + det * det).sqrt();
            let chi = 0.5 * if det >= 0.0 { det + root } else { eps * eps / (root - det) };
            let slope = chi / root;
            let norm = j.iter().flatten().map(|x| x * x).sum::<f64>();
            let top = norm + det * det + 1.0;
            let area = self.untangling.area[t];
            sum += area * top / chi;
            let of_det = area * (2.0 * det / chi - top * slope / (chi * chi));
            let of_norm = area * 2.0 / chi;
            let adjugate = [[j[1][1], -j[1][0]], [-j[0][1], j[0][0]]];
            for r in 0..2 {
                let g = [0, 1].map(|k| of_norm * j[r][k] + of_det * adjugate[r][k]);
                let of_sides = [0, 1].map(|k| g[0] * rest[k][0] + g[1] * rest[k][1]);
                let of_corners = [-of_sides[0] - of_sides[1], of_sides[0], of_sides[1]];
                for (corner, value) in corners.iter().zip(of_corners) {
                    for &(k, c) in &corner[r].terms {
                        gradient[k] += c * value;
                    }
                }
            }
        }
        sum
    }
}

fn points(corners: &[Corner; 3], x: &[f64]) -> [[f64; 2]; 3] {
    [0, 1, 2].map(|k| [0, 1].map(|axis| corners[k][axis].at(x)))
}

fn cross(corners: &[Corner; 3], x: &[f64]) -> f64 {
    let [a, b, c] = points(corners, x);
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}
