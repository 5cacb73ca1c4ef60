//! A piece as a part to be cut: its outline with tabs and tongues, folds, slots, and names on panels, tabs
//! and tongues.

use super::facet::{FacetSide, FoldKind};
use super::kerf::cut_line;
use super::tab::Tab;
use super::tab_name::place_on_tab;
use super::{JointKind, PaperModel};
use crate::fabricate::panel::{direction_of, smallest_box};
use crate::fabricate::sheet::{CutPart, Hole, Inscription, label, strokes, upright};
use crate::math::plane::{Point2, distance, rotated};
use crate::math::sort_by_number;

/// Length of the dashes of a valley fold in mm.
const DASH: f64 = 2.5;
/// Largest number of dashes of a line: in a longer line, of a piece far larger than a sheet, they are
/// longer.
const MOST_DASHES: f64 = 1000.0;
/// Gap between dashes, as a fraction of [`DASH`].
const GAP: f64 = 0.6;

/// Steps of an outline that are not cut, in mm.
const STEP: f64 = 1e-3;

/// Maps a point of a piece to its part: mirrored if the inside is printed, then rotated.
#[derive(Clone, Copy)]
struct Put {
    inside: bool,
    turn: Point2,
}

impl Put {
    fn put(self, [x, y]: Point2) -> Point2 {
        rotated(if self.inside { [-x, y] } else { [x, y] }, self.turn)
    }
}

/// The outline of a piece with its tabs, counterclockwise on its part, and the map from piece to
/// part.
fn outline(model: &PaperModel, piece: u32, inside: bool) -> (Vec<Point2>, Put) {
    let unrotated = Put { inside, turn: [1.0, 0.0] };
    let mut points: Vec<Point2> = Vec::new();
    let net = &model.net;
    for side in net.outline(piece) {
        let [p, _] = net.ends(side);
        points.push(unrotated.put(p));
        points.extend(model.added(side).into_iter().map(|corner| unrotated.put(corner)));
        if net.is_cut_back {
            points.extend(net.corners_after(side).into_iter().map(|corner| unrotated.put(corner)));
        }
    }
    if inside {
        points.reverse();
    }
    let step = if net.is_cut_back { STEP } else { 0.0 };
    points.dedup_by(|after, before| distance(*before, *after) <= step);
    if points.len() > 1 && distance(points[0], points[points.len() - 1]) <= step {
        points.pop();
    }
    let (turn, _) = smallest_box(&points);
    (points.into_iter().map(|point| rotated(point, turn)).collect(), Put { inside, turn })
}

/// The part of a piece: its outline and its slots, as they are cut with this kerf, and its folds.
pub fn drawn(model: &PaperModel, number: usize, inside: bool, kerf: f64) -> CutPart {
    let (net, piece) = (&model.net, model.pieces[number]);
    let (outline, place) = outline(model, piece, inside);
    let outline = cut_line(&outline, kerf);
    let mut part = CutPart { name: format!("S{}", number + 1), outline, ..CutPart::default() };
    for tongue in model.slots(piece) {
        let mut slot: Vec<Point2> =
            tongue.slot_corners(net, kerf).into_iter().map(|point| place.put(point)).collect();
        if inside {
            // Counterclockwise again.
            slot.reverse();
        }
        part.holes.push(Hole::slot(slot));
    }
    for (line, kind) in model.scores(piece) {
        let [p, q] = line.map(|point| place.put(point));
        // A tab is folded back where its panels are coplanar too.
        match (kind != FoldKind::Valley) != inside {
            true => part.ridges.push(vec![p, q]),
            false => part.valleys.extend(dashes(p, q)),
        }
    }
    part.panels =
        net.pieces[piece as usize].iter().map(|&f| net.facets[f as usize].panel).collect();
    part.panels.dedup();
    part
}

/// The names without room on a piece.
#[derive(Clone, Copy, Debug, Default)]
pub struct MissingNames {
    /// Neighbours' names.
    pub dropped: usize,
    /// Whether a name has no room for letters of 2 mm: its own, or of one of its panels.
    pub small: bool,
    /// Whether its own name is missing.
    pub piece: bool,
}

/// Engraves the names of panels, of neighbours and of the piece on its part, rotated by `turn` on
/// its sheet.
pub fn write_names(
    part: &mut CutPart,
    (model, number): (&PaperModel, usize),
    names: &[String],
    inside: bool,
    turn: Point2,
) -> MissingNames {
    let piece = model.pieces[number];
    let (_, place) = outline(model, piece, inside);
    let put = |point: Point2| place.put(point);
    let (mut dropped, mut small, mut is_named) = (0, false, false);
    for &panel in &part.panels {
        for own in name_places(model, piece, panel) {
            let sides = own.iter().map(|&side| named_side(model, names, side, &put));
            let (mut polygon, mut beside): (Vec<Point2>, Vec<_>) = sides.unzip();
            if inside {
                // Counterclockwise again; each name stays with its side.
                polygon.reverse();
                beside.reverse();
                beside.rotate_left(1);
            }
            let (outline, neighbours) = (&polygon[..], &beside[..]);
            let holes = &[][..];
            let named = |name: &str| {
                label(Inscription {
                    outline,
                    name,
                    neighbours,
                    bevels: &[],
                    is_oriented: false,
                    arrow: None,
                    turn,
                    holes,
                })
            };
            let name = &names[panel as usize];
            let mut labels = named(name);
            // The first panel with enough room also shows the name of the piece.
            if !is_named {
                let both = named(&format!("{}: {name}", part.name));
                if !both.small && both.dropped == labels.dropped {
                    (labels, is_named) = (both, true);
                }
            }
            part.engraved.extend(labels.lines);
            dropped += labels.dropped;
            small |= labels.small;
        }
    }
    let tabs = model.tabs(piece).map(|tab| tab.side);
    let slots = model.slots(piece).map(|tongue| tongue.flange.side);
    for side in tabs.chain(slots).chain(model.tongues(piece).map(|tongue| tongue.side)) {
        if let Some((name, tab, height, middle)) = tab_name(model, names, side) {
            let [p, _, _, q] = tab.corners.map(put);
            let along = upright(direction_of(p, q), turn);
            part.engraved.extend(strokes(&name, height, put(middle), along));
        }
    }
    MissingNames { dropped, small, piece: !is_named }
}

