//! Beams: along every edge, between a node axis at each end. Fins are cut from flat sheet; prisms are sawn,
//! their ends mitred in planes through the axis.
//!
//! Source: Pottmann, Liu, Wallner, Bobenko, Wang, *Geometry of multi-layer freeform structures for architecture*
//! (2007): nodes without torsion.
//!
//! | file | holds |
//! |---|---|
//! | `node` | the beams around each node: azimuth and elevation about its axis |
//! | `alike` | nodes and edges that are the same within a tolerance |
//! | `fin` | outlines of fins, cut back at the nodes |
//! | `prism` | prisms with mitres, and the steps between their upper faces |
//! | `frame` | all of them for one surface |

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
