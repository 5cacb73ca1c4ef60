//! Dihedral angles, between the normals of two faces with a common edge, normals by which creases are
//! told, and faces that a deformation has folded over.

use crate::math::{Vec3, angle, angle_between, polygon_sides, twice_vector_area};
use crate::mesh::{Mesh, Point, Ragged, Topology};

/// Two faces with a common edge.
pub(super) struct Neighbours {
    pub(super) faces: [u32; 2],
    /// See [`Topology::agreement`].
    sign: f64,
}

impl Neighbours {
    /// Returns the two faces of each edge that has two.
    pub(super) fn all<'a>(topology: &'a Topology) -> impl Iterator<Item = Neighbours> + 'a {
        (0..).zip(topology.edge_faces().iter()).filter_map(|(e, faces)| {
            let &[a, b] = faces else { return None };
            Some(Neighbours { faces: [a, b], sign: topology.agreement(e) })
        })
    }

    /// Returns the cosine of their angle; 0 if a face has no area.
    pub(super) fn cosine(&self, normals: &[Vec3<f64>]) -> f64 {
        let [a, b] = self.faces.map(|face| normals[face as usize]);
        self.sign * a.dot(b)
    }

    /// Returns their angle in radians; none if a face has no area.
    fn angle(&self, normals: &[Vec3<f64>]) -> Option<f64> {
        let [a, b] = self.faces.map(|face| normals[face as usize]);
        angle(self.sign * a.dot(b), a.cross(b).length())
    }
}

/// Returns the unit normal of each face; zero for a face without area.
fn unit_normals(faces: &Ragged, at: &[Point]) -> Vec<Vec3<f64>> {
    let at = |&v: &u32| Vec3::from(at[v as usize]);
    faces.iter().map(|face| twice_vector_area(face.iter().map(at)).direction_or_zero()).collect()
}

/// Returns the mean angle in degrees between the normals of neighbouring faces at the positions
/// `at` (`#V by 3`); 0 if no edge has two faces with an area.
pub fn mean_dihedral_angle(mesh: &Mesh, topology: &Topology, at: &[Point]) -> f64 {
    let normals = unit_normals(&mesh.faces, at);
    let (mut sum, mut count) = (0.0, 0.0);
    for angle in Neighbours::all(topology).filter_map(|pair| pair.angle(&normals)) {
        sum += angle;
        count += 1.0;
    }
    if count > 0.0 { f64::to_degrees(sum / count) } else { 0.0 }
}

/// A triangle of at most this height over its longest side has no normal of its own: rounded coordinates
/// tilt it.
const THIN: f64 = 1e-3;

/// Returns whether each edge is a crease: whether it has two faces whose [normals](crease_normals) turn by
/// more than `degrees`, `#E`.
pub(crate) fn crease_edges(mesh: &Mesh, topology: &Topology, degrees: f64) -> Vec<bool> {
    let normals = crease_normals(mesh, topology);
    let most = degrees.to_radians();
    let mut is_crease = vec![false; topology.edges().len()];
    for (e, faces) in (0..).zip(topology.edge_faces().iter()) {
        if let [f, g] = *faces {
            let other = normals[g as usize] * topology.agreement(e);
            let turn = angle_between(normals[f as usize], other);
            is_crease[e as usize] = turn.is_some_and(|turn| turn > most);
        }
    }
    is_crease
}

/// Returns a normal of each face, not of length one, by which creases are told: twice its vector area, or
/// for a thin triangle that of the face across its longest side. Beside another thin triangle, as in a
/// narrow strip, it keeps its own: a walk over many would leave the surface there.
fn crease_normals(mesh: &Mesh, topology: &Topology) -> Vec<Vec3<f64>> {
    let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
    let areas = mesh.faces.iter().map(|face| twice_vector_area(face.iter().map(|&v| at(v))));
    let areas: Vec<Vec3<f64>> = areas.collect();
    // The edge of the longest side.
    let longest_if_thin = |face: u32| {
        let corners = mesh.faces.row(face as usize);
        let sides = polygon_sides(corners)
            .filter_map(|[a, b]| Some(((at(b) - at(a)).length_squared(), topology.edge(a, b)?)));
        let (length, edge) = sides.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let is_thin = corners.len() == 3 && areas[face as usize].length() <= THIN * length;
        is_thin.then_some(edge)
    };
    let normal = |face: u32| {
        if let Some(edge) = longest_if_thin(face)
            && let &[first, second] = topology.edge_faces().row(edge as usize)
        {
            let across = if first == face { second } else { first };
            if longest_if_thin(across).is_none() {
                return areas[across as usize] * topology.agreement(edge);
            }
        }
        areas[face as usize]
    };
    (0..mesh.faces.len() as u32).map(normal).collect()
}

