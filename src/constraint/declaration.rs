//! The declaration of a kind: all that hosts and tests need to show or check it generically.

use super::parameter::Param;
use super::select::Element;
use serde::Serialize;

/// The declaration of a kind: all that hosts and tests need to show or check it generically.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Info {
    /// The id in scene files and on the command line.
    pub id: &'static str,
    /// The name on the page.
    pub label: &'static str,
    /// The condition on its vertices, in one sentence.
    pub summary: &'static str,
    /// The section of the paper that defines it; empty if none does.
    pub paper: &'static str,
    /// The number of points.
    pub arity: Arity,
    /// The translations under which it is invariant, which determine the points centred together.
    pub centring: Centring,
    /// The elements whose vertex order the kind relies on; hosts offer it on these only. Empty if
    /// it can act on any element.
    pub elements: &'static [Element],
    /// Whether the projection, with the default parameters, is the closest point of the set. If
    /// not, the total energy can rise, unless the `monotone` guard is on.
    pub exact: bool,
    /// The measure (`"planarity"` or `"circularity"`) of the deviation of faces from the shape, for
    /// constraints on faces. None if no face measure applies.
    pub measure: Option<&'static str>,
    /// The adjective for panels that have the shape ("flat"), for kinds that hosts offer for all
    /// panels by one press. Such a kind has a `measure` of faces, and every triangle satisfies it.
    pub panels: Option<&'static str>,
    /// The sRGB colour of its members on the page.
    pub colour: [u8; 3],
    /// The parameters of the scene file.
    pub params: &'static [Param],
    /// The selections for which the kind is the usual choice; hosts preselect it there.
    #[serde(skip)]
    pub default_for: &'static [TargetShape],
}

impl Info {
    /// A kind of no paper and without parameters, exact, on any element, and invariant under
    /// translation. A declaration states what differs, and its id, texts, arity and colour.
    pub(crate) const PLAIN: Info = Info {
        id: "",
        label: "",
        summary: "",
        paper: "",
        arity: Arity::AtLeast(1),
        centring: Centring::Together,
        elements: &[],
        exact: true,
        measure: None,
        panels: None,
        colour: [0; 3],
        params: &[],
        default_for: &[],
    };

    /// What the points of a constraint are counted as, in singular and plural, and how many of them one
    /// of these is: an edge is two, its ends.
    pub(crate) fn counted_as(&self) -> ([&'static str; 2], usize) {
        match self.centring {
            Centring::ByEdge => (["edge", "edges"], 2),
            Centring::Together | Centring::Placed => (["vertex", "vertices"], 1),
        }
    }

    /// The number of vertices or edges, in words.
    pub fn arity_in_words(&self) -> String {
        let ([_, many], each) = self.counted_as();
        match self.arity {
            Arity::AtLeast(least) => format!("{} or more {many}", least / each),
            Arity::Exactly(exactly) => format!("exactly {} {many}", exactly / each),
        }
    }
}

/// The number of vertices of a constraint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "kebab-case")]
pub enum Arity {
    /// This many or more.
    AtLeast(usize),
    /// Exactly this many.
    Exactly(usize),
}

impl Arity {
    /// Whether `n` vertices are allowed.
    pub const fn fits(self, n: usize) -> bool {
        match self {
            Arity::AtLeast(least) => n >= least,
            Arity::Exactly(exactly) => n == exactly,
        }
    }
}

/// The points of a constraint that are centred together: `N_i` of Eq. 5 subtracts their mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "kebab-case")]
pub enum Centring {
    /// All points: the shape may be anywhere.
    Together,
    /// The two ends of each edge: the shape depends on edge vectors only. The points come in pairs,
    /// one for each edge of the mesh between selected vertices; a vertex may be in several pairs.
    ByEdge,
    /// None: the shape has a fixed location.
    Placed,
}

/// The shape of a selection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TargetShape {
    /// Faces of four or more corners, one constraint each.
    Panels,
    /// Triangles, one constraint each.
    Triangles,
    /// Edges, one constraint each.
    Edges,
    /// Closed loops of edges.
    Loop,
    /// Open chains of edges.
    Chain,
    /// Several faces together, but not the whole mesh.
    Patch,
    /// Several vertices not joined by edges to one of the above.
    Points,
}
