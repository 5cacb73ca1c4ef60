//! Pieces of panels: laid side by side at the seams that their names tell, on the plates behind them.

use super::files::Part;
use super::letters::Text;
use super::outline::{widened, written};
use shape_up::math::plane::{Point2, area, cross, distance, dot, minus, rotated};
use std::collections::{BTreeMap, BTreeSet};

/// The panel of a piece such as `P12.1`.
fn panel_of(name: &str) -> Option<&str> {
    name.split_once('.').map(|(panel, _)| panel)
}

/// A rotation as cosine and sine, and then a translation.
#[derive(Clone, Copy)]
struct Motion {
    turn: Point2,
    by: Point2,
}

impl Motion {
    /// Takes `from` onto `to`, which are equally long.
    fn between(from: [Point2; 2], to: [Point2; 2]) -> Motion {
        let (u, v) = (minus(from[1], from[0]), minus(to[1], to[0]));
        let size = (dot(u, u) * dot(v, v)).sqrt();
        let turn = [dot(u, v) / size, cross(u, v) / size];
        Motion { turn, by: minus(to[0], rotated(from[0], turn)) }
    }

    fn put(&self, point: Point2) -> Point2 {
        let [x, y] = rotated(point, self.turn);
        [x + self.by[0], y + self.by[1]]
    }
}

/// The parts, with panels put together from their pieces: as if they were cut whole, and named in the
/// place of the first piece.
pub(super) fn joined(parts: Vec<Part>, kerf: f64) -> Vec<Part> {
    let (pieces, mut whole): (Vec<Part>, Vec<Part>) =
        parts.into_iter().partition(|part| panel_of(&part.name).is_some());
    let mut panels: BTreeMap<String, BTreeMap<String, Part>> = BTreeMap::new();
    for piece in pieces {
        let panel = panel_of(&piece.name).unwrap().to_owned();
        panels.entry(panel).or_default().insert(piece.name.clone(), piece);
    }
    whole.extend(panels.into_iter().map(|(name, own)| panel(name, own, kerf)));
    whole
}

/// A panel of its pieces and plates.
fn panel(name: String, mut pieces: BTreeMap<String, Part>, kerf: f64) -> Part {
    let mut plates: BTreeMap<String, Part> = BTreeMap::new();
    for plate in pieces.keys().filter(|name| name.contains('-')).cloned().collect::<Vec<_>>() {
        plates.insert(plate.clone(), pieces.remove(&plate).unwrap());
    }
    // What is left when the kerf is cut, and what is written at each side.
    let cut: BTreeMap<&str, (Vec<Point2>, Vec<Option<String>>)> = pieces
        .iter()
        .map(|(name, piece)| {
            let beside = written(name, &piece.outline, &piece.texts);
            (&**name, (widened(&piece.outline, &vec![-0.5 * kerf; piece.outline.len()]), beside))
        })
        .collect();
    let is_seam = |beyond: &Option<String>| {
        beyond.as_ref().is_some_and(|beyond| panel_of(beyond) == Some(&*name))
    };
    let first = format!("{name}.1");
    let still = Motion { turn: [1.0, 0.0], by: [0.0; 2] };
    let mut placed: BTreeMap<&str, Motion> = BTreeMap::from([(&*first, still)]);
    let mut queue = vec![&*first];
    let mut joined: BTreeSet<String> = BTreeSet::new();
    while let Some(own) = queue.pop() {
        let (outline, beside) = &cut[own];
        for (k, beyond) in beside.iter().enumerate().filter(|(_, beyond)| is_seam(beyond)) {
            let (other, _) = cut.get_key_value(&**beyond.as_ref().unwrap()).unwrap();
            let (there, back) = &cut[other];
            let i = back.iter().position(|beyond| beyond.as_deref() == Some(own)).unwrap();
            let side =
                |outline: &[Point2], k: usize| [outline[k], outline[(k + 1) % outline.len()]];
            let seam = side(outline, k).map(|point| placed[own].put(point));
            let [a, b] = side(there, i);
            let motion = Motion::between([b, a], seam);
            let off = distance(motion.put(a), seam[1]);
            assert!(off < 0.01, "{own} and {other} have seams of other lengths: {off}");
            let number = |name: &str| name.split_once('.').unwrap().1.parse::<u32>().unwrap();
            let (low, high) = (number(own).min(number(other)), number(own).max(number(other)));
            joined.insert(format!("{name}.{low}-{high}"));
            match placed.get(other) {
                Some(known) => {
                    let off = distance(known.put(a), motion.put(a));
                    assert!(off < 0.01, "{other} has two places, {off} apart");
                }
                None => {
                    placed.insert(other, motion);
                    queue.push(other);
                }
            }
        }
    }
    assert_eq!(placed.len(), pieces.len(), "{name} is in several pieces");
    assert_eq!(joined, plates.keys().cloned().collect(), "each seam has a plate");
    for plate in plates.values() {
        assert!(area(&plate.outline) > 0.0 && plate.outline.len() == 4);
    }
    // The sides that are no seams, one after another, and straight ones as one.
    let mut sides: Vec<[Point2; 2]> = Vec::new();
    for (own, (outline, beside)) in &cut {
        for (k, _) in beside.iter().enumerate().filter(|(_, beyond)| !is_seam(beyond)) {
            let ends = [outline[k], outline[(k + 1) % outline.len()]];
            sides.push(ends.map(|point| placed[own].put(point)));
        }
    }
    let mut around = vec![sides.swap_remove(0)];
    while let Some(next) =
        sides.iter().position(|side| distance(side[0], around[around.len() - 1][1]) < 0.01)
    {
        around.push(sides.swap_remove(next));
    }
    assert!(sides.is_empty(), "the outline of {name} is one");
    let n = around.len();
    let is_corner = |k: &usize| {
        let [u, v] = [around[(k + n - 1) % n], around[*k]].map(|[p, q]| minus(q, p));
        cross(u, v).abs() > 1e-4 * (dot(u, u) * dot(v, v)).sqrt()
    };
    let outline: Vec<Point2> = (0..n).filter(is_corner).map(|k| around[k][0]).collect();
    let mut texts: Vec<Text> = Vec::new();
    for (own, piece) in &pieces {
        for text in piece.texts.iter().filter(|text| panel_of(&text.text) != Some(&*name)) {
            // Both pieces at an end of a seam name the panel beyond.
            if texts.iter().all(|known| known.text != text.text) {
                texts.push(Text { centre: placed[&**own].put(text.centre), ..text.clone() });
            }
        }
    }
    Part {
        outline: widened(&outline, &vec![0.5 * kerf; outline.len()]),
        texts,
        folds: Vec::new(),
        valleys: Vec::new(),
        // It does not move.
        arrow: pieces[&first].arrow,
        holes: Vec::new(),
        name,
    }
}
