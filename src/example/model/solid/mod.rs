//! Solids, surfaces of solids, and points without faces.
//!
//! | file | makes |
//! |---|---|
//! | `archway` | a block with a pitched roof and a round passage: creases and corners |
//! | `blocks` | blocks of cubes: their surface, and tetrahedra |
//! | `creature`, `implicit` | an animal of blended round parts, polygonised from an implicit function |
//! | `lattice` | points of a grid in space |
//! | `pavilion` | points without faces: a floor, a wall, columns and a dome |

mod archway;
mod blocks;
mod creature;
mod implicit;
mod lattice;
mod pavilion;

pub use archway::Archway;
pub use blocks::Blocks;
pub use creature::Creature;
pub use pavilion::Pavilion;
