//! Measures of faces, by which hosts colour and list them: the distance of a face to a shape, to
//! its constraints, and to the original.
//!
//! All measures are declared here, so that hosts need no names of measures.

use super::measuring::Shape;
use crate::math::{Vec3, angle_between, polygon_corners, polygon_sides};
use crate::mesh::{Curvature, CurvatureLines, Point, diagonal_ratio, face_curvatures};
use crate::session::Session;
use crate::words::MeasureUnit;
use serde::Serialize;
use std::f64::consts::PI;

/// A measure of faces: never negative and best at 0, unless it is signed.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct FaceMeasure {
    /// Its name in messages.
    pub id: &'static str,
    /// Its name on the page.
    pub label: &'static str,
    /// The measured quantity.
    pub words: &'static str,
    /// The statement that is true if the values of all faces are 0.
    pub met: &'static str,
    /// Its unit.
    pub unit: MeasureUnit,
    /// Whether it is a length to which the fabrication tolerance of the model applies.
    pub toleranced: bool,
    /// Whether values have both signs; 0 is then the middle, and neither best nor worst.
    pub signed: bool,
    #[serde(skip)]
    values: fn(&mut Session, &Shape) -> Vec<f64>,
}

/// A measure without its texts, unit and values, which every declaration states.
const PLAIN: FaceMeasure = FaceMeasure {
    id: "",
    label: "",
    words: "",
    met: "",
    unit: MeasureUnit::Number,
    toleranced: false,
    signed: false,
    values: |_, _| Vec::new(),
};

/// All measures, in the order in which they are offered.
pub const FACE_MEASURES: &[FaceMeasure] = &[
    FaceMeasure {
        id: "planarity",
        label: "Planarity",
        words: "largest distance of a face’s corners to its best plane",
        met: "each panel is flat",
        unit: MeasureUnit::Length,
        toleranced: true,
        values: |model, shape| model.measures_of(shape).planarity_distances.clone(),
        ..PLAIN
    },
    FaceMeasure {
        id: "diagonals",
        label: "Planarity: diagonals",
        words: "distance between the diagonals of a quad, relative to their mean length",
        met: "each panel is flat",
        unit: MeasureUnit::Percent,
        values: diagonals,
        ..PLAIN
    },
    FaceMeasure {
        id: "diagonals-by-edge",
        label: "Planarity: diagonals relative to the edge",
        words: "distance between the diagonals of a quad, relative to its mean edge length",
        met: "each panel is flat",
        unit: MeasureUnit::Percent,
        values: diagonals_by_edge,
        ..PLAIN
    },
    FaceMeasure {
        id: "planarity-by-edge",
        label: "Planarity: relative to the edge",
        words: "largest distance of a face’s corners to its best plane, relative to its mean edge length",
        met: "each panel is flat",
        unit: MeasureUnit::Percent,
        values: planarity_by_edge,
        ..PLAIN
    },
    FaceMeasure {
        id: "fourth-corner",
        label: "Planarity: fourth corner",
        words: "largest distance of a quad’s corner to the plane of the other three",
        met: "each panel is flat",
        unit: MeasureUnit::Length,
        toleranced: true,
        values: fourth_corners,
        ..PLAIN
    },
    FaceMeasure {
        id: "e-p",
        label: "Planarity: as in the paper",
        words: "mean squared distance of a face’s corners to its best plane, in a model of size 1",
        met: "each panel is flat",
        unit: MeasureUnit::Number,
        values: |model, shape| model.measures_of(shape).e_p.clone(),
        ..PLAIN
    },
    FaceMeasure {
        id: "circularity",
        label: "Circularity",
        words: "largest distance of a face’s corners to its best circle",
        met: "the corners of each panel lie on a circle",
        unit: MeasureUnit::Length,
        toleranced: true,
        values: |model, shape| model.measures_of(shape).circularity_distances.clone(),
        ..PLAIN
    },
    FaceMeasure {
        id: "e-c",
        label: "Circularity: as in the paper",
        words: "mean squared distance of a face’s corners to its best circle, in a model of size 1",
        met: "the corners of each panel lie on a circle",
        unit: MeasureUnit::Number,
        values: |model, shape| model.measures_of(shape).e_c.clone(),
        ..PLAIN
    },
    FaceMeasure {
        id: "residual",
        label: "Constraints",
        words: "largest distance of a face’s corners to the shapes of their constraints",
        met: "each panel satisfies its constraints",
        unit: MeasureUnit::Length,
        toleranced: true,
        values: Session::residuals_of,
        ..PLAIN
    },
    FaceMeasure {
        id: "edges",
        label: "Edge length change",
        words: "largest relative change in length of a face’s edges from the original",
        met: "each edge is as long as it was",
        unit: MeasureUnit::Percent,
        values: edge_changes,
        ..PLAIN
    },
    FaceMeasure {
        id: "angles",
        label: "Angle error",
        words: "largest difference of a face’s angles from those of the regular polygon",
        met: "the angles of each panel are equal",
        unit: MeasureUnit::Degrees,
        values: angles,
        ..PLAIN
    },
    FaceMeasure {
        id: "curvature-lines",
        label: "Off the lines of curvature",
        words: "mean angle of a face’s edges to the directions in which the surface bends most and least",
        met: "the edges follow the lines of curvature",
        unit: MeasureUnit::Degrees,
        values: off_curvature_lines,
        ..PLAIN
    },
    FaceMeasure {
        id: "gauss-curvature",
        label: "Gauss curvature",
        words: "product of the principal curvatures: above 0 on a bowl, below on a saddle",
        met: "the surface can be laid flat",
        unit: MeasureUnit::PerArea,
        signed: true,
        values: |model, shape| curvature(model, shape, Curvature::gauss),
        ..PLAIN
    },
    FaceMeasure {
        id: "mean-curvature",
        label: "Mean curvature",
        words: "mean of the principal curvatures: above 0 where the front of a face bulges",
        met: "the surface is minimal, as a soap film",
        unit: MeasureUnit::PerLength,
        signed: true,
        values: |model, shape| curvature(model, shape, |one| -one.mean()),
        ..PLAIN
    },
    FaceMeasure {
        id: "surface",
        label: "Distance to original",
        words: "largest distance of a face’s corners to the original surface",
        met: "each panel lies on the original",
        unit: MeasureUnit::Length,
        values: worst_surface_distances,
        ..PLAIN
    },
    FaceMeasure {
        id: "displacement",
        label: "Moved",
        words: "largest distance that a face’s corners have moved from the original",
        met: "each panel is where it was",
        unit: MeasureUnit::Length,
        values: worst_displacements,
        ..PLAIN
    },
];

