//! The thickness `c` of card, whose outer faces lie on the panels of the mesh.
//!
//! At an edge with the fold `theta`, plates keep apart if both stay on their side of the plane that
//! halves the angle between them. It is inclined to both normals by `theta/2`, so that at the depth `c`
//! it is `b = c tan(theta/2)` away from the edge: before it at a ridge, beyond it at a valley. With square
//! sides, plates meet along their inner faces if they end `b` before a ridge, and along their outer faces
//! if they end at a valley. There they hinge:
//!
//! | fold | at a ridge | at a valley |
//! |---|---|---|
//! | scored | cut half through from outside, hinge at the inner faces: both plates end `b` before the edge | cut half through from inside, hinge at the edge |
//! | V-cut | a groove on the inside, `2 b` wide and with the angle `theta`, hinge at the edge, or a mitre where plates are cut apart: outer faces are whole | slit from inside, hinge at the edge |
//! | separate | cut through, both plates end `b` before the edge | cut through at the edge |
//!
//! Only plates with a common edge are kept apart. Where the inner faces of more than three plates do not
//! meet in one point, those that share only a corner may overlap at its tip, by less than `c` in the tests.

use super::facet::{Facet, FacetSide, FoldKind, Joint};
use crate::fabricate::panel::{alike_in_line, direction_of, inset_sides};
use crate::fabricate::surface::PanelSurface;
use crate::math::plane::{Point2, rotated};
use crate::math::{cosine, sine};
use crate::scene::Fold;

/// Distances in mm that differ by less are equal.
const ROUNDING: f64 = 1e-6;

/// Where facets cannot end as their folds ask.
#[derive(Clone, Debug, Default)]
pub struct Uneven {
    /// Facets of which the folds leave no inner face, since the card is too thick: they are not cut back.
    pub too_thick: Vec<u32>,
    /// Sides that end farther from their edge than their fold asks, in line with one that asks for more:
    /// there is a gap.
    pub gaps: Vec<FacetSide>,
}

/// The material of a paper model, and how it is folded.
#[derive(Clone, Copy, Debug)]
pub struct Card {
    /// How folds are made.
    pub fold: Fold,
    /// The thickness in mm.
    pub thickness: f64,
}

impl Card {
    /// Cuts facets back where they end before their edge, and determines the hinges of joints. Returns where
    /// facets end otherwise than their folds ask.
    pub(super) fn cut_back(
        self,
        surface: &PanelSurface,
        facets: &mut [Facet],
        joints: &mut [Joint],
    ) -> Uneven {
        if self.fold == Fold::Crease {
            return Uneven::default();
        }
        for joint in joints.iter_mut() {
            joint.back = self.back(joint.fold);
            joint.is_hinge = self.fold != Fold::Separate || joint.kind() == FoldKind::Flat;
        }
        let mut uneven = Uneven::default();
        for (facet, f) in facets.iter_mut().zip(0..) {
            let back = |(joint, side): (&Option<u32>, &Option<u32>)| match joint {
                Some(joint) => joints[*joint as usize].back,
                None => side.map_or(0.0, |side| self.back_unpaired(surface, facet.panel, side)),
            };
            let asked: Vec<f64> = facet.joints.iter().zip(&facet.panel_sides).map(back).collect();
            if asked.iter().all(|by| *by == 0.0) {
                continue;
            }
            let mut by = alike_in_line(&facet.corners, &asked);
            let inner = inset_sides(&facet.corners, &by);
            if inner.is_none() {
                uneven.too_thick.push(f);
                by.fill(0.0);
            }
            if self.fold == Fold::VCut {
                // Each groove and mitre is as wide as its own fold asks.
                facet.backs = asked;
                continue;
            }
            for ((joint, k), (by, asked)) in facet.joints.iter().zip(0..).zip(by.iter().zip(&asked))
            {
                if (by - asked).abs() <= ROUNDING {
                    continue;
                }
                // What ends elsewhere than its neighbour has no hinge in common with it.
                if let Some(joint) = joint {
                    joints[*joint as usize].is_hinge = false;
                }
                if by > asked {
                    uneven.gaps.push((f, k));
                }
            }
            if let Some(corners) = inner {
                facet.hinges = moved(&facet.hinges, &by);
                facet.set_corners(corners);
            }
            facet.backs = by;
        }
        uneven
    }

    /// How far before a side of a panel without a joint its inner face ends, in mm: it also meets those
    /// beyond a panel without area.
    fn back_unpaired(self, surface: &PanelSurface, panel: u32, side: u32) -> f64 {
        let edge = surface.sides.row(panel as usize)[side as usize];
        let edge = &surface.edges[edge as usize];
        let fold = if surface.is_joined(edge) { None } else { surface.fold(edge) };
        fold.map_or(0.0, |fold| self.back(fold))
    }

    /// How far before an edge with a fold in radians the inner faces of its facets end, in mm.
    pub(in crate::fabricate) fn back(self, fold: f64) -> f64 {
        /// The least cosine of half a fold.
        const CLOSED: f64 = 1e-6;
        if FoldKind::of(fold) != FoldKind::Ridge {
            return 0.0;
        }
        let half_turns = 0.5 * fold / std::f64::consts::TAU;
        self.thickness * sine(half_turns) / cosine(half_turns).max(CLOSED)
    }
}

/// Sides moved inwards.
fn moved(sides: &[[Point2; 2]], by: &[f64]) -> Vec<[Point2; 2]> {
    let inwards = |([p, q], by): (&[Point2; 2], &f64)| {
        let [x, y] = rotated([0.0, *by], direction_of(*p, *q));
        [p, q].map(|end| [end[0] + x, end[1] + y])
    };
    sides.iter().zip(by).map(inwards).collect()
}
