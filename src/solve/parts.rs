//! The components of a solver: the energies of a problem, the system of their global step, and the
//! nodes that are not unknowns.
//!
//! What depends only on the mesh and the pattern of the matrix is kept for the next solver on the
//! same mesh.

use super::assemble::Terms;
use super::clock;
use super::energy::{
    CloseEnergy, Energies, Handle, HandleIndex, Hold, PositionalConstraints, RestShape,
    ShapeEnergy, SmoothEnergy, pins, smooth_terms,
};
use super::gliding::Gliding;
use super::local_frame::{centre_and_extent, relative, rest_surface};
use super::problem::Problem;
use super::settings::{BoundaryRequire, SmoothnessOf};
use super::system::System;
use crate::constraint::{Reference, Row};
use crate::mesh::{Mesh, Point, Surface};
use crate::sparse::SymbolicAnalysis;
use std::borrow::Cow;
use std::cell::OnceCell;
use std::rc::Rc;

/// A problem that is assembled and ordered, but not yet factored.
pub(super) struct Parts {
    /// The origin of the coordinates.
    pub centre: Point,
    /// The diagonal of the bounding box of the rest shape.
    pub extent: f64,
    pub n_vertices: usize,
    /// Number of vertices and extra unknowns; further nodes are padding.
    pub n_unknowns: usize,
    /// The system of the shape energy, the smoothness energy, and those that were added.
    pub system: System,
    /// The rest surface, shared with the next solver; see [`SetupCache`].
    pub surface: OnceCell<Rc<Surface>>,
    /// The target surface of closeness, shared likewise.
    pub target: Option<(Rc<Mesh>, Rc<Surface>)>,
    pub energies: Energies,
    /// `#nodes`: the rest positions.
    pub rest: Vec<Row>,
    /// `#nodes`: the positions of the pose, if kinds take their rest shape from one.
    pub pose: Option<Vec<Row>>,
    /// `#nodes`: whether the shape energy holds the node in place.
    pub held: Vec<bool>,
    /// The corners of the boundary, if they are fixed, and their positions.
    pub corners: Vec<(u32, Point)>,
    /// The other boundary vertices, if they stay exactly on their curves.
    pub gliding: Option<Gliding>,
}

/// An energy in addition to those of a problem.
#[derive(Default)]
pub(super) struct Added {
    /// Its terms; its extra unknowns are numbered after those of the problem.
    pub terms: Option<Terms>,
    /// Number of its extra unknowns.
    pub unknowns: usize,
    /// Vertices that it holds in place.
    pub holds: Vec<u32>,
}

