//! Faces that can be replaced: which face lies on the left of each directed side.

use crate::math::polygon_sides;
use std::collections::BTreeMap;

/// A list of faces with the face of each side.
#[derive(Clone, Debug, Default)]
pub(super) struct Panels {
    faces: Vec<Option<Vec<usize>>>,
    /// The faces on the left of the sides from one node to another: one, unless two edges of the
    /// grid have the same ends.
    on_left: BTreeMap<[usize; 2], Vec<usize>>,
}

impl Panels {
    /// Enters all faces.
    pub(super) fn of(faces: Vec<Vec<usize>>) -> Panels {
        let mut panels = Panels::default();
        faces.into_iter().for_each(|face| panels.add(face));
        panels
    }

    /// Adds a face.
    pub(super) fn add(&mut self, face: Vec<usize>) {
        let index = self.faces.len();
        for side in polygon_sides(&face) {
            self.on_left.entry(side).or_default().push(index);
        }
        self.faces.push(Some(face));
    }

    /// Removes a face, if it is there.
    pub(super) fn take(&mut self, index: usize) -> Option<Vec<usize>> {
        let face = self.faces[index].take()?;
        for side in polygon_sides(&face) {
            if let Some(faces) = self.on_left.get_mut(&side) {
                faces.retain(|&other| other != index);
            }
        }
        Some(face)
    }

    /// A face, if it is there.
    pub(super) fn face(&self, index: usize) -> Option<&[usize]> {
        self.faces.get(index)?.as_deref()
    }

    /// The indices of all faces that are there.
    pub(super) fn indices(&self) -> impl Iterator<Item = usize> {
        (0..self.faces.len()).filter(|&index| self.faces[index].is_some())
    }

    /// The face on the left of a side.
    pub(super) fn left(&self, from: usize, to: usize) -> Option<usize> {
        self.on_left.get(&[from, to])?.first().copied()
    }

    /// Whether some face has a side between two nodes.
    pub(super) fn has_edge(&self, a: usize, b: usize) -> bool {
        self.left(a, b).is_some() || self.left(b, a).is_some()
    }

    /// All faces that are there.
    pub(super) fn into_faces(self) -> Vec<Vec<usize>> {
        self.faces.into_iter().flatten().collect()
    }
}

/// The polygon around two faces that share the side from `a` to `b` of the first; without spurs,
/// that is edges that it passes in both directions one after the other.
pub(super) fn merged(first: &[usize], second: &[usize], [a, b]: [usize; 2]) -> Vec<usize> {
    let after = |face: &[usize], [from, to]: [usize; 2]| -> Vec<usize> {
        let at = polygon_sides(face).position(|side| side == [from, to]).unwrap_or(0);
        (0..face.len()).map(|k| face[(at + 1 + k) % face.len()]).collect()
    };
    // From b around to a, and in the second face from a around to b.
    let mut polygon = after(first, [a, b]);
    let other = after(second, [b, a]);
    polygon.extend(&other[1..other.len() - 1]);
    without_spurs(polygon)
}

fn without_spurs(mut polygon: Vec<usize>) -> Vec<usize> {
    while polygon.len() > 2 {
        let count = polygon.len();
        let spur = (0..count).find(|&k| polygon[k] == polygon[(k + 2) % count]);
        let Some(k) = spur else { break };
        // The tip and one of its equal neighbours.
        let mut gone = [(k + 1) % count, (k + 2) % count];
        gone.sort_unstable();
        polygon.remove(gone[1]);
        polygon.remove(gone[0]);
    }
    polygon
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn merging_goes_around_both_faces() {
        assert_eq!(merged(&[0, 1, 2, 3], &[1, 4, 5, 2], [1, 2]), [2, 3, 0, 1, 4, 5]);
        // They share two sides: the node between them vanishes.
        assert_eq!(merged(&[0, 1, 2, 3], &[1, 0, 4, 5, 2], [1, 2]).len(), 5);
    }
}
