//! The outcome of an attempt to meet hard constraints, and its grade: how good the shape is.

use super::shape_measure::{BendChange, ShapeMeasure};
use crate::math::{key_of_number, sort_by_number};
use serde::Serialize;

/// The level of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// It can be built as it is, and it is the design.
    Good,
    /// It can be built, but the design has changed, or some panels have a larger tolerance.
    Fair,
    /// It cannot be built, because requirements are not met or faces are folded; or nothing is left of
    /// the design: a curved surface became nearly flat, is far away, or lost much of its area.
    Poor,
}

/// Why a shape is not good.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "kebab-case")]
pub enum Flaw {
    /// Boundary vertices that lay on each other, without being joined, are apart.
    SeamOpened,
    /// Panels have a larger tolerance than required.
    Eased,
    /// Neighbouring faces meet at clearly larger angles.
    Rougher,
    /// They meet at less than half the angle.
    Flatter,
    /// The surface is far from the original.
    Away,
    /// The vertices are far from their rest positions, on a surface that is not.
    Moved,
    /// The boundary is far from the original boundary.
    OffBoundary,
    /// Edges are short.
    Short,
    /// The surface has lost area.
    Shrunk,
}

/// Largest distance of the surface of a good shape from the original, relative to the mean edge.
const AWAY: f64 = 0.2;
/// Largest distance of its boundary, relative to the mean edge.
const OFF_BOUNDARY: f64 = 0.2;
/// Largest mean distance of its vertices from their rest positions, relative to the mean edge.
const MOVED: f64 = 0.2;
/// Smallest ratio of an edge to its length at rest.
const SHORT: f64 = 0.2;
/// Largest fraction of the area that is lost.
const SHRUNK: f64 = 0.05;
/// Nothing is left of the design farther than this fraction of the size of the mesh, if that is more
/// than an edge.
const LOST_DISTANCE: f64 = 0.15;
/// Nothing is left of the design with more than this fraction of the area lost.
const MOST_SHRUNK: f64 = 0.25;

impl ShapeMeasure {
    /// The level of a shape whose requirements are met, some within a larger tolerance if `is_eased`,
    /// and its flaws, the gravest first; `edge` is the mean edge at rest.
    pub(crate) fn level(&self, is_eased: bool, edge: f64) -> (Level, Vec<Flaw>) {
        if !self.folded.is_empty() {
            return (Level::Poor, Vec::new());
        }
        let flaws = self.flaws(is_eased, edge);
        let is_away = flaws.contains(&Flaw::Away);
        let is_far = self.surface.max > edge.max(LOST_DISTANCE * self.size);
        let is_lost = is_far || self.bend.is_hardly_bent() || self.area_lost > MOST_SHRUNK;
        if is_away && is_lost {
            return (Level::Poor, flaws);
        }
        (if flaws.is_empty() { Level::Good } else { Level::Fair }, flaws)
    }

    /// The flaws of a shape whose requirements are met without folds, the gravest first; `edge` is
    /// the mean edge at rest.
    pub(crate) fn flaws(&self, is_eased: bool, edge: f64) -> Vec<Flaw> {
        let parts = self.parts(edge);
        let is_far = parts.iter().filter(|(_, part)| *part > 1.0);
        let mut far: Vec<(Flaw, f64)> = is_far.copied().collect();
        // The largest part first.
        sort_by_number(&mut far, |(_, part)| !key_of_number(*part));
        let eased = is_eased.then_some(Flaw::Eased);
        let bend = self.bend.change.map(|change| match change {
            BendChange::Rougher => Flaw::Rougher,
            BendChange::Flatter => Flaw::Flatter,
        });
        eased.into_iter().chain(bend).chain(far.into_iter().map(|(flaw, _)| flaw)).collect()
    }

    /// The measures relative to the limits of a good shape.
    fn parts(&self, edge: f64) -> [(Flaw, f64); 5] {
        let relative =
            |length: f64, limit: f64| if edge > 0.0 { length / (limit * edge) } else { 0.0 };
        // Where panels are on the surface that they were laid out on was nobody's design.
        let slid = if self.is_on_other { 0.0 } else { self.moved.mean };
        [
            (Flaw::Away, relative(self.surface.max, AWAY)),
            (Flaw::Moved, relative(slid, MOVED)),
            (Flaw::OffBoundary, relative(self.boundary, OFF_BOUNDARY)),
            (Flaw::Short, if self.shortest_edge < SHORT { 2.0 } else { 0.0 }),
            (Flaw::Shrunk, self.area_lost / SHRUNK),
        ]
    }

