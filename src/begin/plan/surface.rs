//! The surface over a plan.

use super::declaration::{Plan, PlanError, PlanLayout, entry};
use super::outline::Loop;
use super::raise::PlanSurface;
use super::{cut, follow, raise};
use crate::mesh::Mesh;

impl Plan {
    /// The surface over the plan: faces are counterclockwise seen from above, `z = 0` is the
    /// ground.
    ///
    /// # Errors
    /// If a number is out of its limits, sides cross, or the plan cannot be divided as requested.
    pub fn surface(&self) -> Result<PlanSurface, PlanError> {
        let expect = |path: &str, found: f64, is_good: bool, expected: &str| match is_good {
            true => Ok(()),
            false => Err(entry(path, format!("expected {expected}, found {found}"))),
        };
        let Plan { size, turn, height, .. } = *self;
        expect("size", size, (1e-6..=1e6).contains(&size), "a length from 0.000001 to 1000000")?;
        expect("height", height, (0.0..=1e6).contains(&height), "a length from 0")?;
        expect("turn", turn, (-360.0..=360.0).contains(&turn), "an angle in degrees")?;
        let outline = Loop::of(&self.outline, None)?;
        let holes = (0..).zip(&self.holes).map(|(k, hole)| Loop::of(hole, Some(k)));
        let holes = holes.collect::<Result<Vec<_>, _>>()?;
        let loops: Vec<&Loop> = std::iter::once(&outline).chain(&holes).collect();
        Loop::check_disjoint(&loops)?;
        let ground = match self.layout {
            PlanLayout::Follow if !holes.is_empty() => return Err(PlanError::Holes),
            PlanLayout::Follow => follow::mesh(&outline, size)?,
            PlanLayout::Cut => cut::mesh(&loops, size, turn)?,
        };
        raise::raised(ground, self.support, height)
    }

    /// The mesh of the surface, without its supports.
    ///
    /// # Errors
    /// As [`Plan::surface`].
    pub fn mesh(&self) -> Result<Mesh, PlanError> {
        Ok(self.surface()?.mesh)
    }
}
