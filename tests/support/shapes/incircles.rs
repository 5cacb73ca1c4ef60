//! Quads whose opposite sides have the same sum.

use super::{Points, Random, Shape, at, in_turn_or_back};
use crate::support::random::size;
use shape_up::math::Vec3;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "incircle" => vec![Shape {
            sample: |random, _| quad(random),
            residual: |v, _| uneven([v[0], v[1], v[2], v[3]]),
            relabellings: in_turn_or_back,
            closest: |p, _, vertex| corners(p)[vertex.index],
            parameters: 12,
            exact: false,
            excess: [1e-9; 3],
            ..Shape::ANY
        }],
        "tangent-incircles" => vec![Shape {
            sample: |random, _| {
                let mut quad = quad(random);
                quad.swap(1, 2);
                quad
            },
            residual: |v, _| uneven([v[0], v[2], v[1], v[3]]),
            // Swapped ends, swapped corners, and ends swapped with corners.
            relabellings: |_, _| vec![vec![1, 0, 2, 3], vec![0, 1, 3, 2], vec![2, 3, 0, 1]],
            closest: |p, _, vertex| corners(p)[[0, 2, 1, 3][vertex.index]],
            parameters: 12,
            exact: false,
            excess: [1e-9; 3],
            ..Shape::ANY
        }],
        _ => return None,
    };
    Some(shapes)
}

/// Difference of the sums of opposite sides, relative to the size.
fn uneven([a, b, c, d]: [Vec3<f64>; 4]) -> f64 {
    let difference = (b - a).length() + (d - c).length() - (c - b).length() - (a - d).length();
    difference.abs() / size(&[a, b, c, d])
}

fn quad(random: &mut Random) -> Points {
    loop {
        let parameters: Vec<f64> = (0..12).map(|_| random.uniform()).collect();
        let quad = corners(&parameters);
        // Rejects negative (NaN) and large distances.
        if (quad[3] - quad[0]).length() < 2.0 {
            return quad.to_vec();
        }
    }
}

/// Three free corners, and the last one in a free direction from the first: its distance follows
/// from a linear equation, as for a hyperbola around one of its foci.
fn corners(p: &[f64]) -> [Vec3<f64>; 4] {
    let (a, b, c) = (at(p, 0), at(p, 3), at(p, 6));
    let longer = (b - a).length() - (c - b).length();
    let direction = at(p, 9) * (1.0 / at(p, 9).length());
    let diagonal = c - a;
    let distance =
        0.5 * (diagonal.length_squared() - longer * longer) / (direction.dot(diagonal) - longer);
    let distance = if distance >= 0.0 { distance } else { f64::NAN };
    [a, b, c, a + direction * distance]
}
