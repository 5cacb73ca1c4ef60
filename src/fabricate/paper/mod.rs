//! Paper models: panels laid flat side by side as strips and nets, folded along their edges, and
//! joined with tabs for glue, or tongues in slots, that are hidden behind the neighbour. They are cut along
//! the seams that the user chooses, and elsewhere as little as possible. Card has a thickness instead, and
//! neither tabs nor tongues.

mod drawn;
mod facet;
mod grow;
mod kerf;
mod net;
mod plane;
mod strip;
mod tab;
mod tab_name;
mod thickness;
mod tongue;
mod touching;

pub use drawn::{MissingNames, drawn, write_names};
pub use facet::{Facet, FacetSide, FoldKind, Joint};
pub(in crate::fabricate) use kerf::reach;
pub use net::PaperNet;
pub use plane::Motion;
pub use tab::{LEAST_TAB, Tab};
pub use thickness::{Card, Uneven};
pub use tongue::{Fit, Tongue};

use crate::fabricate::boxes::Boxes;
use crate::fabricate::panel::{FlatPanel, smallest_box_within};
use crate::fabricate::surface::{PanelSurface, distinct};
use crate::math::plane::{Point2, bounds};
use crate::math::sort_by_number;
use crate::scene::{Pieces, ordered};
use facet::facets;
use std::collections::{BTreeMap, BTreeSet};
use strip::{Foldable, foldable};
use tab::{around, tab};
use tongue::tongue;

/// Sizes in mm.
#[derive(Clone, Copy, Debug)]
pub struct PaperSize {
    /// Millimetres of the sheet per unit of the mesh.
    pub model: f64,
    /// Largest size of a piece with its tabs.
    pub room: [f64; 2],
    /// The height of tabs, and of tongues and their flanges; 0 for none.
    pub tab: f64,
    /// What tongues and slots are made for; none for tabs with glue alone.
    pub slots: Option<Fit>,
    /// The material.
    pub card: Card,
}

impl PaperSize {
    /// The height that is kept free around a piece while it grows: of tabs, unless they are so high
    /// that they would leave little of the sheet.
    fn reserved(self) -> f64 {
        self.tab.min(0.25 * self.room[0].min(self.room[1]))
    }
}

/// How a joint is made.
#[derive(Clone, Copy, Debug)]
pub enum JointKind {
    /// Folded.
    Folded,
    /// Cut, with a tab on one of its sides.
    Tab(Tab),
    /// Cut, with a tongue on one of its sides and its slot on the other.
    Tongue(Tongue),
    /// Cut, without room for a tab on either side.
    Bare,
}

/// A paper model.
#[derive(Clone, Debug)]
pub struct PaperModel {
    /// Facets, joints and their positions.
    pub net: PaperNet,
    /// How each joint is made.
    pub joint_kinds: Vec<JointKind>,
    /// The joints whose tab, tongue or slot is on each piece of the net.
    tab_joints: Vec<Vec<u32>>,
    /// The pieces of the net that have facets, sorted by their first facet.
    pub pieces: Vec<u32>,
    /// The panels beyond each side of a facet that has no joint because there are several of them, one
    /// that traverses the side in the same direction, or one without area before them.
    pub unpaired: BTreeMap<FacetSide, Vec<u32>>,
    /// Where card cannot be cut back as its folds ask.
    pub uneven: Uneven,
    /// Panels without facets, and the reasons.
    pub without: Vec<(u32, &'static str)>,
    /// Whether nets are made because strips were requested and there are no quads.
    pub is_without_quads: bool,
}

impl PaperModel {
    /// The paper model of a surface whose panels are laid `flat`. Edges between two vertices of `seams` are
    /// cut.
    pub fn new(
        surface: &PanelSurface,
        flat: &[Option<FlatPanel>],
        pieces: Pieces,
        size: PaperSize,
        seams: &[[u32; 2]],
    ) -> PaperModel {
        let (mut facets, mut joints, without) = facets(surface, flat, size.model);
        let uneven = size.card.cut_back(surface, &mut facets, &mut joints);
        cut_seams(surface, &mut joints, seams);
        let order = foldable(surface, &joints, pieces);
        let is_without_quads = order.is_none();
        let order = order.or_else(|| foldable(surface, &joints, Pieces::Nets));
        let unpaired = unpaired(surface, &facets);
        let unfolded = PaperNet::new(facets, joints);
        let mut net =
            order.map_or_else(|| unfolded.clone(), |order| folded(&unfolded, &order, size));
        let mut pieces: Vec<u32> =
            (0..net.pieces.len() as u32).filter(|&p| !net.pieces[p as usize].is_empty()).collect();
        net.pieces.iter_mut().for_each(|own| own.sort_unstable());
        sort_by_number(&mut pieces, |&piece| u64::from(net.pieces[piece as usize][0]));
        let joint_kinds = joint_kinds(&net, &pieces, size);
        let mut tab_joints = vec![Vec::new(); net.pieces.len()];
        for (kind, joint) in joint_kinds.iter().zip(0..) {
            for piece in distinct(kind.sides().map(|(f, _)| net.piece_of[f as usize])) {
                tab_joints[piece as usize].push(joint);
            }
        }
        PaperModel {
            net,
            joint_kinds,
            tab_joints,
            pieces,
            unpaired,
            uneven,
            without,
            is_without_quads,
        }
    }

