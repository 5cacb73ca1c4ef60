//! Outlines of parts: their sides, and what is written at them.

use super::letters::Text;
use shape_up::math::plane::{Point2, cross, distance, minus};

/// The lengths of the sides of an outline.
pub(super) fn lengths(outline: &[Point2]) -> Vec<f64> {
    let n = outline.len();
    (0..n).map(|k| distance(outline[k], outline[(k + 1) % n])).collect()
}

/// What is written at each side of an outline, besides its own name and bevels: each text is nearest to
/// its side.
pub(super) fn written(own: &str, outline: &[Point2], texts: &[Text]) -> Vec<Option<String>> {
    let n = outline.len();
    let mut found = vec![None; n];
    for text in texts.iter().filter(|text| text.text != own) {
        let away = |k: &usize| to_segment(text.centre, [outline[*k], outline[(*k + 1) % n]]);
        let nearest = (0..n).min_by(|a, b| away(a).total_cmp(&away(b))).unwrap();
        assert!(found[nearest].is_none(), "two names at a side of {own}: {texts:?}");
        found[nearest] = text.text.split(' ').next().map(str::to_owned);
    }
    found
}

/// The names of neighbours with a bevel behind them, and the bevels in degrees.
pub(super) fn bevels(texts: &[Text]) -> impl Iterator<Item = (&str, f64)> {
    let both = texts.iter().filter_map(|text| text.text.split_once(' '));
    both.map(|(name, bevel)| (name, bevel.parse().unwrap()))
}

/// The distance of a point from a segment.
pub(super) fn to_segment(point: Point2, [a, b]: [Point2; 2]) -> f64 {
    let (along, to) = (minus(b, a), minus(point, a));
    let share = (along[0] * to[0] + along[1] * to[1]) / (along[0].powi(2) + along[1].powi(2));
    let share = share.clamp(0.0, 1.0);
    distance(to, along.map(|x| share * x))
}

/// The outline of what is left when a part is cut with this kerf: without ways to the end of a slit and
/// back.
pub(super) fn left_of(outline: &[Point2], kerf: f64) -> Vec<Point2> {
    if kerf == 0.0 {
        return outline.to_vec();
    }
    let mut points = outline.to_vec();
    let mut k = 0;
    while k < points.len() {
        let n = points.len();
        let (before, after) = ((k + n - 1) % n, (k + 1) % n);
        if distance(points[before], points[after]) > 1e-3 {
            k += 1;
            continue;
        }
        points = (0..n).filter(|i| ![k, after].contains(i)).map(|i| points[i]).collect();
        k = 0;
    }
    widened(&points, &vec![-0.5 * kerf; points.len()])
}

/// An outline with its sides moved outwards.
pub(super) fn widened(outline: &[Point2], by: &[f64]) -> Vec<Point2> {
    let n = outline.len();
    let corner = |k: usize| {
        let [before, own, after] = [k + n - 1, k, k + 1].map(|k| outline[k % n]);
        let [u, v] = [minus(own, before), minus(after, own)];
        let [l, m] = [u, v].map(|[x, y]| (x * x + y * y).sqrt());
        let (u, v) = (u.map(|x| x / l), v.map(|x| x / m));
        let [before, after] = [k + n - 1, k].map(|k| by[k % n] / cross(u, v));
        [0, 1].map(|x| own[x] + after * u[x] - before * v[x])
    };
    (0..n).map(corner).collect()
}
