//! What `edges.csv` says about panels, and putting panels together in space.

use super::files::Files;
use shape_up::math::plane::{Point2, distance};
use shape_up::math::{Alignment, Vec3, centre};
use shape_up::mesh::Mesh;
use std::collections::BTreeMap;

/// A point or a vector in space.
pub(super) type Point = Vec3<f64>;

/// A side of a panel, on the way around it, counterclockwise seen from outside.
#[derive(Clone, Debug)]
pub(super) struct Side {
    pub(super) from: String,
    pub(super) to: String,
    /// The panel beyond it; empty at the rim.
    pub(super) beyond: String,
    /// Its length in mm of the building.
    pub(super) length: f64,
    /// The fold in degrees, positive for a ridge.
    pub(super) fold: f64,
}

/// The sides of all panels, in order.
pub(super) fn sides_of_panels(files: &Files) -> BTreeMap<String, Vec<Side>> {
    let mut found: BTreeMap<String, Vec<Side>> = BTreeMap::new();
    for row in files.table("edges.csv").rows() {
        let (length, fold) = (row.number("length_mm"), row.text("fold_deg").parse().unwrap_or(0.0));
        let [a, b] = ["node_a", "node_b"].map(|column| row.text(column).to_owned());
        let [left, right] = ["panel_left", "panel_right"].map(|column| row.text(column).to_owned());
        for (own, from, to, beyond) in [(&left, &a, &b, &right), (&right, &b, &a, &left)] {
            if !own.is_empty() {
                let (from, to, beyond) = (from.clone(), to.clone(), beyond.clone());
                found.entry(own.clone()).or_default().push(Side { from, to, beyond, length, fold });
            }
        }
    }
    for sides in found.values_mut() {
        for k in 1..sides.len() {
            let next = sides.iter().position(|side| side.from == sides[k - 1].to).unwrap();
            sides.swap(k, next);
        }
    }
    found
}

/// The ways to lay the sides of a panel along those of an outline, as rotations of the list, so that each
/// side has the length in mm of the building that is measured, and leads to the panel that is written
/// there.
pub(super) fn matching(
    sides: &[Side],
    outline: &[(f64, Option<String>)],
    tolerance: f64,
) -> Vec<usize> {
    let n = sides.len();
    assert_eq!(n, outline.len(), "{sides:?} has other sides on the sheet");
    let fits = |shift: &usize| {
        outline.iter().enumerate().all(|(k, (length, written))| {
            let own = &sides[(k + shift) % n];
            (own.length - length).abs() < tolerance
                && written.as_ref().is_none_or(|written| own.beyond == *written)
        })
    };
    (0..n).filter(fits).collect()
}

/// A panel laid flat, with the names of its corners.
pub(super) struct Flat {
    /// Its corners in mm of the building, counterclockwise seen from outside.
    pub(super) corners: Vec<Point2>,
    /// Its sides; the first begins at the first corner.
    pub(super) sides: Vec<Side>,
    /// Whether it is joined to the panel beyond each side, by a fold or by glue.
    pub(super) is_joined: Vec<bool>,
}

/// The nodes of a shape, where the first part that has them puts them.
#[derive(Default)]
pub(super) struct Found {
    pub(super) nodes: BTreeMap<String, Point>,
    /// The largest distance in mm at which two parts disagree about a node.
    pub(super) gap: f64,
}

impl Found {
    pub(super) fn put(&mut self, node: &str, at: Point) {
        let before = *self.nodes.entry(node.to_owned()).or_insert(at);
        self.gap = self.gap.max((before - at).length());
    }

    /// The nodes, rigidly moved to where `nodes.csv` has them.
    pub(super) fn in_place(&self, files: &Files) -> BTreeMap<String, Point> {
        let known = files.nodes();
        let mut there: Vec<Point> = self.nodes.keys().map(|name| known[name]).collect();
        let mut own: Vec<Point> = self.nodes.values().copied().collect();
        let middle = centre(&mut there);
        centre(&mut own);
        let turned = Alignment::robust(&own, &there);
        let names = self.nodes.keys().cloned();
        names.zip(own.into_iter().map(|at| turned.turn(at) + middle)).collect()
    }

    /// Checks that parts agree, and that after the best rigid motion all nodes are where the mesh, in
    /// metres, has its vertices.
    pub(super) fn assert_is(mut self, mesh: &Mesh) {
        /// In mm at full size.
        const MOST: f64 = 1.0;
        assert!(self.gap < MOST, "parts are {} mm apart", self.gap);
        let used: std::collections::BTreeSet<u32> = mesh.faces.indices().iter().copied().collect();
        assert_eq!(self.nodes.len(), used.len());
        let vertex = |name: &String| name.strip_prefix('N').unwrap().parse::<usize>().unwrap();
        let at = |name: &String| Vec3::from(mesh.positions[vertex(name)]) * 1000.0;
        let mut rest: Vec<Point> = self.nodes.keys().map(at).collect();
        let mut own: Vec<Point> = self.nodes.values_mut().map(|at| *at).collect();
        centre(&mut rest);
        centre(&mut own);
        let turned = Alignment::robust(&rest, &own);
        let away = rest.iter().zip(&own).map(|(&r, &p)| (turned.turn(r) - p).length());
        let worst = away.fold(0.0, f64::max);
        assert!(worst < MOST, "the surface is missed by {worst} mm");
    }
}

/// Puts panels together, from the first on to all that are joined.
pub(super) fn assembled(panels: &BTreeMap<String, Flat>) -> Found {
    let mut found = Found::default();
    // The first side of each panel in space and its normal.
    let first = panels.keys().next().unwrap();
    let start = [Vec3::zero(), Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 0.0, 1.0)];
    let mut placed: BTreeMap<&str, [Point; 3]> = BTreeMap::from([(&**first, start)]);
    let mut queue = vec![&**first];
    while let Some(name) = queue.pop() {
        let panel = &panels[name];
        let [origin, x, normal] = placed[name];
        let y = normal.cross(x);
        let at = |[u, v]: Point2| origin + x * u + y * v;
        for (k, side) in panel.sides.iter().enumerate() {
            let n = panel.corners.len();
            let [p, q] = [k, (k + 1) % n].map(|k| at(panel.corners[k]));
            found.put(&side.from, p);
            if side.beyond.is_empty() || !panel.is_joined[k] || placed.contains_key(&*side.beyond) {
                continue;
            }
            // Along the side, away from the panel, is turned down by the fold of a ridge.
            let along = (q - p) * (1.0 / (q - p).length());
            let fold = side.fold.to_radians();
            let there = normal * libm::cos(fold) + along.cross(normal) * libm::sin(fold);
            let other = &panels[&side.beyond];
            let i = other.sides.iter().position(|own| own.from == side.to).unwrap();
            let m = other.corners.len();
            let [c, d] = [i, (i + 1) % m].map(|i| other.corners[i]);
            // The side runs from q to p there.
            let size = distance(c, d);
            let [cosine, sine] = [0, 1].map(|k| (d[k] - c[k]) / size);
            let (u, v) = (-along, there.cross(-along));
            let x = u * cosine - v * sine;
            let y = there.cross(x);
            let origin = q - x * c[0] - y * c[1];
            placed.insert(&side.beyond, [origin, x, there]);
            queue.push(&side.beyond);
        }
    }
    assert_eq!(placed.len(), panels.len(), "some panels are joined to none");
    found
}
