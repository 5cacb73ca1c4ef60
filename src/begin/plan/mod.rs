//! A mesh from a plan: a closed outline on the ground, divided into panels and raised.
//!
//! | file | holds |
//! |---|---|
//! | `declaration` | the description of a plan, and its errors |
//! | `outline` | closed loops of straight and arc sides |
//! | `follow` | a grid whose four sides follow the outline |
//! | `cut` | a straight grid cut to the outline and its holes |
//! | `raise` | the height of every vertex |
//! | `surface` | the surface over a plan: loops, panels, heights |

mod cut;
mod declaration;
mod follow;
mod outline;
mod raise;
mod surface;

pub use declaration::{Plan, PlanError, PlanLayout, PlanPoint, PlanSide, Support};
pub use raise::PlanSurface;
