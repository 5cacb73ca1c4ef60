//! The key drawings: the shape that was put together, seen as their titles say, is what they show, and
//! each name stands where its part is.

use super::files::{Drawn, Files};
use super::letters::{Text, read_within};
use super::outline::to_segment;
use super::shape::{Found, Point, sides_of_panels};
use shape_up::math::Vec3;
use shape_up::math::plane::{Point2, bounds, cross, distance, is_inside, minus};
use std::collections::{BTreeMap, BTreeSet};

/// How exactly lines and names are where they should be, in mm of the drawing: coordinates are rounded to
/// hundredths, and parts are put together within a millimetre of the building.
const EXACT: f64 = 0.1;
/// How exactly the points of letters are where they should be, in mm: the smallest ones are 1 mm high, on a
/// grid of six.
const OF_LETTERS: f64 = 0.06;
/// Below it are only titles, in mm.
const MARGIN: f64 = 11.9;

/// A drawing, with the shape on it.
struct Seen<'a> {
    texts: Vec<Text>,
    lines: Vec<[Point2; 2]>,
    /// Where each node is.
    nodes: BTreeMap<&'a str, Point2>,
    /// How far away each node is.
    depths: BTreeMap<&'a str, f64>,
}

/// The unit vectors to the right, up, and away from a viewer whom a title names. The views from the
/// sides are isometric.
fn sight(title: &str) -> [Point; 3] {
    let (_, from) = title.split_once("SEEN FROM ").unwrap();
    let from = from.split(", WITHOUT").next().unwrap();
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
    match from {
        "ABOVE" => [x, y, -z],
        "BELOW" => [x, -y, z],
        _ => {
            let sign = |axis: char| if from.contains(&format!("+{axis}")) { 1.0 } else { -1.0 };
            assert!(from.ends_with(", ABOVE"), "{from}");
            let away = -(x * sign('X') + y * sign('Y') + z) * (1.0 / 3.0_f64.sqrt());
            let right = away.cross(z) * (1.0 / away.cross(z).length());
            [right, right.cross(away), away]
        }
    }
}

impl<'a> Seen<'a> {
    fn of(drawn: &Drawn, nodes: &'a BTreeMap<String, Point>) -> Seen<'a> {
        let [right, up, away] = sight(&drawn.title);
        let lines = drawn.lines("SHEET").into_iter();
        let lines = lines.filter(|line| line.iter().all(|point| point[1] > MARGIN));
        let lines: Vec<[Point2; 2]> = lines.map(|line| [line[0], line[1]]).collect();
        let projected = |at: &Point| [at.dot(right), at.dot(up)];
        // The scale and the place on the page are those at which the shape is as large as what is drawn.
        let [low, high] = bounds(nodes.values().map(projected));
        let [left, top] = bounds(lines.iter().flatten().copied());
        let scales = [0, 1].map(|k| (top[k] - left[k]) / (high[k] - low[k]));
        assert!((scales[0] / scales[1] - 1.0).abs() < 2e-3, "{}: {scales:?}", drawn.title);
        let put = |at: &Point| {
            let at = projected(at);
            [0, 1].map(|k| left[k] + scales[k] * (at[k] - low[k]))
        };
        Seen {
            texts: read_within(&drawn.lines("ENGRAVE"), OF_LETTERS),
            lines,
            nodes: nodes.iter().map(|(name, at)| (&**name, put(at))).collect(),
            depths: nodes.iter().map(|(name, at)| (&**name, at.dot(away))).collect(),
        }
    }

    fn corners(&self, panel: &[String]) -> Vec<Point2> {
        panel.iter().map(|node| self.nodes[&**node]).collect()
    }

    /// How far away a panel is at a point: that of its plane through three corners.
    fn depth(&self, panel: &[String], point: Point2) -> f64 {
        let [a, b, c] = [0, 1, 2].map(|k| (self.nodes[&*panel[k]], self.depths[&*panel[k]]));
        let (u, v, w) = (minus(b.0, a.0), minus(c.0, a.0), minus(point, a.0));
        let [s, t] = [cross(w, v), cross(u, w)].map(|x| x / cross(u, v));
        a.1 + s * (b.1 - a.1) + t * (c.1 - a.1)
    }

    /// The panel that is seen at a point.
    fn panel_at<'b>(
        &self,
        panels: &'b BTreeMap<String, Vec<String>>,
        point: Point2,
    ) -> Option<&'b str> {
        let there = panels.iter().filter(|(_, panel)| is_inside(&self.corners(panel), point));
        let depth = |panel: &Vec<String>| self.depth(panel, point);
        let nearest = there.min_by(|(_, a), (_, b)| depth(a).total_cmp(&depth(b)));
        nearest.map(|(name, _)| &**name)
    }
}

