//! Facets placed in the plane, piece by piece.

use super::facet::{Facet, FacetSide, Joint};
use super::plane::Motion;
use crate::fabricate::boxes::{Boxes, Corners};
use crate::fabricate::panel::direction_of;
use crate::math::plane::{Point2, bounds, dot, minus};
use crate::math::polygon_sides;

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
    /// The boxes of the facets of each piece, in its plane.
    pub(super) boxes: Vec<Boxes>,
    /// For each side of each facet the next one along the outline of its piece, counterclockwise, and the
    /// one before it. Those of folded sides are where they were in the outline when they left it.
    around: Vec<Vec<[FacetSide; 2]>>,
    /// Points of each piece that span its convex hull.
    pub(super) hulls: Vec<Vec<Point2>>,
    /// Whether facets are cut back, so that sides have other ends than their hinges.
    pub(super) is_cut_back: bool,
    /// The piece of each facet.
    pub piece_of: Vec<u32>,
    /// The facets of each piece; empty if it was merged into another.
    pub pieces: Vec<Vec<u32>>,
}

impl PaperNet {
    /// Makes each facet a piece of its own.
    pub(super) fn new(facets: Vec<Facet>, joints: Vec<Joint>) -> PaperNet {
        let n = facets.len();
        let around = facets.iter().zip(0..).map(|(own, facet)| {
            let n = own.corners.len() as u32;
            let side = |side: u32| (facet, side % n);
            (0..n).map(|k| [side(k + 1), side(k + n - 1)]).collect()
        });
        let only = |(own, f): (&Facet, u32)| {
            let mut boxes = Boxes::default();
            boxes.insert(f, bounds(own.corners.iter().copied()));
            boxes
        };
        let is_cut_back = |own: &Facet| !polygon_sides(&own.corners).eq(own.hinges.iter().copied());
        PaperNet {
            is_cut_back: facets.iter().any(is_cut_back),
            folded: vec![false; joints.len()],
            boxes: facets.iter().zip(0..).map(only).collect(),
            around: around.collect(),
            hulls: facets.iter().map(|facet| facet.corners.clone()).collect(),
            places: vec![Motion { turn: [1.0, 0.0], shift: [0.0; 2] }; n],
            piece_of: (0..n as u32).collect(),
            pieces: (0..n as u32).map(|f| vec![f]).collect(),
            facets,
            joints,
        }
    }

    /// The corners of a facet in its piece.
    pub fn corners(&self, f: u32) -> Vec<Point2> {
        let place = self.places[f as usize];
        self.facets[f as usize].corners.iter().map(|&p| place.put(p)).collect()
    }

    /// The ends of a side in its piece.
    pub fn ends(&self, (f, k): FacetSide) -> [Point2; 2] {
        let own = &self.facets[f as usize].corners;
        let place = self.places[f as usize];
        [k as usize, (k as usize + 1) % own.len()].map(|k| place.put(own[k]))
    }

    /// The hinge of a side in its piece.
    pub fn hinge(&self, (f, k): FacetSide) -> [Point2; 2] {
        let place = self.places[f as usize];
        self.facets[f as usize].hinges[k as usize].map(|end| place.put(end))
    }

    /// The line of a fold along a side: what is common to it and the side beyond it.
    pub fn fold_line(&self, side: FacetSide) -> [Point2; 2] {
        let [p, q] = self.ends(side);
        let Some((_, there)) = self.across(side).filter(|_| self.is_cut_back) else {
            return [p, q];
        };
        let other = self.ends(there);
        let along = direction_of(p, q);
        let at = |point: Point2| dot(minus(point, p), along);
        let from = at(other[1]).max(0.0);
        let to = at(other[0]).min(at(q)).max(from);
        [from, to].map(|far| [p[0] + far * along[0], p[1] + far * along[1]])
    }

    /// The convex polygons of a facet in its piece.
    pub(super) fn convex(&self, f: u32) -> impl Iterator<Item = Vec<Point2>> {
        let place = self.places[f as usize];
        let convex = self.facets[f as usize].convex.iter();
        convex.map(move |own| own.iter().map(|&p| place.put(p)).collect())
    }

    /// The convex polygons of the facets of a piece whose boxes meet this one.
    pub(super) fn near(&self, piece: u32, place: Corners) -> Vec<Vec<Point2>> {
        self.boxes[piece as usize].meeting(place).flat_map(|f| self.convex(f)).collect()
    }

    /// The joint of a side, and the side beyond it.
    pub fn across(&self, own: FacetSide) -> Option<(u32, FacetSide)> {
        let joint = self.facets[own.0 as usize].joints[own.1 as usize]?;
        let [a, b] = self.joints[joint as usize].sides;
        Some((joint, if a == own { b } else { a }))
    }

    /// The sides after and before a side on the outline of its piece, counterclockwise.
    pub(super) fn beside(&self, (facet, side): FacetSide) -> [FacetSide; 2] {
        self.around[facet as usize][side as usize]
    }

    /// Takes the two sides of a folded joint out of the outline. What was before each is then before
    /// what was after the other.
    pub(super) fn unlink(&mut self, [a, b]: [FacetSide; 2]) {
        let ([after_a, before_a], [after_b, before_b]) = (self.beside(a), self.beside(b));
        self.link(before_a, after_b);
        self.link(before_b, after_a);
    }

    /// Undoes [`PaperNet::unlink`], if nothing that came later is left.
    pub(super) fn relink(&mut self, [a, b]: [FacetSide; 2]) {
        for own in [a, b] {
            let [after, before] = self.beside(own);
            self.link(before, own);
            self.link(own, after);
        }
    }

    fn link(&mut self, before: FacetSide, after: FacetSide) {
        self.around[before.0 as usize][before.1 as usize][0] = after;
        self.around[after.0 as usize][after.1 as usize][1] = before;
    }

    /// The corners of all facets that hang together at the end of a side of the outline, in order, up to
    /// that of the next side.
    pub(super) fn corners_after(&self, side: FacetSide) -> Vec<Point2> {
        let after = |(f, k): FacetSide| (f, (k + 1) % self.facets[f as usize].corners.len() as u32);
        let beyond = |own: &FacetSide| {
            let (joint, there) = self.across(*own)?;
            self.folded[joint as usize].then(|| after(there))
        };
        let around = std::iter::successors(Some(after(side)), beyond);
        around.map(|own| self.ends(own)[0]).collect()
    }

    /// The outline of a piece, counterclockwise: one closed line.
    pub fn outline(&self, piece: u32) -> Vec<FacetSide> {
        let is_open = |(facet, side): &FacetSide| {
            let joint = self.facets[*facet as usize].joints[*side as usize];
            joint.is_none_or(|joint| !self.folded[joint as usize])
        };
        let sides = |&facet: &u32| {
            let count = self.facets[facet as usize].corners.len() as u32;
            (0..count).map(move |side| (facet, side))
        };
        let first = self.pieces[piece as usize].iter().flat_map(sides).find(is_open);
        let after =
            |own: &FacetSide| Some(self.beside(*own)[0]).filter(|next| Some(*next) != first);
        std::iter::successors(first, after).collect()
    }
}
