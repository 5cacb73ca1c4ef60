//! `E_close` (Eq. 11): every vertex is kept close to the reference surface, to a boundary curve, or
//! to where it was.

use crate::constraint::Row;
use crate::math::{ascending, cosine};
use crate::mesh::{BoundaryCurves, Footing, Point, Surface, Topology};
use crate::scene::{Closeness, ClosenessTo};
use std::rc::Rc;

/// What vertices are kept close to: `sum k_v |v - c(v)|^2`.
pub(super) struct CloseEnergy {
    /// The rest surface and the boundary curves, each with the vertices that glide on it.
    gliding: Vec<Gliding>,
    /// Vertices that are kept close to one point.
    resting: Vec<Resting>,
}

/// Vertices that are kept close to the closest point of a surface or curve.
struct Gliding {
    on: Rc<Surface>,
    /// On the rest surface by ascending nodes: neighbours in the elimination order are neighbours
    /// on the surface, so that its tree stays in the cache.
    vertices: Vec<Glider>,
    /// What the last search for each of the vertices left.
    footings: Vec<Footing>,
}

impl Gliding {
    fn new(on: Rc<Surface>, vertices: Vec<Glider>) -> Gliding {
        let footings = vec![Footing::unknown(); vertices.len()];
        Gliding { on, vertices, footings }
    }
}

#[derive(Clone, Copy)]
struct Glider {
    node: u32,
    /// Where the last search for it ended.
    warm: u32,
    /// `k_v`
    factor: f64,
}

struct Resting {
    node: u32,
    /// `k_v`
    factor: f64,
    target: Row,
}

/// The rest shape in terms of nodes.
pub(super) struct RestShape<'a> {
    /// The rest position of each node.
    pub rest: &'a [Row],
    /// The node of each vertex.
    pub node_of: &'a [u32],
    pub topology: &'a Topology,
    /// The rest surface.
    pub surface: &'a dyn Fn() -> Rc<Surface>,
}

impl CloseEnergy {
    /// What `closeness` asks for, where `factors` has `k_v` of each vertex; none when nothing is kept
    /// close. With it the vertices that are corners of the boundary, if these count.
    pub(super) fn new(
        closeness: &Closeness,
        factors: &[f64],
        rest_shape: &RestShape<'_>,
    ) -> (Option<CloseEnergy>, Vec<u32>) {
        let RestShape { rest, node_of, topology, surface } = *rest_shape;
        let glider = |v: u32| Glider {
            node: node_of[v as usize],
            warm: Surface::COLD,
            factor: factors[v as usize],
        };
        let resting = |v: u32| Resting {
            node: node_of[v as usize],
            factor: factors[v as usize],
            target: rest[node_of[v as usize] as usize],
        };
        let mut elsewhere: Vec<bool> = factors.iter().map(|&factor| factor == 0.0).collect();
        let mut energy = CloseEnergy { gliding: Vec::new(), resting: Vec::new() };
        let mut corners = Vec::new();
        if let Some(boundary) = closeness.boundary {
            let positions: Vec<Point> = node_of
                .iter()
                .map(|&node| {
                    let [x, y, z, _] = rest[node as usize];
                    [x, y, z]
                })
                .collect();
            let boundary =
                BoundaryCurves::new(&positions, topology, cosine(boundary.corners / 360.0));
            let mut take = |v: &u32| !std::mem::replace(&mut elsewhere[*v as usize], true);
            corners = boundary.corners.into_iter().filter(&mut take).collect();
            energy.resting.extend(corners.iter().copied().map(resting));
            for curve in boundary.curves {
                let vertices = curve.vertices.into_iter().filter(&mut take).map(glider).collect();
                energy.gliding.push(Gliding::new(Rc::new(curve.polyline), vertices));
            }
        }
        let others = (0..).zip(&elsewhere).filter(|(_, elsewhere)| !**elsewhere).map(|(v, _)| v);
        match closeness.to {
            ClosenessTo::None => {}
            ClosenessTo::Rest => energy.resting.extend(others.map(resting)),
            ClosenessTo::Surface => {
                let vertices: Vec<Glider> = others.map(glider).collect();
                let order = ascending(vertices.iter().map(|glider| u64::from(glider.node)));
                let vertices = order.into_iter().map(|i| vertices[i as usize]).collect();
                energy.gliding.push(Gliding::new(surface(), vertices));
            }
        }
        let any = energy.held().next().is_some();
        (any.then_some(energy), corners)
    }

    /// The nodes that it holds, each once, with `k_v`, which is not zero.
    pub(super) fn held(&self) -> impl Iterator<Item = (u32, f64)> {
        let gliders = self.gliding.iter().flat_map(|gliding| &gliding.vertices);
        let gliders = gliders.map(|glider| (glider.node, glider.factor));
        gliders.chain(self.resting.iter().map(|resting| (resting.node, resting.factor)))
    }

    /// Adds half the gradient of `lambda * E_close` at `x`, and gives `E_close`.
    pub(super) fn step(&mut self, x: &[Row], gradient: &mut [Row], lambda: f64) -> f64 {
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
        for Gliding { on, vertices, footings } in &mut self.gliding {
            for (Glider { node, warm, factor }, footing) in vertices.iter_mut().zip(footings) {
                let [px, py, pz, _] = x[*node as usize];
                pull(*node, *factor, on.closest_from([px, py, pz], warm, footing));
            }
        }
        for &Resting { node, factor, target: [px, py, pz, _] } in &self.resting {
            pull(node, factor, [px, py, pz]);
        }
        energy
    }
}
