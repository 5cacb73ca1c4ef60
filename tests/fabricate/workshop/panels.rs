//! Panels: each is put beside the neighbours that are written at its sides, or if no name has room there,
//! as the table says.

use super::files::{Files, Part};
use super::letters::Text;
use super::shape::{Flat, Found, assembled, matching, sides_of_panels};
use super::splices::joined;
use shape_up::math::plane::{Point2, cross, distance, dot, minus};
use std::collections::BTreeMap;

/// Assembles panels.
pub(super) fn assemble(files: &Files) -> Found {
    let scale = files.number("Scale 1 : (scale)");
    let by = 0.5 * (files.number("joint on the sheet") - files.number("Kerf (kerf)"));
    let sides = sides_of_panels(files);
    let parts = joined(files.parts().0, files.number("Kerf (kerf)"));
    // The direction of the arrow's side in radians, and the node where it begins.
    let arrows: BTreeMap<String, (f64, String)> = files
        .table("panels.csv")
        .rows()
        .map(|row| {
            let first = row.text("nodes").split(' ').next().unwrap().to_owned();
            // Pieces lie as the first one.
            let name = row.text("name").trim_end_matches(".1").to_owned();
            (name, (row.number("turn_deg").to_radians(), first))
        })
        .collect();
    let flat = |part: &Part| {
        let corners: Vec<Point2> = widened(&part.outline, by)
            .into_iter()
            .map(|corner| corner.map(|x| scale * x))
            .collect();
        let written = written(&part.name, &part.outline, &part.texts);
        let measured: Vec<_> = lengths(&corners).into_iter().zip(written).collect();
        let mut own = sides[&part.name].clone();
        // The side at the arrow, which has this direction on the sheet.
        let (turn, node) = &arrows[&part.name];
        let arrow = [libm::cos(*turn), libm::sin(*turn)];
        let n = corners.len();
        let way = |k: &usize| dot(minus(corners[(k + 1) % n], corners[*k]), arrow) / measured[*k].0;
        let at = (0..n).max_by(|a, b| way(a).total_cmp(&way(b))).unwrap();
        let start = own.iter().position(|side| side.from == *node).unwrap();
        let by_arrow = (start + n - at) % n;
        let by_names = matching(&own, &measured, 0.01);
        assert!(by_names.contains(&by_arrow), "{}: {by_names:?}, {by_arrow}", part.name);
        assert!(by_names.len() == 1 || part.texts.len() < 2, "{}: {by_names:?}", part.name);
        own.rotate_left(by_arrow);
        let is_joined = vec![true; own.len()];
        (part.name.clone(), Flat { corners, sides: own, is_joined })
    };
    let panels: BTreeMap<String, Flat> = parts.iter().map(flat).collect();
    assert_eq!(panels.len(), sides.len(), "every panel is cut");
    assembled(&panels)
}

/// The lengths of the sides of an outline.
pub(super) fn lengths(outline: &[Point2]) -> Vec<f64> {
    let n = outline.len();
    (0..n).map(|k| distance(outline[k], outline[(k + 1) % n])).collect()
}

/// What is written at each side of an outline, besides its own name: each text is nearest to its side.
pub(super) fn written(own: &str, outline: &[Point2], texts: &[Text]) -> Vec<Option<String>> {
    let n = outline.len();
    let mut found = vec![None; n];
    for text in texts.iter().filter(|text| text.text != own) {
        let away = |k: &usize| to_segment(text.centre, [outline[*k], outline[(*k + 1) % n]]);
        let nearest = (0..n).min_by(|a, b| away(a).total_cmp(&away(b))).unwrap();
        assert!(found[nearest].is_none(), "two names at a side of {own}: {texts:?}");
        found[nearest] = Some(text.text.clone());
    }
    found
}

/// The distance of a point from a segment.
pub(super) fn to_segment(point: Point2, [a, b]: [Point2; 2]) -> f64 {
    let (along, to) = (minus(b, a), minus(point, a));
    let share = (along[0] * to[0] + along[1] * to[1]) / (along[0].powi(2) + along[1].powi(2));
    let share = share.clamp(0.0, 1.0);
    distance(to, along.map(|x| share * x))
}

/// An outline with all sides moved outwards.
pub(super) fn widened(outline: &[Point2], by: f64) -> Vec<Point2> {
    let n = outline.len();
    let corner = |k: usize| {
        let [before, own, after] = [k + n - 1, k, k + 1].map(|k| outline[k % n]);
        let [u, v] = [minus(own, before), minus(after, own)];
        let [l, m] = [u, v].map(|[x, y]| (x * x + y * y).sqrt());
        let (u, v) = (u.map(|x| x / l), v.map(|x| x / m));
        let share = by / cross(u, v);
        [0, 1].map(|x| own[x] + share * (u[x] - v[x]))
    };
    (0..n).map(corner).collect()
}
