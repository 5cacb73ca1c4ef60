//! Why the axes of an offset are not exact: what is said about it, and which constraint on panels helps,
//! follow from it.

use super::{Axes, Closing, Closings, Inexact};
use crate::scene::OffsetKind;
use crate::words;

/// Turns below this, in degrees, are due to rounding or the solver's tolerance.
const CLOSED: f64 = 0.01;

/// Why axes are not exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::fabricate) enum Reason {
    /// Corners: the number of panels of a part with an odd number of edges. Around each, axes close that
    /// are in one plane, so that beyond two there are in general none.
    OddPanels(usize),
    /// Corners: a panel, and the angle in degrees by which an axis is turned around it.
    PanelTurn(u32, f64),
    /// Corners, with openings: a rim has an odd number of edges.
    OddRim,
    /// Corners, with openings: the angle in degrees by which an axis is turned around a rim.
    RimTurn(f64),
    /// Corners: axes close around panels and rims, but not around openings through the surface.
    Openings,
    /// Panels: around some vertex they do not meet in one point.
    NoPoint,
    /// Panels: some are not flat.
    NotFlat,
    /// Beams: edges are not parallel to edges that touch one sphere.
    NoSphere,
    /// The distance error at this vertex is above the tolerance.
    Distance(u32),
    /// The warp of the beam between these vertices is.
    Warp([u32; 2]),
    /// The exact axes lean too far.
    Lean,
}

impl Closing {
    /// Why axes do not close around a panel or a rim of this part; none if they do.
    pub(in crate::fabricate) fn reason(&self) -> Option<Reason> {
        let turns = self.rims_deg.iter().flatten();
        let rim = turns.copied().fold(0.0, f64::max);
        if self.odd_panels > 2 {
            Some(Reason::OddPanels(self.odd_panels))
        } else if self.panel_deg > CLOSED {
            Some(Reason::PanelTurn(self.panel, self.panel_deg))
        } else if !self.has_openings {
            // Axes that close around all panels do around every rim, whatever others are turned by.
            None
        } else if self.rims_deg.contains(&None) {
            Some(Reason::OddRim)
        } else {
            (rim > CLOSED).then_some(Reason::RimTurn(rim))
        }
    }
}

impl Axes {
    /// Why these are not exact; none if they are. `are_flat` is whether all panels are flat. Where parts
    /// have different reasons it is one that no constraint on panels removes, if there is any.
    pub(in crate::fabricate) fn reason(
        &self,
        closings: &Closings,
        are_flat: bool,
    ) -> Option<Reason> {
        let of_part = |own: &Closing| own.reason().or(own.has_openings.then_some(Reason::Openings));
        let of_parts: Vec<_> = closings.parts.iter().map(of_part).collect();
        let of = |inexact: Inexact| {
            let cause = match (self.kind, inexact) {
                (_, Inexact::NoPoint | Inexact::Lean) => None,
                // The cause is in the part that has the error: others may close.
                (OffsetKind::Corner, Inexact::Distance(v) | Inexact::Warp([v, _])) => {
                    of_parts[closings.part_of[v as usize] as usize]
                }
                (OffsetKind::Face, _) => (!are_flat).then_some(Reason::NotFlat),
                (OffsetKind::Edge, _) => Some(Reason::NoSphere),
            };
            // Without a known cause, what was measured.
            cause.unwrap_or(match inexact {
                Inexact::NoPoint => Reason::NoPoint,
                Inexact::Distance(vertex) => Reason::Distance(vertex),
                Inexact::Warp(ends) => Reason::Warp(ends),
                Inexact::Lean => Reason::Lean,
            })
        };
        self.inexact.iter().map(|&inexact| of(inexact)).min_by_key(|reason| match reason {
            // What was measured does not tell whether a constraint helps.
            Reason::Distance(_) | Reason::Warp(_) => 2,
            Reason::PanelTurn(..) | Reason::NotFlat => 1,
            _ => 0,
        })
    }
}

