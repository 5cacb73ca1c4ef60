//! The attempt by which a search met the hard constraints of a scene, and the settings that it has
//! changed for that.

use super::document::{AttemptStart, ChosenAttempt, Scene};
use crate::solve::{BoundaryRequire, ClosenessTo};
use crate::words;

impl ChosenAttempt {
    /// Its name in reports.
    pub(crate) fn name(&self) -> String {
        match self.from {
            AttemptStart::Eased => "eased".to_owned(),
            _ if self.on_surface => "surface".to_owned(),
            _ if self.smoother != 1.0 => format!("smoother {}", self.smoother),
            AttemptStart::Soft => "soft".to_owned(),
            AttemptStart::Rest => "rest".to_owned(),
            AttemptStart::Exact => "exact".to_owned(),
        }
    }

    /// Whether it is the first one of a search, with the settings of the user; that the boundary is held
    /// is no attempt.
    pub(crate) fn is_first(&self) -> bool {
        self.from == AttemptStart::Soft && self.smoother == 1.0 && !self.on_surface
    }

    /// Returns the attempt `next`, which a search has made with the settings of this one.
    pub(crate) fn then(self, next: ChosenAttempt) -> ChosenAttempt {
        ChosenAttempt {
            from: next.from,
            smoother: self.smoother * next.smoother,
            on_surface: self.on_surface || next.on_surface,
            ..self
        }
    }

    /// Makes the value of a setting the user's: the next search begins with it.
    pub(crate) fn release(&mut self, setting: AttemptSetting) {
        match setting {
            AttemptSetting::Smoothness => self.smoother = 1.0,
            AttemptSetting::Closeness => self.on_surface = false,
            AttemptSetting::Boundary => {
                (self.holds_boundary, self.hardens_boundary) = (false, false);
            }
        }
    }
}

/// A setting of a scene that an attempt may change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AttemptSetting {
    /// The weight of smoothness.
    Smoothness,
    /// What vertices are kept close to.
    Closeness,
    /// How the boundary is held on its curves.
    Boundary,
}

impl Scene {
    /// Changes the settings as an attempt does, which the scene then names.
    pub(crate) fn choose_attempt(&mut self, chosen: ChosenAttempt) {
        self.weights.smooth *= chosen.smoother;
        if chosen.on_surface {
            self.closeness.to = ClosenessTo::Surface;
            self.hold_boundary(BoundaryRequire::Soft);
        }
        self.attempt = self.attempt.then(chosen);
    }

    /// Holds the vertices of the boundary on it, softly or exactly, but not less than the user does.
    pub(crate) fn hold_boundary(&mut self, require: BoundaryRequire) {
        let before = self.closeness.boundary.require;
        self.closeness.boundary.require = before.max(require);
        self.attempt.holds_boundary |= before == BoundaryRequire::Off;
        self.attempt.hardens_boundary |=
            before == BoundaryRequire::Soft && require == BoundaryRequire::Exact;
    }

    /// Marks the settings that were changed since the scene `before` as the user's: the next search does
    /// not take them back.
    pub(crate) fn keep_user_changes(&mut self, before: &Scene) {
        let [from, to] = [&before.closeness, &self.closeness];
        let changed = [
            (AttemptSetting::Smoothness, before.weights.smooth != self.weights.smooth),
            (AttemptSetting::Closeness, from.to != to.to),
            (AttemptSetting::Boundary, from.boundary != to.boundary),
        ];
        if (from.to, &from.target, &before.pose) != (to.to, &to.target, &self.pose) {
            self.attempt.from = AttemptStart::Soft;
        }
        for (setting, _) in changed.into_iter().filter(|(_, differs)| *differs) {
            self.attempt.release(setting);
        }
    }

    /// Leaves the search where other hard constraints are asked for than those that it has met, or
    /// elsewhere: its start, its smoothness and its larger tolerances say nothing about these. Closeness
    /// and boundary stay, which only a press for panels tries. If it chose the surface, the next run makes
    /// one attempt there; otherwise it tries other starts and smoothness again.
    pub(crate) fn leave_search(&mut self) {
        if self.attempt.smoother != 1.0 {
            // As many digits as anybody types: without the rounding of product and quotient.
            self.weights.smooth = words::rounded(self.weights.smooth / self.attempt.smoother, 15);
        }
        self.attempt.release(AttemptSetting::Smoothness);
        self.attempt.from = AttemptStart::Soft;
        self.constraints.iter_mut().for_each(|row| row.eased = None);
    }

    /// Takes back what a search has chosen to meet the hard constraints: the settings of its attempt,
    /// and larger tolerances. The scene is then as it was asked for.
    pub fn as_asked(&mut self) {
        self.leave_search();
        let chosen = std::mem::take(&mut self.attempt);
        if chosen.on_surface {
            self.closeness.to = ClosenessTo::Rest;
        }
        let boundary = &mut self.closeness.boundary.require;
        if chosen.holds_boundary {
            *boundary = BoundaryRequire::Off;
        } else if chosen.hardens_boundary {
            *boundary = (*boundary).min(BoundaryRequire::Soft);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::BoundaryCloseness;

    #[test]
    fn a_boundary_that_the_user_has_set_keeps_its_corners_and_weight() {
        // An attempt replaced them by the defaults, for good, and made exact what was held softly.
        let mut scene = Scene::default();
        for require in [BoundaryRequire::Off, BoundaryRequire::Soft] {
            let own = BoundaryCloseness { require, weight: 5.0, corners: 30.0 };
            scene.closeness.boundary = own;
            let exact = BoundaryCloseness { require: BoundaryRequire::Exact, ..own };
            scene.hold_boundary(BoundaryRequire::Exact);
            assert_eq!(scene.closeness.boundary, exact);
            scene.as_asked();
            assert_eq!(scene.closeness.boundary, own);
        }
    }
}
