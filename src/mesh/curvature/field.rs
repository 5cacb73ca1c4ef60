//! Field of principal directions on a surface: second fundamental forms at the corners of
//! triangles, interpolated linearly.

use super::{Curvature, SecondForm, Tensor, curvatures};
use crate::math::{Vec3, mean, polygon_sides};
use crate::mesh::{BoundingSphere, Mesh, Point, Topology, at_vertices, components, orientation};

/// One of the two orthogonal families of lines of curvature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Along the larger principal curvature.
    Larger = 0,
    /// Along the smaller one.
    Smaller = 1,
}

/// A point on the surface, with its triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    pub(super) triangle: u32,
    /// In the plane of the triangle.
    pub(super) at: Vec3<f64>,
}

/// A triangulated surface with second fundamental forms at the corners. Faces of more than three
/// corners are split around their centre. Each component is oriented consistently if possible, with
/// positive mean curvature on the whole: the curvatures of a dome are positive.
#[derive(Clone, Debug)]
pub struct CurvatureField {
    points: Vec<Vec3<f64>>,
    /// Second fundamental form and normal of each point, `#points`; `None` if unknown.
    forms: Vec<Option<(Tensor, Vec3<f64>)>>,
    triangles: Vec<[u32; 3]>,
    /// The face that each triangle belongs to.
    faces: Vec<u32>,
    normals: Vec<Vec3<f64>>,
    /// The triangle across each side of each triangle, and the index of the side in that one; side 0 is from
    /// corner 0 to corner 1. None at the boundary, where more than two triangles meet, and where orientations
    /// disagree.
    across: Vec<[Option<(u32, usize)>; 3]>,
    mean_edge: f64,
    diameter: f64,
}

impl CurvatureField {
    /// Builds the field of the faces of `mesh` at `positions`, `#V by 3`.
    pub fn new(positions: &[Point], mesh: &Mesh, topology: &Topology) -> CurvatureField {
        let mut points: Vec<Vec3<f64>> = positions.iter().map(|&p| Vec3::from(p)).collect();
        let known = curvatures(positions, &mesh.faces, topology);
        let mut forms: Vec<_> =
            known.iter().map(|one| one.map(|one| (one.tensor(), one.normal))).collect();
        let (mut triangles, mut faces) = (Vec::new(), Vec::new());
        for (f, face) in (0..).zip(mesh.faces.iter()) {
            if let &[a, b, c] = face {
                triangles.push([a, b, c]);
                faces.push(f);
                continue;
            }
            let centre = points.len() as u32;
            points.push(mean(face.iter().map(|&v| points[v as usize])));
            forms.push(mean_form(face.iter().map(|&v| forms[v as usize])));
            for (k, &a) in face.iter().enumerate() {
                triangles.push([a, face[(k + 1) % face.len()], centre]);
                faces.push(f);
            }
        }
        let mean_edge = topology.mean_edge(positions);
        let corners = at_vertices(positions, &[mesh.faces.indices()]);
        let diameter = BoundingSphere::of(&corners).diameter();
        let mut field = CurvatureField {
            points,
            forms,
            normals: Vec::new(),
            across: vec![[None; 3]; triangles.len()],
            triangles,
            faces,
            mean_edge,
            diameter,
        };
        field.orient();
        field
    }

    /// Mean edge length of the mesh.
    pub fn mean_edge(&self) -> f64 {
        self.mean_edge
    }

    /// Diameter of the smallest ball around the surface; vertices without a face do not count.
    pub fn diameter(&self) -> f64 {
        self.diameter
    }

