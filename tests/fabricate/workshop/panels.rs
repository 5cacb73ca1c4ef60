//! Panels: each is put beside the neighbours that are written at its sides, or if no name has room there,
//! as the table says.

use super::files::{Files, Part};
use super::outline::{bevels, lengths, widened, written};
use super::shape::{Flat, Found, Point, Side, assembled, matching, sides_of_panels};
use super::splices::joined;
use shape_up::math::plane::{Point2, cross, dot, minus};
use std::collections::BTreeMap;

/// Assembles panels.
pub(super) fn assemble(files: &Files) -> Found {
    let scale = files.number("Scale 1 : (scale)");
    let by = 0.5 * (files.number("joint on the sheet") - files.number("Kerf (kerf)"));
    let sides = sides_of_panels(files);
    let is_inside = files.text("Print on the inside (print_inside)") == "on";
    // A triangle that is half of a panel has edges of its own.
    let (mut parts, pieces): (Vec<Part>, Vec<Part>) =
        files.parts().0.into_iter().partition(|part| sides.contains_key(&part.name));
    parts.extend(joined(pieces, files.number("Kerf (kerf)")));
    if is_inside {
        parts.iter_mut().for_each(turn_over);
    }
    // The direction of the first side in radians, and the node where it begins.
    let firsts: BTreeMap<String, (f64, String)> = files
        .table("panels.csv")
        .rows()
        .map(|row| {
            let first = row.text("nodes").split(' ').next().unwrap().to_owned();
            // Pieces lie as the first one.
            let name = row.text("name");
            let is_whole = sides.contains_key(name);
            let name = if is_whole { name } else { name.trim_end_matches(".1") }.to_owned();
            let turn = row.number("turn_deg");
            (name, (if is_inside { 180.0 - turn } else { turn }.to_radians(), first))
        })
        .collect();
    let nodes = files.nodes();
    let flat = |part: &Part| {
        let corners: Vec<Point2> = widened(&part.outline, &vec![by; part.outline.len()])
            .into_iter()
            .map(|corner| corner.map(|x| scale * x))
            .collect();
        let written = written(&part.name, &part.outline, &part.texts);
        let measured: Vec<_> = lengths(&corners).into_iter().zip(written).collect();
        let mut own = sides[&part.name].clone();
        // The first side, which has this direction on the sheet.
        let (turn, node) = &firsts[&part.name];
        let first = [libm::cos(*turn), libm::sin(*turn)];
        let n = corners.len();
        let way = |k: &usize| dot(minus(corners[(k + 1) % n], corners[*k]), first) / measured[*k].0;
        let at = (0..n).max_by(|a, b| way(a).total_cmp(&way(b))).unwrap();
        let start = own.iter().position(|side| side.from == *node).unwrap();
        let by_table = (start + n - at) % n;
        let by_names = matching(&own, &measured, 0.01);
        assert!(by_names.contains(&by_table), "{}: {by_names:?}, {by_table}", part.name);
        assert!(by_names.len() == 1 || part.texts.len() < 2, "{}: {by_names:?}", part.name);
        own.rotate_left(by_table);
        for (name, bevel) in bevels(&part.texts) {
            let fits =
                |side: &Side| side.beyond == name && (0.5 * side.fold - bevel).abs() < 0.0501;
            assert!(own.iter().any(fits), "{}: {name} {bevel}", part.name);
        }
        if let Some(arrow) = part.arrow {
            assert_up(&part.name, minus(arrow[1], arrow[0]), &corners, |k| nodes[&own[k].from]);
        }
        let is_joined = vec![true; own.len()];
        (part.name.clone(), Flat { corners, sides: own, is_joined })
    };
    let panels: BTreeMap<String, Flat> = parts.iter().map(flat).collect();
    assert_eq!(panels.len(), sides.len(), "every panel is cut");
    assembled(&panels)
}

/// Checks that an arrow on a panel goes up the slope: `place` tells where each corner is in space.
fn assert_up(name: &str, arrow: Point2, corners: &[Point2], place: impl Fn(usize) -> Point) {
    let [u, v] = [1, 2].map(|k| minus(corners[k], corners[0]));
    let [a, b] = [cross(arrow, v), cross(u, arrow)].map(|x| x / cross(u, v));
    let [along, across] = [1, 2].map(|k| place(k) - place(0));
    let (way, normal) = (along * a + across * b, along.cross(across));
    let up = Point::new(0.0, 0.0, 1.0);
    let (level, normal) = (normal.cross(up), normal.length());
    // Of what is steeper than ten degrees.
    if level.length() > 0.17 * normal {
        let aside = way.dot(level) / (way.length() * level.length());
        assert!(way.z > 0.0 && aside.abs() < 0.02, "{name}: {way:?}, {aside}");
    }
}

/// Turns a part over that lies with its inside up.
fn turn_over(part: &mut Part) {
    part.outline.reverse();
    let arrow = part.arrow.iter_mut().flatten();
    let texts = part.texts.iter_mut().map(|text| &mut text.centre);
    for at in part.outline.iter_mut().chain(arrow).chain(texts) {
        at[0] = -at[0];
    }
}
