//! Tongues and slots: cut joints that hold without glue.
//!
//! One panel of the joint goes on beyond the edge as a flange, which has the shape of a tab for glue and is
//! folded as the edge is, so that it lies behind the other panel. That panel has a tongue on the edge, which
//! is folded likewise and lies behind the first panel. To get there it passes between that panel and its
//! flange, through a slot in the flange along the fold. Both panels are then held: the flange keeps the
//! second one from moving inwards, and the tongue keeps it from moving outwards.
//!
//! To join them, fold flange and tongue, hold the panels nearly as they will be, with the flange inside, and
//! push the tongue from outside into the slot until both edges meet.
//!
//! The slot is cut from the flange alone, from the fold on: panels stay whole, and what is seen from outside
//! is the edge. It is as wide as the tongue is thick and as long as the tongue is wide, both with the
//! clearance on each side, but never narrower than a closed line can be cut. Flange and tongue lie
//! behind one facet each, clear of its other sides and of all else on their piece, as tabs do
//! ([`super::tab`]).

use super::facet::FacetSide;
use super::net::PaperNet;
use super::tab::{Tab, tab};
use crate::fabricate::panel::direction_of;
use crate::math::plane::{Point2, distance, dot, minus};

/// Width of a tongue as a fraction of the edge, and the greatest in mm.
const OF_EDGE: f64 = 1.0 / 3.0;
const WIDEST: f64 = 25.0;
/// The narrowest tongue and the shortest, in mm and in thicknesses, whichever is more.
const NARROWEST: [f64; 2] = [5.0, 4.0];
const SHORTEST: [f64; 2] = [3.0, 3.0];
/// What is left around a slot, in mm and in thicknesses, whichever is more.
const AROUND: [f64; 2] = [2.0, 2.0];
/// Least distance between the two cuts along a slot, in mm: closer lines are one cut.
const BETWEEN: f64 = 0.1;
/// Bevel of the corners of a tongue, as a fraction of its length: it finds its slot.
const BEVEL: f64 = 1.0 / 3.0;

/// What a tongue and its slot are made for, in mm.
#[derive(Clone, Copy, Debug)]
pub struct Fit {
    /// The thickness of the material.
    pub thickness: f64,
    /// The play on each side of a tongue.
    pub clearance: f64,
    /// The width of the cut.
    pub kerf: f64,
}

impl Fit {
    /// The width of slots.
    fn width(self) -> f64 {
        (self.thickness + 2.0 * self.clearance).max(self.kerf + BETWEEN)
    }

    fn least(self, [of_any, of_thick]: [f64; 2]) -> f64 {
        of_any.max(of_thick * self.thickness)
    }
}

/// A tongue and its slot. Positions along a side are in mm from its start, as the piece is laid.
#[derive(Clone, Copy, Debug)]
pub struct Tongue {
    /// Its number among all, from 1.
    pub number: u32,
    /// The flange with the slot.
    pub flange: Tab,
    /// Where the slot begins and ends along the side of the flange.
    pub slot: [f64; 2],
    /// The width of the slot, from the fold outwards.
    pub width: f64,
    /// The side with the tongue.
    pub side: FacetSide,
    /// Where the tongue begins and ends along its side.
    pub root: [f64; 2],
    /// The length of the tongue, away from its side.
    pub length: f64,
}

/// A side as an axis, with what is outside it at positive heights.
struct Axis {
    start: Point2,
    along: Point2,
    length: f64,
}

impl Axis {
    fn new([p, q]: [Point2; 2]) -> Axis {
        Axis { start: p, along: direction_of(p, q), length: distance(p, q) }
    }

    fn at(&self, [along, outwards]: Point2) -> Point2 {
        let [c, s] = self.along;
        [self.start[0] + along * c + outwards * s, self.start[1] + along * s - outwards * c]
    }

    /// The way along the side per height of both slanted sides of a tab, from either end inwards.
    fn slopes(&self, tab: &Tab) -> [f64; 2] {
        let along = |point: Point2| dot(minus(point, self.start), self.along);
        let [_, a, b, _] = tab.corners;
        [along(a) / tab.height, (self.length - along(b)) / tab.height]
    }

    /// A trapezium of this height, counterclockwise: its ends on the side, and those away from it.
    fn trapezium(&self, [p, q]: [f64; 2], [a, b]: [f64; 2], height: f64) -> [Point2; 4] {
        [[p, 0.0], [a, height], [b, height], [q, 0.0]].map(|point| self.at(point))
    }
}

impl Tongue {
    /// The name at the tongue and at the slot.
    pub fn name(&self) -> String {
        format!("T{}", self.number)
    }

    /// The slot as it is cut with this kerf, on the piece of the flange: counterclockwise, first along it.
    pub fn slot_corners(&self, net: &PaperNet, kerf: f64) -> Vec<Point2> {
        let axis = Axis::new(net.ends(self.flange.side));
        let half = 0.5 * kerf;
        let ([from, to], [low, high]) =
            ([self.slot[0] + half, self.slot[1] - half], [half, self.width - half]);
        [[from, high], [to, high], [to, low], [from, low]].map(|point| axis.at(point)).into()
    }

