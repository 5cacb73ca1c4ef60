//! Strips that cover the joints between panels. They are flat bars of one width, of another material than
//! the panels: a facade has aluminium over glass. So they are listed to be sawn to length, not laid out on
//! the sheets of the panels.
//!
//! A strip lies along an edge, with half of its width `h` on either panel, and has square ends. Where two of
//! them meet in the corner of a panel, both end `h cot(angle/2)` before the vertex: there their corners
//! touch. Where the other side of the corner has no strip, a strip ends before it crosses that side.

use super::build::Build;
use super::panel::direction_of;
use super::surface::Edge;
use crate::math::plane::{cross, dot};
use crate::scene::{BuildSettings, Product};

/// A strip over a joint, in mm of the sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoverStrip {
    /// Its edge.
    pub edge: u32,
    /// How far from the first and the second end of the edge it ends.
    pub cut_back: [f64; 2],
    /// Its length; 0 or less if its corners leave nothing of it.
    pub length: f64,
}

impl Build {
    /// A strip for each edge between two panels that are cut; none of width 0, and for other products.
    pub fn strips(&self) -> Vec<CoverStrip> {
        let BuildSettings { product, strip: width, .. } = self.settings;
        if product != Product::Panels || width <= 0.0 {
            return Vec::new();
        }
        let covered = |edge: &Edge| self.is_covered(edge);
        let all = self.surface.edges.iter().zip(0..).filter(|(edge, _)| covered(edge));
        let strip = |(edge, e): (&Edge, u32)| {
            let cut_back = edge.ends.map(|v| {
                let panels = edge.panels.into_iter().flatten();
                let backs = panels.map(|panel| self.cut_back(panel, e, v));
                0.5 * width * backs.fold(0.0, f64::max)
            });
            let length = self.surface.length(edge) * self.mm_of_sheet();
            CoverStrip { edge: e, cut_back, length: length - cut_back[0] - cut_back[1] }
        };
        all.map(strip).collect()
    }

    fn is_covered(&self, edge: &Edge) -> bool {
        let is_cut = |panel: &Option<u32>| panel.is_some_and(|f| self.cut[f as usize].is_some());
        edge.panels.iter().all(is_cut) && !edge.is_bridge() && self.surface.length(edge) > 0.0
    }

    /// How far before the vertex `v` the strip of edge `e` ends on a panel, in halves of its width.
    fn cut_back(&self, panel: u32, e: u32, v: u32) -> f64 {
        let f = panel as usize;
        let (Some(flat), sides) = (&self.flat[f], self.surface.sides.row(f)) else { return 0.0 };
        let face = self.surface.faces.row(f);
        let n = face.len();
        let ring = self.surface.rings(panel).into_iter().find_map(|ring| {
            let at = ring.iter().position(|&k| sides[k] == e)?;
            Some((ring, at))
        });
        let Some((ring, at)) = ring else { return 0.0 };
        let own = ring[at];
        // The corner is at the start or at the end of the side; sides without length are passed over.
        let starts = face[own] == v;
        let count = ring.len();
        let step = |by: usize| if starts { count - by } else { by };
        let beyond = (1..count).map(|by| ring[(at + step(by)) % count]);
        let has_length = |k: &usize| flat.corners[*k] != flat.corners[(*k + 1) % n];
        let Some(other) = beyond.into_iter().find(has_length) else { return 0.0 };
        let along = |k: usize| direction_of(flat.corners[k], flat.corners[(k + 1) % n]);
        let (before, after) = if starts { (other, own) } else { (own, other) };
        // The angle inside is 180 degrees less what the outline turns to the left.
        let (cosine, sine) =
            (-dot(along(before), along(after)), cross(along(before), along(after)));
        if sine <= 0.0 {
            return 0.0;
        }
        let is_covered = self.is_covered(&self.surface.edges[sides[other] as usize]);
        if is_covered { (1.0 + cosine) / sine } else { (cosine / sine).max(0.0) }
    }
}
