//! Parts of a scene that an edit replaces. Exchanging a part with the scene turns it into its
//! inverse: an edit and its undo move one part, and copy nothing else of the scene.

use crate::constraint::{Kind, Selector, Set};
use crate::mesh::Mesh;
use crate::scene::{
    AttemptStart, BoundaryCloseness, BoundaryRequire, BuildSettings, ChosenAttempt, ClosenessTo,
    ClosenessWeight, ConstraintSpec, EasedFaces, Goal, Lesson, Lock, Pose, Scene, Slide,
    Smoothness, SolverSettings, Target, Up, Variants, Weights,
};
use crate::solve::{Problem, Require};
use crate::words;
use std::mem::{size_of_val, swap};
use std::rc::Rc;

/// One part of a scene, with another value than in the scene.
#[derive(Clone)]
pub(crate) enum Part {
    Units(String),
    Up(Up),
    Tolerance(Option<f64>),
    Lesson(Option<Lesson>),
    Build(Option<Box<BuildSettings>>),
    Variants(Variants),
    Steps(Vec<Slide>),
    Settings(Settings),
    ClosenessWeights(Vec<ClosenessWeight>),
    /// A named set; none removes it.
    Set(String, Option<Set>),
    /// The name of a row.
    RowName(usize, String),
    /// Kind, weight, enabled state and requirement of a row.
    RowValues(usize, RowValues),
    /// A row to be inserted at an index; none removes the row there.
    Row(usize, Option<ConstraintSpec>),
    /// All rows.
    Rows(Vec<ConstraintSpec>),
}

/// The settings: numbers and choices.
#[derive(Clone, PartialEq)]
pub(crate) struct Settings {
    weights: Weights,
    to: ClosenessTo,
    target: Option<Target>,
    pose: Option<Pose>,
    boundary: BoundaryCloseness,
    smoothness: Smoothness,
    solver: SolverSettings,
    attempt: ChosenAttempt,
}

/// All properties of a row of constraints but its name and its selector.
#[derive(Clone, PartialEq)]
pub(crate) struct RowValues {
    pub(crate) kind: Kind,
    pub(crate) weight: f64,
    pub(crate) enabled: bool,
    pub(crate) require: Require,
    pub(crate) eased: Option<EasedFaces>,
}

/// How much of the solver depends on an exchanged part, least first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Effect {
    /// The solver does not depend on the part.
    Nothing,
    /// Only the weights of Eq. 13.
    Weights,
    /// The whole problem.
    Problem,
}

impl RowValues {
    pub(crate) fn of(row: &ConstraintSpec) -> RowValues {
        let ConstraintSpec { kind, weight, enabled, require, eased, .. } = row.clone();
        RowValues { kind, weight, enabled, require, eased }
    }

    /// Whether a row asks for the same: how much it weighs is no question of what is asked for, and
    /// what is eased is what a search has found.
    pub(crate) fn asks_as(&self, row: &ConstraintSpec) -> bool {
        (&self.kind, self.enabled, self.require) == (&row.kind, row.enabled, row.require)
    }
}

/// Takes back what a search has chosen to meet the hard constraints of a scene: the settings of its
/// attempt, and larger tolerances. The scene is then as it was asked for.
pub fn as_asked(scene: &mut Scene) {
    Settings::of(scene).before_attempt().put_in(scene);
    scene.constraints.iter_mut().for_each(|row| row.eased = None);
}

/// Returns the parts that a scene has where other hard constraints are asked for than those that a
/// search has met, or elsewhere: how it met them, and its larger tolerances, say nothing about these.
pub(crate) fn leave_search(scene: &Scene) -> Vec<Part> {
    let rows = scene.constraints.iter().enumerate().filter(|(_, row)| row.eased.is_some());
    let whole =
        |(index, row)| Part::RowValues(index, RowValues { eased: None, ..RowValues::of(row) });
    let attempt = ChosenAttempt { from: AttemptStart::Soft, ..scene.attempt };
    rows.map(whole).chain([Part::Settings(Settings { attempt, ..Settings::of(scene) })]).collect()
}

impl Settings {
    pub(crate) fn of(scene: &Scene) -> Settings {
        Settings {
            weights: scene.weights,
            to: scene.closeness.to,
            target: scene.closeness.target.clone(),
            pose: scene.pose.clone(),
            boundary: scene.closeness.boundary,
            smoothness: scene.smoothness,
            solver: scene.solver,
            attempt: scene.attempt,
        }
    }

