//! The shape unrolled: the rows of panels in the order of assembly, the first at the bottom, each as
//! strips of panels that lie flat side by side as seen from outside, with upwards upwards.
//!
//! In a strip each panel is joined to the one before it along their common edge. A strip ends where a panel
//! has no neighbour that is left in its row, where the next one would lie on the strip, and where upwards has
//! turned too far: a ring near the top of a dome would curl around empty paper. The panels of a row that
//! touch each other only at corners, as every second one of a belt of triangles, are in one strip with those
//! of the next row.

use super::view::{Element, Mark, Spot, on_polygon};
use crate::fabricate::boxes::Boxes;
use crate::fabricate::build::Build;
use crate::fabricate::panel::{are_apart, direction_of};
use crate::fabricate::paper::Motion;
use crate::fabricate::sheet::text_width;
use crate::fabricate::surface::PanelSurface;
use crate::fabricate::view_axes::upwards_in;
use crate::math::Vec3;
use crate::math::plane::{Point2, bounds, dot, is_inside, minus, rotated};
use std::collections::BTreeSet;

/// Space between strips relative to the mean edge.
const SPACE: f64 = 0.4;
/// Panels in a strip overlap if this much of one, about its middle, meets another: neighbours touch.
const WITHIN: f64 = 0.99;
/// The cosine of the angle by which upwards may turn along a strip.
const TURNED: f64 = 0.5;
/// Height of a name relative to the largest with which it does not touch the sides.
const NAME: f64 = 0.8;
/// Widths that are tried, each larger by this factor.
const WIDER: f64 = 1.1;
/// The longer side of a paper relative to the shorter one.
const PAPER: f64 = std::f64::consts::SQRT_2;

/// Panels laid flat, in the unit of the mesh.
#[derive(Clone, Debug)]
pub(super) struct Strip {
    /// Each panel, and the motion from its plane.
    pub(super) panels: Vec<(u32, Motion)>,
    /// The size of its box, whose lower left corner is the origin.
    size: [f64; 2],
}

/// A panel that continues a strip.
struct Next {
    /// The panel, and the motion from its plane.
    laid: (u32, Motion),
    /// Its place in the order of the row.
    place: usize,
    /// Its corners where it is laid.
    outline: Vec<Point2>,
}

/// Strips of all rows on one page.
pub(super) struct Unrolled {
    /// Where each panel is, by its number; none of one without area.
    places: Vec<Option<Motion>>,
    /// Width and height of all, in the unit of the mesh. The lower left corner is the origin.
    pub(super) size: [f64; 2],
    /// The outlines of the panels.
    pub(super) lines: Vec<Vec<Point2>>,
}

impl Build {
    /// The strips of all rows; of a row without common edges, with those of the next one.
    fn strips_of_rows(&self, z_up: bool) -> Vec<Vec<Strip>> {
        let mut left = &self.rows[..];
        let mut found = Vec::new();
        let mut place_of = vec![usize::MAX; self.surface.faces.len()];
        while let [row, rest @ ..] = left {
            let mut group = row.clone();
            left = rest;
            if let [next, beyond @ ..] = rest
                && !is_joined(&self.surface, row)
            {
                group.extend(next);
                left = beyond;
            }
            found.push(self.strips_of(&group, &mut place_of, z_up));
        }
        found
    }

    /// The strips of some panels, in their order. `place_of` has room for the place of every panel in it.
    fn strips_of(&self, group: &[u32], place_of: &mut [usize], z_up: bool) -> Vec<Strip> {
        let mut open: BTreeSet<(usize, u32)> = (0..).zip(group.iter().copied()).collect();
        open.retain(|(_, f)| self.flat[*f as usize].is_some());
        // Of another group no place and panel are open together.
        open.iter().for_each(|&(place, f)| place_of[f as usize] = place);
        let mut found = Vec::new();
        while let Some((_, first)) = open.pop_first() {
            let unmoved = Motion { turn: [1.0, 0.0], shift: [0.0; 2] };
            let mut strip = vec![(first, unmoved)];
            let mut outlines = vec![self.laid(first, unmoved)];
            let mut boxes = Boxes::of([bounds(outlines[0].iter().copied())]);
            // From the last panel on, and where that leads nowhere, from the first.
            let (mut tip, mut is_from_first) = (0, false);
            loop {
                let Some(next) = self.next_in_strip(strip[tip], &open, place_of) else {
                    if is_from_first {
                        break;
                    }
                    (tip, is_from_first) = (0, true);
                    continue;
                };
                let Next { laid, place, outline } = next;
                let around = bounds(outline.iter().copied());
                let meets = |k: usize| k != tip && overlap(&outline, &outlines[k]);
                let is_free = !boxes.meeting(around).any(|k| meets(k as usize));
                let ways = [(first, unmoved), laid].map(|own| self.upwards(own, z_up));
                if !is_free || dot(ways[0], ways[1]) < TURNED {
                    break;
                }
                open.remove(&(place, laid.0));
                tip = strip.len();
                boxes.insert(tip as u32, around);
                strip.push(laid);
                outlines.push(outline);
            }
            found.push(self.upright(strip, &outlines, z_up));
        }
        found
    }

