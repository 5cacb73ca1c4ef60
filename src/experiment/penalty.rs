//! Fig. 11: a strip of quads with circle constraints, whose edges collapse under fairness. Compares
//! Shape-Up with the penalty method of Liu et al. 2006 at the same circularity error.
//!
//! If no edge collapses, both find the same shape. If edges do collapse, on strips other than the
//! example's, the penalty method most often does not reach that error: it ends at an edge of a
//! millionth of its length, beside which no step is short enough. Both find a local minimum only.
//!
//! Both adapt the weight of the circles by the same rule until the circularity error has a given
//! value.

use super::declaration::{
    Experiment, Limits, Method, MethodInfo, Over, Plot, Quantity, Step, Unit,
};
use super::gauss_newton::GaussNewton;
use crate::mesh::{Laplacian, Measures, Mesh, Point, Ragged, Topology};
use crate::scene::{ClosenessTo, Hold, Scene, SceneError, SmoothnessOf, Weights};
use crate::session::{Edit, Error, Session};

/// Mean circularity error `e_c` for the comparison, at a bounding sphere of diameter 1.
const ERROR: f64 = 5e-8;

/// Fraction of the scene's circle weight at which both methods start. A penalty is raised step by
/// step: a high one would keep a rough shape nearly fixed.
const START: f64 = 1.0 / 200.0;

pub(super) const PENALTY: Experiment = Experiment {
    id: "penalty",
    label: "Collapsing edges",
    summary: "Smoothness makes short edges vanish. Both methods reach the same circularity error; compare how smooth the strip is then, and how short its shortest edge.",
    examples: &["fig-11-strip"],
    quantities: &[
        Quantity { id: "smooth", label: "Smoothness energy", unit: Unit::Energy },
        Quantity { id: "e_c", label: "Mean circularity error e_c", unit: Unit::None },
        Quantity { id: "shortest", label: "Shortest edge", unit: Unit::Length },
    ],
    plots: &[
        Plot { quantity: 0, over: Over::Iterations, above_lowest: false },
        Plot { quantity: 2, over: Over::Iterations, above_lowest: false },
    ],
    methods: &[
        MethodInfo {
            id: "shape-up",
            label: "Shape-Up",
            summary: "Circles are fitted to the corners wherever these are, so that an edge may vanish.",
            most_vertices: None,
            start: |scene, mesh| Ok(Box::new(Fitted::new(scene, mesh)?)),
        },
        MethodInfo {
            id: "gauss-newton",
            label: "Penalty, Gauss-Newton",
            summary: "Opposite angles must sum to a half turn (Liu, Pottmann, Wallner, Yang and Wang, 2006): their derivatives grow without bound as an edge vanishes.",
            most_vertices: None,
            start: |scene, mesh| Ok(Box::new(Penalised::new(scene, mesh)?)),
        },
    ],
    limits: Limits { iterations: 1500, seconds: 30.0 },
};

/// Mesh data for measuring a shape.
struct Measured {
    faces: Ragged,
    edges: Vec<[u32; 2]>,
    diameter: f64,
}

impl Measured {
    fn new(mesh: &Mesh, topology: &Topology) -> Measured {
        Measured {
            faces: mesh.faces.clone(),
            edges: topology.body_edges().collect(),
            diameter: mesh.size(),
        }
    }

    fn error(&self, positions: &[Point]) -> f64 {
        Measures::new(positions, &self.faces, self.diameter).circularity.e_c_mean
    }

    fn values(&self, smooth: f64, positions: &[Point]) -> Vec<f64> {
        let square = |&[a, b]: &[u32; 2]| {
            let differences = (0..3).map(|k| positions[a as usize][k] - positions[b as usize][k]);
            differences.map(|difference| difference * difference).sum::<f64>()
        };
        let shortest = self.edges.iter().map(square).fold(f64::INFINITY, f64::min).sqrt();
        vec![smooth, self.error(positions), shortest]
    }
}

/// Shape-Up, as run by the Run button.
struct Fitted {
    session: Session,
    measured: Measured,
    continuation: Continuation,
}

impl Fitted {
    fn new(scene: &Scene, mesh: &Mesh) -> Result<Fitted, Error> {
        let mut scene = scene.clone();
        scene.solver.tolerance = 0.0;
        scene.weights.shape *= START;
        let continuation = Continuation::new(scene.weights.shape, ERROR);
        let session = Session::open(scene, mesh.clone())?;
        let measured = Measured::new(session.mesh(), session.topology());
        Ok(Fitted { session, measured, continuation })
    }
}

impl Method for Fitted {
    fn set_up_seconds(&self) -> f64 {
        let seconds = self.session.solver().set_up_seconds();
        seconds.assemble + seconds.order + seconds.factor
    }

    fn step(&mut self) -> Result<Step, Error> {
        self.session.step()?;
        let total = self.session.solver().energy().total;
        let error = self.measured.error(&self.session.positions());
        let weight = self.continuation.weight;
        if self.continuation.record(total, error, false) {
            return Ok(Step::Reached);
        }
        if self.continuation.weight != weight {
            let weights = self.session.document().weights;
            let weights = Weights { shape: self.continuation.weight, ..weights };
            self.session.edit(Edit::SetWeights(weights.into()))?;
        }
        Ok(Step::Going)
    }

    fn values(&self) -> Vec<f64> {
        let smooth = self.session.solver().energy().smooth;
        self.measured.values(smooth, &self.session.positions())
    }
}

/// The penalty method.
struct Penalised {
    state: GaussNewton,
    measured: Measured,
    continuation: Continuation,
}

