//! The mesh as it is drawn: positions relative to the view's own centre, triangles, edges and
//! normals; and data that belongs to it.
//!
//! Panels must look like panels, so shading uses mainly the normal of the polygon; the normal of
//! the vertex only bends it slightly across the panel.

pub mod checks;
pub mod error;
pub mod lists;
pub mod projected_faces;
pub mod projections;
pub mod triangulate;

pub use checks::Checks;
pub use error::ViewError;
pub use lists::{check_indices, check_length, rows};
pub use projected_faces::ProjectedFaces;
pub use projections::ProjectionMarks;

use crate::math::{Ragged, polygon_sides};
use glam::{DVec3, Vec3};
use triangulate::{fan, is_whole, newell_normal, triangulate};

/// The mesh as it is drawn.
#[derive(Clone, Debug, Default)]
pub struct RenderMesh {
    /// The centre of the first bounding box, in file coordinates. It stays when vertices move.
    pub centre: DVec3,
    /// The vertices of faces and curves, or all vertices if there are neither. A stray vertex far
    /// away would otherwise shrink the model to a dot and cost precision.
    pub used: Vec<u32>,
    /// #V, in file coordinates.
    pub exact: Vec<DVec3>,
    /// #V, relative to the centre.
    pub positions: Vec<Vec3>,
    /// The lowest and the highest corner of the bounding box of the used vertices, relative to the
    /// centre: asked for several times in every picture.
    pub bounds: [Vec3; 2],
    /// Corners of each face.
    pub faces: Ragged,
    /// Vertices of each polyline.
    pub curves: Ragged,
    /// Triangles of the faces, three vertices each.
    pub triangles: Vec<[u32; 3]>,
    /// The face of each triangle.
    pub triangle_face: Vec<u32>,
    /// Every side of every face, the smaller vertex first, with its face: those of an edge one after
    /// another, in the order of `edges`.
    pub sides: Vec<([u32; 2], u32)>,
    /// The edges of the polygons, each once.
    pub edges: Vec<PolygonEdge>,
    /// Normals per face and per vertex.
    pub normals: Normals,
}

impl RenderMesh {
    /// Creates the mesh; `coordinates` is #V by 3 in a flat array, in file coordinates.
    ///
    /// # Errors
    /// Arrays that do not fit together, or a coordinate that is not finite.
    pub fn new(
        faces: Ragged,
        curves: Ragged,
        coordinates: &[f64],
    ) -> Result<RenderMesh, ViewError> {
        let exact = read_points(coordinates)?;
        let used = used(&faces, &curves, exact.len());
        let [low, high] = bounds(&used, &exact);
        let sides = sides_by_edge(&faces);
        let edges = polygon_edges(&sides);
        let centre = low + (high - low) * 0.5;
        let known = RenderMesh { sides, edges, ..RenderMesh::default() };
        let mut mesh = RenderMesh { centre, used, faces, curves, ..known };
        mesh.place(exact);
        for (f, face) in mesh.faces.iter().enumerate() {
            triangulate(&mesh.positions, face, &mut mesh.triangles);
            mesh.triangle_face.resize(mesh.triangles.len(), f as u32);
        }
        Ok(mesh)
    }

