//! Node discs as parts: their outlines and slots on the sheet, and their names. The geometry is in
//! `beam/disc`.

use super::beam::{Disc, DiscSize, Slot};
use super::build::{Build, CutDisc, NotCut};
use super::fault::Fault;
use super::panel::inset;
use super::sheet::{CutPart, Hole, Labels, SlotName, circle, label_disc};
use crate::math::plane::Point2;
use crate::scene::BuildSettings;

/// Corners of the outline of a disc: it is within 1.3 thousandths of its radius from the circle.
const CORNERS: u32 = 64;
/// Least width of walls and length of tenons: in thicknesses of the material, and in mm.
const WALL: [f64; 2] = [1.0, 1.5];
const TENON: [f64; 2] = [2.0, 3.0];
/// Diameters that are not given are multiples of this, in mm.
const STEP: f64 = 1.0;

impl Build {
    /// Why node discs cannot be cut with these settings although they are asked for, if so.
    pub(super) fn no_slots(settings: &BuildSettings) -> Option<Fault> {
        let &BuildSettings { disc, thickness, clearance, kerf, .. } = settings;
        let is_too_thin = thickness <= 0.0 || thickness + 2.0 * clearance <= kerf;
        (disc != Some(0.0) && is_too_thin).then(|| Fault::no_slots(thickness > 0.0))
    }

    /// The dimensions of node discs with these settings, if they are asked for and can be cut.
    pub(super) fn disc_size(&self, own: &BuildSettings) -> Option<DiscSize> {
        if own.disc == Some(0.0) || Build::no_slots(own).is_some() {
            return None;
        }
        let in_mesh = 1.0 / self.mm_of_sheet_at(own.scale);
        let least = |[thicknesses, mm]: [f64; 2]| (thicknesses * own.thickness).max(mm) * in_mesh;
        Some(DiscSize {
            diameter: own.disc.map(|diameter| diameter * in_mesh),
            step: STEP * in_mesh,
            clearance: own.clearance * in_mesh,
            wall: least(WALL),
            tenon: least(TENON),
        })
    }

    /// Adds the discs to the parts, after the fins.
    pub(super) fn cut_discs(&mut self) {
        let Some(frame) = self.frame.as_ref().filter(|frame| !frame.discs.is_empty()) else {
            return;
        };
        let model = self.mm_of_sheet();
        let half = 0.5 * self.settings.kerf;
        let mut around = self.surface.panels_around();
        for (disc, v) in frame.discs.iter().zip(0..) {
            let name = self.node_name(v);
            let made = match disc {
                None => continue,
                Some(Ok(disc)) => cut(disc, model, half),
                Some(Err(why)) => Err(*why),
            };
            match made {
                Ok((outline, holes)) => {
                    let mut panels = std::mem::take(&mut around[v as usize]);
                    panels.dedup();
                    self.discs.push(CutDisc { vertex: v, part: self.parts.len() });
                    self.parts.push(CutPart { name, panels, outline, holes, ..CutPart::default() });
                }
                Err(why) => self.not_cut.push(NotCut { part: name, why, is_part: true }),
            }
        }
    }

    /// The disc of a part, if it is one.
    pub(super) fn disc_of(&self, part: usize) -> Option<&Disc> {
        let first = self.discs.first()?.part;
        let vertex = self.discs.get(part.checked_sub(first)?)?.vertex;
        self.frame.as_ref()?.discs[vertex as usize].as_ref()?.as_ref().ok()
    }

    /// The names on a disc that is a part.
    pub(super) fn label_disc(&self, disc: &Disc, part: &CutPart, turn: Point2) -> Labels {
        let model = self.mm_of_sheet();
        let of_slot = |slot: &Slot| {
            let ends = self.surface.edges[slot.edge as usize].ends;
            let other = if ends[0] == disc.vertex { ends[1] } else { ends[0] };
            let corners = slot.corners.map(|corner| corner.map(|x| x * model));
            SlotName { corners, name: self.node_name(other) }
        };
        let slots: Vec<SlotName> = disc.slots.iter().map(of_slot).collect();
        label_disc((&part.outline, &part.holes), &part.name, &slots, turn)
    }
}

/// The outline and the slots of a disc in mm of the sheet, with half the kerf.
fn cut(disc: &Disc, model: f64, half: f64) -> Result<(Vec<Point2>, Vec<Hole>), &'static str> {
    let outline = circle([0.0; 2], disc.radius * model + half, CORNERS);
    let slots = disc.slots.iter().map(|slot| {
        let scaled = slot.corners.map(|corner| corner.map(|x| x * model));
        let narrowed = if half > 0.0 { inset(&scaled, half) } else { Some(scaled.into()) };
        narrowed.map(Hole::slot).ok_or("a slot is no wider than the kerf")
    });
    Ok((outline, slots.collect::<Result<_, _>>()?))
}

/// The outline of a disc and its slots as one polygon, in the unit of the mesh: each slot is joined
/// to the rim by a cut without width, at the corner of the rim nearest to it.
pub(super) fn as_one_polygon(disc: &Disc) -> Vec<Point2> {
    let rim = circle([0.0; 2], disc.radius, CORNERS);
    let turn = |[x, y]: Point2| {
        let turns = libm::atan2(y, x) / std::f64::consts::TAU;
        if turns < 0.0 { turns + 1.0 } else { turns }
    };
    // Each slot begins at the outer corner on its right.
    let mut starts: Vec<(usize, f64, &[Point2; 4])> = Vec::new();
    for slot in &disc.slots {
        let at = turn(slot.corners[1]) * f64::from(CORNERS);
        // By how far it is beyond the corner: before the first one is not after the last one.
        let nearest = at.round();
        starts.push((nearest as usize % CORNERS as usize, at - nearest, &slot.corners));
    }
    starts.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut polygon = Vec::new();
    for (k, &corner) in rim.iter().enumerate() {
        polygon.push(corner);
        for (.., [a, b, c, d]) in starts.iter().filter(|(own, ..)| *own == k) {
            // Clockwise around the slot, and back.
            polygon.extend([*b, *a, *d, *c, *b, corner]);
        }
    }
    polygon
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cuts_to_slots_on_both_sides_of_the_first_corner_do_not_cross() {
        let slot = |degrees: f64| {
            let [x, y] = crate::math::cosine_and_sine_of_degrees(degrees);
            let put = |r: f64, side: f64| [r * x - side * y, r * y + side * x];
            let corners = [put(1.0, 0.0), put(2.0, 0.0), put(2.0, 0.05), put(1.0, 0.05)];
            Slot { edge: 0, corners }
        };
        let slots = vec![slot(1.0), slot(-2.0)];
        let disc = Disc { vertex: 0, radius: 3.0, seat: 0.0, slots, neck: 0.0, lean_deg: 0.0 };
        // The corners on the right, in the order in which the rim is passed.
        let first = as_one_polygon(&disc)[1];
        assert_eq!(first, disc.slots[1].corners[1]);
    }
}
