//! A mesh that covers the surface of another one, as an edit of it: where its elements lie on the old
//! ones.

use super::origins::{Combinations, Edited, Origins};
use super::parts_under::parts_under;
use super::rebuild::regrouped;
use crate::math::{Vec3, marked, mean, sort_by_number};
use crate::mesh::topology::oriented_areas;
use crate::mesh::{FaceTriangle, Mesh, Point, Ragged, Surface, Topology, Weld, components};
use std::collections::HashMap;

/// A new vertex whose weight on a corner is at most this does not depend on it.
const NEGLIGIBLE: f64 = 1e-9;
/// Nor does one that is no farther from the opposite side than its coordinates are rounded, in units of the
/// last place: a vertex on a side was computed in a few steps, each of which rounds.
const ROUNDED: f64 = 8.0;
/// Least inner product of the unit normal of an old face with the mean of those at the corners of a new
/// face, for the new one to come from it: not from the other wall of a shell.
const FACING: f64 = -0.5;
/// A vertex lies on all faces that are nearer than this, relative to the size of the mesh.
const ON: f64 = 1e-6;

impl Edited {
    /// Returns `cover`, each connected part of which lies on one part of `mesh` that is connected over
    /// edges, as made from it. A new face comes from [the same one](Mesh::same_faces), else from the face
    /// of that part nearest to its centre, among those whose normal agrees with the faces at its corners;
    /// sets and groups follow that.
    /// Nothing else comes from faces with a vertex whose position is not in the file. Curves stay, and so
    /// do vertices of no face and of faces that are left as they are.
    pub fn covering(mesh: &Mesh, cover: &Mesh) -> Edited {
        let surface = Surface::of_polygons(&mesh.positions, mesh);
        let same = cover.same_faces(mesh);
        // Panels come from none of the faces that stay.
        let staying = same.iter().copied().flatten();
        let is_out = marked(mesh.faces.len(), mesh.faces_left_out(&[]).into_iter().chain(staying));
        // Panels are laid out on faces that are welded if they share no vertices.
        let mut welded = mesh.clone();
        Weld::apply(&mut welded);
        let topology = Topology::new(&welded);
        let old_parts = components(welded.faces.len(), topology.edge_faces().iter());
        let new_parts = components(cover.positions.len(), cover.faces.iter());
        let part_of = |old: u32| (!is_out[old as usize]).then(|| old_parts[old as usize]);
        let others = cover.faces.iter().zip(&same).filter(|(_, same)| same.is_none());
        let mut panels =
            vec![Vec::new(); new_parts.iter().max().map_or(0, |&last| last as usize + 1)];
        others.for_each(|(face, _)| panels[new_parts[face[0] as usize] as usize].push(face));
        let near = ON * mesh.size();
        let under = parts_under(&cover.positions, &panels, &surface, near, part_of);
        let is_under = |v: u32, old: u32| {
            let under = under[new_parts[v as usize] as usize];
            part_of(old).is_some_and(|part| under.is_none_or(|under| part == under))
        };
        let closest = |v: u32, point: Point| {
            let found = surface.closest_triangle_of(point, f64::INFINITY, |old| is_under(v, old));
            found.map(|(triangle, _)| triangle).unwrap_or_default()
        };
        let at_vertices: Vec<FaceTriangle> =
            (0..).zip(&cover.positions).map(|(v, &point)| closest(v, point)).collect();
        let on_faces = cover.positions.iter().zip(&at_vertices);
        let mut vertices: Vec<(Point, Vec<(u32, f64)>)> =
            on_faces.map(|(&point, &triangle)| (point, weights(mesh, triangle, point))).collect();
        for (face, same) in cover.faces.iter().zip(&same) {
            let olds = same.map_or(&[][..], |same| mesh.faces.row(same as usize));
            face.iter().zip(olds).for_each(|(&v, &old)| vertices[v as usize].1 = vec![(old, 1.0)]);
        }
        // Those vertices stay, unless there is a new one at their place.
        let mut stays = vec![true; mesh.positions.len()];
        mesh.faces.indices().iter().for_each(|&v| stays[v as usize] = false);
        let of_others = mesh.curves.indices().iter().chain(mesh.untouched.indices());
        of_others.for_each(|&v| stays[v as usize] = true);
        for (point, terms) in &vertices {
            if let Some(old) = at_old(mesh, *point, terms) {
                stays[old as usize] = false;
            }
        }
        let kept = (0..).zip(&mesh.positions).zip(stays).filter(|(_, stays)| *stays);
        vertices.extend(kept.map(|((old, &point), _)| (point, vec![(old, 1.0)])));
        let olds: Vec<Option<u32>> =
            vertices.iter().map(|(point, terms)| at_old(mesh, *point, terms)).collect();
        let mut order: Vec<usize> = (0..vertices.len()).collect();
        sort_by_number(&mut order, |&v| olds[v].unwrap_or(u32::MAX).into());
        let mut place = vec![0; vertices.len()];
        (0..).zip(&order).for_each(|(new, &v)| place[v] = new);

        let mut made = Mesh { faces: cover.faces.clone(), ..Mesh::default() };
        made.faces.rename(&place);
        let mut now = vec![None; mesh.positions.len()];
        let (mut positions, mut between) = (Combinations::default(), Ragged::new());
        for (new, &v) in (0..).zip(&order) {
            let (point, terms) = &vertices[v];
            if let Some(old) = olds[v] {
                now[old as usize].get_or_insert(new);
            }
            made.positions.push(*point);
            positions.push(terms);
            let mut corners: Vec<u32> = terms.iter().map(|(corner, _)| *corner).collect();
            corners.sort_unstable();
            between.push(&corners);
        }
        let places: Vec<u32> = now.iter().map(|new| new.unwrap_or(u32::MAX)).collect();
        made.curves = mesh.curves.clone();
        made.curves.rename(&places);
        let normals = oriented_areas(&welded.positions, &welded.faces, &topology);
        let normals: Vec<_> = normals.into_iter().map(Vec3::direction_or_zero).collect();
        // The centre of a panel is inside a curved shell, and can be nearer to its other wall, or to another
        // layer.
        let at_centre = |face: &[u32]| {
            let corners = || face.iter().map(|&v| Vec3::from(cover.positions[v as usize]));
            let olds = face.iter().map(|&v| at_vertices[v as usize].face as usize);
            let facing = mean(olds.map(|old| normals[old]));
            let centre = mean(corners());
            let reach = corners().map(|corner| (corner - centre).length()).fold(0.0, f64::max);
            let is_own =
                |old: u32| is_under(face[0], old) && normals[old as usize].dot(facing) >= FACING;
            let found = surface.closest_triangle_of(centre.into(), reach, is_own);
            found.map_or_else(|| closest(face[0], centre.into()), |(triangle, _)| triangle).face
        };
        let origin =
            |(face, same): (&[u32], Option<u32>)| [same.unwrap_or_else(|| at_centre(face))];
        let faces: Ragged = cover.faces.iter().zip(same).map(origin).collect();
        let curves: Vec<Option<u32>> = (0..mesh.curves.len() as u32).map(Some).collect();
        made.groups = regrouped(mesh, &faces, &curves);
        Edited { mesh: made, origins: Origins { vertices: now, positions, between, faces } }
    }
}