impl FaceMeasure {
    /// Returns the measure `id`; none if there is no such measure.
    pub fn of(id: &str) -> Option<&'static FaceMeasure> {
        FACE_MEASURES.iter().find(|measure| measure.id == id)
    }
}

impl Session {
    /// Returns the values of the measure `id`, `#F`, in its unit; NaN for faces without one, such
    /// as a triangle, which has no diagonals. None if there is no such measure.
    pub fn face_values(&mut self, id: &str) -> Option<Vec<f64>> {
        self.face_values_of(id, &Shape::Now)
    }

    /// As [`Session::face_values`], for the current or the original shape.
    pub fn face_values_of(&mut self, id: &str, shape: &Shape) -> Option<Vec<f64>> {
        let measure = FaceMeasure::of(id)?;
        Some((measure.values)(self, shape))
    }

    /// Returns the values of the measure `id` as [`Session::face_values`] does, and the largest absolute
    /// one; rounding errors are 0 there.
    pub fn face_values_and_greatest(&mut self, id: &str) -> Option<(Vec<f64>, f64)> {
        let unit = FaceMeasure::of(id)?.unit;
        let values = self.face_values(id)?;
        // In single precision, as the values that are drawn.
        let greatest = values.iter().fold(0.0, |most: f32, value| most.max(value.abs() as f32));
        Some((values, unit.or_zero(f64::from(greatest), self.rest.diameter())))
    }

    /// Returns how far the values of the measure `id` are from 0, `#F`: of a signed one, on either side.
    /// Errors are judged by them: rounding errors are 0. As [`Session::face_values`].
    pub(in crate::session) fn face_errors(&mut self, id: &str) -> Option<Vec<f64>> {
        let (unit, size) = (FaceMeasure::of(id)?.unit, self.rest.diameter());
        let values = self.face_values(id)?.into_iter();
        Some(values.map(|value| unit.or_zero(value.abs(), size)).collect())
    }

    /// Returns the vertex values (`#V`) whose maximum over a face is its measure `id`. Only for
    /// distances to the original, which vary gradually; none for any other measure.
    pub fn corner_values(&self, id: &str) -> Option<Vec<f64>> {
        match id {
            "surface" => Some(self.surface_distances(&Shape::Now).to_vec()),
            "displacement" => Some(self.rest.displacements(self.scene.positions()).collect()),
            _ => None,
        }
    }
}

/// Returns the largest value among the corners of each face.
fn worst_corner(model: &Session, values: &[f64]) -> Vec<f64> {
    let worst = |face: &[u32]| face.iter().map(|&v| values[v as usize]).fold(0.0, f64::max);
    model.faces().iter().map(worst).collect()
}

