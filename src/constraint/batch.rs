//! Many constraints of one kind and one number of points, projected in lanes.
//!
//! The only layer between the mesh and an operator: it gathers the points of `LANES` constraints at
//! a time, centres them (`N_i` of Eq. 5), projects them, and scatters the gradient
//! `w_i N_i (N_i V_i - P_i)` (Appendix A). The operator receives points only.
//!
//! # From a kind to its compiled closed form
//!
//! The code of a batch is compiled once for all kinds, and the closed form of a kind once for each
//! number of points that matters, so that these stay in registers. For `plane` on quads:
//!
//! ```text
//! batches                                 once; constraints of 4 points make one batch
//!   Kind::visit -> MakeBatch::visit       the kind is known as a type, P = Plane
//!     Batch::new                          and is erased again: Box<dyn Operator>
//!
//! Batch::local_step                       each iteration, without knowing the kind
//!   step_few::<4> -> step_chunk           by the number of points: arrays on the stack
//!     gather, centre
//!     Operator::project                   one indirect call per chunk, to that of Plane
//!       closed_form_of_few::<Plane, 4>    by the number of points again, now with the kind
//!         Plane::closed_form              kinds/plane.rs, inlined for 4 points
//!       lane_by_lane                      only if that is inaccurate in some lane
//!         Plane::closed_form              for one lane, copied to all
//!         Plane::project_robust           if it is inaccurate there, too
//!     centre, keep_nearer, add_to_rows
//! ```
//!
//! Other numbers of points than 3 and 4 take `scratch` instead of arrays, and kinds of any number
//! of points `closed_form_of_many`. [`Projection::project`] is the same without a batch, for tests.

mod points;

use super::declaration::{Arity, Centring};
use super::kinds::{Kind, KindVisitor};
use super::projection::{Fitted, Reference, Row};
use super::projection::{Projection, project_with};
use crate::math::{LANES, Lane, Lanes, Vec3, argsort, centre, key_of_pair};
use crate::mesh::Ragged;

/// The result of the local step of a batch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LocalStep {
    /// `sum_i w_i |N_i V_i - P_i|^2` over the batch, in squared length.
    pub energy: f64,
    /// The largest squared distance of a vertex to the fitted shape.
    pub worst_squared: f64,
}

/// The points of one constraint: the node, and the displacement from it to the fitted shape.
pub type Projected = [(u32, Vec3<f64>)];

/// Groups the constraints of a kind into one batch per number of points, fewest first.
///
/// `members` are the node indices of each constraint, `rest` the rest position of each node,
/// `weight` is `w_i`, the same for all. Points that the kind centres by edge come in pairs. With
/// `guarded`, each constraint keeps the nearer of the new and the previous projection, so that the
/// energy never rises even with inexact operators.
pub fn batches(
    kind: &Kind,
    members: &Ragged,
    rest: &[Row],
    weight: f64,
    guarded: bool,
    reference: &Reference<'_>,
) -> Vec<Batch> {
    // Sorted by smallest node, consecutive constraints read and write neighbouring rows.
    let key = |nodes: &[u32]| [nodes.len() as u32, nodes.iter().min().map_or(0, |&first| first)];
    let order = argsort(members.iter().map(|nodes| key_of_pair(key(nodes))));
    let by_size: Vec<&[u32]> = order.into_iter().map(|i| members.row(i as usize)).collect();
    by_size
        .chunk_by(|a, b| a.len() == b.len())
        .map(|same_size| {
            let centring = kind.info().centring;
            let members = same_size;
            kind.visit(MakeBatch { members, rest, weight, guarded, reference, centring })
        })
        .collect()
}

struct MakeBatch<'a> {
    members: &'a [&'a [u32]],
    rest: &'a [Row],
    weight: f64,
    guarded: bool,
    reference: &'a Reference<'a>,
    centring: Centring,
}

impl KindVisitor for MakeBatch<'_> {
    type Output = Batch;
    fn visit<P: Projection>(self, operator: &P) -> Batch {
        let mut operator = operator.clone();
        operator.bind(self.reference);
        let rest = self.reference.pose.filter(|_| P::USES_POSE).unwrap_or(self.rest);
        let make = MakeBatch { guarded: self.guarded || P::GUARDED, rest, ..self };
        Batch::new(Box::new(operator), P::READS_REST, make)
    }
}