    /// The first of the open panels beside one that is laid.
    fn next_in_strip(
        &self,
        (last, place): (u32, Motion),
        open: &BTreeSet<(usize, u32)>,
        place_of: &[usize],
    ) -> Option<Next> {
        let sides = self.surface.sides.row(last as usize).iter();
        let beyond = sides.filter_map(|&e| {
            let other = beside(&self.surface, e, last)?;
            Some((place_of[other as usize], e, other))
        });
        let is_open = |(number, _, other): &(usize, u32, u32)| open.contains(&(*number, *other));
        let (number, e, next) = beyond.filter(is_open).min()?;
        let [p, q] = self.side(last, e)?;
        let motion = Motion::between(self.side(next, e)?, [place.put(q), place.put(p)]);
        Some(Next { laid: (next, motion), place: number, outline: self.laid(next, motion) })
    }

    /// The direction on a panel that is laid like this in which it rises.
    fn upwards(&self, (f, place): (u32, Motion), z_up: bool) -> Point2 {
        let flat = self.flat[f as usize].as_ref();
        flat.map_or([0.0, 1.0], |flat| rotated(upwards_in(flat.axes, z_up), place.turn))
    }

    /// A strip turned so that it rises upwards, and moved to the origin.
    fn upright(&self, strip: Vec<(u32, Motion)>, outlines: &[Vec<Point2>], z_up: bool) -> Strip {
        let ways = || strip.iter().map(|&own| self.upwards(own, z_up));
        let [x, y] = direction_of([0.0; 2], [0, 1].map(|k| ways().map(|way| way[k]).sum()));
        let turn = [y, x];
        let turned = outlines.iter().flatten().map(|&point| rotated(point, turn));
        let [low, high] = bounds(turned);
        let whole = Motion { turn, shift: low.map(|x| -x) };
        let panels = strip.into_iter().map(|(f, place)| (f, whole.after(&place))).collect();
        Strip { panels, size: minus(high, low) }
    }

    /// The ends of the side of a panel along an edge, in its plane.
    fn side(&self, f: u32, e: u32) -> Option<[Point2; 2]> {
        let k = self.surface.sides.row(f as usize).iter().position(|&side| side == e)?;
        let corners = &self.flat[f as usize].as_ref()?.corners;
        Some([corners[k], corners[(k + 1) % corners.len()]])
    }

    /// The corners of a panel where it is laid.
    fn laid(&self, f: u32, place: Motion) -> Vec<Point2> {
        let flat = self.flat[f as usize].as_ref();
        flat.map_or_else(Vec::new, |flat| flat.corners.iter().map(|&p| place.put(p)).collect())
    }

    /// All strips, row above row, on the width with which they are largest on a paper.
    pub(super) fn unrolled(&self, z_up: bool) -> Unrolled {
        let rows = self.strips_of_rows(z_up);
        let mean = self.surface.mean_edge();
        let space = SPACE * mean;
        let widest = rows.iter().flatten().map(|strip| strip.size[0]).fold(0.0, f64::max);
        let wide = |row: &Vec<Strip>| row.iter().map(|strip| strip.size[0] + space).sum::<f64>();
        let longest = rows.iter().map(wide).fold(widest, f64::max);
        let widths =
            std::iter::successors((widest > 0.0).then_some(widest), |width| Some(width * WIDER));
        let widths = widths.take_while(|width| *width <= WIDER * longest);
        let scale = |width: f64| {
            let [width, height] = arranged(&rows, width, space).1;
            (PAPER / width.max(height)).min(1.0 / width.min(height))
        };
        let best =
            widths.reduce(|best, other| if scale(other) > scale(best) { other } else { best });
        let (at, size) = arranged(&rows, best.unwrap_or(widest), space);
        let (mut places, mut lines) = (vec![None; self.names.len()], Vec::new());
        for (row, at) in rows.iter().zip(&at) {
            for (strip, &shift) in row.iter().zip(at) {
                let moved = Motion { turn: [1.0, 0.0], shift };
                for (f, place) in &strip.panels {
                    let place = moved.after(place);
                    places[*f as usize] = Some(place);
                    for ring in self.surface.rings(*f) {
                        let corners = self.laid(*f, place);
                        let mut line: Vec<Point2> = ring.into_iter().map(|k| corners[k]).collect();
                        line.extend(line.first().copied());
                        lines.push(line);
                    }
                }
            }
        }
        Unrolled { places, size, lines }
    }

