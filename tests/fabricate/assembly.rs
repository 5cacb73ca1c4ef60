//! Fins and node discs are assembled from the drawings and the tables alone, as a workshop does it, and
//! no plate is where another one is.

use super::identities::revolution;
use super::{build, metres, text_of};
use shape_up::fabricate::sheet::Role;
use shape_up::fabricate::{Build, Stand};
use shape_up::generate::NewKind;
use shape_up::math::{Vec3, ears};
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, OffsetKind, Product};
use std::collections::BTreeMap;

type Point = [f64; 2];
type V = Vec3<f64>;
/// Rows of a table by their columns.
type Rows = Vec<BTreeMap<String, String>>;

/// Tables have six decimals, so that discs are placed a little above their seats, in mm.
const ABOVE: f64 = 1e-3;

fn settings() -> BuildSettings {
    BuildSettings {
        product: Product::Fins,
        distance: Some(0.25),
        scale: 10.0,
        thickness: 3.0,
        disc: None,
        sheet: [1200.0, 600.0],
        ..BuildSettings::default()
    }
}

/// Lines of the sheets: outlines by the name of their part, and slots.
#[derive(Clone, Default)]
struct Sheets {
    outlines: BTreeMap<String, Vec<Point>>,
    slots: BTreeMap<String, Vec<Vec<Point>>>,
}

/// What a workshop gets.
#[derive(Clone)]
struct Delivered {
    sheets: Sheets,
    tables: BTreeMap<&'static str, Rows>,
    thickness: f64,
    scale: f64,
    outwards: bool,
}

fn rows(made: &Build, name: &str) -> Rows {
    let text = text_of(made, name);
    let mut lines = text.lines().map(|line| line.split(','));
    let columns: Vec<&str> = lines.next().expect("a header").collect();
    let row = |cells: std::str::Split<'_, char>| {
        columns.iter().map(|&column| column.to_owned()).zip(cells.map(str::to_owned)).collect()
    };
    lines.map(row).collect()
}

fn delivered(made: &Build) -> Delivered {
    let mut sheets = Sheets::default();
    for line in made.drawings().into_iter().flat_map(|drawing| drawing.lines) {
        match line.role {
            Role::Cut => assert!(sheets.outlines.insert(line.part, line.points).is_none()),
            Role::Hole => sheets.slots.entry(line.part).or_default().push(line.points),
            _ => {}
        }
    }
    let names = ["nodes.csv", "fins.csv", "node-beams.csv", "discs.csv"];
    Delivered {
        sheets,
        tables: names.into_iter().map(|name| (name, rows(made, name))).collect(),
        thickness: made.settings.thickness,
        scale: made.settings.scale,
        outwards: made.distance() > 0.0,
    }
}

fn number(row: &BTreeMap<String, String>, column: &str) -> f64 {
    row[column].parse().expect("a number")
}

/// A point on the sheet, in the coordinates of its part.
fn on_part(row: &BTreeMap<String, String>, [x, y]: Point) -> Point {
    let [x, y] = [x - number(row, "x_sheet_mm"), y - number(row, "y_sheet_mm")];
    let (s, c) = libm::sincos(number(row, "turn_deg").to_radians());
    [c * x + s * y, c * y - s * x]
}

fn unit(v: V) -> V {
    v * (1.0 / v.length())
}

/// A convex body: its faces, counterclockwise seen from outside.
#[derive(Clone)]
struct Body(Vec<Vec<V>>);

impl Body {
    /// What is between a triangle and the same triangle moved.
    fn prism(triangle: [V; 3], by: V) -> Body {
        let [a, b, c] = match (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).dot(by) {
            up if up > 0.0 => triangle,
            _ => [triangle[0], triangle[2], triangle[1]],
        };
        let mut faces = vec![vec![a, c, b], vec![a + by, b + by, c + by]];
        faces.extend([[a, b], [b, c], [c, a]].map(|[p, q]| vec![p, q, q + by, p + by]));
        Body(faces)
    }

    fn bounds(&self) -> [[f64; 3]; 2] {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in self.0.iter().flatten() {
            for (k, x) in [point.x, point.y, point.z].into_iter().enumerate() {
                (low[k], high[k]) = (low[k].min(x), high[k].max(x));
            }
        }
        [low, high]
    }

