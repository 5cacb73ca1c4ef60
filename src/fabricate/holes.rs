//! Holes for dowels, bolts or ties: two on each side of every edge between panels, opposite each
//! other, or one at each end of a fin; and four through each splice plate. An edge without length, where panels only touch, has none.

use super::build::{Build, Splice};
use super::panel::{direction_of, distance_to_outline};
use super::sheet::{CutPart, Hole};
use crate::math::plane::{Point2, bounds, distance, is_inside};
use crate::scene::Product;

/// Distance of the centre of a hole from its edge, in diameters.
const FROM_EDGE: f64 = 1.5;
/// Least distance from every other edge, and half of that from other holes, in diameters.
const LEAST: f64 = 1.0;
/// Positions of holes along an edge, as fractions of its length.
const ALONG: [f64; 2] = [1.0 / 3.0, 2.0 / 3.0];

impl Build {
    /// Drills holes of the requested diameter that have room, and counts those that have none.
    /// Paper models have no holes.
    pub(super) fn drill(&mut self) {
        let diameter = self.settings.hole;
        if diameter <= 0.0 {
            return;
        }
        // What is cut out is narrower than the hole by the kerf.
        let radius = 0.5 * (diameter - self.settings.kerf);
        match self.settings.product {
            Product::Panels => {
                self.drill_panels(diameter, radius);
                self.drill_plates(diameter, radius);
            }
            Product::Fins => self.drill_fins(diameter, radius),
            Product::Paper => {}
        }
    }

    fn drill_panels(&mut self, diameter: f64, radius: f64) {
        let joint = 0.5 * self.settings.joint * self.mm_of_sheet();
        // Holes lie opposite each other only between two panels.
        let unpaired = self.surface.unpaired();
        let unpaired = unpaired.flat_map(|(e, _)| self.surface.panels.row(e as usize));
        let cut = unpaired.filter(|&&f| self.cut[f as usize].is_some());
        self.left_out.unpaired_holes += ALONG.len() * cut.count();
        for (edge, e) in self.surface.edges.iter().zip(0..) {
            let [Some(f), Some(g)] = edge.panels else { continue };
            if f == g {
                continue;
            }
            let cut = [f, g].map(|f| self.cut[f as usize].as_ref().map(|cut| (f, cut)));
            let [Some(one), Some(other)] = cut else { continue };
            match self.surface.length(edge) * self.mm_of_sheet() {
                0.0 => continue,
                short if short < diameter => {
                    self.left_out.dropped_holes += 2 * ALONG.len();
                    continue;
                }
                _ => {}
            }
            for share in ALONG {
                // The panels traverse the edge in opposite directions: hence `1 - share`.
                let at = |(f, cut): (u32, &super::build::CutPanel), share: f64| {
                    let sides = self.surface.sides.row(f as usize);
                    let k = sides.iter().position(|&side| side == e)?;
                    let (p, q) = (cut.whole[k], cut.whole[(k + 1) % cut.whole.len()]);
                    let centre = beside([p, q], share, joint + FROM_EDGE * diameter);
                    let is_on = |part: &usize| is_inside(&self.parts[*part].outline, centre);
                    Some((cut.parts().find(is_on).unwrap_or(cut.part), centre))
                };
                let both = at(one, share).zip(at(other, 1.0 - share));
                let Some(both) = both.map(|(a, b)| [a, b]) else { continue };
                let outside = 0.5 * self.settings.kerf;
                let has_room = |&(part, centre): &(usize, Point2)| {
                    let part = &self.parts[part];
                    let is_apart = |frame: &Vec<Point2>| {
                        let [low, high] = bounds(frame.iter().copied());
                        (0..2).any(|x| {
                            centre[x] < low[x] - diameter || centre[x] > high[x] + diameter
                        })
                    };
                    // Nor behind it, where a plate is.
                    has_room(part, centre, (diameter, outside))
                        && part.engraved.iter().all(is_apart)
                };
                match radius > 0.0 && both.iter().all(has_room) {
                    true => both.iter().for_each(|&(part, centre)| {
                        self.parts[part].holes.push(Hole::round(centre, radius));
                    }),
                    false => self.left_out.dropped_holes += 2,
                }
            }
        }
    }

    /// Drills splice plates and the pieces that they join: two holes on each side of the seam.
    fn drill_plates(&mut self, diameter: f64, radius: f64) {
        let outside = 0.5 * self.settings.kerf;
        for Splice { part, pieces, axis, corners: [low, high], .. } in &self.splices {
            let from_edge = 0.25 * (high[*axis] - low[*axis]);
            for (piece, across) in
                pieces.iter().zip([low[*axis] + from_edge, high[*axis] - from_edge])
            {
                for along in [low[1 - axis] + from_edge, high[1 - axis] - from_edge] {
                    let centre = if *axis == 0 { [across, along] } else { [along, across] };
                    let fits =
                        |part: &&usize| has_room(&self.parts[**part], centre, (diameter, outside));
                    match radius > 0.0 && [part, piece].iter().all(fits) {
                        true => [part, piece].into_iter().for_each(|part| {
                            self.parts[*part].holes.push(Hole::round(centre, radius));
                        }),
                        false => self.left_out.dropped_holes += 2,
                    }
                }
            }
        }
    }

    fn drill_fins(&mut self, diameter: f64, radius: f64) {
        // The outline that is cut is outside the fin.
        let outside = 0.5 * self.settings.kerf;
        for part in &mut self.parts {
            // The sides at its nodes.
            let n = part.outline.len();
            for side in [1, n.saturating_sub(1)] {
                let ends = [part.outline[side % n], part.outline[(side + 1) % n]];
                let centre = beside(ends, 0.5, FROM_EDGE * diameter + outside);
                match radius > 0.0 && has_room(part, centre, (diameter, outside)) {
                    true => part.holes.push(Hole::round(centre, radius)),
                    false => self.left_out.dropped_holes += 1,
                }
            }
        }
    }
}

/// The point at a fraction of a side, moved inwards by `away`.
fn beside([p, q]: [Point2; 2], share: f64, away: f64) -> Point2 {
    let [c, s] = direction_of(p, q);
    let at = |x: usize| p[x] + share * (q[x] - p[x]);
    [at(0) - away * s, at(1) + away * c]
}

/// Whether a hole leaves enough of a part, which is smaller than what is cut by `outside` on each side.
fn has_room(part: &CutPart, centre: Point2, (diameter, outside): (f64, f64)) -> bool {
    let apart = |hole: &Hole| match hole.as_opening() {
        None => distance(centre, hole.centre) >= 2.0 * LEAST * diameter,
        Some(opening) => {
            !is_inside(opening, centre)
                && distance_to_outline(opening, centre) >= LEAST * diameter + outside
        }
    };
    is_inside(&part.outline, centre)
        && distance_to_outline(&part.outline, centre) >= LEAST * diameter + outside
        && part.holes.iter().all(apart)
}
