//! Everything that is built as objects on layers, for CAD programs: panels, offset, beams, node
//! axes, and the sheets at their real size beside the shape.

use crate::fabricate::beam::Prism;
use crate::fabricate::build::{Build, beam_name, node_name};
use crate::fabricate::panel::triangles_in_space;
use crate::fabricate::sheet::Role;
use crate::math::{Vec3, twice_vector_area};
use serde::Serialize;

/// An object on a layer, in the unit of the mesh; z is up.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct SpatialPart {
    /// The name of its layer.
    pub layer: String,
    /// The colour of the layer: red, green, blue.
    pub colour: [u8; 3],
    /// Its name; may be empty.
    pub name: String,
    /// Its points.
    pub points: Vec<[f64; 3]>,
    /// Its faces over the points, counterclockwise seen from outside; empty for a line. Faces that a
    /// program could fill wrongly are triangles: those with more than four corners or a notch.
    pub faces: Vec<Vec<u32>>,
    /// Whether a line leads back to its first point, which is not repeated.
    pub closed: bool,
}

/// Faces, those with more than four corners or a notch as triangles.
fn filled(faces: &[Vec<u32>], points: &[Vec3<f64>]) -> Vec<Vec<u32>> {
    let mut found = Vec::new();
    for face in faces {
        let corners: Vec<Vec3<f64>> = face.iter().map(|&v| points[v as usize]).collect();
        let outside = twice_vector_area(corners.iter().copied());
        let n = corners.len();
        let turns_left = |k: usize| {
            let [a, b, c] = [k, k + 1, k + 2].map(|k| corners[k % n]);
            (b - a).cross(c - b).dot(outside) >= 0.0
        };
        match n <= 4 && (0..n).all(turns_left) {
            true => found.push(face.clone()),
            false => found.extend(
                triangles_in_space(&corners).into_iter().map(|own| own.map(|k| face[k]).into()),
            ),
        }
    }
    found
}

/// Distance of sheets from the shape and from each other, as a fraction of their width.
const BESIDE: f64 = 0.1;

impl Build {
    /// All objects, rotated so that z is up. `z_up` is whether z is up in the mesh; else y is.
    pub fn spatial_parts(&self, z_up: bool) -> Vec<SpatialPart> {
        let surface = &self.surface;
        let turned = |point: Vec3<f64>| -> [f64; 3] {
            let [x, y, z] = (point + surface.centre).into();
            if z_up { [x, y, z] } else { [x, -z, y] }
        };
        let on = |layer: &str, colour, name: &str, points: &[Vec3<f64>]| SpatialPart {
            layer: layer.to_owned(),
            colour,
            name: name.to_owned(),
            points: points.iter().map(|&point| turned(point)).collect(),
            faces: Vec::new(),
            closed: false,
        };
        let faces: Vec<Vec<u32>> = surface.faces.iter().map(<[u32]>::to_vec).collect();
        let (grey, violet, brown, blue) =
            ([110, 110, 115], [90, 50, 165], [115, 75, 45], [0, 90, 160]);
        let mut parts = vec![SpatialPart {
            faces: filled(&faces, &surface.positions),
            ..on("Surface", grey, "", &surface.positions)
        }];
        for (face, name) in faces.iter().zip(&self.names) {
            let corners: Vec<_> = face.iter().map(|&v| surface.at(v)).collect();
            parts.push(SpatialPart { closed: true, ..on("Panels", grey, name, &corners) });
        }
        if let Some((axes, _)) = &self.offset {
            let above = surface.positions.iter().zip(&axes.axes);
            let above: Vec<_> = above.map(|(p, n)| *p + *n * self.distance()).collect();
            let own = on("Offset", violet, "", &above);
            parts.push(SpatialPart { faces: filled(&faces, &above), ..own });
            for (v, (&low, &high)) in (0..).zip(surface.positions.iter().zip(&above)) {
                if low != high {
                    parts.push(on("Nodes", blue, &node_name(v), &[low, high]));
                }
            }
        }
        let prisms = self.frame.iter().flat_map(|frame| &frame.prisms);
        for (edge, prism) in surface.edges.iter().zip(prisms) {
            if let Some(prism) = prism {
                let name = beam_name(edge.ends);
                let own = on("Beams", brown, &name, &prism.corners);
                let faces = filled(&Prism::faces(), &prism.corners);
                parts.push(SpatialPart { faces, ..own });
            }
        }
        let beside = parts.iter().flat_map(|part| &part.points);
        let (mut right, mut front) = (f64::NEG_INFINITY, f64::INFINITY);
        for [x, y, _] in beside {
            (right, front) = (right.max(*x), front.min(*y));
        }
        parts.extend(self.sheets_from([right, front]));
        parts
    }

    /// The lines of all sheets at their real size, side by side to the right of this point on the
    /// ground.
    fn sheets_from(&self, [right, front]: [f64; 2]) -> Vec<SpatialPart> {
        let of_mm = 1.0 / self.mm_of_building();
        let mut parts = Vec::new();
        let mut left = right;
        for drawing in self.drawings() {
            left += BESIDE * drawing.size[0] * of_mm;
            for line in &drawing.lines {
                let put = |&[x, y]: &[f64; 2]| [left + x * of_mm, front + y * of_mm, 0.0];
                let title = if line.role == Role::Sheet { &drawing.name } else { &line.part };
                parts.push(SpatialPart {
                    layer: format!("Sheets {}", line.role.layer()),
                    colour: line.role.rgb(),
                    name: title.clone(),
                    points: line.points.iter().map(put).collect(),
                    faces: Vec::new(),
                    closed: line.closed,
                });
            }
            left += drawing.size[0] * of_mm;
        }
        parts
    }
}
