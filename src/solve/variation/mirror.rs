//! Planes of symmetry of a shape, through its centre.

use crate::constraint::Row;
use crate::math::{argsort, key_of_number, symmetric_eigen};
use nalgebra::DMatrix;

/// Vertices are mirror images up to this fraction of the size, because shapes come from iterations.
const NEAR: f64 = 1e-4;

/// A plane of symmetry.
pub(super) struct Mirror {
    normal: [f64; 3],
    /// The node whose mirror image each node of a vertex is; other nodes map to themselves.
    image: Vec<u32>,
}

impl Mirror {
    /// Finds the mirrors across coordinate planes and principal planes of `nodes`, the nodes of
    /// vertices, at positions `at` on a model of this `size`.
    pub(super) fn all(at: &[Row], nodes: &[u32], size: f64) -> Vec<Mirror> {
        let n = nodes.len() as f64;
        let mean: [f64; 3] =
            std::array::from_fn(|c| nodes.iter().map(|&node| at[node as usize][c] / n).sum());
        let relative =
            |node: u32| -> [f64; 3] { std::array::from_fn(|c| at[node as usize][c] - mean[c]) };
        let mut scatter = DMatrix::zeros(3, 3);
        for &node in nodes {
            let p = relative(node);
            (0..9).for_each(|k| scatter[(k / 3, k % 3)] += p[k / 3] * p[k % 3]);
        }
        let (_, axes) = symmetric_eigen(&scatter);
        let principal = axes.column_iter().map(|axis| [axis[0], axis[1], axis[2]]);
        let coordinate = (0..3).map(|c| std::array::from_fn(|k| f64::from(u8::from(k == c))));
        // Sorted along a direction that is unlikely to be the normal of a plane of symmetry.
        let key = |p: [f64; 3]| dot(p, [0.532, 0.301, 0.791]);
        let points: Vec<[f64; 3]> = nodes.iter().map(|&node| relative(node)).collect();
        let order = argsort(points.iter().map(|&p| key_of_number(key(p))));
        let keys: Vec<f64> = order.iter().map(|&k| key(points[k as usize])).collect();
        let near = NEAR * size;
        let find = |p: [f64; 3]| {
            let first = keys.partition_point(|&other| other < key(p) - near);
            let last = keys.partition_point(|&other| other <= key(p) + near);
            let mut found = order[first..last].iter().copied().filter(|&k| {
                let q = points[k as usize];
                let away: [f64; 3] = std::array::from_fn(|c| q[c] - p[c]);
                dot(away, away) <= near * near
            });
            found.next().filter(|_| found.next().is_none())
        };
        let mirror = |normal: [f64; 3]| {
            let mut image: Vec<u32> = (0..at.len() as u32).collect();
            for (&node, &p) in nodes.iter().zip(&points) {
                image[node as usize] = nodes[find(mirrored(p, normal))? as usize];
            }
            Some(Mirror { normal, image })
        };
        coordinate.chain(principal).filter_map(mirror).collect()
    }

    /// The mirror image of a displacement, `#nodes`.
    pub(super) fn of(&self, displacement: &[Row]) -> Vec<Row> {
        let rows = self.image.iter().map(|&from| {
            let [x, y, z, _] = displacement[from as usize];
            let [x, y, z] = mirrored([x, y, z], self.normal);
            [x, y, z, 0.0]
        });
        rows.collect()
    }
}

fn mirrored(p: [f64; 3], normal: [f64; 3]) -> [f64; 3] {
    let twice = 2.0 * dot(p, normal);
    std::array::from_fn(|c| p[c] - twice * normal[c])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|c| a[c] * b[c]).sum()
}
