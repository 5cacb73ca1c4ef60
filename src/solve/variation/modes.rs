//! The modes that are shown: the softest directions, made tangent and symmetric about the mirrors
//! of the shape, and oriented outwards.

use super::subspace::{MODES, Subspace, column_of, rows_of};
use crate::constraint::Row;
use crate::math::{Vec3, argsort, key_of_number, symmetric_eigen};
use crate::mesh::Point;
use crate::solve::exact::block_system::BlockSystem;
use nalgebra::{DMatrix, DVector};

/// Coefficients of modes range this far to either side, as a fraction of the size.
pub const SLIDE: f64 = 0.1;

/// A direction that loses more than this fraction of its length when it is made tangent is not in
/// the shape space.
const TANGENT: f64 = 0.5;

/// A mode counts as symmetric or antisymmetric from this absolute parity on.
const ALMOST: f64 = 0.99;

/// A variation of a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Variation {
    /// `#V by 3`: the displacement, whose longest row has the size of the model. A coefficient of a
    /// hundredth moves the vertex that moves farthest by a hundredth of the size.
    pub displacement: Vec<Point>,
    /// The stiffness of the shape against it, for comparison with other modes.
    pub stiffness: f64,
    /// The least and the greatest coefficient for which the constraints can be met, from minus
    /// [`SLIDE`] to [`SLIDE`]; `None` until one is known, and NaN for the other until that is.
    pub range: Option<[f64; 2]>,
}

/// Returns the modes of a subspace, `#nodes` each, of length one, the softest first, with their
/// stiffness.
pub(super) fn modes(
    system: &mut BlockSystem,
    mut subspace: Subspace,
    mirrors: &[Mirror],
) -> Vec<(Vec<Row>, f64)> {
    let parities = symmetrise(&mut subspace, mirrors);
    let compliances = &subspace.compliances;
    let mut modes = Vec::new();
    for k in 0..MODES {
        let mut mode = rows_of(&subspace.vectors, k);
        if compliances[k] <= 0.0 || squared(&mode) < 0.5 {
            continue;
        }
        let definite = mirrors.iter().zip(&parities).filter(|(_, parity)| parity[k].abs() > ALMOST);
        for (mirror, parity) in definite {
            let image = mirror.of(&mode);
            for (row, image) in mode.iter_mut().zip(image) {
                (0..3).for_each(|c| row[c] = 0.5 * (row[c] + parity[k].signum() * image[c]));
            }
        }
        system.make_tangent(&mut mode);
        let length = squared(&mode).sqrt();
        // Written so that NaN is no mode.
        if length > TANGENT {
            mode.as_flattened_mut().iter_mut().for_each(|value| *value /= length);
            modes.push((mode, 1.0 / compliances[k]));
        }
    }
    let order = argsort(modes.iter().map(|(_, stiffness)| key_of_number(*stiffness)));
    order.iter().map(|&k| std::mem::take(&mut modes[k as usize])).collect()
}

/// Mixes the vectors of a subspace so that each is symmetric or antisymmetric about every mirror,
/// if possible. Returns their parities, from -1 to 1, for each mirror. If the constraints are not
/// symmetric, changes nothing and returns no parities.
fn symmetrise(subspace: &mut Subspace, mirrors: &[Mirror]) -> Vec<Vec<f64>> {
    if mirrors.is_empty() {
        return Vec::new();
    }
    let vectors = &subspace.vectors;
    let (n, count) = vectors.shape();
    let products = |mirror: &Mirror| {
        let images = (0..count).map(|k| mirror.of(&rows_of(vectors, k)));
        let entries = images.flat_map(|image| column_of(&image).collect::<Vec<_>>());
        vectors.tr_mul(&DMatrix::from_iterator(n, count, entries))
    };
    let images: Vec<DMatrix<f64>> = mirrors.iter().map(products).collect();
    // Commuting matrices share an eigenbasis, even with repeated compliances.
    let own = DMatrix::from_diagonal(&DVector::from_column_slice(&subspace.compliances));
    let mut sum = own.clone();
    let mut weight = 0.1 * subspace.compliances[MODES - 1];
    for image in &images {
        sum += image * weight;
        weight *= 0.37;
    }
    let Some((_, factors)) = symmetric_eigen(&sum) else { return Vec::new() };
    let along = |matrix: &DMatrix<f64>| -> Vec<f64> {
        factors.column_iter().map(|mode| mode.dot(&(matrix * mode))).collect()
    };
    let parities: Vec<Vec<f64>> = images.iter().map(along).collect();
    let is_definite = |k: &usize| parities.iter().all(|parity| parity[*k].abs() > ALMOST);
    // The subspace may end between modes of equal compliance, so that some have no parity.
    if (0..MODES).filter(is_definite).count() < MODES / 2 {
        return Vec::new();
    }
    subspace.compliances = along(&own);
    subspace.vectors *= factors;
    parities
}

fn squared(mode: &[Row]) -> f64 {
    mode.as_flattened().iter().map(|value| value * value).sum()
}

/// Whether the vertex that moves farthest moves outwards: along its normal, or away from the
/// centre, or, if it moves across both, towards the first vertex in whose direction it moves.
pub(super) fn goes_outwards(displacement: &[Point], normals: &[Vec3<f64>], at: &[Point]) -> bool {
    const ALONG: f64 = 0.1;
    let n = at.len() as f64;
    let centre = at.iter().fold(Vec3::zero(), |sum, &p| sum + Vec3::from(p) * (1.0 / n));
    let lengths = || displacement.iter().map(|&d| Vec3::from(d).length());
    let longest = lengths().fold(0.0, f64::max);
    // The first of those that move almost as far: mirror images move equally far.
    let Some(v) = lengths().position(|length| length >= 0.999 * longest) else { return true };
    let (way, from) = (Vec3::from(displacement[v]), Vec3::from(at[v]));
    let others = at.iter().map(|&p| Vec3::from(p) - from);
    let mut directions = [normals[v], from - centre].into_iter().chain(others);
    let clear = directions.find_map(|direction| {
        let along = way.dot(direction);
        (along.abs() > ALONG * longest * direction.length()).then_some(along)
    });
    clear.is_none_or(|along| along > 0.0)
}

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
        let Some((_, axes)) = symmetric_eigen(&scatter) else { return Vec::new() };
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
