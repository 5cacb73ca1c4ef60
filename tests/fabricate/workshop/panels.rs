//! Panels: each is put beside the neighbours that are written at its sides, or if no name has room there,
//! as the table says.

use super::files::{Files, Part};
use super::outline::{lengths, widened, written};
use super::shape::{Flat, Found, assembled, matching, sides_of_panels};
use super::splices::joined;
use shape_up::math::plane::{Point2, dot, minus};
use std::collections::BTreeMap;

/// Assembles panels.
pub(super) fn assemble(files: &Files) -> Found {
    let scale = files.number("Scale 1 : (scale)");
    let by = 0.5 * (files.number("joint on the sheet") - files.number("Kerf (kerf)"));
    let sides = sides_of_panels(files);
    // A triangle that is half of a panel has edges of its own.
    let (mut parts, pieces): (Vec<Part>, Vec<Part>) =
        files.parts().0.into_iter().partition(|part| sides.contains_key(&part.name));
    parts.extend(joined(pieces, files.number("Kerf (kerf)")));
    // The direction of the arrow's side in radians, and the node where it begins.
    let arrows: BTreeMap<String, (f64, String)> = files
        .table("panels.csv")
        .rows()
        .map(|row| {
            let first = row.text("nodes").split(' ').next().unwrap().to_owned();
            // Pieces lie as the first one.
            let name = row.text("name");
            let is_whole = sides.contains_key(name);
            let name = if is_whole { name } else { name.trim_end_matches(".1") }.to_owned();
            (name, (row.number("turn_deg").to_radians(), first))
        })
        .collect();
    let flat = |part: &Part| {
        let corners: Vec<Point2> = widened(&part.outline, &vec![by; part.outline.len()])
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