/// Cosine of the least angle between the normals of two faces folded onto each other: 120 degrees.
const FOLDED: f64 = -0.5;
/// Cosine of the greatest angle between them before: 80 degrees. Sharper edges are intended.
const SMOOTH: f64 = 0.17;
/// Least sine of the turn at a corner, before and after, for a change of its sign to count.
const TURN: f64 = 0.1;

/// Returns the faces, ascending, that are folded over at `now` (`#V by 3`) and not at the positions
/// of the mesh: both faces of an edge whose normals are more than 120 degrees apart, and faces with
/// a corner that turns the other way, so that the outline crosses itself or has a dent.
pub fn folded_faces(mesh: &Mesh, topology: &Topology, now: &[Point]) -> Vec<u32> {
    let [before, after] = [&mesh.positions[..], now].map(|at| unit_normals(&mesh.faces, at));
    let mut is_folded: Vec<bool> = (0..mesh.faces.len())
        .map(|f| {
            let corners = mesh.faces.row(f);
            let turned = |at, normal| turns(corners, at, normal_or_corner(corners, at, normal));
            let pairs = turned(&mesh.positions, before[f]).zip(turned(now, after[f]));
            let mut reversed = pairs.filter(|(was, is)| was * is < 0.0);
            reversed.any(|(was, is)| was.abs() > TURN && is.abs() > TURN)
        })
        .collect();
    for pair in Neighbours::all(topology) {
        if pair.cosine(&before) > SMOOTH && pair.cosine(&after) < FOLDED {
            pair.faces.iter().for_each(|&face| is_folded[face as usize] = true);
        }
    }
    (0..).zip(is_folded).filter(|(_, is_folded)| *is_folded).map(|(face, _)| face).collect()
}

/// The part of the turns of a face that its area is at least; less is rounding error.
const NO_AREA: f64 = 1e-9;

/// Returns the unit normal of a face, or, where its loops cancel out, as in a panel whose sides cross
/// in the middle, that of its largest corner: corners then turn both ways.
fn normal_or_corner(corners: &[u32], at: &[Point], normal: Vec3<f64>) -> Vec3<f64> {
    let place = |&v: &u32| Vec3::from(at[v as usize]);
    let area = twice_vector_area(corners.iter().map(place)).length();
    let n = corners.len();
    let corner = |k: usize| {
        let [before, here, after] = [k + n - 1, k, k + 1].map(|k| place(&corners[k % n]));
        (here - before).cross(after - here)
    };
    let larger = |a: Vec3<f64>, b: Vec3<f64>| if b.length() > a.length() { b } else { a };
    let largest = (0..n).map(corner).fold(Vec3::zero(), larger);
    let length = largest.length();
    if length > 0.0 && area < NO_AREA * length { largest * (1.0 / length) } else { normal }
}

/// Returns the sine of the turn at each corner, positive for a left turn seen from the tip of the
/// normal.
fn turns(corners: &[u32], at: &[Point], normal: Vec3<f64>) -> impl Iterator<Item = f64> {
    let n = corners.len();
    let place = move |k: usize| Vec3::from(at[corners[k % n] as usize]);
    (0..n).map(move |k| {
        let [into, out] = [place(k) - place(k + n - 1), place(k + 1) - place(k)];
        let lengths = into.length() * out.length();
        if lengths > 0.0 { into.cross(out).dot(normal) / lengths } else { 0.0 }
    })
}
