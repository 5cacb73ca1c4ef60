//! The map from the elements of a new mesh to those of the mesh that it was made from.

use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{Mesh, Point, Ragged};
use std::collections::BTreeSet;

/// A mesh made from another one, with the origins of its elements.
#[derive(Clone, Debug, PartialEq)]
pub struct Edited {
    /// The new mesh.
    pub mesh: Mesh,
    /// The origins of its elements.
    pub origins: Origins,
}

impl Edited {
    /// Returns the new vertices for another state of the old mesh: `from` are the old positions
    /// that this mesh was made from, `other` those of the other state; all are `#V by 3`.
    pub fn in_other_state(&self, from: &[Point], other: &[Point]) -> Vec<Point> {
        let combined = [from, other].map(|points| self.origins.positions.apply(points));
        let [from, mut other] = combined;
        for ((other, from), to) in other.iter_mut().zip(from).zip(&self.mesh.positions) {
            for axis in 0..3 {
                // Exact combinations of old vertices get no offset, so that no rounding is added.
                if to[axis] != from[axis] {
                    other[axis] += to[axis] - from[axis];
                }
            }
        }
        other
    }
}

/// Least area of a new face in the direction of the old one, as a fraction of the area of that.
const NO_AREA: f64 = 1e-9;

impl Edited {
    /// Counts the faces around a new vertex in a face that have no area, or face the other way than all
    /// faces that they were made from: `old`, at the positions of this mesh. There the vertex is not
    /// inside one of these.
    pub fn turned_over(&self, old: &Mesh) -> usize {
        let area = |mesh: &Mesh, face: &[u32]| {
            twice_vector_area(face.iter().map(|&v| Vec3::from(mesh.positions[v as usize])))
        };
        let before: Vec<Vec3<f64>> = old.faces.iter().map(|face| area(old, face)).collect();
        // A vertex that others were merged into is not the centre of a face.
        let merged: BTreeSet<u32> = self.origins.vertices.iter().flatten().copied().collect();
        let is_centre =
            |v: &u32| self.origins.between.row(*v as usize).len() > 2 && !merged.contains(v);
        let is_turned = |(face, parents): &(&[u32], &[u32])| {
            let is = area(&self.mesh, face);
            let is_against = |&parent: &u32| {
                let was = before[parent as usize];
                was != Vec3::zero() && is.dot(was) <= NO_AREA * was.length_squared()
            };
            !parents.is_empty() && face.iter().any(is_centre) && parents.iter().all(is_against)
        };
        self.mesh.faces.iter().zip(self.origins.faces.iter()).filter(is_turned).count()
    }
}

/// The origins of the elements of a mesh. Remaining old vertices come first, in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Origins {
    /// The new index of each old vertex: `None` if it was removed, the same for merged vertices.
    pub vertices: Vec<Option<u32>>,
    /// The position of each new vertex as an affine combination of old ones.
    pub positions: Combinations,
    /// The old vertices that each new vertex lies between, ascending: one for an old vertex or one that
    /// moves with it, two for a vertex on an old edge or on a diagonal that cuts a face into triangles,
    /// corners of a face for another vertex inside it.
    pub between: Ragged,
    /// The old faces that each new face is a part of or was made from; empty for a face that closes
    /// a hole.
    pub faces: Ragged,
}

impl Origins {
    pub(super) fn unchanged(mesh: &Mesh) -> Origins {
        let vertices = 0..mesh.positions.len() as u32;
        let mut positions = Combinations::default();
        vertices.clone().for_each(|v| positions.push(&[(v, 1.0)]));
        Origins {
            vertices: vertices.clone().map(Some).collect(),
            positions,
            between: vertices.map(|v| [v]).collect(),
            faces: (0..mesh.faces.len() as u32).map(|face| [face]).collect(),
        }
    }

    /// Gives the mesh `to`, made from `from`, what operations leave: the faces that are left as they are,
    /// unless it has them already, as long as their vertices are there, and which vertices are not in the
    /// file; and the statements of its file, which stand between elements, if all of these are still there.
    pub fn carry(&self, from: &Mesh, to: &mut Mesh) {
        let made_of = (0..).zip(self.between.iter());
        let unplaced = made_of.filter(|(_, olds)| olds.iter().any(|&old| from.is_unplaced(old)));
        to.unplaced = unplaced.map(|(new, _)| new).collect();
        let is_own = |(new, olds): (u32, &[u32])| *olds == [new];
        if self.faces.len() == from.faces.len()
            && (0..).zip(self.faces.iter()).all(is_own)
            && to.curves.len() == from.curves.len()
        {
            to.order = from.order.clone();
        }
        let turned = std::mem::take(&mut to.untouched);
        let rows = if turned.is_empty() { &from.untouched } else { &turned };
        for face in rows.iter() {
            let kept = face.iter().map(|&old| self.vertices[old as usize]);
            let Some(mut face) = kept.collect::<Option<Vec<u32>>>() else { continue };
            // Corners may have been merged.
            face.dedup();
            if face.first() == face.last() {
                face.pop();
            }
            if face.len() > 2 {
                to.untouched.push(&face);
            }
        }
    }

