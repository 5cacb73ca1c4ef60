//! Names on a node disc: its own between two slots or in the middle, an arrow on the rim at the first
//! slot, and beside each slot that of the node that its fin leads to. Names that do not fit are made
//! smaller down to a readable height, then left out and counted.

use super::label::{ALIKE, Labels, TALLEST, underline};
use super::lettering::{LEAST, strokes, text_width, upright};
use super::part::Hole;
use super::text_box::{ROOM, TextBox};
use crate::fabricate::panel::{direction_of, distance_to_outline};
use crate::math::plane::{Point2, distance, dot, length, rotated};

/// Largest height of the own name relative to the radius; smaller if that leaves room for more.
const OF_RADIUS: [f64; 3] = [0.4, 0.28, 0.2];
/// Height of the other names relative to the own one.
const OF_OWN: f64 = 0.7;
/// By this names are made smaller until there is room.
const SMALLER: f64 = 0.85;
/// Number of steps from the middle to the rim at which a name is tried.
const STEPS: u32 = 16;
/// Room at both ends of the arrow, relative to the wall between slot and rim.
const BESIDE_ARROW: f64 = 0.2;

/// A slot and its name.
#[derive(Clone, Debug)]
pub struct SlotName {
    /// Its corners; its first side leads from the axis outwards.
    pub corners: [Point2; 4],
    /// What is written beside it: the name of the node that its fin leads to.
    pub name: String,
}

/// Writes the labels of a disc about the origin that have room beside its slots, which are cut as
/// `holes`; `turn` is its rotation on the sheet.
pub fn label_disc(
    (outline, holes): (&[Point2], &[Hole]),
    name: &str,
    slots: &[SlotName],
    turn: Point2,
) -> Labels {
    let mut best: Option<(usize, Labels)> = None;
    for tallest in OF_RADIUS {
        let labels = labels_of((outline, holes), (name, tallest), slots, turn);
        let missing = labels.dropped + usize::from(labels.small);
        if best.as_ref().is_none_or(|(least, _)| missing < *least) {
            best = Some((missing, labels));
        }
        if missing == 0 {
            break;
        }
    }
    best.map_or_else(Labels::default, |(_, labels)| labels)
}

/// As [`label_disc`], with a largest height of the own name relative to the radius.
fn labels_of(
    (outline, holes): (&[Point2], &[Hole]),
    (name, tallest): (&str, f64),
    slots: &[SlotName],
    turn: Point2,
) -> Labels {
    let radius = outline.first().map_or(0.0, |&corner| length(corner));
    // A circle within the outline.
    let room = distance_to_outline(outline, [0.0; 2]);
    let mut labels = Labels::default();
    let mut taken: Vec<TextBox> = holes.iter().map(TextBox::of_hole).collect();
    if let Some(first) = slots.first() {
        let (lines, own) = arrow(first, radius);
        labels.lines.extend(lines);
        taken.push(own);
    }
    let found = own_name((name, tallest * radius), slots, (room, turn), &taken);
    let height = found.map_or(0.0, |(height, _)| height);
    if let Some((height, own)) = found {
        labels.lines.extend(strokes(name, height, own.centre, own.along));
        labels.texts.push(name.to_owned());
        taken.push(own);
    }
    labels.small = found.is_none();
    let mut highest: f64 = 0.0;
    for k in 0..slots.len() {
        let tallest = (OF_OWN * height).clamp(LEAST, TALLEST);
        match beside_slot((slots, room), k, tallest, turn, &taken) {
            Some((height, own)) => {
                let name = &slots[k].name;
                highest = highest.max(height);
                labels.lines.extend(strokes(name, height, own.centre, own.along));
                labels.texts.push(name.clone());
                taken.push(own);
            }
            None => labels.dropped += 1,
        }
    }
    if let Some((_, own)) = found.filter(|(height, _)| highest > ALIKE * height) {
        labels.lines.push(underline(own, text_width(name, height), height));
    }
    labels
}

/// From the middle to the rim.
fn shares() -> impl Iterator<Item = f64> {
    (0..STEPS).map(|k| f64::from(k) / f64::from(STEPS))
}

/// The height and the box of the own name: in the middle, or else half way between two slots.
fn own_name(
    (name, tallest): (&str, f64),
    slots: &[SlotName],
    (room, turn): (f64, Point2),
    taken: &[TextBox],
) -> Option<(f64, TextBox)> {
    let n = slots.len();
    let outwards = |k: usize| direction_of(slots[k % n].corners[0], slots[k % n].corners[1]);
    let between = |k: usize| {
        let ([a, b], [c, d]) = (outwards(k), outwards(k + 1));
        // Opposite slots, or a single one, leave the side to the left of the first.
        let sum = [a + c, b + d];
        match length(sum) > 1e-6 && n > 1 && a * d - b * c > 0.0 {
            true => direction_of([0.0; 2], sum),
            false => [-b, a],
        }
    };
    let mut height = tallest.clamp(LEAST, TALLEST);
    while height >= LEAST {
        for share in shares() {
            for k in 0..n {
                let away = between(k);
                let centre = away.map(|x| x * share * room);
                let level = [turn[0], -turn[1]];
                for along in [level, upright([-away[1], away[0]], turn), upright(away, turn)] {
                    let own = TextBox::of_text(name, height, centre, along);
                    if own.reach() < room && taken.iter().all(|other| own.is_apart(other)) {
                        return Some((height, own));
                    }
                }
            }
        }
        height = if height > LEAST { (SMALLER * height).max(LEAST) } else { 0.0 };
    }
    None
}

