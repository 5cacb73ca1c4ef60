//! The results that the gallery shows. `UPDATE=1 cargo test gallery` writes them;
//! `npm run pictures` calls it.

use crate::examples::solved::Run;
use serde::{Deserialize, Serialize};
use shape_up::generate::example::Example;
use shape_up::mesh::angle_histogram;

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/pictures/results.json");
/// Number of bins of the histograms of angles, each five degrees wide.
const BINS: usize = 36;

/// The results of an example.
#[derive(Serialize, Deserialize)]
pub(crate) struct Results {
    id: String,
    iterations: u32,
    /// The total energy at the start and at the end; none without constraints.
    #[serde(skip_serializing_if = "Option::is_none")]
    energy: Option<[f64; 2]>,
    /// Histograms of the angles at corners of faces, at rest and at the end, in bins of equal width
    /// from 0 to 180 degrees; only for scenes of squares.
    #[serde(skip_serializing_if = "Option::is_none")]
    angles: Option<[Vec<u32>; 2]>,
}

impl Results {
    pub(crate) fn of(example: &Example, run: &Run) -> Results {
        let [start, end] = [run.before.energy.initial, run.after.energy.last];
        let kinds = &run.scene.constraints;
        let squares = kinds.iter().any(|constraint| constraint.kind.info().id == "square");
        let histogram = |positions| angle_histogram(positions, &run.mesh.faces, BINS);
        Results {
            id: example.id.to_owned(),
            iterations: run.after.iterations,
            energy: (!kinds.is_empty()).then_some([start.total, end.total]),
            angles: squares.then(|| [&run.mesh.positions, &run.positions].map(|at| histogram(at))),
        }
    }

    /// Whether these agree with other results, up to rounding on another machine.
    fn agree(&self, other: &Results) -> bool {
        let is_near = |[[start, end], [other_start, other_end]]: [[f64; 2]; 2]| {
            // An energy may fall to nothing but rounding.
            let rounding = 1e-12 * start;
            (start - other_start).abs() <= 1e-6 * start
                && (end - other_end).abs() <= 1e-6 * end + rounding
        };
        let energies = [self.energy, other.energy];
        let angles = [&self.angles, &other.angles].map(|angles| angles.iter().flatten().flatten());
        let [own, others] = angles;
        self.id == other.id
            && self.iterations.abs_diff(other.iterations) <= 3
            && match energies {
                [Some(own), Some(others)] => is_near([own, others]),
                [own, others] => own == others,
            }
            && self.angles.is_some() == other.angles.is_some()
            && own.zip(others).map(|(a, b)| a.abs_diff(*b)).sum::<u32>() <= 4
    }
}

/// Fails if the gallery does not show these results of all examples, or writes them if asked to.
pub(crate) fn compare_with_gallery(found: &[Results]) {
    if std::env::var_os("UPDATE").is_some() {
        // A line for each example, so that changes are seen.
        let line = |result| serde_json::to_string(result).expect("numbers are finite");
        let text = format!("[\n{}\n]\n", found.iter().map(line).collect::<Vec<_>>().join(",\n"));
        std::fs::write(PATH, text).expect("the results can be written");
    }
    let text = std::fs::read_to_string(PATH).expect("there are results");
    let shown: Vec<Results> = serde_json::from_str(&text).expect("they can be read");
    assert_eq!(shown.len(), found.len(), "npm run pictures writes those of new examples");
    for (shown, found) in shown.iter().zip(found) {
        assert!(
            shown.agree(found),
            "{}: {} iterations and {:?} are shown, but found are {} and {:?}: npm run pictures",
            found.id,
            shown.iterations,
            shown.energy,
            found.iterations,
            found.energy,
        );
    }
}