/// Constraints of one kind and one number of points.
pub struct Batch {
    operator: Box<dyn Operator>,
    centring: Centring,
    weight: f64,
    /// The number of points per constraint.
    n: usize,
    /// The number of constraints; the last chunk is padded with copies of the last one.
    count: usize,
    /// Node indices, chunk by chunk, point by point, lane by lane.
    nodes: Vec<[u32; LANES]>,
    /// Centred and prepared rest points in the layout of `nodes`, if the operator reads them.
    rest: Vec<Vec3<Lanes>>,
    /// Previous projections in the layout of `nodes`, from the first guarded step on.
    previous: Vec<Vec3<Lanes>>,
    /// The projections before `previous`, for [`Batch::undo_step`].
    earlier: Vec<Vec3<Lanes>>,
    guarded: bool,
    /// Displacements to the projections in the layout of `nodes`, for [`Batch::projected`] only.
    displacements: Option<Vec<Vec3<Lanes>>>,
    /// Points of one chunk and their projections, for constraints too large for the stack.
    scratch: Vec<Vec3<Lanes>>,
}

/// The sums of a local step, in lanes.
struct Residuals {
    /// Squared distances of the points to their centred projections.
    squared: Lanes,
    /// The largest squared distance to the fitted shape.
    worst: Lanes,
}

impl Default for Residuals {
    fn default() -> Self {
        Residuals { squared: Lanes::zero(), worst: Lanes::zero() }
    }
}

/// A type-erased [`Projection`], so that code independent of the kind is compiled once.
trait Operator {
    /// See [`Projection::prepare`].
    fn prepare(&self, rest: &mut [Vec3<f64>]);
    /// Step I for one chunk; see [`Projection::project`].
    fn project(&self, rest: &[Vec3<Lanes>], v: &[Vec3<Lanes>], projected: &mut [Vec3<Lanes>]);
    /// See [`Projection::fitted`].
    fn fitted(&self, v: &[Vec3<f64>]) -> Option<Fitted>;
}

impl<P: Projection> Operator for P {
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        Projection::prepare(self, rest);
    }

    fn project(&self, rest: &[Vec3<Lanes>], v: &[Vec3<Lanes>], projected: &mut [Vec3<Lanes>]) {
        // Instances that the arity rules out are not compiled. Four points are special-cased for
        // kinds of panels, as most panels have four corners.
        let closed_form = match v.len() {
            2 if const { matches!(P::INFO.arity, Arity::Exactly(2)) } => closed_form_of_few::<P, 2>,
            3 if const { matches!(P::INFO.arity, Arity::Exactly(3)) } => closed_form_of_few::<P, 3>,
            4 if const { matches!(P::INFO.arity, Arity::Exactly(4)) } => closed_form_of_few::<P, 4>,
            5 if const { matches!(P::INFO.arity, Arity::Exactly(5)) } => closed_form_of_few::<P, 5>,
            4 if const { P::INFO.panels.is_some() } => closed_form_of_few::<P, 4>,
            _ if const { matches!(P::INFO.arity, Arity::AtLeast(_)) } => closed_form_of_many::<P>,
            n => unreachable!("{} takes {}, not {n}", P::INFO.id, P::INFO.arity_in_words()),
        };
        project_with(
            |rest, v, projected| closed_form(self, rest, v, projected),
            &|rest, v| self.project_robust(rest, v),
            (rest, v, projected),
        );
    }

    fn fitted(&self, v: &[Vec3<f64>]) -> Option<Fitted> {
        Projection::fitted(self, v)
    }
}

/// The closed form for a number of points known at compile time, which keeps them in registers.
// Separate functions: V8 switches a wasm function to optimised code only between calls, so hot
// kernels must be entered often.
#[inline(never)]
fn closed_form_of_few<P: Projection, const N: usize>(
    operator: &P,
    rest: &[Vec3<Lanes>],
    v: &[Vec3<Lanes>],
    projected: &mut [Vec3<Lanes>],
) -> bool {
    const SIZE: &str = "a chunk has the points of its constraints";
    let v: &[Vec3<Lanes>; N] = v.try_into().expect(SIZE);
    let projected: &mut [Vec3<Lanes>; N] = projected.try_into().expect(SIZE);
    if P::READS_REST {
        let rest: &[Vec3<Lanes>; N] = rest.try_into().expect(SIZE);
        operator.closed_form(rest, v, projected)
    } else {
        operator.closed_form(&[], v, projected)
    }
}

#[inline(never)]
fn closed_form_of_many<P: Projection>(
    operator: &P,
    rest: &[Vec3<Lanes>],
    v: &[Vec3<Lanes>],
    projected: &mut [Vec3<Lanes>],
) -> bool {
    operator.closed_form(rest, v, projected)
}

