//! Reasons why something cannot be built, and the products that are still available.

use std::fmt;

/// One sentence: the problem, and what is available nevertheless.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault(pub String);

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Fault {}

impl Fault {
    /// Points and curves have nothing to cut.
    pub(super) fn no_panels(has_curves: bool) -> Fault {
        let what = if has_curves { "curves" } else { "points" };
        Fault(format!(
            "the model has {what} and no faces, expected a surface of panels: there is nothing to cut"
        ))
    }

    /// The surface has only one side, such as a Moebius strip.
    pub(super) fn one_sided([a, b]: [u32; 2]) -> Fault {
        Fault(format!(
            "the surface has one side only (seen at the edge of vertices {a} and {b}), so that it has no outside: panels can be cut and folded, offsets and beams are not offered"
        ))
    }

    /// Edges with more than two panels.
    pub(super) fn crowded_edges(edges: usize) -> Fault {
        let edges = match edges {
            1 => "1 edge has".to_owned(),
            many => format!("{many} edges have"),
        };
        Fault(format!(
            "{edges} more than two panels, so that the surface has no outside there: panels can be cut and folded, offsets and beams are not offered"
        ))
    }

    /// There are no quads for strips to follow.
    pub(super) fn no_strips() -> Fault {
        Fault(
            "the surface has no panels of four edges, which strips follow: nets are made instead"
                .to_owned(),
        )
    }

    /// Panels that are folded over.
    pub(super) fn folded_over(panels: &[u32]) -> Fault {
        let what = match panels {
            [one] => format!("panel {one} is folded over, its outside"),
            many => {
                let (count, first) = (many.len(), many[0]);
                format!("{count} panels are folded over (the first is {first}), their outside")
            }
        };
        Fault(format!(
            "{what} is turned against the shape around: panels can be cut and folded, offsets and beams are not offered"
        ))
    }
}
