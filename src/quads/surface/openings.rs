//! Openings too short for a line of panels around them, such as cracks and bolt holes: triangles are put
//! over them, and panels run across.

use super::chains::Chains;
use super::edges::Edges;
use super::input::InputSurface;
use super::slivers::remove_slivers;
use crate::math::{Vec3, ears_in_space, mean};
use crate::quads::{RemeshError, Side};
use std::borrow::Cow;

/// Boundary loops of fewer panels are covered, or the size is refused.
pub(in crate::quads) const SHORTEST_LOOP: f64 = 2.0;
/// An opening is covered only if the area vectors of the triangles around it add up to at least this
/// fraction of their areas: those around the end of a tube cancel.
const FLAT: f64 = 0.5;

/// An opening, by its boundary loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opening {
    /// Length around it, in the unit of the mesh.
    pub length: f64,
    /// The mean of its vertices.
    pub at: Vec3<f64>,
}

impl InputSurface {
    /// The surface with triangles over the openings that are less than `longest` around, as far as they
    /// can be covered, and these openings.
    ///
    /// # Errors
    /// If one that is less than `shortest` around cannot be covered: the end of a tube, or one around
    /// faces that stay. It is the shortest of these.
    pub(super) fn without_openings(
        &self,
        [shortest, longest]: [f64; 2],
    ) -> Result<(Cow<'_, InputSurface>, Vec<Opening>), RemeshError> {
        let edges = Edges::new(&self.triangles);
        let short = self.openings(&edges, longest);
        let flat = self.flat_around(&short);
        let mut triangles = self.triangles.clone();
        let (mut covered, mut open) = (Vec::new(), Vec::new());
        for ((opening, ring), flat) in short.into_iter().zip(flat) {
            let Some(cover) = self.cover(&edges, &ring).filter(|_| flat) else {
                open.push((opening, ring));
                continue;
            };
            triangles.extend(cover);
            covered.push(opening);
        }
        self.refuse(open, shortest)?;
        if covered.is_empty() {
            return Ok((Cow::Borrowed(self), covered));
        }
        remove_slivers(&self.positions, &mut triangles);
        let vertices = (&self.vertices[..], &self.at_staying[..]);
        let faces = self.faces.clone();
        let surface = InputSurface::of_part(&self.positions, triangles, faces, vertices);
        surface.refuse(surface.openings(&Edges::new(&surface.triangles), shortest), shortest)?;
        Ok((Cow::Owned(surface), covered))
    }

    /// Whether some openings of lengths from `shortest` to below `longest` can be covered.
    pub(in crate::quads) fn covers_more(&self, [shortest, longest]: [f64; 2]) -> bool {
        let found = self.without_openings([shortest, longest]);
        found.is_ok_and(|(_, covered)| covered.iter().any(|opening| opening.length >= shortest))
    }

    /// Refuses the shortest of these openings that is less than `shortest` around.
    fn refuse(
        &self,
        openings: Vec<(Opening, Vec<usize>)>,
        shortest: f64,
    ) -> Result<(), RemeshError> {
        let least = openings.into_iter().min_by(|a, b| a.0.length.total_cmp(&b.0.length));
        match least {
            Some((Opening { length, at }, ring)) if length < shortest => {
                let stays = ring.iter().any(|&v| self.at_staying[v]);
                Err(RemeshError::Opening { length, greatest: length / SHORTEST_LOOP, stays, at })
            }
            _ => Ok(()),
        }
    }

    /// The openings that are less than `longest` around, with their vertices: the surface is on the
    /// left of them in this order.
    fn openings(&self, edges: &Edges, longest: f64) -> Vec<(Opening, Vec<usize>)> {
        let is_boundary: Vec<bool> = edges.sides.iter().map(|sides| sides.len() == 1).collect();
        let chains = Chains::new(&self.positions, edges, &is_boundary);
        let short = chains.all().filter(|(length, _)| *length < longest);
        let opening = |(length, vertices): (f64, &[usize])| {
            let at = mean(vertices.iter().map(|&v| self.positions[v]));
            let mut ring = vertices.to_vec();
            let ends = [ring[0].min(ring[1]), ring[0].max(ring[1])];
            let Side { triangle, side } = edges.sides[edges.ends.binary_search(&ends).ok()?][0];
            if self.triangles[triangle][side] != ring[0] {
                ring.reverse();
            }
            Some((Opening { length, at }, ring))
        };
        short.filter_map(opening).collect()
    }

    /// Whether the surface is flat around each opening.
    fn flat_around(&self, openings: &[(Opening, Vec<usize>)]) -> Vec<bool> {
        let mut of_vertex = vec![None; self.positions.len()];
        for (k, (_, ring)) in openings.iter().enumerate() {
            ring.iter().for_each(|&v| of_vertex[v] = Some(k));
        }
        let mut sums = vec![(Vec3::zero(), 0.0); openings.len()];
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|v| self.positions[v]);
            let area = (b - a).cross(c - a);
            for k in triangle.iter().filter_map(|&v| of_vertex[v]) {
                sums[k] = (sums[k].0 + area, sums[k].1 + area.length());
            }
        }
        sums.into_iter().map(|(sum, areas)| sum.length() >= FLAT * areas).collect()
    }

    /// Triangles over an opening; none if faces that stay are in it, or if they would need an edge that is
    /// there.
    fn cover(&self, edges: &Edges, ring: &[usize]) -> Option<Vec<[usize; 3]>> {
        if ring.iter().any(|&v| self.at_staying[v]) {
            return None;
        }
        // Seen from the side of the surface, the opening is on the right of its ring.
        let turned: Vec<usize> = ring.iter().rev().copied().collect();
        let corners: Vec<Vec3<f64>> = turned.iter().map(|&v| self.positions[v]).collect();
        let n = ring.len();
        let ears = ears_in_space(&corners);
        let is_new = |&[i, j]: &[usize; 2]| {
            let ends = [turned[i].min(turned[j]), turned[i].max(turned[j])];
            (i + 1) % n == j || (j + 1) % n == i || edges.ends.binary_search(&ends).is_err()
        };
        let sides = ears.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let fits = n >= 3 && sides.into_iter().all(|side| is_new(&side));
        fits.then(|| ears.iter().map(|ear| ear.map(|k| turned[k])).collect())
    }
}