impl Parts {
    /// Assembles and orders a problem. Reuses what another solver on the same mesh left in the
    /// `cache`.
    pub(super) fn new(problem: &Problem<'_>, added: Added, mut cache: SetupCache) -> Parts {
        let started = clock::now();
        let Problem { mesh, constraints, weights, settings, .. } = *problem;
        let n_vertices = mesh.positions.len();
        let n_unknowns = problem.n_unknowns() + added.unknowns;
        // `sprs-ldl` panics below two unknowns: further nodes are padding, and fixed.
        let n = n_unknowns.max(2);
        let laplacian = problem.laplacian();
        let shape_terms = problem.shape_terms();
        let mut held = problem.nodes_held_by(&shape_terms, n);
        added.holds.iter().for_each(|&v| held[v as usize] = true);
        let smooth_part = laplacian.as_ref().map(smooth_terms).unwrap_or_default();
        let before_system = clock::now();
        let mut terms = vec![shape_terms, smooth_part];
        terms.extend(added.terms);
        let (sizes, order) = ([n, n_vertices], cache.analysis.as_ref());
        let mut system = System::with_order(sizes, terms, settings.factorization, order);
        let after_system = clock::now();

        let (centre, extent) = centre_and_extent(mesh);
        let node_of = &system.node_of()[..n_vertices];
        let rest = to_rows(&mesh.positions, node_of, n, centre);
        let design = problem.design.map(|design| to_rows(design, node_of, n, centre));
        let held_to = design.as_deref().unwrap_or(&rest);
        let target = problem.closeness_target.filter(|_| weights.close > 0.0);
        let target = target.map(|target| cache.surface_of(target, centre));
        let SetupCache { surface: made, target: cached, .. } = cache;
        let surface = || Rc::clone(made.get_or_init(|| Rc::new(rest_surface(mesh, centre))));
        let pose = problem.pose.map(|pose| to_rows(pose, node_of, n, centre));
        let reference = Reference { surface: &surface, pose: pose.as_deref() };
        let boundary = problem.boundary_closeness;
        let mut factors = Cow::Borrowed(problem.closeness_factors);
        let gliding = (boundary.require == BoundaryRequire::Exact).then(|| {
            let around_centre = |p: &Point| std::array::from_fn(|i| p[i] - centre[i]);
            let positions: Vec<Point> = mesh.positions.iter().map(around_centre).collect();
            let released = |v: u32| problem.closeness_factors[v as usize] == 0.0;
            let (gliding, corners) =
                Gliding::new((&positions, centre), problem.topology, boundary, released, node_of);
            let factors = factors.to_mut();
            let on_curves = gliding.vertices().map(|(v, _)| v).chain(corners.iter().copied());
            on_curves.for_each(|v| factors[v as usize] = 0.0);
            (gliding, corners)
        });
        let (close, mut corners) = if weights.close > 0.0 {
            let of_design = problem.design.map(|design| {
                let mesh = mesh.at(design);
                move || Rc::new(rest_surface(&mesh, centre))
            });
            let rest_shape = RestShape {
                rest: held_to,
                node_of,
                topology: problem.topology,
                surface: of_design.as_ref().map_or(&surface as &dyn Fn() -> _, |it| it),
                target,
            };
            CloseEnergy::new(problem.closeness_to, boundary, &factors, &rest_shape)
        } else {
            Default::default()
        };
        let gliding = gliding.map(|(gliding, found)| {
            corners = found;
            gliding
        });
        let nodes: Vec<u32> = gliding.iter().flat_map(Gliding::vertices).map(|(_, n)| n).collect();
        let energies = Energies {
            weights,
            shape: ShapeEnergy::new(constraints, node_of, &rest, settings.monotone, &reference),
            smooth: laplacian.map(|laplacian| {
                let rest = match problem.smoothness.of {
                    SmoothnessOf::Surface => Vec::new(),
                    SmoothnessOf::Displacement => held_to.to_vec(),
                };
                SmoothEnergy::new(&laplacian, node_of, n, rest)
            }),
            close,
            handles: PositionalConstraints::default(),
        };
        system.decouple(nodes.into_iter());
        let held = {
            let mut by_node = vec![false; n];
            held.iter().zip(system.node_of()).for_each(|(&h, &node)| by_node[node as usize] = h);
            by_node
        };
        // Those on curves that they may not leave are where the curves of the mesh end.
        let shape = problem.design.filter(|_| gliding.is_none()).unwrap_or(&mesh.positions);
        system.seconds.assemble += before_system - started + clock::now() - after_system;
        Parts {
            centre,
            extent,
            n_vertices,
            n_unknowns,
            system,
            surface: made,
            target: cached,
            energies,
            rest,
            pose,
            held,
            corners: corners.into_iter().map(|v| (v, shape[v as usize])).collect(),
            gliding,
        }
    }

    /// Converts positions, `#V by 3`, to rows, one for each node.
    pub(super) fn to_rows(&self, positions: &[Point]) -> Vec<Row> {
        to_rows(positions, self.node_of(), self.held.len(), self.centre)
    }

    /// Converts a row to a position.
    pub(super) fn to_point(&self, row: Row) -> Point {
        std::array::from_fn(|i| row[i] + self.centre[i])
    }

    /// Puts what does not move freely at its place, given at most one handle for each vertex: fixed
    /// vertices at their targets, corners of the boundary at their places in `corners` unless a handle
    /// frees them, and vertices on curves at their closest points there. `x` are the positions by nodes,
    /// `put` those at which vertices were put, `#V by 3`.
    pub(super) fn place(
        &mut self,
        handles: &[Handle],
        index: &HandleIndex,
        x: &mut [Row],
        put: &mut [Point],
    ) {
        let node_of = &self.system.node_of()[..self.n_vertices];
        // On a boundary that stays exactly on its curves, corners ignore soft handles.
        let is_exact = self.gliding.is_some();
        let frees = |handle: &Handle| !is_exact || handle.hold == Hold::Fixed;
        let is_freed = |v: u32| index.get(v).is_some_and(|place| frees(&handles[place]));
        let corners = self.corners.iter().copied().filter(|&(v, _)| !is_freed(v));
        let fixed = handles.iter().filter(|handle| handle.hold == Hold::Fixed);
        for (vertex, target) in corners.chain(fixed.map(|handle| (handle.vertex, handle.target))) {
            x[node_of[vertex as usize] as usize] = relative(target, self.centre);
            put[vertex as usize] = target;
        }
        self.energies.handles = PositionalConstraints::new(handles, node_of, self.centre);
        if let Some(gliding) = &mut self.gliding {
            gliding.place(x, handles);
        }
    }