    /// Returns the settings with what an attempt changes, and with its name.
    pub(crate) fn by_attempt(mut self, chosen: ChosenAttempt) -> Settings {
        self.weights.smooth *= chosen.smoother;
        if chosen.on_surface {
            self = self.on_surface();
        }
        self.attempt = self.attempt.then(chosen);
        self
    }

    /// Returns the settings before a search chose an attempt.
    pub(crate) fn before_attempt(mut self) -> Settings {
        let chosen = std::mem::take(&mut self.attempt);
        if chosen.smoother != 1.0 {
            // As many digits as anybody types: without the rounding of product and quotient.
            self.weights.smooth = words::rounded(self.weights.smooth / chosen.smoother, 15);
        }
        if chosen.on_surface {
            self.to = ClosenessTo::Rest;
        }
        if chosen.holds_boundary {
            self.boundary.require = BoundaryRequire::Off;
        } else if chosen.hardens_boundary {
            self.boundary.require = self.boundary.require.min(BoundaryRequire::Soft);
        }
        self
    }

    /// Returns the attempt that the settings `now` name: what the user has changed is not the search's.
    pub(crate) fn attempt_beside(&self, now: &Settings) -> ChosenAttempt {
        let mut attempt = now.attempt;
        if (self.to, &self.target, &self.pose) != (now.to, &now.target, &now.pose) {
            attempt.from = AttemptStart::Soft;
        }
        if self.weights.smooth != now.weights.smooth {
            attempt.smoother = 1.0;
        }
        attempt.on_surface &= self.to == now.to;
        let has_boundary = self.boundary == now.boundary;
        attempt.holds_boundary &= has_boundary;
        attempt.hardens_boundary &= has_boundary;
        attempt
    }

    /// What a lesson may lock, of what differs `now`. That a search has chosen settings is no change of
    /// the user, nor that they are left again.
    pub(crate) fn locks_beside(&self, now: &Settings) -> Vec<Lock> {
        let own = |it: &Settings| (it.weights, it.to, it.boundary, it.smoothness);
        let meshes = |it: &Settings| (it.target.clone(), it.pose.clone());
        let asked = self.clone().before_attempt();
        let is_reweighed = ![self, &asked].map(own).contains(&own(now));
        let is_elsewhere = meshes(self) != meshes(now);
        let differs = [(is_reweighed, Lock::Weights), (is_elsewhere, Lock::Mesh)];
        differs.into_iter().filter_map(|(differs, lock)| differs.then_some(lock)).collect()
    }

    /// Returns the settings with closeness to the surface, and to its boundary.
    fn on_surface(mut self) -> Settings {
        self.attempt.holds_boundary |= self.boundary.require == BoundaryRequire::Off;
        self.boundary.require = self.boundary.require.max(BoundaryRequire::Soft);
        Settings { to: ClosenessTo::Surface, ..self }
    }

    /// Returns the settings with the vertices of the boundary exactly on it.
    pub(crate) fn on_boundary(mut self) -> Settings {
        self.attempt.holds_boundary |= self.boundary.require == BoundaryRequire::Off;
        self.attempt.hardens_boundary |= self.boundary.require == BoundaryRequire::Soft;
        self.boundary.require = BoundaryRequire::Exact;
        self
    }

    /// Sets these settings in the problem of a scene.
    pub(crate) fn set_in(&self, problem: &mut Problem<'_>) {
        problem.weights = self.weights;
        problem.closeness_to = self.to;
        problem.boundary_closeness = self.boundary;
    }

    /// Memory in bytes of the target and the pose, without those that `other` settings share.
    pub(crate) fn bytes_beside(&self, other: Option<&Settings>) -> usize {
        let target = |it: &Settings| it.target.as_ref().and_then(Target::mesh).map(Rc::clone);
        let pose = |it: &Settings| match &it.pose {
            Some(Pose::Positions(pose)) => Some(Rc::clone(pose)),
            _ => None,
        };
        let of_mesh =
            |mesh: &Mesh| size_of_val(&*mesh.positions) + size_of_val(mesh.faces.indices());
        own(target(self), other.and_then(target)).map_or(0, |mesh| of_mesh(&mesh))
            + own(pose(self), other.and_then(pose)).map_or(0, |pose| size_of_val(&*pose))
    }

