//! New meshes to start from: a few kinds defined by sizes, from a plan, or between curves. `z`
//! points up, except between curves; every mesh stands or lies on the ground, and has the same bits
//! on every machine.
//!
//! | file | holds |
//! |---|---|
//! | `declaration` | declaration of a kind, and errors in its sizes |
//! | `face_count` | the limit of the number of faces |
//! | `even_steps` | points in equal steps along a curve of several pieces |
//! | `coons_patch` | the grid between four sides |
//! | `list` | the kinds |
//! | `sheets` | flat and arched sheets: quads, triangles, hexagons |
//! | `round` | meshes of revolution |
//! | `plan` | a mesh from a closed outline on the ground |
//! | `span` | a mesh between curves of a file |

mod coons_patch;
mod declaration;
mod even_steps;
mod face_count;
mod list;
mod plan;
mod round;
mod sheets;
mod span;

pub use declaration::{NewKind, NewMeshError};
pub use face_count::TooManyFaces;
pub use list::NEW_KINDS;
pub use plan::{Plan, PlanError, PlanLayout, PlanPoint, PlanSide, PlanSurface, Support};
pub use span::{CurveLabel, SpanCurve, SpanError, fill, loft};