    /// Returns the ends of every edge between two faces, and these faces; where more meet, each is
    /// paired with the one before.
    pub fn seams(&self) -> impl Iterator<Item = ([u32; 2], [u32; 2])> + '_ {
        let pairs = self.sides.windows(2).filter(|pair| pair[0].0 == pair[1].0);
        pairs.map(|pair| (pair[0].0, [pair[0].1, pair[1].1]))
    }

    /// Moves the vertices; `coordinates` as in [`RenderMesh::new`]. Returns whether faces have other
    /// triangles now.
    ///
    /// # Errors
    /// A wrong number of vertices, or a coordinate that is not finite. Nothing has moved then.
    pub fn set_positions(&mut self, coordinates: &[f64]) -> Result<bool, ViewError> {
        check_length("positions", coordinates.len(), self.exact.len() * 3)?;
        self.place(read_points(coordinates)?);
        Ok(self.renew_triangles())
    }

    /// Cuts the faces anew of which a triangle is turned over, since a corner has passed a diagonal, or
    /// which could be a fan again; returns whether there were any. So the triangles depend on the
    /// positions alone. A face keeps their number.
    fn renew_triangles(&mut self) -> bool {
        let mut renewed = false;
        let mut rest = &mut self.triangles[..];
        for (face, outside) in self.faces.iter().zip(&self.normals.faces) {
            let own;
            (own, rest) = rest.split_at_mut(face.len().saturating_sub(2));
            if face.len() < 4 {
                continue;
            }
            let is_fan = fan(face).eq(own.iter().copied());
            let stays = match is_fan {
                true => is_whole(&self.positions, own.iter().copied(), *outside),
                false => {
                    !is_whole(&self.positions, fan(face), *outside)
                        && is_whole(&self.positions, own.iter().copied(), *outside)
                }
            };
            if !stays {
                let mut cut = Vec::with_capacity(own.len());
                triangulate(&self.positions, face, &mut cut);
                renewed |= *own != *cut;
                own.copy_from_slice(&cut);
            }
        }
        renewed
    }

    fn place(&mut self, exact: Vec<DVec3>) {
        self.positions.clear();
        self.positions.extend(exact.iter().map(|&p| (p - self.centre).as_vec3()));
        self.exact = exact;
        let used = || self.used.iter().map(|&v| self.positions[v as usize]);
        self.bounds = [Vec3::min, Vec3::max].map(|end| used().reduce(end).unwrap_or_default());
        self.normals.update(&self.positions, &self.faces);
    }

    /// Returns whether the bounding box of other positions, #V by 3, is at most its diagonal away
    /// from the centre, relative to which they then keep their digits.
    pub fn is_near(&self, points: &[DVec3]) -> bool {
        let [low, high] = bounds(&self.used, points);
        (low + (high - low) * 0.5).distance(self.centre) <= low.distance(high)
    }

    /// Returns the positions of the used vertices, relative to the centre.
    pub fn used_positions(&self) -> impl Iterator<Item = Vec3> + Clone {
        self.used.iter().map(|&v| self.positions[v as usize])
    }

    /// Returns those of `points` (#V by 3, or none) that are of used vertices.
    pub fn used_of<'a>(&'a self, points: &'a [DVec3]) -> impl Iterator<Item = DVec3> + Clone + 'a {
        self.used.iter().filter_map(|&v| points.get(v as usize).copied())
    }

    /// Returns whether the mesh has only vertices, neither faces nor curves.
    pub fn is_only_points(&self) -> bool {
        self.faces.is_empty() && self.curves.is_empty()
    }

    /// Returns a point in file coordinates relative to the centre.
    pub fn relative(&self, point: DVec3) -> Vec3 {
        (point - self.centre).as_vec3()
    }
}

/// Returns the lowest and the highest corner of the bounding box of the vertices `used`.
fn bounds(used: &[u32], points: &[DVec3]) -> [DVec3; 2] {
    let corners = used.iter().map(|&v| points[v as usize]);
    [DVec3::min, DVec3::max].map(|end| corners.clone().reduce(end).unwrap_or_default())
}

/// Returns the vertices of faces and curves among `count`, ascending, or all if there are neither.
fn used(faces: &Ragged, curves: &Ragged, count: usize) -> Vec<u32> {
    let mut is_used = vec![faces.is_empty() && curves.is_empty(); count];
    for &vertex in faces.iter().chain(curves.iter()).flatten() {
        is_used[vertex as usize] = true;
    }
    (0..).zip(is_used).filter_map(|(vertex, used)| used.then_some(vertex)).collect()
}

/// Reads points from #P by 3 coordinates.
///
/// # Errors
/// A length that is not a multiple of three, or a coordinate that is not finite.
pub fn read_points(coordinates: &[f64]) -> Result<Vec<DVec3>, ViewError> {
    check_length("positions", coordinates.len(), coordinates.len().next_multiple_of(3))?;
    let (points, _) = coordinates.as_chunks::<3>();
    if let Some(vertex) = points.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
        return Err(ViewError::NotFinite { vertex });
    }
    Ok(points.iter().map(|&p| DVec3::from(p)).collect())
}

/// A side of one or more faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PolygonEdge {
    /// The two vertices, the smaller index first.
    pub ends: [u32; 2],
    /// Whether only one face has this side.
    pub boundary: bool,
}

/// Returns every edge once, sorted by vertices, of the sides of faces.
fn polygon_edges(sides: &[([u32; 2], u32)]) -> Vec<PolygonEdge> {
    sides
        .chunk_by(|a, b| a.0 == b.0)
        .map(|same| PolygonEdge { ends: same[0].0, boundary: same.len() == 1 })
        .collect()
}

/// Returns every side of every face, the smaller vertex first, with its face, sorted; without sides of
/// zero length.
fn sides_by_edge(faces: &Ragged) -> Vec<([u32; 2], u32)> {
    let mut sides = Vec::new();
    for (index, face) in (0..).zip(faces.iter()) {
        let own = undirected_sides(face).filter(|[a, b]| a != b);
        sides.extend(own.map(|ends| (ends, index)));
    }
    sides.sort_unstable();
    sides
}

/// Returns the sides of a face, each with the smaller vertex first.
pub fn undirected_sides(corners: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    polygon_sides(corners).map(|[a, b]| [a.min(b), a.max(b)])
}

/// Unit normals: `faces` is #F, `vertices` is #V. Zero without area, or where normals cancel.
#[derive(Clone, Debug, Default)]
pub struct Normals {
    /// One per polygon.
    pub faces: Vec<Vec3>,
    /// One per vertex, the area-weighted mean of its polygons.
    pub vertices: Vec<Vec3>,
}