impl Penalised {
    fn new(scene: &Scene, mesh: &Mesh) -> Result<Penalised, Error> {
        scene.validate(mesh)?;
        let topology = Topology::new(mesh);
        let wrong = |path: &str, message: &str| {
            Error::Scene(SceneError { path: path.to_owned(), message: message.to_owned() })
        };
        let quads = mesh.faces.iter().map(|face| <[u32; 4]>::try_from(face).ok());
        let quads: Option<Vec<_>> = quads.collect();
        let quads = quads.ok_or_else(|| {
            wrong("mesh", "the penalty method needs quads, expected four corners in every face")
        })?;
        if scene.smoothness.of != SmoothnessOf::Surface {
            return Err(wrong(
                "smoothness.of",
                "the penalty method smooths positions, expected \"surface\"",
            ));
        }
        let gliding = matches!(scene.closeness.to, ClosenessTo::Surface | ClosenessTo::Target);
        if gliding && scene.weights.close > 0.0 {
            return Err(wrong(
                "closeness.to",
                "the penalty method keeps vertices close to points, expected \"rest\" or \"none\"",
            ));
        }
        let mut positions = scene.start(mesh).to_vec();
        let mut fixed = vec![false; positions.len()];
        for (k, handle) in scene.handles.iter().enumerate() {
            if handle.hold != Hold::Fixed {
                return Err(wrong(
                    &format!("handles[{k}]"),
                    "the penalty method has no soft handles, expected \"fixed\": true",
                ));
            }
            for (k, &v) in handle.vertices.iter().enumerate() {
                fixed[v as usize] = true;
                let target = handle.targets.as_ref().map(|targets| targets[k]);
                positions[v as usize] = target.unwrap_or(mesh.positions[v as usize]);
            }
        }
        let close = if scene.closeness.to == ClosenessTo::Rest { scene.weights.close } else { 0.0 };
        let state = GaussNewton::new(
            &mesh.positions,
            &positions,
            quads,
            Laplacian::uniform(&topology),
            fixed,
            [close, scene.weights.smooth],
        );
        let continuation = Continuation::new(START * scene.weights.shape, ERROR);
        Ok(Penalised { state, measured: Measured::new(mesh, &topology), continuation })
    }
}

impl Method for Penalised {
    fn step(&mut self) -> Result<Step, Error> {
        let weight = self.continuation.weight;
        let moved = self.state.step(weight);
        let total = self.state.total(weight, self.state.penalties());
        let error = self.measured.error(&self.state.positions);
        if self.continuation.record(total, error, !moved) {
            return Ok(Step::Reached);
        }
        // Stalled only if the weight did not change either.
        let stuck = !moved && self.continuation.weight == weight;
        Ok(if stuck { Step::Stalled } else { Step::Going })
    }

    fn values(&self) -> Vec<f64> {
        self.measured.values(self.state.penalties().smooth, &self.state.positions)
    }
}

/// Relative decrease of the total over [`SPAN`] iterations below which it counts as settled.
const SETTLED: f64 = 1e-4;
/// Number of iterations over which the decrease is measured.
const SPAN: usize = 5;
/// Maximum number of iterations at one weight.
const MOST_ITERATIONS: usize = 60;
/// Relative tolerance of the circularity error.
const TOLERANCE: f64 = 0.05;
/// Largest factor by which the weight changes at once.
const GREATEST_CHANGE: f64 = 4.0;

/// The weight, and the totals of the iterations at this weight.
pub(super) struct Continuation {
    pub(super) weight: f64,
    /// The required circularity error.
    target: f64,
    totals: Vec<f64>,
}

impl Continuation {
    pub(super) fn new(weight: f64, target: f64) -> Continuation {
        Continuation { weight, target, totals: Vec::new() }
    }

    /// Records an iteration, or a failed one (`stuck`): the total at this weight, and the
    /// circularity error. Returns true once the total has settled at the required error; otherwise
    /// it may have changed the weight.
    pub(super) fn record(&mut self, total: f64, error: f64, stuck: bool) -> bool {
        self.totals.push(total);
        let n = self.totals.len();
        let falls_no_more =
            n > SPAN && self.totals[n - 1 - SPAN] - total <= SETTLED * self.totals[n - 1 - SPAN];
        if !(stuck || falls_no_more || n >= MOST_ITERATIONS) {
            return false;
        }
        self.totals.clear();
        let ratio = error / self.target;
        // The remaining distance decreases as the weight grows, and the error is its square.
        self.weight *= ratio.sqrt().clamp(1.0 / GREATEST_CHANGE, GREATEST_CHANGE);
        (ratio - 1.0).abs() <= TOLERANCE
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// It was relative to the faces alone, and a guide line could be the shortest edge.
    #[test]
    fn guide_lines_count_in_the_scale_of_the_error_and_not_among_the_edges() {
        let mesh = Mesh {
            positions: vec![
                [0.0, 0.0, 0.0],
                [2.0, 0.0, 0.0],
                [3.0, 1.0, 0.0],
                [0.0, 1.0, 0.0],
                [9.0, 0.0, 0.0],
                [9.0, 0.1, 0.0],
            ],
            faces: [[0, 1, 2, 3]].iter().collect(),
            curves: [[4, 5]].iter().collect(),
            ..Mesh::default()
        };
        let at = &mesh.positions;
        let values = Measured::new(&mesh, &Topology::new(&mesh)).values(0.0, at);
        let error = Measures::new(at, &mesh.faces, mesh.size()).circularity.e_c_mean;
        assert_eq!(values, [0.0, error, 1.0]);
    }
}
