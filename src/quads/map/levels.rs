//! The whole way from a prepared surface to an integer-grid map, with retries (sections 4.3 to 4.8 of
//! `reference/quads.md`): creases nearer to each other than a panel are dropped, and when triangles
//! stay flipped at all scales, the field follows less of the curvature.

use super::budget::Budget;
use super::relaxed::{Attempt, Field, Found, Relaxed};
use super::snap::snap;
use crate::quads::field::{Frames, Steering};
use crate::quads::surface::Prepared;
use crate::quads::{GridMap, MapFault, RemeshObserver, RemeshStage, Side};

/// Number of levels.
const LEVELS: usize = 4;
/// Factors of the scale, tried in turn: the integers fall differently.
const SCALES: [f64; 3] = [1.0, 0.94, 1.06];
/// A number of quads farther from the wanted one by this ratio is corrected.
const MOST_MISSED: f64 = 1.07;
/// Most corrections.
const CORRECTIONS: usize = 3;
/// How often creases are dropped.
const MOST_DROPS: usize = 3;

/// How a map came about.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MapNotes {
    /// Triangles that are flipped or have no area in the map; they are where details are smaller than
    /// a panel. None if all is well.
    pub flipped: Vec<usize>,
    /// The level of the field: 0 follows curvature as asked, 3 not at all.
    pub level: u32,
    /// Number of integer unknowns that were rounded.
    pub integers: usize,
    /// Crease edges dropped because they are nearer to each other than a panel.
    pub dropped_creases: usize,
}

/// Maps of one prepared surface. Fields and seamless maps are kept, so that another number of quads
/// takes a rounding only, and another weight of directions a map.
pub struct GridMapper {
    frames: Frames,
    /// The surface with all its creases, then each time that some are dropped.
    sets: Vec<CreaseSet>,
    /// The set of the last map.
    current: usize,
    /// What the last search left for its variations.
    budget: Budget,
}

/// A prepared surface with its fields and seamless maps.
struct CreaseSet {
    prepared: Prepared,
    /// The creases that the set before has and this one drops.
    dropped: Vec<Side>,
    /// By level.
    fields: Vec<Field>,
    /// By level.
    relaxed: Vec<Relaxed>,
}

/// Is shown each map with its surface, whose features are those that the map follows. Returns whether
/// to go on to the next one.
pub type MapVisitor<'a> = dyn FnMut(&Prepared, GridMap, MapNotes) -> bool + 'a;

/// How the roundings of a level end.
enum Rounds {
    /// No more maps are wanted.
    Enough,
    /// All scales were tried.
    Tried,
    /// Creases are in the way.
    Creases(Vec<Side>),
}

impl GridMapper {
    /// Maps of a surface.
    pub fn new(prepared: Prepared) -> GridMapper {
        let frames = Frames::new(&prepared.surface);
        let budget = Budget::new(prepared.surface.triangles.len());
        GridMapper { frames, sets: vec![CreaseSet::new(prepared, Vec::new())], current: 0, budget }
    }

    /// Computes map after map, for the weights of curvature and of directions (see
    /// [`crate::quads::MapOptions`]) and about this number of quads: at each level at one scale after
    /// another, as long as the visitor wants to see more and the budget allows; at least one. What was
    /// asked before changes nothing.
    ///
    /// # Errors
    /// If there are too many integer unknowns, or numbers are out of proportion.
    pub fn maps(
        &mut self,
        [follow, direction, wanted]: [f64; 3],
        observer: &mut RemeshObserver<'_>,
        visit: &mut MapVisitor<'_>,
    ) -> Result<(), MapFault> {
        self.current = 0;
        let mut level = 0;
        self.budget = Budget::new(self.sets[0].prepared.surface.triangles.len());
        while level < LEVELS {
            let GridMapper { sets, frames, current, budget } = self;
            let may_drop = *current < MOST_DROPS;
            let here = &mut sets[*current];
            here.relax(frames, level, [follow, direction], observer)?;
            // What is kept counts too: what was asked before changes nothing.
            budget.relax();
            match here.round(frames, level, (wanted, may_drop), budget, observer, visit)? {
                Rounds::Enough => return Ok(()),
                Rounds::Tried => level += 1,
                Rounds::Creases(sides) => {
                    *current += 1;
                    level = 0;
                    if sets.get(*current).is_none_or(|next| next.dropped != sides) {
                        sets.truncate(*current);
                        let prepared = sets[*current - 1].prepared.without_creases(&sides);
                        sets.push(CreaseSet::new(prepared, sides));
                    }
                }
            }
        }
        Ok(())
    }