impl Normals {
    /// Computes both for the given positions.
    pub fn update(&mut self, positions: &[Vec3], faces: &Ragged) {
        self.faces.clear();
        self.vertices.clear();
        self.vertices.resize(positions.len(), Vec3::ZERO);
        for face in faces.iter() {
            let normal = newell_normal(positions, face);
            for &corner in face {
                self.vertices[corner as usize] += normal;
            }
            self.faces.push(normal.normalize_or_zero());
        }
        for normal in &mut self.vertices {
            *normal = normal.normalize_or_zero();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(at: DVec3) -> RenderMesh {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.25]];
        let coordinates: Vec<f64> =
            corners.iter().flat_map(|&c| (DVec3::from(c) + at).to_array()).collect();
        let faces = rows("faces", vec![0, 4], vec![0, 1, 2, 3], 4).unwrap();
        RenderMesh::new(faces, Ragged::new(), &coordinates).unwrap()
    }

    #[test]
    fn site_coordinates_lose_no_digits() {
        let (here, there) =
            (square(DVec3::ZERO), square(DVec3::new(2_679_500.0, 1_247_250.0, 408.0)));
        assert_eq!(here.positions, there.positions);
        assert_eq!(here.triangles.len(), 2);
        assert_eq!(here.edges.len(), 4);
    }

    #[test]
    fn a_stray_vertex_costs_no_digits() {
        let at = DVec3::new(2_679_500.0, 1_247_250.0, 408.0);
        let there = square(at);
        let mut coordinates: Vec<f64> = there.exact.iter().flat_map(|p| p.to_array()).collect();
        coordinates.extend([0.0; 3]);
        let stray = RenderMesh::new(there.faces.clone(), Ragged::new(), &coordinates).unwrap();
        assert_eq!(stray.centre, there.centre);
        assert_eq!(stray.positions[..4], there.positions);
        assert!(stray.used_positions().eq(there.used_positions()));
    }

    #[test]
    fn a_corner_that_passes_a_diagonal_has_other_triangles_and_back() {
        // The notch was drawn and picked as if it were filled, until the file was opened again.
        let mut mesh = square(DVec3::ZERO);
        let given = mesh.triangles.clone();
        let first: Vec<f64> = mesh.exact.iter().flat_map(|p| p.to_array()).collect();
        let mut notched = first.clone();
        notched[3..6].copy_from_slice(&[0.4, 0.6, 0.0]);
        assert_eq!(mesh.set_positions(&notched), Ok(true));
        let again = RenderMesh::new(mesh.faces.clone(), Ragged::new(), &notched).unwrap();
        assert_eq!(mesh.triangles, again.triangles);
        assert_ne!(mesh.triangles, given);
        assert_eq!(mesh.set_positions(&notched), Ok(false));
        assert_eq!(mesh.set_positions(&first), Ok(true));
        assert_eq!(mesh.triangles, given);
    }

    #[test]
    fn bad_positions_change_nothing() {
        let mut mesh = square(DVec3::ZERO);
        let before = mesh.positions.clone();
        let mut wrong = [0.0; 12];
        wrong[7] = f64::NAN;
        assert_eq!(mesh.set_positions(&wrong), Err(ViewError::NotFinite { vertex: 2 }));
        assert!(mesh.set_positions(&wrong[..9]).is_err());
        assert_eq!(mesh.positions, before);
    }

    #[test]
    fn shared_sides_come_once_and_the_rim_is_marked() {
        let faces = rows("faces", vec![0, 4, 7], vec![0, 1, 4, 3, 1, 2, 4], 5).unwrap();
        let mesh = RenderMesh::new(faces, Ragged::new(), &[0.0; 15]).unwrap();
        let edges = &mesh.edges;
        assert_eq!(edges.len(), 6);
        let inner: Vec<_> = edges.iter().filter(|e| !e.boundary).collect();
        assert_eq!(inner.len(), 1);
        assert_eq!(inner[0].ends, [1, 4]);
        assert_eq!(mesh.seams().collect::<Vec<_>>(), [([1, 4], [0, 1])]);
    }

    #[test]
    fn a_folded_pair_has_two_face_normals_and_their_mean_on_the_fold() {
        let positions =
            [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
        let faces = rows("faces", vec![0, 3, 6], vec![0, 2, 1, 0, 1, 3], 4).unwrap();
        let mut normals = Normals::default();
        normals.update(&positions, &faces);
        assert_eq!(normals.faces, [Vec3::Z, Vec3::X]);
        assert!((normals.vertices[0] - Vec3::new(1.0, 0.0, 1.0).normalize()).length() < 1e-6);
        assert_eq!(normals.vertices[3], Vec3::X);
    }
}
