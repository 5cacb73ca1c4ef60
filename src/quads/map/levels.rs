//! The whole way from a prepared surface to an integer-grid map, with retries (sections 4.3 to 4.8 of
//! the study): creases nearer to each other than a panel are given up, and when triangles stay flipped
//! at all scales, the field follows less of the curvature.

use super::relaxed::{Attempt, Field, Found, Relaxed};
use super::snap::snap;
use crate::quads::field::{Frames, Steering};
use crate::quads::surface::Prepared;
use crate::quads::{GridMap, MapOptions, RemeshError, RemeshObserver, RemeshStage, Side};

/// Number of levels.
const LEVELS: usize = 4;
/// Factors of the scale, tried in turn: the integers fall differently.
const SCALES: [f64; 3] = [1.0, 0.94, 1.06];
/// A number of quads farther from the wanted one by this ratio is corrected.
const OFF: f64 = 1.07;
/// Most corrections.
const CORRECTIONS: usize = 3;
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

/// Maps of one prepared surface. Fields and seamless maps are kept, so that another number of quads
/// takes a rounding only, and another weight of directions a map.
pub struct GridMapper {
    prepared: Prepared,
    frames: Frames,
    abandonings: usize,
    /// By level.
    fields: Vec<Field>,
    /// By level.
    relaxed: Vec<Relaxed>,
}

impl GridMapper {
    /// Maps of a surface.
    pub fn new(prepared: Prepared) -> GridMapper {
        let frames = Frames::new(&prepared.surface);
        let (fields, relaxed) = (Vec::new(), Vec::new());
        GridMapper { prepared, frames, abandonings: 0, fields, relaxed }
    }

    /// The surface; its features are those that the last map follows.
    pub fn prepared(&self) -> &Prepared {
        &self.prepared
    }

    /// Computes an integer-grid map with about `wanted` quads, for the weights `follow` of curvature
    /// and `direction` of directions (see [`crate::quads::MapOptions`]). If triangles are flipped at
    /// all levels, the map is that with the fewest, and the notes name them.
    ///
    /// # Errors
    /// If the observer says no, or numbers are out of proportion.
    pub fn map(
        &mut self,
        follow: f64,
        direction: f64,
        wanted: f64,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<(GridMap, MapNotes), RemeshError> {
        let mut best: Option<(usize, Found)> = None;
        let mut level = 0;
        while level < LEVELS {
            self.relax(level, follow, direction, observer)?;
            let found = match self.round(level, wanted, observer)? {
                Attempt::Map(found) => found,
                Attempt::Creases(sides) => {
                    self.abandon(&sides);
                    best = None;
                    level = 0;
                    continue;
                }
            };
            let fewest = best.as_ref().map_or(usize::MAX, |(_, best)| best.flipped.len());
            if found.flipped.len() < fewest {
                best = Some((level, found));
            }
            if best.as_ref().is_some_and(|(_, best)| best.flipped.is_empty()) {
                break;
            }
            level += 1;
        }
        let (level, found) = best.expect("the last level finds a map");
        let Field { combed, seams, .. } = &self.fields[level];
        let map = snap(seams, &found.rounded.values)?;
        let notes = MapNotes {
            flipped: (0..map.corners.len()).filter(|&t| map.doubled_area(t) <= 0).collect(),
            level: level as u32,
            singularities: combed.singularities(),
            quads: found.quads,
            scale: found.factor,
            integers: self.relaxed[level].integers.count(),
            separations: found.separations,
            abandoned_creases: self.prepared.notes.abandoned,
            cut: seams.cut.len(),
            seamless_flips: self.relaxed[level].seamless.flips.clone(),
        };
        Ok((map, notes))
    }

    /// Makes sure that the field and the map without integers of a level are those of the weights.
    fn relax(
        &mut self,
        level: usize,
        follow: f64,
        direction: f64,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<(), RemeshError> {
        let steering = steering(level, follow);
        let GridMapper { prepared, frames, fields, relaxed, .. } = self;
        if fields.get(level).is_none_or(|field| field.steering != steering) {
            fields.truncate(level);
            relaxed.truncate(level);
            fields.push(Field::new(prepared, frames, steering, observer)?);
        }
        if relaxed.get(level).is_none_or(|relaxed| relaxed.direction != direction) {
            relaxed.truncate(level);
            let field = &fields[level];
            relaxed.push(Relaxed::new(prepared, frames, field, direction, observer)?);
        }
        Ok(())
    }

    /// Rounds at one scale after another until no triangle is flipped, then corrects the scale where
    /// the number of quads is off.
    fn round(
        &mut self,
        level: usize,
        wanted: f64,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<Attempt, RemeshError> {
        let GridMapper { prepared, frames, fields, relaxed, .. } = self;
        let (field, relaxed) = (&fields[level], &mut relaxed[level]);
        let may_abandon = self.abandonings < ABANDONINGS;
        let mut at = |factor: f64, part: f64| {
            if !observer(RemeshStage::Round, part) {
                return Err(RemeshError::Cancelled);
            }
            Ok(relaxed.round(prepared, frames, field, [wanted, factor], may_abandon))
        };
        let mut best: Option<Found> = None;
        for (k, factor) in SCALES.into_iter().enumerate() {
            let found = match at(factor, k as f64 / SCALES.len() as f64)? {
                Attempt::Map(found) => found,
                creases => return Ok(creases),
            };
            if best.as_ref().is_none_or(|best| found.flipped.len() < best.flipped.len()) {
                best = Some(found);
            }
            if best.as_ref().is_some_and(|best| best.flipped.is_empty()) {
                break;
            }
        }
        let mut best = best.expect("there is a scale");
        let off = |found: &Found| (found.quads / wanted).max(wanted / found.quads);
        let mut factor = best.factor;
        for _ in 0..CORRECTIONS {
            if !best.flipped.is_empty() || off(&best) <= OFF {
                break;
            }
            factor *= (wanted / best.quads).sqrt();
            let Attempt::Map(found) = at(factor, 1.0)? else { break };
            if !found.flipped.is_empty() || off(&found) >= off(&best) {
                break;
            }
            best = found;
        }
        Ok(Attempt::Map(best))
    }

    fn abandon(&mut self, creases: &[Side]) {
        self.prepared = self.prepared.without_creases(creases);
        self.abandonings += 1;
        self.fields.clear();
        self.relaxed.clear();
    }
}

/// Computes one map; see [`GridMapper::map`]. Without a `wanted` number of quads, panels have the size
/// for which the surface was prepared.
///
/// # Errors
/// If the observer says no, or numbers are out of proportion.
pub fn grid_map(
    prepared: &Prepared,
    options: &MapOptions,
    wanted: Option<f64>,
    observer: &mut RemeshObserver<'_>,
) -> Result<(GridMap, MapNotes), RemeshError> {
    let wanted = wanted.unwrap_or(prepared.surface.area() / (prepared.size * prepared.size));
    let mut mapper = GridMapper::new(prepared.clone());
    mapper.map(options.follow, options.direction, wanted, observer)
}

/// The field's settings of a level: lambda, smoothing and step.
fn steering(level: usize, follow: f64) -> Steering {
    let times = f64::from(1u32 << level);
    Steering {
        follow: if level + 1 < LEVELS { follow / (times * times) } else { 0.0 },
        smoothing: 0.5 * times,
        step: times * times,
    }
}
