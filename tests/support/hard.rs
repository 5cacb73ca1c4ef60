//! Meshes with hard constraints: the problem of the study that they are compared with.

use shape_up::constraint::{Element, Kind, Selector, Sets, resolve};
use shape_up::mesh::{BoundingSphere, Mesh, Point, Topology};
use shape_up::solve::{
    BoundaryCloseness, ClosenessTo, Constraints, Exact, Handle, Problem, Require, Requirements,
    SHORTEST_EDGE, SetupCache, ShapeSpace, Smoothness, SmoothnessOf, Solver, SolverSettings,
    Weighting, Weights,
};

/// A mesh with rows of constraints.
pub(crate) struct Case {
    pub(crate) mesh: Mesh,
    pub(crate) topology: Topology,
    pub(crate) rows: Vec<Constraints>,
    pub(crate) requires: Vec<Require>,
    pub(crate) handles: Vec<Handle>,
    pub(crate) weights: Weights,
    pub(crate) shortest_edge: Option<f64>,
    factors: Vec<f64>,
}

impl Case {
    /// No constraints: closeness to rest with weight 10, smoothness of the displacement with weight
    /// 2, and the default guard.
    pub(crate) fn new(mesh: Mesh) -> Case {
        Case {
            topology: Topology::new(&mesh),
            factors: vec![1.0; mesh.positions.len()],
            mesh,
            rows: Vec::new(),
            requires: Vec::new(),
            handles: Vec::new(),
            weights: Weights { shape: 5.0, close: 10.0, smooth: 2.0 },
            shortest_edge: Some(SHORTEST_EDGE),
        }
    }

    /// Adds a row of constraints.
    pub(crate) fn with(
        mut self,
        kind: &str,
        params: serde_json::Value,
        members: impl IntoIterator<Item = Vec<u32>>,
        require: Require,
    ) -> Case {
        let kind = Kind::new(kind, params).expect("the kind is there");
        let members = members.into_iter().collect();
        self.rows.push(Constraints { kind, weight: 1.0, members });
        self.requires.push(require);
        self
    }

    /// Adds a kind on all faces that fit it.
    pub(crate) fn on_faces(self, kind: &str, require: Require) -> Case {
        let selector = Selector::Each { element: Element::Face, within: None, radius: 0 };
        let faces = resolve(&selector, &self.mesh, &self.topology, &Sets::default());
        let faces = faces.expect("faces can be selected");
        let arity = Kind::new(kind, serde_json::json!({})).expect("the kind is there").info().arity;
        let fitting = faces.iter().filter(|face| arity.fits(face.len()));
        let fitting: Vec<Vec<u32>> = fitting.map(<[u32]>::to_vec).collect();
        self.with(kind, serde_json::json!({}), fitting, require)
    }

    pub(crate) fn problem(&self) -> Problem<'_> {
        Problem {
            mesh: &self.mesh,
            pose: None,
            design: None,
            topology: &self.topology,
            constraints: &self.rows,
            weights: self.weights,
            closeness_to: ClosenessTo::Rest,
            closeness_target: None,
            boundary_closeness: BoundaryCloseness::default(),
            closeness_factors: &self.factors,
            smoothness: Smoothness {
                of: SmoothnessOf::Displacement,
                weighting: Weighting::Uniform,
            },
            settings: SolverSettings::default(),
        }
    }

    /// The solution with all rows soft.
    pub(crate) fn soft(&self) -> Vec<Point> {
        let start = &self.mesh.positions;
        let cache = SetupCache::default();
        let solver = Solver::new(&self.problem(), cache, self.handles.clone(), start);
        let mut solver = solver.expect("the problem is regular");
        for _ in 0..500 {
            solver.step().expect("positions stay finite");
            if solver.converged() {
                break;
            }
        }
        solver.settle();
        solver.positions().collect()
    }

    /// The exact problem, starting at these positions.
    pub(crate) fn exact(&self, start: &[Point]) -> Exact {
        let requirements = Requirements {
            rows: &self.requires,
            shortest_edge: self.shortest_edge,
            iterations: Requirements::ITERATIONS,
        };
        Exact::new(&self.problem(), &requirements, &self.handles, start, SetupCache::default())
    }

    /// The distance that is reached instead if the exact solution does not fit in memory.
    pub(crate) fn nearest(&self, nonzeros: usize) -> Option<f64> {
        let requirements = Requirements {
            rows: &self.requires,
            shortest_edge: self.shortest_edge,
            iterations: Requirements::ITERATIONS,
        };
        Exact::nearest(&self.problem(), &requirements, nonzeros)
    }

    /// The variations of a shape on which all constraints are met.
    pub(crate) fn shape_space(&self, shape: &[Point]) -> ShapeSpace {
        let requirements = Requirements {
            rows: &self.requires,
            shortest_edge: self.shortest_edge,
            iterations: Requirements::ITERATIONS,
        };
        let (problem, cache) = (self.problem(), SetupCache::default());
        let space = ShapeSpace::new(&problem, &requirements, &self.handles, shape, cache);
        space.expect("its systems are regular")
    }

    /// Diameter of the bounding sphere.
    pub(crate) fn size(&self) -> f64 {
        BoundingSphere::of(&self.mesh.positions).diameter()
    }
}