    pub(crate) fn with_weights(self, weights: Weights) -> Settings {
        Settings { weights, ..self }
    }

    pub(crate) fn put_in(self, scene: &mut Scene) {
        let Settings { weights, to, target, pose, boundary, smoothness, solver, attempt } = self;
        scene.weights = weights;
        scene.closeness.to = to;
        scene.closeness.target = target;
        scene.pose = pose;
        scene.closeness.boundary = boundary;
        scene.smoothness = smoothness;
        scene.solver = solver;
        scene.attempt = attempt;
    }
}

impl Part {
    /// Puts the part in `scene`, and stores the previous value.
    pub(crate) fn exchange(&mut self, scene: &mut Scene) {
        match self {
            Part::Units(units) => swap(units, &mut scene.units),
            Part::Up(up) => swap(up, &mut scene.up),
            Part::Tolerance(tolerance) => swap(tolerance, &mut scene.tolerance),
            Part::Lesson(lesson) => swap(lesson, &mut scene.lesson),
            Part::Build(build) => swap(build, &mut scene.build),
            Part::Variants(variants) => swap(variants, &mut scene.variants),
            Part::Steps(steps) => swap(steps, &mut scene.steps),
            Part::Settings(settings) => {
                let before = Settings::of(scene);
                std::mem::replace(settings, before).put_in(scene);
            }
            Part::ClosenessWeights(weights) => swap(weights, &mut scene.closeness.weights),
            Part::Set(name, set) => {
                *set = match set.take() {
                    Some(set) => scene.sets.insert(name.clone(), set),
                    None => scene.sets.remove(name),
                };
            }
            Part::RowName(index, name) => swap(name, &mut scene.constraints[*index].name),
            Part::RowValues(index, RowValues { kind, weight, enabled, require, eased }) => {
                let row = &mut scene.constraints[*index];
                swap(kind, &mut row.kind);
                swap(weight, &mut row.weight);
                swap(enabled, &mut row.enabled);
                swap(require, &mut row.require);
                swap(eased, &mut row.eased);
            }
            Part::Row(index, row) => {
                *row = match row.take() {
                    Some(row) => {
                        scene.constraints.insert(*index, row);
                        None
                    }
                    None => Some(scene.constraints.remove(*index)),
                };
            }
            Part::Rows(rows) => swap(rows, &mut scene.constraints),
        }
    }

    /// Whether `scene` already has this value.
    pub(crate) fn is_in(&self, scene: &Scene) -> bool {
        match self {
            Part::Units(units) => *units == scene.units,
            Part::Up(up) => *up == scene.up,
            Part::Tolerance(tolerance) => *tolerance == scene.tolerance,
            Part::Lesson(lesson) => *lesson == scene.lesson,
            Part::Build(build) => *build == scene.build,
            Part::Variants(variants) => *variants == scene.variants,
            Part::Steps(steps) => *steps == scene.steps,
            Part::Settings(settings) => *settings == Settings::of(scene),
            Part::ClosenessWeights(weights) => *weights == scene.closeness.weights,
            Part::Set(name, set) => set.as_ref() == scene.sets.get(name),
            Part::RowName(index, name) => *name == scene.constraints[*index].name,
            Part::RowValues(index, values) => *values == RowValues::of(&scene.constraints[*index]),
            Part::Row(..) => false,
            Part::Rows(rows) => *rows == scene.constraints,
        }
    }

    /// Whether `scene`, with which the part was exchanged, asks for other hard constraints than before.
    pub(crate) fn asks_otherwise(&self, scene: &Scene) -> bool {
        let is_hard = |enabled: bool, require: Require| enabled && require.is_hard();
        let is_hard_row = |row: &ConstraintSpec| is_hard(row.enabled, row.require);
        let rows = &scene.constraints;
        match self {
            Part::Rows(_) => true,
            Part::Row(index, row) => row.as_ref().or(rows.get(*index)).is_some_and(is_hard_row),
            Part::RowValues(index, before) => rows.get(*index).is_some_and(|row| {
                let was_hard = is_hard(before.enabled, before.require);
                !before.asks_as(row) && (was_hard || is_hard_row(row))
            }),
            Part::Set(name, _) => {
                rows.iter().any(|row| is_hard_row(row) && row.on.named() == Some(name))
            }
            _ => false,
        }
    }

