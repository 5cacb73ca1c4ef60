//! The linear system of the global step: `Q^T Q` in the elimination order, and its factor.
//!
//! The matrix is given by its parameters at once; its values and its factor are computed when they
//! are needed ([`State`]):
//!
//! ```text
//! set_matrix          Unknown     and prepare at once, because it may be singular
//!                     Regular     if it is above one that was factored: it cannot be singular
//!                     Factored    if its own factor was kept: handles were released again
//! prepare             Unknown, Regular -> Whole
//! complete            Factored -> Whole, for an update or for the other precision
//! set_coefficients    any -> Unknown
//! ```

#[cfg(test)]
mod tests;

use super::assemble::{Assembler, Terms, structure};
use super::clock;
use super::error::SolveError;
use crate::constraint::Row;
use crate::sparse::{
    F32Factor, Factor, Factorization, Panels, Precision, SymbolicAnalysis, Update, UpperTriangle,
};
use std::rc::Rc;

/// Times of the set-up in seconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SetUpSeconds {
    /// Terms, batches and the normal matrix.
    pub assemble: f64,
    /// The elimination order and the symbolic analysis; almost nothing if an existing one fits.
    pub order: f64,
    /// The last factorisation.
    pub factor: f64,
}

/// The parameters of a normal matrix of this pattern: it is
/// `sum_k scales[k] * energies[k] + diag(diagonal)`, with the rows and columns of the `fixed` nodes
/// replaced by those of the identity.
#[derive(Clone, Debug, Default, PartialEq)]
struct Matrix {
    /// One for each energy.
    scales: Vec<f64>,
    /// `#nodes`
    diagonal: Vec<f64>,
    /// `#nodes`
    fixed: Vec<bool>,
}

impl Matrix {
    /// Whether `other` is this matrix, possibly with more on its diagonal and more nodes fixed. If
    /// this one is positive definite, so is the other, whose pivots are no smaller (Schur
    /// complements of positive definite matrices grow with the diagonal; those of a submatrix are
    /// no smaller).
    fn is_below(&self, other: &Matrix) -> bool {
        let own = self.diagonal.iter().zip(&self.fixed);
        let others = other.diagonal.iter().zip(&other.fixed);
        self.scales == other.scales
            && own
                .zip(others)
                .all(|((a, fixed), (b, other_fixed))| *other_fixed || (!*fixed && a <= b))
    }
}

/// The normal matrix over vertices and extra unknowns, called nodes once they are in the
/// elimination order. Everything that iterates is numbered by node, so that no step permutes.
pub struct System {
    analysis: Rc<SymbolicAnalysis>,
    /// Number of unknowns of vertices, the first ones; the others are extra unknowns.
    own: usize,
    assembler: Assembler,
    factorization: Factorization,
    precision: Precision,
    matrix: Matrix,
    /// The values of `matrix` in the state [`State::Whole`], otherwise of another one.
    normal: UpperTriangle,
    factor: Factor,
    state: State,
    /// A matrix that is below the current one (see [`Matrix::is_below`]), and its factor, which is
    /// used again when the handles added since are released.
    below: Option<(Matrix, Factor)>,
    /// The nodes that are fixed.
    fixed: Vec<u32>,
    /// Times of the set-up in seconds.
    pub seconds: SetUpSeconds,
}

/// The progress of the set-up for the current matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    /// Neither values nor a factor; the matrix may be singular.
    Unknown,
    /// Neither values nor a factor, but the matrix is certain to be positive definite.
    Regular,
    /// A factor; the values are those of another matrix.
    Factored,
    /// Values and a factor.
    Whole,
}

impl System {
    /// Orders the `n` nodes of the given terms, all of which are unknowns of vertices.
    pub fn new(n: usize, energies: Vec<Terms>) -> System {
        System::with_order([n, n], energies, Factorization::default(), None)
    }

