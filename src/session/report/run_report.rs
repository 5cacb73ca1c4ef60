//! The report of a solved scene.

use crate::constraint::describe;
use crate::mesh::{Circularity, Planarity};
use crate::scene::{Accelerator, ConstraintSpec, NamedEnum};
use crate::session::Session;
use crate::session::run::{ExactReport, TraceEntry, shortest_edge};
use crate::session::state::{Paired, SolvedScene};
use crate::solve::{Energy, IterateSeconds, Moved};
use crate::words::group_digits;
use serde::Serialize;
use std::collections::BTreeMap;
use std::num::NonZeroUsize;

/// The report of `shape-up solve --report`; the page shows it with the same words and units.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// `#V`
    pub vertices: usize,
    /// `#F`
    pub faces: usize,
    /// Number of enabled constraints by kind.
    pub constraints: BTreeMap<&'static str, usize>,
    /// Number of elements whose number of vertices does not fit their kind.
    pub skipped: usize,
    /// Rows of constraints that leave vertices free, because they have no partner at rest.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unpaired: Vec<Unpaired>,
    /// Unknowns of the linear system (x, y and z each), with the extra ones of big constraints.
    pub unknowns: usize,
    /// Nonzeros of `L`, including the diagonal.
    pub factor_nonzeros: usize,
    /// Iterations done.
    pub iterations: u32,
    /// `"tolerance"` or `"iterations"`.
    pub stopped_by: &'static str,
    /// The accelerator, in the words of the scene file.
    pub accelerator: &'static str,
    /// Vertices that were pinned because nothing holds their component.
    pub pinned: Vec<u32>,
    /// Energies of the input and of the current shape.
    pub energy: EnergyReport,
    /// Planarity of the faces.
    pub planarity: Planarity,
    /// Circularity of the faces.
    pub circularity: Circularity,
    /// Distances of the vertices from their rest positions.
    pub moved: Moved,
    /// The smallest ratio of an edge length to its rest length.
    pub shortest_edge: f64,
    /// Number of faces that are folded or dented but were not at rest, if there are any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub folded: Option<NonZeroUsize>,
    /// How well hard constraints are met, if there are any and they were met.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exact: Option<ExactReport>,
    /// Time by stage.
    pub seconds: Seconds,
    /// Every iteration, if a trace was requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trace: Option<Vec<TraceEntry>>,
}

/// A row of constraints on pairs of vertices, some of which have no partner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Unpaired {
    /// Index of the row in the scene.
    pub constraint: usize,
    /// Number of vertices with a partner.
    #[serde(flatten)]
    pub paired: Paired,
}

impl Unpaired {
    /// Returns the enabled rows of which some vertices have no partner.
    fn all(scene: &SolvedScene) -> impl Iterator<Item = Unpaired> {
        let rows = scene.rows().iter().enumerate().filter(|(_, row)| row.enabled);
        rows.filter_map(|(constraint, row)| {
            let paired = row.paired.filter(|paired| paired.vertices < paired.of)?;
            Some(Unpaired { constraint, paired })
        })
    }

    /// Says for each of these rows how many vertices have a partner.
    fn words(scene: &SolvedScene) -> Vec<String> {
        let specs = &scene.document().constraints;
        let words = |Unpaired { constraint, paired: Paired { vertices, of } }| {
            let spec: &ConstraintSpec = &specs[constraint];
            let (what, of) =
                (format!("{} on {}", spec.label(), describe(&spec.on)), group_digits(of));
            match vertices {
                0 => format!(
                    "{what}: none of the {of} vertices has a partner among the others, so it does nothing. \
                     Check the direction of its mirror or axis."
                ),
                some => format!(
                    "{what}: {} of {of} vertices {} a partner; the others are free.",
                    group_digits(some),
                    if some == 1 { "has" } else { "have" }
                ),
            }
        };
        Unpaired::all(scene).map(words).collect()
    }
}

/// Energies of the input and of the current shape.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct EnergyReport {
    /// Of the input.
    pub initial: Energy,
    /// Of the current shape.
    #[serde(rename = "final")]
    pub last: Energy,
}

/// Time by stage, in seconds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Seconds {
    /// Reading the files.
    pub load: f64,
    /// Assembling the normal matrix.
    pub assemble: f64,
    /// Computing the elimination order.
    pub order: f64,
    /// Factoring the matrix.
    pub factor: f64,
    /// All iterations.
    pub iterate: f64,
    /// All iterations by part.
    pub parts: IterateSeconds,
}

impl Session {
    /// Returns the report on the current state.
    pub fn report(&self) -> Report {
        let Session { scene, rest, progress, .. } = self;
        let measures = self.measures();
        // The steps that meet hard constraints are not iterations.
        let has_converged =
            scene.solver().converged() || self.met_here().is_some_and(|met| met.converged);
        let converged = has_converged && self.collapse().is_none();
        let mut constraints = BTreeMap::new();
        let mut skipped = 0;
        for row in scene.rows().iter().filter(|row| row.enabled) {
            *constraints.entry(row.constraints.kind.info().id).or_insert(0) +=
                row.constraints.members.len();
            skipped += row.skipped;
        }
        let solver = scene.solver();
        let set_up = solver.set_up_seconds();
        let settings = &scene.document().solver;
        // With a window of 0, the accelerator is the plain iteration.
        let accelerator =
            if settings.window == 0 { Accelerator::None } else { settings.accelerator };
        Report {
            vertices: rest.positions().len(),
            faces: rest.mesh().faces.len(),
            constraints,
            skipped,
            unpaired: Unpaired::all(scene).collect(),
            unknowns: solver.system().unknowns(),
            factor_nonzeros: solver.system().factor_nonzeros(),
            iterations: progress.iteration(),
            stopped_by: if converged { "tolerance" } else { "iterations" },
            accelerator: accelerator.word(),
            pinned: solver.pinned().to_vec(),
            energy: EnergyReport { initial: progress.initial(), last: solver.energy() },
            planarity: measures.planarity,
            circularity: measures.circularity,
            moved: rest.moved_by(scene.positions()),
            shortest_edge: shortest_edge(scene.positions(), rest),
            folded: NonZeroUsize::new(rest.folded_by(scene.positions()).len()),
            exact: self.exact(),
            seconds: Seconds {
                load: progress.load_seconds,
                assemble: set_up.assemble,
                order: set_up.order,
                factor: set_up.factor,
                iterate: solver.iterate_seconds().total(),
                parts: solver.iterate_seconds(),
            },
            trace: progress.trace().map(<[TraceEntry]>::to_vec),
        }
    }

    /// Says for each constraint on pairs of vertices, some of which have no partner, how many have one.
    pub fn unpaired_words(&self) -> Vec<String> {
        Unpaired::words(&self.scene)
    }
}
