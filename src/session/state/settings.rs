//! The settings of a scene, and what a search for a shape has changed of them.

use crate::scene::{
    AttemptStart, BoundaryCloseness, BoundaryRequire, ChosenAttempt, ClosenessTo, Lock, Pose,
    Scene, Smoothness, SolverSettings, Target, Weights,
};
use crate::solve::Problem;

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

/// Leaves the search where other hard constraints are asked for than those that it has met, or
/// elsewhere: how it met them, and its larger tolerances, say nothing about these.
pub(crate) fn leave_search(scene: &mut Scene) {
    scene.attempt.from = AttemptStart::Soft;
    scene.constraints.iter_mut().for_each(|row| row.eased = None);
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
        chosen.take_back(&mut self.weights.smooth, &mut self.to, &mut self.boundary.require);
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

    /// The settings of a scene, without the numbers of its boundary that have no effect.
    pub(crate) fn in_effect(scene: &Scene) -> Settings {
        let boundary = scene.closeness.boundary.in_effect();
        Settings { boundary, ..Settings::of(scene) }
    }

    /// The settings that the solver knows: not how hard constraints were met.
    pub(crate) fn without_attempt(self) -> Settings {
        Settings { attempt: ChosenAttempt::default(), ..self }
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
}
