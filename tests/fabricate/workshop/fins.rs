//! Fins: from a node, each is put up by its azimuth and its elevation, and leads to the next node and
//! its axis.

use super::files::{Files, Part};
use super::letters::Text;
use super::outline::widened;
use super::shape::{Found, Point};
use shape_up::math::Vec3;
use shape_up::math::plane::{Point2, cross, distance, dot, minus};
use std::collections::BTreeMap;

/// A fin as its outline and its name tell.
struct Fin {
    /// The nodes at its ends, the first of its name first.
    nodes: [String; 2],
    /// The distance between them in mm of the building.
    length: f64,
    /// The angle in degrees from the way to the other end to the axis of each node.
    axis: [f64; 2],
}

/// Assembles fins.
pub(super) fn assemble(files: &Files) -> Found {
    let fins = fins(files);
    // For each beam of a node, its azimuth and its elevation.
    let mut around: BTreeMap<String, BTreeMap<String, [f64; 2]>> = BTreeMap::new();
    for row in files.table("node-beams.csv").rows() {
        let angles = ["azimuth_deg", "elevation_deg"].map(|column| row.number(column));
        let node = around.entry(row.text("node").to_owned()).or_default();
        node.insert(row.text("beam").to_owned(), angles);
    }
    let mut found = Found::default();
    // Each node with its axis and the direction of azimuth 0.
    let first = around.keys().next().unwrap();
    let start = [Vec3::zero(), Vec3::new(0.0, 0.0, 1.0), Vec3::new(1.0, 0.0, 0.0)];
    let mut placed: BTreeMap<&str, [Point; 3]> = BTreeMap::from([(&**first, start)]);
    let mut queue = vec![&**first];
    while let Some(node) = queue.pop() {
        let [at, axis, zero] = placed[node];
        found.put(node, at);
        for (beam, &[azimuth, elevation]) in &around[node] {
            let fin = &fins[beam];
            let own = usize::from(fin.nodes[1] == node);
            let [azimuth, elevation] = [azimuth, elevation].map(f64::to_radians);
            let outwards = turned(zero, axis, azimuth);
            let along = outwards * libm::cos(elevation) + axis * libm::sin(elevation);
            // The fin stands along the axis: the angle is that between its edge and its end.
            let rise = libm::acos(axis.dot(along)).to_degrees();
            assert!((rise - fin.axis[own]).abs() < 0.01, "{beam}: {rise} {}", fin.axis[own]);
            let up = axis - along * axis.dot(along);
            let up = up * (1.0 / up.length());
            let lean = fin.axis[1 - own].to_radians();
            let there = at + along * fin.length;
            let axis_there = up * libm::sin(lean) - along * libm::cos(lean);
            let to = &*fin.nodes[1 - own];
            found.put(to, there);
            let back = -along - axis_there * axis_there.dot(-along);
            let zero =
                turned(back * (1.0 / back.length()), axis_there, -around[to][beam][0].to_radians());
            match placed.get(to) {
                Some([_, known, direction]) => {
                    let off = (*known - axis_there).length().max((*direction - zero).length());
                    assert!(off < 1e-3, "{beam} meets {to} at another angle: {off}");
                }
                None => {
                    placed.insert(to, [there, axis_there, zero]);
                    queue.push(to);
                }
            }
        }
    }
    found
}

/// A vector at right angles to an axis, turned about it, counterclockwise as it points.
fn turned(v: Point, axis: Point, angle: f64) -> Point {
    v * libm::cos(angle) + axis.cross(v) * libm::sin(angle)
}

/// All fins by their names, as their letters and outlines say.
fn fins(files: &Files) -> BTreeMap<String, Fin> {
    let (parts, beside) = files.parts();
    let legend = beside.iter().find(|text| text.text.starts_with("FIN NAMES READ FROM FIRST"));
    let legend = &*legend.expect("the sheet says how fins lie").text;
    let is_below = legend.contains("OUTSIDE UP, MODEL EDGE AT THE BOTTOM");
    assert!(is_below || legend.contains("OUTSIDE UP, MODEL EDGE AT THE TOP"));
    let table = files.table("fins.csv");
    let cut_backs: BTreeMap<String, [f64; 2]> = table
        .rows()
        .map(|row| {
            let backs = ["cut_back_a_sheet_mm", "cut_back_b_sheet_mm"];
            (row.text("name").to_owned(), backs.map(|column| row.number(column)))
        })
        .collect();
    let turns: BTreeMap<String, f64> =
        table.rows().map(|row| (row.text("name").to_owned(), row.number("turn_deg"))).collect();
    let (scale, kerf) = (files.number("Scale 1 : (scale)"), files.number("Kerf (kerf)"));
    let fin = |part: &Part| {
        let all = part.texts.iter().chain(&beside);
        let own: Vec<&Text> = all.filter(|text| text.text == part.name).collect();
        assert!(own.len() < 2, "{} is named twice", part.name);
        // Without room anywhere, the table has the direction of its name.
        let turn = turns[&part.name].to_radians();
        let by_table = [libm::cos(turn), libm::sin(turn)];
        let along = own.first().map_or(by_table, |text| text.along);
        assert!(dot(along, by_table) > 0.9, "{} lies otherwise than it says", part.name);
        let outline = widened(&part.outline, &vec![-0.5 * kerf; part.outline.len()]);
        let sides = [0, 1, 2, 3].map(|k| [outline[k], outline[(k + 1) % 4]]);
        // Below a text is to its right, on the outline from its first end to its last.
        let downwards = |[p, q]: [Point2; 2]| {
            let way = dot(minus(q, p), along) / distance(p, q);
            if is_below { way } else { -way }
        };
        let at_edge = (0..4).max_by(|&a, &b| downwards(sides[a]).total_cmp(&downwards(sides[b])));
        let at_edge = at_edge.unwrap();
        let [mut a, mut b] = sides[at_edge];
        let [mut top_b, mut top_a] = sides[(at_edge + 2) % 4];
        if dot(minus(b, a), along) < 0.0 {
            ((a, b), (top_a, top_b)) = ((b, a), (top_b, top_a));
        }
        // Outwards at the ends, whichever side the edge is on.
        let ways = [minus(top_a, a), minus(top_b, b)].map(|way| match is_below {
            true => way,
            false => way.map(|x| -x),
        });
        let angle = |edge: Point2, way: Point2| {
            libm::atan2(cross(edge, way).abs(), dot(edge, way)).to_degrees()
        };
        let axis = [angle(minus(b, a), ways[0]), angle(minus(a, b), ways[1])];
        let [back_a, back_b] = cut_backs[&part.name];
        let length = scale * (distance(a, b) + back_a + back_b);
        let names = part.name.strip_prefix('B').unwrap().split_once('-').unwrap();
        let nodes = [names.0, names.1].map(|node| format!("N{node}"));
        (part.name.clone(), Fin { nodes, length, axis })
    };
    parts.iter().map(fin).collect()
}
