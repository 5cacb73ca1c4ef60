//! The state shared by both stages: the energies, the hard constraints, and the system of the
//! global step.

use super::hard_rows::{HardBatch, HardRow, HardRows};
use super::requirement::Guard;
use super::requirement::{Require, Requirements};
use crate::constraint::{Centring, Reference, Row};
use crate::mesh::{Laplacian, Point};
use crate::solve::assemble::Terms;
use crate::solve::energy::{
    BIG, Constraints, Handle, HandleIndex, Hold, extra_unknowns, shape_terms,
};
use crate::solve::gliding::Gliding;
use crate::solve::local_frame::rest_surface;
use crate::solve::parts::SetupCache;
use crate::solve::parts::{Added, Holding, Parts};
use crate::solve::problem::Problem;
use std::rc::Rc;

/// The polish ends at this fraction of the diagonal of the bounding box: 1e-12 of the bounding
/// sphere.
const MET: f64 = 5e-13;

/// The shape with its energies and hard constraints.
pub(in crate::solve) struct Model {
    pub parts: Parts,
    pub hard: HardRows,
    pub holding: Holding,
    /// `#nodes`: the positions.
    pub x: Vec<Row>,
    /// `#nodes`: the positions at the start.
    pub start: Vec<Row>,
    /// The positions at the start, `#V by 3`: a vertex that is still there keeps every bit of its
    /// coordinates.
    pub put: Vec<Point>,
    /// The edges of the guard, and the ratio that they keep.
    pub guarded: Option<(Vec<[u32; 2]>, f64)>,
    /// The mean diagonal of the metric, and that of the hard constraints, over the nodes of hard
    /// constraints.
    pub stiffness: [f64; 2],
    /// The terms of soft rows and of hard rows over vertices only, for the block system.
    pub cliques: [Terms; 2],
    /// The Laplacian of smoothness, if it has a weight.
    pub laplacian: Option<Laplacian>,
}

impl Model {
    /// Assembles the problem with its `requirements`, at the positions `start`, `#V by 3`.
    pub(in crate::solve) fn new(
        problem: &Problem<'_>,
        requirements: &Requirements<'_>,
        handles: &[Handle],
        start: &[Point],
        cache: SetupCache,
    ) -> Model {
        let rows = problem.constraints.iter().zip(requirements.rows).enumerate();
        let (mut soft, mut hard, mut places) = (Vec::new(), Vec::new(), Vec::new());
        for (index, (row, &require)) in rows {
            if require == Require::Soft {
                soft.push(row.clone());
            } else {
                // A constraint that is met needs no weight; weights only balance constraints that
                // cannot be met.
                let weight = if row.weight > 0.0 { row.weight } else { 1.0 };
                hard.push(Constraints { weight, ..row.clone() });
                places.push((Some(index), require));
            }
        }
        let n_vertices = problem.mesh.positions.len();
        let soft_problem = Problem { constraints: &soft, ..*problem };
        let first_mean = soft_problem.n_unknowns();
        let ratio = requirements.shortest_edge.filter(|ratio| *ratio > 0.0);
        let guard = ratio.and_then(|ratio| {
            let fixed = handles.iter().filter(|handle| handle.hold == Hold::Fixed);
            let fixed = fixed.map(|handle| handle.vertex).collect();
            let guard = Guard::new(&hard, problem, &fixed, ratio, requirements.all_within())?;
            let ends = guard.row.members.iter().map(|ends| [ends[0], ends[1]]).collect();
            hard.push(guard.row);
            places.push((None, guard.require));
            Some((ends, ratio))
        });
        let added = Added {
            terms: Some(shape_terms(&hard, first_mean, true)),
            unknowns: extra_unknowns(&hard, true),
            holds: hard.iter().flat_map(Constraints::placed).copied().collect(),
        };
        let mut parts = Parts::new(&soft_problem, added, cache);
        let node_of = &parts.system.node_of()[..n_vertices];
        let rows: Vec<HardRow<'_>> = hard
            .iter()
            .zip(&places)
            .map(|(row, &(place, require))| (row, place, require))
            .collect();
        let (mesh, centre) = (problem.mesh, parts.centre);
        let surface =
            || Rc::clone(parts.surface.get_or_init(|| Rc::new(rest_surface(mesh, centre))));
        let reference = Reference { surface: &surface, pose: parts.pose.as_deref() };
        let hard_rows = HardRows::new(&rows, node_of, &parts.rest, &reference);

        let mut holding = parts.holding(handles);
        // The approach moves them along their curves, the polish lets them stay.
        let gliding = parts.gliding.iter().flat_map(Gliding::vertices);
        gliding.for_each(|(_, node)| holding.fixed[node as usize] = true);
        let (mut x, mut put) = (parts.to_rows(start), start.to_vec());
        parts.place(handles, &HandleIndex::new(n_vertices, handles), &mut x, &mut put);
        let cliques = [without_means(&soft, problem.settings.mean_centring), coupled(&hard)];
        let mut model = Model {
            parts,
            hard: hard_rows,
            holding,
            start: x.clone(),
            x,
            put,
            guarded: guard,
            stiffness: [0.0; 2],
            cliques,
            laplacian: soft_problem.laplacian(),
        };
        model.stiffness = model.mean_stiffness();
        model
    }

