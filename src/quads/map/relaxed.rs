//! One field with its map: the seamless map, and the integer-grid maps of any scale that are rounded
//! from it.

use super::budget::Budget;
use super::energy::Energy;
use super::integer::{Integers, Rounded};
use super::seamless::{Seamless, doubled_areas, seamless_map};
use super::seams::Seams;
use super::separation::{Separation, separations};
use super::untangle::Untangling;
use crate::quads::field::{Combed, Cross, Frames, Steering, cross_field, cut_sides};
use crate::quads::surface::Prepared;
use crate::quads::{MapFault, Side};

/// Most roundings at one scale, each with more separations.
const ROUNDINGS: usize = 8;

/// Roundings in a row that bring no new pair, after which those left contradict each other.
const STUCK: usize = 2;

/// A field, its singularities and the unknowns of maps along it.
pub(super) struct Field {
    pub steering: Steering,
    cross: Cross,
    pub combed: Combed,
    pub seams: Seams,
}

impl Field {
    /// Computes the field and its cut.
    ///
    /// # Errors
    /// If a matrix is singular.
    pub(super) fn new(
        prepared: &Prepared,
        frames: &Frames,
        steering: Steering,
    ) -> Result<Field, MapFault> {
        let cross = cross_field(prepared, frames, steering)?;
        let combed = Combed::new(&prepared.surface, frames, &cross.crosses);
        let cut = cut_sides(&prepared.surface, &combed);
        let seams = Seams::new(prepared, frames, &combed, cut);
        Ok(Field { steering, cross, combed, seams })
    }
}

/// The seamless map of a field for one weight of directions.
pub(super) struct Relaxed {
    pub direction: f64,
    energy: Energy,
    pub seamless: Seamless,
    pub integers: Integers,
    /// Number of quads by the area of the map, before scaling.
    predicted: f64,
}

/// An integer-grid map, or what is in its way.
pub(super) enum Attempt {
    /// A map.
    Map(Found),
    /// Creases that are nearer to each other, or to a singular vertex, than a panel.
    Creases(Vec<Side>),
}

/// A rounded map with the way to it.
pub(super) struct Found {
    /// Factor of the scale for the wanted number of quads.
    pub factor: f64,
    pub rounded: Rounded,
    /// Triangles without positive area.
    pub flipped: Vec<usize>,
    /// Number of quads by the area of the map.
    pub quads: f64,
}

impl Relaxed {
    /// Computes the map without integers.
    ///
    /// # Errors
    /// If there are too many integer unknowns, or numbers are out of proportion.
    pub(super) fn new(
        prepared: &Prepared,
        frames: &Frames,
        field: &Field,
        direction: f64,
    ) -> Result<Relaxed, MapFault> {
        let Field { cross, combed, seams, .. } = field;
        let mut energy = Energy::new(prepared, frames, combed, cross, seams, direction);
        let seamless = seamless_map(prepared, seams, &mut energy, &frames.area)?;
        let predicted = 0.5 * doubled_areas(seams, &seamless.values).iter().sum::<f64>();
        if !(predicted > 0.0 && predicted.is_finite()) {
            return Err(MapFault::Numerical);
        }
        let integers = Integers::new(seams, &mut energy, &seamless)?;
        Ok(Relaxed { direction, energy, seamless, integers, predicted })
    }

    /// Rounds at the scale for `wanted` quads times `factor`; anew with separations as long as points
    /// or lines are rounded onto each other and the budget allows, then untangled. If creases are in the
    /// way, and may be dropped, these are returned.
    pub(super) fn round(
        &mut self,
        prepared: &Prepared,
        frames: &Frames,
        field: &Field,
        [wanted, factor]: [f64; 2],
        may_drop: bool,
        budget: &mut Budget,
    ) -> Attempt {
        let seams = &field.seams;
        let scale = factor * (wanted / self.predicted).sqrt();
        let free: Vec<f64> = self.seamless.values.iter().map(|value| scale * value).collect();
        let mut given: Vec<Separation> = Vec::new();
        let mut stuck = 0;
        for rounding in 1.. {
            budget.round();
            let integers = self.integers.round(scale, &given);
            let mut rounded = self.integers.solve(seams, &mut self.energy, scale, &integers);
            let more = separations(prepared, seams, &rounded.flipped(), &free, &rounded.values);
            let creases: Vec<Side> = more.iter().flat_map(|one| one.creases.clone()).collect();
            if may_drop && !creases.is_empty() {
                return Attempt::Creases(creases);
            }
            stuck = if more.iter().all(|one| given.contains(one)) { stuck + 1 } else { 0 };
            let is_last = stuck == STUCK || rounding == ROUNDINGS || budget.is_spent();
            if more.is_empty() || is_last {
                if !rounded.flipped().is_empty() {
                    let size = prepared.size / scale;
                    let untangling = Untangling::new(&prepared.surface, frames, seams, size);
                    untangling.untangle(&mut rounded.values, &mut rounded.doubled, budget);
                }
                let quads = 0.5 * rounded.doubled.iter().sum::<f64>();
                let flipped = rounded.flipped();
                return Attempt::Map(Found { factor, rounded, flipped, quads });
            }
            // What is violated although it was given contradicts what was given before it.
            given.retain(|one| !more.contains(one));
            given.splice(0..0, more);
        }
        unreachable!("the last rounding returns")
    }
}