    fn volume(&self) -> f64 {
        let Some(&origin) = self.0.first().and_then(|face| face.first()) else { return 0.0 };
        let of_face = |face: &Vec<V>| -> f64 {
            (2..face.len())
                .map(|k| {
                    let [a, b, c] = [0, k - 1, k].map(|k| face[k] - origin);
                    a.dot(b.cross(c)) / 6.0
                })
                .sum()
        };
        self.0.iter().map(of_face).sum()
    }

    /// The part of it on the inner side of a plane.
    fn clipped(&self, at: V, outwards: V) -> Body {
        let far = |p: V| (p - at).dot(outwards);
        if self.0.iter().flatten().all(|&p| far(p) <= 0.0) {
            return self.clone();
        }
        let (mut faces, mut cap) = (Vec::new(), Vec::new());
        for face in &self.0 {
            let mut kept = Vec::new();
            for (k, &p) in face.iter().enumerate() {
                let q = face[(k + 1) % face.len()];
                let (from, to) = (far(p), far(q));
                if from <= 0.0 {
                    kept.push(p);
                }
                if (from < 0.0 && to > 0.0) || (from > 0.0 && to < 0.0) {
                    kept.push(p + (q - p) * (from / (from - to)));
                }
            }
            cap.extend(kept.iter().copied().filter(|&p| far(p).abs() < 1e-9));
            if kept.len() > 2 {
                faces.push(kept);
            }
        }
        if cap.len() > 2 {
            let centre = cap.iter().fold(V::zero(), |sum, &p| sum + p) * (1.0 / cap.len() as f64);
            let farthest = cap
                .iter()
                .copied()
                .max_by(|a, b| (*a - centre).length().total_cmp(&(*b - centre).length()));
            let x = unit(farthest.expect("there are some") - centre);
            let y = unit(outwards).cross(x);
            let turn = |p: &V| libm::atan2((*p - centre).dot(y), (*p - centre).dot(x));
            cap.sort_by(|a, b| turn(a).total_cmp(&turn(b)));
            faces.push(cap);
        }
        Body(faces)
    }

    fn common_volume(&self, other: &Body) -> f64 {
        let mut left = self.clone();
        for face in &other.0 {
            let outwards = unit((face[1] - face[0]).cross(face[2] - face[0]));
            left = left.clipped(face[0], outwards);
            if left.0.is_empty() {
                return 0.0;
            }
        }
        left.volume()
    }
}

/// A plate as convex bodies, each with its bounds.
struct Plate {
    name: String,
    bodies: Vec<(Body, [[f64; 3]; 2])>,
    volume: f64,
}

impl Plate {
    fn new(name: &str, outline: &[Point], put: impl Fn(Point) -> V, by: V) -> Plate {
        let bodies = ears(outline).into_iter().map(|corners| {
            let body = Body::prism(corners.map(|k| put(outline[k])), by);
            let bounds = body.bounds();
            (body, bounds)
        });
        let bodies: Vec<_> = bodies.collect();
        let volume = bodies.iter().map(|(body, _)| body.volume()).sum();
        Plate { name: name.to_owned(), bodies, volume }
    }

    fn common_volume(&self, other: &Plate) -> f64 {
        let mut sum = 0.0;
        for (body, [low, high]) in &self.bodies {
            for (second, [under, over]) in &other.bodies {
                if (0..3).all(|k| low[k] < over[k] && under[k] < high[k]) {
                    sum += body.common_volume(second);
                }
            }
        }
        sum
    }

    fn bounds(&self) -> [[f64; 3]; 2] {
        let of = |pick: fn(f64, f64) -> f64, side: usize| {
            let all = self.bodies.iter().map(|(_, bounds)| bounds[side]);
            all.reduce(|a, b| [0, 1, 2].map(|k| pick(a[k], b[k]))).expect("a plate has bodies")
        };
        [of(f64::min, 0), of(f64::max, 1)]
    }
}

/// What an assembly shows.
#[derive(Debug, Default)]
struct Found {
    plates: usize,
    tenons: usize,
    /// The largest common volume of two plates, relative to the smaller one, and their names.
    overlap: (f64, String),
    /// The least share of a slot that its tenon fills, also where it leaves the disc.
    filled: f64,
}

