//! The numbers per face that hosts colour and list: how far a face is from a shape, from where its
//! constraints want it, and from what it was.
//!
//! Which measures there are is declared here, so that hosts name none of them.

use crate::math::{Vec3, angle, polygon_corners, polygon_sides};
use crate::mesh::{Measures, Point, diagonal_ratio};
use crate::session::state::Session;
use serde::Serialize;
use std::f64::consts::PI;
use std::rc::Rc;

/// The unit of a measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum MeasureUnit {
    /// The unit of the mesh.
    Length,
    /// Per cent.
    Percent,
    /// Degrees.
    Degrees,
    /// A number without a unit.
    Number,
}

/// A measure of faces: never negative, and 0 is best.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct FaceMeasure {
    /// Its name in messages.
    pub id: &'static str,
    /// Its name for people.
    pub label: &'static str,
    /// The measured quantity.
    pub words: &'static str,
    /// The statement that holds where the values of all faces are 0.
    pub met: &'static str,
    /// Its unit.
    pub unit: MeasureUnit,
    /// Whether it is an error that the tolerance of the model applies to: a length that whoever builds
    /// it has to allow for.
    pub toleranced: bool,
    #[serde(skip)]
    values: fn(&mut Session, Shape) -> Vec<f64>,
}

/// All measures, in the order in which they are offered.
pub const FACE_MEASURES: &[FaceMeasure] = &[
    FaceMeasure {
        id: "planarity",
        label: "Planarity",
        words: "largest distance of a face’s corners to its best plane",
        met: "each panel is flat",
        unit: MeasureUnit::Length,
        toleranced: true,
        values: |session, shape| session.measures_of(shape).planarity_distances.clone(),
    },
    FaceMeasure {
        id: "diagonals",
        label: "Planarity: diagonals",
        words: "distance between the diagonals of a quad, of their mean length",
        met: "each panel is flat",
        unit: MeasureUnit::Percent,
        toleranced: false,
        values: diagonals,
    },
    FaceMeasure {
        id: "diagonals-by-edge",
        label: "Planarity: diagonals by edge",
        words: "distance between the diagonals of a quad, of its mean edge",
        met: "each panel is flat",
        unit: MeasureUnit::Percent,
        toleranced: false,
        values: diagonals_by_edge,
    },
    FaceMeasure {
        id: "planarity-by-edge",
        label: "Planarity: by edge",
        words: "largest distance of a face’s corners to its best plane, of its mean edge",
        met: "each panel is flat",
        unit: MeasureUnit::Percent,
        toleranced: false,
        values: planarity_by_edge,
    },
    FaceMeasure {
        id: "fourth-corner",
        label: "Planarity: fourth corner",
        words: "largest distance of a quad’s corner to the plane of the other three",
        met: "each panel is flat",
        unit: MeasureUnit::Length,
        toleranced: true,
        values: fourth_corners,
    },
    FaceMeasure {
        id: "e-p",
        label: "Planarity: e_p of the paper",
        words: "mean squared distance of a face’s corners to its best plane, in a model of size 1",
        met: "each panel is flat",
        unit: MeasureUnit::Number,
        toleranced: false,
        values: |session, shape| session.measures_of(shape).e_p.clone(),
    },
    FaceMeasure {
        id: "circularity",
        label: "Circularity",
        words: "largest distance of a face’s corners to its best circle",
        met: "the corners of each panel lie on a circle",
        unit: MeasureUnit::Length,
        toleranced: true,
        values: |session, shape| session.measures_of(shape).circularity_distances.clone(),
    },
    FaceMeasure {
        id: "e-c",
        label: "Circularity: e_c of the paper",
        words: "mean squared distance of a face’s corners to its best circle, in a model of size 1",
        met: "the corners of each panel lie on a circle",
        unit: MeasureUnit::Number,
        toleranced: false,
        values: |session, shape| session.measures_of(shape).e_c.clone(),
    },
    FaceMeasure {
        id: "residual",
        label: "Constraints",
        words: "largest distance of a face’s corners to where their constraints want them",
        met: "each panel is as its constraints want it",
        unit: MeasureUnit::Length,
        toleranced: true,
        values: Session::residuals_of,
    },
    FaceMeasure {
        id: "edges",
        label: "Edge length change",
        words: "largest change of a face’s edges against the model that was opened",
        met: "each edge is as long as it was",
        unit: MeasureUnit::Percent,
        toleranced: false,
        values: edge_changes,
    },
    FaceMeasure {
        id: "angles",
        label: "Angle quality",
        words: "largest difference of a face’s angles from those of the regular polygon",
        met: "the angles of each panel are equal",
        unit: MeasureUnit::Degrees,
        toleranced: false,
        values: angles,
    },
    FaceMeasure {
        id: "surface",
        label: "Distance to original",
        words: "largest distance of a face’s corners to the surface of the model that was opened",
        met: "each panel lies on the original",
        unit: MeasureUnit::Length,
        toleranced: false,
        values: surface_distances,
    },
    FaceMeasure {
        id: "displacement",
        label: "Moved",
        words: "how far a face’s corners have moved from where they were in the model, at most",
        met: "each panel is where it was",
        unit: MeasureUnit::Length,
        toleranced: false,
        values: displacements,
    },
];

