//! New meshes to start from: a few kinds defined by sizes, from a plan, or between curves; and the
//! examples, with the models that they show. `z` points up, except between curves; every new mesh
//! stands or lies on the ground. Only `+ - * / sqrt`, and `libm` for angles, are used, so that every
//! machine computes the same bits.
//!
//! | file or folder | holds |
//! |---|---|
//! | `kind` | new meshes by kind and sizes: sheets, and meshes of revolution |
//! | `plan` | a mesh from a closed outline on the ground |
//! | `span` | a mesh between curves of a file |
//! | `model` | the meshes of the examples |
//! | `example` | the example scenes, and their files |
//! | `quads` | rows of quads, and the limit of the number of faces |
//! | `finish` | what generators of any kind do with a mesh, and random numbers |
//! | `hexagons` | hexagons and other polygons over a square |
//! | `sides` | points in equal steps along a side, and the grid between four sides |

pub mod example;
mod finish;
mod hexagons;
mod kind;
pub mod model;
mod plan;
mod quads;
mod sides;
mod span;

pub use kind::{NEW_KINDS, NewKind, NewMeshError};
pub use plan::{
    DrawnSide, Plan, PlanDrawing, PlanError, PlanLayout, PlanLoops, PlanPoint, PlanSide,
    PlanSurface, Support, bulge_of, bulge_through, end_of_side, loop_through,
};
pub use quads::TooManyFaces;
pub use span::{CurveLabel, SpanCurve, SpanError, fill, loft};
