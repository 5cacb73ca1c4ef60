//! Growth of pieces: folding a joint merges two pieces if they fit on the sheet together, do not
//! overlap, and leave room for the tabs of the edges that stay open between them.

use super::facet::{FacetSide, Joint};
use super::net::PaperNet;
use super::plane::{Motion, is_same_corner, overlaps, reach};
use super::tab::tab;
use crate::fabricate::panel::{hull, smallest_box};
use crate::math::plane::{Point2, bounds, distance};

/// The least length of an edge that holds two pieces together, in mm: a shorter one tears.
const LEAST_HINGE: f64 = 0.5;

impl PaperNet {
    /// Folds a joint if possible: the pieces on its two sides become one. `room` is the largest
    /// size of a piece without its tabs, which are up to `tab_height` high.
    pub(super) fn fold(&mut self, joint: u32, room: [f64; 2], tab_height: f64) -> bool {
        let Joint { sides: [mut still, mut moving], is_hinge, .. } = self.joints[joint as usize];
        if !is_hinge || self.piece_of[still.0 as usize] == self.piece_of[moving.0 as usize] {
            return false;
        }
        let size = |net: &PaperNet, side: FacetSide| {
            net.pieces[net.piece_of[side.0 as usize] as usize].len()
        };
        if size(self, still) < size(self, moving) {
            (still, moving) = (moving, still);
        }
        let [a, b] = [still, moving].map(|side| self.piece_of[side.0 as usize]);
        let [p, q] = self.hinge(still);
        let motion = Motion::between(self.hinge(moving), [q, p]);
        let moved = self.pieces[b as usize].clone();
        let before: Vec<Motion> = moved.iter().map(|&f| self.places[f as usize]).collect();
        for &f in &moved {
            self.places[f as usize] = motion.after(&self.places[f as usize]);
        }
        let welded = self.welded(joint, &moved, a);
        let corners = moved.iter().flat_map(|&f| self.corners(f));
        let both = hull(&self.hulls[a as usize].iter().copied().chain(corners).collect::<Vec<_>>());
        let [from, to] = self.fold_line(still);
        let is_held = distance(from, to) >= LEAST_HINGE;
        let mut is_good = is_held && fits(&both, room) && !self.overlap(a, &moved);
        if is_good {
            welded.iter().for_each(|&j| self.folded[j as usize] = true);
            let unlinked = self.close_outline(joint);
            for &f in &moved {
                self.piece_of[f as usize] = a;
                let around = bounds(self.corners(f));
                self.boxes[a as usize].insert(f, around);
            }
            // What is folded elsewhere leaves a hole in the piece.
            is_good = unlinked.len() == welded.len() && self.has_room_for_tabs(&moved, tab_height);
            if is_good {
                self.hulls[a as usize] = both;
                self.pieces[a as usize].extend(&moved);
                self.pieces[b as usize].clear();
            } else {
                unlinked.into_iter().rev().for_each(|sides| self.relink(sides));
                for &f in &moved {
                    self.piece_of[f as usize] = b;
                    let around = bounds(self.corners(f));
                    self.boxes[a as usize].remove(f, around);
                }
                welded.iter().for_each(|&j| self.folded[j as usize] = false);
            }
        }
        if !is_good {
            moved.iter().zip(before).for_each(|(&f, place)| self.places[f as usize] = place);
        }
        is_good
    }

    /// Takes the sides of a folded joint out of the outline of its two pieces, which becomes one, and
    /// then those of folded joints which meet at its ends. Returns them in order, without the last if
    /// nothing of the outline would be left.
    fn close_outline(&mut self, joint: u32) -> Vec<[FacetSide; 2]> {
        let first = self.joints[joint as usize].sides;
        let mut closed = vec![first];
        self.unlink(first);
        for [a, b] in [first, [first[1], first[0]]] {
            let (mut before, mut after) = (self.beside(a)[1], self.beside(b)[0]);
            while let Some((joint, there)) = self.across(before)
                && there == after
                && self.folded[joint as usize]
                && self.beside(before)[1] != after
            {
                closed.push([before, after]);
                let next = (self.beside(before)[1], self.beside(after)[0]);
                self.unlink([before, after]);
                (before, after) = next;
            }
        }
        closed
    }

    /// The joint, and all others between the moved facets and the piece whose two sides coincide.
    fn welded(&self, joint: u32, moved: &[u32], piece: u32) -> Vec<u32> {
        let mut found = vec![joint];
        for &f in moved {
            for k in 0..self.facets[f as usize].corners.len() as u32 {
                let Some((other, there)) = self.across((f, k)) else { continue };
                if other == joint || self.piece_of[there.0 as usize] != piece {
                    continue;
                }
                let ([p, q], [r, s]) = (self.hinge((f, k)), self.hinge(there));
                let is_hinge = self.joints[other as usize].is_hinge;
                if is_hinge && is_same_corner(p, s) && is_same_corner(q, r) {
                    found.push(other);
                }
            }
        }
        found
    }

    /// Whether moved facets overlap a piece.
    fn overlap(&self, piece: u32, moved: &[u32]) -> bool {
        moved.iter().any(|&f| {
            let near = self.near(piece, reach(bounds(self.corners(f)), 0.0));
            !near.is_empty()
                && self
                    .convex(f)
                    .any(|own| near.iter().any(|p| overlaps(p, &own, !self.is_cut_back)))
        })
    }

    /// Whether every cut edge of moved facets with both sides on their piece has room for a tab on one
    /// of them.
    fn has_room_for_tabs(&self, moved: &[u32], tab_height: f64) -> bool {
        let sides =
            |&f: &u32| (0..self.facets[f as usize].corners.len() as u32).map(move |k| (f, k));
        tab_height <= 0.0
            || moved.iter().flat_map(sides).all(|own| {
                let Some((joint, there)) = self.across(own) else { return true };
                let is_cut = !self.folded[joint as usize]
                    && self.piece_of[there.0 as usize] == self.piece_of[own.0 as usize];
                !is_cut
                    || [own, there]
                        .into_iter()
                        .any(|side| tab(self, side, &[], tab_height).is_some())
            })
    }
}

/// Whether the smallest box around these points is at most as large as `room`.
fn fits(points: &[Point2], [width, height]: [f64; 2]) -> bool {
    let (_, size) = smallest_box(points);
    let [long, short] = [width.max(height), width.min(height)];
    size[0] <= long && size[1] <= short
}
