//! `E_close` (Eq. 11) keeps every vertex close to the reference surface, to a boundary curve, or to
//! its rest position.

use crate::constraint::Row;
use crate::math::{argsort, cosine};
use crate::mesh::{BoundaryCurves, ClosestPointCache, Point, Surface, Topology};
use crate::solve::settings::{BoundaryCloseness, BoundaryRequire, ClosenessTo};
use std::rc::Rc;

/// `E_close = sum_v k_v |v - c(v)|^2`, over the vertices that have a target `c(v)`.
pub(crate) struct CloseEnergy {
    /// The surface and the boundary curves, each with the vertices that are kept close to it.
    surfaces: Vec<SurfaceTargets>,
    /// Vertices that are kept close to one point.
    points: Vec<PointTarget>,
}

/// Vertices whose target is their closest point on a surface or curve.
struct SurfaceTargets {
    on: Rc<Surface>,
    /// On the surface by ascending nodes: neighbours in the elimination order are neighbours on the
    /// surface, so that its tree stays in the cache.
    vertices: Vec<SurfaceTarget>,
    /// The foot point of the last search for each vertex, from which the next search starts.
    caches: Vec<ClosestPointCache>,
}

impl SurfaceTargets {
    fn new(on: Rc<Surface>, vertices: Vec<SurfaceTarget>) -> SurfaceTargets {
        let caches = vec![ClosestPointCache::unknown(); vertices.len()];
        SurfaceTargets { on, vertices, caches }
    }
}

#[derive(Clone, Copy)]
struct SurfaceTarget {
    node: u32,
    /// The result of the last search.
    hint: u32,
    /// `k_v`, positive.
    factor: f64,
}

struct PointTarget {
    node: u32,
    /// `k_v`, positive.
    factor: f64,
    target: Row,
}

/// The rest shape by nodes.
pub(crate) struct RestShape<'a> {
    /// The rest position of each node.
    pub rest: &'a [Row],
    /// The node of each vertex.
    pub node_of: &'a [u32],
    pub topology: &'a Topology,
    /// Returns the rest surface, which is computed on first use.
    pub surface: &'a dyn Fn() -> Rc<Surface>,
    /// The surface of [`ClosenessTo::Target`].
    pub target: Option<Rc<Surface>>,
}

impl CloseEnergy {
    /// Creates the energy with the targets `to`, or a soft `boundary` for the vertices there, and the
    /// factors `k_v`, `#V`; `None` if nothing is kept close. Also returns the corners of the
    /// boundary, except those with a factor of zero.
    pub(crate) fn new(
        to: ClosenessTo,
        boundary: BoundaryCloseness,
        factors: &[f64],
        rest_shape: &RestShape<'_>,
    ) -> (Option<CloseEnergy>, Vec<u32>) {
        let &RestShape { rest, node_of, topology, surface, ref target } = rest_shape;
        let on_surface = |v: u32| SurfaceTarget {
            node: node_of[v as usize],
            hint: Surface::NO_HINT,
            factor: factors[v as usize],
        };
        let at_point = |v: u32| PointTarget {
            node: node_of[v as usize],
            factor: factors[v as usize],
            target: rest[node_of[v as usize] as usize],
        };
        let mut is_taken: Vec<bool> = factors.iter().map(|&factor| factor == 0.0).collect();
        let mut energy = CloseEnergy { surfaces: Vec::new(), points: Vec::new() };
        let mut corners = Vec::new();
        if boundary.require == BoundaryRequire::Soft {
            let positions: Vec<Point> = node_of
                .iter()
                .map(|&node| {
                    let [x, y, z, _] = rest[node as usize];
                    [x, y, z]
                })
                .collect();
            let BoundaryCloseness { corners: angle, weight, .. } = boundary;
            let boundary = BoundaryCurves::new(&positions, topology, cosine(angle / 360.0));
            let times = |mut target: SurfaceTarget| {
                target.factor *= weight;
                target
            };
            let mut take = |v: &u32| !std::mem::replace(&mut is_taken[*v as usize], true);
            corners = boundary.corners.into_iter().filter(&mut take).collect();
            energy.points.extend(corners.iter().copied().map(at_point));
            for curve in boundary.curves {
                let vertices = curve.vertices.into_iter().filter(&mut take);
                let vertices = vertices.map(on_surface).map(times);
                let vertices = vertices.filter(|target| target.factor > 0.0).collect();
                energy.surfaces.push(SurfaceTargets::new(Rc::new(curve.curve), vertices));
            }
        }
        let others = (0..).zip(&is_taken).filter(|(_, is_taken)| !**is_taken).map(|(v, _)| v);
        match to {
            ClosenessTo::None => {}
            ClosenessTo::Rest => energy.points.extend(others.map(at_point)),
            ClosenessTo::Surface | ClosenessTo::Target => {
                // Beside faces, a curve or a lone vertex is no part of the surface.
                let faces = topology.vertex_faces();
                let has_faces = !faces.indices().is_empty();
                let (on, off): (Vec<u32>, Vec<u32>) =
                    others.partition(|&v| !has_faces || !faces.row(v as usize).is_empty());
                energy.points.extend(off.into_iter().map(at_point));
                let vertices: Vec<SurfaceTarget> = on.into_iter().map(on_surface).collect();
                let order = argsort(vertices.iter().map(|target| u64::from(target.node)));
                let vertices = order.into_iter().map(|i| vertices[i as usize]).collect();
                let other = target.as_ref().filter(|_| to == ClosenessTo::Target);
                let on = other.map_or_else(surface, Rc::clone);
                energy.surfaces.push(SurfaceTargets::new(on, vertices));
            }
        }
        let any = energy.held().next().is_some();
        (any.then_some(energy), corners)
    }

    /// The nodes that it holds, each once, with their nonzero `k_v`.
    pub(crate) fn held(&self) -> impl Iterator<Item = (u32, f64)> {
        let on_surfaces = self.surfaces.iter().flat_map(|surface| &surface.vertices);
        let on_surfaces = on_surfaces.map(|target| (target.node, target.factor));
        on_surfaces.chain(self.points.iter().map(|target| (target.node, target.factor)))
    }

    /// Adds half the gradient of `lambda * E_close` at `x`, and returns `E_close`.
    pub(crate) fn step(&mut self, x: &[Row], gradient: &mut [Row], lambda: f64) -> f64 {
        let mut energy = 0.0;
        let mut pull = |node: u32, factor: f64, target: Point| {
            let (row, gradient) = (x[node as usize], &mut gradient[node as usize]);
            let lambda = lambda * factor;
            for i in 0..3 {
                let away = row[i] - target[i];
                energy += factor * (away * away);
                gradient[i] += lambda * away;
            }
        };
        for SurfaceTargets { on, vertices, caches } in &mut self.surfaces {
            for (SurfaceTarget { node, hint, factor }, cache) in vertices.iter_mut().zip(caches) {
                let [px, py, pz, _] = x[*node as usize];
                pull(*node, *factor, on.closest_from([px, py, pz], hint, cache));
            }
        }
        for &PointTarget { node, factor, target: [px, py, pz, _] } in &self.points {
            pull(node, factor, [px, py, pz]);
        }
        energy
    }
}
