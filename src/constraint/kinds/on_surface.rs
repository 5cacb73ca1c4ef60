//! On surface: the closest point `c(v)` of the rest surface (paper Eq. 11) as a shape constraint.

use crate::constraint::kinds::shared::separate_lanes;
use crate::constraint::{Arity, Centring, Info, Projection, Reference};
use crate::math::{Lane, Vec3};
use crate::mesh::{Point, Surface};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::rc::Rc;

/// The vertices glide on the rest surface of the whole mesh: its faces, triangulated as fans, or
/// its curves if there are no faces.
///
/// Each vertex is projected to the closest point; one is chosen if several are. Points with a
/// coordinate beyond 1e100 are first scaled down to it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct OnSurface {
    #[serde(skip)]
    surface: RestSurface,
}

/// The rest surface, once it is bound. Not a parameter: operators with equal parameters are equal.
#[derive(Clone, Default)]
struct RestSurface(Option<Rc<Surface>>);

impl PartialEq for RestSurface {
    fn eq(&self, _: &RestSurface) -> bool {
        true
    }
}

impl fmt::Debug for RestSurface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "known" } else { "unknown" })
    }
}

impl Projection for OnSurface {
    const INFO: Info = Info {
        id: "on-surface",
        label: "On surface",
        summary: "The vertices glide on the surface of the original.",
        arity: Arity::AtLeast(1),
        centring: Centring::Placed,
        colour: [70, 130, 70],
        ..Info::PLAIN
    };

    const READS_REST: bool = true;

    fn bind(&mut self, reference: &Reference<'_>) {
        self.surface = RestSurface(Some((reference.surface)()));
    }

    /// Stores the triangle closest to each vertex at rest, where later searches start.
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        for r in rest {
            let mut triangle = Surface::NO_HINT;
            self.closest(*r, &mut triangle);
            *r = Vec3::new(f64::from(triangle), 0.0, 0.0);
        }
    }

    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        separate_lanes(rest, v, projected, |lane, projected| {
            for ((r, v), p) in rest.iter().zip(v).zip(projected) {
                let mut triangle = r.x.lane(lane) as u32;
                p.set_lane(lane, self.closest(v.lane(lane), &mut triangle));
            }
            true
        })
    }
}

/// Largest coordinate; its square is finite.
const FARTHEST: f64 = 1e100;

impl OnSurface {
    fn closest(&self, v: Vec3<f64>, triangle: &mut u32) -> Vec3<f64> {
        let surface = self.surface.0.as_ref().expect("operators get their reference first");
        let largest = v.largest_coordinate();
        let v = if largest > FARTHEST { v * (FARTHEST / largest) } else { v };
        surface.closest(Point::from(v), triangle).into()
    }
}
