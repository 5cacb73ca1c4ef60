//! Paper: pieces are folded along their lines, and tabs are glued behind the panels that are written on
//! them, or that the name at their side tells; tongues go into the slots of their name. Edges of card are
//! taped to each other.

use super::files::{Files, Part};
use super::letters::Text;
use super::outline::{left_of, lengths, widened, written};
use super::shape::{Flat, Found, Side, assembled, matching, sides_of_panels};
use shape_up::math::plane::{Point2, area, cross, distance, dot, is_inside, minus};
use std::collections::{BTreeMap, BTreeSet};

/// Corners at which lines end are the same within this, in mm, on creased paper and on card.
const EXACT: [f64; 2] = [0.1, 5e-4];

/// What a side of a region of a piece is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Line {
    Cut,
    Ridge,
    Valley,
}

/// A region of a piece between its lines.
struct Region {
    corners: Vec<Point2>,
    lines: Vec<Line>,
    /// The region beyond each side, on the same piece.
    beyond: Vec<Option<usize>>,
    texts: Vec<Text>,
}

impl Region {
    /// Joins sides in line: where panels are shorter, their sides go on beyond the end of a hinge.
    fn without_steps(mut self) -> Region {
        let mut k = 0;
        while k < self.corners.len() {
            let n = self.corners.len();
            let [p, at, q] = [k + n - 1, k, k + 1].map(|k| self.corners[k % n]);
            let (before, after) = (minus(at, p), minus(q, at));
            if cross(before, after).abs() > 0.01 * distance(p, at) * distance(at, q) {
                k += 1;
                continue;
            }
            let kept = (k + n - 1) % n;
            if self.lines[kept] == Line::Cut {
                (self.lines[kept], self.beyond[kept]) = (self.lines[k], self.beyond[k]);
            }
            self.corners.remove(k);
            self.lines.remove(k);
            self.beyond.remove(k);
        }
        self
    }

    /// Whether it is a tongue: a rectangle with bevelled corners, of which only one side is folded.
    fn is_tongue(&self) -> bool {
        let is_folded = |k: &usize| self.lines[*k] != Line::Cut;
        let [k] = (0..self.lines.len()).filter(is_folded).collect::<Vec<_>>()[..] else {
            return false;
        };
        let side = |i: usize| {
            let [p, q] = [0, 1].map(|end| self.corners[(k + i + end) % self.corners.len()]);
            minus(q, p)
        };
        let is_square = |i: usize| {
            dot(side(0), side(i)).abs()
                < 0.01 * (dot(side(0), side(0)) * dot(side(i), side(i))).sqrt()
        };
        self.corners.len() == 6 && is_square(1) && is_square(5)
    }

    /// Whether it is a tab: a trapezium of which only the longer of two parallel sides is folded, with
    /// angles of at most 45 degrees there.
    fn is_tab(&self) -> bool {
        let folded: Vec<usize> =
            (0..self.lines.len()).filter(|&k| self.lines[k] != Line::Cut).collect();
        let [k] = folded[..] else { return false };
        let corner = |i: usize| self.corners[(k + i) % self.corners.len()];
        let [p, q, a, b] = [0, 1, 2, 3].map(corner);
        let angle = |u: Point2, v: Point2| libm::atan2(cross(u, v).abs(), dot(u, v)).to_degrees();
        let base = minus(q, p);
        self.corners.len() == 4
            && cross(base, minus(b, a)).abs() < 1e-3 * distance(p, q)
            && angle(base, minus(b, p)) < 45.01
            && angle(minus(p, q), minus(a, q)) < 45.01
    }
}

