//! Resolves a selector to the vertices of each of its constraints.

use super::select::MOST_MEMBERS;
use super::{Element, SelectError, Selector, Sets};
use crate::math::marked;
use crate::mesh::{Mesh, Ragged, Topology, corners, edge_lines, hinges, repeated, stars, strips};

/// Returns one row of distinct vertices for each constraint of a selector.
///
/// | selected | rows | vertices of a row |
/// |---|---|---|
/// | faces, tets | in the order of the mesh | as its corners |
/// | edges | in the order of [`Topology::edges`] | the smaller index first |
/// | rings | one per vertex | the vertex, then ring by ring, each ring ascending |
/// | curves | polylines, then edge lines; without those that run along another, see [`repeated`] | along the curve |
/// | polylines | in the order of the file | along the polyline |
/// | edge lines | as [`edge_lines`] | along the line |
/// | boundary | as [`Topology::boundary_loops`] | along the loop |
/// | strips | as [`strips`] | along the strip, side by side |
/// | corners | face by face | before, corner, after |
/// | stars | one per interior vertex | the vertex, then its neighbours around it |
/// | hinges | in the order of [`Topology::edges`] | the ends, then the opposite corners |
/// | groups, sets | groups in the order of the mesh; a set is one row | vertices as listed, then those of faces, then those of curves |
/// | vertices | one row | as listed |
///
/// A name stands for a set or, if there is none, for all groups of that name. `within` keeps the
/// faces that it lists, if it lists any, and likewise the curves of the file; rings whose centre is
/// in it; and any other element all of whose vertices are in it, including those of its faces and
/// curves. Then `radius` adds rings of neighbours to each remaining element, each ring ascending.
///
/// # Errors
/// If a name is unknown, an index is out of range, or the rows have too many vertices to solve for.
pub fn resolve(
    selector: &Selector,
    mesh: &Mesh,
    topology: &Topology,
    sets: &Sets,
) -> Result<Ragged, SelectError> {
    let mut rows = Rows { seen: vec![0; mesh.positions.len()], round: 0, rows: Ragged::new() };
    match selector {
        Selector::Vertices(vertices) => {
            rows.push(&Members::of_vertices(vertices, mesh)?.vertices);
        }
        Selector::Set(name) => rows.push(&Members::named(name, mesh, sets)?.vertices),
        Selector::Each { element, within, radius } => {
            let within =
                within.as_ref().map(|name| Members::named(name, mesh, sets)).transpose()?;
            let kept = within.as_ref().map(|members| Kept::new(members, mesh));
            let keeps = |origin: Origin, vertices: &[u32]| {
                kept.as_ref().is_none_or(|kept| kept.keeps(origin, vertices))
            };
            let mut push = |origin: Origin, vertices: &[u32]| {
                if keeps(origin, vertices) && rows.rows.indices().len() <= MOST_MEMBERS {
                    let own = rows.distinct(vertices);
                    rows.rows.push(&topology.grow(&own, *radius));
                }
            };
            match element {
                Element::Face => each(&mesh.faces, |f, face| push(Origin::Face(f), face)),
                Element::Edge => topology.edges().iter().for_each(|ends| push(Origin::Other, ends)),
                Element::Ring => {
                    (0..mesh.positions.len() as u32).for_each(|v| push(Origin::Other, &[v]));
                }
                Element::Tet => mesh.tets.iter().for_each(|tet| push(Origin::Other, tet)),
                Element::Curve => {
                    let lines = edge_lines(topology);
                    // Curves outside the set do not count as repeated.
                    let kept = |origin, row| if keeps(origin, row) { row } else { &[][..] };
                    let polylines = (0..)
                        .zip(mesh.curves.iter())
                        .map(|(c, curve)| kept(Origin::Curve(c), curve));
                    let kept_lines = lines.iter().map(|line| kept(Origin::Other, line));
                    let found = repeated(&polylines.collect(), &kept_lines.collect(), topology);
                    each(&mesh.curves, |c, curve| {
                        if !found.polylines[c] {
                            push(Origin::Curve(c), curve);
                        }
                    });
                    each(&lines, |k, line| {
                        if !found.lines[k] {
                            push(Origin::Other, line);
                        }
                    });
                }
                Element::Polyline => each(&mesh.curves, |c, curve| push(Origin::Curve(c), curve)),
                Element::EdgeLine => {
                    each(&edge_lines(topology), |_, line| push(Origin::Other, line));
                }
                Element::Boundary => {
                    each(topology.boundary_loops(), |_, one| {
                        push(Origin::Other, one);
                    });
                }
                Element::Strip => {
                    each(&strips(mesh, topology), |_, strip| push(Origin::Other, strip));
                }
                Element::Corner => {
                    corners(mesh).for_each(|(f, corner)| push(Origin::Face(f), &corner));
                }
                Element::Star => {
                    stars(mesh, topology).iter().for_each(|star| push(Origin::Other, star));
                }
                Element::Hinge => {
                    hinges(mesh, topology).iter().for_each(|hinge| push(Origin::Other, hinge));
                }
                Element::Group => {
                    for group in &mesh.groups {
                        let members = Members::new(&[], &group.faces, &group.curves, mesh)?;
                        push(Origin::Other, &members.vertices);
                    }
                }
            }
        }
    }
    if rows.rows.indices().len() > MOST_MEMBERS {
        return Err(SelectError::TooMany);
    }
    Ok(rows.rows)
}

