//! Key drawings: where each part goes. The shape from above, from as many more sides as are needed until
//! every panel, or with fins every beam and node, has its name in one of them, and, unless it is level,
//! from at least one side, and but for fins, unrolled by rows. They are to be read, not to be cut.
//!
//! | file | holds |
//! |---|---|
//! | `view` | the shape in one direction, and which of its elements are seen |
//! | `unrolled` | the rows of panels, laid flat |
//! | `page` | the paper that a view needs, and its drawing |

mod page;
mod unrolled;
mod view;

use super::build::{Build, CutPanel};
use super::file::Drawing;
use super::sheet::CutPart;
use super::view_axes::{ViewAxes, compass, from_above, from_camera};
use crate::math::Vec3;
use crate::math::plane::{Point2, rotated};
use crate::scene::Product;
use page::Page;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use view::{Element, Mark, Spot, View};

/// Tilt of the views from the sides, in radians: that of an isometric drawing.
const TILT: f64 = 0.6155;
/// Height of a shape relative to its mean edge up to which it is level.
const LEVEL: f64 = 1e-3;

impl Build {
    /// Draws the key, from the most important view on: the first is from above. Titles say how many names
    /// no view shows, of what is hidden from all sides or too small. `z_up` is whether z is up in the
    /// mesh; else y is.
    pub fn key(&self, z_up: bool) -> Vec<Drawing> {
        let marks = self.marks();
        let seams: Vec<(u32, Vec<Vec3<f64>>)> = (self.splices.iter())
            .map(|own| (own.panel, self.in_space(own.panel, &own.seam)))
            .collect();
        let mut missing: Vec<usize> = (0..marks.len()).collect();
        let seen_in = |axes| {
            let view = View::new(&self.surface, axes);
            let spots = view.spots(&marks);
            (view, spots)
        };
        let mut chosen = Vec::new();
        let mut next = Some(seen_in(from_above(z_up)));
        let mut others = None;
        while let Some((view, spots)) = next.take() {
            let page = Page::of(view.seen.size, &spots, &missing);
            missing.retain(|mark| !page.names(&spots, *mark));
            chosen.push((view, spots, page));
            if missing.is_empty() {
                break;
            }
            // The side that shows most of what has no name yet.
            let others = others
                .get_or_insert_with(|| around(z_up).into_iter().map(seen_in).collect::<Vec<_>>());
            let named = |(view, spots): &(View<'_>, Vec<Option<Spot>>)| {
                let page = Page::of(view.seen.size, spots, &missing);
                missing.iter().filter(|mark| page.names(spots, **mark)).count()
            };
            let best = others.iter().map(named).zip(0..);
            let best = best.max_by_key(|&(count, k)| (count, std::cmp::Reverse(k)));
            next = best.filter(|&(count, _)| count > 0).map(|(_, k)| others.remove(k));
        }
        if !chosen.iter().any(|(view, ..)| is_from_a_side(view.axes, z_up))
            && let Some(axes) = self.most_seen(z_up)
        {
            let (view, spots) = seen_in(axes);
            let page = Page::of(view.seen.size, &spots, &[]);
            chosen.push((view, spots, page));
        }
        let flat = self.settings.product != Product::Fins && !self.is_level(z_up);
        let flat = flat.then(|| {
            let laid = self.unrolled(z_up);
            let spots = self.unrolled_spots(&laid, &marks);
            let page = Page::of(laid.size, &spots, &missing);
            missing.retain(|mark| !page.names(&spots, *mark));
            (laid, spots, page)
        });
        let count = chosen.len() + usize::from(flat.is_some());
        let hidden = match missing.len() {
            0 => String::new(),
            1 => ", WITHOUT 1 NAME THAT NO VIEW SHOWS".to_owned(),
            hidden => format!(", WITHOUT {hidden} NAMES THAT NO VIEW SHOWS"),
        };
        let drawings = chosen.iter().zip(1..).map(|((view, spots, page), number)| {
            let seen = seen_from(view.axes, z_up);
            let title = format!("KEY {number}/{count}, NOT TO BE CUT, SEEN FROM {seen}{hidden}");
            let name = format!("key-{number}");
            let place = (view.seen.low, view.seen.size);
            page.drawing((name, title), place, view.lines(&seams), (spots, &marks))
        });
        let mut drawings: Vec<Drawing> = drawings.collect();
        if let Some((laid, spots, page)) = flat {
            let side = if self.surface.one_sided.is_none() { ", SEEN FROM OUTSIDE" } else { "" };
            let title =
                format!("KEY {count}/{count}, NOT TO BE CUT, UNROLLED BY ROWS{side}{hidden}");
            let lines = [&laid.lines[..], &self.unrolled_seams(&laid, &seams)].concat();
            let (name, place) = (format!("key-{count}"), ([0.0; 2], laid.size));
            drawings.push(page.drawing((name, title), place, lines, (&spots, &marks)));
        }
        drawings
    }