/// Which shape is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// The current positions.
    Now,
    /// The rest shape: the model as it was opened.
    Original,
}

impl Session {
    fn measures_of(&self, shape: Shape) -> Rc<Measures> {
        match shape {
            Shape::Now => self.measures(),
            Shape::Original => {
                Rc::new(Measures::new(&self.mesh.positions, &self.mesh.faces, self.diameter))
            }
        }
    }

    /// Positions, `#V by 3`.
    pub(crate) fn positions_of(&self, shape: Shape) -> Vec<Point> {
        match shape {
            Shape::Now => self.positions(),
            Shape::Original => self.mesh.positions.clone(),
        }
    }

    /// The values of the measure `id`, `#F`, in its unit; not a number where a face has none, as the
    /// diagonals of a triangle. `None` when no measure is called so.
    pub fn face_values(&mut self, id: &str) -> Option<Vec<f64>> {
        self.face_values_of(id, Shape::Now)
    }

    /// The same of another shape.
    pub fn face_values_of(&mut self, id: &str, shape: Shape) -> Option<Vec<f64>> {
        let measure = FACE_MEASURES.iter().find(|measure| measure.id == id)?;
        Some((measure.values)(self, shape))
    }

    /// The values of the vertices (`#V`) whose largest a face has in the measure `id`, where they change
    /// gradually over the surface: distances to what the model was. `None` for every other measure.
    pub fn corner_values(&self, id: &str) -> Option<Vec<f64>> {
        match id {
            "surface" => Some(self.surface_distances(Shape::Now).to_vec()),
            "displacement" => Some(self.displacements()),
            _ => None,
        }
    }

    /// Per face the largest of what its vertices have.
    fn worst_corner(&self, value: impl Fn(usize) -> f64) -> Vec<f64> {
        let worst = |face: &[u32]| face.iter().map(|&v| value(v as usize)).fold(0.0, f64::max);
        self.mesh.faces.iter().map(worst).collect()
    }
}

/// A value of every quad; other faces have none.
fn of_quads(session: &Session, shape: Shape, value: impl Fn([Vec3<f64>; 4]) -> f64) -> Vec<f64> {
    let positions = session.positions_of(shape);
    let of_face = |face: &[u32]| match face {
        &[a, b, c, d] => value([a, b, c, d].map(|v| Vec3::from(positions[v as usize]))),
        _ => f64::NAN,
    };
    session.mesh.faces.iter().map(of_face).collect()
}

fn diagonals(session: &mut Session, shape: Shape) -> Vec<f64> {
    of_quads(session, shape, |quad| 100.0 * diagonal_ratio(quad.map(Point::from)))
}

fn diagonals_by_edge(session: &mut Session, shape: Shape) -> Vec<f64> {
    of_quads(session, shape, |quad| {
        let [a, b, c, d] = quad;
        let mean_diagonal = 0.5 * ((c - a).length() + (d - b).length());
        let distance = diagonal_ratio(quad.map(Point::from)) * mean_diagonal;
        100.0 * ratio(distance, mean_length(quad))
    })
}

fn fourth_corners(session: &mut Session, shape: Shape) -> Vec<f64> {
    of_quads(session, shape, |quad| {
        let off = |i: usize| {
            let [p, a, b, c] = [0, 1, 2, 3].map(|step| quad[(i + step) % 4]);
            let normal = (b - a).cross(c - a);
            ratio((p - a).dot(normal).abs(), normal.length())
        };
        (0..4).map(off).fold(0.0, f64::max)
    })
}

fn planarity_by_edge(session: &mut Session, shape: Shape) -> Vec<f64> {
    let positions = session.positions_of(shape);
    let measures = session.measures_of(shape);
    let faces = session.mesh.faces.iter().zip(&measures.planarity_distances);
    let edge = |face: &[u32]| mean_length(face.iter().map(|&v| Vec3::from(positions[v as usize])));
    faces.map(|(face, distance)| 100.0 * ratio(*distance, edge(face))).collect()
}

