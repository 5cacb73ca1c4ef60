//! Facets: flat polygons in mm. A flat panel is one facet; other panels are creased into triangles,
//! which preserves all lengths. Facets are connected by joints, which are folded or glued.

use crate::fabricate::panel::{
    FlatPanel, check_size, distinct_corners, is_simple, triangles, turn,
};
use crate::fabricate::surface::{PanelSurface, unit};
use crate::math::plane::Point2;
use crate::math::{Vec3, polygon_sides};
use std::collections::BTreeMap;

/// Panels are creased if laying them flat would change a distance between corners by more, in mm on
/// the sheet.
const FLAT: f64 = 0.02;

/// Area of a triangle that is due to rounding, relative to the square of its sides.
const ROUNDING: f64 = 1e-9;

/// A flat facet of a panel.
#[derive(Clone, Debug)]
pub struct Facet {
    /// Its panel.
    pub panel: u32,
    /// Its corners in mm, counterclockwise seen from outside.
    pub corners: Vec<Point2>,
    /// For each side the part of its line between the ends of the edge: where the facet beyond it hinges.
    /// The side itself, unless the facet is cut back.
    pub hinges: Vec<[Point2; 2]>,
    /// The vertices of its corners.
    pub vertices: Vec<u32>,
    /// For each side, from its corner to the next one: the side of the panel; none for a crease.
    pub panel_sides: Vec<Option<u32>>,
    /// The joint of each side; none at the rim.
    pub joints: Vec<Option<u32>>,
    /// How far before the edge of each side its inner face ends, in mm.
    pub backs: Vec<f64>,
    /// The same area as convex polygons.
    pub convex: Vec<Vec<Point2>>,
    /// Its normal, outwards.
    normal: Vec3<f64>,
}

/// A facet, and the number of one of its sides.
pub type FacetSide = (u32, u32);

/// The joint between two facets.
#[derive(Clone, Copy, Debug)]
pub struct Joint {
    /// The two facets, each with its side.
    pub sides: [FacetSide; 2],
    /// The fold angle in radians, positive for a ridge seen from outside.
    pub fold: f64,
    /// The edge of the surface; none for a crease.
    pub edge: Option<u32>,
    /// How far before the edge the inner faces of both facets end as the fold asks, in mm; 0 on creased
    /// paper.
    pub back: f64,
    /// Whether its facets can hang together there: not along a seam, nor where card is cut back unevenly.
    pub is_hinge: bool,
}

/// What a fold becomes, seen from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FoldKind {
    /// Folded backwards.
    Ridge,
    /// Folded forwards.
    Valley,
    /// Neither: the panels are coplanar.
    Flat,
}

impl FoldKind {
    /// What a fold angle in radians becomes.
    pub(super) fn of(fold: f64) -> FoldKind {
        /// Largest angle, in radians, of panels that count as coplanar.
        const FLAT: f64 = 1e-3;
        if fold.abs() <= FLAT {
            FoldKind::Flat
        } else if fold > 0.0 {
            FoldKind::Ridge
        } else {
            FoldKind::Valley
        }
    }

    /// Its word in tables.
    pub fn word(self) -> &'static str {
        match self {
            FoldKind::Ridge => "ridge",
            FoldKind::Valley => "valley",
            FoldKind::Flat => "flat",
        }
    }
}

impl Joint {
    /// What its fold becomes.
    pub fn kind(&self) -> FoldKind {
        FoldKind::of(self.fold)
    }
}

/// The facets of panels and their joints, and the panels without facets with the reason; `model` is
/// in mm per unit of the mesh.
pub(super) fn facets(
    surface: &PanelSurface,
    flat: &[Option<FlatPanel>],
    model: f64,
) -> (Vec<Facet>, Vec<Joint>, Vec<(u32, &'static str)>) {
    let (mut facets, mut joints, mut without) = (Vec::new(), Vec::new(), Vec::new());
    for (panel, f) in flat.iter().zip(0..) {
        let first = facets.len();
        let panel = match surface.has_holes(f) {
            true => Err("it has a hole, and only panels that are cut singly have holes"),
            false => panel.as_ref().ok_or("it has no area"),
        };
        match panel.and_then(|panel| usable(panel, model)) {
            Err(why) => without.push((f, why)),
            Ok(panel) if panel.flattening_error * model <= FLAT => {
                facets.push(whole(surface, f, panel, model));
            }
            Ok(panel) => creased(&mut facets, surface, f, panel, model),
        }
        for sides in creases(&facets, first) {
            add(&mut facets, &mut joints, surface, sides, None);
        }
    }
    // The panel, the facet and its side at each edge.
    let mut at_edges = vec![Vec::new(); surface.edges.len()];
    for (f, facet) in facets.iter().enumerate() {
        let sides = surface.sides.row(facet.panel as usize);
        for (k, side) in facet.panel_sides.iter().enumerate() {
            if let Some(side) = side {
                at_edges[sides[*side as usize] as usize].push((facet.panel, (f, k)));
            }
        }
    }
    for (edge, e) in surface.edges.iter().zip(0..) {
        let [Some(left), Some(right)] = edge.panels else { continue };
        if left == right || surface.length(edge) == 0.0 {
            continue;
        }
        let side = |panel: u32| {
            let own = at_edges[e as usize].iter().find(|(own, _)| *own == panel);
            own.map(|(_, side)| *side)
        };
        if let (Some(a), Some(b)) = (side(left), side(right)) {
            add(&mut facets, &mut joints, surface, [a, b], Some(e));
        }
    }
    (facets, joints, without)
}

/// The panel, if it can be folded.
///
/// # Errors
/// If it cannot, in words.
fn usable(panel: &FlatPanel, model: f64) -> Result<&FlatPanel, &'static str> {
    check_size(&scaled(panel, model))?;
    match is_simple(&distinct_corners(&panel.corners)) {
        true => Ok(panel),
        false => Err("laid flat it crosses itself"),
    }
}

