//! The whole way from a prepared surface to an integer-grid map, with retries (sections 4.3 to 4.8 of
//! the study): when triangles stay flipped at all scales, the field follows less of the curvature.

use super::energy::Energy;
use super::integer::{Integers, Rounded};
use super::seamless::{NO_AREA, doubled_areas, seamless_map};
use super::seams::Seams;
use super::separation::{Separation, separations};
use super::snap::snap;
use super::untangle::Untangling;
use crate::quads::field::{Combed, Frames, Steering, cross_field, cut_sides};
use crate::quads::surface::Prepared;
use crate::quads::{GridMap, MapOptions, RemeshError, RemeshObserver, RemeshStage};

/// Number of levels.
const LEVELS: u32 = 4;
/// Factors of the scale, tried in turn: the integers fall differently.
const SCALES: [f64; 7] = [1.0, 0.94, 1.06, 0.88, 1.12, 0.8, 1.25];
/// Most factorisations with integers held, for each scale.
const ROUNDS: usize = 5;
/// Maps with more flipped triangles are not worth stiffening.
const HOPELESS: usize = 60;

/// How a map came about.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MapNotes {
    /// Triangles that are flipped or have no area in the map; they are where details are smaller than
    /// a panel. None if all is well.
    pub flipped: Vec<usize>,
    /// The level of the field: 0 follows curvature as asked, 3 not at all.
    pub level: u32,
    /// The inner vertices where other than four quads meet: vertex of the surface, and 4 less the
    /// number of quads.
    pub singularities: Vec<(usize, i32)>,
    /// Number of quads by the area of the map.
    pub quads: f64,
    /// Factor of the scale that was chosen.
    pub scale: f64,
    /// Number of integer unknowns that were rounded.
    pub integers: usize,
    /// Number of cut edges.
    pub cut: usize,
    /// Flipped triangles of the map without integers, by rounds of stiffening.
    pub seamless_flips: Vec<usize>,
}

/// Computes an integer-grid map of a prepared surface. `wanted` is the number of quads to aim at; by
/// default panels have the size for which the surface was prepared. If triangles are flipped at all
/// levels, the map is that with the fewest, and the notes name them.
///
/// # Errors
/// If the observer says no, or numbers are out of proportion.
pub fn grid_map(
    prepared: &Prepared,
    options: &MapOptions,
    wanted: Option<f64>,
    observer: &mut RemeshObserver<'_>,
) -> Result<(GridMap, MapNotes), RemeshError> {
    let frames = Frames::new(&prepared.surface);
    let mut best: Option<(GridMap, MapNotes)> = None;
    for level in 0..LEVELS {
        let found = at_level(prepared, &frames, options, wanted, level, observer)?;
        let flips = |found: &(GridMap, MapNotes)| found.1.flipped.len();
        if best.as_ref().is_none_or(|best| flips(&found) < flips(best)) {
            best = Some(found);
        }
        if best.as_ref().is_some_and(|best| flips(best) == 0) {
            break;
        }
    }
    Ok(best.expect("there is a level"))
}

/// The field's settings of a level: lambda, smoothing and step.
fn steering(level: u32, follow: f64) -> Steering {
    let times = f64::from(1u32 << level);
    Steering {
        follow: if level + 1 < LEVELS { follow / (times * times) } else { 0.0 },
        smoothing: 0.5 * times,
        step: times * times,
    }
}

fn at_level(
    prepared: &Prepared,
    frames: &Frames,
    options: &MapOptions,
    wanted: Option<f64>,
    level: u32,
    observer: &mut RemeshObserver<'_>,
) -> Result<(GridMap, MapNotes), RemeshError> {
    let surface = &prepared.surface;
    let steering = steering(level, options.follow);
    let cross =
        cross_field(prepared, frames, steering, &mut |part| observer(RemeshStage::Field, part))?;
    let combed = Combed::new(surface, frames, &cross.crosses);
    let cut = cut_sides(surface, &combed);
    let seams = Seams::new(prepared, frames, &combed, cut);
    let mut energy = Energy::new(prepared, frames, &combed, &cross, &seams, options.direction);
    let areas = &frames.area;
    let seamless = seamless_map(prepared, &seams, &mut energy, areas, &mut |part| {
        observer(RemeshStage::Map, part)
    })?;
    let predicted = 0.5 * doubled_areas(&seams, &seamless.values).iter().sum::<f64>();
    let target = wanted.unwrap_or_else(|| surface.area() / (prepared.size * prepared.size));
    let scale = (target / predicted).sqrt();
    if !(scale.is_finite() && predicted > 0.0) {
        return Err(RemeshError::Numerical);
    }
    let integers = Integers::new(prepared, &seams, areas, &mut energy, &seamless)?;
    let mut best: Option<(f64, Rounded)> = None;
    for (tried, factor) in SCALES.into_iter().enumerate() {
        if !observer(RemeshStage::Round, tried as f64 / SCALES.len() as f64) {
            return Err(RemeshError::Cancelled);
        }
        let scale = scale * factor;
        let untangling = Untangling::new(surface, frames, &seams, prepared.size / scale);
        let free: Vec<f64> = seamless.values.iter().map(|value| scale * value).collect();
        let mut given: Vec<Separation> = Vec::new();
        for again in 0..8 {
            let values = integers.round(scale, &given);
            let mut rounded = integers.solve(&mut energy, scale, &values);
            let f0 = rounded.flips;
            let t = std::time::Instant::now();
            untangling.untangle(&mut rounded.values, &mut rounded.doubled);
            rounded.flips = rounded.doubled.iter().filter(|&&a| a <= NO_AREA).count();
            eprintln!(
                "level {level} factor {factor} again {again} given {} flips {f0} -> {} in {:?}",
                given.len(),
                rounded.flips,
                t.elapsed()
            );
            let flipped: Vec<usize> =
                (0..areas.len()).filter(|&t| rounded.doubled[t] <= NO_AREA).collect();
            let t = std::time::Instant::now();
            let more = if flipped.is_empty() {
                Vec::new()
            } else {
                separations(prepared, &seams, &flipped, &free, &rounded.values)
            };
            eprintln!("   {} separations in {:?}", more.len(), t.elapsed());
            if best.as_ref().is_none_or(|best: &(f64, Rounded)| rounded.flips < best.1.flips) {
                best = Some((factor, rounded));
            }
            if more.is_empty() {
                break;
            }
            given.extend(more);
        }
        if best.as_ref().is_some_and(|best| best.1.flips == 0) {
            break;
        }
    }
    let (factor, rounded) = best.expect("there is a scale");
    let map = snap(&seams, &rounded.values)?;
    let flipped: Vec<usize> = (0..areas.len()).filter(|&t| map.doubled_area(t) <= 0).collect();
    let notes = MapNotes {
        flipped,
        level,
        singularities: combed.singularities(),
        quads: 0.5 * rounded.doubled.iter().sum::<f64>(),
        scale: factor,
        integers: integers.unknowns.len(),
        cut: seams.cut.len(),
        seamless_flips: seamless.flips.clone(),
    };
    Ok((map, notes))
}
