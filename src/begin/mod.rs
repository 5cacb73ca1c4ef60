//! Meshes to begin with: a few kinds, each with the sizes that it is made by. All are in the frame that `z` points up
//! in, stand on the ground or lie on it, and have the same bits on every machine.
//!
//! | file | holds |
//! |---|---|
//! | `declaration` | what a kind and its sizes are, and what sizes are refused |
//! | `list` | the kinds |
//! | `sheets` | the flat and the arched ones: quads, triangles, hexagons |
//! | `round` | those around an axis |
//! | `plan` | a mesh from a closed outline on the ground |
//! | `span` | a mesh between curves of a file |

mod declaration;
mod list;
mod plan;
mod round;
mod sheets;
mod span;

pub use declaration::{NewKind, NewMeshError};
pub use list::NEW_KINDS;
pub use plan::{Plan, PlanError, PlanLayout, PlanPoint, PlanSide, PlanSurface, Standing};
pub use span::{CurveWords, SpanCurve, SpanError, fill, loft};
