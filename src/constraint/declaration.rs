//! The declaration of a kind: everything that hosts show or check without knowing it.

use super::parameter::Param;
use super::select::Element;
use serde::Serialize;

/// The declaration of a kind: everything that hosts show or check without knowing it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Info {
    /// The id in scene files and on the command line.
    pub id: &'static str,
    /// The name on the page.
    pub label: &'static str,
    /// The condition on its vertices, in one sentence.
    pub summary: &'static str,
    /// Where the paper defines it.
    pub paper: &'static str,
    /// How many points it takes.
    pub arity: Arity,
    /// The translations it is invariant under, hence which points are centred together.
    pub centring: Centring,
    /// The elements whose vertices come in the order that it means; hosts offer it on these only.
    /// Empty where any elements will do.
    pub elements: &'static [Element],
    /// Whether the projection is the closest point of the set, with the default parameters. Where it is
    /// not, the total energy can rise, unless the `monotone` guard is on.
    pub exact: bool,
    /// The error measure of a face (`"planarity"` or `"circularity"`) that says how far faces are
    /// from the shape, when they are what it acts on. None where no measure of a face does.
    pub measure: Option<&'static str>,
    /// The adjective for panels that have the shape ("flat"), of kinds that hosts offer for all panels by one
    /// press. Such a kind has a `measure` of faces, and every triangle meets it.
    pub panels: Option<&'static str>,
    /// The colour of its members on the page, as sRGB bytes.
    pub colour: [u8; 3],
    /// The parameters of the scene file.
    pub params: &'static [Param],
}

impl Info {
    /// How many vertices or edges it takes, in words.
    pub fn takes(&self) -> String {
        match (self.centring, self.arity) {
            (Centring::ByEdge, Arity::AtLeast(ends)) => format!("{} or more edges", ends / 2),
            (Centring::ByEdge, Arity::Exactly(ends)) => format!("exactly {} edges", ends / 2),
            (_, arity) => arity.to_string(),
        }
    }
}

/// How many vertices a constraint takes.
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
    /// Whether `n` vertices fit.
    pub const fn fits(self, n: usize) -> bool {
        match self {
            Arity::AtLeast(least) => n >= least,
            Arity::Exactly(exactly) => n == exactly,
        }
    }
}

impl std::fmt::Display for Arity {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Arity::AtLeast(least) => write!(f, "{least} or more vertices"),
            Arity::Exactly(exactly) => write!(f, "exactly {exactly} vertices"),
        }
    }
}

/// Which points of a constraint are centred together: `N_i` of Eq. 5 takes the mean of these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "kebab-case")]
pub enum Centring {
    /// All of them: the shape may be anywhere.
    Together,
    /// The two ends of each edge: what counts is the vectors along edges. The points come in pairs,
    /// the edges of the mesh between the vertices that are selected; a vertex may be in several.
    ByEdge,
    /// None: the shape has a place.
    Placed,
}