/// The corners of a panel in mm.
fn scaled(panel: &FlatPanel, model: f64) -> Vec<Point2> {
    panel.corners.iter().map(|corner| corner.map(|x| x * model)).collect()
}

impl Facet {
    fn new(
        panel: u32,
        corners: Vec<Point2>,
        vertices: Vec<u32>,
        panel_sides: Vec<Option<u32>>,
        normal: Vec3<f64>,
    ) -> Facet {
        let (hinges, joints) = (polygon_sides(&corners).collect(), vec![None; corners.len()]);
        let backs = vec![0.0; corners.len()];
        let (convex, none) = (Vec::new(), Vec::new());
        let mut facet = Facet {
            panel,
            corners: none,
            hinges,
            vertices,
            panel_sides,
            joints,
            backs,
            convex,
            normal,
        };
        facet.set_corners(corners);
        facet
    }

    /// Gives it other corners.
    pub(super) fn set_corners(&mut self, corners: Vec<Point2>) {
        let n = corners.len();
        let is_convex =
            (0..n).all(|k| turn(corners[k], corners[(k + 1) % n], corners[(k + 2) % n]) >= 0.0);
        self.convex = match is_convex {
            true => vec![corners.clone()],
            false => {
                let corners = distinct_corners(&corners);
                triangles(&corners).into_iter().map(|own| own.map(|k| corners[k]).into()).collect()
            }
        };
        self.corners = corners;
    }
}

fn whole(surface: &PanelSurface, f: u32, panel: &FlatPanel, model: f64) -> Facet {
    let vertices = surface.faces.row(f as usize).to_vec();
    let sides = (0..vertices.len() as u32).map(Some).collect();
    Facet::new(f, scaled(panel, model), vertices, sides, surface.normal(f))
}

fn creased(facets: &mut Vec<Facet>, surface: &PanelSurface, f: u32, panel: &FlatPanel, model: f64) {
    let face = surface.faces.row(f as usize);
    // Of coincident corners only the last one, which its side of the panel starts from.
    let n = face.len();
    let at = |k: usize| surface.at(face[k % n]);
    let kept: Vec<usize> = (0..n).filter(|&k| at(k) != at(k + 1)).collect();
    let corners: Vec<Point2> = kept.iter().map(|&k| panel.corners[k]).collect();
    for own in triangles(&corners) {
        let at = own.map(|k| surface.at(face[kept[k]]));
        let (b, c) = (at[1] - at[0], at[2] - at[0]);
        let (length, along) = (b.length(), unit(b));
        let across = c - along * c.dot(along);
        // A triangle whose area is due to rounding cannot be folded: its normal is random.
        let (twice_area, longest) = (b.cross(c), length.max(c.length()));
        if twice_area.length() <= ROUNDING * longest * longest {
            continue;
        }
        let normal = unit(twice_area);
        let corners: Vec<Point2> = vec![
            [0.0, 0.0],
            [length * model, 0.0],
            [c.dot(along) * model, across.length() * model],
        ];
        let side = |k: usize| {
            let (from, to) = (own[k], own[(k + 1) % 3]);
            ((from + 1) % kept.len() == to).then_some(kept[from] as u32)
        };
        let (vertices, sides) = (own.map(|k| face[kept[k]]).into(), (0..3).map(side).collect());
        facets.push(Facet::new(f, corners, vertices, sides, normal));
    }
}

/// The common sides of the facets of a panel, of which `first` is the first and the last of all is the
/// last: each facet and its side, sorted by the second facet, then the first.
fn creases(facets: &[Facet], first: usize) -> Vec<[(usize, usize); 2]> {
    let mut known: BTreeMap<[u32; 2], (usize, usize)> = BTreeMap::new();
    let mut found = Vec::new();
    for (f, facet) in facets.iter().enumerate().skip(first) {
        let sides = polygon_sides(&facet.vertices).zip(&facet.panel_sides).enumerate();
        for (k, ([p, q], _)) in sides.filter(|(_, (_, side))| side.is_none()) {
            found.extend(known.get(&[q, p]).map(|&other| [other, (f, k)]));
            known.insert([p, q], (f, k));
        }
    }
    found.sort_unstable_by_key(|&[(a, _), (b, _)]| (b, a));
    found
}

fn add(
    facets: &mut [Facet],
    joints: &mut Vec<Joint>,
    surface: &PanelSurface,
    sides: [(usize, usize); 2],
    edge: Option<u32>,
) {
    let number = joints.len() as u32;
    for (f, k) in sides {
        facets[f].joints[k] = Some(number);
    }
    let sides = sides.map(|(f, k)| (f as u32, k as u32));
    let fold = fold(surface, facets, sides);
    joints.push(Joint { sides, fold, edge, back: 0.0, is_hinge: true });
}

fn fold(surface: &PanelSurface, facets: &[Facet], [(f, k), (g, _)]: [FacetSide; 2]) -> f64 {
    let (own, other) = (&facets[f as usize], &facets[g as usize]);
    let k = k as usize;
    let next = own.vertices[(k + 1) % own.vertices.len()];
    let t = unit(surface.at(next) - surface.at(own.vertices[k]));
    libm::atan2(t.dot(own.normal.cross(other.normal)), own.normal.dot(other.normal))
}