    /// Moves vertices to the points of their curves given by the unknowns after a step.
    pub(super) fn put_on_curves(&mut self, x: &mut [Row]) {
        if let Some(gliding) = &mut self.gliding {
            gliding.put_on_curves(x);
        }
    }

    /// Reduces a gradient to what fixed vertices and those on curves leave of it.
    pub(super) fn constrain(&mut self, gradient: &mut [Row]) {
        self.system.clear_fixed(gradient);
        if let Some(gliding) = &mut self.gliding {
            gliding.constrain(gradient);
        }
    }

    /// The node of each vertex.
    pub(super) fn node_of(&self) -> &[u32] {
        &self.system.node_of()[..self.n_vertices]
    }
}

fn to_rows(positions: &[Point], node_of: &[u32], n: usize, centre: Point) -> Vec<Row> {
    let mut rows = vec![[0.0; 4]; n];
    for (&point, &node) in positions.iter().zip(node_of) {
        rows[node as usize] = relative(point, centre);
    }
    rows
}

/// The fixed nodes of a system, and what handles, closeness and pins add to its normal matrix.
pub(super) struct Holding {
    /// `#nodes`: whether the node is fixed.
    pub fixed: Vec<bool>,
    /// `#nodes`: addition to the diagonal.
    pub diagonal: Vec<f64>,
    /// Vertices that are fixed because nothing else holds their component.
    pub pinned: Vec<u32>,
}

impl Parts {
    /// Computes what is fixed and held with the given handles.
    pub(super) fn holding(&self, handles: &[Handle]) -> Holding {
        let Parts { system, energies, .. } = self;
        let (n, node_of) = (self.held.len(), self.node_of());
        let (mut fixed, mut held, mut diagonal) = (vec![false; n], self.held.clone(), vec![0.0; n]);
        let padding = &system.node_of()[self.n_unknowns..];
        padding.iter().for_each(|&node| fixed[node as usize] = true);
        if let Some(close) = &energies.close {
            for (node, factor) in close.held() {
                held[node as usize] = true;
                diagonal[node as usize] = energies.weights.close * factor;
            }
        }
        let corners = self.corners.iter().map(|&(v, _)| node_of[v as usize] as usize);
        corners.clone().for_each(|corner| fixed[corner] = true);
        for handle in handles {
            let node = node_of[handle.vertex as usize] as usize;
            held[node] = true;
            match handle.hold {
                Hold::Soft { weight } => {
                    diagonal[node] += weight;
                    fixed[node] = false;
                }
                Hold::Fixed => fixed[node] = true,
            }
        }
        // On a boundary that stays exactly on its curves, corners ignore soft handles.
        if self.gliding.is_some() {
            for corner in corners {
                (fixed[corner], held[corner]) = (true, true);
            }
            hold_both_sides(system, &mut held);
        }
        let pinned = pins(node_of, system.components(), &held);
        pinned.iter().for_each(|&v| fixed[node_of[v as usize] as usize] = true);
        Holding { fixed, diagonal, pinned }
    }
}

/// Marks components with both decoupled and other nodes as held: neither block of the matrix
/// contains all nodes of such a component, so both are regular.
fn hold_both_sides(system: &System, held: &mut [bool]) {
    let (components, is_decoupled) = (system.components(), system.is_decoupled());
    let mut sides = vec![[false; 2]; components.len()];
    for (&component, &is_decoupled) in components.iter().zip(is_decoupled) {
        sides[component as usize][usize::from(is_decoupled)] = true;
    }
    for (&component, held) in components.iter().zip(held) {
        *held |= sides[component as usize] == [true; 2];
    }
}

/// The rest surface, and the symbolic analysis of the last normal matrix.
#[derive(Clone, Default)]
pub struct SetupCache {
    /// Relative to the centre of the model; computed on first use.
    pub(super) surface: OnceCell<Rc<Surface>>,
    pub(super) analysis: Option<Rc<SymbolicAnalysis>>,
    /// The target surface of closeness with its mesh, relative to the same centre.
    pub(super) target: Option<(Rc<Mesh>, Rc<Surface>)>,
}

impl SetupCache {
    /// Returns the surface of `target`, computed unless the previous solver had the same target.
    pub(super) fn surface_of(&mut self, target: &Rc<Mesh>, centre: Point) -> Rc<Surface> {
        let known = self.target.take().filter(|(mesh, _)| Rc::ptr_eq(mesh, target));
        let (mesh, surface) =
            known.unwrap_or_else(|| (Rc::clone(target), Rc::new(rest_surface(target, centre))));
        self.target = Some((mesh, Rc::clone(&surface)));
        surface
    }
}
