//! Parts shared by several operators.
//!
//! | file | holds |
//! |---|---|
//! | `pitot` | quads with an incircle, and pairs of triangles with tangent incircles |
//! | `symmetry_group` | a mirror plane or a rotation axis, and the pairing of images |
//! | `separate_lanes` | projection lane by lane, for operators whose control flow depends on the points |

pub(super) mod pitot;
mod separate_lanes;
mod symmetry_group;

pub(crate) use separate_lanes::separate_lanes;
pub(crate) use symmetry_group::SymmetryGroup;
