//! Panels that face the wrong side: those of a closed part that face inwards, and those that are folded
//! over.

use super::surface::PanelSurface;
use crate::math::{Vec3, angle_between};
use crate::mesh::components;

impl PanelSurface {
    /// Whether all panels are to be flipped, since all parts are closed and then none faces inwards. None
    /// if no closed part faces inwards. A part faces inwards if it encloses a negative volume, and its box
    /// does not lie in that of a larger closed part, whose hollow it would be.
    pub fn inside_out(&self) -> Option<bool> {
        if self.one_sided.is_some() {
            return None;
        }
        let mut shells = self.shells();
        any_inwards(&shells).then(|| {
            shells.iter_mut().for_each(|own| own.volume = -own.volume);
            shells.iter().all(|own| own.is_closed) && !any_inwards(&shells)
        })
    }

    /// The parts of panels that are connected across edges.
    pub(super) fn shells(&self) -> Vec<Shell> {
        let labels = components(self.faces.len(), self.panels.iter());
        let count = labels.iter().max().map_or(0, |last| *last as usize + 1);
        let mut shells = vec![Shell::default(); count];
        for (((face, area), label), f) in self.faces.iter().zip(&self.areas).zip(&labels).zip(0..) {
            let shell = &mut shells[*label as usize];
            shell.panel = f;
            let sum = face.iter().fold(Vec3::zero(), |sum, &v| sum + self.at(v));
            shell.volume += sum.dot(*area) / (3 * face.len()) as f64;
            for point in face.iter().map(|&v| <[f64; 3]>::from(self.at(v))) {
                (0..3).for_each(|k| shell.low[k] = shell.low[k].min(point[k]));
                (0..3).for_each(|k| shell.high[k] = shell.high[k].max(point[k]));
            }
        }
        for panel in self.panels.iter().filter(|own| own.len() == 1).flatten() {
            shells[labels[*panel as usize] as usize].is_closed = false;
        }
        shells
    }

    /// The panels that are folded over: the normals of the panel and of one of its vertices point
    /// to opposite sides, so that no offset is meaningful there.
    pub fn folded_over(&self) -> Vec<u32> {
        let normals = self.normals_by_angle();
        let over = |f: &u32| {
            let area = self.areas[*f as usize];
            self.faces.row(*f as usize).iter().any(|&v| area.dot(normals[v as usize]) < 0.0)
        };
        (0..self.faces.len() as u32).filter(over).collect()
    }

    /// The sum of the unit normals of the panels at each vertex, weighted by the angles of their
    /// corners. Weighted by area, a small panel beyond a sharp ridge would count as folded over.
    fn normals_by_angle(&self) -> Vec<Vec3<f64>> {
        let mut normals = vec![Vec3::zero(); self.positions.len()];
        for (face, f) in self.faces.iter().zip(0..) {
            let (n, normal) = (face.len(), self.normal(f));
            for (k, &v) in face.iter().enumerate() {
                let along = |other: usize| self.at(face[other % n]) - self.at(v);
                let angle = angle_between(along(k + 1), along(k + n - 1)).unwrap_or(0.0);
                normals[v as usize] += normal * angle;
            }
        }
        normals
    }
}

/// Whether the panels of some closed part face inwards.
fn any_inwards(shells: &[Shell]) -> bool {
    let contains = |outer: &Shell, inner: &Shell| {
        outer.is_closed
            && outer.volume > inner.volume.abs()
            && (0..3).all(|k| outer.low[k] <= inner.low[k] && inner.high[k] <= outer.high[k])
    };
    let is_hollow = |own: &Shell| shells.iter().any(|outer| contains(outer, own));
    shells.iter().any(|own| own.is_closed && own.volume < -own.rounding() && !is_hollow(own))
}

/// Panels that are connected across edges.
#[derive(Clone, Debug)]
pub(super) struct Shell {
    /// One of its panels.
    pub(super) panel: u32,
    /// Whether it has no rim.
    pub(super) is_closed: bool,
    /// The volume that it encloses if it is closed; negative if its panels face inwards.
    volume: f64,
    /// Its bounding box.
    low: [f64; 3],
    high: [f64; 3],
}

impl Shell {
    /// Smaller volumes are rounding errors: of two flat layers joined at their rim, for instance.
    fn rounding(&self) -> f64 {
        let diagonal = Vec3::from(self.high) - Vec3::from(self.low);
        1e-9 * diagonal.length() * diagonal.dot(diagonal)
    }
}

impl Default for Shell {
    fn default() -> Shell {
        let (low, high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        Shell { panel: 0, is_closed: true, volume: 0.0, low, high }
    }
}