    /// Composes these origins with those of a following edit, `next`.
    pub(super) fn then(&self, next: &Origins) -> Origins {
        let union = |olds: &Ragged, row: &[u32]| {
            let olds = row.iter().flat_map(|&i| olds.row(i as usize));
            let mut olds: Vec<u32> = olds.copied().collect();
            olds.sort_unstable();
            olds.dedup();
            olds
        };
        let now = |v: &Option<u32>| v.and_then(|v| next.vertices[v as usize]);
        Origins {
            vertices: self.vertices.iter().map(now).collect(),
            positions: next.positions.of(&self.positions),
            between: next.between.iter().map(|row| union(&self.between, row)).collect(),
            faces: next.faces.iter().map(|row| union(&self.faces, row)).collect(),
        }
    }
}

/// Points as affine combinations of other points: weighted sums whose weights add up to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Combinations {
    /// `#points + 1`: point `i` has the terms `terms[offsets[i]..offsets[i + 1]]`.
    offsets: Vec<u32>,
    /// Index and weight of a point.
    terms: Vec<(u32, f64)>,
}

impl Combinations {
    /// Evaluates the combinations of `points`.
    pub fn apply(&self, points: &[Point]) -> Vec<Point> {
        let sum = |terms: &[(u32, f64)]| {
            // Relative to the first point: no digits are lost far from the origin, and points that
            // stay keep every bit.
            let base = points[terms[0].0 as usize];
            let mut sum = [0.0; 3];
            for &(point, weight) in &terms[1..] {
                for axis in 0..3 {
                    sum[axis] += weight * (points[point as usize][axis] - base[axis]);
                }
            }
            std::array::from_fn(|axis| base[axis] + sum[axis])
        };
        self.rows().map(sum).collect()
    }

    /// Returns the terms of each point, at least one.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[(u32, f64)]> {
        self.offsets.windows(2).map(|ends| &self.terms[ends[0] as usize..ends[1] as usize])
    }

    /// Expands combinations of points that are themselves combinations, `combined`.
    fn of(&self, combined: &Combinations) -> Combinations {
        let row = |place: u32| {
            let ends = [place, place + 1].map(|i| combined.offsets[i as usize] as usize);
            &combined.terms[ends[0]..ends[1]]
        };
        let (mut expanded, mut sum) = (Combinations::default(), Sum::default());
        for terms in self.rows() {
            for &(point, weight) in terms {
                row(point).iter().for_each(|&(old, part)| sum.add(old, weight * part));
            }
            expanded.push_sum(&mut sum);
        }
        expanded
    }

    /// Appends a point, as indices and weights of old points; the weights add up to 1.
    pub(super) fn push(&mut self, terms: &[(u32, f64)]) {
        self.terms.extend_from_slice(terms);
        self.offsets.push(self.terms.len() as u32);
    }

    /// Appends a sum, and empties it.
    pub(super) fn push_sum(&mut self, sum: &mut Sum) {
        self.push(&sum.terms);
        sum.terms.drain(..).for_each(|(point, _)| sum.places[point as usize] = 0);
    }
}

impl Default for Combinations {
    fn default() -> Self {
        Combinations { offsets: vec![0], terms: Vec::new() }
    }
}

/// A combination under construction.
#[derive(Default)]
pub(super) struct Sum {
    terms: Vec<(u32, f64)>,
    /// The number of the term of each point, from 1; 0 without one. All corners of a large face are in
    /// the sums of all its edges: to search the terms would take the cube of their number.
    places: Vec<u32>,
}

impl Sum {
    pub(super) fn add(&mut self, point: u32, weight: f64) {
        let own = point as usize;
        if self.places.len() <= own {
            self.places.resize(own + 1, 0);
        }
        match self.places[own] {
            0 => {
                self.terms.push((point, weight));
                self.places[own] = self.terms.len() as u32;
            }
            place => self.terms[place as usize - 1].1 += weight,
        }
    }
}
