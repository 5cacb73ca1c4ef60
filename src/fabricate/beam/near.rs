//! What is near a node disc: whether it keeps clear of other discs, and of fins that do not end at its
//! node. A disc counts as the ball around it: nothing that it meets is missed, and one that barely clears
//! a neighbour may be refused.

use super::fin::{BeamPlane, Fin};
use crate::fabricate::boxes::{Boxes, Corners};
use crate::fabricate::panel::distance_to_outline;
use crate::fabricate::surface::PanelSurface;
use crate::math::Vec3;
use crate::math::plane::{Point2, is_inside};

/// A ball: its centre and its radius.
type Ball = (Vec3<f64>, f64);

/// The box of a ball in x and y, grown by this.
fn box_of((centre, radius): Ball, by: f64) -> Corners {
    [-1.0, 1.0].map(|sign| [centre.x, centre.y].map(|x| x + sign * (radius + by)))
}

/// A fin as a plate in space.
struct PlacedFin {
    nodes: [u32; 2],
    outline: [Point2; 4],
    plane: BeamPlane,
    /// What contains it.
    ball: Ball,
}

/// The fins, and the discs so far as balls, each with their boxes.
pub(super) struct Near {
    fins: (Vec<PlacedFin>, Boxes),
    discs: (Vec<Ball>, Boxes),
}

impl Near {
    pub(super) fn new(
        surface: &PanelSurface,
        axes: &[Vec3<f64>],
        fins: &[Result<Fin, &'static str>],
    ) -> Near {
        let placed = (0..).zip(fins).filter_map(|(edge, fin)| {
            let outline = fin.as_ref().ok()?.outline;
            let plane = BeamPlane::of(surface, axes, edge);
            let corners = outline.map(|corner| plane.in_space(corner));
            let centre = corners.into_iter().fold(Vec3::zero(), |sum, p| sum + p) * 0.25;
            let radius = corners.iter().map(|p| (*p - centre).length()).fold(0.0, f64::max);
            let nodes = surface.edges[edge as usize].ends;
            Some(PlacedFin { nodes, outline, plane, ball: (centre, radius) })
        });
        let fins: Vec<PlacedFin> = placed.collect();
        let boxes = Boxes::of(fins.iter().map(|fin| box_of(fin.ball, 0.0)));
        Near { fins: (fins, boxes), discs: (Vec::new(), Boxes::default()) }
    }

    /// Adds the disc of the node `vertex`, as a ball, if it is clear of all
    /// others, and of fins whose plates reach `half` from their middle.
    ///
    /// # Errors
    /// What it would meet.
    pub(super) fn take(&mut self, vertex: u32, disc: Ball, half: f64) -> Result<(), &'static str> {
        let (centre, radius) = disc;
        let (discs, boxes) = &mut self.discs;
        let meets = |k: u32| {
            let (other, own) = discs[k as usize];
            (other - centre).length() < radius + own
        };
        if boxes.meeting(box_of(disc, 0.0)).any(meets) {
            return Err("it would meet the disc of another node");
        }
        let (fins, of_fins) = &self.fins;
        let others = of_fins.meeting(box_of(disc, half)).map(|k| &fins[k as usize]);
        let mut others = others.filter(|fin| !fin.nodes.contains(&vertex));
        if others.any(|fin| fin.is_within(centre, radius + half)) {
            return Err("it would meet a fin of other nodes");
        }
        boxes.insert(discs.len() as u32, box_of(disc, 0.0));
        discs.push(disc);
        Ok(())
    }
}

impl PlacedFin {
    /// Whether its middle plane comes nearer to a point than this.
    fn is_within(&self, point: Vec3<f64>, least: f64) -> bool {
        if (point - self.ball.0).length() >= self.ball.1 + least {
            return false;
        }
        let BeamPlane { origin, along, up } = self.plane;
        let step = point - origin;
        let at = self.plane.flat(step);
        let off = step - along * at[0] - up * at[1];
        let beside = match is_inside(&self.outline, at) {
            true => 0.0,
            false => distance_to_outline(&self.outline, at),
        };
        off.length_squared() + beside * beside < least * least
    }
}
