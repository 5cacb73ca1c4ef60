//! A mesh from a plan: a closed outline on the ground, divided into panels and raised.

mod cut;
mod declaration;
mod follow;
mod outline;
mod surface;

pub use declaration::{Plan, PlanError, PlanLayout, PlanPoint, PlanSide, Support};
pub use surface::PlanSurface;
