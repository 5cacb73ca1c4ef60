//! Point sets on which closed forms fail.

use crate::support::random::{Points, Random};
use crate::support::shapes::cloud;
use shape_up::math::Vec3;

/// Inputs on which closed forms fail, by name.
pub(crate) fn degenerate(n: usize) -> Vec<(&'static str, Points)> {
    let mut random = Random::new(n as u64);
    let [e, f, g] = random.frame();
    let ramp = |i: usize| i as f64 - 0.4 * (i * i % 3) as f64;
    let line: Points = (0..n).map(|i| e * ramp(i)).collect();
    let flat: Points = (0..n).map(|i| e * ramp(i) + f * ((i * i) % 5) as f64).collect();
    let near = |points: &Points, d: f64, random: &mut Random| -> Points {
        points.iter().map(|v| *v + random.vector() * d).collect()
    };
    let with_centre: Points = (0..n)
        .map(|i| match i % 5 {
            0 => e,
            1 => f,
            2 => -e,
            3 => -f,
            _ => Vec3::zero(),
        })
        .collect();
    let mut sets = vec![
        ("zeros", vec![Vec3::zero(); n]),
        ("all equal", vec![e * 3.7; n]),
        ("all equal, far away", vec![e * 1e9 + f * 3.3e8 + g; n]),
        ("two places", (0..n).map(|i| if i % 2 == 0 { e } else { f }).collect()),
        ("one apart", (0..n).map(|i| if i == 0 { e } else { f }).collect()),
        ("collinear", line.clone()),
        ("along an axis", (0..n).map(|i| Vec3::new(0.0, ramp(i), 0.0)).collect()),
        ("collinear, far away", line.iter().map(|v| *v + f * 1e8).collect()),
        ("coplanar", flat.clone()),
        ("a cross and its centre", with_centre),
        ("cube corners", (0..n).map(corner).collect()),
        ("random, far away", cloud(&mut random, n, 1.0).iter().map(|v| *v + f * 1e8).collect()),
    ];
    for d in [1e-15, 1e-12, 1e-9, 1e-6, 1e-3] {
        sets.push(("nearly coincident", near(&vec![e; n], d, &mut random)));
        sets.push(("nearly collinear", near(&line, d, &mut random)));
        sets.push(("nearly coplanar", near(&flat, d, &mut random)));
    }
    sets
}

fn corner(i: usize) -> Vec3<f64> {
    let side = |bit: usize| if (i >> bit) & 1 == 0 { -1.0 } else { 1.0 };
    Vec3::new(side(0), side(1), side(2))
}
