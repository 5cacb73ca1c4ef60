//! What was measured of the current shape. As long as the shape stays, it is not measured again: a frame,
//! a colour and a list ask for the same numbers.

use super::{Session, Shape};
use crate::math::Vec3;
use crate::mesh::{Measures, Point, Surface};
use std::rc::Rc;

/// What was measured of one shape, and what helps to measure the next one.
#[derive(Default)]
pub(super) struct Measured {
    /// The shape, `#V by 3`.
    positions: Vec<Point>,
    measures: Option<Rc<Measures>>,
    /// `#V`
    surface_distances: Option<Rc<[f64]>>,
    /// The triangle of the original that was closest to each vertex last, `#V`; none before the first search.
    closest: Vec<u32>,
}

impl Measured {
    /// Forgets what was measured of another shape.
    fn of(&mut self, positions: Vec<Point>) {
        if self.positions != positions {
            *self = Measured {
                positions,
                closest: std::mem::take(&mut self.closest),
                ..Measured::default()
            };
        }
    }
}

impl Session {
    /// How planar and circular the faces are now.
    pub fn measures(&self) -> Rc<Measures> {
        let mut measured = self.measured.borrow_mut();
        measured.of(self.positions());
        let Measured { positions, measures, .. } = &mut *measured;
        let measure = || Rc::new(Measures::new(positions, &self.mesh.faces, self.diameter));
        Rc::clone(measures.get_or_insert_with(measure))
    }

    /// Per vertex (`#V`), its distance to the surface of the model that was opened.
    pub(super) fn surface_distances(&self, shape: Shape) -> Rc<[f64]> {
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