    /// The same for `n` nodes, of which the first `own` are unknowns of vertices, using the analysis
    /// `known` if it has the same pattern.
    pub(super) fn with_order(
        [n, own]: [usize; 2],
        energies: Vec<Terms>,
        factorization: Factorization,
        known: Option<&Rc<SymbolicAnalysis>>,
    ) -> System {
        let started = clock::now();
        let all: Vec<&Terms> = energies.iter().collect();
        let structure = structure(n, &all);
        let patterned = clock::now();
        let analysis = match known.filter(|known| known.fits(&structure)) {
            Some(fitting) => Rc::clone(fitting),
            None => Rc::new(SymbolicAnalysis::new(structure)),
        };
        let arranged = clock::now();

        let renumbered = energies.into_iter().map(|terms| terms.renumbered(analysis.position_of()));
        let energies = renumbered.collect();
        let assembler = Assembler::new(n, energies);
        let normal = analysis.zeros();
        let factor = Factor::new(Rc::clone(analysis.supernodes()), factorization);
        let seconds = SetUpSeconds {
            assemble: patterned - started + clock::now() - arranged,
            order: arranged - patterned,
            factor: 0.0,
        };
        System {
            analysis,
            own,
            assembler,
            factorization,
            precision: Precision::Double,
            matrix: Matrix::default(),
            normal,
            factor,
            state: State::Unknown,
            below: None,
            fixed: Vec::new(),
            seconds,
        }
    }

    /// The analysis of the pattern, for other systems of the same pattern.
    pub(super) fn analysis(&self) -> &Rc<SymbolicAnalysis> {
        &self.analysis
    }

    /// The node of each vertex, then of each extra unknown.
    pub fn node_of(&self) -> &[u32] {
        self.analysis.position_of()
    }

    /// Decouples these nodes from the others in the matrix. Must be called before factoring.
    pub(super) fn decouple(&mut self, nodes: impl Iterator<Item = u32>) {
        self.assembler.decouple(nodes);
    }

    /// `#nodes`: which nodes are decoupled.
    pub(super) fn is_decoupled(&self) -> &[bool] {
        self.assembler.is_decoupled()
    }

    /// A number for each node that is shared within a connected component.
    pub fn components(&self) -> &[u32] {
        self.analysis.components()
    }

    /// Number of nodes that are unknowns.
    pub fn unknowns(&self) -> usize {
        self.analysis.size() - self.fixed.len()
    }

    /// Number of nonzeros of the factor.
    pub fn factor_nonzeros(&self) -> usize {
        self.factor.nonzeros()
    }

    /// Replaces `a` of every term of an energy, one entry for each entry of its nodes as they were
    /// pushed, for terms that are linearised. Takes effect with the next factor.
    #[cfg(feature = "cli")]
    pub(crate) fn set_coefficients(&mut self, energy: usize, a: &[f64]) {
        self.assembler.set_coefficients(energy, a);
        (self.below, self.state) = (None, State::Unknown);
    }

    /// Assembles `sum_k scales[k] * energies[k] + diag(diagonal)` and factors it. Nodes marked
    /// `fixed` are not unknowns. The pattern and the order stay.
    ///
    /// # Errors
    /// If the matrix is not positive definite. The system must then be factored again before use.
    pub fn factor(
        &mut self,
        scales: &[f64],
        diagonal: &[f64],
        fixed: Vec<bool>,
    ) -> Result<(), SolveError> {
        self.set_matrix(Precision::Double, scales, diagonal, fixed)?;
        self.prepare()
    }

    /// The same, for solving in this precision. A matrix that is certain to be positive definite is
    /// factored only by [`System::prepare`], and not at all if its factor is available.
    ///
    /// # Errors
    /// As [`System::factor`].
    pub(super) fn set_matrix(
        &mut self,
        precision: Precision,
        scales: &[f64],
        diagonal: &[f64],
        fixed: Vec<bool>,
    ) -> Result<(), SolveError> {
        self.fixed = (0..).zip(&fixed).filter(|(_, fixed)| **fixed).map(|(node, _)| node).collect();
        let wanted = Matrix { scales: scales.to_vec(), diagonal: diagonal.to_vec(), fixed };
        let has_factor = matches!(self.state, State::Factored | State::Whole);
        let matrix = std::mem::replace(&mut self.matrix, wanted);
        if precision != self.precision {
            (self.below, self.state) = (None, State::Unknown);
        }
        self.precision = precision;
        self.state = match &self.below {
            Some((below, _)) if *below == self.matrix => {
                let (_, factor) = self.below.take().expect("it is there");
                self.factor = factor;
                State::Factored
            }
            Some((below, _)) if below.is_below(&self.matrix) => State::Regular,
            _ if has_factor && matrix.is_below(&self.matrix) => {
                let new = Factor::new(Rc::clone(self.analysis.supernodes()), self.factorization);
                let mut factor = std::mem::replace(&mut self.factor, new);
                factor.keep_only(precision);
                self.below = Some((matrix, factor));
                State::Regular
            }
            _ => {
                self.below = None;
                State::Unknown
            }
        };
        if self.state == State::Unknown { self.prepare() } else { Ok(()) }
    }

