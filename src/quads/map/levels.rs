//! The whole way from a prepared surface to an integer-grid map, with retries (sections 4.3 to 4.8 of
//! the study): creases nearer to each other than a panel are given up, and when triangles stay flipped
//! at all scales, the field follows less of the curvature.

use super::energy::Energy;
use super::integer::{Integers, Rounded};
use super::seamless::{Seamless, doubled_areas, seamless_map};
use super::seams::Seams;
use super::separation::{Separation, separations};
use super::snap::snap;
use super::untangle::Untangling;
use crate::quads::field::{Combed, Frames, Steering, cross_field, cut_sides};
use crate::quads::surface::Prepared;
use crate::quads::{GridMap, MapOptions, RemeshError, RemeshObserver, RemeshStage, Side};

/// Number of levels.
const LEVELS: u32 = 4;
/// Factors of the scale, tried in turn: the integers fall differently.
const SCALES: [f64; 5] = [1.0, 0.94, 1.06, 0.88, 1.12];
/// Most roundings at one scale, each with more separations.
const ROUNDINGS: usize = 8;
/// How often creases are given up.
const ABANDONINGS: usize = 3;

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
    /// Number of pairs of points and lines that rounding would have put together.
    pub separations: usize,
    /// Crease edges given up because they are nearer to each other than a panel.
    pub abandoned_creases: usize,
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
    let target = wanted.unwrap_or(prepared.surface.area() / (prepared.size * prepared.size));
    let mut best: Option<(GridMap, MapNotes)> = None;
    let mut fewer: Option<Prepared> = None;
    let mut abandonings = 0;
    let mut level = 0;
    while level < LEVELS {
        let current = fewer.as_ref().unwrap_or(prepared);
        let stages = Stages::new(current, &frames, options, level, observer)?;
        let (found, creases) = stages.round(target, abandonings < ABANDONINGS, observer)?;
        if !creases.is_empty() {
            fewer = Some(current.without_creases(&creases));
            abandonings += 1;
            continue;
        }
        let flips = |found: &(GridMap, MapNotes)| found.1.flipped.len();
        if let Some(found) = found
            && best.as_ref().is_none_or(|best| flips(&found) < flips(best))
        {
            best = Some(found);
        }
        if best.as_ref().is_some_and(|best| flips(best) == 0) {
            break;
        }
        level += 1;
    }
    Ok(best.expect("the last level finds a map"))
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

/// The field and the map without integers, from which maps of any scale are rounded.
struct Stages<'a> {
    prepared: &'a Prepared,
    frames: &'a Frames,
    level: u32,
    combed: Combed,
    seams: Seams,
    energy: Energy,
    seamless: Seamless,
}

impl<'a> Stages<'a> {
    fn new(
        prepared: &'a Prepared,
        frames: &'a Frames,
        options: &MapOptions,
        level: u32,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<Stages<'a>, RemeshError> {
        let surface = &prepared.surface;
        let steering = steering(level, options.follow);
        let cross = cross_field(prepared, frames, steering, &mut |part| {
            observer(RemeshStage::Field, part)
        })?;
        let combed = Combed::new(surface, frames, &cross.crosses);
        let cut = cut_sides(surface, &combed);
        let seams = Seams::new(prepared, frames, &combed, cut);
        let mut energy = Energy::new(prepared, frames, &combed, &cross, &seams, options.direction);
        let seamless = seamless_map(prepared, &seams, &mut energy, &frames.area, &mut |part| {
            observer(RemeshStage::Map, part)
        })?;
        Ok(Stages { prepared, frames, level, combed, seams, energy, seamless })
    }

    /// Rounds for a number of quads, at one scale after another until no triangle is flipped. If
    /// creases are in each other's way, and `may_abandon`, these are returned instead of a map.
    #[expect(clippy::type_complexity, reason = "a map or creases")]
    fn round(
        self,
        target: f64,
        may_abandon: bool,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<(Option<(GridMap, MapNotes)>, Vec<Side>), RemeshError> {
        let Stages { prepared, frames, level, combed, seams, mut energy, seamless } = self;
        let (seams, seamless) = (&seams, &seamless);
        let energy = &mut energy;
        let predicted = 0.5 * doubled_areas(seams, &seamless.values).iter().sum::<f64>();
        let scale = (target / predicted).sqrt();
        if !(scale.is_finite() && predicted > 0.0) {
            return Err(RemeshError::Numerical);
        }
        let integers = Integers::new(seams, energy, seamless)?;
        let mut best: Option<Found> = None;
        for (tried, factor) in SCALES.into_iter().enumerate() {
            let scale = scale * factor;
            let free: Vec<f64> = seamless.values.iter().map(|value| scale * value).collect();
            let size = prepared.size / scale;
            let untangling = Untangling::new(&prepared.surface, frames, seams, size);
            let mut given: Vec<Separation> = Vec::new();
            for _ in 0..ROUNDINGS {
                if !observer(RemeshStage::Round, tried as f64 / SCALES.len() as f64) {
                    return Err(RemeshError::Cancelled);
                }
                let mut rounded = integers.solve(energy, scale, &integers.round(scale, &given));
                let pairs = |rounded: &Rounded| {
                    let flipped = rounded.flipped();
                    separations(prepared, seams, &flipped, &free, &rounded.values)
                };
                let mut more = pairs(&rounded);
                more.retain(|one| !given.contains(one));
                if more.is_empty() {
                    untangling.untangle(&mut rounded.values, &mut rounded.doubled);
                }
                let creases: Vec<Side> = more.iter().flat_map(|one| one.creases.clone()).collect();
                if may_abandon && !creases.is_empty() {
                    return Ok((None, creases));
                }
                let is_last = more.is_empty();
                let found = Found {
                    factor,
                    flips: rounded.flipped().len(),
                    rounded,
                    separations: given.len(),
                };
                given.extend(more);
                if best.as_ref().is_none_or(|best| found.flips < best.flips) {
                    best = Some(found);
                }
                if is_last {
                    break;
                }
            }
            if best.as_ref().is_some_and(|best| best.flips == 0) {
                break;
            }
        }
        let found = best.expect("there is a scale");
        let map = snap(seams, &found.rounded.values)?;
        let flipped = (0..map.corners.len()).filter(|&t| map.doubled_area(t) <= 0).collect();
        let notes = MapNotes {
            flipped,
            level,
            singularities: combed.singularities(),
            quads: 0.5 * found.rounded.doubled.iter().sum::<f64>(),
            scale: found.factor,
            integers: integers.unknowns.len(),
            separations: found.separations,
            abandoned_creases: prepared.notes.abandoned,
            cut: seams.cut.len(),
            seamless_flips: seamless.flips.clone(),
        };
        Ok((Some((map, notes)), Vec::new()))
    }
}

/// A rounded map with the way to it.
struct Found {
    factor: f64,
    flips: usize,
    rounded: Rounded,
    separations: usize,
}