impl Mesh {
    /// Returns for each face the face of `other` whose corners have the same positions, to the bit; of
    /// several such faces each is returned once, in their order.
    pub fn same_faces(&self, other: &Mesh) -> Vec<Option<u32>> {
        let corners = |mesh: &Mesh, face: &[u32]| -> Vec<[u64; 3]> {
            face.iter().map(|&v| mesh.positions[v as usize].map(f64::to_bits)).collect()
        };
        let mut there: HashMap<_, Vec<u32>> = HashMap::new();
        for f in (0..other.faces.len()).rev() {
            there.entry(corners(other, other.faces.row(f))).or_default().push(f as u32);
        }
        self.faces.iter().map(|face| there.get_mut(&corners(self, face))?.pop()).collect()
    }
}

/// The old vertex at which a new vertex lies, if there is one.
fn at_old(mesh: &Mesh, point: Point, terms: &[(u32, f64)]) -> Option<u32> {
    match *terms {
        [(old, _)] if mesh.positions[old as usize] == point => Some(old),
        _ => None,
    }
}

/// A point as an affine combination of the corners of a triangle, or of the ends of a side.
fn weights(mesh: &Mesh, triangle: FaceTriangle, point: Point) -> Vec<(u32, f64)> {
    let [a, b, c] = triangle.corners.map(|v| Vec3::from(mesh.positions[v as usize]));
    let (ab, ac, ap) = (b - a, c - a, Vec3::from(point) - a);
    let normal = ab.cross(ac);
    let squared = normal.length_squared();
    let [u, v] = if squared > 0.0 {
        [ap.cross(ac), ab.cross(ap)].map(|part| part.dot(normal) / squared)
    } else {
        [if ab == Vec3::zero() { 0.0 } else { ap.dot(ab) / ab.length_squared() }, 0.0]
    };
    let weights = [1.0 - u - v, u, v];
    let heights = match squared > 0.0 {
        true => [ac - ab, ac, ab].map(|opposite| normal.length() / opposite.length()),
        false => [ab.length(); 3],
    };
    let coordinates = [a, b, c].map(Point::from);
    let largest = coordinates.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    // Of a triangle as small as that, the corner of the greatest weight.
    let greatest = (0..3).max_by(|&i, &j| weights[i].total_cmp(&weights[j]));
    let depends = |&k: &usize| {
        let weight = weights[k].abs();
        Some(k) == greatest
            || (weight > NEGLIGIBLE && weight * heights[k] > ROUNDED * f64::EPSILON * largest)
    };
    let kept: Vec<(u32, f64)> =
        (0..3).filter(depends).map(|k| (triangle.corners[k], weights[k])).collect();
    match kept[..] {
        [(corner, _)] => vec![(corner, 1.0)],
        _ => kept,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{cosine, polygon_sides, sine};
    use crate::mesh::{Group, GroupKeyword};

    /// A square of two triangles, and a cover of it by two quads side by side.
    fn square() -> (Mesh, Mesh) {
        let corner = |x: f64, y: f64| [x, y, 0.0];
        let triangles = Mesh {
            positions: vec![corner(0., 0.), corner(1., 0.), corner(1., 1.), corner(0., 1.)],
            faces: [[0, 1, 2], [0, 2, 3]].iter().collect(),
            groups: vec![Group {
                name: "lower".to_owned(),
                keyword: GroupKeyword::Group,
                faces: vec![0],
                curves: Vec::new(),
            }],
            ..Mesh::default()
        };
        let quads = Mesh {
            positions: vec![
                corner(0.5, 0.),
                corner(0.5, 1.),
                corner(1., 1.),
                corner(1., 0.),
                corner(0., 0.),
                corner(0., 1.),
            ],
            faces: [[4, 0, 1, 5], [0, 3, 2, 1]].iter().collect(),
            ..Mesh::default()
        };
        (triangles, quads)
    }

    #[test]
    fn vertices_at_old_places_keep_their_order_and_the_others_follow_with_the_surface() {
        let (mesh, quads) = square();
        let edited = Edited::covering(&mesh, &quads);
        assert_eq!(edited.origins.vertices, [Some(0), Some(1), Some(2), Some(3)]);
        assert_eq!(edited.mesh.positions[..4], mesh.positions[..]);
        assert_eq!(edited.mesh.faces.row(0), [0, 4, 5, 3]);
        assert_eq!(edited.origins.between.row(4), [0, 1]);
        let lifted: Vec<Point> = mesh.positions.iter().map(|&[x, y, _]| [x, y, x]).collect();
        let moved = edited.in_other_state(&mesh.positions, &lifted);
        assert_eq!(moved[4], [0.5, 0.0, 0.5]);
    }

    #[test]
    fn curves_and_vertices_of_no_face_stay() {
        let (mut mesh, quads) = square();
        mesh.positions.extend([[3.0, 0.0, 0.0], [0.5, 0.5, 0.0]]);
        mesh.curves = [[0, 5, 2]].iter().collect();
        let edited = Edited::covering(&mesh, &quads);
        assert_eq!(edited.mesh.positions[..6], mesh.positions[..]);
        assert_eq!(edited.mesh.curves.row(0), [0, 5, 2]);
        assert_eq!(edited.mesh.positions.len(), 8);
    }

    #[test]
    fn faces_that_are_left_as_they_are_keep_their_corners() {
        let (mut mesh, mut quads) = square();
        // One of them is not a corner of the cover.
        quads.positions[3] = [0.9, 0.0, 0.0];
        mesh.positions.push([3.0, 0.0, 0.0]);
        mesh.untouched = [[1, 4, 2]].iter().collect();
        let mut edited = Edited::covering(&mesh, &quads);
        edited.origins.carry(&mesh, &mut edited.mesh);
        let at = |v: &u32| edited.mesh.positions[*v as usize];
        let corners: Vec<Point> = edited.mesh.untouched.indices().iter().map(at).collect();
        assert_eq!(corners, [[1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [1.0, 1.0, 0.0]]);
    }

    #[test]
    fn a_group_gets_the_faces_whose_centres_are_on_its_own() {
        let (mesh, quads) = square();
        let edited = Edited::covering(&mesh, &quads);
        let groups: Vec<_> = edited.mesh.groups.iter().map(|group| &group.faces[..]).collect();
        assert_eq!(groups, [[1]]);
    }

    fn corners_of(mesh: &Mesh, face: u32) -> FaceTriangle {
        FaceTriangle {
            face,
            corners: mesh.faces.row(face as usize).try_into().expect("a triangle"),
        }
    }

    /// The vertices of a curved eave far from the origin were inside triangles.
    #[test]
    fn a_vertex_on_a_side_is_between_its_ends_at_coordinates_of_a_site() {
        let eave = |k: u32| {
            let x = 0.25 * f64::from(k);
            [7.0e5 + x, 5.33e6 + 0.3 * x + 0.01 * x * x, 300.0 + 0.1 * x]
        };
        let mut mesh = Mesh::default();
        for k in 0..100 {
            let [x, y, z] = eave(k);
            mesh.positions.extend([[x, y, z], [x - 0.06, y + 0.2, z + 0.05]]);
        }
        for k in 0..99 {
            let v = 2 * k;
            mesh.faces.push(&[v, v + 2, v + 3]);
            mesh.faces.push(&[v, v + 3, v + 1]);
        }
        let on_eave = |k: u32| {
            let [start, end] = [eave(k), eave(k + 1)].map(Vec3::from);
            Point::from(start + (end - start) * (0.1 + 0.008 * f64::from(k)))
        };
        for k in 0..99 {
            let point = on_eave(k);
            let triangle = corners_of(&mesh, 2 * k);
            let of: Vec<u32> = weights(&mesh, triangle, point).iter().map(|term| term.0).collect();
            assert_eq!(of, [2 * k, 2 * k + 2]);
        }
    }

    /// It was the farthest one, since its weight is the most negative.
    #[test]
    fn a_vertex_outside_a_triangle_as_small_as_rounding_is_at_a_near_corner() {
        let (far, step) = (1e6, 2_f64.powi(-33));
        let mesh = Mesh {
            positions: vec![[far, 0.0, 0.0], [far + step, 0.0, 0.0], [far, step, 0.0]],
            faces: [[0, 1, 2]].iter().collect(),
            ..Mesh::default()
        };
        let found = weights(&mesh, corners_of(&mesh, 0), [far + 2.0 * step, 2.0 * step, 0.0]);
        assert!(found == [(1, 1.0)] || found == [(2, 1.0)], "{found:?}");
    }

    /// The centre of a panel on the outer wall is nearer to the inner one, or to another layer.
    #[test]
    fn a_panel_on_a_wall_of_a_shell_comes_from_that_wall() {
        [true, false].into_iter().for_each(check_walls);
    }

    fn check_walls(inwards: bool) {
        let mut mesh = Mesh::default();
        let mut wall = |radius: f64, turned: bool| {
            let first = mesh.positions.len() as u32;
            for (j, i) in (0..11).flat_map(|j| (0..11).map(move |i| (j, i))) {
                let [x, y] = [i, j].map(|k: u32| 0.2 * f64::from(k) - 1.0);
                mesh.positions.push([x, y, (radius * radius - x * x - y * y).sqrt()]);
            }
            for (j, i) in (0..10).flat_map(|j| (0..10).map(move |i| (j, i))) {
                let a = first + 11 * j + i;
                match turned {
                    false => mesh.faces.push(&[a, a + 1, a + 12, a + 11]),
                    true => mesh.faces.push(&[a, a + 11, a + 12, a + 1]),
                }
            }
        };
        wall(5.0, false);
        wall(4.9, inwards);
        let corner = |[i, j]: [usize; 2], wall: usize| mesh.positions[121 * wall + 11 * j + i];
        let corners = [[2, 2], [8, 2], [8, 8], [2, 8]];
        let both = [0, 1].map(|wall| corners.map(|at| corner(at, wall)));
        let cover = Mesh {
            positions: both.as_flattened().to_vec(),
            faces: [[0, 1, 2, 3], [4, 7, 6, 5]].iter().collect(),
            ..Mesh::default()
        };
        let surface = Surface::of_polygons(&mesh.positions, &mesh);
        let centre = [0, 1, 2].map(|axis| both[0].iter().map(|p| p[axis]).sum::<f64>() / 4.0);
        assert!(surface.closest_face(centre).is_some_and(|face| face >= 100));
        let edited = Edited::covering(&mesh, &cover);
        let of_walls = edited.origins.faces.indices().iter().map(|face| face / 100);
        assert_eq!(of_walls.collect::<Vec<_>>(), [0, 1]);
    }

    /// A face was looked for among fans: that of a concave one covers the ground of its neighbours.
    #[test]
    fn a_concave_face_has_no_more_ground_than_its_own() {
        // The corner of an L first from which a fan covers its notch, with a square in it.
        let positions = [[2, 1], [1, 1], [1, 2], [0, 2], [0, 0], [2, 0], [2, 2]];
        let group = |name: &str, face: u32| Group {
            name: name.to_owned(),
            keyword: GroupKeyword::Group,
            faces: vec![face],
            curves: Vec::new(),
        };
        let faces: [&[u32]; 2] = [&[0, 1, 2, 3, 4, 5], &[1, 0, 6, 2]];
        for order in [[0, 1], [1, 0]] {
            let mesh = Mesh {
                positions: positions.map(|[x, y]| [f64::from(x), f64::from(y), 0.0]).to_vec(),
                faces: order.map(|f| faces[f as usize]).iter().collect(),
                groups: vec![group("wall", order[0]), group("window", order[1])],
                ..Mesh::default()
            };
            // Panels of the square, and the L as it is: the mean of its corners is in its notch.
            let mut cover = Mesh { positions: mesh.positions.clone(), ..Mesh::default() };
            for [x, y] in [[1.0, 1.0], [1.5, 1.0], [1.0, 1.5], [1.5, 1.5]] {
                let first = cover.positions.len() as u32;
                let corner = |[i, j]: [f64; 2]| [x + 0.5 * i, y + 0.5 * j, 0.0];
                let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(corner);
                cover.positions.extend(corners);
                cover.faces.push(&[first, first + 1, first + 2, first + 3]);
            }
            cover.faces.push(faces[0]);
            let edited = Edited::covering(&mesh, &cover);
            let [wall, window] = order;
            assert_eq!(edited.origins.faces.indices(), [window, window, window, window, wall]);
            let with = |name: &str| {
                let found = edited.mesh.groups.iter().find(|group| group.name == name);
                found.map_or(0, |group| group.faces.len())
            };
            assert_eq!([with("wall"), with("window")], [1, 4]);
        }
    }

    /// Corners of a concave face were inside a triangle of its fan.
    #[test]
    fn corners_and_sides_of_a_concave_face_stay_such() {
        let round = |k: u32| {
            let turn = 0.25 * f64::from(k) / 9.0;
            [2.0 - 2.0 * cosine(turn), 0.5 - 0.5 * sine(turn), 0.0]
        };
        let mut mesh = Mesh {
            positions: vec![[2.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 2.0, 0.0]],
            ..Mesh::default()
        };
        mesh.positions.extend((0..10).map(round));
        let outline: Vec<u32> = (0..14).collect();
        mesh.faces.push(&outline);
        let mut cover = Mesh { positions: mesh.positions.clone(), ..Mesh::default() };
        let mut corners = Vec::new();
        for [a, b] in polygon_sides(&outline) {
            let ends = [a, b].map(|v| Vec3::from(mesh.positions[v as usize]));
            corners.extend([a, cover.positions.len() as u32]);
            cover.positions.push(mean(ends).into());
        }
        cover.faces.push(&corners);
        let Origins { vertices, between, .. } = Edited::covering(&mesh, &cover).origins;
        assert!((0..14).map(Some).eq(vertices), "each corner is itself");
        for (k, [a, b]) in polygon_sides(&outline).enumerate() {
            assert_eq!(between.row(14 + k), [a.min(b), a.max(b)]);
        }
    }

    /// Those of the second one came from the first one.
    #[test]
    fn vertices_at_a_seam_that_is_not_joined_come_from_their_own_patch() {
        // Patches side by side, with rows of faces to 1 and 2; panels with rows to 0.5 and 2.
        let patches = |rows: [f64; 3]| {
            let mut mesh = Mesh::default();
            for k in 0..3_u32 {
                let ends = [k, k + 1].map(f64::from);
                mesh.positions.extend(rows.iter().flat_map(|&y| ends.map(|x| [x, y, 0.0])));
                let first = 6 * k;
                for a in [first, first + 2] {
                    mesh.faces.push(&[a, a + 1, a + 3, a + 2]);
                }
            }
            mesh
        };
        let edited = Edited::covering(&patches([0.0, 1.0, 2.0]), &patches([0.0, 0.5, 2.0]));
        let Origins { vertices, between, .. } = edited.origins;
        let stay = (0..18).filter(|&v: &usize| vertices[v].is_some());
        assert!(stay.eq((0..18).filter(|v| ![2, 3].contains(&(v % 6)))), "{vertices:?}");
        let sides: Vec<&[u32]> = between.iter().filter(|olds| olds.len() > 1).collect();
        assert_eq!(sides, [[0, 2], [1, 3], [6, 8], [7, 9], [12, 14], [13, 15]]);
    }
}
