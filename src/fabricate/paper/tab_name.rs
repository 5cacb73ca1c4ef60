//! The name on a tab: as high as possible between the sides of the tab, which converge away from
//! the piece.

use super::tab::Tab;
use crate::fabricate::panel::direction_of;
use crate::fabricate::sheet::text_width;
use crate::math::plane::{Point2, rotated};

/// Largest height of names on tabs, in mm.
const TALLEST: f64 = 3.5;
/// Smallest height; lower names are written on the panel.
const LEAST: f64 = 1.8;
/// Largest height relative to the tab.
const OF_TAB: f64 = 0.55;
/// Distance of letters from cut and folded lines, in mm.
const CLEAR: f64 = 0.5;

/// The height of a name on a tab and its centre, along the side of the tab; none if it has no room.
pub(super) fn place_on_tab(tab: &Tab, name: &str) -> Option<(f64, Point2)> {
    let [p, a, b, q] = tab.corners;
    let along = direction_of(p, q);
    // From the start of the side: along it, and away from the piece.
    let frame = |[x, y]: Point2| {
        let [x, y] = rotated([x - p[0], y - p[1]], [along[0], -along[1]]);
        [x, -y]
    };
    let [left, right, end] = [a, b, q].map(frame);
    // Inward slope of each end of the tab, and the clearance it requires along the text.
    let (lean_in, lean_out) = (left[0] / tab.height, (end[0] - right[0]) / tab.height);
    let beside = |lean: f64| CLEAR * (1.0 + lean * lean).sqrt();
    let mut height = (OF_TAB * tab.height).min(TALLEST);
    while height >= LEAST {
        let spare = tab.height - height;
        // Centred, or else close to the fold, where the tab is wider.
        for below in [0.5 * spare, CLEAR] {
            if below < CLEAR || spare - below < CLEAR {
                continue;
            }
            let top = below + height;
            let from = lean_in * top + beside(lean_in);
            let to = end[0] - lean_out * top - beside(lean_out);
            if to - from >= text_width(name, height) {
                let [x, y] = rotated([0.5 * (from + to), -(below + 0.5 * height)], along);
                return Some((height, [p[0] + x, p[1] + y]));
            }
        }
        height *= 0.93;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::panel::distance_to_outline;
    use crate::fabricate::sheet::strokes;
    use crate::math::plane::is_inside;

    #[test]
    fn letters_keep_clear_of_the_sides_of_their_tab_however_it_leans() {
        let side = (0, 0);
        let mut named = 0;
        for turn in [[1.0, 0.0], [0.6, 0.8], [-0.8, -0.6]] {
            for (length, slopes) in
                [(30.0, [4.0, 4.0]), (14.0, [4.0, 1.0]), (9.0, [0.5, 3.0]), (6.0, [2.0, 2.0])]
            {
                for height in [2.5, 4.0, 8.0] {
                    let [s, t] = slopes.map(|slope: f64| slope * height / 8.0);
                    let points = [[0.0, 0.0], [s, -height], [length - t, -height], [length, 0.0]];
                    let corners = points.map(|point| rotated(point, turn));
                    let tab = Tab { side, corners, height };
                    let Some((own, centre)) = place_on_tab(&tab, "P47") else { continue };
                    named += 1;
                    for point in strokes("P47", own, centre, turn).into_iter().flatten() {
                        assert!(is_inside(&corners, point), "{length} {height}");
                        let clear = distance_to_outline(&corners, point);
                        assert!(clear >= CLEAR - 1e-9, "{length} {height}: {clear}");
                    }
                }
            }
        }
        assert!(named >= 18, "{named}");
    }
}
