//! The arrow of a part, beside its name.

use super::text_box::TextBox;
use crate::fabricate::panel::distance_to_outline;
use crate::math::plane::Point2;

/// The lines of an arrow in this direction, as long as a letter is high, and its box, beside the name,
/// whose box is the first of those taken; none without room.
pub(super) fn arrow_beside_name(
    rings: &[&[Point2]],
    taken: &[TextBox],
    height: f64,
    along: Point2,
) -> Option<([Vec<Point2>; 2], TextBox)> {
    let own = taken.first().copied()?;
    let half = [0.5 * height, 0.25 * height];
    let [c, s] = along;
    // Ahead of the name, just outside its box, else on either side of it, or behind.
    let beside = [along, [-s, c], [s, -c], [-c, -s]].map(|way| {
        let at = |away: f64| {
            let centre = [0, 1].map(|x| own.centre[x] + away * way[x]);
            TextBox { centre, along, half }
        };
        // Farther away than this it is apart.
        let most = own.half[0] + own.half[1] + height;
        let mut away = 0.0;
        while away < most && !at(away).is_apart(&own) {
            away += 0.1 * height;
        }
        at(away)
    });
    let has_room = |found: &TextBox| {
        let tip = [0, 1].map(|x| found.centre[x] + half[0] * along[x]);
        taken.iter().all(|other| found.is_apart(other))
            && found.is_on(rings)
            && rings.iter().all(|ring| distance_to_outline(ring, tip) >= 0.2 * height)
    };
    let found = beside.into_iter().find(has_room)?;
    let at = |x: f64, y: f64| [found.centre[0] + c * x - s * y, found.centre[1] + s * x + c * y];
    let [x, y] = [half[0], 0.8 * half[1]];
    let head = vec![at(0.1 * x, y), at(x, 0.0), at(0.1 * x, -y)];
    Some(([vec![at(-x, 0.0), at(x, 0.0)], head], found))
}