/// Of the sides of a polygon.
fn mean_length(corners: impl IntoIterator<Item = Vec3<f64>>) -> f64 {
    let corners: Vec<Vec3<f64>> = corners.into_iter().collect();
    let sum: f64 = polygon_sides(&corners).map(|[a, b]| (b - a).length()).sum();
    sum / corners.len() as f64
}

fn edge_changes(session: &mut Session, shape: Shape) -> Vec<f64> {
    let (now, rest) = (session.positions_of(shape), &session.mesh.positions);
    let change = |ends| {
        let before = length(rest, ends);
        100.0 * ratio((length(&now, ends) - before).abs(), before)
    };
    let worst = |face: &[u32]| polygon_sides(face).map(change).fold(0.0, f64::max);
    session.mesh.faces.iter().map(worst).collect()
}

fn angles(session: &mut Session, shape: Shape) -> Vec<f64> {
    let positions = session.positions_of(shape);
    let at = |v: u32| Vec3::from(positions[v as usize]);
    let worst = |face: &[u32]| {
        let regular = 180.0 - 360.0 / face.len() as f64;
        let corner = |corner: [u32; 3]| {
            let [before, here, after] = corner.map(at);
            let (a, b) = (before - here, after - here);
            let angle = angle(a.dot(b), a.cross(b).length()) * (180.0 / PI);
            (angle - regular).abs()
        };
        polygon_corners(face).map(corner).fold(0.0, f64::max)
    };
    session.mesh.faces.iter().map(worst).collect()
}

fn surface_distances(session: &mut Session, shape: Shape) -> Vec<f64> {
    let distances = session.surface_distances(shape);
    session.worst_corner(|v| distances[v])
}

fn displacements(session: &mut Session, shape: Shape) -> Vec<f64> {
    match shape {
        Shape::Now => {
            let ways = session.displacements();
            session.worst_corner(|v| ways[v])
        }
        Shape::Original => vec![0.0; session.mesh.faces.len()],
    }
}

fn length(positions: &[Point], ends: [u32; 2]) -> f64 {
    let [a, b] = ends.map(|v| Vec3::from(positions[v as usize]));
    (b - a).length()
}

/// 0 over 0 is no change.
fn ratio(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::scene::{MeshSource, Scene};

    /// A unit square, two of whose opposite corners are lifted by 0.02, opened from a flat one.
    fn lifted() -> Session {
        let square =
            |lift| vec![[0.0, 0.0, lift], [1.0, 0.0, 0.0], [1.0, 1.0, lift], [0.0, 1.0, 0.0]];
        let mesh = Mesh {
            positions: square(0.0),
            faces: [[0, 1, 2, 3]].into_iter().collect(),
            ..Mesh::default()
        };
        let mut scene = Scene::new(MeshSource::File(String::new()));
        scene.current = Some(square(0.02));
        Session::open(scene, mesh).expect("it opens")
    }

    #[test]
    fn conventions_of_the_same_panel_differ_as_they_are_known_to() {
        let mut session = lifted();
        let mut value = |id| session.face_values(id).expect("there is one")[0];
        let near = |value: f64, expected: f64| assert!((value - expected).abs() < 2e-3 * expected);
        near(value("planarity"), 0.01);
        near(value("diagonals"), 1.414);
        near(value("diagonals-by-edge"), 2.0);
        near(value("planarity-by-edge"), 1.0);
        near(value("fourth-corner"), 0.04);
        near(value("e-p"), 0.5e-4);
        near(value("displacement"), 0.02);
        near(value("surface"), 0.02);
        near(value("edges"), 0.02);
        assert!(value("angles") < 0.05);
    }

    #[test]
    fn values_of_corners_are_what_their_faces_have_the_largest_of() {
        let mut session = lifted();
        for measure in FACE_MEASURES {
            let Some(corners) = session.corner_values(measure.id) else { continue };
            let faces = session.face_values(measure.id).expect("it is declared");
            assert_eq!(corners.len(), 4);
            assert_eq!(corners.into_iter().fold(0.0, f64::max), faces[0]);
        }
        assert!(session.corner_values("displacement").is_some());
        assert!(session.corner_values("planarity").is_none());
    }

    #[test]
    fn every_measure_is_nothing_for_a_square_at_rest() {
        let mut session = lifted();
        let rest = session.mesh().positions.clone();
        let mut scene = session.scene();
        scene.current = Some(rest);
        session = Session::open(scene, session.mesh().clone()).expect("it opens");
        for measure in FACE_MEASURES {
            let value = session.face_values(measure.id).expect("it is declared")[0];
            assert!(value.abs() < 1e-12, "{}: {value}", measure.id);
        }
        assert!(session.face_values("beauty").is_none());
    }
}
