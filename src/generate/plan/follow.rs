//! A grid whose four sides follow the outline.

use super::declaration::PlanError;
use super::outline::{FlatPlan, Loop, Side, along};
use crate::generate::quads::{check_face_count, quads};
use crate::generate::sides::{coons_patch, even_steps};
use crate::math::plane::{Point2, bounds, cross, distance, dot, minus};
use crate::mesh::Mesh;

/// Limit of vertex updates in all smoothing sweeps together: the largest grids take a second.
const MOST_MOVES: usize = 40_000_000;

/// The grid between the four marked corners.
pub(super) fn mesh(outline: &Loop, size: f64) -> Result<FlatPlan, PlanError> {
    let marked: Vec<usize> =
        (0..outline.sides.len()).filter(|&k| outline.sides[k].is_corner).collect();
    let &[a, b, c, d] = &marked[..] else { return Err(PlanError::FourCorners(marked.len())) };
    let pieces = [(a, b), (b, c), (c, d), (d, a)].map(|(from, to)| piece(outline, from, to));
    let lengths = pieces.each_ref().map(|sides| sides.iter().map(Side::length).sum::<f64>());
    let count =
        |one: usize, other: usize| (0.5 * (lengths[one] + lengths[other]) / size).round().max(1.0);
    let panels = [count(0, 2), count(1, 3)];
    check_face_count(panels[0] * panels[1]).map_err(PlanError::TooManyFaces)?;
    let [nx, ny] = panels.map(|n| n as usize);
    let [south, east, north, west] =
        [0, 1, 2, 3].map(|k| places(&pieces[k], if k % 2 == 0 { nx } else { ny }));
    let mut places = coons_patch(&south, &east, &north, &west);
    smooth(&mut places, nx + 1);
    let positions = places.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    let mesh = Mesh { positions, faces: quads([nx, ny], false).collect(), ..Mesh::default() };
    let is_folded = |face: &[u32]| {
        let at = |k: usize| places[face[k % 4] as usize];
        (0..4).any(|k| cross(minus(at(k + 1), at(k)), minus(at(k + 3), at(k))) <= 0.0)
    };
    if mesh.faces.iter().any(is_folded) {
        return Err(PlanError::Folded);
    }
    let corner = |i: usize, j: usize| (j * (nx + 1) + i) as u32;
    let is_outer = |v: &u32| {
        let (i, j) = (*v as usize % (nx + 1), *v as usize / (nx + 1));
        i == 0 || j == 0 || i == nx || j == ny
    };
    Ok(FlatPlan {
        outline: (0..mesh.positions.len() as u32).filter(is_outer).collect(),
        corners: [[0, 0], [nx, 0], [nx, ny], [0, ny]].map(|[i, j]| (corner(i, j), None)).to_vec(),
        mesh,
    })
}

/// The sides from one corner to the next.
fn piece(outline: &Loop, from: usize, to: usize) -> Vec<Side> {
    let n = outline.sides.len();
    (0..(to + n - from) % n).map(|k| outline.sides[(from + k) % n]).collect()
}

/// `n + 1` points in equal steps along some sides. The corners between sides replace the nearest of
/// them, as far as there are enough.
fn places(sides: &[Side], n: usize) -> Vec<Point2> {
    let mut ends = vec![0.0];
    sides.iter().for_each(|side| ends.push(ends[ends.len() - 1] + side.length()));
    let (steps, _) = even_steps(&ends, 1..sides.len(), n);
    steps.into_iter().map(|(k, part)| sides[k].at(part)).collect()
}

/// Winslow's smoothing (1966): a map from the square whose inverse is harmonic, so that it does not
/// fold. Solved by Gauss-Seidel sweeps over finite differences.
fn smooth(places: &mut [Point2], row: usize) {
    let inner = (row - 2) * (places.len() / row).saturating_sub(2);
    let [low, high] = bounds(places.iter().copied());
    let extent = distance(low, high);
    let sweeps = (MOST_MOVES / inner.max(1)).min(4 * row * row);
    for _ in 0..sweeps {
        let mut farthest = 0.0_f64;
        for j in 1..(places.len() / row).saturating_sub(1) {
            for i in 1..row - 1 {
                let at = |di: isize, dj: isize| {
                    places[((j * row + i) as isize + dj * row as isize + di) as usize]
                };
                let [e, w, n, s] = [at(1, 0), at(-1, 0), at(0, 1), at(0, -1)];
                let (across, up) = (minus(e, w), minus(n, s));
                let (alpha, beta, gamma) = (dot(up, up), dot(across, up), dot(across, across));
                let twist = minus(minus(at(1, 1), at(-1, 1)), minus(at(1, -1), at(-1, -1)));
                let sum = along(along(e, 1.0, w), gamma / alpha, along(n, 1.0, s));
                let sum = along(sum, -0.5 * beta / alpha, twist);
                let scale = 0.5 / (1.0 + gamma / alpha);
                let new = [scale * sum[0], scale * sum[1]];
                if new.iter().all(|x| x.is_finite()) {
                    let old = std::mem::replace(&mut places[j * row + i], new);
                    let by = minus(new, old);
                    farthest = farthest.max(dot(by, by));
                }
            }
        }
        if farthest.sqrt() <= 1e-9 * extent {
            break;
        }
    }
}
