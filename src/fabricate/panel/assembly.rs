//! The order of assembly: rows of panels from the supports upwards, and within a row from each panel
//! to a neighbour.
//!
//! The first row stands on what is held, or else on the ground: it has the panels at the lowest part of
//! the rim, or where that is not the lowest part of the surface, its lowest panel. Every other row has the
//! panels beside the row before. Each connected component stands by itself; a row goes on from one to the
//! next.

use crate::fabricate::surface::PanelSurface;
use crate::math::{Vec3, marked, polygon_sides, sort_by_number};
use crate::mesh::components;
use crate::scene::{HandleSpec, Hold, Scene, Up};
use std::collections::VecDeque;

/// Height of the rim that stands on the ground, as a fraction of the height of its component.
const ON_GROUND: f64 = 0.02;
/// Differences of heights due to rounding, and radii without a direction, as a fraction of the size.
const ROUNDING: f64 = 1e-6;
/// Directions about the vertical that differ by more are not the same, as a fraction of a turn.
const DIRECTIONS: i64 = 1 << 20;

/// How a shape stands; by default on the ground, with z up.
#[derive(Clone, Debug, Default)]
pub struct Stand {
    /// The axis that points up.
    pub up: Up,
    /// The vertices that are held where they are; those that the mesh does not have hold nothing.
    pub held: Vec<u32>,
}

impl Stand {
    /// As a scene says.
    pub fn of_scene(scene: &Scene) -> Stand {
        Stand::on(&scene.handles, scene.up)
    }

    /// On the fixed ones of some handles.
    pub fn on(handles: &[HandleSpec], up: Up) -> Stand {
        let fixed = handles.iter().filter(|handle| handle.hold == Hold::Fixed);
        Stand { up, held: fixed.flat_map(|handle| handle.vertices.iter().copied()).collect() }
    }

    /// The height of a point, and its two coordinates in plan, counterclockwise seen from above.
    fn height_and_plan(&self, point: Vec3<f64>) -> (f64, [f64; 2]) {
        match self.up {
            Up::Z => (point.z, [point.x, point.y]),
            Up::Y => (point.y, [point.z, point.x]),
        }
    }
}

/// The number of each vertex in the order of assembly, from 1: with the first of its panels, which are
/// assembled in these `rows`; of one panel the lower ones first, else as they follow on it. Vertices without
/// panels come last.
pub fn assembly_of_nodes(surface: &PanelSurface, rows: &[Vec<u32>], stand: &Stand) -> Vec<u32> {
    /// Heights that differ by less are the same, as a fraction of the mean length of the edges.
    const LEVEL: f64 = 0.01;
    let level = LEVEL * surface.mean_edge();
    let height = |v: u32| stand.height_and_plan(surface.at(v)).0;
    let mut numbers = vec![0; surface.positions.len()];
    let mut count = 0;
    let mut add = |v: u32| {
        if numbers[v as usize] == 0 {
            count += 1;
            numbers[v as usize] = count;
        }
    };
    for &f in rows.iter().flatten() {
        let mut own = surface.faces.row(f as usize).to_vec();
        let lowest = own.iter().map(|&v| height(v)).fold(f64::INFINITY, f64::min);
        sort_by_number(&mut own, |&v| match level > 0.0 {
            true => ((height(v) - lowest) / level) as u64,
            false => 0,
        });
        own.into_iter().for_each(&mut add);
    }
    (0..surface.positions.len() as u32).for_each(add);
    numbers
}

/// The panels of each row, in the order of assembly. All panels are in one row.
pub fn assembly_rows(surface: &PanelSurface, stand: &Stand) -> Vec<Vec<u32>> {
    let plan = Plan::new(surface, stand);
    let mut row_of: Vec<Option<usize>> = vec![None; surface.faces.len()];
    let mut queue: VecDeque<u32> = plan.supports(stand).into();
    queue.iter().for_each(|&f| row_of[f as usize] = Some(0));
    let mut rows: Vec<Vec<u32>> = Vec::new();
    while let Some(f) = queue.pop_front() {
        let row = row_of[f as usize].unwrap_or(0);
        rows.resize_with(rows.len().max(row + 1), Vec::new);
        rows[row].push(f);
        for &e in surface.sides.row(f as usize) {
            for other in surface.others(e, f) {
                if row_of[other as usize].is_none() {
                    row_of[other as usize] = Some(row + 1);
                    queue.push_back(other);
                }
            }
        }
    }
    rows.iter().map(|row| plan.along(row, &row_of)).collect()
}

/// The panels in plan.
struct Plan<'a> {
    surface: &'a PanelSurface,
    /// The connected component of each panel, over common edges.
    component: Vec<u32>,
    /// The height of each vertex.
    heights: Vec<f64>,
    /// The direction of each panel from the middle of its component, counterclockwise from the first
    /// axis of the plan, in steps of a turn over [`DIRECTIONS`].
    directions: Vec<i64>,
    /// The panels at each vertex.
    around: Vec<Vec<u32>>,
}

