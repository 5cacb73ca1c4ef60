//! Measures of the current shape, each computed once.

use super::face_measure::Shape;
use crate::math::Vec3;
use crate::mesh::{Measures, Point, Surface};
use crate::session::state::{Measured, Session};
use crate::solve::clock;
use std::rc::Rc;

impl Session {
    /// How planar and circular the faces are now.
    pub fn measures(&self) -> Rc<Measures> {
        let mut measured = self.measured.borrow_mut();
        measured.of(self.positions());
        let Measured { positions, measures, recent, .. } = &mut *measured;
        let measure = || {
            let new = Rc::new(Measures::new(positions, &self.mesh.faces, self.diameter));
            *recent = Some((Rc::clone(&new), clock::now()));
            new
        };
        Rc::clone(measures.get_or_insert_with(measure))
    }

    /// The same of a shape at most so many seconds ago: on large meshes it takes longer than an iteration.
    pub fn recent_measures(&self, seconds: f64) -> Rc<Measures> {
        let recent = self.measured.borrow().recent.clone();
        let recent = recent.filter(|(_, time)| clock::now() < time + seconds);
        recent.map_or_else(|| self.measures(), |(measures, _)| measures)
    }

    /// Per vertex (`#V`), its distance to the surface of the model that was opened.
    pub(crate) fn surface_distances(&self, shape: Shape) -> Rc<[f64]> {
        let (surface, centre) = self.solver.rest_surface(&self.mesh);
        let mut measured = self.measured.borrow_mut();
        if shape == Shape::Now {
            measured.of(self.positions());
        }
        let Measured { positions, surface_distances, closest, .. } = &mut *measured;
        match shape {
            Shape::Now => {
                let search = || distances(&surface, centre, positions, closest);
                Rc::clone(surface_distances.get_or_insert_with(search))
            }
            Shape::Original => distances(&surface, centre, &self.mesh.positions, closest),
        }
    }
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