impl Reason {
    /// The reason as a clause; panels have these `names`, a `node` and a `beam` those of their vertices, and
    /// exact offsets errors of at most `tolerance` mm.
    pub(in crate::fabricate) fn words(
        self,
        names: &[String],
        node: impl Fn(u32) -> String,
        beam: impl Fn([u32; 2]) -> String,
        tolerance: f64,
    ) -> String {
        let tolerance = words::millimetres_limit(tolerance);
        let plain = match self {
            Reason::OddPanels(panels) => {
                let panels = words::count(panels, "panel", "panels");
                return format!(
                    "the axes do not close around {panels} that have an odd number of edges"
                );
            }
            Reason::PanelTurn(panel, turn) => {
                let (name, turn) = (&names[panel as usize], words::degrees(turn));
                return format!(
                    "around panel {name} an axis is turned by {turn}: its corners are not on a circle"
                );
            }
            Reason::RimTurn(turn) => {
                let turn = words::degrees(turn);
                return format!(
                    "around a rim an axis is turned by {turn}, so the axes do not close"
                );
            }
            Reason::Distance(vertex) => {
                let name = node(vertex);
                return format!(
                    "the axes nearest to exact leave node {name} off its distance by more than {tolerance}"
                );
            }
            Reason::Warp(ends) => {
                let name = beam(ends);
                return format!(
                    "the axes nearest to exact leave beam {name} out of flat by more than {tolerance}"
                );
            }
            Reason::OddRim => {
                "a rim has an odd number of edges: axes close around it only in special shapes"
            }
            Reason::Openings => {
                "the axes do not close around the openings through the surface, as in a ring"
            }
            Reason::NoPoint => {
                "around some vertex, the panels moved by this distance do not meet in one point"
            }
            Reason::NotFlat => "the panels are not flat",
            Reason::NoSphere => {
                "only a mesh whose edges are parallel to edges that all touch one sphere allows this"
            }
            Reason::Lean => "the exact axes lean too far",
        };
        plain.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WARP: Inexact = Inexact::Warp([3, 7]);

    fn reason(closing: &Closing, inexact: Inexact) -> Option<Reason> {
        let axes = Axes { axes: Vec::new(), kind: OffsetKind::Corner, inexact: vec![inexact] };
        let closings = Closings { parts: vec![closing.clone()], part_of: vec![0; 8] };
        axes.reason(&closings, true)
    }

    #[test]
    fn an_odd_rim_is_the_reason_rather_than_a_turn_of_zero() {
        let of_rims = |rims: [Option<f64>; 2]| {
            let closing =
                Closing { rims_deg: rims.to_vec(), has_openings: true, ..Closing::default() };
            reason(&closing, WARP)
        };
        assert_eq!(of_rims([None, Some(0.0)]), Some(Reason::OddRim));
        assert_eq!(of_rims([Some(0.0), Some(1.5)]), Some(Reason::RimTurn(1.5)));
    }

    #[test]
    fn a_panel_that_can_be_made_circular_is_the_reason_beside_two_odd_ones() {
        let of_odd = |odd_panels| {
            reason(&Closing { odd_panels, panel_deg: 3.0, ..Closing::default() }, WARP)
        };
        assert_eq!(of_odd(2), Some(Reason::PanelTurn(0, 3.0)));
        assert_eq!(of_odd(3), Some(Reason::OddPanels(3)));
    }

    #[test]
    fn without_openings_a_rim_is_no_reason() {
        // The turn around two odd panels leaves the axis along the line of their planes.
        let two = Closing { odd_panels: 2, rims_deg: vec![Some(40.0)], ..Closing::default() };
        assert_eq!(reason(&two, WARP), Some(Reason::Warp([3, 7])));
        assert_eq!(two.reason(), None);
    }

    #[test]
    fn openings_or_the_lean_are_the_reason_only_where_they_are() {
        let closing =
            |has_openings| Closing { has_openings, panel_deg: 1e-5, ..Closing::default() };
        assert_eq!(reason(&closing(true), WARP), Some(Reason::Openings));
        // No cause is claimed that nobody measured.
        assert_eq!(reason(&closing(false), WARP), Some(Reason::Warp([3, 7])));
        assert_eq!(reason(&closing(true), Inexact::Lean), Some(Reason::Lean));
    }

    #[test]
    fn the_reason_is_that_of_the_part_that_is_not_exact() {
        let tube = Closing { has_openings: true, ..Closing::default() };
        let patch = Closing { odd_panels: 1, rims_deg: vec![None], ..Closing::default() };
        let panels = Closing { odd_panels: 4, ..Closing::default() };
        let closings =
            Closings { parts: vec![patch, tube, panels], part_of: vec![0, 0, 1, 1, 2, 2] };
        let of = |inexact: &[Inexact]| {
            let (kind, inexact) = (OffsetKind::Corner, inexact.to_vec());
            Axes { axes: Vec::new(), kind, inexact }.reason(&closings, true)
        };
        assert_eq!(of(&[]), None);
        assert_eq!(of(&[Inexact::Warp([2, 3])]), Some(Reason::Openings));
        assert_eq!(of(&[Inexact::Distance(5)]), Some(Reason::OddPanels(4)));
        assert_eq!(of(&[Inexact::Distance(1)]), Some(Reason::Distance(1)));
        assert_eq!(of(&[Inexact::Distance(1), Inexact::Warp([4, 5])]), Some(Reason::OddPanels(4)));
    }
}