impl Batch {
    fn new(operator: Box<dyn Operator>, reads_rest: bool, make: MakeBatch<'_>) -> Self {
        let centring = make.centring;
        let n = make.members[0].len();
        let mut nodes = Vec::with_capacity(make.members.len().div_ceil(LANES) * n);
        for chunk in make.members.chunks(LANES) {
            let last = chunk.len() - 1;
            nodes.extend((0..n).map(|k| std::array::from_fn(|lane| chunk[lane.min(last)][k])));
        }
        let mut rest = Vec::new();
        if reads_rest {
            rest = nodes.iter().map(|point| Vec3::of_rows(make.rest, point)).collect();
            for chunk in rest.chunks_mut(n) {
                centre_as(centring, chunk);
                for lane in 0..LANES {
                    let mut own: Vec<_> = chunk.iter().map(|point| point.lane(lane)).collect();
                    operator.prepare(&mut own);
                    chunk.iter_mut().zip(own).for_each(|(to, from)| to.set_lane(lane, from));
                }
            }
        }
        Batch {
            operator,
            centring,
            weight: make.weight,
            n,
            count: make.members.len(),
            nodes,
            rest,
            previous: Vec::new(),
            earlier: Vec::new(),
            guarded: make.guarded,
            displacements: None,
            scratch: vec![Vec3::zero(); 2 * n],
        }
    }

    /// Runs the local step at positions `x` (`#nodes` rows): adds half the gradient of
    /// `scale * E_shape` to `gradient` (`#nodes` rows).
    ///
    /// The result does not depend on mean-centring: the set is closed under translation, so that
    /// the residual is centred with or without `N_i`. Only the normal matrix differs.
    pub fn local_step(&mut self, x: &[Row], gradient: &mut [Row], scale: f64) -> LocalStep {
        let scale = scale * self.weight;
        // One sum per lane, so that no chunk waits for a horizontal sum.
        let mut all = Residuals::default();
        let mut scratch = std::mem::take(&mut self.scratch);
        for chunk in 0..self.count.div_ceil(LANES) {
            let rows = (x, &mut *gradient);
            match self.n {
                3 => self.step_few::<3>(chunk, rows, scale, &mut all),
                4 => self.step_few::<4>(chunk, rows, scale, &mut all),
                _ => self.step_chunk(chunk, scratch.split_at_mut(self.n), rows, scale, &mut all),
            }
        }
        self.scratch = scratch;
        let Residuals { squared, worst } = all;
        let mut found = LocalStep::default();
        for lane in 0..LANES {
            found.energy += self.weight * squared.lane(lane);
            found.worst_squared = found.worst_squared.max(worst.lane(lane));
        }
        found
    }

    /// Calls `each` with the projection of every constraint at positions `x`: its nodes, and their
    /// displacements to the fitted shape. The energy uses the same projection, translated to the
    /// mean, but where a guard keeps the previous one.
    pub fn projected(&mut self, x: &[Row], each: &mut dyn FnMut(&Projected)) {
        self.displacements = Some(vec![Vec3::zero(); self.nodes.len()]);
        self.local_step(x, &mut vec![[0.0; 4]; x.len()], 0.0);
        let displacements = self.displacements.take().unwrap_or_default();
        let mut points = Vec::with_capacity(self.n);
        for i in 0..self.count {
            let (first, lane) = (i / LANES * self.n, i % LANES);
            let chunk = self.nodes[first..].iter().zip(&displacements[first..]).take(self.n);
            points.clear();
            points
                .extend(chunk.map(|(nodes, displacement)| (nodes[lane], displacement.lane(lane))));
            each(&points);
        }
    }

    /// Appends the shapes fitted to the constraints at positions `x`, for drawing. Omits shapes
    /// much larger than their points, which would cover the drawing.
    pub fn fitted(&self, x: &[Row], shapes: &mut Vec<Fitted>) {
        let mut points = vec![Vec3::zero(); self.n];
        for i in 0..self.count {
            let chunk = &self.nodes[i / LANES * self.n..][..self.n];
            for (point, nodes) in points.iter_mut().zip(chunk) {
                let row = x[nodes[i % LANES] as usize];
                *point = Vec3::new(row[0], row[1], row[2]);
            }
            let shape = self.operator.fitted(&points);
            shapes.extend(shape.filter(|shape| shape.is_of_the_size_of(&points)));
        }
    }

