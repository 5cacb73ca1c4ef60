//! Cache of the measures of the current shape, because a frame, a colouring and a list all use
//! them.

use crate::math::Vec3;
use crate::mesh::{Measures, Mesh, Point, Surface};
use crate::scene::{BuildSettings, Scene};
use crate::session::run::ShapeMeasure;
use crate::session::state::{RestMesh, SolvedScene};
use crate::solve::clock;
use std::cell::RefCell;
use std::rc::Rc;

/// The measures of the last measured shape.
#[derive(Default)]
pub(crate) struct MeasureCache(RefCell<Measured>);

#[derive(Default)]
struct Measured {
    /// The shape, `#V by 3`.
    positions: Option<Rc<[Point]>>,
    /// The other surface that it was measured against, if it is close to one.
    target: Option<Rc<Mesh>>,
    measures: Option<Rc<Measures>>,
    /// The last measures, of this or an earlier shape, and their time in seconds.
    recent: Option<(Rc<Measures>, f64)>,
    /// The shape against the original.
    shape: Option<Rc<ShapeMeasure>>,
    /// Distance of each vertex to the original surface, `#V`.
    surface_distances: Option<Rc<[f64]>>,
    /// Numbers of the build of this shape, which were computed elsewhere.
    build: Option<BuildNumbers>,
    /// The original triangle last closest to each vertex, `#V`; empty before the first search.
    closest: Vec<u32>,
}

/// Numbers of a build, with what they depend on beside the shape.
struct BuildNumbers {
    settings: Option<Box<BuildSettings>>,
    units: String,
    /// By name.
    values: Vec<(String, f64)>,
}

impl BuildNumbers {
    fn is_of(&self, document: &Scene) -> bool {
        self.settings == document.build && self.units == document.units
    }
}

impl MeasureCache {
    /// Returns planarity and circularity of the faces of the current shape.
    pub(crate) fn measures(&self, scene: &SolvedScene, rest: &RestMesh) -> Rc<Measures> {
        let mut measured = self.0.borrow_mut();
        measured.begin(scene);
        let Measured { measures, recent, .. } = &mut *measured;
        let measure = || {
            let mesh = rest.mesh();
            let diameter = mesh.size();
            let new = Rc::new(Measures::new(scene.positions(), &mesh.faces, diameter));
            *recent = Some((Rc::clone(&new), clock::now()));
            new
        };
        Rc::clone(measures.get_or_insert_with(measure))
    }

    /// As [`MeasureCache::measures`], but up to `seconds` old: on large meshes measuring takes
    /// longer than an iteration.
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

    /// Returns the measure of the current shape against the original.
    pub(crate) fn shape_measure(&self, scene: &SolvedScene, rest: &RestMesh) -> Rc<ShapeMeasure> {
        let mut measured = self.0.borrow_mut();
        measured.begin(scene);
        let target = scene.document().closeness.target_mesh();
        let measure = || Rc::new(ShapeMeasure::of(scene.positions(), rest, target));
        Rc::clone(measured.shape.get_or_insert_with(measure))
    }

    /// Returns the distance of each vertex to the surface of the opened model, `#V`, in its unit.
    pub(crate) fn surface_distances(&self, scene: &SolvedScene, rest: &RestMesh) -> Rc<[f64]> {
        let mut measured = self.0.borrow_mut();
        measured.begin(scene);
        let Measured { surface_distances, closest, .. } = &mut *measured;
        let search = || {
            let (surface, centre) = original(scene, rest);
            distances(&surface, centre, scene.positions(), closest)
        };
        Rc::clone(surface_distances.get_or_insert_with(search))
    }

    /// Stores numbers of the build of the current shape, by name.
    pub(crate) fn set_build_numbers(&self, scene: &SolvedScene, values: Vec<(String, f64)>) {
        let mut measured = self.0.borrow_mut();
        measured.begin(scene);
        let Scene { build, units, .. } = &**scene.document();
        let (settings, units) = (build.clone(), units.clone());
        measured.build = Some(BuildNumbers { settings, units, values });
    }

    /// Returns a number of the build of the current shape, and none for it if that has no value; none at
    /// all before numbers are stored for this shape with these settings.
    pub(crate) fn build_number(&self, scene: &SolvedScene, name: &str) -> Option<Option<f64>> {
        let mut measured = self.0.borrow_mut();
        measured.begin(scene);
        let build = measured.build.as_ref().filter(|build| build.is_of(scene.document()))?;
        let number = build.values.iter().find(|(own, _)| own == name);
        Some(number.map(|(_, value)| *value))
    }
}

impl Measured {
    /// Removes the measures of another shape, or against another original, but of the same original
    /// keeps the closest triangles as initial guesses.
    fn begin(&mut self, scene: &SolvedScene) {
        let (positions, target) = (scene.positions(), scene.document().closeness.target_mesh());
        let is_same = |known: &Rc<[Point]>| Rc::ptr_eq(known, positions) || known == positions;
        if !self.positions.as_ref().is_some_and(is_same) {
            (self.measures, self.shape, self.surface_distances) = (None, None, None);
            self.build = None;
        }
        self.positions = Some(Rc::clone(positions));
        if self.target.as_ref().map(Rc::as_ptr) != target.map(Rc::as_ptr) {
            (self.shape, self.surface_distances) = (None, None);
            self.closest.clear();
        }
        self.target = target.map(Rc::clone);
    }
}

/// Returns the original surface, and the centre that its coordinates are relative to.
fn original(scene: &SolvedScene, rest: &RestMesh) -> (Rc<Surface>, Point) {
    let other = rest.original(scene.document().closeness.target_mesh());
    other.map_or_else(|| scene.solver().rest_surface(rest.mesh()), |other| (other, [0.0; 3]))
}

/// Distance of each of `positions` (`#V by 3`) to the surface of the opened model, `#V`, in its unit.
pub(super) fn surface_distances_at(
    positions: &[Point],
    scene: &SolvedScene,
    rest: &RestMesh,
) -> Rc<[f64]> {
    let (surface, centre) = original(scene, rest);
    distances(&surface, centre, positions, &mut Vec::new())
}

/// Returns the distance of each point to the surface, whose coordinates are relative to `centre`.
/// `closest` stores the triangle found by the last search for each point.
fn distances(
    surface: &Surface,
    centre: Point,
    points: &[Point],
    closest: &mut Vec<u32>,
) -> Rc<[f64]> {
    let is_first = closest.is_empty();
    closest.resize(points.len(), Surface::NO_HINT);
    let mut before = Surface::NO_HINT;
    let places = points.iter().zip(closest);
    let distance = |(point, closest): (&Point, &mut u32)| {
        if is_first {
            // Neighbours in the file are usually neighbours in space.
            *closest = before;
        }
        let point = std::array::from_fn(|i| point[i] - centre[i]);
        let foot = surface.closest(point, closest);
        before = *closest;
        (Vec3::from(foot) - Vec3::from(point)).length()
    };
    places.map(distance).collect()
}
