//! One way to meet hard constraints, and which ways a search may take.

use super::easing::Tolerances;
use super::outcome::Level;
use crate::scene::{AttemptStart, ChosenAttempt};
use crate::solve::Requirements;
use serde::Serialize;

/// What the search may do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Search {
    /// Only the first attempt: the shape follows a drag.
    Off,
    /// The attempts that keep the settings of the scene but for its smoothness.
    Scene,
    /// All of them, with tolerances above this required one for some panels at last (unit of the
    /// mesh).
    Panels(f64),
}

/// Maximum number of iterations of attempts after the first, and within a larger tolerance: if more,
/// the shape resists.
const MOST_ITERATIONS: u32 = 900;
const MOST_EASED_ITERATIONS: u32 = 600;

/// One way to meet hard constraints.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Attempt {
    /// With the requirements of the scene, from the soft solution.
    FromSoft,
    /// The same, starting at the rest shape.
    FromRest,
    /// With exact panels.
    Exact,
    /// Vertices may slide over the surface, and those of the boundary along it; from the soft solution
    /// with this closeness.
    OnSurface,
    /// With the smoothness weight multiplied by this factor; where a handle pulls, from the soft
    /// solution with it.
    Smoother(f64),
    /// The same, always from that soft solution.
    SmootherFromSoft(f64),
    /// With the panels within these tolerances, in few iterations.
    Eased(Tolerances),
}

impl Attempt {
    /// What the run does meanwhile, in words.
    pub(crate) fn words(&self) -> &'static str {
        match self {
            Attempt::FromSoft => "Satisfying what is required …",
            Attempt::FromRest => "Trying from the original shape …",
            Attempt::Exact => "Trying exact panels …",
            Attempt::OnSurface => "Trying vertices that slide along the surface …",
            Attempt::Smoother(_) | Attempt::SmootherFromSoft(_) => "Trying a smoother shape …",
            Attempt::Eased(_) => "Trying relaxed tolerances …",
        }
    }

    /// Maximum number of iterations of the approach.
    pub(crate) fn iterations(&self) -> u32 {
        match self {
            Attempt::FromSoft | Attempt::OnSurface | Attempt::SmootherFromSoft(_) => {
                Requirements::ITERATIONS
            }
            Attempt::Eased(_) => MOST_EASED_ITERATIONS,
            _ => MOST_ITERATIONS,
        }
    }

    /// How the scene says that this attempt was chosen.
    pub(crate) fn chosen(&self) -> ChosenAttempt {
        let chosen = |from| ChosenAttempt { from, ..ChosenAttempt::default() };
        match self {
            Attempt::FromSoft => chosen(AttemptStart::Soft),
            Attempt::FromRest => chosen(AttemptStart::Rest),
            Attempt::Exact => chosen(AttemptStart::Exact),
            Attempt::OnSurface => ChosenAttempt { on_surface: true, ..chosen(AttemptStart::Soft) },
            Attempt::Smoother(smoother) => {
                ChosenAttempt { smoother: *smoother, ..chosen(AttemptStart::Rest) }
            }
            Attempt::SmootherFromSoft(smoother) => {
                ChosenAttempt { smoother: *smoother, ..chosen(AttemptStart::Soft) }
            }
            Attempt::Eased(Tolerances { settings, .. }) => {
                ChosenAttempt { from: AttemptStart::Eased, ..*settings }
            }
        }
    }
}

/// An attempt that has ended.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Tried {
    /// Its name: `soft`, `rest`, `exact`, `surface`, `smoother 10`, `eased`.
    pub name: String,
    /// The level of its shape.
    pub level: Level,
    /// Number of constraints that it did not meet.
    pub misses: usize,
    /// Number of faces that it folded.
    pub folded: usize,
    /// Largest distance of a vertex from its rest position, in the unit of the mesh.
    pub moved: f64,
}