    /// Computes the factor if there is none.
    ///
    /// # Errors
    /// As [`System::factor`].
    pub(super) fn prepare(&mut self) -> Result<(), SolveError> {
        if matches!(self.state, State::Factored | State::Whole) {
            return Ok(());
        }
        self.state = State::Unknown;
        self.assemble();
        let started = clock::now();
        self.factor.factor(&self.normal, &self.matrix.fixed, self.precision).map_err(
            |singular| SolveError::NotPositiveDefinite { vertex: self.vertex_at(singular.column) },
        )?;
        self.seconds.factor = clock::now() - started;
        self.state = State::Whole;
        Ok(())
    }

    /// The unknown of a vertex at a node: of an extra unknown, the first of those that it is coupled to.
    fn vertex_at(&self, node: usize) -> u32 {
        let unknown = |node: u32| self.analysis.unknown_at(node as usize);
        let is_own = |unknown: &u32| (*unknown as usize) < self.own;
        let above = &self.normal.indices()[self.normal.indptr().outer_inds_sz(node)];
        let below = self.analysis.supernodes().lower(node).map(|(row, _)| row);
        let coupled = above.iter().copied().chain(below).map(unknown).filter(is_own).min();
        Some(unknown(node as u32)).filter(is_own).or(coupled).unwrap_or(0)
    }

    /// Computes the values of the matrix.
    fn assemble(&mut self) {
        let started = clock::now();
        let Matrix { scales, diagonal, fixed } = &self.matrix;
        self.assembler.assemble(scales, diagonal, fixed, &mut self.normal);
        self.seconds.assemble += clock::now() - started;
    }

    /// Returns another matrix of this pattern, `sum_k scales[k] * energies[k] + diag(diagonal)`.
    pub(super) fn values(&self, scales: &[f64], diagonal: &[f64], fixed: &[bool]) -> UpperTriangle {
        let mut values = self.analysis.zeros();
        self.assembler.assemble(scales, diagonal, fixed, &mut values);
        values
    }

    /// Computes the values of a matrix that has only a factor.
    fn complete(&mut self) {
        if self.state == State::Factored {
            self.assemble();
            self.state = State::Whole;
        }
    }

    /// Updates the rows and columns of some nodes without a new factorisation. Returns false, and
    /// changes nothing, if there is no factor.
    pub(super) fn update(&mut self, updates: &[(u32, Update)]) -> bool {
        if !matches!(self.state, State::Factored | State::Whole) {
            return false;
        }
        self.complete();
        let started = clock::now();
        for &(node, update) in updates {
            let column = self.normal.indptr().outer_inds_sz(node as usize);
            let values = self.normal.data_mut();
            match update {
                Update::Weight(weight) => {
                    values[column.end - 1] += weight;
                    self.matrix.diagonal[node as usize] += weight;
                }
                Update::Fix => {
                    values[column.clone()].fill(0.0);
                    let below = self.analysis.supernodes().lower(node as usize);
                    below.for_each(|(_, place)| values[place as usize] = 0.0);
                    values[column.end - 1] = 1.0;
                    self.fixed.push(node);
                    self.matrix.fixed[node as usize] = true;
                }
            }
            self.factor.update(node, update);
        }
        self.seconds.factor = clock::now() - started;
        true
    }

    /// The factor in single precision, after [`System::prepare`].
    pub(super) fn f32_factor(&mut self) -> &F32Factor {
        if !self.factor.has(Precision::Single) {
            self.complete();
        }
        self.factor.single(&self.normal, &self.matrix.fixed)
    }

    /// Applies the inverse of the normal matrix to `right` in place, in double precision.
    pub(crate) fn solve(&mut self, right: &mut [Row]) {
        self.double().solve(right);
    }

    fn double(&mut self) -> &Panels<f64> {
        if !self.factor.has(Precision::Double) {
            self.complete();
        }
        self.factor.double(&self.normal, &self.matrix.fixed)
    }

    /// Sets the rows of fixed nodes to zero.
    pub fn clear_fixed(&self, gradient: &mut [Row]) {
        self.fixed.iter().for_each(|&node| gradient[node as usize] = [0.0; 4]);
    }
}