    /// Runs the local step of a chunk. `centred` and `projected` are scratch for `n` points each.
    #[inline(always)]
    fn step_chunk(
        &mut self,
        chunk: usize,
        (centred, projected): (&mut [Vec3<Lanes>], &mut [Vec3<Lanes>]),
        (x, gradient): (&[Row], &mut [Row]),
        scale: f64,
        all: &mut Residuals,
    ) {
        let n = centred.len();
        let first = chunk * n;
        for (point, nodes) in centred.iter_mut().zip(&self.nodes[first..first + n]) {
            *point = Vec3::of_rows(x, nodes);
        }
        centre_as(self.centring, centred);
        let rest = self.rest.get(first..first + n).unwrap_or_default();
        self.operator.project(rest, centred, projected);
        // Distances are to the fitted shape before it is re-centred.
        let mut worst = Lanes::zero();
        for (v, p) in centred.iter().zip(projected.iter()) {
            worst = worst.max((*v - *p).length_squared());
        }
        if self.displacements.is_some() {
            self.store_displacements(first, centred, projected);
        }
        // The set is closed under translation of points that are centred together, so the centred
        // projection is also in it, and nearer. Projections to circles and spheres are not centred.
        centre_as(self.centring, projected);
        if self.guarded {
            self.keep_nearer(first, centred, projected);
        }
        let counts = self.counts(chunk);
        let scale = counts * Lanes::splat(scale);
        let mut sum = Lanes::zero();
        let points = centred.iter().zip(projected.iter()).zip(&self.nodes[first..first + n]);
        for ((v, p), nodes) in points {
            let residual = *v - *p;
            sum += residual.length_squared();
            (residual * scale).add_to_rows(gradient, nodes);
        }
        all.squared += sum * counts;
        all.worst = all.worst.max(worst * counts);
    }

    /// [`Batch::step_chunk`] for `N` points.
    #[inline(never)]
    fn step_few<const N: usize>(
        &mut self,
        chunk: usize,
        rows: (&[Row], &mut [Row]),
        scale: f64,
        all: &mut Residuals,
    ) {
        let (mut centred, mut projected) = ([Vec3::zero(); N], [Vec3::zero(); N]);
        self.step_chunk(chunk, (&mut centred, &mut projected), rows, scale, all);
    }

    /// Stores the displacements to the projections of the chunk whose points start at `first`.
    #[cold]
    #[inline(never)]
    fn store_displacements(
        &mut self,
        first: usize,
        centred: &[Vec3<Lanes>],
        projected: &[Vec3<Lanes>],
    ) {
        let Some(displacements) = &mut self.displacements else { return };
        let displacements = &mut displacements[first..first + centred.len()];
        for ((displacement, v), p) in displacements.iter_mut().zip(centred).zip(projected) {
            *displacement = *p - *v;
        }
    }

    /// Whether its projections depend on those of the last local step.
    pub fn is_guarded(&self) -> bool {
        self.guarded
    }

    /// Undoes the last local step: its positions were rejected, and the guard needs the projections
    /// before.
    pub fn undo_step(&mut self) {
        std::mem::swap(&mut self.previous, &mut self.earlier);
    }

    /// Replaces the projections of the chunk whose points start at `first`, lane by lane, by the
    /// previous ones if these are nearer.
    fn keep_nearer(
        &mut self,
        first: usize,
        centred: &[Vec3<Lanes>],
        projected: &mut [Vec3<Lanes>],
    ) {
        if self.previous.len() < self.nodes.len() {
            self.previous.extend_from_slice(projected);
            self.earlier.extend_from_slice(projected);
            return;
        }
        let chunk = first..first + centred.len();
        let previous = &mut self.previous[chunk.clone()];
        self.earlier[chunk].copy_from_slice(previous);
        let (mut new, mut old) = (Lanes::zero(), Lanes::zero());
        for ((v, p), q) in centred.iter().zip(&*projected).zip(&*previous) {
            new += (*v - *p).length_squared();
            old += (*v - *q).length_squared();
        }
        for (p, q) in projected.iter_mut().zip(previous) {
            *p = Vec3::if_greater(new, old, *q, *p);
            *q = *p;
        }
    }
}

/// Applies `N_i`: subtracts the mean of the points that are centred together.
#[inline(always)]
fn centre_as(centring: Centring, points: &mut [Vec3<Lanes>]) {
    match centring {
        Centring::Together => {
            centre(points);
        }
        Centring::ByEdge => points.chunks_exact_mut(2).for_each(|ends| {
            centre(ends);
        }),
        Centring::Placed => {}
    }
}
