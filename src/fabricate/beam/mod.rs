//! Beams along every edge, between the node axes at its ends. Fins are cut from flat sheet; prisms
//! are sawn, with ends mitred in planes through the axis.
//!
//! Source: Pottmann, Liu, Wallner, Bobenko, Wang, *Geometry of multi-layer freeform structures for architecture*
//! (2007): nodes without torsion.

mod alike;
mod fin;
mod node;
mod prism;

pub use alike::{edge_types, node_types};
pub use fin::{Fin, cut_back, fin};
pub use node::{Node, Spoke, nodes};
pub use prism::{EndCut, Prism, end_cuts, prism};

use crate::fabricate::alike::Types;
use crate::fabricate::surface::PanelSurface;
use crate::math::Vec3;

/// Dimensions of beams, in the unit of the mesh.
#[derive(Clone, Copy, Debug)]
pub struct FrameSize {
    /// The height of fins and prisms, negative inwards.
    pub height: f64,
    /// The width of prisms.
    pub width: f64,
    /// The thickness of fins.
    pub thickness: f64,
}

/// The beams of a surface.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The node at each vertex.
    pub nodes: Vec<Option<Node>>,
    /// Types of nodes.
    pub types: Types,
    /// The fin of each edge, or the reason why there is none.
    pub fins: Vec<Result<Fin, &'static str>>,
    /// The end cuts of prisms at each node, one for each of its beams.
    pub cuts: Vec<Vec<EndCut>>,
    /// The prism of each edge; none if the cuts leave nothing of it.
    pub prisms: Vec<Option<Prism>>,
}

impl Frame {
    /// The beams along all edges for these node axes (`#V`). Nodes whose angles differ by at most
    /// `alike_deg` have the same type.
    pub fn new(
        surface: &PanelSurface,
        axes: &[Vec3<f64>],
        size: FrameSize,
        alike_deg: f64,
        mirror: bool,
    ) -> Frame {
        let nodes = nodes(surface, axes);
        let cuts: Vec<Vec<EndCut>> = nodes
            .iter()
            .map(|node| {
                node.as_ref().map_or(Vec::new(), |node| end_cuts(surface, axes, node, size.width))
            })
            .collect();
        let (mut fins, mut prisms) = (Vec::new(), Vec::new());
        for (edge, e) in surface.edges.iter().zip(0..) {
            let [i, j] = edge.ends.map(|v| v as usize);
            let (Some(a), Some(b)) = (&nodes[i], &nodes[j]) else {
                fins.push(Err("one of its nodes has no axis"));
                prisms.push(None);
                continue;
            };
            fins.push(fin(surface, axes, [a, b], e, size.height, size.thickness));
            let cut = |node: &Node, v: usize| node.spoke_index(e).and_then(|k| cuts[v].get(k));
            let both = cut(a, i).zip(cut(b, j));
            prisms.push(both.and_then(|(p, q)| prism(surface, axes, e, [p, q], size.height)));
        }
        Frame { types: node_types(&nodes, alike_deg, mirror), nodes, fins, cuts, prisms }
    }

    /// The largest step between the upper faces of neighbouring prisms, and its node.
    pub fn largest_step(&self) -> Option<(f64, u32)> {
        let steps =
            self.cuts.iter().zip(0..).flat_map(|(cuts, v)| cuts.iter().map(move |c| (c.step, v)));
        steps.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)))
    }
}