/// Outlines for the names of a panel: the whole panel if it is on this piece and hangs together
/// there, else each of its facets.
fn name_places(model: &PaperModel, piece: u32, panel: u32) -> Vec<Vec<FacetSide>> {
    let net = &model.net;
    let sides = |f: u32| (0..net.facets[f as usize].corners.len() as u32).map(move |k| (f, k));
    // Facets are in the order of panels, and those of a piece in this order too.
    let first = |panel: u32| net.facets.partition_point(|facet| facet.panel < panel);
    let all = first(panel)..first(panel + 1);
    let of_piece = &net.pieces[piece as usize];
    let before = |end: usize| of_piece.partition_point(|&f| (f as usize) < end);
    let own = &of_piece[before(all.start)..before(all.end)];
    let mut of_panel: Vec<(u32, FacetSide)> = own
        .iter()
        .flat_map(|&f| sides(f))
        .filter_map(|(facet, side)| {
            let of_panel = net.facets[facet as usize].panel_sides[side as usize]?;
            Some((of_panel, (facet, side)))
        })
        .collect();
    sort_by_number(&mut of_panel, |(side, _)| u64::from(*side));
    let is_held =
        |&joint: &u32| net.joints[joint as usize].edge.is_some() || net.folded[joint as usize];
    let hangs_together = |&f: &u32| net.facets[f as usize].joints.iter().flatten().all(is_held);
    match own.len() == all.len() && own.iter().all(hangs_together) {
        true => vec![of_panel.into_iter().map(|(_, side)| side).collect()],
        false => own.iter().map(|&f| sides(f).collect()).collect(),
    }
}

/// The start of a side on the sheet, and what is to be written beside it if the side is cut: the name of
/// the neighbour beyond it, unless it is on a tab of the side, and that of a tongue which has no room for it.
fn named_side(
    model: &PaperModel,
    names: &[String],
    side: FacetSide,
    put: &impl Fn(Point2) -> Point2,
) -> (Point2, Option<String>) {
    let net = &model.net;
    let start = put(net.ends(side)[0]);
    if let Some(others) = model.unpaired.get(&side) {
        let others: Vec<&str> = others.iter().map(|&other| &*names[other as usize]).collect();
        return (start, Some(others.join("/")));
    }
    let name = net.across(side).and_then(|(joint, (g, _))| {
        let neighbour = &names[net.facets[g as usize].panel as usize];
        let is_written = || tab_name(model, names, side).is_some();
        match &model.joint_kinds[joint as usize] {
            JointKind::Folded => None,
            JointKind::Tab(tab) if tab.side == side && is_written() => None,
            JointKind::Tongue(own) if !is_written() => Some(format!("{neighbour} {}", own.name())),
            _ => Some(neighbour.clone()),
        }
    });
    (start, name)
}

/// The name on the tab of a side, on its flange or on its tongue, the tab or the part of it on which it is
/// written, its height and its centre; none if it has no room.
fn tab_name(
    model: &PaperModel,
    names: &[String],
    side: FacetSide,
) -> Option<(String, Tab, f64, Point2)> {
    let (joint, (g, _)) = model.net.across(side)?;
    let (name, tab) = match &model.joint_kinds[joint as usize] {
        JointKind::Tab(tab) => (names[model.net.facets[g as usize].panel as usize].clone(), *tab),
        JointKind::Tongue(own) => (own.name(), own.name_place(&model.net, side)),
        JointKind::Folded | JointKind::Bare => return None,
    };
    let (height, middle) = place_on_tab(&tab, &name)?;
    Some((name, tab, height, middle))
}

/// A dashed line that begins and ends with a dash, as separate lines, which every program
/// preserves.
fn dashes(p: Point2, q: Point2) -> Vec<Vec<Point2>> {
    let [x, y] = [q[0] - p[0], q[1] - p[1]];
    let length = (x * x + y * y).sqrt();
    let count = ((length / DASH + GAP) / (1.0 + GAP) + 0.5).floor().clamp(1.0, MOST_DASHES);
    let dash = 1.0 / (count + (count - 1.0) * GAP);
    let at = |share: f64| [p[0] + share * x, p[1] + share * y];
    (0..count as u32)
        .map(|k| {
            let from = f64::from(k) * dash * (1.0 + GAP);
            vec![at(from), at(from + dash)]
        })
        .collect()
}
