//! Faces with holes. In OBJ and PLY their corners go around the outline, over a bridge to a hole, around it
//! in the other direction, and back over the bridge.

use super::Point;
use crate::math::{Vec3, polygon_sides, sort_by_number, twice_vector_area};
use std::collections::BTreeSet;

/// The sides of each ring of a face with so many sides, where `bridge` tells a bridge from its return;
/// the first ring has the first side that is none. None if bridges are not passed there and back like
/// parentheses.
pub(crate) fn rings_of<Key: PartialEq>(
    sides: usize,
    bridge: impl Fn(usize) -> Option<Key>,
) -> Option<Vec<Vec<usize>>> {
    let (mut open, mut levels, mut rings) = (Vec::new(), vec![Vec::new()], Vec::new());
    for k in 0..sides {
        match bridge(k) {
            None => levels.last_mut()?.push(k),
            Some(own) if open.last() == Some(&own) => {
                open.pop();
                rings.extend(levels.pop());
            }
            Some(own) => {
                open.push(own);
                levels.push(Vec::new());
            }
        }
    }
    rings.extend(levels.pop());
    sort_by_number(&mut rings, |ring| ring.first().map_or(0, |&side| side as u64 + 1));
    levels.is_empty().then_some(rings)
}

/// The sides of each ring of a face of a mesh, as [`rings_of`].
fn rings(face: &[u32]) -> Option<Vec<Vec<usize>>> {
    let sides: Vec<[u32; 2]> = polygon_sides(face).collect();
    let known: BTreeSet<[u32; 2]> = sides.iter().copied().collect();
    let bridge = |k: usize| {
        let [a, b] = sides[k];
        known.contains(&[b, a]).then_some([a.min(b), a.max(b)])
    };
    rings_of(sides.len(), bridge)
}

/// The corners of a face that visits vertices twice, from the first side of its outline in the face on, if
/// it is one with holes: rings without a common vertex, all but one of them around holes.
pub(crate) fn with_holes(face: &[u32], positions: &[Point]) -> Option<Vec<u32>> {
    let rings = rings(face)?;
    let corners: BTreeSet<u32> = rings.iter().flatten().map(|&k| face[k]).collect();
    let count: usize = rings.iter().map(Vec::len).sum();
    if rings.len() < 2 || rings.iter().any(|ring| ring.len() < 3) || corners.len() < count {
        return None;
    }
    let area = |ring: &mut dyn Iterator<Item = usize>| {
        twice_vector_area(ring.map(|k| Vec3::from(positions[face[k] as usize])))
    };
    let whole = area(&mut (0..face.len()));
    // Holes are passed in the other direction.
    let is_outline = |ring: &&Vec<usize>| area(&mut ring.iter().copied()).dot(whole) > 0.0;
    let mut outlines = rings.iter().filter(is_outline);
    let (Some(outline), None) = (outlines.next(), outlines.next()) else { return None };
    let mut found = face.to_vec();
    found.rotate_left(outline[0]);
    Some(found)
}

/// The sides around the holes of a face that visits vertices twice, in its direction: all, where it is not
/// known which they are.
pub(crate) fn sides_of_holes(face: &[u32], positions: &[Point]) -> Vec<[u32; 2]> {
    let Some(face) = with_holes(face, positions) else { return polygon_sides(face).collect() };
    let holes = rings(&face).into_iter().flatten().skip(1).flatten();
    holes.map(|k| [face[k], face[(k + 1) % face.len()]]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square, and two small ones in it.
    fn squares() -> Vec<Point> {
        let square = |[x, y]: [f64; 2], side: f64| {
            [[x, y], [x + side, y], [x + side, y + side], [x, y + side]].map(|[x, y]| [x, y, 0.0])
        };
        [square([0.0, 0.0], 9.0), square([1.0, 1.0], 2.0), square([5.0, 5.0], 2.0)].concat()
    }

    #[test]
    fn a_face_with_holes_begins_with_its_outline_wherever_the_file_begins() {
        // From one hole to the next; or both from the outline.
        for face in [
            vec![0, 1, 2, 3, 0, 4, 7, 6, 8, 11, 10, 9, 8, 6, 5, 4],
            vec![0, 1, 2, 10, 9, 8, 11, 10, 2, 3, 0, 4, 7, 6, 5, 4],
        ] {
            for first in 0..face.len() {
                let mut own = face.clone();
                own.rotate_left(first);
                let found = with_holes(&own, &squares()).expect("it has holes");
                assert!(found[0] < 4 && found[1] < 4 && found[0] != found[1], "{found:?}");
                let sides = sides_of_holes(&own, &squares());
                assert!(
                    sides.len() == 8 && sides.as_flattened().iter().all(|v| *v > 3),
                    "{sides:?}"
                );
                let again = with_holes(&found, &squares()).expect("it has holes");
                assert_eq!(again, found);
            }
        }
    }

    #[test]
    fn what_only_touches_itself_has_no_holes() {
        for face in [
            // Two rings at one vertex, a slit, a hole in the direction of the outline, and none.
            vec![0, 1, 2, 0, 5, 6],
            vec![0, 1, 2, 3, 0, 4],
            vec![0, 1, 2, 3, 0, 4, 5, 6, 7, 4],
            vec![0, 1, 2, 3],
            vec![],
        ] {
            assert_eq!(with_holes(&face, &squares()), None, "{face:?}");
        }
    }
}
