//! Beams along every edge, between the node axes at its ends. Fins are cut from flat sheet; prisms
//! are sawn, with ends mitred in planes through the axis. Node discs join the fins of a node.
//!
//! Source: Pottmann, Liu, Wallner, Bobenko, Wang, *Geometry of multi-layer freeform structures for architecture*
//! (2007): nodes without torsion.

mod alike;
mod disc;
mod fin;
mod near;
mod node;
mod prism;
mod seat;
mod size;

pub use alike::{edge_types, node_types};
pub use disc::{Disc, Slot};
pub use fin::{BeamPlane, EndRoom, Fin, cut_back, fin};
pub use node::{Node, Spoke, nodes};
pub use prism::{EndCut, Prism, end_cuts, prism};
pub use size::{DiscSize, FrameSize};

use crate::fabricate::alike::Types;
use crate::fabricate::surface::PanelSurface;
use crate::math::Vec3;
use seat::Lean;

/// The beams of a surface.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The node at each vertex.
    pub nodes: Vec<Option<Node>>,
    /// Types of nodes.
    pub types: Types,
    /// The fin of each edge, or the reason why there is none.
    pub fins: Vec<Result<Fin, &'static str>>,
    /// The disc of each vertex where fins end, or the reason why there is none; empty without discs.
    pub discs: Vec<Option<Result<Disc, &'static str>>>,
    /// The end cuts of prisms at each node, one for each of its beams.
    pub cuts: Vec<Vec<EndCut>>,
    /// The prism of each edge; none if there is no beam along it, or the cuts leave nothing of it.
    pub prisms: Vec<Option<Prism>>,
    /// Beams of whose prism the cuts leave nothing.
    pub without_prism: usize,
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
        let room = |node: &Node| room_at(surface, axes, node, size);
        let rooms: Vec<_> = nodes.iter().map(|node| node.as_ref().map(room)).collect();
        let (mut fins, mut prisms, mut without_prism) = (Vec::new(), Vec::new(), 0);
        for (edge, e) in surface.edges.iter().zip(0..) {
            let [i, j] = edge.ends.map(|v| v as usize);
            let (Some(a), Some(b), Some(first), Some(second)) =
                (&nodes[i], &nodes[j], rooms[i], rooms[j])
            else {
                fins.push(Err("one of its nodes has no axis"));
                prisms.push(None);
                continue;
            };
            fins.push(fin(surface, axes, [a, b], e, size.height, [first, second]));
            let cut = |node: &Node, v: usize| node.spoke_index(e).and_then(|k| cuts[v].get(k));
            let both = cut(a, i).zip(cut(b, j));
            let solid = both.and_then(|(p, q)| prism(surface, axes, e, [p, q], size.height));
            without_prism += usize::from(both.is_some() && solid.is_none());
            prisms.push(solid);
        }
        let discs =
            size.discs.map(|own| disc::discs((surface, axes), &nodes, &mut fins, size, own));
        let (types, discs) = (node_types(&nodes, alike_deg, mirror), discs.unwrap_or_default());
        Frame { types, nodes, fins, discs, cuts, prisms, without_prism }
    }

    /// The number of fins and discs.
    pub fn made(&self) -> usize {
        let discs = self.discs.iter().flatten().flatten().count();
        self.fins.iter().flatten().count() + discs
    }

    /// The largest step between the upper faces of neighbouring prisms, and its node.
    pub fn largest_step(&self) -> Option<(f64, u32)> {
        let steps =
            self.cuts.iter().zip(0..).flat_map(|(cuts, v)| cuts.iter().map(move |c| (c.step, v)));
        steps.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)))
    }
}

/// The room that fins leave at a node. With discs, no play is lost where beams are warped: fins that
/// lean from the axis move aside along it.
fn room_at(surface: &PanelSurface, axes: &[Vec3<f64>], node: &Node, size: FrameSize) -> EndRoom {
    let FrameSize { height, thickness, discs, .. } = size;
    let Some(DiscSize { clearance, .. }) = discs else {
        return EndRoom { thickness, play: 0.0 };
    };
    let end = |edge: u32| usize::from(surface.edges[edge as usize].ends[1] == node.vertex);
    let leans = node.spokes.iter().filter_map(|spoke| {
        let lean = Lean::of(surface, axes, spoke.edge, end(spoke.edge))?;
        Some((lean.drift.abs(), lean.cosine))
    });
    let (drift, cosine) = leans.fold((0.0, 1.0), |(drift, cosine), (own, least)| {
        (f64::max(drift, own), f64::min(cosine, least))
    });
    let long = axes[node.vertex as usize].length();
    let aside = drift * (height.abs() * long + thickness);
    EndRoom { thickness: thickness / cosine + 2.0 * aside, play: clearance }
}
