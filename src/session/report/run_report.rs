//! The report of a solved scene.

use super::moved::{moved, shortest_edge};
use crate::mesh::{Circularity, Measures, Planarity};
use crate::scene::{Accelerator, NamedEnum};
use crate::session::run::{ExactReport, Progress, TraceEntry};
use crate::session::state::{Paired, RestMesh, SolvedScene};
use crate::solve::{Energy, IterateSeconds, Moved};
use serde::Serialize;
use std::collections::BTreeMap;
use std::num::NonZeroUsize;

/// The report of `shape-up solve --report`, which the page shows in the same words and units.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// `#V`
    pub vertices: usize,
    /// `#F`
    pub faces: usize,
    /// Enabled constraints by kind.
    pub constraints: BTreeMap<&'static str, usize>,
    /// Elements whose number of vertices does not fit their kind.
    pub skipped: usize,
    /// Rows of constraints that leave vertices free, as these have no partner at rest.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unpaired: Vec<Unpaired>,
    /// Unknowns of the linear system, the extra ones of big constraints included; each is x, y and z.
    pub unknowns: usize,
    /// Nonzeros of `L` with its diagonal.
    pub factor_nonzeros: usize,
    /// Iterations done.
    pub iterations: u32,
    /// `"tolerance"` or `"iterations"`.
    pub stopped_by: &'static str,
    /// How steps were accelerated, in the words of the scene file.
    pub accelerator: &'static str,
    /// Vertices pinned because nothing holds their part.
    pub pinned: Vec<u32>,
    /// Energies at the input and now.
    pub energy: EnergyReport,
    /// Planarity of the faces.
    pub planarity: Planarity,
    /// Circularity of the faces.
    pub circularity: Circularity,
    /// How far the vertices are from their rest positions.
    pub moved: Moved,
    /// The least length of an edge as a part of its length at rest.
    pub shortest_edge: f64,
    /// How many faces are folded or dented and are not at rest, if there are any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub folded: Option<NonZeroUsize>,
    /// How well hard constraints are met, where there are some and they were.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exact: Option<ExactReport>,
    /// Where the time went.
    pub seconds: Seconds,
    /// Every iteration, when a trace was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trace: Option<Vec<TraceEntry>>,
}

/// A row of constraints that acts on vertices in pairs, and not all of them have a partner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Unpaired {
    /// Which row of the scene.
    pub constraint: usize,
    /// How many have a partner.
    #[serde(flatten)]
    pub paired: Paired,
}

/// Energies at the input and now.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct EnergyReport {
    /// At the input.
    pub initial: Energy,
    /// Now.
    #[serde(rename = "final")]
    pub last: Energy,
}

/// Seconds by stage.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Seconds {
    /// Reading the files.
    pub load: f64,
    /// The normal matrix.
    pub assemble: f64,
    /// The order of elimination.
    pub order: f64,
    /// The factor.
    pub factor: f64,
    /// All iterations.
    pub iterate: f64,
    /// All iterations by part.
    pub parts: IterateSeconds,
}

impl Report {
    /// The report as of now; `collapsed` says whether the shape has.
    pub(crate) fn of(
        scene: &SolvedScene,
        rest: &RestMesh,
        progress: &Progress,
        measures: &Measures,
        collapsed: bool,
        exact: Option<ExactReport>,
    ) -> Report {
        let mut constraints = BTreeMap::new();
        let mut skipped = 0;
        let mut unpaired = Vec::new();
        for (constraint, row) in scene.rows().iter().enumerate().filter(|(_, row)| row.enabled) {
            *constraints.entry(row.constraints.kind.info().id).or_insert(0) +=
                row.constraints.members.len();
            skipped += row.skipped;
            let paired = row.paired.filter(|paired| paired.vertices < paired.of);
            unpaired.extend(paired.map(|paired| Unpaired { constraint, paired }));
        }
        let solver = scene.solver();
        let set_up = solver.set_up_seconds();
        let settings = &scene.document().solver;
        // Without steps to learn from there is nothing but the plain iteration.
        let accelerator =
            if settings.window == 0 { Accelerator::None } else { settings.accelerator };
        let converged = solver.converged() && !collapsed;
        Report {
            vertices: rest.positions().len(),
            faces: rest.mesh().faces.len(),
            constraints,
            skipped,
            unpaired,
            unknowns: solver.system().unknowns(),
            factor_nonzeros: solver.system().factor_nonzeros(),
            iterations: progress.iteration(),
            stopped_by: if converged { "tolerance" } else { "iterations" },
            accelerator: accelerator.word(),
            pinned: solver.pinned().to_vec(),
            energy: EnergyReport { initial: progress.initial(), last: solver.energy() },
            planarity: measures.planarity,
            circularity: measures.circularity,
            moved: moved(scene, rest),
            shortest_edge: shortest_edge(scene, rest),
            folded: NonZeroUsize::new(rest.folded_by(scene.positions()).len()),
            exact,
            seconds: Seconds {
                load: progress.load_seconds(),
                assemble: set_up.assemble,
                order: set_up.order,
                factor: set_up.factor,
                iterate: solver.iterate_seconds().total(),
                parts: solver.iterate_seconds(),
            },
            trace: progress.trace().map(<[TraceEntry]>::to_vec),
        }
    }
}
