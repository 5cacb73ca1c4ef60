//! The shape as SVG, by the painter's algorithm: panels from the farthest to the nearest. Lengths
//! are in mm when printed.

use crate::fabricate::build::Build;
use crate::fabricate::check_card::Failed;
use crate::fabricate::file::{escaped, places};
use crate::fabricate::panel::roomiest_point;
use crate::fabricate::view_axes::{Seen, ViewAxes};
use crate::math::plane::Point2;
use crate::math::{argsort, key_of_number, marked};

/// Names are shown on the plan if this fraction of them has room.
const MOST: f64 = 0.7;

/// Least height of a picture.
const LEAST: f64 = 4.0;
/// Smallest and largest font size of panel names on a plan.
const NAMES: [f64; 2] = [1.1, 2.4];
/// Width of a letter or digit of a name and height of a capital, in font sizes, in any sans-serif
/// font.
const LETTER: [f64; 2] = [0.6, 0.72];

/// A shape in a view, in the unit of the mesh.
pub(super) struct Picture<'a> {
    build: &'a Build,
    axes: ViewAxes,
    pub(super) seen: Seen,
    /// The panels, farthest first.
    order: Vec<u32>,
}

impl Picture<'_> {
    pub(super) fn new(build: &Build, axes: ViewAxes) -> Picture<'_> {
        let seen = Seen::new(&build.surface, axes);
        let depth = |face: &[u32]| {
            face.iter().map(|&v| seen.depths[v as usize]).sum::<f64>() / face.len() as f64
        };
        let order = argsort(build.surface.faces.iter().map(|face| key_of_number(-depth(face))));
        Picture { build, axes, seen, order }
    }

    /// The scale at which it fills a box, in mm per unit of the mesh.
    pub(super) fn scale_in(&self, room: [f64; 2]) -> f64 {
        let scale = (0..2).map(|k| room[k] / self.seen.size[k]).fold(f64::INFINITY, f64::min);
        if scale.is_finite() { scale } else { 1.0 }
    }

    /// A box of this width that is as high as the shape, and the vertices in it, with y downwards
    /// and centred.
    fn placed(&self, width: f64, scale: f64) -> ([f64; 2], Vec<Point2>) {
        let [wide, high] = self.seen.size.map(|size| scale * size);
        let room = [width, high.max(LEAST)];
        let put = |point: &Point2| {
            let [right, up] = [0, 1].map(|k| scale * (point[k] - self.seen.low[k]));
            [0.5 * (room[0] - wide) + right, 0.5 * (room[1] + high) - up]
        };
        (room, self.seen.points.iter().map(put).collect())
    }

    /// Shaded panels that fill a box in one direction, with failing elements in red.
    pub(super) fn shaded(&self, room: [f64; 2], failed: &Failed) -> String {
        let scale = self.scale_in(room);
        let (room, points) = self.placed(room[0], scale);
        let [right, up, away] = self.axes;
        let light = right * -0.37 + up * 0.56 - away * 0.74;
        let fails = marked(self.build.surface.faces.len(), &failed.panels);
        let fill = |f: u32| {
            let share = 0.62 + 0.38 * self.build.surface.normal(f).dot(light).abs().min(1.0);
            let base = if fails[f as usize] { [240, 120, 120] } else { [224, 230, 243] };
            let [r, g, b] = base.map(|part| (f64::from(part) * share + 0.5) as u8);
            format!(" fill=\"#{r:02x}{g:02x}{b:02x}\"")
        };
        let pen = (0.03 * scale * self.build.surface.mean_edge()).clamp(0.03, 0.15);
        let panels = self.order.iter().map(|&f| self.panel(f, &points, &fill(f)));
        let panels: String = panels.collect();
        let edges = failed.edges.iter().map(|&e| {
            let ends = self.build.surface.edges[e as usize].ends.map(|v| points[v as usize]);
            path(ends.into_iter())
        });
        let edges = match edges.collect::<String>() {
            none if none.is_empty() => none,
            d => format!(
                "<path class=\"failed\" stroke-width=\"{}\" d=\"{d}\"/>\n",
                places(3.0 * pen, 3)
            ),
        };
        svg(room, "The shape in the current view", pen, &(panels + &edges))
    }

    /// Panels as outlines, with names if there is room, at a scale in mm per unit of the mesh.
    pub(super) fn plan(&self, width: f64, scale: f64) -> String {
        let (room, points) = self.placed(width, scale);
        let pen = (0.02 * scale * self.build.surface.mean_edge()).clamp(0.03, 0.12);
        let names: Vec<Option<String>> =
            self.order.iter().map(|&f| self.name(f, &points)).collect();
        // With only some of the names, panels would seem to be missing.
        let enough = names.iter().flatten().count() as f64 >= MOST * names.len() as f64;
        // A name comes right after its panel, so that panels above hide it.
        let drawn = self.order.iter().zip(names).map(|(&f, name)| {
            let name = name.filter(|_| enough).unwrap_or_default();
            self.panel(f, &points, "") + &name
        });
        svg(room, "The plan", pen, &drawn.collect::<String>())
    }

    /// The name of a panel at its roomiest point, if it fits.
    fn name(&self, f: u32, points: &[Point2]) -> Option<String> {
        let name = &self.build.names[f as usize];
        let [half, tall] = [0.5 * LETTER[0] * name.chars().count() as f64, 0.5 * LETTER[1]];
        let corners: Vec<Point2> =
            self.build.surface.faces.row(f as usize).iter().map(|&v| points[v as usize]).collect();
        let (middle, radius) = roomiest_point(&corners);
        let size = (0.95 * radius / (half * half + tall * tall).sqrt()).min(NAMES[1]);
        let [x, y, font] = [middle[0], middle[1] + tall * size, size].map(|at| places(at, 2));
        (size >= NAMES[0]).then(|| {
            format!("<text x=\"{x}\" y=\"{y}\" font-size=\"{font}\">{}</text>\n", escaped(name))
        })
    }

    fn panel(&self, f: u32, points: &[Point2], fill: &str) -> String {
        let face = self.build.surface.faces.row(f as usize);
        let ring =
            |ring: Vec<usize>| path(ring.into_iter().map(|k| points[face[k] as usize])) + "Z";
        let d: String = self.build.surface.rings(f).into_iter().map(ring).collect();
        format!("<path{fill} d=\"{d}\"/>\n")
    }
}

/// A picture that fills a box, with lines of the width `pen`.
fn svg(room: [f64; 2], label: &str, pen: f64, content: &str) -> String {
    let [width, height, pen] = [room[0], room[1], pen].map(|length| places(length, 3));
    format!(
        "<svg class=\"shape\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{label}\" stroke-width=\"{pen}\">\n{content}</svg>"
    )
}

fn path(points: impl Iterator<Item = Point2>) -> String {
    let points = points.zip(std::iter::once('M').chain(std::iter::repeat('L')));
    points.map(|([x, y], letter)| format!("{letter}{},{}", places(x, 2), places(y, 2))).collect()
}
