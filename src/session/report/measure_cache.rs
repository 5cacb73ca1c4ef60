//! Measures of the current shape. As long as the shape stays, it is not measured again: a frame, a
//! colour and a list ask for the same numbers.

use crate::math::Vec3;
use crate::mesh::{Measures, Point, Surface};
use crate::session::state::{RestMesh, SolvedScene};
use crate::solve::clock;
use std::cell::RefCell;
use std::rc::Rc;

/// The measures of the shape that was last asked for.
#[derive(Default)]
pub(crate) struct MeasureCache(RefCell<Measured>);

#[derive(Default)]
struct Measured {
    /// The shape, `#V by 3`.
    positions: Option<Rc<[Point]>>,
    measures: Option<Rc<Measures>>,
    /// Those that were taken last, of this shape or one before, and when, in seconds.
    recent: Option<(Rc<Measures>, f64)>,
    /// `#V`
    surface_distances: Option<Rc<[f64]>>,
    /// What others measured of this shape, by name.
    told: Vec<(String, f64)>,
    /// The triangle of the original that was closest to each vertex last, `#V`; none before the first search.
    closest: Vec<u32>,
}

impl MeasureCache {
    /// Planarity and circularity of the faces as they are now.
    pub(crate) fn measures(&self, scene: &SolvedScene, rest: &RestMesh) -> Rc<Measures> {
        let mut measured = self.0.borrow_mut();
        measured.begin(scene.positions());
        let Measured { measures, recent, .. } = &mut *measured;
        let measure = || {
            let new = Measures::new(scene.positions(), &rest.mesh().faces, rest.diameter());
            let new = Rc::new(new);
            *recent = Some((Rc::clone(&new), clock::now()));
            new
        };
        Rc::clone(measures.get_or_insert_with(measure))
    }

    /// [`MeasureCache::measures`] at most `seconds` old: on large meshes measuring takes longer than an
    /// iteration.
    pub(crate) fn recent_measures(
        &self,
        scene: &SolvedScene,
        rest: &RestMesh,
        seconds: f64,
    ) -> Rc<Measures> {
        let recent = self.0.borrow().recent.clone();
        let recent = recent.filter(|(_, time)| clock::now() < time + seconds);
        recent.map_or_else(|| self.measures(scene, rest), |(measures, _)| measures)
    }

    /// The distance of each vertex to the surface of the model that was opened, `#V`, in its unit.
    pub(crate) fn surface_distances(&self, scene: &SolvedScene, rest: &RestMesh) -> Rc<[f64]> {
        let mut measured = self.0.borrow_mut();
        measured.begin(scene.positions());
        let Measured { surface_distances, closest, .. } = &mut *measured;
        let search = || {
            let (surface, centre) = scene.solver().rest_surface(rest.mesh());
            distances(&surface, centre, scene.positions(), closest)
        };
        Rc::clone(surface_distances.get_or_insert_with(search))
    }

    /// Keeps what others measured of the current shape, by name.
    pub(crate) fn tell(&self, scene: &SolvedScene, values: Vec<(String, f64)>) {
        let mut measured = self.0.borrow_mut();
        measured.begin(scene.positions());
        measured.told = values;
    }

    /// What others measured of the current shape; none where they did not.
    pub(crate) fn told(&self, scene: &SolvedScene, name: &str) -> Option<f64> {
        let mut measured = self.0.borrow_mut();
        measured.begin(scene.positions());
        measured.told.iter().find(|(own, _)| own == name).map(|(_, value)| *value)
    }
}

impl Measured {
    /// Forgets what was measured of another shape; where vertices were closest is a start for this one.
    fn begin(&mut self, positions: &Rc<[Point]>) {
        let is_same = |known: &Rc<[Point]>| Rc::ptr_eq(known, positions) || known == positions;
        if !self.positions.as_ref().is_some_and(is_same) {
            (self.measures, self.surface_distances) = (None, None);
            self.told.clear();
        }
        self.positions = Some(Rc::clone(positions));
    }
}

/// The distance of each vertex of the original to its own surface, which is rounding: `#V`, in its unit.
pub(super) fn rest_surface_distances(scene: &SolvedScene, rest: &RestMesh) -> Rc<[f64]> {
    let (surface, centre) = scene.solver().rest_surface(rest.mesh());
    distances(&surface, centre, rest.positions(), &mut Vec::new())
}

/// The distance of each point to the surface, whose coordinates are relative to `centre`; `closest` has
/// where the last search for each ended.
fn distances(
    surface: &Surface,
    centre: Point,
    points: &[Point],
    closest: &mut Vec<u32>,
) -> Rc<[f64]> {
    let is_first = closest.is_empty();
    closest.resize(points.len(), Surface::COLD);
    let mut before = Surface::COLD;
    let places = points.iter().zip(closest);
    let distance = |(point, closest): (&Point, &mut u32)| {
        if is_first {
            // Neighbours in the file are mostly neighbours in space.
            *closest = before;
        }
        let point = std::array::from_fn(|i| point[i] - centre[i]);
        let foot = surface.closest(point, closest);
        before = *closest;
        (Vec3::from(foot) - Vec3::from(point)).length()
    };
    places.map(distance).collect()
}
