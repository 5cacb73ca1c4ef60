//! Access to single constraints of a batch, for solvers that shift points before projecting them,
//! or project displaced copies.

use super::{Batch, centre_as};
use crate::constraint::{Centring, Row};
use crate::math::{LANES, Lane, Lanes, Vec3};

impl Batch {
    /// The number of points of each constraint.
    pub fn points(&self) -> usize {
        self.n
    }

    /// The number of constraints.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The weight `w_i`, the same for all constraints.
    pub fn weight(&self) -> f64 {
        self.weight
    }

    /// One in the lanes of a chunk that hold constraints, zero in the padding of the last one.
    #[inline(always)]
    pub fn counts(&self, chunk: usize) -> Lanes {
        let lanes = self.count - chunk * LANES;
        if lanes >= LANES {
            return Lanes::one();
        }
        Lanes::from_fn(|lane| f64::from(u8::from(lane < lanes)))
    }

    /// The points that are centred together.
    pub fn centring(&self) -> Centring {
        self.centring
    }

    /// The nodes of all constraints, chunk by chunk, point by point, one per lane. The last chunk
    /// is padded with copies of the last constraint.
    pub fn nodes(&self) -> &[[u32; LANES]] {
        &self.nodes
    }

    /// The nodes of constraint `i`.
    pub fn nodes_of(&self, i: usize) -> impl ExactSizeIterator<Item = u32> {
        self.nodes[i / LANES * self.n..][..self.n].iter().map(move |nodes| nodes[i % LANES])
    }

    /// Writes the centred points of chunk `chunk` at positions `x` to `points`.
    #[inline(always)]
    pub fn gather(&self, chunk: usize, x: &[Row], points: &mut [Vec3<Lanes>]) {
        let nodes = &self.nodes[chunk * self.n..][..points.len()];
        for (point, nodes) in points.iter_mut().zip(nodes) {
            *point = Vec3::of_rows(x, nodes);
        }
        self.centre(points);
    }

    /// Applies `N_i`: subtracts the mean of the points that are centred together.
    #[inline(always)]
    pub fn centre(&self, points: &mut [Vec3<Lanes>]) {
        centre_as(self.centring, points);
    }

    /// Projects chunk `chunk`, whose centred points are `v`. The result is not centred.
    #[inline(always)]
    pub fn project(&self, chunk: usize, v: &[Vec3<Lanes>], projected: &mut [Vec3<Lanes>]) {
        let rest = self.rest.get(chunk * self.n..).unwrap_or_default();
        self.operator.project(&rest[..rest.len().min(self.n)], v, projected);
    }

    /// The rest points of constraint `i` in every lane, for [`Batch::project_copies`].
    pub fn rest_of(&self, i: usize) -> Vec<Vec3<Lanes>> {
        let rest = self.rest.iter().skip(i / LANES * self.n).take(self.n);
        rest.map(|point| Vec3::splat(point.lane(i % LANES))).collect()
    }

    /// Projects copies of one constraint, one per lane, with centred points `v`.
    pub fn project_copies(
        &self,
        rest: &[Vec3<Lanes>],
        v: &[Vec3<Lanes>],
        projected: &mut [Vec3<Lanes>],
    ) {
        self.operator.project(rest, v, projected);
    }
}
