//! The rest mesh: as opened, or derived from the opened one.

use crate::math::{Vec3, key_of_pair, marked, sort_by_number};
use crate::mesh::{
    BoundaryCurve, BoundaryCurves, Group, Mesh, Point, Surface, Topology, folded_faces,
    mean_dihedral_angle, seams, smoothed_area,
};
use crate::solve::Moved;
use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

/// Below every cosine: no vertex of a boundary is a corner.
const NO_CORNERS: f64 = -2.0;

/// A mesh whose vertices are nearer to a surface than this fraction of its mean edge lies on it.
const ON_SURFACE: f64 = 0.02;

/// A rest mesh with its topology.
pub(crate) struct RestMesh {
    mesh: Mesh,
    topology: Topology,
    diameter: f64,
    /// See [`RestMesh::bend`].
    bend: OnceCell<f64>,
    /// See [`RestMesh::surface`], [`RestMesh::boundary`] and [`RestMesh::smoothed_area`].
    surface: OnceCell<Surface>,
    boundary: OnceCell<Vec<BoundaryCurve>>,
    smoothed_area: OnceCell<f64>,
    /// See [`RestMesh::original`].
    original: RefCell<Option<KnownTarget>>,
    /// See [`seams`].
    seams: OnceCell<Vec<[u32; 2]>>,
    generation: u32,
    lost: Vec<String>,
}

/// A mesh that closeness is to, and its surface if the rest mesh is made of panels on it.
type KnownTarget = (Rc<Mesh>, Option<Rc<Surface>>);

impl RestMesh {
    pub(crate) fn new(mesh: Mesh) -> RestMesh {
        let topology = Topology::new(&mesh);
        let diameter = mesh.size();
        RestMesh {
            mesh,
            topology,
            diameter,
            bend: OnceCell::new(),
            surface: OnceCell::new(),
            boundary: OnceCell::new(),
            smoothed_area: OnceCell::new(),
            original: RefCell::default(),
            seams: OnceCell::new(),
            generation: 0,
            lost: Vec::new(),
        }
    }

    /// Creates a mesh that is derived from this one.
    pub(crate) fn next(&self, mesh: Mesh) -> RestMesh {
        RestMesh::numbered(mesh, self.generation.wrapping_add(1))
    }

    /// Creates the mesh of this [`RestMesh::generation`].
    pub(crate) fn numbered(mesh: Mesh, generation: u32) -> RestMesh {
        RestMesh { generation, ..RestMesh::new(mesh) }
    }

    /// Approximate memory in bytes.
    pub(crate) fn bytes(&self) -> usize {
        let corners = self.mesh.faces.indices().len() + self.mesh.curves.indices().len();
        // For each corner: its vertex, and twice an edge with its ends, faces and neighbours.
        size_of_val(&*self.mesh.positions) + 64 * corners
    }

    /// Number of meshes derived one after another from the opened one; 0 for the opened mesh. Those
    /// from which a reopened scene was derived count down from there, as `u32` wraps.
    pub(crate) fn generation(&self) -> u32 {
        self.generation
    }

    /// A sentence for each item that was not carried over to it.
    pub(crate) fn lost(&self) -> &[String] {
        &self.lost
    }

    pub(crate) fn set_lost(&mut self, lost: Vec<String>) {
        self.lost = lost;
    }

    pub(crate) fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    pub(crate) fn topology(&self) -> &Topology {
        &self.topology
    }

    /// Rest positions, `#V by 3`.
    pub(crate) fn positions(&self) -> &[Point] {
        &self.mesh.positions
    }

    /// Returns the faces that are folded or dented at `now` (`#V by 3`); see [`folded_faces`].
    pub(crate) fn folded_by(&self, now: &[Point]) -> Vec<u32> {
        folded_faces(&self.mesh, &self.topology, now)
    }

    /// Returns the mean angle in degrees between neighbouring faces at `now` (`#V by 3`).
    pub(crate) fn bend_at(&self, now: &[Point]) -> f64 {
        mean_dihedral_angle(&self.mesh, &self.topology, now)
    }

    /// Returns the mean angle in degrees between neighbouring faces at rest.
    pub(crate) fn bend(&self) -> f64 {
        *self.bend.get_or_init(|| self.bend_at(self.positions()))
    }

    /// Returns the original surface.
    pub(crate) fn surface(&self) -> &Surface {
        self.surface.get_or_init(|| Surface::new(self.positions(), &self.mesh))
    }

