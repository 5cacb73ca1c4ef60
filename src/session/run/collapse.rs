//! Collapse of a shape: a run that shrinks the model to a dot, crushes its faces, or carries it away.
//!
//! The shape at the end is compared with that at the beginning and with the original: one that goes
//! back to the original has not collapsed, nor one that was so before. Runs that go on with each other
//! have one beginning.

use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{Mesh, Point, Ragged, Surface, at_vertices, diagonal};
use crate::scene::Scene;
use crate::session::state::{RestMesh, SceneState, SolvedScene, same_positions, same_problem};
use std::fmt;
use std::rc::Rc;

/// Smallest allowed diagonal of the bounding box, relative to that before.
const LEAST_DIAGONAL: f64 = 0.5;
/// Largest allowed displacement of a vertex, relative to the size of the shape before.
const FARTHEST: f64 = 0.25;
/// A face with less than this fraction of its area before has lost it.
const LOST: f64 = 0.05;
/// Largest allowed fraction of faces that lose their area. With the settings of a newly opened mesh
/// it is less than one in a hundred, on real meshes with circular panels.
const MOST_LOST: f64 = 0.1;
/// Length by which a shape may be smaller or farther away than another one, relative to the largest
/// distance from that one at which a vertex is asked to be.
const PER_PULL: f64 = 2.0;

/// A collapse of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collapse {
    /// Its kind.
    pub reason: CollapseReason,
    /// Shrunk: the remaining fraction of the diagonal. Area: the fraction of faces that lost their
    /// area. Moved: the largest displacement of a vertex, relative to the size of the shape before.
    pub amount: f64,
}

/// Written to end a sentence: "the mesh shrank to a dot".
impl fmt::Display for Collapse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = (100.0 * self.amount).round();
        match self.reason {
            CollapseReason::Shrunk if self.amount < 0.01 => f.write_str("the mesh shrank to a dot"),
            CollapseReason::Shrunk => write!(f, "the mesh shrank to {percent} % of its size"),
            CollapseReason::Area => write!(f, "{percent} % of the faces lost their area"),
            CollapseReason::Moved => {
                write!(f, "vertices moved by up to {percent} % of the size of the mesh")
            }
        }
    }
}

/// The kind of a collapse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CollapseReason {
    /// The whole mesh has shrunk.
    Shrunk,
    /// Faces have lost their area.
    Area,
    /// Vertices have moved far away.
    Moved,
}

/// How a run has ended, of the state that it led to.
pub(crate) struct LastRun {
    pub(crate) collapse: Option<Collapse>,
    /// The shape that its end was compared with, `#V by 3`.
    start: Rc<[Point]>,
    end: SceneState,
}

impl LastRun {
    /// Records a run that has ended, compared with the shape `start`.
    pub(crate) fn new(
        start: Rc<[Point]>,
        scene: &SolvedScene,
        collapse: Option<Collapse>,
    ) -> LastRun {
        LastRun { collapse, start, end: scene.state() }
    }

    /// Returns the shape that a run from its end, with this `document`, is compared with, if it goes on
    /// with this run: with the same problem, or after a collapse. So a collapse over several runs or
    /// single steps is one as well.
    pub(crate) fn start_of_next(&self, document: &Scene) -> Option<Rc<[Point]>> {
        let goes_on = self.collapse.is_some() || same_problem(&self.end.document, document);
        goes_on.then(|| Rc::clone(&self.start))
    }

    /// Whether it ended with the current shape of the scene.
    pub(crate) fn is_of(&self, scene: &SolvedScene) -> bool {
        same_positions(&self.end.positions, scene.positions())
    }
}

/// Returns how the current shape has collapsed since the shape `start` (`#V by 3`), if it has.
pub(crate) fn collapse_since(
    start: &[Point],
    scene: &SolvedScene,
    rest: &RestMesh,
) -> Option<Collapse> {
    let document = scene.document();
    let original = document.variants.design_positions().unwrap_or(rest.positions());
    let target = other_surface(document);
    let before = Before {
        shapes: [start, original].into_iter().chain(document.pose_positions()).collect(),
        mesh: rest.mesh(),
        target: target.map(|target| extent_of(&target.positions, target)),
        by_handles: PER_PULL * pull_of_handles(scene, start),
    };
    before.collapse(scene.positions(), |shape| PER_PULL * pull(scene, shape))
}

/// The other surface that vertices are kept close to, if there is one.
fn other_surface(document: &Scene) -> Option<&Rc<Mesh>> {
    document.closeness.target_mesh().filter(|_| document.weights.close > 0.0)
}

/// Returns the largest distance from the `shape` (`#V by 3`) at which handles ask a vertex to be.
fn pull_of_handles(scene: &SolvedScene, shape: &[Point]) -> f64 {
    let handles = scene.handles().iter();
    handles.map(|it| far(shape[it.vertex as usize], it.target)).fold(0.0, f64::max)
}

/// The same by handles, by another pose, and by closeness to another surface.
fn pull(scene: &SolvedScene, shape: &[Point]) -> f64 {
    let mut pull = pull_of_handles(scene, shape);
    if let Some(pose) = scene.document().pose_positions() {
        pull = shape.iter().zip(pose).map(|(&from, &to)| far(from, to)).fold(pull, f64::max);
    }
    let target = other_surface(scene.document());
    if let Some((surface, centre)) = target.and_then(|it| scene.solver().target_surface(it)) {
        let mut hint = Surface::NO_HINT;
        let mut distance = |point: Point| {
            let point = (Vec3::from(point) - Vec3::from(centre)).into();
            far(point, surface.closest(point, &mut hint))
        };
        pull = shape.iter().map(|&point| distance(point)).fold(pull, f64::max);
    }
    pull
}

