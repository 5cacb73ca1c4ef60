//! The seamless map along a cross field, and its rounding to the integer grid.
//!
//! | file | holds |
//! |---|---|
//! | `elimination` | linear equations in integers |
//! | `seams` | unknowns of the map, equations over cuts and along features |
//! | `energy` | the energy of a map |
//! | `seamless` | the map without integers |
//! | `rounding` | greedy rounding on a dense matrix |
//! | `integer` | maps with integers |
//! | `separation` | integers between points that rounding throws together |
//! | `lbfgs` | minimisation of a smooth function |
//! | `untangle` | flipped triangles turned back, patch by patch |
//! | `snap` | fixed point |
//! | `budget` | what the search may cost |
//! | `relaxed` | a field with its seamless map and the maps rounded from it |
//! | `levels` | all of it, with retries |

mod budget;
mod elimination;
mod energy;
mod integer;
mod lbfgs;
mod levels;
mod relaxed;
mod rounding;
mod seamless;
mod seams;
mod separation;
mod snap;
mod untangle;

pub use levels::{GridMapper, MapNotes, MapVisitor};
