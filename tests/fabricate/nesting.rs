//! Parts of any shape nested in each other: random outlines keep the gap and the margin.

use shape_up::fabricate::panel::is_simple;
use shape_up::fabricate::sheet::{CutPart, Layout, SheetSize, lay_out};
use shape_up::math::plane::{Point2, cross, distance, dot, is_inside, minus};
use shape_up::math::{cosine, sine};
use shape_up::scene::Order;

const A3: SheetSize = SheetSize { size: [420.0, 297.0], margin: 5.0, gap: 3.0 };

/// Pseudorandom numbers in 0..1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

fn rectangle([width, height]: [f64; 2]) -> Vec<Point2> {
    vec![[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]]
}

/// A bar of this width with teeth upwards; with two of them a U.
fn comb(teeth: u32, [width, height]: [f64; 2], thick: f64) -> Vec<Point2> {
    let step = (width - thick) / f64::from(teeth - 1);
    let mut outline = vec![[0.0, 0.0], [width, 0.0]];
    for k in (0..teeth).rev() {
        let left = step * f64::from(k);
        outline.push([left + thick, if k + 1 == teeth { height } else { thick }]);
        if k + 1 < teeth {
            outline.push([left + thick, height]);
        }
        outline.push([left, height]);
        if k > 0 {
            outline.push([left, thick]);
        }
    }
    outline
}

/// Part of a ring.
fn arc(radius: f64, thick: f64, turns: f64) -> Vec<Point2> {
    let at = |radius: f64, k: i32| {
        let at = turns * f64::from(k) / 16.0;
        [radius * cosine(at), radius * sine(at)]
    };
    let outer = (0..=16).map(|k| at(radius, k));
    outer.chain((0..=16).rev().map(|k| at(radius - thick, k))).collect()
}

/// As many parts of each kind, each somehow rotated.
fn parts_of_all_kinds(random: &mut Random, number: usize) -> Vec<CutPart> {
    let mut parts = Vec::new();
    for k in 0..number {
        let size = [random.within(40.0, 180.0), random.within(30.0, 120.0)];
        let thick = random.within(4.0, 0.2 * size[0].min(size[1]) + 4.0);
        let outline = match k % 4 {
            0 => comb(2, size, thick),
            1 => comb(3 + (k as u32 / 4) % 3, size, 0.6 * thick),
            2 => arc(0.6 * size[0], thick, random.within(0.2, 0.8)),
            _ => rectangle(size.map(|size| 0.3 * size)),
        };
        let turn = [cosine, sine].map(|of| of(0.1 * k as f64));
        let outline: Vec<Point2> = outline
            .iter()
            .map(|&p| [dot(p, [turn[0], -turn[1]]), dot(p, [turn[1], turn[0]])])
            .collect();
        assert!(is_simple(&outline) && shape_up::math::plane::area(&outline) > 0.0);
        parts.push(CutPart { name: format!("P{k}"), outline, ..CutPart::default() });
    }
    parts
}

fn sides(outline: &[Point2]) -> impl Iterator<Item = [Point2; 2]> + Clone + '_ {
    shape_up::math::polygon_sides(outline)
}

/// The distance of two parts; 0 if they overlap.
fn apart(a: &[Point2], b: &[Point2]) -> f64 {
    let cross_each_other = |[p, q]: [Point2; 2], [r, s]: [Point2; 2]| {
        let left = |p: Point2, q: Point2, x: Point2| cross(minus(q, p), minus(x, p)) > 0.0;
        left(p, q, r) != left(p, q, s) && left(r, s, p) != left(r, s, q)
    };
    let crosses = |side: [Point2; 2]| sides(b).any(|other| cross_each_other(side, other));
    if is_inside(a, b[0]) || is_inside(b, a[0]) || sides(a).any(crosses) {
        return 0.0;
    }
    let to_side = |point: Point2, [p, q]: [Point2; 2]| {
        let (along, at) = (minus(q, p), minus(point, p));
        let share = (dot(at, along) / dot(along, along)).clamp(0.0, 1.0);
        distance(at, along.map(|x| share * x))
    };
    let from = |a: &[Point2], b: &[Point2]| {
        let all = a.iter().flat_map(|&point| sides(b).map(move |side| to_side(point, side)));
        all.fold(f64::INFINITY, f64::min)
    };
    from(a, b).min(from(b, a))
}

