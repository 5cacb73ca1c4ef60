//! The symmetric system of 3 by 3 blocks, with the sparsity of the edges, for one step of the solve
//! for axes.

use crate::fabricate::surface::PanelSurface;
use crate::math::{Vec3, marked};
use crate::sparse::{BlockMatrix, SymbolicAnalysis};

/// Largest number of conjugate gradient iterations: a factorisation costs about as much.
const MOST_ITERATIONS: usize = 15;
/// Largest acceptable squared relative residual after that.
const ENOUGH: f64 = 0.01;

/// `A n = b` with a block of `A` for each vertex and each edge. Quadratic terms are added to it: a
/// term `(c . n - 1)^2` adds `c c'` to the matrix and `c` to the right-hand side.
pub(super) struct System {
    analysis: SymbolicAnalysis,
    matrix: BlockMatrix,
    /// The values of the matrix of flat beams, with which every step begins.
    beams: Vec<f64>,
    /// Vertices of no panel: their axis is zero.
    excluded: Vec<bool>,
    right: Vec<Vec3<f64>>,
}

impl System {
    /// The system of the edges of `surface`.
    pub(super) fn new(surface: &PanelSurface) -> System {
        let n = surface.positions.len();
        let edges = surface.edges.iter().map(|edge| edge.ends);
        let analysis = SymbolicAnalysis::of_edges(n, edges);
        let used = marked(n, surface.faces.indices());
        let mut system = System {
            matrix: BlockMatrix::new(&analysis),
            analysis,
            beams: Vec::new(),
            excluded: used.iter().map(|used| !used).collect(),
            right: vec![Vec3::zero(); n],
        };
        for edge in surface.real_edges() {
            let t = surface.direction(edge);
            let [i, j] = edge.ends;
            let across = identity_and_outer(1.0, -1.0, t);
            system.add(i, across);
            system.add(j, across);
            system.couple(i, j, identity_and_outer(-1.0, 1.0, t));
        }
        system.beams = system.matrix.values().to_vec();
        system
    }

    /// Resets to `A = mu I` and `b` as `mu` times the vectors `near` (`#V`).
    pub(super) fn reset(&mut self, mu: f64, near: &[Vec3<f64>]) {
        self.matrix.clear();
        self.follow(mu, near);
    }

    /// As `reset`, with the terms `sum_e |P_e (n_j - n_i)|^2`.
    pub(super) fn reset_with_beams(&mut self, mu: f64, near: &[Vec3<f64>]) {
        self.matrix.set_values(&self.beams);
        self.follow(mu, near);
    }

    fn follow(&mut self, mu: f64, near: &[Vec3<f64>]) {
        for place in 0..self.analysis.size() as u32 {
            self.matrix.add_diagonal(place, |r, c| if r == c { mu } else { 0.0 });
        }
        self.set_rhs(mu, near);
    }

    /// Sets the right-hand side to `mu` times `near`.
    pub(super) fn set_rhs(&mut self, mu: f64, near: &[Vec3<f64>]) {
        self.right.iter_mut().zip(near).for_each(|(right, near)| *right = *near * mu);
    }

    /// Adds a block at a vertex.
    pub(super) fn add(&mut self, v: u32, block: [[f64; 3]; 3]) {
        let place = self.analysis.position_of()[v as usize];
        self.matrix.add_diagonal(place, |r, c| block[r][c]);
    }

    /// Adds a symmetric block between two vertices.
    pub(super) fn couple(&mut self, i: u32, j: u32, block: [[f64; 3]; 3]) {
        let [p, q] = [i, j].map(|v| self.analysis.position_of()[v as usize]);
        self.matrix.add(p.min(q), p.max(q), |r, c| block[r][c]);
    }

    /// Adds to the right-hand side of a vertex.
    pub(super) fn add_rhs(&mut self, v: u32, by: Vec3<f64>) {
        self.right[v as usize] += by;
    }

    /// Factors the matrix. Returns false if it is singular up to rounding.
    pub(super) fn factor(&mut self) -> bool {
        let n = self.analysis.size();
        let excluded: Vec<bool> =
            (0..n).map(|k| self.excluded[self.analysis.unknown_at(k) as usize]).collect();
        self.matrix.factor(&excluded).is_ok()
    }