    /// Returns the surface of `target` if the rest mesh is made of panels on it: all vertices of its
    /// edges lie there, but those of curves beside its faces. Such a mesh is judged by that surface, not
    /// by its own.
    pub(crate) fn original(&self, target: Option<&Rc<Mesh>>) -> Option<Rc<Surface>> {
        let target = target?;
        let mut known = self.original.borrow_mut();
        if known.as_ref().is_none_or(|(mesh, _)| !Rc::ptr_eq(mesh, target)) {
            let surface = Surface::of_polygons(&target.positions, target);
            let limit = ON_SURFACE * self.mean_edge();
            let mut hint = Surface::NO_HINT;
            let mut is_on = |v: u32| {
                let point = self.positions()[v as usize];
                let to = surface.closest(point, &mut hint);
                (Vec3::from(to) - Vec3::from(point)).length() <= limit
            };
            let lies = self.topology.body_edges().flatten().all(&mut is_on);
            *known = Some((Rc::clone(target), lies.then(|| Rc::new(surface))));
        }
        known.as_ref().and_then(|(_, surface)| surface.clone())
    }

    /// Returns the largest distance at `now` (`#V by 3`) between boundary vertices that lie on each
    /// other at rest without being joined.
    pub(crate) fn seam_at(&self, now: &[Point]) -> f64 {
        let at = |v: u32| Vec3::from(now[v as usize]);
        let pairs = self.seams.get_or_init(|| seams(&self.mesh)).iter();
        pairs.map(|&[a, b]| (at(a) - at(b)).length()).fold(0.0, f64::max)
    }

    /// Returns the vertices of each boundary loop, except corners, which are on the curve as well,
    /// and the loop as a curve.
    pub(crate) fn boundary(&self) -> &[BoundaryCurve] {
        self.boundary.get_or_init(|| {
            BoundaryCurves::new(self.positions(), &self.topology, NO_CORNERS).curves
        })
    }

    /// Returns the area of the original without its wrinkles: see [`smoothed_area`].
    pub(crate) fn smoothed_area(&self) -> f64 {
        *self.smoothed_area.get_or_init(|| self.smoothed_area_at(self.positions()))
    }

    /// The same at `now` (`#V by 3`).
    pub(crate) fn smoothed_area_at(&self, now: &[Point]) -> f64 {
        smoothed_area(&self.mesh, &self.topology, now)
    }

    /// Returns the faces and all that share a vertex with them, ascending.
    pub(crate) fn faces_around(&self, faces: &[u32]) -> Vec<u32> {
        let mut is_near = vec![false; self.mesh.faces.len()];
        for &v in faces.iter().flat_map(|&face| self.mesh.faces.row(face as usize)) {
            let around = self.topology.vertex_faces().row(v as usize);
            around.iter().for_each(|&face| is_near[face as usize] = true);
        }
        (0..).zip(is_near).filter(|(_, near)| *near).map(|(face, _)| face).collect()
    }

    /// Returns the distances of `now` (`#V by 3`) from the rest positions, in the unit of the mesh.
    pub(crate) fn displacements<'a>(
        &'a self,
        now: &'a [Point],
    ) -> impl ExactSizeIterator<Item = f64> + 'a {
        let pairs = now.iter().zip(self.positions());
        pairs.map(|(&now, &rest)| (Vec3::from(now) - Vec3::from(rest)).length())
    }

    /// Summarises the distances of `now` (`#V by 3`) from the rest positions.
    pub(crate) fn moved_by(&self, now: &[Point]) -> Moved {
        Moved::of(self.displacements(now))
    }

    /// The [`Mesh::size`] at rest, in the unit of the mesh.
    pub(crate) fn diameter(&self) -> f64 {
        self.diameter
    }

    /// Mean edge length, in the unit of the mesh; zero without edges.
    pub(crate) fn mean_edge(&self) -> f64 {
        self.topology.mean_edge(&self.mesh.positions)
    }

    /// Returns the names of the groups that contain one of `faces`, in the order of the file.
    pub(crate) fn groups_of(&self, faces: &[u32]) -> Vec<String> {
        let groups = self.mesh.groups.iter();
        let is_asked = marked(self.mesh.faces.len(), faces);
        let has_one = |group: &&Group| group.faces.iter().any(|&face| is_asked[face as usize]);
        groups.filter(has_one).map(|group| group.name.clone()).collect()
    }

    /// Indices in [`Topology::edges`] of the edges with these ends, ascending.
    pub(crate) fn edges_between(&self, ends: &[[u32; 2]]) -> Vec<u32> {
        let mut ends = ends.to_vec();
        sort_by_number(&mut ends, |&ends| key_of_pair(ends));
        let edges = (0..).zip(self.topology.edges());
        edges
            .filter(|(_, [a, b])| ends.binary_search(&[*a.min(b), *a.max(b)]).is_ok())
            .map(|(index, _)| index)
            .collect()
    }
}
