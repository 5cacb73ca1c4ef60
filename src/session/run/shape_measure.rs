//! The measure of a shape against its original: what a builder judges it by. The attempts to meet
//! hard constraints are compared by it, the verdict is made from it, and the report has it.

use crate::math::Vec3;
use crate::mesh::{BoundaryCurve, Mesh, Point, Surface};
use crate::session::state::RestMesh;
use crate::solve::Moved;
use serde::Serialize;
use std::rc::Rc;

/// A shape against its original. Lengths are in the unit of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ShapeMeasure {
    /// The faces, ascending, that are folded or dented and were not at rest: see
    /// [`folded_faces`](crate::mesh::folded_faces).
    pub(crate) folded: Vec<u32>,
    /// Distances of the vertices from their rest positions.
    pub(crate) moved: Moved,
    /// Distances between the surface and its original.
    pub(crate) surface: SurfaceDistance,
    /// Whether the original is another surface, on which the rest mesh lies.
    pub(crate) is_on_other: bool,
    /// The largest distance of a boundary vertex from the original boundary.
    pub(crate) boundary: f64,
    /// The angle between neighbouring faces.
    pub(crate) bend: Bend,
    /// The smallest ratio of an edge length to its rest length; 1 without edges.
    pub(crate) shortest_edge: f64,
    /// The fraction of the area that is lost, after wrinkles are smoothed away.
    pub(crate) area_lost: f64,
    /// The diameter of the original.
    pub(crate) size: f64,
}

/// Distances between two surfaces: of the vertices of each from the other, in the unit of the mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct SurfaceDistance {
    /// Root mean square.
    pub rms: f64,
    /// The maximum.
    pub max: f64,
}

/// The mean angle between neighbouring faces of the whole mesh, in degrees.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Bend {
    /// At rest.
    pub rest: f64,
    /// In the current shape.
    pub now: f64,
    /// Whether the difference is a change of the design.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub change: Option<BendChange>,
}

/// A change of the surface as a whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum BendChange {
    /// The faces meet at clearly larger angles.
    Rougher,
    /// They meet at less than half the angle.
    Flatter,
}

impl ShapeMeasure {
    /// Measures the shape of `rest` with its vertices at `now` (`#V by 3`). `target` is the mesh that
    /// its closeness is to, if another one: the original, if the rest mesh lies on it.
    pub(crate) fn of(now: &[Point], rest: &RestMesh, target: Option<&Rc<Mesh>>) -> ShapeMeasure {
        let other = rest.original(target);
        ShapeMeasure {
            is_on_other: other.is_some(),
            folded: rest.folded_by(now),
            moved: rest.moved_by(now),
            surface: SurfaceDistance::between(now, rest, other.as_deref()),
            boundary: boundary_distance(now, rest),
            bend: Bend::of(now, rest),
            shortest_edge: shortest_edge(now, rest),
            area_lost: lost(rest.smoothed_area(), rest.smoothed_area_at(now)),
            size: rest.diameter(),
        }
    }
}

impl SurfaceDistance {
    /// The distances between the surface at `now` (`#V by 3`) and the original, both ways: a part of
    /// the original that is cut off is far from the surface, which may be near the original itself.
    /// Of an original `other` than the rest mesh, which lies on it, the rest positions are points.
    fn between(now: &[Point], rest: &RestMesh, other: Option<&Surface>) -> SurfaceDistance {
        if now == rest.positions() {
            return SurfaceDistance::default();
        }
        // What the surface is made of: beside faces neither curves nor lone vertices.
        let faces = rest.topology().vertex_faces();
        let parts = if faces.indices().is_empty() { rest.topology().neighbours() } else { faces };
        let is_on_it = |v: &usize| !parts.row(*v).is_empty();
        let moved = Surface::new(now, rest.mesh());
        let (mut sum, mut count, mut max) = (0.0, 0.0, 0.0);
        let original = other.unwrap_or_else(|| rest.surface());
        for (points, surface) in [(now, original), (rest.positions(), &moved)] {
            let mut hint = Surface::NO_HINT;
            for v in (0..points.len()).filter(is_on_it) {
                let to = surface.closest(points[v], &mut hint);
                let squared = (Vec3::from(to) - Vec3::from(points[v])).length_squared();
                sum += squared;
                count += 1.0;
                max = f64::max(max, squared);
            }
        }
        SurfaceDistance { rms: (sum / f64::max(count, 1.0)).sqrt(), max: max.sqrt() }
    }
}