    /// The corners of the tongue on its piece, counterclockwise, from the start of its root to its end.
    pub fn corners(&self, net: &PaperNet) -> [Point2; 6] {
        let axis = Axis::new(net.ends(self.side));
        let ([from, to], bevel) = (self.root, self.bevel());
        [
            [from, 0.0],
            [from, self.length - bevel],
            [from + bevel, self.length],
            [to - bevel, self.length],
            [to, self.length - bevel],
            [to, 0.0],
        ]
        .map(|point| axis.at(point))
    }

    fn bevel(&self) -> f64 {
        BEVEL * self.length.min(self.root[1] - self.root[0])
    }

    /// What of its folds is scored on a piece: the fold of the flange beside the slot, or that of the
    /// tongue.
    pub fn scores(&self, net: &PaperNet, side: FacetSide) -> Vec<[Point2; 2]> {
        let axis = Axis::new(net.ends(side));
        let line = |[from, to]: [f64; 2]| [from, to].map(|along| axis.at([along, 0.0]));
        if side == self.side {
            return vec![line(self.root)];
        }
        let [from, to] = self.slot;
        vec![line([0.0, from]), line([to, axis.length])]
    }

    /// The trapezium around the tongue that its side keeps free.
    fn envelope(&self, net: &PaperNet) -> [Point2; 4] {
        let axis = Axis::new(net.ends(self.side));
        axis.trapezium([0.0, axis.length], self.root, self.length)
    }

    /// The trapezia that it takes on a piece: of the flange and around the tongue.
    pub(super) fn taken(&self, net: &PaperNet, piece: u32) -> impl Iterator<Item = [Point2; 4]> {
        let own = [(self.flange.side, self.flange.corners), (self.side, self.envelope(net))];
        let of = own.map(|((f, _), corners)| (net.piece_of[f as usize], corners));
        of.into_iter().filter(move |(of, _)| *of == piece).map(|(_, corners)| corners)
    }

    /// Where the name is written at a side: on the flange beyond the slot, or on the tongue, as a tab
    /// without what is beside it.
    pub(super) fn name_place(&self, net: &PaperNet, side: FacetSide) -> Tab {
        let axis = Axis::new(net.ends(side));
        if side == self.side {
            let ([from, to], bevel) = (self.root, self.bevel());
            let corners = axis.trapezium([from, to], [from + bevel, to - bevel], self.length);
            return Tab { side, corners, height: self.length };
        }
        let ([left, right], height) = (axis.slopes(&self.flange), self.flange.height);
        let at = |height: f64| [left * height, axis.length - right * height];
        let [a, b] = [self.width, height].map(at);
        let corners = [[a[0], self.width], [b[0], height], [b[1], height], [a[1], self.width]];
        let corners = corners.map(|point| axis.at(point));
        Tab { side, corners, height: height - self.width }
    }
}

/// A tongue and its slot on the sides of a joint, the flange on the first and the tongue on the second, of
/// at most `most` mm away from the edge, that keep clear of what is `taken` on the piece of either side.
/// None without room for them.
pub(super) fn tongue(
    net: &PaperNet,
    [flange_side, side]: [FacetSide; 2],
    [taken, taken_there]: [&[[Point2; 4]]; 2],
    most: f64,
    fit: Fit,
) -> Option<Tongue> {
    let width = fit.width();
    let around = fit.least(AROUND);
    let flange = tab(net, flange_side, taken, most)?;
    if flange.height < width + around {
        return None;
    }
    let of_piece = |(f, _): FacetSide| net.piece_of[f as usize];
    let mut taken_there = taken_there.to_vec();
    if of_piece(side) == of_piece(flange_side) {
        taken_there.push(flange.corners);
    }
    let room = tab(net, side, &taken_there, most)?;
    let shortest = fit.least(SHORTEST).max(width + fit.thickness);
    if room.height < shortest {
        return None;
    }
    let (axis, there) = (Axis::new(net.ends(flange_side)), Axis::new(net.ends(side)));
    let (of_flange, of_room) = (axis.slopes(&flange), there.slopes(&room));
    // Along the side of the flange: the one with the tongue runs the other way.
    let least = |k: usize| {
        let beside_flange = (of_flange[k] * width).max(0.0) + around + fit.clearance;
        beside_flange.max(of_room[1 - k] * shortest)
    };
    let [from, to] = [least(0), axis.length - least(1)];
    let wide = (OF_EDGE * axis.length).min(WIDEST).max(fit.least(NARROWEST)).min(to - from);
    if wide < fit.least(NARROWEST) {
        return None;
    }
    let middle = (0.5 * axis.length).clamp(from + 0.5 * wide, to - 0.5 * wide);
    let [from, to] = [middle - 0.5 * wide, middle + 0.5 * wide];
    // In the middle of both sides, of which rounding has one longer.
    let spare = 0.5 * (there.length - axis.length);
    let root = [to, from].map(|along| axis.length - along + spare);
    let up_to = |along: f64, slope: f64| if slope > 0.0 { along / slope } else { f64::INFINITY };
    let length =
        room.height.min(up_to(root[0], of_room[0])).min(up_to(there.length - root[1], of_room[1]));
    let slot = [from - fit.clearance, to + fit.clearance];
    Some(Tongue { number: 0, flange, slot, width, side, root, length })
}
