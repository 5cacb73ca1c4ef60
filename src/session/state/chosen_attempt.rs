//! What a search for a shape has changed of the settings of a scene.

use crate::scene::{AttemptStart, BoundaryRequire, ChosenAttempt, ClosenessTo, Scene};

/// Leaves the search where other hard constraints are asked for than those that it has met, or
/// elsewhere: how it met them, and its larger tolerances, say nothing about these.
pub(crate) fn leave_search(scene: &mut Scene) {
    scene.attempt.from = AttemptStart::Soft;
    scene.constraints.iter_mut().for_each(|row| row.eased = None);
}

/// Changes the settings of a scene as an attempt does, which the scene then names.
pub(crate) fn choose_attempt(scene: &mut Scene, chosen: ChosenAttempt) {
    scene.weights.smooth *= chosen.smoother;
    if chosen.on_surface {
        scene.closeness.to = ClosenessTo::Surface;
        hold_boundary(scene, BoundaryRequire::Soft);
    }
    scene.attempt = scene.attempt.then(chosen);
}

/// Holds the vertices of the boundary on it, softly or exactly, but not less than the user does.
pub(crate) fn hold_boundary(scene: &mut Scene, require: BoundaryRequire) {
    let before = scene.closeness.boundary.require;
    scene.closeness.boundary.require = before.max(require);
    scene.attempt.holds_boundary |= before == BoundaryRequire::Off;
    scene.attempt.hardens_boundary |=
        before == BoundaryRequire::Soft && require == BoundaryRequire::Exact;
}

/// Returns the attempt that the scene names after the user has changed it from `before` to `now`: what the
/// user has changed is not the search's.
pub(super) fn attempt_after(before: &Scene, now: &Scene) -> ChosenAttempt {
    let mut attempt = now.attempt;
    let [from, to] = [before, now].map(|scene| &scene.closeness);
    if (from.to, &from.target, &before.pose) != (to.to, &to.target, &now.pose) {
        attempt.from = AttemptStart::Soft;
    }
    if before.weights.smooth != now.weights.smooth {
        attempt.smoother = 1.0;
    }
    attempt.on_surface &= from.to == to.to;
    let has_boundary = from.boundary == to.boundary;
    attempt.holds_boundary &= has_boundary;
    attempt.hardens_boundary &= has_boundary;
    attempt
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
            hold_boundary(&mut scene, BoundaryRequire::Exact);
            assert_eq!(scene.closeness.boundary, exact);
            scene.as_asked();
            assert_eq!(scene.closeness.boundary, own);
        }
    }
}
