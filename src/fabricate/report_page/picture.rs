//! The shape as lines and areas, by the painter's algorithm: panels from the farthest to the
//! nearest.

use super::helvetica::width;
use super::mark::{BLACK, Colour, GREY, Mark, RED, Shape, text};
use crate::fabricate::build::Build;
use crate::fabricate::check_card::Failed;
use crate::fabricate::panel::roomiest_point;
use crate::math::plane::Point2;
use crate::math::{self, Vec3, argsort, key_of_number, marked};

/// Names are shown on the plan if this fraction of them has room.
const MOST: f64 = 0.7;

/// The direction of view as unit vectors: right, up, and away from the viewer.
pub(super) type Sight = [Vec3<f64>; 3];

/// Smallest and largest font size of panel names on a plan.
const NAMES: [f64; 2] = [1.1, 2.4];

/// The axes of a mesh that point east, north and up, if z is up, or else y.
fn compass(z_up: bool) -> Sight {
    let [x, y, z] = [Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0)];
    if z_up { [x, y, z] } else { [x, -z, y] }
}

/// The view from above.
pub(super) fn from_above(z_up: bool) -> Sight {
    let [east, north, up] = compass(z_up);
    [east, north, -up]
}

/// The view of a camera that is turned about the upward axis and tilted down, in radians.
pub(super) fn from_camera(z_up: bool, camera: [f64; 2]) -> Sight {
    let [east, north, up] = compass(z_up);
    let turns = |radians: f64| radians / std::f64::consts::TAU;
    let [[sine, cosine], [down, level]] =
        camera.map(turns).map(|turns| [math::sine(turns), math::cosine(turns)]);
    let right = east * cosine + north * sine;
    let away = (north * cosine - east * sine) * level - up * down;
    [right, right.cross(away), away]
}

/// A shape in a view, in the unit of the mesh.
pub(super) struct Picture<'a> {
    build: &'a Build,
    sight: Sight,
    points: Vec<Point2>,
    /// The panels, farthest first.
    order: Vec<u32>,
    low: Point2,
    pub(super) size: [f64; 2],
}

impl Picture<'_> {
    pub(super) fn new(build: &Build, sight: Sight) -> Picture<'_> {
        let [right, up, away] = sight;
        let surface = &build.surface;
        let points: Vec<Point2> =
            surface.positions.iter().map(|p| [p.dot(right), p.dot(up)]).collect();
        let depth = |face: &[u32]| {
            face.iter().map(|&v| surface.at(v).dot(away)).sum::<f64>() / face.len() as f64
        };
        let order = argsort(surface.faces.iter().map(|face| key_of_number(-depth(face))));
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for &v in surface.faces.indices() {
            for k in 0..2 {
                low[k] = low[k].min(points[v as usize][k]);
                high[k] = high[k].max(points[v as usize][k]);
            }
        }
        let size = [0, 1].map(|k| high[k] - low[k]);
        Picture { build, sight, points, order, low, size }
    }

    /// The scale at which it fills a box, in mm per unit of the mesh.
    pub(super) fn scale_in(&self, room: [f64; 2]) -> f64 {
        let scale = (0..2).map(|k| room[k] / self.size[k]).fold(f64::INFINITY, f64::min);
        if scale.is_finite() { scale } else { 1.0 }
    }

    /// The vertices, centred in a box.
    fn placed(&self, corner: Point2, room: [f64; 2], scale: f64) -> Vec<Point2> {
        let put = |point: &Point2| {
            [0, 1].map(|k| {
                let free = room[k] - scale * self.size[k];
                corner[k] + 0.5 * free + scale * (point[k] - self.low[k])
            })
        };
        self.points.iter().map(put).collect()
    }

    /// Shaded panels, with failing elements in red.
    pub(super) fn shaded(&self, corner: Point2, room: [f64; 2], failed: &Failed) -> Vec<Mark> {
        let scale = self.scale_in(room);
        let points = self.placed(corner, room, scale);
        let [right, up, away] = self.sight;
        let light = right * -0.37 + up * 0.56 - away * 0.74;
        let fails = marked(self.build.surface.faces.len(), &failed.panels);
        let of_panel = |f: u32| {
            let share = 0.62 + 0.38 * self.build.surface.normal(f).dot(light).abs().min(1.0);
            let base: Colour = if fails[f as usize] { [240, 120, 120] } else { [224, 230, 243] };
            base.map(|part| (f64::from(part) * share + 0.5) as u8)
        };
        let pen = (0.03 * scale * self.build.surface.mean_edge()).clamp(0.03, 0.15);
        let mut marks = self.panels(&points, pen, of_panel);
        let edges = failed
            .edges
            .iter()
            .map(|&e| self.build.surface.edges[e as usize].ends.map(|v| points[v as usize]).into());
        let paths: Vec<Vec<Point2>> = edges.collect();
        if !paths.is_empty() {
            marks.push(Mark::Shape(Shape { paths, fill: None, pen: Some((3.0 * pen, RED)) }));
        }
        marks
    }

    /// Panels as outlines, with names if there is room, at a scale in mm per unit of the mesh.
    pub(super) fn plan(&self, corner: Point2, room: [f64; 2], scale: f64) -> Vec<Mark> {
        let points = self.placed(corner, room, scale);
        let pen = (0.02 * scale * self.build.surface.mean_edge()).clamp(0.03, 0.12);
        let panels = self.panels(&points, pen, |_| [255; 3]);
        let names: Vec<Option<Mark>> = self.order.iter().map(|&f| self.name(f, &points)).collect();
        // With only some of the names, panels would seem to be missing.
        let enough = names.iter().flatten().count() as f64 >= MOST * names.len() as f64;
        let shown = |(panel, name)| [Some(panel), name].into_iter().flatten();
        match enough {
            true => panels.into_iter().zip(names).flat_map(shown).collect(),
            false => panels,
        }
    }

    /// The name of a panel at its roomiest point, if it fits.
    fn name(&self, f: u32, points: &[Point2]) -> Option<Mark> {
        let name = &self.build.names[f as usize];
        // Capital letters are 0.72 of the font size high.
        let [half, tall] = [0.5 * width(name, 1.0), 0.36];
        let corners: Vec<Point2> =
            self.build.surface.faces.row(f as usize).iter().map(|&v| points[v as usize]).collect();
        let (middle, radius) = roomiest_point(&corners);
        let size = (0.95 * radius / (half * half + tall * tall).sqrt()).min(NAMES[1]);
        let at = [middle[0] - half * size, middle[1] - tall * size];
        (size >= NAMES[0]).then(|| text(at, size, GREY, name))
    }

    fn panels(&self, points: &[Point2], pen: f64, fill: impl Fn(u32) -> Colour) -> Vec<Mark> {
        let panel = |&f: &u32| {
            let corners = self.build.surface.faces.row(f as usize).iter();
            let paths = vec![corners.map(|&v| points[v as usize]).collect()];
            Mark::Shape(Shape { paths, fill: Some(fill(f)), pen: Some((pen, BLACK)) })
        };
        self.order.iter().map(panel).collect()
    }
}