    /// A number that grows with the distance from the design: it is 1 at the limits of a good shape.
    pub(crate) fn distance(&self, edge: f64) -> f64 {
        self.parts(edge).iter().map(|(_, part)| *part).fold(0.0, f64::max)
    }

    /// The same, for the distance and the bend.
    pub(crate) fn change(&self, edge: f64) -> f64 {
        self.distance(edge).max(self.bend.relative())
    }
}

/// The outcome of an attempt.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    pub(crate) met: bool,
    /// Number of constraints that are not met, and the faces that they are on.
    pub(crate) misses: usize,
    pub(crate) missed: Vec<u32>,
    pub(crate) measure: ShapeMeasure,
    /// The energy of the soft terms, without the hard constraints.
    pub(crate) energy: f64,
    /// Iterations times vertices.
    pub(crate) work: u64,
}

impl Outcome {
    /// Whether the requirements are met without a fold.
    pub(crate) fn is_whole(&self) -> bool {
        self.met && self.measure.folded.is_empty()
    }

    /// Number of constraints that are not met and of folded faces.
    pub(crate) fn faults(&self) -> usize {
        self.misses + self.measure.folded.len()
    }

    /// The faces that are folded, or whose constraints are not met.
    pub(crate) fn resisting(&self) -> Vec<u32> {
        [&self.measure.folded[..], &self.missed].concat()
    }

    /// Whether the requirements are met without a fold, and the surface is neither rougher nor flatter
    /// than the original.
    pub(crate) fn keeps_design(&self) -> bool {
        self.is_whole() && self.measure.bend.change.is_none()
    }

    /// The level of the shape.
    pub(crate) fn level(&self, is_eased: bool, edge: f64) -> Level {
        if self.met { self.measure.level(is_eased, edge).0 } else { Level::Poor }
    }
}

#[cfg(test)]
impl Outcome {
    /// An outcome that is met and folds these faces.
    pub(super) fn of_test(folded: &[u32]) -> Outcome {
        use super::shape_measure::{Bend, SurfaceDistance};
        use crate::solve::Moved;
        let measure = ShapeMeasure {
            folded: folded.to_vec(),
            moved: Moved { max: 0.1, mean: 0.05 },
            surface: SurfaceDistance { rms: 0.01, max: 0.02 },
            is_on_other: false,
            boundary: 0.0,
            bend: Bend { rest: 4.0, now: 4.0, change: None },
            shortest_edge: 0.9,
            area_lost: 0.0,
            size: 10.0,
        };
        Outcome { met: true, misses: 0, missed: Vec::new(), measure, energy: 9.0, work: 1 }
    }
}

#[cfg(test)]
mod tests {
    use super::{BendChange, Flaw, Level, Outcome};

    #[test]
    fn a_shape_of_whose_design_nothing_is_left_is_poor() {
        // A pavilion became a sliver, and a hypar flat but for one corner: both were said to be fair.
        let edge = 1.0;
        let mut measure = Outcome::of_test(&[]).measure;
        measure.surface.max = 1.0;
        assert_eq!(measure.level(false, edge), (Level::Fair, vec![Flaw::Away]));
        measure.surface.max = 2.0;
        assert_eq!(measure.level(false, edge), (Level::Poor, vec![Flaw::Away]));
        // Less than an edge of a coarse mesh.
        assert_eq!(measure.level(false, 2.5).0, Level::Fair);
        // Where it is to be elsewhere, its place is not judged.
        assert_eq!(measure.level(false, f64::INFINITY).0, Level::Good);
        measure.surface.max = 1.0;
        measure.area_lost = 0.3;
        assert_eq!(measure.level(false, edge).0, Level::Poor);
        measure.area_lost = 0.0;
        (measure.bend.rest, measure.bend.now) = (5.0, 0.7);
        measure.bend.change = Some(BendChange::Flatter);
        assert_eq!(measure.level(false, edge), (Level::Poor, vec![Flaw::Flatter, Flaw::Away]));
    }
}
