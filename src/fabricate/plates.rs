//! Fins and node discs as plates in space, as they are assembled: of the thickness of the material at
//! the scale of the building.

use super::beam::{BeamPlane, Disc, Frame};
use super::build::Build;
use super::discs::as_one_polygon;
use super::panel::triangles;
use super::space::Body;
use crate::math::Vec3;
use crate::math::plane::Point2;

impl Body {
    /// A plate of an outline, of which `put` places a point on the lower side and on the upper: its two
    /// sides as triangles, then its edges. Corners that coincide are one point.
    fn plate(name: String, outline: &[Point2], put: impl Fn(Point2) -> [Vec3<f64>; 2]) -> Body {
        let mut corners: Vec<Point2> = Vec::new();
        let number = |corner: &Point2| {
            corners.iter().position(|own| own == corner).unwrap_or_else(|| {
                corners.push(*corner);
                corners.len() - 1
            }) as u32
        };
        let around: Vec<u32> = outline.iter().map(number).collect();
        let n = corners.len() as u32;
        let both: Vec<[Vec3<f64>; 2]> = corners.iter().map(|&corner| put(corner)).collect();
        let points = [0, 1].into_iter().flat_map(|side| both.iter().map(move |own| own[side]));
        let mut faces = Vec::new();
        for [a, b, c] in triangles(outline).into_iter().map(|own| own.map(|k| around[k])) {
            faces.extend([vec![n + a, n + b, n + c], vec![c, b, a]]);
        }
        for (k, &a) in around.iter().enumerate() {
            let b = around[(k + 1) % around.len()];
            // A cut without width is passed in both directions.
            let is_cut =
                (0..around.len()).any(|j| around[j] == b && around[(j + 1) % around.len()] == a);
            if !is_cut {
                faces.push(vec![a, b, n + b, n + a]);
            }
        }
        Body { name, points: points.collect(), faces }
    }
}

impl Build {
    /// The fins and the discs, as assembled; empty without discs.
    pub(super) fn plates(&self) -> [Vec<Body>; 2] {
        let (Some(frame), Some((axes, _))) = (&self.frame, &self.offset) else {
            return [Vec::new(), Vec::new()];
        };
        if self.discs.is_empty() {
            return [Vec::new(), Vec::new()];
        }
        let thickness = self.settings.thickness / self.mm_of_sheet();
        let fins = self.fins.iter().filter_map(|&edge| {
            let fin = frame.fins[edge as usize].as_ref().ok()?;
            let plane = BeamPlane::of(&self.surface, &axes.axes, edge);
            let aside = plane.along.cross(plane.up) * (0.5 * thickness);
            let put = |corner: Point2| {
                let point = plane.in_space(corner);
                [point - aside, point + aside]
            };
            let name = self.beam_name(self.surface.edges[edge as usize].ends);
            Some(Body::plate(name, &fin.cut, put))
        });
        let discs = self.discs.iter().filter_map(|own| self.placed(frame, own.vertex, thickness));
        [fins.collect(), discs.collect()]
    }

    fn placed(&self, frame: &Frame, vertex: u32, thickness: f64) -> Option<Body> {
        let node = frame.nodes[vertex as usize].as_ref()?;
        let disc: &Disc = frame.discs[vertex as usize].as_ref()?.as_ref().ok()?;
        let other = disc.seat + self.distance().signum() * thickness;
        let heights = [disc.seat.min(other), disc.seat.max(other)];
        let put =
            |point: Point2| heights.map(|height| disc.in_space(&self.surface, node, point, height));
        Some(Body::plate(self.node_name(vertex), &as_one_polygon(disc), put))
    }
}