    /// Solves for the right-hand side; returns `#V` vectors.
    pub(super) fn solve(&mut self) -> Vec<Vec3<f64>> {
        let mut rows = self.in_places(&self.right);
        self.matrix.solve(&mut rows);
        self.by_vertices(&rows)
    }

    /// Solves by conjugate gradients from `near`, preconditioned by the last factor, until the
    /// relative error is at most `accuracy`, or for about the time of a factorisation. Returns none
    /// if most of the error is left then, or the matrix is not positive definite.
    pub(super) fn solve_near(
        &mut self,
        near: &[Vec3<f64>],
        accuracy: f64,
    ) -> Option<Vec<Vec3<f64>>> {
        let mut solution = self.in_places(near);
        let mut residual = self.in_places(&self.right);
        let mut product = vec![[0.0; 4]; residual.len()];
        self.matrix.times(&solution, &mut product);
        add(&mut residual, -1.0, &product);
        let mut direction = residual.clone();
        self.matrix.solve(&mut direction);
        let mut size = inner(&residual, &direction);
        let first = size;
        for _ in 0..MOST_ITERATIONS {
            if size <= accuracy * accuracy * first {
                return Some(self.by_vertices(&solution));
            }
            self.matrix.times(&direction, &mut product);
            let curvature = inner(&direction, &product);
            if curvature <= 0.0 || curvature.is_nan() {
                return None;
            }
            add(&mut solution, size / curvature, &direction);
            add(&mut residual, -size / curvature, &product);
            product.copy_from_slice(&residual);
            self.matrix.solve(&mut product);
            let next = inner(&residual, &product);
            add(&mut product, next / size, &direction);
            direction.copy_from_slice(&product);
            size = next;
        }
        (size < ENOUGH * first).then(|| self.by_vertices(&solution))
    }

    /// Reorders vectors of vertices to the order of elimination; zero for vertices of no panel.
    fn in_places(&self, vectors: &[Vec3<f64>]) -> Vec<[f64; 4]> {
        let mut rows = vec![[0.0; 4]; vectors.len()];
        for (v, (vector, &place)) in vectors.iter().zip(self.analysis.position_of()).enumerate() {
            if !self.excluded[v] {
                rows[place as usize] = [vector.x, vector.y, vector.z, 0.0];
            }
        }
        rows
    }

    /// The inverse of `in_places`.
    fn by_vertices(&self, rows: &[[f64; 4]]) -> Vec<Vec3<f64>> {
        let at = |&place: &u32| {
            let [x, y, z, _] = rows[place as usize];
            Vec3::new(x, y, z)
        };
        self.analysis.position_of().iter().map(at).collect()
    }
}

/// Adds `times` times `vectors`.
fn add(to: &mut [[f64; 4]], times: f64, vectors: &[[f64; 4]]) {
    for (to, vector) in to.iter_mut().zip(vectors) {
        to.iter_mut().zip(vector).for_each(|(to, value)| *to += times * value);
    }
}

/// The inner product.
fn inner(a: &[[f64; 4]], b: &[[f64; 4]]) -> f64 {
    let mut sums = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        (0..4).for_each(|k| sums[k] += a[k] * b[k]);
    }
    sums.iter().sum()
}

/// `c c'`.
pub(super) fn outer(c: Vec3<f64>) -> [[f64; 3]; 3] {
    let c = [c.x, c.y, c.z];
    c.map(|row| c.map(|column| row * column))
}

/// `a I + b c c'`.
pub(super) fn identity_and_outer(a: f64, b: f64, c: Vec3<f64>) -> [[f64; 3]; 3] {
    let mut block = outer(c).map(|row| row.map(|entry| b * entry));
    (0..3).for_each(|k| block[k][k] += a);
    block
}

/// `P_e x`.
pub(in crate::fabricate) fn across_edge(x: Vec3<f64>, t: Vec3<f64>) -> Vec3<f64> {
    x - t * x.dot(t)
}
