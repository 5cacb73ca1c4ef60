//! Triangles without area, removed so that no opening is left where they were.

use super::edges::Edges;
use crate::math::Vec3;
use crate::quads::Side;

/// Triangles with at most this fraction of the largest area have none.
const NO_AREA: f64 = 1e-14;
/// A safeguard: vertices along one line take a round each at most.
const MOST_ROUNDS: usize = 100;

/// A triangle without area.
struct Sliver {
    /// Its longest side, and the length of that.
    longest: (Side, f64),
    /// Its shortest side, if the ends of that coincide.
    coincident: Option<Side>,
}

/// Removes triangles without area. Where the ends of a side coincide, they become one vertex;
/// otherwise the triangle over the longest side is split at the third vertex, which lies on it.
/// What neither can remove without joining three triangles in an edge is dropped. Returns for each
/// triangle that is left the given one that it is, or is a part of.
pub(super) fn remove_slivers(
    positions: &[Vec3<f64>],
    triangles: &mut Vec<[usize; 3]>,
) -> Vec<usize> {
    let area = |&[a, b, c]: &[usize; 3]| {
        (positions[b] - positions[a]).cross(positions[c] - positions[a]).length()
    };
    let least = NO_AREA * triangles.iter().map(area).fold(0.0, f64::max);
    let mut given: Vec<usize> = (0..triangles.len()).collect();
    for _ in 0..MOST_ROUNDS {
        let thin = (0..triangles.len()).filter(|&t| area(&triangles[t]) <= least);
        let mut slivers: Vec<Sliver> =
            thin.map(|t| sliver(positions, t, triangles[t], least)).collect();
        // Longest first: what is split then has only shorter sides.
        slivers.sort_by(|a, b| b.longest.1.total_cmp(&a.longest.1));
        let edges = Edges::new(triangles);
        let removed = !slivers.is_empty()
            && (merge(&slivers, &edges, triangles, &mut given)
                || split(&slivers, &edges, triangles, &mut given));
        if !removed {
            break;
        }
    }
    keep(triangles, &mut given, |triangle| area(triangle) > least);
    given
}

fn sliver(positions: &[Vec3<f64>], triangle: usize, corners: [usize; 3], least: f64) -> Sliver {
    let mut sides = [0, 1, 2].map(|side| {
        let ends = [corners[side], corners[(side + 1) % 3]].map(|v| positions[v]);
        (Side { triangle, side }, (ends[1] - ends[0]).length())
    });
    sides.sort_by(|a, b| a.1.total_cmp(&b.1));
    let [shortest, _, longest] = sides;
    let coincident = (shortest.1 * longest.1 <= least).then_some(shortest.0);
    Sliver { longest, coincident }
}

/// Makes one vertex of the ends of sides that coincide, where that closes no other triangle; returns
/// whether it did.
fn merge(
    slivers: &[Sliver],
    edges: &Edges,
    triangles: &mut Vec<[usize; 3]>,
    given: &mut Vec<usize>,
) -> bool {
    if slivers.iter().all(|sliver| sliver.coincident.is_none()) {
        return false;
    }
    let count = edges.ends.iter().flatten().max().map_or(0, |most| most + 1);
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); count];
    for &[a, b] in &edges.ends {
        around[a].push(b);
        around[b].push(a);
    }
    let mut name: Vec<usize> = (0..count).collect();
    let mut changed = vec![false; count];
    let mut merged = false;
    for side in slivers.iter().filter_map(|sliver| sliver.coincident) {
        let e = edges.of_side[side.triangle][side.side];
        let [kept, gone] = edges.ends[e];
        let both = around[gone].iter().filter(|v| around[kept].contains(v)).count();
        let own = || around[kept].iter().chain(&around[gone]);
        if kept != gone && both == edges.sides[e].len() && !own().any(|&v| changed[v]) {
            own().for_each(|&v| changed[v] = true);
            name[gone] = kept;
            merged = true;
        }
    }
    triangles.iter_mut().flatten().for_each(|v| *v = name[*v]);
    keep(triangles, given, |&[a, b, c]| a != b && b != c && c != a);
    merged
}

/// Splits the triangles over the longest sides; returns whether there were any.
fn split(
    slivers: &[Sliver],
    edges: &Edges,
    triangles: &mut Vec<[usize; 3]>,
    given: &mut Vec<usize>,
) -> bool {
    // Those whose neighbours in `edges` are not theirs any more, or that wait for a longer sliver.
    let mut changed = vec![false; triangles.len()];
    let mut gone = vec![false; triangles.len()];
    let mut removed = false;
    for sliver in slivers.iter().filter(|sliver| sliver.coincident.is_none()) {
        let Side { triangle: own, side: k } = sliver.longest.0;
        let beside = &edges.sides[edges.of_side[own][k]];
        let other = beside.iter().find(|other| other.triangle != own);
        let waits = beside.len() > 2 || other.is_some_and(|other| changed[other.triangle]);
        if std::mem::replace(&mut changed[own], true) || waits {
            continue;
        }
        let Some(&Side { triangle, side }) = other else {
            (gone[own], removed) = (true, true);
            continue;
        };
        let tip = triangles[own][(k + 2) % 3];
        let [from, to, apex] = [0, 1, 2].map(|corner| triangles[triangle][(side + corner) % 3]);
        if tip == apex {
            (gone[own], gone[triangle]) = (true, true);
        } else if edges.ends.binary_search(&[tip.min(apex), tip.max(apex)]).is_err() {
            triangles[triangle] = [from, tip, apex];
            triangles[own] = [tip, to, apex];
            given[own] = given[triangle];
        } else {
            continue;
        }
        (changed[triangle], removed) = (true, true);
    }
    let mut gone = gone.into_iter();
    keep(triangles, given, |_| !gone.next().expect("one for each"));
    removed
}

/// Keeps some triangles, and what they are parts of.
fn keep(
    triangles: &mut Vec<[usize; 3]>,
    given: &mut Vec<usize>,
    mut is_kept: impl FnMut(&[usize; 3]) -> bool,
) {
    let kept: Vec<bool> = triangles.iter().map(&mut is_kept).collect();
    let mut of_triangle = kept.iter();
    triangles.retain(|_| *of_triangle.next().expect("one for each"));
    let mut of_given = kept.iter();
    given.retain(|_| *of_given.next().expect("one for each"));
}