    /// A variation of the last search, which must have ended at level 0: the first map for another number
    /// of quads, with the same weights and creases. None if the budget of the search is spent, if more
    /// creases are in the way, or if numbers are out of proportion.
    pub(in crate::quads) fn vary(&mut self, wanted: f64) -> Option<(&Prepared, GridMap, MapNotes)> {
        let GridMapper { sets, frames, current, budget } = self;
        let mut own = budget.take_variation();
        if own.is_spent() {
            return None;
        }
        let here = &mut sets[*current];
        let asked = (wanted, *current < MOST_DROPS);
        let mut found = None;
        let mut keep = |_: &Prepared, map, notes| {
            found = Some((map, notes));
            false
        };
        let rounds = here.round(frames, 0, asked, &mut own, &mut |_| (), &mut keep);
        budget.give_back(own);
        rounds.ok()?;
        let (map, notes) = found?;
        Some((&here.prepared, map, notes))
    }
}

impl CreaseSet {
    fn new(prepared: Prepared, dropped: Vec<Side>) -> CreaseSet {
        CreaseSet { prepared, dropped, fields: Vec::new(), relaxed: Vec::new() }
    }

    /// Makes sure that the field and the map without integers of a level are those of the weights.
    fn relax(
        &mut self,
        frames: &Frames,
        level: usize,
        [follow, direction]: [f64; 2],
        observer: &mut RemeshObserver<'_>,
    ) -> Result<(), MapFault> {
        let steering = steering(level, follow);
        let CreaseSet { prepared, fields, relaxed, .. } = self;
        if fields.get(level).is_none_or(|field| field.steering != steering) {
            fields.truncate(level);
            relaxed.truncate(level);
            observer(RemeshStage::Field);
            fields.push(Field::new(prepared, frames, steering)?);
        }
        if relaxed.get(level).is_none_or(|relaxed| relaxed.direction != direction) {
            relaxed.truncate(level);
            observer(RemeshStage::Map);
            relaxed.push(Relaxed::new(prepared, frames, &fields[level], direction)?);
        }
        Ok(())
    }

    /// Rounds at one scale after another, and corrects the scale where the number of quads is off.
    fn round(
        &mut self,
        frames: &Frames,
        level: usize,
        (wanted, may_drop): (f64, bool),
        budget: &mut Budget,
        observer: &mut RemeshObserver<'_>,
        visit: &mut MapVisitor<'_>,
    ) -> Result<Rounds, MapFault> {
        let CreaseSet { prepared, fields, relaxed, .. } = self;
        let (field, relaxed) = (&fields[level], &mut relaxed[level]);
        for factor in SCALES {
            observer(RemeshStage::Round);
            let mut at =
                |factor| relaxed.round(prepared, frames, field, [wanted, factor], may_drop, budget);
            let mut best = match at(factor) {
                Attempt::Map(found) => found,
                Attempt::Creases(sides) => return Ok(Rounds::Creases(sides)),
            };
            let off = |found: &Found| (found.quads / wanted).max(wanted / found.quads);
            let mut factor = best.factor;
            for _ in 0..CORRECTIONS {
                if !best.flipped.is_empty() || off(&best) <= MOST_MISSED {
                    break;
                }
                factor *= (wanted / best.quads).sqrt();
                let Attempt::Map(found) = at(factor) else { break };
                if !found.flipped.is_empty() || off(&found) >= off(&best) {
                    break;
                }
                best = found;
            }
            let map = snap(&field.seams, &best.rounded.values)?;
            let notes = MapNotes {
                flipped: (0..map.corners.len()).filter(|&t| map.doubled_area(t) <= 0).collect(),
                level: level as u32,
                integers: relaxed.integers.count(),
                dropped_creases: prepared.notes.dropped.len(),
            };
            observer(RemeshStage::Extract);
            budget.judge();
            if !visit(prepared, map, notes) || budget.is_spent() {
                return Ok(Rounds::Enough);
            }
        }
        Ok(Rounds::Tried)
    }
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
