//! Growth of pieces: folding a joint merges two pieces if they fit on the sheet together, do not
//! overlap, and leave room for the tabs of the edges that stay open between them.

use super::net::{OutlineSide, PaperNet};
use super::plane::{Motion, is_near, is_same_corner, overlaps};
use super::tab::tab;
use crate::fabricate::panel::{hull, smallest_box};
use crate::math::plane::{Point2, bounds, distance};
use std::cell::LazyCell;

/// The least length of an edge that holds two pieces together, in mm: a shorter one tears.
const LEAST_HINGE: f64 = 0.5;

impl PaperNet {
    /// Folds a joint if possible: the pieces on its two sides become one. `room` is the largest
    /// size of a piece without its tabs, which are up to `tab_height` high.
    pub(super) fn fold(&mut self, joint: u32, room: [f64; 2], tab_height: f64) -> bool {
        let [mut still, mut moving] = self.joints[joint as usize].sides;
        if self.piece_of[still.0 as usize] == self.piece_of[moving.0 as usize] {
            return false;
        }
        let size = |net: &PaperNet, side: (u32, u32)| {
            net.pieces[net.piece_of[side.0 as usize] as usize].len()
        };
        if size(self, still) < size(self, moving) {
            (still, moving) = (moving, still);
        }
        let [a, b] = [still, moving].map(|side| self.piece_of[side.0 as usize]);
        let [p, q] = self.ends(still);
        if distance(p, q) < LEAST_HINGE {
            return false;
        }
        let motion = Motion::between(self.ends(moving), [q, p]);
        let moved = self.pieces[b as usize].clone();
        let before: Vec<Motion> = moved.iter().map(|&f| self.places[f as usize]).collect();
        for &f in &moved {
            self.put(f, motion.after(&self.places[f as usize]));
        }
        let welded = self.welded(joint, &moved, a);
        let corners = moved.iter().flat_map(|&f| self.corners(f));
        let both = hull(&self.hulls[a as usize].iter().copied().chain(corners).collect::<Vec<_>>());
        let mut is_good = fits(&both, room) && !self.overlap([a, b]);
        if is_good {
            welded.iter().for_each(|&j| self.folded[j as usize] = true);
            moved.iter().for_each(|&f| self.piece_of[f as usize] = a);
            self.pieces[a as usize].extend(&moved);
            self.pieces[b as usize].clear();
            is_good = self.has_room_for_tabs(a, &moved, tab_height);
            if is_good {
                self.hulls[a as usize] = both;
            } else {
                let kept = self.pieces[a as usize].len() - moved.len();
                self.pieces[a as usize].truncate(kept);
                self.pieces[b as usize].clone_from(&moved);
                moved.iter().for_each(|&f| self.piece_of[f as usize] = b);
                welded.iter().for_each(|&j| self.folded[j as usize] = false);
            }
        }
        if !is_good {
            moved.iter().zip(before).for_each(|(&f, place)| self.put(f, place));
        }
        is_good
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
                let ([p, q], [r, s]) = (self.ends((f, k)), self.ends(there));
                if is_same_corner(p, s) && is_same_corner(q, r) {
                    found.push(other);
                }
            }
        }
        found
    }

    /// Whether two pieces overlap; `b` is the smaller one.
    fn overlap(&self, [a, b]: [u32; 2]) -> bool {
        let other = self.convex(b);
        let around = bounds(other.iter().flatten().copied());
        let near = |f: &&u32| is_near(self.boxes[**f as usize], around);
        let own = self.convex_of(self.pieces[a as usize].iter().filter(near));
        own.iter().any(|p| other.iter().any(|q| overlaps(p, q)))
    }

    /// Whether the outline of a piece is one closed line, and every cut edge with both sides on the
    /// piece has room for a tab on one of them.
    fn has_room_for_tabs(&self, piece: u32, moved: &[u32], tab_height: f64) -> bool {
        let Some(outline) = self.outline(piece) else { return false };
        // Few joints need them.
        let convex = LazyCell::new(|| self.convex(piece));
        outline.iter().all(|own| {
            if tab_height <= 0.0 || !moved.contains(&own.facet) {
                return true;
            }
            let Some((_, there)) = self.across((own.facet, own.side)) else { return true };
            if self.piece_of[there.0 as usize] != piece {
                return true;
            }
            let at = |(facet, side): (u32, u32)| {
                outline.iter().position(|other| *other == OutlineSide { facet, side })
            };
            [(own.facet, own.side), there]
                .into_iter()
                .filter_map(at)
                .any(|k| tab(self, &outline, k, &convex, tab_height).is_some())
        })
    }
}

/// Whether the smallest box around these points is at most as large as `room`.
fn fits(points: &[Point2], [width, height]: [f64; 2]) -> bool {
    let (_, size) = smallest_box(points);
    let [long, short] = [width.max(height), width.min(height)];
    size[0] <= long && size[1] <= short
}