    /// Returns the effect of having been exchanged with `scene`.
    pub(crate) fn effect(&self, scene: &Scene) -> Effect {
        match self {
            Part::Units(_)
            | Part::Up(_)
            | Part::Tolerance(_)
            | Part::Lesson(_)
            | Part::Build(_)
            | Part::Steps(_)
            | Part::RowName(..) => Effect::Nothing,
            Part::Variants(before) => match same_design(before, &scene.variants) {
                true => Effect::Nothing,
                false => Effect::Problem,
            },
            Part::Settings(before) => {
                let now = Settings::of(scene);
                // The solver does not know how hard constraints were met.
                let before = Settings { attempt: now.attempt, ..before.clone() };
                if before == now {
                    Effect::Nothing
                } else if before.with_weights(now.weights) == now {
                    Effect::Weights
                } else {
                    Effect::Problem
                }
            }
            Part::Set(name, _) => match is_used(name, scene) {
                true => Effect::Problem,
                false => Effect::Nothing,
            },
            Part::ClosenessWeights(_) | Part::RowValues(..) | Part::Row(..) | Part::Rows(_) => {
                Effect::Problem
            }
        }
    }

    /// Returns the parts of `to` that differ from those of `from`: exchanged with `from`, they make
    /// it `to`. Title, mesh, handles and positions are not compared.
    pub(crate) fn between(from: &Scene, to: &Scene) -> Vec<Part> {
        let mut parts = vec![
            Part::Units(to.units.clone()),
            Part::Up(to.up),
            Part::Tolerance(to.tolerance),
            Part::Lesson(to.lesson.clone()),
            Part::Build(to.build.clone()),
            Part::Variants(to.variants.clone()),
            Part::Steps(to.steps.clone()),
            Part::Settings(Settings::of(to)),
            Part::ClosenessWeights(to.closeness.weights.clone()),
        ];
        let names =
            from.sets.keys().chain(to.sets.keys().filter(|name| !from.sets.contains_key(*name)));
        parts.extend(names.map(|name| Part::Set(name.clone(), to.sets.get(name).cloned())));
        if equal_except_names(&from.constraints, &to.constraints) {
            let names = to.constraints.iter().map(|row| row.name.clone());
            parts.extend((0..).zip(names).map(|(index, name)| Part::RowName(index, name)));
        } else {
            parts.push(Part::Rows(to.constraints.clone()));
        }
        parts.retain(|part| !part.is_in(from));
        parts
    }

    /// Memory in bytes, including the heap.
    pub(crate) fn bytes(&self) -> usize {
        let held = match self {
            Part::Units(text) | Part::RowName(_, text) => text.len(),
            // See [`Settings::bytes_beside`].
            Part::Up(_) | Part::Tolerance(_) | Part::Settings(_) => 0,
            Part::RowValues(_, values) => bytes_of_eased(values.eased.as_ref()),
            Part::Lesson(lesson) => lesson.as_ref().map_or(0, bytes_of_lesson),
            Part::Build(build) => build.as_ref().map_or(0, |_| size_of::<BuildSettings>()),
            // Consecutive lists share their shapes.
            Part::Variants(variants) => size_of_val(&*variants.kept),
            Part::Steps(steps) => steps.iter().map(bytes_of_step).sum(),
            Part::ClosenessWeights(weights) => {
                size_of_val(&**weights)
                    + weights.iter().map(|entry| bytes_of_selector(&entry.on)).sum::<usize>()
            }
            Part::Set(name, set) => name.len() + set.as_ref().map_or(0, bytes_of_set),
            Part::Row(_, row) => row.as_ref().map_or(0, bytes_of_row),
            Part::Rows(rows) => size_of_val(&**rows) + rows.iter().map(bytes_of_row).sum::<usize>(),
        };
        size_of::<Part>() + held
    }
}