/// Returns the fraction of an area that is lost.
fn lost(before: f64, now: f64) -> f64 {
    if before > 0.0 { (1.0 - now / before).max(0.0) } else { 0.0 }
}

/// A surface is rough if the mean angle between neighbouring faces exceeds this multiple of the
/// angle at rest by more than [`HARDLY_ROUGH`].
const ROUGH: f64 = 1.25;
/// A difference of this angle, in degrees, that is hardly visible.
const HARDLY_ROUGH: f64 = 1.0;
/// A surface has become flatter if this angle is below this fraction of the angle at rest.
const FLATTER: f64 = 0.5;
/// It is hardly bent below this fraction.
const HARDLY_BENT: f64 = 0.2;
/// It is flat below this fraction.
const FLAT: f64 = 0.1;

impl Bend {
    fn of(now: &[Point], rest: &RestMesh) -> Bend {
        let (rest, now) = (rest.bend(), rest.bend_at(now));
        let change = match now {
            _ if now > ROUGH * rest + HARDLY_ROUGH => Some(BendChange::Rougher),
            _ if now < FLATTER * rest => Some(BendChange::Flatter),
            _ => None,
        };
        Bend { rest, now, change }
    }

    /// Whether a curved surface lost nearly all of its curvature.
    pub(crate) fn is_hardly_bent(&self) -> bool {
        self.now < HARDLY_BENT * self.rest
    }

    /// Whether a curved surface became flat.
    pub(crate) fn is_flat(&self) -> bool {
        self.now < FLAT * self.rest
    }

    /// The angle relative to that at which the surface is rough, or flatter: 1 at the limit.
    pub(crate) fn relative(&self) -> f64 {
        let rough = self.now / (ROUGH * self.rest + HARDLY_ROUGH);
        let flatter = match self.rest > 0.0 {
            true => FLATTER * self.rest / self.now.max(f64::MIN_POSITIVE),
            false => 0.0,
        };
        rough.max(flatter)
    }
}

/// Returns the largest distance at `now` (`#V by 3`) of a boundary vertex from the boundary loop that
/// it is on at rest.
fn boundary_distance(now: &[Point], rest: &RestMesh) -> f64 {
    let mut most = 0.0;
    for BoundaryCurve { curve, vertices, .. } in rest.boundary() {
        let mut hint = Surface::NO_HINT;
        for &v in vertices {
            let point = now[v as usize];
            let to = curve.closest(point, &mut hint);
            most = f64::max(most, (Vec3::from(to) - Vec3::from(point)).length());
        }
    }
    most
}

/// Returns the smallest ratio of an edge length at `now` (`#V by 3`) to its rest length. Ignores
/// curves beside faces, and edges of zero rest length; 1 without edges.
pub(crate) fn shortest_edge(now: &[Point], rest: &RestMesh) -> f64 {
    let squared = |of: &[Point], [a, b]: [u32; 2]| {
        (Vec3::from(of[a as usize]) - Vec3::from(of[b as usize])).length_squared()
    };
    let edges = rest.topology().body_edges();
    let ratios = edges.filter_map(|ends| match squared(rest.positions(), ends) {
        0.0 => None,
        before => Some(squared(now, ends) / before),
    });
    ratios.reduce(f64::min).map_or(1.0, f64::sqrt)
}
