//! Parts that several operators share.
//!
//! | file | holds |
//! |---|---|
//! | `pitot` | quads with an incircle, and pairs of them whose incircles touch |
//! | `symmetry_group` | the symmetries of a regular polygon about an axis |
//! | `separate_lanes` | lane by lane, for operators whose work depends on where the points are |

pub(super) mod pitot;
mod separate_lanes;
mod symmetry_group;

pub(crate) use separate_lanes::separate_lanes;
pub(crate) use symmetry_group::SymmetryGroup;