    /// The view from the side that most of the panels face; none if the shape is level.
    fn most_seen(&self, z_up: bool) -> Option<ViewAxes> {
        if self.is_level(z_up) {
            return None;
        }
        let facing = |[_, _, away]: ViewAxes| -> f64 {
            self.surface.areas.iter().map(|area| (-area.dot(away)).max(0.0)).sum()
        };
        // In a tie the first one, regardless of rounding.
        let more = |best, other| if facing(other) > 1.001 * facing(best) { other } else { best };
        sides(z_up).into_iter().reduce(more)
    }

    /// Whether the whole shape lies in a level plane.
    fn is_level(&self, z_up: bool) -> bool {
        let surface = &self.surface;
        let [_, _, up] = compass(z_up);
        let heights =
            surface.faces.indices().iter().map(|&v| surface.positions[v as usize].dot(up));
        let [low, high] = heights
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
        high - low <= LEVEL * surface.mean_edge()
    }

    /// The names of the parts that are made, and where they go. The panels of a paper model have the
    /// name of their piece, or of both if they are cut along a crease.
    fn marks(&self) -> Vec<Mark> {
        let surface = &self.surface;
        if self.settings.product == Product::Fins {
            let ends = |e: &u32| surface.edges[*e as usize].ends;
            let nodes = super::surface::distinct(self.fins.iter().flat_map(ends)).into_iter();
            let nodes =
                nodes.map(|v| Mark { name: self.node_name(v), element: Element::Vertex(v) });
            let beams = self.fins.iter().map(|e| (self.beam_name(ends(e)), Element::Edge(*e)));
            let beams = beams.map(|(name, element)| Mark { name, element });
            return beams.chain(nodes).collect();
        }
        if self.settings.product == Product::Panels {
            let parts = self.cut.iter().flatten().flat_map(CutPanel::parts);
            let mark = |part: &CutPart| {
                let f = part.panels[0];
                let element = match self.names[f as usize] == part.name {
                    true => Element::Panel(f),
                    false => {
                        let outline: Vec<Point2> =
                            part.outline.iter().map(|&corner| self.on_part(corner)).collect();
                        Element::Piece(f, self.in_space(f, &outline))
                    }
                };
                Mark { name: part.name.clone(), element }
            };
            return parts.map(|part| mark(&self.parts[part])).collect();
        }
        let mut names = vec![Vec::new(); self.names.len()];
        for part in &self.parts {
            part.panels.iter().for_each(|&f| names[f as usize].push(&*part.name));
        }
        let made = names.into_iter().zip(0..).filter(|(names, _)| !names.is_empty());
        made.map(|(names, f)| Mark { name: names.join("/"), element: Element::Panel(f) }).collect()
    }
}

impl Build {
    /// Points of a panel as it is cut, in space.
    fn in_space(&self, panel: u32, points: &[Point2]) -> Vec<Vec3<f64>> {
        let f = panel as usize;
        let (Some(flat), Some(cut)) = (&self.flat[f], &self.cut[f]) else { return Vec::new() };
        let back = [cut.turn[0], -cut.turn[1]];
        let put = |&point: &Point2| {
            let [x, y] = rotated(point, back).map(|x| x / self.mm_of_sheet());
            flat.origin + flat.axes[0] * x + flat.axes[1] * y
        };
        points.iter().map(put).collect()
    }
}

/// The views from four sides, of an isometric drawing.
fn sides(z_up: bool) -> [ViewAxes; 4] {
    [0.0, 1.0, 2.0, 3.0].map(|k| from_camera(z_up, [FRAC_PI_4 + FRAC_PI_2 * k, TILT]))
}

/// The views beside that from above: from four sides, and from below.
fn around(z_up: bool) -> Vec<ViewAxes> {
    let [east, north, up] = compass(z_up);
    sides(z_up).into_iter().chain([[east, -north, up]]).collect()
}

/// Whether a view is neither from above nor from below.
fn is_from_a_side([_, _, away]: ViewAxes, z_up: bool) -> bool {
    let [_, _, up] = compass(z_up);
    away.dot(up).abs() < 0.99
}

/// Where the viewer is, in words, with the axes of the mesh.
fn seen_from(axes: ViewAxes, z_up: bool) -> String {
    let [_, _, up] = compass(z_up);
    let [_, _, away] = axes;
    if !is_from_a_side(axes, z_up) {
        return if away.dot(up) < 0.0 { "ABOVE" } else { "BELOW" }.to_owned();
    }
    let sign = |x: f64| if x < 0.0 { '+' } else { '-' };
    let (second, letter) = if z_up { (away.y, 'Y') } else { (away.z, 'Z') };
    format!("{}X {}{letter}, ABOVE", sign(away.x), sign(second))
}
