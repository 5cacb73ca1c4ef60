//! The outlines of a panel and of its holes as they are cut: each side moved by half the joint, or at the
//! boundary of the model by its setback, and by half the kerf the other way; and which panels are cut alike.

use super::alike::Types;
use super::build::Build;
use super::panel::{
    alike_in_line, are_apart, check_size, inset, inset_sides, is_simple, panel_types,
};
use crate::math::plane::{Point2, is_inside};
use crate::scene::{BuildSettings, Product};

/// Why a panel is not cut whose holes, with the joint, reach each other or its outline.
const TOO_LITTLE: &str = "the joint leaves too little of it beside a hole";

/// A panel in mm of the sheet, in its plane.
pub(super) struct PanelOutline {
    /// Its corners without joint and kerf, in the order of the surface.
    pub whole: Vec<Point2>,
    /// Its outline, then its holes.
    pub rings: Vec<PanelRing>,
}

/// The outline of a panel, or of a hole in it, as it is cut.
pub(super) struct PanelRing {
    /// Its corners, counterclockwise. Where a side has vanished, two coincide.
    pub corners: Vec<Point2>,
    /// The side of the panel from each corner to the next one.
    pub sides: Vec<usize>,
}

impl PanelRing {
    /// Whether another ring lies in it, and they do not touch.
    fn contains(&self, other: &PanelRing) -> bool {
        are_apart(&self.corners, &other.corners)
            && other.corners.iter().all(|&corner| is_inside(&self.corners, corner))
    }

    /// Whether another ring lies beside it, and they do not touch.
    fn is_beside(&self, other: &PanelRing) -> bool {
        let is_within = |one: &PanelRing, other: &PanelRing| {
            other.corners.first().is_some_and(|&corner| is_inside(&one.corners, corner))
        };
        are_apart(&self.corners, &other.corners)
            && !is_within(self, other)
            && !is_within(other, self)
    }
}

/// Whether holes, all but the first of some rings, lie in the first one, apart from each other.
fn are_holes(rings: &[PanelRing]) -> bool {
    let [outline, holes @ ..] = rings else { return true };
    holes.iter().enumerate().all(|(k, hole)| {
        outline.contains(hole) && holes[..k].iter().all(|other| hole.is_beside(other))
    })
}

/// Why a panel has no outline whose sides are moved inwards `by` so much.
fn why_no_outline(panel: &[Point2], by: &[f64]) -> &'static str {
    if inset(panel, 0.0).is_none() {
        "two of its sides lie on each other"
    } else if by.iter().all(|by| *by < 0.0) {
        "a notch in it is too narrow for the kerf"
    } else {
        "it is too small for the joint or the setback"
    }
}

impl Build {
    /// A panel as it is cut with these settings, at their scale.
    ///
    /// # Errors
    /// Why it cannot be cut, in words.
    pub(super) fn outline(
        &self,
        f: usize,
        settings: &BuildSettings,
    ) -> Result<PanelOutline, &'static str> {
        let model = self.mm_of_sheet_at(settings.scale);
        let flat = self.flat[f].as_ref().ok_or("it has no area")?;
        let whole: Vec<Point2> =
            flat.corners.iter().map(|corner| corner.map(|x| x * model)).collect();
        check_size(&whole)?;
        let ring = |sides: Vec<usize>| {
            let corners = sides.iter().map(|&k| whole[k]).collect();
            PanelRing { corners, sides }
        };
        let unmoved: Vec<PanelRing> = self.surface.rings(f as u32).into_iter().map(ring).collect();
        if !unmoved.iter().all(|ring| is_simple(&ring.corners)) {
            return Err("laid flat it crosses itself");
        }
        if !are_holes(&unmoved) {
            return Err("laid flat a hole in it is not within its outline");
        }
        let setbacks = self.setbacks(f, settings);
        let mut rings = Vec::new();
        for (number, PanelRing { corners, sides }) in unmoved.into_iter().enumerate() {
            let by: Vec<f64> =
                sides.iter().map(|&k| setbacks[k] * model - 0.5 * settings.kerf).collect();
            let moved = match number {
                0 => {
                    let outline = inset_sides(&corners, &by);
                    let corners = outline.ok_or_else(|| why_no_outline(&corners, &by))?;
                    PanelRing { corners, sides }
                }
                _ => hole(&corners, &sides, &by).ok_or(match by.iter().all(|by| *by < 0.0) {
                    true => "a hole in it is too small for the kerf",
                    false => TOO_LITTLE,
                })?,
            };
            rings.push(moved);
        }
        check_size(&rings[0].corners)?;
        match are_holes(&rings) {
            true => Ok(PanelOutline { whole, rings }),
            false => Err(TOO_LITTLE),
        }
    }

    /// How far each side of a panel is from its edge as it is cut, in the unit of the mesh; 0 for bridges.
    pub(super) fn setbacks(&self, f: usize, settings: &BuildSettings) -> Vec<f64> {
        let Some(flat) = &self.flat[f] else { return Vec::new() };
        let mut found = vec![0.0; flat.corners.len()];
        for ring in self.surface.rings(f as u32) {
            let corners: Vec<Point2> = ring.iter().map(|&k| flat.corners[k]).collect();
            let by: Vec<f64> = ring.iter().map(|&k| self.setback(f, k, settings)).collect();
            ring.into_iter().zip(alike_in_line(&corners, &by)).for_each(|(k, by)| found[k] = by);
        }
        found
    }

    /// The types of the panels within a tolerance in mm of the building: by their outlines as cut, if
    /// they are cut singly.
    pub(super) fn panel_types(&self, tolerance: f64) -> Types {
        let setbacks = |f: usize| match self.settings.product {
            Product::Panels => self.setbacks(f, &self.settings),
            _ => vec![0.0; self.surface.faces.row(f).len()],
        };
        let tolerance = tolerance / self.mm_of_building();
        panel_types(&self.flat, setbacks, tolerance, self.settings.mirror)
    }

    /// How far side `k` of a panel is from its edge, in the unit of the mesh: half the joint, or the setback
    /// at the boundary of the model, where it meets no panel.
    fn setback(&self, f: usize, k: usize, settings: &BuildSettings) -> f64 {
        let joint = 0.5 * settings.joint;
        let Some(setback) = settings.setback else { return joint };
        let edge = self.surface.sides.row(f)[k];
        let is_boundary = self.surface.neighbours_across(edge, f as u32).is_empty();
        if is_boundary { setback } else { joint }
    }
}

/// A hole with these corners, clockwise, whose sides are moved so far out of it.
fn hole(corners: &[Point2], sides: &[usize], by: &[f64]) -> Option<PanelRing> {
    let backwards: Vec<Point2> = corners.iter().rev().copied().collect();
    // Backwards, the side before a corner begins there.
    let mut order: Vec<usize> = (0..sides.len()).rev().collect();
    order.rotate_left(1);
    let outwards: Vec<f64> = order.iter().map(|&k| -by[k]).collect();
    let corners = inset_sides(&backwards, &outwards)?;
    Some(PanelRing { corners, sides: order.into_iter().map(|k| sides[k]).collect() })
}