    /// The number of panels of which the folds leave an inner face of every facet.
    pub fn made(&self) -> usize {
        made_of(&self.net.facets, &self.uneven)
    }

    /// As [`PaperModel::made`], of a model of this size.
    pub fn made_at(surface: &PanelSurface, flat: &[Option<FlatPanel>], size: PaperSize) -> usize {
        let (mut facets, mut joints, _) = facets(surface, flat, size.model);
        let uneven = size.card.cut_back(surface, &mut facets, &mut joints);
        made_of(&facets, &uneven)
    }

    /// Whether each facet of a model of this size has room on a sheet. Then every piece has: facets are
    /// joined only where they have room together.
    pub fn has_room(surface: &PanelSurface, flat: &[Option<FlatPanel>], size: PaperSize) -> bool {
        let (mut facets, mut joints, _) = facets(surface, flat, size.model);
        size.card.cut_back(surface, &mut facets, &mut joints);
        facets.iter().all(|facet| lies_on(&facet.corners, size.room))
    }

    /// The corners of the outline of a piece between the start and the end of a side: of a tab, of the
    /// flange with a slot, or of a tongue.
    fn added(&self, side: FacetSide) -> Vec<Point2> {
        let Some((joint, _)) = self.net.across(side) else { return Vec::new() };
        match &self.joint_kinds[joint as usize] {
            JointKind::Tab(tab) if tab.side == side => tab.corners[1..3].to_vec(),
            JointKind::Tongue(own) if own.flange.side == side => own.flange.corners[1..3].to_vec(),
            JointKind::Tongue(own) => own.corners(&self.net).to_vec(),
            _ => Vec::new(),
        }
    }

    /// Whether it has tongues and slots.
    pub fn has_tongues(&self) -> bool {
        self.joint_kinds.iter().any(|kind| matches!(kind, JointKind::Tongue(_)))
    }

    /// The lines along which a piece is scored, each fold once, and how it is folded.
    pub fn scores(&self, piece: u32) -> impl Iterator<Item = ([Point2; 2], FoldKind)> {
        let facets = self.net.pieces[piece as usize].iter();
        let sides = facets.flat_map(|&f| {
            (0..self.net.facets[f as usize].corners.len() as u32).map(move |k| (f, k))
        });
        sides.flat_map(|side| {
            let Some((joint, _)) = self.net.across(side) else { return Vec::new() };
            let own = &self.net.joints[joint as usize];
            let lines = match &self.joint_kinds[joint as usize] {
                JointKind::Folded if own.sides[0] == side && own.kind() != FoldKind::Flat => {
                    vec![self.net.fold_line(side)]
                }
                JointKind::Tab(tab) if tab.side == side => vec![self.net.fold_line(side)],
                JointKind::Tongue(tongue) => tongue.scores(&self.net, side),
                _ => Vec::new(),
            };
            lines.into_iter().map(|line| (line, own.kind())).collect()
        })
    }