    /// The excess at which the polish is done, not less than the rounding error of coordinates.
    pub(in crate::solve) fn goal(&self) -> f64 {
        (MET * self.parts.extent).max(self.rounding())
    }

    /// Whether the constraints are met; exact ones up to `near`.
    pub(in crate::solve) fn is_met(&self, near: f64) -> bool {
        let mut met = true;
        for hard in &self.hard.batches {
            let most = if hard.within.is_some() { 0.0 } else { near };
            hard.misses(&self.x, |_, miss| met &= miss.excess <= most);
        }
        met
    }

    /// Whether a node is free outside of the approach.
    pub(in crate::solve) fn has_free(&self) -> bool {
        self.holding.fixed.iter().any(|fixed| !*fixed)
    }

    /// Whether each node is fixed in the approach, `#nodes`: those on curves move along them.
    pub(in crate::solve) fn fixed_in_approach(&self) -> Vec<bool> {
        let mut fixed = self.holding.fixed.clone();
        let moving = self.parts.gliding.iter().flat_map(Gliding::moving);
        moving.for_each(|node| fixed[node as usize] = false);
        fixed
    }

    /// The scales of the energies in the normal matrix, with the weight `rho` of the hard
    /// constraints.
    pub(in crate::solve) fn scales(&self, rho: f64) -> [f64; 3] {
        let weights = self.parts.energies.weights;
        [weights.shape, weights.smooth, rho]
    }

    /// Computes [`Model::stiffness`], over the free nodes of hard constraints.
    fn mean_stiffness(&self) -> [f64; 2] {
        let Holding { fixed, diagonal, .. } = &self.holding;
        let system = &self.parts.system;
        let metric = system.values(&self.scales(0.0), diagonal, fixed);
        let mut own = vec![0.0; diagonal.len()];
        for HardBatch { batch, .. } in self.hard.batches.iter().filter(|it| it.row.is_some()) {
            let share = match batch.centring() {
                Centring::Together => 1.0 - 1.0 / batch.points() as f64,
                Centring::ByEdge => 0.5,
                Centring::Placed => 1.0,
            };
            for node in (0..batch.count()).flat_map(|i| batch.nodes_of(i)) {
                own[node as usize] += batch.weight() * share;
            }
        }
        let (mut sums, mut count) = ([0.0; 2], 0.0);
        for node in (0..own.len()).filter(|&node| own[node] > 0.0 && !fixed[node]) {
            sums[0] += metric.data()[metric.indptr().outer_inds_sz(node).end - 1];
            sums[1] += own[node];
            count += 1.0;
        }
        if count > 0.0 { sums.map(|sum| sum / count) } else { [0.0, 1.0] }
    }
}

/// The terms of soft rows without extra unknowns: constraints on many points hold each point by
/// itself.
fn without_means(rows: &[Constraints], mean_centring: bool) -> Terms {
    let is_big = |row: &Constraints, members: &[u32]| {
        row.kind.info().centring == Centring::Together && members.len() > BIG
    };
    let part = |big: bool| {
        move |row: &Constraints| {
            let members = row.members.iter().filter(|members| is_big(row, members) == big);
            Constraints { members: members.collect(), ..row.clone() }
        }
    };
    let small: Vec<Constraints> = rows.iter().map(part(false)).collect();
    let mut terms = shape_terms(&small, 0, mean_centring);
    for row in rows.iter().map(part(true)) {
        row.members.indices().iter().for_each(|&v| terms.push(&[v], [1.0], row.weight, 0.0));
    }
    terms
}

/// Terms that couple all vertices of each constraint in the pattern, with zero values.
fn coupled(rows: &[Constraints]) -> Terms {
    let mut terms = Terms::default();
    let mut distinct = Vec::new();
    for members in rows.iter().flat_map(|row| row.members.iter()) {
        distinct.clear();
        distinct.extend_from_slice(members);
        distinct.sort_unstable();
        distinct.dedup();
        terms.push(&distinct, distinct.iter().map(|_| 1.0), 0.0, 0.0);
    }
    terms
}