fn each(rows: &Ragged, mut visit: impl FnMut(usize, &[u32])) {
    rows.iter().enumerate().for_each(|(i, row)| visit(i, row));
}

/// Collects rows of distinct vertices.
struct Rows {
    /// The last round (row) in which each vertex occurred.
    seen: Vec<u32>,
    round: u32,
    rows: Ragged,
}

impl Rows {
    /// Returns the vertices without repetitions, in the order of their first occurrence.
    fn distinct(&mut self, vertices: &[u32]) -> Vec<u32> {
        self.round += 1;
        let mut distinct = vertices.to_vec();
        distinct
            .retain(|&v| std::mem::replace(&mut self.seen[v as usize], self.round) != self.round);
        distinct
    }

    fn push(&mut self, vertices: &[u32]) {
        let distinct = self.distinct(vertices);
        self.rows.push(&distinct);
    }
}

/// The origin of an element, if sets and groups can list it by its index.
#[derive(Clone, Copy)]
enum Origin {
    Face(usize),
    Curve(usize),
    Other,
}

/// The members of a set or group.
struct Members {
    /// Listed vertices, then those of the faces, then those of the curves; may repeat.
    vertices: Vec<u32>,
    faces: Vec<u32>,
    curves: Vec<u32>,
}

impl Members {
    fn named(name: &str, mesh: &Mesh, sets: &Sets) -> Result<Members, SelectError> {
        if let Some(set) = sets.get(name) {
            return Members::new(&set.vertices, &set.faces, &[], mesh);
        }
        let groups: Vec<_> = mesh.groups.iter().filter(|group| group.name == name).collect();
        if groups.is_empty() {
            return Err(SelectError::UnknownSet(name.to_string()));
        }
        let faces: Vec<u32> = groups.iter().flat_map(|group| &group.faces).copied().collect();
        let curves: Vec<u32> = groups.iter().flat_map(|group| &group.curves).copied().collect();
        Members::new(&[], &faces, &curves, mesh)
    }

    fn of_vertices(vertices: &[u32], mesh: &Mesh) -> Result<Members, SelectError> {
        Members::new(vertices, &[], &[], mesh)
    }

    fn new(
        vertices: &[u32],
        faces: &[u32],
        curves: &[u32],
        mesh: &Mesh,
    ) -> Result<Members, SelectError> {
        if let Some(&v) = vertices.iter().find(|&&v| v as usize >= mesh.positions.len()) {
            return Err(SelectError::VertexOutOfRange(v));
        }
        if let Some(&f) = faces.iter().find(|&&f| f as usize >= mesh.faces.len()) {
            return Err(SelectError::FaceOutOfRange(f));
        }
        let mut all = vertices.to_vec();
        faces.iter().for_each(|&f| all.extend_from_slice(mesh.faces.row(f as usize)));
        curves.iter().for_each(|&c| all.extend_from_slice(mesh.curves.row(c as usize)));
        Ok(Members { vertices: all, faces: faces.to_vec(), curves: curves.to_vec() })
    }
}

/// The elements that `within` keeps.
struct Kept {
    /// `#V`.
    vertices: Vec<bool>,
    /// `#F`; none if no face is listed.
    faces: Option<Vec<bool>>,
    /// `#curves`; none if no curve is listed.
    curves: Option<Vec<bool>>,
}

impl Kept {
    fn new(members: &Members, mesh: &Mesh) -> Kept {
        let if_listed = |n, listed: &[u32]| (!listed.is_empty()).then(|| marked(n, listed));
        Kept {
            vertices: marked(mesh.positions.len(), &members.vertices),
            faces: if_listed(mesh.faces.len(), &members.faces),
            curves: if_listed(mesh.curves.len(), &members.curves),
        }
    }

    fn keeps(&self, origin: Origin, vertices: &[u32]) -> bool {
        match (origin, &self.faces, &self.curves) {
            (Origin::Face(f), Some(faces), _) => faces[f],
            (Origin::Curve(c), _, Some(curves)) => curves[c],
            _ => vertices.iter().all(|&v| self.vertices[v as usize]),
        }
    }
}