    /// The tabs of a piece.
    pub fn tabs(&self, piece: u32) -> impl Iterator<Item = &Tab> {
        self.kinds_on(piece).filter_map(|kind| match kind {
            JointKind::Tab(tab) => Some(tab),
            _ => None,
        })
    }

    /// The tongues whose slot is on a piece.
    pub fn slots(&self, piece: u32) -> impl Iterator<Item = &Tongue> {
        self.tongues_by(piece, |tongue| tongue.flange.side)
    }

    /// The tongues that are on a piece.
    pub fn tongues(&self, piece: u32) -> impl Iterator<Item = &Tongue> {
        self.tongues_by(piece, |tongue| tongue.side)
    }

    fn tongues_by(
        &self,
        piece: u32,
        side: fn(&Tongue) -> FacetSide,
    ) -> impl Iterator<Item = &Tongue> {
        self.kinds_on(piece).filter_map(move |kind| match kind {
            JointKind::Tongue(own) if self.net.piece_of[side(own).0 as usize] == piece => Some(own),
            _ => None,
        })
    }

    /// The joints with a tab, a tongue or a slot on a piece.
    fn kinds_on(&self, piece: u32) -> impl Iterator<Item = &JointKind> {
        self.tab_joints[piece as usize].iter().map(|&joint| &self.joint_kinds[joint as usize])
    }
}

impl JointKind {
    /// The sides with a tab, a flange or a tongue.
    fn sides(&self) -> impl Iterator<Item = FacetSide> {
        let sides = match self {
            JointKind::Tab(tab) => [Some(tab.side), None],
            JointKind::Tongue(tongue) => [Some(tongue.flange.side), Some(tongue.side)],
            JointKind::Folded | JointKind::Bare => [None, None],
        };
        sides.into_iter().flatten()
    }