/// Evaluates every quad; NaN for other faces.
fn of_quads(model: &Session, shape: &Shape, value: impl Fn([Vec3<f64>; 4]) -> f64) -> Vec<f64> {
    let positions = model.positions_of(shape);
    let of_face = |face: &[u32]| match face {
        &[a, b, c, d] => value([a, b, c, d].map(|v| Vec3::from(positions[v as usize]))),
        _ => f64::NAN,
    };
    model.faces().iter().map(of_face).collect()
}

fn diagonals(model: &mut Session, shape: &Shape) -> Vec<f64> {
    of_quads(model, shape, |quad| 100.0 * diagonal_ratio(quad.map(Point::from)))
}

fn diagonals_by_edge(model: &mut Session, shape: &Shape) -> Vec<f64> {
    of_quads(model, shape, |quad| {
        let [a, b, c, d] = quad;
        let mean_diagonal = 0.5 * ((c - a).length() + (d - b).length());
        let distance = diagonal_ratio(quad.map(Point::from)) * mean_diagonal;
        100.0 * ratio(distance, mean_length(quad))
    })
}

fn fourth_corners(model: &mut Session, shape: &Shape) -> Vec<f64> {
    of_quads(model, shape, |quad| {
        let off = |i: usize| {
            let [p, a, b, c] = [0, 1, 2, 3].map(|step| quad[(i + step) % 4]);
            let normal = (b - a).cross(c - a);
            ratio((p - a).dot(normal).abs(), normal.length())
        };
        (0..4).map(off).fold(0.0, f64::max)
    })
}

fn planarity_by_edge(model: &mut Session, shape: &Shape) -> Vec<f64> {
    let positions = model.positions_of(shape);
    let measures = model.measures_of(shape);
    let faces = model.faces().iter().zip(&measures.planarity_distances);
    let edge = |face: &[u32]| mean_length(face.iter().map(|&v| Vec3::from(positions[v as usize])));
    faces.map(|(face, distance)| 100.0 * ratio(*distance, edge(face))).collect()
}

/// Mean length of the sides of a polygon.
fn mean_length(corners: impl IntoIterator<Item = Vec3<f64>>) -> f64 {
    let corners: Vec<Vec3<f64>> = corners.into_iter().collect();
    let sum: f64 = polygon_sides(&corners).map(|[a, b]| (b - a).length()).sum();
    sum / corners.len() as f64
}

fn edge_changes(model: &mut Session, shape: &Shape) -> Vec<f64> {
    let (now, rest) = (model.positions_of(shape), model.rest.positions());
    // A side without length at rest has no relative change.
    let change = |ends| {
        let before = length(rest, ends);
        (before > 0.0).then(|| 100.0 * (length(&now, ends) - before).abs() / before)
    };
    let worst =
        |face: &[u32]| polygon_sides(face).filter_map(change).reduce(f64::max).unwrap_or(f64::NAN);
    model.faces().iter().map(worst).collect()
}

fn angles(model: &mut Session, shape: &Shape) -> Vec<f64> {
    let positions = model.positions_of(shape);
    let at = |v: u32| Vec3::from(positions[v as usize]);
    let worst = |face: &[u32]| {
        let regular = 180.0 - 360.0 / face.len() as f64;
        let corner = |corner: [u32; 3]| {
            let [before, here, after] = corner.map(at);
            let (a, b) = (before - here, after - here);
            let angle = angle_between(a, b)?;
            Some((angle * (180.0 / PI) - regular).abs())
        };
        polygon_corners(face).filter_map(corner).reduce(f64::max).unwrap_or(f64::NAN)
    };
    model.faces().iter().map(worst).collect()
}

fn off_curvature_lines(model: &mut Session, shape: &Shape) -> Vec<f64> {
    let (faces, topology) = (model.faces(), model.rest.topology());
    CurvatureLines::new(&model.positions_of(shape), faces, topology).of_faces(faces, topology)
}

/// Curvature of the smooth surface through the vertices.
fn curvature(model: &mut Session, shape: &Shape, quantity: fn(&Curvature) -> f64) -> Vec<f64> {
    let (faces, topology) = (model.faces(), model.rest.topology());
    face_curvatures(&model.positions_of(shape), faces, topology, quantity)
}

fn worst_surface_distances(model: &mut Session, shape: &Shape) -> Vec<f64> {
    worst_corner(model, &model.surface_distances(shape))
}

fn worst_displacements(model: &mut Session, shape: &Shape) -> Vec<f64> {
    let positions = model.positions_of(shape);
    let displacements: Vec<f64> = model.rest.displacements(&positions).collect();
    worst_corner(model, &displacements)
}

fn length(positions: &[Point], ends: [u32; 2]) -> f64 {
    let [a, b] = ends.map(|v| Vec3::from(positions[v as usize]));
    (b - a).length()
}

/// Returns a ratio; 0 over 0 counts as 0.
fn ratio(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}