    /// Returns the centres of the faces in order, without faces of zero area.
    pub(super) fn centres(&self) -> impl Iterator<Item = SurfacePoint> + '_ {
        let of_face = self.faces.chunk_by(|a, b| a == b).scan(0, |next, same| {
            let first = *next;
            *next += same.len();
            Some(self.centre(first, same.len()))
        });
        of_face.flatten()
    }

    /// Returns the centre of the face of `pieces` triangles from `first` on. Of several, the last
    /// corner is the centre.
    fn centre(&self, first: usize, pieces: usize) -> Option<SurfacePoint> {
        let triangle = first as u32;
        let [a, b, c] = self.corners(triangle);
        let at = if pieces > 1 { c } else { (a + b + c) * (1.0 / 3.0) };
        let point = SurfacePoint { triangle, at };
        (self.normal(point) != Vec3::zero()).then_some(point)
    }

    /// Returns the unit normal of the triangle of a point; zero if it has no area.
    pub(super) fn normal(&self, point: SurfacePoint) -> Vec3<f64> {
        self.normals[point.triangle as usize]
    }

    pub(super) fn corners(&self, triangle: u32) -> [Vec3<f64>; 3] {
        self.triangles[triangle as usize].map(|v| self.points[v as usize])
    }

    /// Returns the triangle across a side and the index of the side in that triangle; `None` at the
    /// boundary.
    pub(super) fn across(&self, triangle: u32, side: usize) -> Option<(u32, usize)> {
        self.across[triangle as usize][side]
    }

    /// Returns the barycentric coordinates of a point in its triangle.
    fn weights(&self, SurfacePoint { triangle, at }: SurfacePoint) -> [f64; 3] {
        let corners = self.corners(triangle);
        let normal = self.normals[triangle as usize];
        let part = |k: usize| {
            let [a, b] = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
            (b - a).cross(at - a).dot(normal)
        };
        let parts = [part(0), part(1), part(2)];
        let sum = parts[0] + parts[1] + parts[2];
        parts.map(|part| part / sum)
    }

    /// Returns the unit direction of a family at a point. `None` if the curvature is unknown, if
    /// the surface is flat over the length of an edge, or if the difference of the principal
    /// curvatures is at most the fraction `umbilic` of the sum of their absolute values.
    pub(super) fn direction(
        &self,
        point: SurfacePoint,
        family: Family,
        umbilic: f64,
    ) -> Option<Vec3<f64>> {
        let normal = self.normal(point);
        if normal == Vec3::zero() {
            return None;
        }
        let (mut tensor, mut up) = ([0.0; 6], Vec3::zero());
        let corners = self.triangles[point.triangle as usize];
        for (v, weight) in corners.into_iter().zip(self.weights(point)) {
            let (form, normal_there) = self.forms[v as usize]?;
            let weight = if normal_there.dot(normal) < 0.0 { -weight } else { weight };
            tensor.iter_mut().zip(form).for_each(|(sum, part)| *sum += weight * part);
            up += normal_there * weight;
        }
        // Use the tangent plane of the smooth surface, which differs from that of the triangle.
        let (_, up) = up.length_and_direction();
        let up = up?;
        let x = up.across();
        let y = up.cross(x);
        let values = [form_on(&tensor, x, x), form_on(&tensor, x, y), form_on(&tensor, y, y)];
        let curvature = Curvature::of(SecondForm { axes: [x, y], values });
        if !curvature.has_directions(umbilic, self.mean_edge) {
            return None;
        }
        let direction = curvature.directions[family as usize];
        let (_, direction) = (direction - normal * normal.dot(direction)).length_and_direction();
        direction
    }

    /// Orients each component, see [`CurvatureField`], connects its triangles, and computes the normals.
    fn orient(&mut self) {
        let positions = self.points.iter().map(|&p| p.into()).collect();
        let faces = self.triangles.iter().collect();
        let mesh = Mesh { positions, faces, ..Mesh::default() };
        let topology = Topology::new(&mesh);
        let (turned, _) = orientation(&mesh.faces, &topology);
        let part_of = components(
            self.triangles.len(),
            topology.edge_faces().iter().filter(|faces| faces.len() == 2),
        );
        let mut bends = vec![0.0; self.triangles.len()];
        for (t, &part) in part_of.iter().enumerate() {
            bends[part as usize] += if turned[t] { -self.bend(t) } else { self.bend(t) };
        }
        for (t, part) in part_of.into_iter().enumerate() {
            if turned[t] != (bends[part as usize] < 0.0) {
                self.triangles[t].swap(0, 1);
            }
        }
        for (&[a, b], faces) in topology.edges().iter().zip(topology.edge_faces().iter()) {
            let &[t, u] = faces else { continue };
            let side = |t: u32, ends: [u32; 2]| {
                polygon_sides(&self.triangles[t as usize]).position(|side| side == ends)
            };
            let opposite = |[a, b]: [u32; 2]| side(t, [a, b]).zip(side(u, [b, a]));
            if let Some((k, l)) = opposite([a, b]).or_else(|| opposite([b, a])) {
                self.across[t as usize][k] = Some((u, l));
                self.across[u as usize][l] = Some((t, k));
            }
        }
        let normal = |[a, b, c]: [Vec3<f64>; 3]| (b - a).cross(c - a).direction_or_zero();
        let all = 0..self.triangles.len() as u32;
        self.normals = all.map(|t| normal(self.corners(t))).collect();
    }

    /// Returns a positive multiple of mean curvature times area, signed by the triangle's normal.
    fn bend(&self, triangle: usize) -> f64 {
        let [a, b, c] = self.corners(triangle as u32);
        let area = (b - a).cross(c - a);
        let of_corner = |v: u32| {
            self.forms[v as usize].map_or(0.0, |([xx, yy, zz, ..], up)| {
                if up.dot(area) < 0.0 { -(xx + yy + zz) } else { xx + yy + zz }
            })
        };
        let sum: f64 = self.triangles[triangle].into_iter().map(of_corner).sum();
        sum * area.length()
    }
}

/// Returns the mean of forms, with signs matched to the first normal; `None` if one is unknown.
fn mean_form(
    forms: impl ExactSizeIterator<Item = Option<(Tensor, Vec3<f64>)>>,
) -> Option<(Tensor, Vec3<f64>)> {
    let share = 1.0 / forms.len() as f64;
    let mut mean: Option<(Tensor, Vec3<f64>)> = None;
    for form in forms {
        let (form, up) = form?;
        let (tensor, normal) = mean.get_or_insert(([0.0; 6], Vec3::zero()));
        let sign = if up.dot(*normal) < 0.0 { -1.0 } else { 1.0 };
        tensor.iter_mut().zip(form).for_each(|(sum, part)| *sum += sign * share * part);
        *normal += up * (sign * share);
    }
    mean
}

/// The value of a symmetric form, such as the second fundamental form, on two vectors; its entries are
/// `xx, yy, zz, xy, xz, yz`.
pub(crate) fn form_on([xx, yy, zz, xy, xz, yz]: &Tensor, a: Vec3<f64>, b: Vec3<f64>) -> f64 {
    xx * a.x * b.x
        + yy * a.y * b.y
        + zz * a.z * b.z
        + xy * (a.x * b.y + a.y * b.x)
        + xz * (a.x * b.z + a.z * b.x)
        + yz * (a.y * b.z + a.z * b.y)
}