fn far(from: Point, to: Point) -> f64 {
    (Vec3::from(from) - Vec3::from(to)).length()
}

/// The diagonal of what can move of a shape: faces that are left as they are stay where they are.
fn extent_of(positions: &[Point], mesh: &Mesh) -> f64 {
    match mesh.faces.is_empty() {
        true => diagonal(&mesh.body_of(positions)),
        false => diagonal(&at_vertices(positions, &[mesh.faces.indices()])),
    }
}

/// What a shape is compared with: it has collapsed if it has relative to each of these.
struct Before<'a> {
    /// The shape at the beginning, the original, and another pose; each `#V by 3`.
    shapes: Vec<&'a [Point]>,
    mesh: &'a Mesh,
    /// The diagonal of another surface that it is kept close to.
    target: Option<f64>,
    /// Length by which handles may make it smaller than the shape at the beginning.
    by_handles: f64,
}

impl Before<'_> {
    /// Returns how the shape `now` (`#V by 3`) has collapsed, if it has. `farther` returns the length by
    /// which vertices may be farther away from a shape.
    fn collapse(&self, now: &[Point], farther: impl Fn(&[Point]) -> f64) -> Option<Collapse> {
        let Before { shapes, mesh, .. } = self;
        let extents: Vec<f64> = shapes.iter().map(|shape| extent_of(shape, mesh)).collect();
        let extent = extent_of(now, mesh);
        let all = || extents.iter().copied().chain(self.target);
        // In the order of the shapes: handles have moved since the beginning.
        let smaller = || std::iter::once(self.by_handles).chain(std::iter::repeat(0.0));
        if all().zip(smaller()).all(|(before, slack)| extent + slack < LEAST_DIAGONAL * before) {
            let amount = extent / all().fold(f64::INFINITY, f64::min);
            return Some(Collapse { reason: CollapseReason::Shrunk, amount });
        }
        let areas_before: Vec<Vec<f64>> =
            shapes.iter().map(|shape| areas(shape, &mesh.faces).collect()).collect();
        let is_lost = |&(face, now): &(usize, f64)| {
            let mut before = areas_before.iter().zip(smaller());
            before.all(|(areas, slack)| now.sqrt() + slack < (LOST * areas[face]).sqrt())
        };
        let lost = areas(now, &mesh.faces).enumerate().filter(is_lost).count();
        let lost = lost as f64 / mesh.faces.len().max(1) as f64;
        if lost > MOST_LOST {
            return Some(Collapse { reason: CollapseReason::Area, amount: lost });
        }
        let farthest = |slack: &[f64]| {
            let beyond = |(v, &now): (usize, &Point)| {
                let shapes = shapes.iter().zip(slack);
                shapes
                    .map(|(shape, slack)| far(now, shape[v]) - slack)
                    .fold(f64::INFINITY, f64::min)
            };
            now.iter().enumerate().map(beyond).fold(0.0, f64::max)
        };
        // The shape before may be a dot, after an undo.
        let size = extents.iter().copied().fold(0.0, f64::max);
        let moved = farthest(&vec![0.0; shapes.len()]);
        // Distances to another surface are left out where nothing is far away.
        let is_far = moved > FARTHEST * size && {
            let slack: Vec<f64> = shapes.iter().map(|shape| farther(shape)).collect();
            farthest(&slack) > FARTHEST * size
        };
        is_far.then(|| Collapse { reason: CollapseReason::Moved, amount: moved / size })
    }
}

/// Lengths of the area vectors of the faces, `#F`.
fn areas(positions: &[Point], faces: &Ragged) -> impl Iterator<Item = f64> {
    let at = |&v: &u32| Vec3::from(positions[v as usize]);
    faces.iter().map(move |face| 0.5 * twice_vector_area(face.iter().map(at)).length())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_collapse_is_of_the_start_and_of_the_original_and_beyond_what_was_asked() {
        let strip = |place: fn(f64) -> f64| -> Vec<Point> {
            let columns = (0..=10).map(|k| place(f64::from(k)));
            columns.flat_map(|x| [[x, 0.0, 0.0], [x, 1.0, 0.0]]).collect()
        };
        let original = strip(|x| x);
        let faces = (0..10).map(|k| [2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1]).collect();
        let mesh = Mesh { positions: original.clone(), faces, ..Mesh::default() };
        for (now, reason) in [
            (strip(|x| 0.1 * x), CollapseReason::Shrunk),
            (strip(|x| x.min(7.0)), CollapseReason::Area),
            (strip(|x| x + 5.0), CollapseReason::Moved),
        ] {
            let found = |now: &[Point], start: &[Point], by_handles, farther: f64| {
                let (shapes, mesh) = (vec![start, &original], &mesh);
                let before = Before { shapes, mesh, target: None, by_handles };
                before.collapse(now, |_| farther).map(|found| found.reason)
            };
            assert_eq!(found(&now, &original, 0.0, 0.0), Some(reason));
            // A shape that was so, or that goes back to the original, has not collapsed.
            assert_eq!(found(&now, &now, 0.0, 0.0), None);
            assert_eq!(found(&original, &now, 0.0, 0.0), None);
            // Handles that are moved ask for a smaller shape, whatever may be far away does not.
            let asked = found(&now, &original, 10.0, 10.0);
            assert_eq!(asked, None);
            let is_moved = reason == CollapseReason::Moved;
            assert_eq!(found(&now, &original, 0.0, 10.0), (!is_moved).then_some(reason));
        }
    }
}
