//! Collapse of a shape: a run that shrinks the model to a dot, crushes its faces, or carries it away.
//!
//! The shape at the end is compared with that at the beginning and with the original: one that goes
//! back to the original has not collapsed, nor one that was so before.

use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{Mesh, Point, Ragged, Surface, at_vertices, diagonal};
use crate::session::state::{RestMesh, SolvedScene};
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
/// Length by which a shape may be smaller or farther away, relative to the largest distance from the
/// original at which a vertex is asked to be.
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

/// A shape that a run has collapsed.
pub(crate) struct Collapsed {
    pub(crate) collapse: Collapse,
    /// The shapes at the beginning and at the end, `#V by 3`.
    start: Rc<[Point]>,
    shape: Rc<[Point]>,
}

impl Collapsed {
    /// Returns how a run that began at the shape `start` (`#V by 3`) has collapsed the current one, if
    /// it has. Where the run `before` had collapsed that shape, it counts as continued.
    pub(crate) fn since(
        start: &Rc<[Point]>,
        before: Option<Collapsed>,
        scene: &SolvedScene,
        rest: &RestMesh,
    ) -> Option<Collapsed> {
        let before = before.filter(|before| Rc::ptr_eq(&before.shape, start));
        let start = before.map_or_else(|| Rc::clone(start), |before| before.start);
        let design = scene.document().variants.design_positions();
        let (original, shape) = (design.unwrap_or(rest.positions()), Rc::clone(scene.positions()));
        let compared = |slack| collapse(&shape, [&start, original], rest.mesh(), slack);
        // A search for the distance to another surface is left out where nothing has collapsed.
        compared(0.0)?;
        let collapse = compared(PER_PULL * pull(scene, original))?;
        Some(Collapsed { collapse, start, shape })
    }

    /// Whether this is the current shape of the scene.
    pub(crate) fn is_of(&self, scene: &SolvedScene) -> bool {
        Rc::ptr_eq(&self.shape, scene.positions())
    }
}

/// Returns the largest distance from the `original` (`#V by 3`) at which a vertex is asked to be: by a
/// handle, by another pose, or by closeness to another surface.
fn pull(scene: &SolvedScene, original: &[Point]) -> f64 {
    let far = |from: Point, to: Point| (Vec3::from(from) - Vec3::from(to)).length();
    let document = scene.document();
    let handles = scene.handles().iter();
    let mut pull =
        handles.map(|it| far(original[it.vertex as usize], it.target)).fold(0.0, f64::max);
    if let Some(pose) = document.pose_positions() {
        pull = original.iter().zip(pose).map(|(&from, &to)| far(from, to)).fold(pull, f64::max);
    }
    let is_close = document.weights.close > 0.0;
    if let Some(target) = document.closeness.target_mesh().filter(|_| is_close) {
        let surface = Surface::of_polygons(&target.positions, target);
        let mut hint = Surface::NO_HINT;
        let distances = original.iter().map(|&from| far(from, surface.closest(from, &mut hint)));
        pull = distances.fold(pull, f64::max);
    }
    pull
}

/// The diagonal of what can move of a shape: faces that are left as they are stay where they are.
fn extent_of(positions: &[Point], mesh: &Mesh) -> f64 {
    match mesh.faces.is_empty() {
        true => diagonal(&mesh.body_of(positions)),
        false => diagonal(&at_vertices(positions, &[mesh.faces.indices()])),
    }
}

/// Returns how the shape `now` has collapsed, if it has, compared with both shapes `before`; all
/// `#V by 3`. The length `slack` is allowed besides.
fn collapse(now: &[Point], before: [&[Point]; 2], mesh: &Mesh, slack: f64) -> Option<Collapse> {
    let extents = before.map(|shape| extent_of(shape, mesh));
    let (extent, least) = (extent_of(now, mesh), extents[0].min(extents[1]));
    if extent + slack < LEAST_DIAGONAL * least {
        return Some(Collapse { reason: CollapseReason::Shrunk, amount: extent / least });
    }
    let is_lost =
        |(now, (a, b)): (f64, (f64, f64))| now.sqrt() + slack < (LOST * f64::min(a, b)).sqrt();
    let [a, b] = before.map(|shape| areas(shape, &mesh.faces));
    let lost = areas(now, &mesh.faces).zip(a.zip(b)).filter(|&faces| is_lost(faces)).count();
    let lost = lost as f64 / mesh.faces.len().max(1) as f64;
    if lost > MOST_LOST {
        return Some(Collapse { reason: CollapseReason::Area, amount: lost });
    }
    let [a, b] = before.map(|shape| {
        let pairs = now.iter().zip(shape);
        pairs.map(|(&now, &before)| (Vec3::from(now) - Vec3::from(before)).length_squared())
    });
    let farthest = a.zip(b).map(|(a, b)| a.min(b)).fold(0.0, f64::max).sqrt();
    // The shape before may be a dot, after an undo.
    let size = extents[0].max(extents[1]);
    (farthest > FARTHEST * size + slack)
        .then(|| Collapse { reason: CollapseReason::Moved, amount: farthest / size })
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
            let reason_of = |start: &[Point], slack: f64| {
                collapse(&now, [start, &original], &mesh, slack).map(|found| found.reason)
            };
            assert_eq!(reason_of(&original, 0.0), Some(reason));
            // A shape that was so, or that goes back to the original, has not collapsed.
            assert_eq!(reason_of(&now, 0.0), None);
            assert_eq!(collapse(&original, [&now, &original], &mesh, 0.0), None);
            assert_eq!(reason_of(&original, 10.0), None);
        }
    }
}