/// The height and the box of a name beside a slot, along it on either side, nearer to it than to
/// other slots.
fn beside_slot(
    (slots, room): (&[SlotName], f64),
    k: usize,
    tallest: f64,
    turn: Point2,
    taken: &[TextBox],
) -> Option<(f64, TextBox)> {
    let [from, to, across, _] = slots[k].corners;
    let name = &slots[k].name;
    let along = direction_of(from, to);
    let left = rotated(along, [0.0, 1.0]);
    let middle = [0, 1].map(|x| 0.5 * (to[x] + across[x]));
    let half = 0.5 * distance(to, across);
    let is_nearest = |point: Point2| {
        let far = |slot: &SlotName| distance_to_outline(&slot.corners, point);
        slots.iter().all(|slot| far(slot) >= far(&slots[k]) * (1.0 - 1e-9))
    };
    let radius = dot(to, along);
    let mut height = tallest;
    while height >= LEAST {
        let aside = half + (0.5 + 1.01 * ROOM) * height;
        // As far out as there is room.
        for share in shares() {
            for side in [aside, -aside] {
                let back = share * radius;
                let centre = [0, 1].map(|x| middle[x] + side * left[x] - back * along[x]);
                let found = TextBox::of_text(name, height, centre, upright(along, turn));
                if found.reach() < room
                    && taken.iter().all(|other| found.is_apart(other))
                    && is_nearest(centre)
                {
                    return Some((height, found));
                }
            }
        }
        height = if height > LEAST { (SMALLER * height).max(LEAST) } else { 0.0 };
    }
    None
}

/// An arrow from the rim to a slot, and its box.
fn arrow(slot: &SlotName, radius: f64) -> (Vec<Vec<Point2>>, TextBox) {
    let [from, to, across, _] = slot.corners;
    let along = direction_of(from, to);
    let left = rotated(along, [0.0, 1.0]);
    let foot = [0, 1].map(|x| 0.5 * (to[x] + across[x]));
    // The rim beside the axis is nearer than the radius.
    let aside = dot(foot, left);
    let wall = (radius * radius - aside * aside).sqrt() - dot(foot, along);
    let at = |away: f64, side: f64| {
        [0, 1].map(|x| foot[x] + away * wall * along[x] + side * wall * left[x])
    };
    let [tip, end] = [BESIDE_ARROW, 1.0 - BESIDE_ARROW];
    let head = tip + 0.45 * (end - tip);
    let wide = 0.2;
    let lines =
        vec![vec![at(end, 0.0), at(tip, 0.0)], vec![at(head, wide), at(tip, 0.0), at(head, -wide)]];
    let half = [0.5 * (end - tip) * wall, wide * wall];
    (lines, TextBox { centre: at(0.5 * (tip + end), 0.0), along, half })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::sheet::circle;
    use crate::math::plane::minus;

    /// A disc with slots in these directions, in degrees, from 8 mm to the wall.
    fn named(radius: f64, degrees: &[f64]) -> Labels {
        let slot = |degrees: &f64| {
            let turn = crate::math::cosine_and_sine_of_degrees(*degrees);
            let stop = radius - 4.0;
            let corners = [[8.0, -1.5], [stop, -1.5], [stop, 1.5], [8.0, 1.5]];
            let corners = corners.map(|corner| rotated(corner, turn));
            SlotName { corners, name: "N13".to_owned() }
        };
        let slots: Vec<SlotName> = degrees.iter().map(slot).collect();
        let holes: Vec<Hole> = slots.iter().map(|slot| Hole::slot(slot.corners.into())).collect();
        label_disc((&circle([0.0; 2], radius, 64), &holes), "N12", &slots, [1.0, 0.0])
    }

    #[test]
    fn a_large_disc_has_all_names_and_a_small_one_its_own() {
        let large = named(60.0, &[0.0, 90.0, 180.0, 270.0]);
        assert_eq!((large.dropped, large.small), (0, false));
        assert_eq!(large.texts, ["N12", "N13", "N13", "N13", "N13"]);
        let small = named(17.0, &[0.0, 60.0, 120.0, 180.0, 240.0, 300.0]);
        assert_eq!(small.texts.first().map(String::as_str), Some("N12"), "{:?}", small.texts);
        for labels in [large, small] {
            let far = labels.lines.iter().flatten().map(|&point| length(point));
            assert!(far.fold(0.0, f64::max) < 60.0);
        }
    }

    #[test]
    fn the_arrow_is_between_the_first_slot_and_the_rim() {
        let labels = named(20.0, &[30.0, 200.0]);
        let turn = crate::math::cosine_and_sine_of_degrees(-30.0);
        for &point in labels.lines[..2].iter().flatten() {
            let [x, y] = rotated(point, turn);
            assert!(x > 16.0 && x < 20.0 && y.abs() < 1.0, "{x} {y}");
        }
        assert!(minus(labels.lines[0][1], labels.lines[0][0])[0] < 0.0, "inwards");
    }
}