impl Plan<'_> {
    fn new<'a>(surface: &'a PanelSurface, stand: &Stand) -> Plan<'a> {
        let component = components(surface.faces.len(), surface.panels.iter());
        let points: Vec<_> =
            surface.positions.iter().map(|&at| stand.height_and_plan(at)).collect();
        let count = component.iter().max().map_or(0, |last| *last as usize + 1);
        let mut boxes = vec![[[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]]; count];
        for (face, &own) in surface.faces.iter().zip(&component) {
            let [low, high] = &mut boxes[own as usize];
            for &v in face {
                for (k, x) in points[v as usize].1.into_iter().enumerate() {
                    (low[k], high[k]) = (low[k].min(x), high[k].max(x));
                }
            }
        }
        let direction = |(face, own): (&[u32], &u32)| {
            let [low, high] = boxes[*own as usize];
            let [x, y] = [0, 1].map(|k| {
                let sum: f64 = face.iter().map(|&v| points[v as usize].1[k]).sum();
                sum / face.len() as f64 - 0.5 * (low[k] + high[k])
            });
            let size = (high[0] - low[0]).max(high[1] - low[1]);
            if x.abs().max(y.abs()) <= ROUNDING * size {
                return 0;
            }
            let turns = libm::atan2(y, x) / std::f64::consts::TAU;
            ((turns * DIRECTIONS as f64 + 0.5).floor() as i64).rem_euclid(DIRECTIONS)
        };
        let directions = surface.faces.iter().zip(&component).map(direction).collect();
        let heights = points.iter().map(|(height, _)| *height).collect();
        Plan { surface, component, heights, directions, around: surface.panels_around() }
    }

    /// The panels of the first row.
    fn supports(&self, stand: &Stand) -> Vec<u32> {
        let count = self.component.iter().max().map_or(0, |last| *last as usize + 1);
        let (mut low, mut high) = (vec![f64::INFINITY; count], vec![f64::NEG_INFINITY; count]);
        let mut lowest_panel = vec![f64::INFINITY; count];
        for (face, &own) in self.surface.faces.iter().zip(&self.component) {
            let own = own as usize;
            for &v in face {
                low[own] = low[own].min(self.heights[v as usize]);
                high[own] = high[own].max(self.heights[v as usize]);
            }
            lowest_panel[own] = lowest_panel[own].min(self.middle(face));
        }
        let size = self.surface.mean_edge();
        let vertices = self.heights.len();
        let is_there = |v: &&u32| (**v as usize) < vertices;
        let held = marked(vertices, stand.held.iter().filter(is_there));
        // What each panel of a component stands on: the first of these that any of them has.
        let ranks: Vec<Option<usize>> = (0..self.component.len())
            .map(|f| {
                let own = self.component[f] as usize;
                let rounding = ROUNDING * size.max(high[own] - low[own]);
                let ground = low[own] + ON_GROUND * (high[own] - low[own]) + rounding;
                let face = self.surface.faces.row(f);
                let sides = self.surface.sides.row(f).iter().zip(polygon_sides(face));
                let on_ground = |(e, ends): (&u32, [u32; 2])| {
                    self.surface.edges[*e as usize].is_rim()
                        && ends.iter().all(|&v| self.heights[v as usize] <= ground)
                };
                let reasons = [
                    face.iter().any(|&v| held[v as usize]),
                    sides.into_iter().any(on_ground),
                    self.middle(face) <= lowest_panel[own] + rounding,
                ];
                reasons.iter().position(|is_met| *is_met)
            })
            .collect();
        let mut best = vec![usize::MAX; count];
        for (rank, &own) in ranks.iter().zip(&self.component) {
            best[own as usize] = best[own as usize].min(rank.unwrap_or(usize::MAX));
        }
        let stands =
            |f: &u32| ranks[*f as usize] == Some(best[self.component[*f as usize] as usize]);
        (0..self.component.len() as u32).filter(stands).collect()
    }

    /// The height of the middle of a panel.
    fn middle(&self, face: &[u32]) -> f64 {
        face.iter().map(|&v| self.heights[v as usize]).sum::<f64>() / face.len() as f64
    }

    /// A row in order: from an end, or else from the first direction, counterclockwise seen from above
    /// and from each panel to a neighbour; what cannot be reached so follows.
    fn along(&self, row: &[u32], row_of: &[Option<usize>]) -> Vec<u32> {
        let is_beside = |f: u32, g: &u32| *g != f && row_of[*g as usize] == row_of[f as usize];
        let across = |f: u32| {
            let sides = self.surface.sides.row(f as usize).iter();
            sides.flat_map(move |&e| self.surface.others(e, f)).filter(move |g| is_beside(f, g))
        };
        let touching = |f: u32| {
            let corners = self.surface.faces.row(f as usize).iter();
            let all = corners.flat_map(|&v| self.around[v as usize].iter().copied());
            all.filter(move |g| is_beside(f, g))
        };
        let ahead = |f: u32, g: u32| {
            let step = self.directions[g as usize] - self.directions[f as usize];
            step.rem_euclid(DIRECTIONS)
        };
        // An end has at most one neighbour; it should lie ahead.
        let start = |f: u32| {
            let first = touching(f).next();
            let is_end = first.is_none_or(|first| touching(f).all(|other| other == first));
            let leads_on = first.is_none_or(|first| 2 * ahead(f, first) < DIRECTIONS);
            let end = if is_end { 1 + usize::from(!leads_on) } else { 3 };
            (self.component[f as usize], end, self.directions[f as usize], f)
        };
        let mut starts: Vec<_> = row.iter().map(|&f| start(f)).collect();
        starts.sort_unstable();
        let mut is_open = vec![false; row_of.len()];
        row.iter().for_each(|&f| is_open[f as usize] = true);
        let mut found = Vec::with_capacity(row.len());
        for (.., first) in starts {
            let mut next = Some(first).filter(|&f| is_open[f as usize]);
            while let Some(f) = next {
                is_open[f as usize] = false;
                found.push(f);
                let open = |g: &u32| is_open[*g as usize];
                let nearest = |g: &u32| (ahead(f, *g), *g);
                next = across(f).filter(open).min_by_key(nearest);
                next = next.or_else(|| touching(f).filter(open).min_by_key(nearest));
            }
        }
        found
    }
}