/// Folds and glues a paper model.
pub(super) fn assemble(files: &Files) -> Found {
    let scale = files.number("Scale 1 : (scale)");
    let sides = sides_of_panels(files);
    let (mut parts, _) = files.parts();
    let kerf = files.number("Kerf (kerf)");
    for part in &mut parts {
        part.outline = left_of(&part.outline, kerf);
        close_folds(part, kerf);
    }
    if files.text("Print on the inside (print_inside)") == "on" {
        parts.iter_mut().for_each(turn_over);
    }
    let has_tabs = files.text("Folds (fold)") == "crease";
    let exact = EXACT[usize::from(!has_tabs)];
    let is_shorter = ["score", "separate"].iter().any(|word| files.text("Folds (fold)") == *word);
    // How far before each edge panels end, in mm of the sheet.
    let backs: BTreeMap<String, f64> = files
        .table("joins.csv")
        .rows()
        .filter(|_| is_shorter)
        .map(|row| (row.text("edge").to_owned(), row.number("cut_back_sheet_mm")))
        .collect();
    let back = |side: &Side| {
        let [a, b] = [&side.from, &side.to].map(|node| node.trim_start_matches('N'));
        let names = [format!("B{a}-{b}"), format!("B{b}-{a}")];
        names.iter().find_map(|name| backs.get(name)).copied().unwrap_or(0.0)
    };
    let known: BTreeMap<String, BTreeSet<String>> = files
        .table("pieces.csv")
        .rows()
        .map(|row| {
            let names = row.text("names").split(' ').map(str::to_owned).collect();
            (row.text("name").to_owned(), names)
        })
        .collect();
    let mut panels = BTreeMap::new();
    // Tabs, as the panel that each is on and the panel behind which it is glued.
    let mut glued: Vec<(String, String)> = Vec::new();
    // By the name of a tongue: what is at a slot and at the tongue, as the panels there and beyond.
    let mut tongues: [BTreeMap<String, (String, String)>; 2] = Default::default();
    for part in &parts {
        let regions: Vec<Region> =
            regions(part, exact).into_iter().map(Region::without_steps).collect();
        let mut names: Vec<Option<String>> = Vec::new();
        for region in &regions {
            let is_added = has_tabs && (region.is_tab() || region.is_tongue());
            let own = (!is_added).then(|| own_name(part, region));
            assert!(own.as_ref().is_none_or(|own| known[&part.name].contains(own)), "{own:?}");
            names.push(own);
        }
        assert_eq!(names.iter().flatten().count(), known[&part.name].len(), "{}", part.name);
        for (region, name) in regions.iter().zip(&names) {
            let Some(name) = name else { continue };
            let both = [name.clone(), format!("{}: {name}", part.name)];
            let beside = region.texts.iter().filter(|text| !both.contains(&text.text));
            let beside: Vec<Text> = beside.cloned().collect();
            let mut written = written(name, &region.corners, &beside);
            let (mut is_joined, mut has_tab) = (Vec::new(), Vec::new());
            for (k, beyond) in region.beyond.iter().enumerate() {
                let other = beyond.map(|other| (&names[other], &regions[other]));
                match other {
                    Some((Some(other), _)) => written[k] = Some(other.clone()),
                    Some((None, tab)) if !tab.texts.is_empty() => {
                        assert_eq!(tab.texts.len(), 1, "{}", part.name);
                        let text = &tab.texts[0].text;
                        match text.starts_with('T') {
                            // Beside the name of the neighbour, which is written on the panel.
                            true => {
                                let beyond = written[k].take().unwrap_or_default();
                                written[k] = Some(format!("{beyond} {text}"));
                            }
                            false => written[k] = Some(text.clone()),
                        }
                    }
                    _ => {}
                }
                is_joined.push(matches!(other, Some((Some(_), _))));
                has_tab.push(other.filter(|(other, _)| other.is_none()).map(|(_, tab)| tab));
            }
            let of_tongues: Vec<Option<String>> = written
                .iter_mut()
                .map(|written| {
                    let (beyond, tongue) = written.as_ref()?.split_once(' ')?;
                    let (beyond, tongue) = (beyond.to_owned(), tongue.to_owned());
                    *written = (!beyond.is_empty()).then_some(beyond);
                    Some(tongue)
                })
                .collect();
            let mut own = sides[name].clone();
            // The whole panel, if the first side of the region is this one.
            let whole = |first: usize| {
                let by: Vec<f64> = own.iter().map(back).collect();
                let by = [&by[first..], &by[..first]].concat();
                let whole = widened(&region.corners, &by).into_iter();
                let corners: Vec<Point2> = whole.map(|corner| corner.map(|x| scale * x)).collect();
                let measured: Vec<_> =
                    lengths(&corners).into_iter().zip(written.iter().cloned()).collect();
                let fits = matching(&own, &measured, exact.max(0.01) * scale).contains(&first);
                fits.then_some((first, corners))
            };
            let ways: Vec<_> = (0..own.len()).filter_map(whole).collect();
            let [(first, corners)] = &ways[..] else { panic!("{name}: {own:?} {ways:?}") };
            let corners = corners.clone();
            own.rotate_left(*first);
            for (k, side) in own.iter().enumerate() {
                // A fold is made the way in which its line is drawn.
                let expected = if side.fold > 0.0 { Line::Ridge } else { Line::Valley };
                assert!([Line::Cut, expected].contains(&region.lines[k]), "{name} {side:?}");
                let Some(added) = has_tab[k] else { continue };
                let panels = (name.clone(), side.beyond.clone());
                match &of_tongues[k] {
                    // Its name has no room; that at its slot tells where it goes.
                    None if added.is_tongue() => {}
                    None => glued.push(panels),
                    Some(tongue) => {
                        let of = &mut tongues[usize::from(added.is_tongue())];
                        assert!(of.insert(tongue.clone(), panels).is_none(), "{tongue} twice");
                    }
                }
            }
            if !has_tabs {
                is_joined.fill(true);
            }
            let before = panels.insert(name.clone(), Flat { corners, sides: own, is_joined });
            assert!(before.is_none(), "{name} is there twice");
        }
    }
    assert_eq!(panels.len(), sides.len(), "every panel is on a piece");
    // A tongue that is found by its name has its slot, at the edge that it is on. Others have no room for
    // letters of 2 mm.
    let [slots, tongues] = tongues;
    assert_eq!(slots.is_empty(), tongues.is_empty());
    for (name, (own, beyond)) in &tongues {
        assert_eq!(slots[name], (beyond.clone(), own.clone()), "{name}");
    }
    for (on, behind) in glued.into_iter().chain(slots.into_values()) {
        for (own, other) in [(&on, &behind), (&behind, &on)] {
            let panel = panels.get_mut(own).unwrap();
            let k = panel.sides.iter().position(|side| side.beyond == *other).unwrap();
            assert!(!std::mem::replace(&mut panel.is_joined[k], true), "{on} {behind}");
        }
    }
    assembled(&panels)
}

