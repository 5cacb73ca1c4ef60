//! Offsets: a node axis `n_i` for every vertex, such that the mesh `v_i + d n_i` has parallel edges and keeps
//! its distance. It is then a parallel mesh (Combescure transform), and every strip
//! `v_i, v_j, v_j + d n_j, v_i + d n_i` is a flat beam for every `d`.
//!
//! Sources: Liu, Pottmann, Wallner, Yang, Wang, *Geometric modeling with conical meshes and developable
//! surfaces* (2006); Pottmann, Liu, Wallner, Bobenko, Wang, *Geometry of multi-layer freeform structures for
//! architecture* (2007), which has the three kinds of offsets.
//!
//! | file | holds |
//! |---|---|
//! | `system` | the sparse system of 3 by 3 blocks of one step |
//! | `axes` | node axes: the exact ones, else the least-squares fit |
//! | `newton` | the least-squares fit |
//! | `exact` | the exact pass, and whether it is worthwhile |
//! | `closing` | why corner offsets are not exact: turns around panels and holes |
//! | `check` | the numbers that show whether an offset can be built |
//! | `choice` | the errors by which kinds are compared |

mod axes;
mod check;
mod choice;
mod closing;
mod exact;
mod newton;
mod system;

pub(super) use axes::axes_of;
pub use axes::{Axes, exact, fit};
pub use check::{BeamCheck, NodeCheck, OffsetCheck, check};
pub use choice::Choice;
pub use closing::{Closing, closing};
pub(super) use exact::can_be_exact;
pub(super) use system::across_edge;
