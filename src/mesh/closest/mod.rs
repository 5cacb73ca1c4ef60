//! Closest points on a surface (`c(v)` of paper section 4, Eq. 11) and on its boundary curves.
//!
//! Every iteration searches the closest point on the surface for every vertex, so a search starts
//! from the last result for that vertex. Near the surface, the neighbour list of the last closest
//! triangle contains all candidates; elsewhere the distance to that triangle bounds the search of
//! the hierarchy. Both are exact. Listing the neighbours takes several times as long as all
//! else, so it is done only for the surfaces of iterations: see [`Surface::for_iterations`].

mod boundary_curves;
mod bvh;
mod neighbourhoods;
mod polyline;
mod safe_region;
mod triangle;

pub use boundary_curves::{BoundaryCurve, BoundaryCurves, BoundaryPiece};
pub use polyline::Polyline;
pub use safe_region::ClosestPointCache;

use crate::math::{Pair, Vec3, ears_in_space};
use crate::mesh::{Mesh, Point};
use bvh::{Box3, Bvh};
use neighbourhoods::TriangleNeighbourhoods;
use triangle::{Corners, Hit, Planes, is_sliver, splat};

/// A surface with closest-point queries.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Origin of the coordinates below, so that coordinates far from zero do not lose digits.
    centre: Vec3<f64>,
    /// The triangles as parts of faces; empty without faces.
    of_faces: Vec<FaceTriangle>,
    /// In the order of the hierarchy, so that neighbours in space are neighbours in memory.
    planes: Vec<Planes>,
    corners: Vec<Corners>,
    neighbourhoods: Option<TriangleNeighbourhoods>,
    bvh: Bvh,
}

/// A triangle of a face, as triangulated for a [`Surface`].
#[derive(Clone, Copy, Debug, Default)]
pub struct FaceTriangle {
    /// The face.
    pub face: u32,
    /// The corners as vertices of the mesh. The last two are the same for a side of a thin triangle.
    pub corners: [u32; 3],
}

impl Surface {
    /// Initial value of `hint`: no triangle is known yet.
    pub const NO_HINT: u32 = u32::MAX;

    /// Builds the surface of `mesh` at `positions` (`#V by 3`): its faces, triangulated as fans
    /// `(f0, fk, fk+1)`; without faces, the segments of its curves; without both, its vertices.
    /// A triangle thinner than 1e-8 of its length is replaced by its three sides.
    pub fn new(positions: &[Point], mesh: &Mesh) -> Surface {
        Surface::cut(positions, mesh, |corners| (2..corners.len()).map(|k| [0, k - 1, k]))
    }

    /// Returns the surface of the triangles on which panels are laid out: to ask what lies on it, and on
    /// which face. No face covers what is outside its polygon, as the fan of a concave one does.
    pub fn of_polygons(positions: &[Point], mesh: &Mesh) -> Surface {
        Surface::cut(positions, mesh, ears_in_space)
    }

    fn cut<I: IntoIterator<Item = [usize; 3]>>(
        positions: &[Point],
        mesh: &Mesh,
        triangles_of: impl Fn(&[Vec3<f64>]) -> I,
    ) -> Surface {
        let at = |v: u32| positions[v as usize];
        let mut of_faces = Vec::with_capacity(mesh.faces.indices().len());
        let mut corners: Vec<Vec3<f64>> = Vec::new();
        for (face, vertices) in (0..).zip(mesh.faces.iter()) {
            corners.clear();
            corners.extend(vertices.iter().map(|&v| Vec3::from(at(v))));
            for triangle in triangles_of(&corners) {
                let [a, b, c] = triangle.map(|k| vertices[k]);
                let sides = [[a, b, b], [b, c, c], [c, a, a]];
                let own = if is_sliver([a, b, c].map(at)) { &sides[..] } else { &[[a, b, c]] };
                of_faces.extend(own.iter().map(|&corners| FaceTriangle { face, corners }));
            }
        }
        let mut triangles: Vec<[Point; 3]> =
            of_faces.iter().map(|triangle| triangle.corners.map(at)).collect();
        if mesh.faces.is_empty() {
            let segments = mesh.curves.iter().flat_map(|curve| curve.windows(2));
            triangles.extend(segments.map(|ends| [ends[0], ends[1], ends[1]].map(at)));
        }
        if triangles.is_empty() {
            triangles.extend(positions.iter().map(|&p| [p; 3]));
        }
        Surface::of_triangles(triangles, &of_faces)
    }

    /// Returns the same surface as [`Surface::new`], prepared for searches that are repeated for points
    /// that move little.
    pub fn for_iterations(positions: &[Point], mesh: &Mesh) -> Surface {
        let mut surface = Surface::new(positions, mesh);
        let Surface { bvh, planes, corners, .. } = &surface;
        surface.neighbourhoods = Some(TriangleNeighbourhoods::new(bvh, planes, corners));
        surface
    }

    /// `of_faces` are the same triangles, or none.
    fn of_triangles(triangles: Vec<[Point; 3]>, of_faces: &[FaceTriangle]) -> Surface {
        let centre = Box3::around(triangles.as_flattened()).centre();
        let triangles: Vec<[Vec3<f64>; 3]> =
            triangles.into_iter().map(|corners| corners.map(|p| Vec3::from(p) - centre)).collect();
        let boxes: Vec<Box3> =
            triangles.iter().map(|corners| Box3::around(&corners.map(Point::from))).collect();
        let (bvh, order) = Bvh::new(&boxes);
        let ordered = || order.iter().map(|&t| t as usize);
        let planes: Vec<Planes> = ordered().map(|t| Planes::new(triangles[t])).collect();
        let corners: Vec<Corners> = ordered().map(|t| Corners::new(triangles[t])).collect();
        let of_faces = ordered().filter_map(|t| of_faces.get(t).copied()).collect();
        Surface { centre, of_faces, planes, corners, neighbourhoods: None, bvh }
    }