/// Whether rows are equal except for their names.
fn equal_except_names(from: &[ConstraintSpec], to: &[ConstraintSpec]) -> bool {
    let alike = |(a, b): (&ConstraintSpec, &ConstraintSpec)| {
        let values = |row: &ConstraintSpec| (row.weight, row.enabled, row.require);
        (&a.kind, &a.on, &a.eased, values(a)) == (&b.kind, &b.on, &b.eased, values(b))
    };
    from.len() == to.len() && from.iter().zip(to).all(alike)
}

/// Whether two scenes pose the same problem to the solver.
pub(crate) fn same_problem(a: &Scene, b: &Scene) -> bool {
    Settings::of(a) == Settings::of(b)
        && a.closeness.weights == b.closeness.weights
        && same_design(&a.variants, &b.variants)
        && equal_except_names(&a.constraints, &b.constraints)
        && a.sets.keys().chain(b.sets.keys()).all(|name| {
            a.sets.get(name) == b.sets.get(name) || !(is_used(name, a) || is_used(name, b))
        })
}

/// Whether constraints, and whether closeness weights of a scene are on the set of this name.
pub(crate) fn uses(name: &str, scene: &Scene) -> [bool; 2] {
    let is_it = |on: &Selector| on.named() == Some(name);
    [
        scene.constraints.iter().any(|row| is_it(&row.on)),
        scene.closeness.weights.iter().any(|entry| is_it(&entry.on)),
    ]
}

fn is_used(name: &str, scene: &Scene) -> bool {
    uses(name, scene).contains(&true)
}

fn same_design(a: &Variants, b: &Variants) -> bool {
    a.design_positions() == b.design_positions()
}

/// What is here, unless it is what is there.
fn own<T: ?Sized>(here: Option<Rc<T>>, there: Option<Rc<T>>) -> Option<Rc<T>> {
    here.filter(|here| !there.is_some_and(|there| Rc::ptr_eq(here, &there)))
}

fn bytes_of_row(row: &ConstraintSpec) -> usize {
    row.name.len() + bytes_of_selector(&row.on) + bytes_of_eased(row.eased.as_ref())
}

fn bytes_of_eased(eased: Option<&EasedFaces>) -> usize {
    eased.map_or(0, |eased| size_of_val(&*eased.faces))
}

fn bytes_of_selector(on: &Selector) -> usize {
    match on {
        Selector::Vertices(vertices) => size_of_val(&**vertices),
        Selector::Set(name) => name.len(),
        Selector::Each { within, .. } => within.as_ref().map_or(0, String::len),
    }
}

fn bytes_of_set(set: &Set) -> usize {
    size_of_val(&*set.vertices) + size_of_val(&*set.faces)
}

fn bytes_of_step(step: &Slide) -> usize {
    size_of::<Slide>() + step.title.len() + step.text.len() + step.notes.len()
}

fn bytes_of_lesson(lesson: &Lesson) -> usize {
    lesson.text.len() + lesson.goals.len() * size_of::<Goal>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_boundary_that_the_user_has_set_keeps_its_corners_and_weight() {
        // An attempt replaced them by the defaults, for good, and made exact what was held softly.
        let mut settings = Settings::of(&Scene::default());
        for require in [BoundaryRequire::Off, BoundaryRequire::Soft] {
            let own = BoundaryCloseness { require, weight: 5.0, corners: 30.0 };
            settings.boundary = own;
            let exact = BoundaryCloseness { require: BoundaryRequire::Exact, ..own };
            let held = settings.clone().on_boundary();
            assert_eq!(held.boundary, exact);
            assert_eq!(held.before_attempt().boundary, own);
        }
    }

    #[test]
    fn surfaces_that_were_tried_count_towards_the_limit_of_undo_once() {
        // The meshes of all of them stayed in memory.
        let mesh = || Mesh { positions: vec![[0.0; 3]; 1000], ..Mesh::default() };
        let mut settings = Settings::of(&Scene::default());
        assert_eq!(settings.bytes_beside(None), 0);
        settings.target = Some(Target::Mesh(Rc::new(mesh())));
        let same = settings.clone();
        settings.pose = Some(Pose::Positions(mesh().positions.into()));
        assert_eq!(settings.bytes_beside(None), 48_000);
        assert_eq!(settings.bytes_beside(Some(&same)), 24_000);
        settings.target = Some(Target::Mesh(Rc::new(mesh())));
        assert_eq!(settings.bytes_beside(Some(&same)), 48_000);
    }
}
