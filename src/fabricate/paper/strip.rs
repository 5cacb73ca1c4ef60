//! The order in which joints are folded, which determines the shape of the pieces.

use super::facet::Joint;
use crate::fabricate::surface::PanelSurface;
use crate::math::{key_of_number, sort_by_number};
use crate::scene::Pieces;

/// The joints that may be folded.
pub(super) struct Foldable {
    /// Joints outside strips, in order: creases, and the edges of nets.
    pub always: Vec<u32>,
    /// The joints along each strip, in order.
    pub strips: Vec<Vec<u32>>,
}

impl Foldable {
    /// For each joint, whether to cut a strip there, so that it is divided into equally many pieces
    /// as in `folded` (where pieces are as long as possible), but with about equal numbers of
    /// panels.
    pub(super) fn even_cuts(&self, folded: &[bool]) -> Vec<bool> {
        let mut cuts = vec![false; folded.len()];
        for strip in &self.strips {
            let pieces = 1 + strip.iter().filter(|&&joint| !folded[joint as usize]).count();
            let panels = strip.len() + 1;
            (1..pieces).for_each(|k| cuts[strip[k * panels / pieces - 1] as usize] = true);
        }
        cuts
    }
}

/// The joints that may be folded; none if strips are requested and there are no quads.
pub(super) fn foldable(
    surface: &PanelSurface,
    joints: &[Joint],
    pieces: Pieces,
) -> Option<Foldable> {
    let (mut always, mut of_edges): (Vec<u32>, Vec<u32>) =
        (0..joints.len() as u32).partition(|&j| joints[j as usize].edge.is_none());
    let mut own_strips = Vec::new();
    match pieces {
        Pieces::Nets => {
            sort_by_number(&mut of_edges, |&j| key_of_number(joints[j as usize].fold.abs()));
            always.extend(of_edges);
        }
        Pieces::Strips | Pieces::Across => {
            let along = strips(surface, usize::from(pieces == Pieces::Across))?;
            let mut of_edge = vec![None; surface.edges.len()];
            for j in of_edges {
                if let Some(edge) = joints[j as usize].edge {
                    of_edge[edge as usize] = Some(j);
                }
            }
            for strip in along {
                let own: Vec<u32> =
                    strip.into_iter().filter_map(|edge| of_edge[edge as usize]).collect();
                // A strip ends where it cannot be folded: each part is divided evenly by itself.
                let parts = own.split(|&j| !joints[j as usize].is_hinge);
                own_strips.extend(parts.map(<[u32]>::to_vec));
            }
        }
    }
    Some(Foldable { always, strips: own_strips })
}

/// The edges that each strip of quads crosses; none without quads. In each connected part the strip
/// through the first quad crosses its side `first`. If the mesh is not a grid, the direction is
/// inconsistent at some edges, and strips end there.
fn strips(surface: &PanelSurface, first: usize) -> Option<Vec<Vec<u32>>> {
    let faces = surface.faces.len();
    let is_quad = |f: u32| surface.faces.row(f as usize).len() == 4;
    let sides = |f: u32| surface.sides.row(f as usize);
    let beyond = |f: u32, k: usize| {
        let e = *sides(f).get(k)?;
        let g = surface.edges[e as usize].across(f).filter(|&g| g != f && is_quad(g))?;
        Some((e, g, sides(g).iter().position(|&side| side == e)?))
    };
    // For each quad, the pair of its sides that the strip crosses.
    let mut crossed: Vec<Option<usize>> = vec![None; faces];
    for start in (0..faces as u32).filter(|&f| is_quad(f)) {
        if crossed[start as usize].is_some() {
            continue;
        }
        crossed[start as usize] = Some(first);
        let mut queue = std::collections::VecDeque::from([(start, first)]);
        while let Some((f, own)) = queue.pop_front() {
            for k in 0..4 {
                let Some((_, g, back)) = beyond(f, k) else { continue };
                if crossed[g as usize].is_none() {
                    let there = (back + usize::from(k % 2 != own)) % 2;
                    crossed[g as usize] = Some(there);
                    queue.push_back((g, there));
                }
            }
        }
    }
    crossed.iter().flatten().next()?;
    // The next quad of the strip through side `k` of a quad, and the side that leads on.
    let ahead = |f: u32, k: usize| {
        let (e, g, back) = beyond(f, k)?;
        (crossed[g as usize] == Some(back % 2)).then_some((e, g, (back + 2) % 4))
    };
    let mut is_seen = vec![false; faces];
    let mut strips = Vec::new();
    for start in 0..faces as u32 {
        let Some(own) = crossed[start as usize].filter(|_| !is_seen[start as usize]) else {
            continue;
        };
        // Back to the start of the strip, or once around.
        let (mut f, mut k) = (start, own);
        while let Some((_, g, on)) = ahead(f, k) {
            if g == start {
                break;
            }
            (f, k) = (g, on);
        }
        k = (k + 2) % 4;
        is_seen[f as usize] = true;
        let mut edges = Vec::new();
        while let Some((e, g, on)) = ahead(f, k) {
            if std::mem::replace(&mut is_seen[g as usize], true) {
                break;
            }
            edges.push(e);
            (f, k) = (g, on);
        }
        strips.push(edges);
    }
    Some(strips)
}