    /// Returns the point of the surface closest to `p`; `p` itself if the surface is empty.
    /// `hint` is the value that the last search for this point left, or [`Surface::NO_HINT`]. A
    /// better value makes the search faster; if several points are equally close, it can decide
    /// which is returned.
    #[inline]
    pub fn closest(&self, p: Point, hint: &mut u32) -> Point {
        let p = Vec3::from(p) - self.centre;
        let known = self.planes.get(*hint as usize).zip(self.neighbourhoods.as_ref());
        if let Some((planes, neighbourhoods)) = known {
            let distances = planes.distances(splat(p));
            if neighbourhoods.region(*hint as usize).contains(distances) {
                return (planes.foot(p, distances) + self.centre).into();
            }
        }
        (self.search(p, hint) + self.centre).into()
    }

    /// Returns the face closest to `p`; none if the surface has no faces. If several are equally close,
    /// it returns one of them.
    pub fn closest_face(&self, p: Point) -> Option<u32> {
        self.closest_triangle_of(p, f64::INFINITY, |_| true).map(|(triangle, _)| triangle.face)
    }

    /// Returns the faces with triangles nearer to `p` than `within`, once for each triangle.
    pub fn faces_near(&self, p: Point, within: f64) -> Vec<u32> {
        let p = Vec3::from(p) - self.centre;
        let lanes = splat(p);
        let mut found = Vec::new();
        self.bvh.search(lanes, within * within, |leaf, bound| {
            let of_faces = leaf.clone().zip(self.of_faces.get(leaf).unwrap_or_default());
            found.extend(of_faces.filter_map(|(t, own)| {
                let mut best = Hit { point: p, distance_squared: bound };
                let mut hint = Surface::NO_HINT;
                self.consider(t, p, lanes, &mut best, &mut hint);
                (hint != Surface::NO_HINT).then_some(own.face)
            }));
            bound
        });
        found
    }

    /// Returns the triangle closest to `p`, nearer than `within`, of the faces that `is_meant`, and its
    /// distance; none if there is no such triangle.
    pub fn closest_triangle_of(
        &self,
        p: Point,
        within: f64,
        is_meant: impl Fn(u32) -> bool,
    ) -> Option<(FaceTriangle, f64)> {
        let p = Vec3::from(p) - self.centre;
        let lanes = splat(p);
        let mut best = Hit { point: p, distance_squared: within * within };
        let mut found = Surface::NO_HINT;
        self.bvh.search(lanes, best.distance_squared, |leaf, _| {
            for t in leaf.filter(|&t| self.of_faces.get(t).is_some_and(|own| is_meant(own.face))) {
                self.consider(t, p, lanes, &mut best, &mut found);
            }
            best.distance_squared
        });
        let triangle = self.of_faces.get(found as usize)?;
        Some((*triangle, best.distance_squared.sqrt()))
    }

    /// Returns the same as [`Surface::closest`]. `cache` also comes from the last search for this
    /// point, or is [`ClosestPointCache::unknown`].
    #[inline(always)]
    pub fn closest_from(&self, p: Point, hint: &mut u32, cache: &mut ClosestPointCache) -> Point {
        let p = Vec3::from(p) - self.centre;
        let foot = match cache.foot(p) {
            Some(foot) => foot,
            None => self.find_from(p, hint, cache),
        };
        (foot + self.centre).into()
    }

    #[inline(never)]
    fn find_from(&self, p: Vec3<f64>, hint: &mut u32, cache: &mut ClosestPointCache) -> Vec3<f64> {
        let before = *hint;
        let found = self.search(p, hint);
        if let Some(neighbourhoods) = &self.neighbourhoods
            && *hint != before
        {
            let t = *hint as usize;
            cache.planes.clone_from(&self.planes[t]);
            cache.region.clone_from(neighbourhoods.region(t));
        }
        found
    }

    /// Searches the neighbours of the triangle `hint` if they suffice, else the hierarchy.
    #[inline(never)]
    fn search(&self, p: Vec3<f64>, hint: &mut u32) -> Vec3<f64> {
        let lanes = splat(p);
        let mut best = Hit { point: p, distance_squared: f64::INFINITY };
        if let Some(planes) = self.planes.get(*hint as usize) {
            let t = *hint as usize;
            best = self.corners[t].closest(planes, p, planes.distances(lanes));
            let listed =
                self.neighbourhoods.as_ref().and_then(|all| all.of(t, best.distance_squared));
            if let Some(list) = listed {
                for &s in list {
                    self.consider(s as usize, p, lanes, &mut best, hint);
                }
                return best.point;
            }
        }
        self.bvh.search(lanes, best.distance_squared, |leaf, _| {
            for t in leaf {
                self.consider(t, p, lanes, &mut best, hint);
            }
            best.distance_squared
        });
        best.point
    }

    /// Replaces the best point by the closest point of triangle `t` if that is nearer.
    #[inline(always)]
    fn consider(&self, t: usize, p: Vec3<f64>, lanes: Vec3<Pair>, best: &mut Hit, hint: &mut u32) {
        let distances = self.planes[t].distances(lanes);
        if distances.within(best.distance_squared) {
            let hit = self.corners[t].closest(&self.planes[t], p, distances);
            if hit.distance_squared < best.distance_squared {
                *best = hit;
                *hint = t as u32;
            }
        }
    }
}