    /// Points in the plane of a panel, about the centre of the surface, where the panel is laid.
    fn unrolled_points(&self, f: u32, place: Motion, points: &[Vec3<f64>]) -> Vec<Point2> {
        let Some(flat) = &self.flat[f as usize] else { return Vec::new() };
        let within = |&point: &Vec3<f64>| {
            let step = point - flat.origin;
            place.put(flat.axes.map(|axis| step.dot(axis)))
        };
        points.iter().map(within).collect()
    }

    /// Where the names of some marks on panels are written.
    pub(super) fn unrolled_spots(&self, laid: &Unrolled, marks: &[Mark]) -> Vec<Option<Spot>> {
        let spot = |mark: &Mark| {
            let (f, points) = match &mark.element {
                Element::Panel(f) => (*f, None),
                Element::Piece(f, outline) => (*f, Some(outline)),
                Element::Edge(_) | Element::Vertex(_) => return None,
            };
            let place = laid.places[f as usize]?;
            let outline = match points {
                None => self.laid(f, place),
                Some(points) => self.unrolled_points(f, place, points),
            };
            let spot = on_polygon(&outline, text_width(&mark.name, 1.0))?;
            Some(Spot { height: NAME * spot.height, ..spot })
        };
        marks.iter().map(spot).collect()
    }

    /// The seams of panels where they are laid.
    pub(super) fn unrolled_seams(
        &self,
        laid: &Unrolled,
        seams: &[(u32, Vec<Vec3<f64>>)],
    ) -> Vec<Vec<Point2>> {
        let seam = |(f, ends): &(u32, Vec<Vec3<f64>>)| {
            Some(self.unrolled_points(*f, laid.places[*f as usize]?, ends))
        };
        seams.iter().filter_map(seam).collect()
    }
}

/// The panel beside another one at an edge of two, which both pass in opposite directions.
fn beside(surface: &PanelSurface, edge: u32, panel: u32) -> Option<u32> {
    let both = surface.edges[edge as usize].panels;
    both.into_iter().flatten().find(|&other| other != panel)
}

/// Whether most panels of a row have a common edge with another one of it, or there is only one.
fn is_joined(surface: &PanelSurface, row: &[u32]) -> bool {
    let own: BTreeSet<u32> = row.iter().copied().collect();
    let is_beside = |&&f: &&u32| {
        let sides = surface.sides.row(f as usize);
        sides.iter().any(|&e| beside(surface, e, f).is_some_and(|other| own.contains(&other)))
    };
    row.len() == 1 || 2 * row.iter().filter(is_beside).count() >= row.len()
}

/// Whether a panel lies on another one, by more than they touch.
fn overlap(one: &[Point2], other: &[Point2]) -> bool {
    let count = one.len() as f64;
    let middle = [0, 1].map(|k| one.iter().map(|point| point[k]).sum::<f64>() / count);
    let within = |point: &Point2| [0, 1].map(|k| middle[k] + WITHIN * (point[k] - middle[k]));
    let one: Vec<Point2> = one.iter().map(within).collect();
    let first_in = |of: &[Point2], polygon: &[Point2]| {
        of.first().is_some_and(|&point| is_inside(polygon, point))
    };
    !are_apart(&one, other) || first_in(&one, other) || first_in(other, &one)
}

/// Where the lower left corner of each strip of each row is, from left to right and from below in lines of
/// this width, and the size of all. A row begins a line.
fn arranged(rows: &[Vec<Strip>], width: f64, space: f64) -> (Vec<Vec<Point2>>, [f64; 2]) {
    let (mut right, mut low, mut high) = (0.0_f64, 0.0, 0.0_f64);
    let mut found = Vec::new();
    for row in rows {
        let mut own = Vec::new();
        let mut x = 0.0;
        for (k, strip) in row.iter().enumerate() {
            if k == 0 || x + strip.size[0] > width {
                low = if high > 0.0 { high + space } else { 0.0 };
                x = 0.0;
            }
            own.push([x, low]);
            right = right.max(x + strip.size[0]);
            high = high.max(low + strip.size[1]);
            x += strip.size[0] + space;
        }
        found.push(own);
    }
    (found, [right, high])
}