fn assembled(own: &Delivered) -> Found {
    let Delivered { sheets, tables, thickness, scale, outwards } = own;
    let mut nodes = BTreeMap::new();
    for row in &tables["nodes.csv"] {
        let of = |columns: [&str; 3]| {
            let [x, y, z] = columns.map(|column| number(row, column));
            V::new(x, y, z)
        };
        let at = of(["x_mm", "y_mm", "z_mm"]) * (1.0 / scale);
        nodes.insert(row["name"].clone(), (at, of(["axis_x", "axis_y", "axis_z"])));
    }
    let mut plates = Vec::new();
    let mut of_node: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for row in &tables["fins.csv"] {
        let [a, b] = ["node_a", "node_b"].map(|column| nodes[&row[column]]);
        let t = unit(b.0 - a.0);
        let across = a.1 + b.1;
        let up = unit(across - t * across.dot(t));
        let aside = t.cross(up) * (0.5 * thickness);
        let outline = sheets.outlines[&row["name"]].iter().map(|&p| on_part(row, p));
        let outline: Vec<Point> = outline.collect();
        let put = |[x, y]: Point| a.0 + t * x + up * y - aside;
        for column in ["node_a", "node_b"] {
            of_node.entry(&row[column]).or_default().push(plates.len());
        }
        plates.push(Plate::new(&row["name"], &outline, put, aside * 2.0));
    }
    let mut found = Found { filled: f64::INFINITY, ..Found::default() };
    let side = if *outwards { 1.0 } else { -1.0 };
    for row in &tables["discs.csv"] {
        let (at, axis) = nodes[&row["name"]];
        let axis = unit(axis);
        let is_first =
            |beam: &&BTreeMap<String, String>| beam["node"] == row["name"] && beam["number"] == "1";
        let first = tables["node-beams.csv"].iter().find(is_first).expect("it is listed");
        let ends: Vec<&str> = first["beam"][1..].split('-').collect();
        let other = ends.into_iter().map(|v| format!("N{v}")).find(|v| *v != row["name"]);
        let along = nodes[&other.expect("it has another end")].0 - at;
        let x = unit(along - axis * along.dot(axis));
        let y = axis.cross(x);
        let seat = number(row, "seat_sheet_mm") + side * ABOVE;
        let put = |[u, v]: Point| at + axis * seat + x * u + y * v;
        let by = axis * (side * thickness);
        let flat = |outline: &Vec<Point>| -> Vec<Point> {
            outline.iter().map(|&point| on_part(row, point)).collect()
        };
        let outline = flat(&sheets.outlines[&row["name"]]);
        let slots: Vec<Vec<Point>> = sheets.slots[&row["name"]].iter().map(flat).collect();
        assert_eq!(slots.len(), of_node[&*row["name"]].len(), "a slot for each fin");
        for &fin in &of_node[&*row["name"]] {
            // The slot as a body, and the last hundredth of it where the tenon leaves the disc.
            let share = |slot: &Vec<Point>| {
                let whole = Plate::new("", slot, put, by);
                let leaving = Plate::new("", slot, |p| put(p) + by * 0.989, by * 0.01);
                let filled = |body: &Plate| plates[fin].common_volume(body) / body.volume;
                filled(&whole).min(filled(&leaving))
            };
            found.filled = found.filled.min(slots.iter().map(share).fold(0.0, f64::max));
            found.tenons += 1;
        }
        plates.push(Plate::new(&row["name"], &with_slots(&outline, &slots), put, by));
    }
    found.plates = plates.len();
    let bounds: Vec<_> = plates.iter().map(Plate::bounds).collect();
    for (k, plate) in plates.iter().enumerate() {
        for (j, other) in plates[..k].iter().enumerate() {
            let [[low, high], [under, over]] = [bounds[k], bounds[j]];
            if (0..3).all(|x| low[x] < over[x] && under[x] < high[x]) {
                let share = plate.common_volume(other) / plate.volume.min(other.volume);
                if share > found.overlap.0 {
                    found.overlap = (share, format!("{} {}", plate.name, other.name));
                }
            }
        }
    }
    found
}

/// An outline with slots, each joined to it by a cut without width between the nearest corners.
fn with_slots(outline: &[Point], slots: &[Vec<Point>]) -> Vec<Point> {
    let mut whole = outline.to_vec();
    for slot in slots {
        let mut pairs = Vec::new();
        for (i, p) in outline.iter().enumerate() {
            for (j, q) in slot.iter().enumerate() {
                pairs.push((crate::fabricate::length([p[0] - q[0], p[1] - q[1]]), i, j));
            }
        }
        let nearest = pairs.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).expect("corners");
        let (_, i, j) = nearest;
        let at = whole.iter().position(|p| *p == outline[i]).expect("it is there");
        let around = (0..=slot.len()).map(|k| slot[(j + slot.len() - k) % slot.len()]);
        let cut: Vec<Point> = around.chain([outline[i]]).collect();
        whole.splice(at + 1..at + 1, cut);
    }
    whole
}