    /// The trapezia that it takes on a piece.
    fn taken(&self, net: &PaperNet, piece: u32) -> Vec<[Point2; 4]> {
        match self {
            JointKind::Tab(tab) if net.piece_of[tab.side.0 as usize] == piece => vec![tab.corners],
            JointKind::Tongue(tongue) => tongue.taken(net, piece).collect(),
            _ => Vec::new(),
        }
    }
}

/// The number of panels with an inner face of every facet.
fn made_of(facets: &[Facet], uneven: &Uneven) -> usize {
    let panels = |own: &mut dyn Iterator<Item = &Facet>| distinct(own.map(|f| f.panel)).len();
    let lost = panels(&mut uneven.too_thick.iter().map(|&f| &facets[f as usize]));
    panels(&mut facets.iter()) - lost
}

/// Unhinges the joints along these edges, by their vertices.
fn cut_seams(surface: &PanelSurface, joints: &mut [Joint], seams: &[[u32; 2]]) {
    let seams: BTreeSet<[u32; 2]> = seams.iter().copied().map(ordered).collect();
    for joint in joints {
        let ends = joint.edge.map(|edge| surface.edges[edge as usize].ends);
        joint.is_hinge &= ends.is_none_or(|ends| !seams.contains(&ends));
    }
}

/// The panels beyond the sides of facets without a joint.
fn unpaired(surface: &PanelSurface, facets: &[Facet]) -> BTreeMap<FacetSide, Vec<u32>> {
    let mut found = BTreeMap::new();
    for (own, f) in facets.iter().zip(0..) {
        for ((side, joint), k) in own.panel_sides.iter().zip(&own.joints).zip(0..) {
            let (Some(side), None) = (side, joint) else { continue };
            let edge = surface.sides.row(own.panel as usize)[*side as usize];
            let met = surface.neighbours_across(edge, own.panel);
            if !surface.is_joined(&surface.edges[edge as usize]) && !met.is_empty() {
                found.insert((f, k), met);
            }
        }
    }
    found
}

/// Folds all joints that are allowed and possible. Strips too long for the sheet are divided evenly
/// if that makes no more pieces.
fn folded(unfolded: &PaperNet, order: &Foldable, size: PaperSize) -> PaperNet {
    let tab = size.reserved();
    let room = size.room.map(|side| side - 2.0 * tab);
    let all = |cuts: &[bool]| {
        let mut net = unfolded.clone();
        for &joint in order.always.iter().chain(order.strips.iter().flatten()) {
            if !cuts[joint as usize] {
                net.fold(joint, room, tab);
            }
        }
        net
    };
    let longest = all(&vec![false; unfolded.joints.len()]);
    let cuts = order.even_cuts(&longest.folded);
    if !cuts.contains(&true) {
        return longest;
    }
    let even = all(&cuts);
    let count = |net: &PaperNet| net.pieces.iter().filter(|own| !own.is_empty()).count();
    if count(&even) <= count(&longest) { even } else { longest }
}

/// Chooses tabs: on the piece that comes first, or else on the other side; or, if they are wanted and
/// have room, tongues and slots. A piece that fits on the sheet has none that keeps it from fitting.
fn joint_kinds(net: &PaperNet, pieces: &[u32], size: PaperSize) -> Vec<JointKind> {
    let mut place = vec![0; net.pieces.len()];
    pieces.iter().enumerate().for_each(|(k, &piece)| place[piece as usize] = k);
    // The boxes of what is added to each piece, by joint.
    let mut added = vec![Boxes::default(); pieces.len()];
    // The corners of pieces that fit, but need not with tabs.
    let with_tabs = size.room.map(|side| side - 2.0 * size.tab);
    let tight = |&piece: &u32| {
        let corners = &net.hulls[piece as usize];
        (!lies_on(corners, with_tabs) && lies_on(corners, size.room)).then(|| corners.clone())
    };
    let mut tight: Vec<Option<Vec<Point2>>> = pieces.iter().map(tight).collect();
    let mut found: Vec<JointKind> = Vec::new();
    let mut tongues = 0;
    for ((joint, &folded), number) in net.joints.iter().zip(&net.folded).zip(0..) {
        if folded || size.tab <= 0.0 {
            found.push(if folded { JointKind::Folded } else { JointKind::Bare });
            continue;
        }
        let mut sides = joint.sides;
        // The piece that comes first is tried first.
        sides.sort_unstable_by_key(|&side| (place[net.piece_of[side.0 as usize] as usize], side));
        let taken = |side: FacetSide| -> Vec<[Point2; 4]> {
            let piece = net.piece_of[side.0 as usize];
            let near = added[place[piece as usize]].meeting(around(net, side, size.tab));
            near.flat_map(|joint| found[joint as usize].taken(net, piece)).collect()
        };
        let has_room = |kind: &JointKind| {
            kind.sides().all(|(f, _)| {
                let piece = net.piece_of[f as usize];
                let Some(corners) = &tight[place[piece as usize]] else { return true };
                let own = kind.taken(net, piece);
                lies_on(&[&corners[..], own.as_flattened()].concat(), size.room)
            })
        };
        let of_tongue = |fit: Fit| {
            let [a, b] = sides.map(&taken);
            let ways = [(sides, [&a[..], &b[..]]), ([sides[1], sides[0]], [&b[..], &a[..]])];
            ways.into_iter().find_map(|(sides, taken)| {
                let own = tongue(net, sides, taken, size.tab, fit)?;
                let kind = JointKind::Tongue(Tongue { number: tongues + 1, ..own });
                has_room(&kind).then_some(kind)
            })
        };
        let of_tab = || {
            sides.into_iter().find_map(|side| {
                let kind = JointKind::Tab(tab(net, side, &taken(side), size.tab)?);
                has_room(&kind).then_some(kind)
            })
        };
        let kind = size.slots.and_then(of_tongue).or_else(of_tab).unwrap_or(JointKind::Bare);
        tongues += u32::from(matches!(kind, JointKind::Tongue(_)));
        for piece in distinct(kind.sides().map(|(f, _)| net.piece_of[f as usize])) {
            let k = place[piece as usize];
            for corners in kind.taken(net, piece) {
                added[k].insert(number, bounds(corners));
                tight[k].iter_mut().for_each(|own| own.extend(corners));
            }
        }
        found.push(kind);
    }
    found
}

/// Whether points have a box of at most this width and height, or height and width.
fn lies_on(points: &[Point2], [width, height]: [f64; 2]) -> bool {
    let [long, short] = [width.max(height), width.min(height)];
    let (_, size) = smallest_box_within(points, [long, short]);
    size[0] <= long && size[1] <= short
}