/// Asserts that every part is on a sheet once, within the margin and at the gap from the others, or
/// named as too large.
fn is_right(parts: &[CutPart], layout: &Layout, sheet: SheetSize) {
    let mut seen = layout.too_large.clone();
    for own in &layout.sheets {
        assert!(!own.places.is_empty());
        let outlines: Vec<Vec<Point2>> = (own.places.iter())
            .map(|place| {
                parts[place.part].outline.iter().map(|&point| place.to_sheet(point)).collect()
            })
            .collect();
        for (k, outline) in outlines.iter().enumerate() {
            for point in outline {
                let is_within = (0..2).all(|k| {
                    point[k] > sheet.margin - 1e-6 && point[k] < sheet.size[k] - sheet.margin + 1e-6
                });
                assert!(is_within, "{point:?}");
            }
            for other in &outlines[..k] {
                let apart = apart(outline, other);
                assert!(apart >= sheet.gap - 1e-5 && apart > 0.0, "{apart}");
            }
        }
        seen.extend(own.places.iter().map(|place| place.part));
    }
    seen.sort_unstable();
    assert_eq!(seen, (0..parts.len()).collect::<Vec<_>>());
}

#[test]
fn parts_of_any_shape_keep_the_gap_and_the_margin_and_need_no_more_sheets_than_rows() {
    let mut random = Random(3);
    let mut fewer = 0;
    for (number, size, gap, margin) in [
        (24, [420.0, 297.0], 3.0, 5.0),
        (40, [297.0, 420.0], 1.0, 0.0),
        (33, [600.0, 300.0], 8.0, 12.0),
        (20, [250.0, 200.0], 0.5, 3.0),
    ] {
        let parts = parts_of_all_kinds(&mut random, number);
        let sheet = SheetSize { size, gap, margin };
        let layout = lay_out(&parts, sheet, Order::Size);
        is_right(&parts, &layout, sheet);
        assert_eq!(lay_out(&parts, sheet, Order::Size).places(number), layout.places(number));
        let in_rows = lay_out(&parts, sheet, Order::Names);
        is_right(&parts, &in_rows, sheet);
        assert!(layout.sheets.len() <= in_rows.sheets.len());
        fewer += in_rows.sheets.len() - layout.sheets.len();
    }
    assert!(fewer >= 4, "{fewer}");
}

#[test]
fn what_has_room_in_the_notch_of_a_part_needs_no_other_sheet() {
    // Nothing else of the sheet has room for the plate, or for the smaller U with its own plate.
    let parts =
        [comb(2, [400.0, 280.0], 20.0), comb(2, [340.0, 240.0], 20.0), rectangle([280.0, 200.0])];
    let parts = parts.map(|outline| CutPart { outline, ..CutPart::default() });
    let layout = lay_out(&parts, A3, Order::Size);
    is_right(&parts, &layout, A3);
    assert_eq!(layout.sheets.len(), 1);
    assert_eq!(lay_out(&parts, A3, Order::Names).sheets.len(), 3);
}

#[test]
fn a_part_larger_than_the_sheet_is_named_and_the_others_are_nested() {
    let mut parts = parts_of_all_kinds(&mut Random(9), 12);
    parts.insert(5, CutPart { outline: comb(2, [500.0, 320.0], 15.0), ..CutPart::default() });
    let layout = lay_out(&parts, A3, Order::Size);
    is_right(&parts, &layout, A3);
    assert_eq!(layout.too_large, [5]);
}
