//! What is near a node disc: whether it keeps clear of other discs, and of fins that do not end at its
//! node. A disc counts as the ball around it: nothing that it meets is missed, and one that barely clears
//! a neighbour may be refused.

use super::fin::Fin;
use crate::fabricate::offset::across_edge;
use crate::fabricate::panel::distance_to_outline;
use crate::fabricate::surface::{PanelSurface, unit};
use crate::math::plane::{Point2, is_inside};
use crate::math::{Vec3, key_of_number, sort_by_number};

/// A fin as a plate in space.
#[derive(Clone)]
struct PlacedFin {
    nodes: [u32; 2],
    outline: [Point2; 4],
    /// Its plane: the first node, the direction of the edge, and of the beam upwards.
    origin: Vec3<f64>,
    axes: [Vec3<f64>; 2],
    /// A ball around it.
    centre: Vec3<f64>,
    radius: f64,
}

/// Fins sorted along x, and the discs so far, as balls.
pub(super) struct Near {
    fins: Vec<PlacedFin>,
    largest: f64,
    discs: Vec<(Vec3<f64>, f64)>,
}

impl Near {
    pub(super) fn new(
        surface: &PanelSurface,
        axes: &[Vec3<f64>],
        fins: &[Result<Fin, &'static str>],
    ) -> Near {
        let placed = surface.edges.iter().zip(fins).filter_map(|(edge, fin)| {
            let fin = fin.as_ref().ok()?;
            let t = surface.direction(edge);
            let [n, m] = edge.ends.map(|v| axes[v as usize]);
            let b = unit(across_edge(n + m, t));
            let origin = surface.at(edge.ends[0]);
            let corners = fin.outline.map(|[x, y]| origin + t * x + b * y);
            let centre = corners.into_iter().fold(Vec3::zero(), |sum, p| sum + p) * 0.25;
            let radius = corners.iter().map(|p| (*p - centre).length()).fold(0.0, f64::max);
            let outline = fin.outline;
            Some(PlacedFin { nodes: edge.ends, outline, origin, axes: [t, b], centre, radius })
        });
        let mut fins: Vec<PlacedFin> = placed.collect();
        sort_by_number(&mut fins, |fin| key_of_number(fin.centre.x));
        let largest = fins.iter().map(|fin| fin.radius).fold(0.0, f64::max);
        Near { fins, largest, discs: Vec::new() }
    }

    /// Adds the disc of the node `vertex`, as a ball with a centre and a radius, if it is clear of all
    /// others, and of fins whose plates reach `half` from their middle.
    ///
    /// # Errors
    /// What it would meet.
    pub(super) fn take(
        &mut self,
        vertex: u32,
        (centre, radius): (Vec3<f64>, f64),
        half: f64,
    ) -> Result<(), &'static str> {
        let is_near = |&(other, own): &(Vec3<f64>, f64)| (other - centre).length() < radius + own;
        if self.discs.iter().any(is_near) {
            return Err("it would meet the disc of another node");
        }
        let reach = self.largest + radius + half;
        let from = self.fins.partition_point(|fin| fin.centre.x < centre.x - reach);
        let others = self.fins[from..].iter().take_while(|fin| fin.centre.x <= centre.x + reach);
        let mut others = others.filter(|fin| !fin.nodes.contains(&vertex));
        if others.any(|fin| fin.is_within(centre, radius + half)) {
            return Err("it would meet a fin of other nodes");
        }
        self.discs.push((centre, radius));
        Ok(())
    }
}

impl PlacedFin {
    /// Whether its middle plane comes nearer to a point than this.
    fn is_within(&self, point: Vec3<f64>, least: f64) -> bool {
        if (point - self.centre).length() >= self.radius + least {
            return false;
        }
        let step = point - self.origin;
        let at = self.axes.map(|axis| step.dot(axis));
        let off = step - self.axes[0] * at[0] - self.axes[1] * at[1];
        let beside = match is_inside(&self.outline, at) {
            true => 0.0,
            false => distance_to_outline(&self.outline, at),
        };
        off.length_squared() + beside * beside < least * least
    }
}