/// Checks all drawings against a shape that was put together.
pub(super) fn assert_shows(files: &Files, found: &Found) {
    let nodes = found.in_place(files);
    let panels: BTreeMap<String, Vec<String>> = sides_of_panels(files)
        .into_iter()
        .map(|(name, sides)| (name, sides.into_iter().map(|side| side.from).collect()))
        .collect();
    let edges: Vec<[String; 2]> = files
        .table("edges.csv")
        .rows()
        .map(|row| ["node_a", "node_b"].map(|column| row.text(column).to_owned()))
        .collect();
    let marks = marks(files);
    let drawings = files.drawn("key-");
    let mut shown: BTreeSet<String> = BTreeSet::new();
    for drawn in &drawings {
        // Unrolled, every panel or piece has its name, and nothing else has one.
        if drawn.title.contains("UNROLLED BY ROWS") {
            let texts = read_within(&drawn.lines("ENGRAVE"), OF_LETTERS);
            let texts: BTreeSet<String> = texts.into_iter().map(|own| own.text).collect();
            assert_eq!(texts, marks.values().flatten().cloned().collect());
            continue;
        }
        let seen = Seen::of(drawn, &nodes);
        let title = &drawn.title;
        for &[p, q] in &seen.lines {
            let is_edge = edges.iter().any(|ends| {
                let [a, b] = [0, 1].map(|k| seen.nodes[&*ends[k]]);
                let off = |c, d| distance(p, c).max(distance(q, d));
                off(a, b).min(off(b, a)) < EXACT
            });
            // Or a seam between two pieces, which are one panel.
            let middle = [0, 1].map(|k| 0.5 * (p[k] + q[k]));
            let panel = seen.panel_at(&panels, middle);
            assert!(
                is_edge || panel.is_some_and(|own| marks[own].len() > 1),
                "{title}: {p:?} {q:?}"
            );
        }
        assert!(!seen.texts.is_empty(), "{title}");
        for Text { text, centre, .. } in &seen.texts {
            let element = match text.strip_prefix('B').and_then(|ends| ends.split_once('-')) {
                _ if seen.nodes.contains_key(&**text) => {
                    assert!(distance(seen.nodes[&**text], *centre) < EXACT, "{title}: {text}");
                    text.clone()
                }
                Some((a, b)) if marks.contains_key(text) => {
                    let ends = [a, b].map(|end| seen.nodes[&*format!("N{end}")]);
                    assert!(to_segment(*centre, ends) < EXACT, "{title}: {text}");
                    text.clone()
                }
                _ => {
                    let panel = seen.panel_at(&panels, *centre);
                    let panel = panel.unwrap_or_else(|| panic!("{title}: {text} is on no panel"));
                    assert!(marks[panel].contains(text), "{title}: {text} is on {panel}");
                    // A piece of paper has its name on each of its panels.
                    if text.starts_with('S') { panel.to_owned() } else { text.clone() }
                }
            };
            shown.insert(element);
        }
    }
    let of_panel = |(element, names): (&String, &Vec<String>)| match names.len() {
        1 => vec![element.clone()],
        _ => names.clone(),
    };
    let expected: BTreeSet<String> = marks.iter().flat_map(of_panel).collect();
    let missing = expected.difference(&shown).count();
    assert!(shown.is_subset(&expected), "{:?}", shown.difference(&expected));
    for drawn in &drawings {
        let said = drawn
            .title
            .split_once(", WITHOUT ")
            .map_or(0, |(_, said)| said.split(' ').next().unwrap().parse().unwrap());
        assert_eq!(said, missing, "{}", drawn.title);
    }
}

/// What is written on each panel, beam and node.
fn marks(files: &Files) -> BTreeMap<String, Vec<String>> {
    let mut marks: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut add = |element: &str, name: &str| {
        marks.entry(element.to_owned()).or_default().push(name.to_owned());
    };
    let product = files.text("product");
    match &*product {
        "fins" => {
            let table = files.table("fins.csv");
            for row in table.rows() {
                add(row.text("name"), row.text("name"));
            }
            let ends = table.rows().flat_map(|row| ["node_a", "node_b"].map(|k| row.text(k)));
            ends.collect::<BTreeSet<_>>().into_iter().for_each(|node| add(node, node));
        }
        "paper" => {
            for row in files.table("pieces.csv").rows() {
                row.text("names").split(' ').for_each(|panel| add(panel, row.text("name")));
            }
        }
        _ => {
            // A triangle that is half of a panel has edges of its own; a piece has those of its panel.
            let panels = sides_of_panels(files);
            for row in files.table("panels.csv").rows() {
                let name = row.text("name");
                let piece = name.split('.').next().unwrap();
                add(if panels.contains_key(name) { name } else { piece }, name);
            }
        }
    }
    marks
}
