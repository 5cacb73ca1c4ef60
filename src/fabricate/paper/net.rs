//! Facets placed in the plane, piece by piece.

use super::facet::{Facet, Joint};
use super::plane::Motion;
use crate::math::plane::{Point2, bounds};

/// A side of the outline of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutlineSide {
    /// The facet.
    pub facet: u32,
    /// Its side.
    pub side: u32,
}

/// All pieces of a paper model.
#[derive(Clone, Debug)]
pub struct PaperNet {
    /// The facets.
    pub facets: Vec<Facet>,
    /// The joints between them.
    pub joints: Vec<Joint>,
    /// Whether each joint is folded; the others are glued.
    pub folded: Vec<bool>,
    /// The position of each facet in the plane of its piece.
    pub places: Vec<Motion>,
    /// The box of each facet in the plane of its piece.
    pub(super) boxes: Vec<[Point2; 2]>,
    /// Points of each piece that span its convex hull.
    pub(super) hulls: Vec<Vec<Point2>>,
    /// The piece of each facet.
    pub piece_of: Vec<u32>,
    /// The facets of each piece; empty if it was merged into another.
    pub pieces: Vec<Vec<u32>>,
}

impl PaperNet {
    /// Makes each facet a piece of its own.
    pub(super) fn new(facets: Vec<Facet>, joints: Vec<Joint>) -> PaperNet {
        let n = facets.len();
        PaperNet {
            folded: vec![false; joints.len()],
            boxes: facets.iter().map(|facet| bounds(facet.corners.iter().copied())).collect(),
            hulls: facets.iter().map(|facet| facet.corners.clone()).collect(),
            places: vec![Motion { turn: [1.0, 0.0], shift: [0.0; 2] }; n],
            piece_of: (0..n as u32).collect(),
            pieces: (0..n as u32).map(|f| vec![f]).collect(),
            facets,
            joints,
        }
    }

    /// Moves a facet to another place.
    pub(super) fn put(&mut self, f: u32, place: Motion) {
        self.places[f as usize] = place;
        self.boxes[f as usize] = bounds(self.corners(f));
    }

    /// The corners of a facet in its piece.
    pub fn corners(&self, f: u32) -> Vec<Point2> {
        let place = self.places[f as usize];
        self.facets[f as usize].corners.iter().map(|&p| place.put(p)).collect()
    }

    /// The ends of a side in its piece.
    pub fn ends(&self, (f, k): (u32, u32)) -> [Point2; 2] {
        let own = &self.facets[f as usize].corners;
        let place = self.places[f as usize];
        [k as usize, (k as usize + 1) % own.len()].map(|k| place.put(own[k]))
    }

    /// The convex polygons of a piece.
    pub(super) fn convex(&self, piece: u32) -> Vec<Vec<Point2>> {
        self.convex_of(&self.pieces[piece as usize])
    }

    /// The convex polygons of some facets.
    pub(super) fn convex_of<'a>(
        &self,
        facets: impl IntoIterator<Item = &'a u32>,
    ) -> Vec<Vec<Point2>> {
        let of_facet = |&f: &u32| {
            let place = self.places[f as usize];
            let convex = self.facets[f as usize].convex.iter();
            convex.map(move |own| own.iter().map(|&p| place.put(p)).collect())
        };
        facets.into_iter().flat_map(of_facet).collect()
    }

    /// The joint of a side, and the side beyond it.
    pub fn across(&self, own: (u32, u32)) -> Option<(u32, (u32, u32))> {
        let joint = self.facets[own.0 as usize].joints[own.1 as usize]?;
        let [a, b] = self.joints[joint as usize].sides;
        Some((joint, if a == own { b } else { a }))
    }

    /// The outline of a piece, counterclockwise; none if it is not one closed line.
    pub fn outline(&self, piece: u32) -> Option<Vec<OutlineSide>> {
        let is_open = |f: u32, k: u32| {
            self.facets[f as usize].joints[k as usize].is_none_or(|j| !self.folded[j as usize])
        };
        let sides = |f: u32| self.facets[f as usize].corners.len() as u32;
        let own = &self.pieces[piece as usize];
        let count: usize =
            own.iter().map(|&f| (0..sides(f)).filter(|&k| is_open(f, k)).count()).sum();
        let first = own.iter().find_map(|&f| Some((f, (0..sides(f)).find(|&k| is_open(f, k))?)))?;
        let (mut f, mut k) = first;
        let mut outline = Vec::with_capacity(count);
        loop {
            outline.push(OutlineSide { facet: f, side: k });
            k = (k + 1) % sides(f);
            while !is_open(f, k) {
                let (_, (g, i)) = self.across((f, k))?;
                (f, k) = (g, (i + 1) % sides(g));
            }
            if (f, k) == first {
                break;
            }
            if outline.len() == count {
                return None;
            }
        }
        (outline.len() == count).then_some(outline)
    }
}
