//! The two choices that users have, from 0 to 1, and the weights of the map that they stand for
//! (section 5 of `reference/quads.md` has their effects).

/// From few irregular vertices to a small move: the weights of alignment with curvature.
const FOLLOW: [(f64, f64); 4] = [(0.0, 0.0), (1.0 / 3.0, 5.0), (2.0 / 3.0, 20.0), (1.0, 80.0)];
/// From a small move to even panels: the weights of directions against sizes.
const EVEN: [(f64, f64); 4] = [(0.0, 100.0), (0.25, 30.0), (0.5, 10.0), (1.0, 1.0)];

/// The weight of alignment with curvature, lambda, of a share: 0 has few irregular vertices, 1 a small
/// move to circular panels.
pub fn follow_weight(share: f64) -> f64 {
    interpolated(&FOLLOW, share)
}

/// The weight of directions against sizes, D, of a share: 0 has a small move, 1 even panels.
pub fn direction_weight(even: f64) -> f64 {
    interpolated(&EVEN, even)
}

/// The value at `x` of the polyline through points of ascending abscissa, constant beyond its ends.
fn interpolated(points: &[(f64, f64)], x: f64) -> f64 {
    let after = points.iter().position(|point| point.0 >= x).unwrap_or(points.len() - 1);
    let (b, b_value) = points[after];
    let (a, a_value) = points[after.saturating_sub(1)];
    if b > a { a_value + (b_value - a_value) * ((x - a) / (b - a)).min(1.0) } else { b_value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quads::{MapOptions, PanelSize};

    #[test]
    fn sliders_pass_through_the_values_of_the_document() {
        let found = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0, 2.0].map(follow_weight);
        assert_eq!(found, [0.0, 5.0, 20.0, 80.0, 80.0]);
        let found = [-1.0, 0.0, 0.25, 0.5, 1.0].map(direction_weight);
        assert_eq!(found, [100.0, 100.0, 30.0, 10.0, 1.0]);
        let defaults = MapOptions::of_size(PanelSize::Count(1));
        assert_eq!(defaults.follow, follow_weight(2.0 / 3.0));
        assert_eq!(defaults.direction, direction_weight(0.25));
    }
}