/// Adds what a slot leaves out of a fold: the side of the slot along it, with the kerf.
fn close_folds(part: &mut Part, kerf: f64) {
    const EXACT: f64 = 0.01;
    for hole in &part.holes {
        let hole = widened(hole, &vec![0.5 * kerf; hole.len()]);
        for lines in [&mut part.folds, &mut part.valleys] {
            let ends: Vec<Point2> = lines.iter().flatten().copied().collect();
            let is_end = |point: Point2| ends.iter().any(|end| distance(*end, point) < EXACT);
            let sides = (0..4).map(|k| [hole[k], hole[(k + 1) % 4]]);
            lines.extend(sides.filter(|side| side.iter().all(|&point| is_end(point))));
        }
    }
}

/// Turns a piece over: what was printed on is inside, and its ridges are valleys seen from outside.
fn turn_over(part: &mut Part) {
    let over = |point: &mut Point2| point[0] = -point[0];
    part.outline.iter_mut().for_each(over);
    part.outline.reverse();
    std::mem::swap(&mut part.folds, &mut part.valleys);
    part.folds.iter_mut().chain(&mut part.valleys).flatten().for_each(over);
    part.texts.iter_mut().for_each(|text| over(&mut text.centre));
}

/// The name of the panel of a region: the largest one there, or the one that is underlined; without
/// that of the piece before it.
fn own_name(part: &Part, region: &Region) -> String {
    let tallest = region
        .texts
        .iter()
        .max_by(|a, b| a.is_underlined.cmp(&b.is_underlined).then(a.height.total_cmp(&b.height)));
    let text = &tallest.unwrap_or_else(|| panic!("{} has a panel without name", part.name)).text;
    text.strip_prefix(&format!("{}: ", part.name)).unwrap_or(text).to_owned()
}

