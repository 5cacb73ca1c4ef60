//! Beams along every edge, between the node axes at its ends. Fins are cut from flat sheet; prisms
//! are sawn, with ends mitred in planes through the axis.
//!
//! Source: Pottmann, Liu, Wallner, Bobenko, Wang, *Geometry of multi-layer freeform structures for architecture*
//! (2007): nodes without torsion.
//!
//! | file | holds |
//! |---|---|
//! | `node` | the beams around each node: azimuth and elevation about its axis |
//! | `alike` | types of nodes and of edges |
//! | `fin` | outlines of fins, cut back at the nodes |
//! | `prism` | prisms with mitres, and the steps between their upper faces |
//! | `frame` | all nodes and beams of a surface |

mod alike;
mod fin;
mod frame;
mod node;
mod prism;

pub use alike::{edge_types, node_types};
pub use fin::{Fin, cut_back, fin};
pub use frame::{Frame, FrameSize};
pub use node::{Node, Spoke, nodes};
pub use prism::{EndCut, Prism, end_cuts, prism};