fn assert_fits(made: &Build, name: &str) {
    assert!(made.not_cut.is_empty(), "{name}: {:?}", made.not_cut);
    assert!(!made.discs.is_empty() && made.layout.too_large.is_empty(), "{name}");
    let found = assembled(&delivered(made));
    println!("{name}: {found:?}");
    assert_eq!(found.plates, made.parts.len(), "{name}");
    let ends = 2 * (made.parts.len() - made.discs.len());
    assert_eq!(found.tenons, ends, "{name}: a disc at each end of each fin");
    assert!(found.overlap.0 < 1e-9, "{name}: {:?}", found.overlap);
    // Between tenon and slot there is the clearance, and nothing else.
    assert!(found.filled > 0.85 && found.filled < 1.0, "{name}: {}", found.filled);
}

/// A free-form surface on which no offset is exact.
fn free_form() -> Mesh {
    let mut mesh = revolution(4, 3);
    for [x, y, z] in &mut mesh.positions {
        *z += 0.02 * shape_up::math::sine(0.4 * *x * *y);
        *x += 0.01 * shape_up::math::sine(0.3 * *z);
    }
    mesh
}

#[test]
fn fins_and_discs_of_an_exactly_circular_grid_go_together() {
    for distance in [0.25, -0.2] {
        let own = BuildSettings { distance: Some(distance), ..settings() };
        let made = build(&revolution(3, 5), &own);
        assert!(made.offset.as_ref().unwrap().0.inexact.is_empty());
        assert_fits(&made, "circular grid");
    }
}

#[test]
fn fins_and_discs_of_a_free_form_surface_go_together_although_its_beams_are_warped() {
    let made = build(&free_form(), &settings());
    let (axes, check) = made.offset.as_ref().unwrap();
    assert!(!axes.inexact.is_empty() && check.warp > 1e-5, "{check:?}");
    assert_fits(&made, "free form");
}

#[test]
fn fins_and_discs_of_a_new_dome_go_together() {
    let kind = NewKind::of("dome").unwrap();
    let mut sizes = kind.defaults();
    // Panels around and rows.
    (sizes[3], sizes[4]) = (12.0, 3.0);
    let mesh = kind.mesh(&sizes).unwrap();
    let own = BuildSettings { kind: Some(OffsetKind::Corner), ..settings() };
    let made = Build::new(&mesh, &own, metres(), &Stand::default()).unwrap();
    assert_fits(&made, "dome");
}

#[test]
fn a_slot_that_is_turned_or_too_narrow_is_found() {
    let made = build(&revolution(3, 2), &settings());
    let right = delivered(&made);
    let name = right.tables["discs.csv"][0]["name"].clone();
    let spoilt = |change: &dyn Fn(&BTreeMap<String, String>, Point) -> Point| {
        let mut own = right.clone();
        let row = right.tables["discs.csv"][0].clone();
        let slot = &mut own.sheets.slots.get_mut(&name).unwrap()[0];
        slot.iter_mut().for_each(|point| *point = change(&row, *point));
        assembled(&own)
    };
    assert!(spoilt(&|_, point| point).overlap.0 < 1e-9);
    let (s, c) = libm::sincos(2.0_f64.to_radians());
    let turned = spoilt(&|row, [x, y]| {
        let [u, v] = ["x_sheet_mm", "y_sheet_mm"].map(|column| number(row, column));
        let [x, y] = [x - u, y - v];
        [u + c * x - s * y, v + s * x + c * y]
    });
    assert!(turned.overlap.0 > 1e-6, "{turned:?}");
    // A play of -0.05 mm instead of 0.1 mm on each side.
    let mut own = right.clone();
    let slot = &mut own.sheets.slots.get_mut(&name).unwrap()[0];
    *slot = shape_up::fabricate::panel::inset(slot, 0.15).unwrap();
    let narrow = assembled(&own);
    assert!(narrow.overlap.0 > 1e-6, "{narrow:?}");
}
