//! `E_shape` (Eq. 4): the constraints of a scene in batches, with their part of the normal matrix.

use crate::constraint::{
    Batch, Centring, Fitted, Kind, LocalStep, Projected, Reference, Row, batches,
};
use crate::mesh::Ragged;
use crate::solve::assemble::Terms;

/// A constraint on more points than this gets its mean as one extra unknown, coupled to each of its
/// points, instead of coupling all its points with each other. The minimiser is exactly the same:
/// minimising over the mean alone gives `N_i`.
pub(crate) const BIG: usize = 32;

/// One row of the list of constraints, resolved: one kind on several sets of vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraints {
    /// The operator `P_i`, with its parameters.
    pub kind: Kind,
    /// `w_i`, the same for all sets.
    pub weight: f64,
    /// The vertices of each constraint; for kinds that act on edges, the ends of one edge after
    /// another.
    pub members: Ragged,
}

impl Constraints {
    /// The vertices of each constraint with an extra unknown.
    fn big(&self) -> impl Iterator<Item = &[u32]> {
        let together = self.couples() && self.centring() == Centring::Together;
        self.members.iter().filter(move |members| together && members.len() > BIG)
    }

    /// Whether they couple their vertices in the normal matrix. Constraints without weight do not:
    /// they hold nothing, so that their vertices may need pins.
    fn couples(&self) -> bool {
        self.weight > 0.0
    }

    fn centring(&self) -> Centring {
        self.kind.info().centring
    }

    /// The vertices that these constraints hold in place.
    pub(crate) fn placed(&self) -> &[u32] {
        let holds = self.centring() == Centring::Placed && self.couples();
        if holds { self.members.indices() } else { &[] }
    }
}

/// Number of extra unknowns of these constraints.
pub(crate) fn extra_unknowns(constraints: &[Constraints], mean_centring: bool) -> usize {
    if mean_centring { constraints.iter().map(|c| c.big().count()).sum() } else { 0 }
}

/// The terms `sum_i w_i N_i` over vertices and extra unknowns, which are numbered from `n_vertices` on.
pub(crate) fn terms(constraints: &[Constraints], n_vertices: usize, mean_centring: bool) -> Terms {
    let mut terms = Terms::default();
    let mut mean = n_vertices as u32;
    for row in constraints.iter().filter(|row| row.couples()) {
        let centring = if mean_centring { row.centring() } else { Centring::Placed };
        for members in row.members.iter() {
            let n = members.len();
            if centring == Centring::Placed {
                members.iter().for_each(|&v| terms.push(&[v], [1.0], row.weight, 0.0));
            } else if centring == Centring::ByEdge {
                for ends in members.chunks_exact(2) {
                    terms.push(ends, [1.0; 2], row.weight, -row.weight / 2.0);
                }
            } else if n > BIG {
                for &v in members {
                    terms.push(&[v, mean], [1.0, -1.0], 0.0, row.weight);
                }
                mean += 1;
            } else {
                terms.push(members, (0..n).map(|_| 1.0), row.weight, -row.weight / n as f64);
            }
        }
    }
    terms
}

/// The batches of every row of constraints.
pub(crate) struct ShapeEnergy {
    rows: Vec<ShapeRow>,
}

struct ShapeRow {
    batches: Vec<Batch>,
    found: LocalStep,
}

impl ShapeEnergy {
    /// Batches `constraints`; `node_of` is the node of each vertex.
    pub(crate) fn new(
        constraints: &[Constraints],
        node_of: &[u32],
        rest: &[Row],
        guarded: bool,
        reference: &Reference<'_>,
    ) -> Self {
        let rows = constraints
            .iter()
            .map(|row| {
                let mut members = row.members.clone();
                members.rename(node_of);
                let batches = batches(&row.kind, &members, rest, row.weight, guarded, reference);
                ShapeRow { batches, found: LocalStep::default() }
            })
            .collect();
        ShapeEnergy { rows }
    }

    /// Whether projections of a constraint depend on those of the last local step.
    pub(crate) fn is_guarded(&self) -> bool {
        self.rows.iter().flat_map(|row| &row.batches).any(Batch::is_guarded)
    }

    /// Undoes the last local step: see `Batch::undo_step`.
    pub(crate) fn undo_step(&mut self) {
        self.rows.iter_mut().flat_map(|row| &mut row.batches).for_each(|batch| batch.undo_step());
    }

    /// Step I: projects at `x`, adds half the gradient of `lambda * E_shape`, and returns
    /// `E_shape`.
    pub(crate) fn local_step(&mut self, x: &[Row], gradient: &mut [Row], lambda: f64) -> f64 {
        let mut energy = 0.0;
        for row in &mut self.rows {
            row.found = LocalStep::default();
            for batch in &mut row.batches {
                let found = batch.local_step(x, gradient, lambda);
                row.found.energy += found.energy;
                row.found.worst_squared = row.found.worst_squared.max(found.worst_squared);
            }
            energy += row.found.energy;
        }
        energy
    }

    /// Returns for each row of constraints its energy at the last local step, and the greatest
    /// squared distance of a point from its projection.
    pub(crate) fn found(&self) -> impl Iterator<Item = LocalStep> {
        self.rows.iter().map(|row| row.found)
    }

    /// Calls `each` with the row and the projection of every constraint at `x`, as
    /// [`Batch::projected`].
    pub(crate) fn projected(&mut self, x: &[Row], mut each: impl FnMut(usize, &Projected)) {
        for (index, row) in self.rows.iter_mut().enumerate() {
            for batch in &mut row.batches {
                batch.projected(x, &mut |points| each(index, points));
            }
        }
    }

    /// The fitted shapes at `x`, for drawing.
    pub(crate) fn fitted(&self, x: &[Row]) -> Vec<Fitted> {
        let mut shapes = Vec::new();
        for batch in self.rows.iter().flat_map(|row| &row.batches) {
            batch.fitted(x, &mut shapes);
        }
        shapes
    }
}