/// The regions of a piece between its outline and its folds, whose ends are the same within `exact` mm.
fn regions(part: &Part, exact: f64) -> Vec<Region> {
    let mut points: Vec<Point2> = Vec::new();
    let mut number = |at: Point2| {
        let known = points.iter().position(|&other| distance(other, at) < exact);
        known.unwrap_or_else(|| {
            points.push(at);
            points.len() - 1
        })
    };
    let n = part.outline.len();
    // Ways along lines; the outline is walked with the piece to the left only.
    let mut ways: Vec<([usize; 2], Line)> = Vec::new();
    for k in 0..n {
        let ends = [part.outline[k], part.outline[(k + 1) % n]].map(&mut number);
        ways.push((ends, Line::Cut));
    }
    for (lines, line) in [(&part.folds, Line::Ridge), (&part.valleys, Line::Valley)] {
        for ends in lines {
            let [p, q] = ends.map(&mut number);
            ways.extend([([p, q], line), ([q, p], line)]);
        }
    }
    let index: BTreeMap<[usize; 2], usize> =
        ways.iter().enumerate().map(|(k, (ends, _))| (*ends, k)).collect();
    assert_eq!(index.len(), ways.len(), "{} has a line twice", part.name);
    // At its end, a way goes on along the one that turns most to the left.
    let next = |way: usize| {
        let [p, q] = ways[way].0;
        let back = minus(points[p], points[q]);
        let angle = |other: &usize| {
            let along = minus(points[ways[*other].0[1]], points[q]);
            let angle = libm::atan2(cross(along, back), dot(along, back));
            if angle <= 1e-9 { angle + std::f64::consts::TAU } else { angle }
        };
        let on = (0..ways.len()).filter(|&other| ways[other].0[0] == q);
        on.min_by(|a, b| angle(a).total_cmp(&angle(b))).unwrap()
    };
    let mut region_of: Vec<Option<usize>> = vec![None; ways.len()];
    let mut walks: Vec<Vec<usize>> = Vec::new();
    for start in 0..ways.len() {
        let mut way = start;
        if region_of[start].is_some() {
            continue;
        }
        let mut walk = Vec::new();
        while region_of[way].is_none() {
            region_of[way] = Some(walks.len());
            walk.push(way);
            way = next(way);
        }
        assert_eq!(way, start, "the lines of {} do not close", part.name);
        walks.push(walk);
    }
    let region = |walk: &Vec<usize>| {
        let corners: Vec<Point2> = walk.iter().map(|&way| points[ways[way].0[0]]).collect();
        assert!(area(&corners) > 0.0, "{}", part.name);
        let beyond = |&way: &usize| {
            let [p, q] = ways[way].0;
            index.get(&[q, p]).and_then(|&back| region_of[back])
        };
        Region {
            lines: walk.iter().map(|&way| ways[way].1).collect(),
            beyond: walk.iter().map(beyond).collect(),
            texts: (part.texts.iter())
                .filter(|text| is_inside(&corners, text.centre))
                .cloned()
                .collect(),
            corners,
        }
    };
    walks.iter().map(region).collect()
}
