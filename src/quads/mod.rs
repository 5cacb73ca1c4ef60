//! Quads along the lines of curvature of any surface: a cross field aligned with curvature, a seamless
//! map rounded to the integer grid, and the exact extraction of the grid.
//!
//! | file or folder | holds |
//! |---|---|
//! | `grid_map` | the triangulated surface and the integer-grid map, in fixed point |
//! | `options` | settings, stages |
//! | `error`, `fault` | why a surface cannot be remeshed, why it has no map, and what is wrong with a result |
//! | `system` | sparse systems with some unknowns given |
//! | `surface` | the input prepared: refined, with features |
//! | `field` | the cross field and its cut |
//! | `map` | the seamless map and its rounding |
//! | `extract` | the exact extraction of the grid |
//! | `repair` | faces that are not quads, replaced |
//! | `glide` | vertices glide until panels are nearer to circles |
//! | `result` | checks and measures of the result |
//! | `part` | one connected part |
//! | `remesh` | all parts |
//! | `remeshed` | the result: one mesh, its measures and notes |
//! | `sliders` | the choices of users |

mod error;
mod extract;
mod fault;
mod field;
mod glide;
mod grid_map;
mod map;
mod options;
mod part;
mod remesh;
mod remeshed;
mod repair;
mod result;
mod sliders;
mod surface;
mod system;

pub use error::RemeshError;
pub use fault::{MapFault, ResultFault};
pub use grid_map::{FRACTION_BITS, GridMap, Side, Transition, Triangulation, UNIT};
pub use map::{GridMapper, MapNotes, MapVisitor};
pub use options::{Boundary, MapOptions, PanelSize, RemeshObserver, RemeshStage};
pub use remesh::{Remesher, remesh};
pub use remeshed::{RemeshNote, Remeshed};
pub use result::{AngleToCurvature, EdgeLengths, Irregular, LargestDistances, RemeshMeasures};
pub use sliders::{direction_weight, follow_weight};
pub use surface::{InputParts, InputSurface, Opening, PrepareNotes, Prepared, StayingPart};
