//! Operations on meshes: counts, Euler number, orientation, areas, origins of the new elements.

use crate::mesh::subdivide::{boundary_edges, cube, euler, most_alike, most_faces};
use crate::support::grid::grid;
use crate::support::{meshes, shared};
use proptest::prelude::*;
use shape_up::mesh::{
    Edited, MESH_OPERATIONS, Mesh, MeshOperation, OperationError, Point, Scheme, Size, SizeOf,
    Subdivision, Task, Topology, read,
};

/// Selected elements for an operation.
#[derive(Clone, Debug, Default)]
pub(crate) struct Picked {
    vertices: Vec<u32>,
    faces: Vec<u32>,
}

pub(crate) fn apply(
    mesh: &Mesh,
    id: &str,
    sizes: Option<&[f64]>,
    picked: &Picked,
) -> Result<Edited, OperationError> {
    let operation = MeshOperation::of(id)?;
    let defaults: Vec<f64> = operation.sizes.iter().map(|size| size.default).collect();
    let topology = Topology::new(mesh);
    operation.apply(&Task {
        mesh,
        rest: &mesh.positions,
        topology: &topology,
        up: [0.0, 0.0, 1.0],
        sizes: sizes.unwrap_or(&defaults),
        vertices: &picked.vertices,
        faces: &picked.faces,
    })
}

pub(crate) fn done(mesh: &Mesh, id: &str) -> Edited {
    apply(mesh, id, None, &Picked::default()).unwrap()
}

pub(crate) fn with_vertices(vertices: &[u32]) -> Picked {
    Picked { vertices: vertices.to_vec(), ..Picked::default() }
}

/// Area of the surface, as the sum over the triangle fan at the first corner of each face.
pub(crate) fn area(mesh: &Mesh) -> f64 {
    let at = |v: u32| mesh.positions[v as usize];
    let twice = |[a, b, c]: [Point; 3]| {
        let [p, q] = [b, c].map(|x: Point| -> Point { std::array::from_fn(|i| x[i] - a[i]) });
        let n = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        n.iter().map(|x| x * x).sum::<f64>().sqrt()
    };
    let fans =
        mesh.faces.iter().flat_map(|face| face.windows(2).skip(1).map(|w| [face[0], w[0], w[1]]));
    fans.map(|fan| 0.5 * twice(fan.map(at))).sum()
}

/// Checks that hold for every operation on every mesh.
fn check(mesh: &Mesh, id: &str, picked: &Picked) {
    let Ok(Edited { mesh: edited, origins }) = apply(mesh, id, None, picked) else { return };
    assert!(edited.positions.as_flattened().iter().all(|x| x.is_finite()), "{id}");
    assert!(edited.faces.iter().all(|face| face.len() > 2), "{id}");
    let twice = |face: &[u32]| (1..face.len()).any(|k| face[..k].contains(&face[k]));
    assert!(!edited.faces.iter().any(twice), "{id} makes a face with a corner twice");
    assert_eq!(origins.vertices.len(), mesh.positions.len());
    assert_eq!(origins.positions.rows().len(), edited.positions.len());
    assert_eq!(origins.between.len(), edited.positions.len());
    assert_eq!(origins.faces.len(), edited.faces.len());
    for row in origins.positions.rows() {
        let sum: f64 = row.iter().map(|(_, weight)| weight).sum();
        assert!((sum - 1.0).abs() < 1e-12, "{id}: an affine combination: {sum}");
    }
    // Vertices that are kept come first, in their order.
    let left: std::collections::BTreeSet<u32> =
        origins.vertices.iter().flatten().copied().collect();
    assert!((0..left.len() as u32).eq(left.iter().copied()), "{id}: {left:?}");
    let after = Topology::new(&edited);
    let keeps_shape =
        ["quads", "triangles", "diagonal", "insert-strip", "split-face", "flip", "unify", "snap"];
    if keeps_shape.contains(&id) {
        assert_eq!(euler(&edited, &after), euler(mesh, &Topology::new(mesh)), "{id}");
    }
    let is_manifold = most_faces(&Topology::new(mesh)) <= 2 && most_alike(mesh) == 1;
    if is_manifold && !["weld", "join", "merge-vertices", "remove-strip", "fill"].contains(&id) {
        assert!(most_faces(&after) <= 2, "{id}");
        assert_eq!(most_alike(&edited), 1, "{id}: faces run as they did");
    }
    // In the state that it was made from, the result is unchanged.
    assert_eq!(
        Edited { mesh: edited.clone(), origins }.in_other_state(&mesh.positions, &mesh.positions),
        edited.positions
    );
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(64))]

    #[test]
    fn counts_orientation_and_origins_are_right(
        mesh in meshes::mixed(),
        vertices in prop::collection::vec(any::<prop::sample::Index>(), 0..5),
        faces in prop::collection::vec(any::<prop::sample::Index>(), 0..5),
    ) {
        prop_assume!(!mesh.faces.is_empty());
        let picked = Picked {
            vertices: vertices.iter().map(|i| i.index(mesh.positions.len()) as u32).collect(),
            faces: faces.iter().map(|i| i.index(mesh.faces.len()) as u32).collect(),
        };
        for operation in MESH_OPERATIONS {
            check(&mesh, operation.id, &picked);
            check(&mesh, operation.id, &Picked::default());
        }
    }

    #[test]
    fn any_sequence_of_operations_leaves_a_mesh(
        mesh in meshes::mixed(),
        steps in prop::collection::vec((0..MESH_OPERATIONS.len(), any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..6),
    ) {
        let mut mesh = mesh;
        for (operation, v, f) in steps {
            if mesh.faces.is_empty() || mesh.faces.len() > 2000 {
                break;
            }
            let face = f.index(mesh.faces.len()) as u32;
            let corners = mesh.faces.row(face as usize);
            let first = v.index(corners.len());
            // The vertices of an edge and its face, a valid selection for most operations.
            let picked = Picked {
                vertices: vec![corners[first], corners[(first + 1) % corners.len()]],
                faces: vec![face],
            };
            check(&mesh, MESH_OPERATIONS[operation].id, &picked);
            if let Ok(edited) = apply(&mesh, MESH_OPERATIONS[operation].id, None, &picked) {
                mesh = edited.mesh;
            }
        }
    }

    #[test]
    fn turning_over_twice_changes_nothing(mesh in meshes::mixed()) {
        prop_assume!(!mesh.faces.is_empty());
        let twice = done(&done(&mesh, "flip").mesh, "flip").mesh;
        prop_assert_eq!(twice, mesh);
    }

    #[test]
    fn faces_turned_over_at_random_are_found(
        turned in prop::collection::vec(any::<bool>(), 30),
        height in -1.0..1.0_f64,
    ) {
        let mesh = grid(6, 5, |i, j| [f64::from(i), f64::from(j), height * f64::from(i * j)]);
        let mut wrong = mesh.clone();
        wrong.faces = mesh.faces.iter().zip(&turned).map(|(face, turned)| {
            let mut face = face.to_vec();
            if *turned { face[1..].reverse(); }
            face
        }).collect();
        let is_wrong = turned.iter().any(|t| *t != turned[0]);
        let found = apply(&wrong, "unify", None, &Picked::default());
        prop_assert_eq!(found.is_ok(), is_wrong);
        if let Ok(found) = found {
            prop_assert_eq!(most_alike(&found.mesh), 1);
            let as_they_were = found.mesh.faces.iter().zip(wrong.faces.iter()).filter(|(a, b)| a == b);
            prop_assert!(2 * as_they_were.count() >= 30, "as few as are needed");
        }
    }
}

pub(crate) fn flat(columns: u32, rows: u32) -> Mesh {
    grid(columns, rows, |i, j| [f64::from(i), f64::from(j), 0.0])
}

#[test]
fn quads_cut_to_triangles_are_found_again() {
    let quads = grid(7, 5, |i, j| {
        let x = f64::from(i);
        [1.2 * x, f64::from(j), 0.05 * x * x]
    });
    let cut = done(&quads, "triangles").mesh;
    assert_eq!(cut.faces.len(), 70);
    let paired = done(&cut, "quads");
    assert_eq!(paired.mesh.faces.len(), 35);
    let sorted = |mesh: &Mesh| {
        let corners = |face: &[u32]| {
            let mut corners = face.to_vec();
            corners.sort_unstable();
            corners
        };
        let mut faces: Vec<Vec<u32>> = mesh.faces.iter().map(corners).collect();
        faces.sort_unstable();
        faces
    };
    assert_eq!(sorted(&paired.mesh), sorted(&quads));
    assert!(paired.origins.faces.iter().all(|parents| parents.len() == 2));
    // A left-over triangle can regroup: of five in a row, two pairs and one triangle remain.
    let mut row = flat(5, 1);
    row = done(&row, "triangles").mesh;
    row.faces = row.faces.iter().take(9).collect();
    assert_eq!(done(&row, "quads").mesh.faces.len(), 5);
}

#[test]
fn the_dual_of_a_grid_is_a_grid_with_its_outline() {
    let mesh = flat(6, 4);
    let Edited { mesh: dual, .. } = done(&mesh, "dual");
    assert_eq!(dual.faces.len(), 7 * 5);
    assert!(dual.faces.iter().all(|face| face.len() == 4));
    // Centres of faces and of boundary edges, and the four corners.
    assert_eq!(dual.positions.len(), 24 + 20 + 4);
    assert!((area(&dual) - 24.0).abs() < 1e-12);
    let topology = Topology::new(&dual);
    assert_eq!((boundary_edges(&topology), euler(&dual, &topology)), (24, 1));
}

#[test]
fn the_dual_of_a_cube_is_an_octahedron_and_back() {
    let octahedron = done(&cube(), "dual").mesh;
    assert_eq!((octahedron.positions.len(), octahedron.faces.len()), (6, 8));
    assert!(octahedron.faces.iter().all(|face| face.len() == 3));
    let back = done(&octahedron, "dual").mesh;
    assert_eq!((back.positions.len(), back.faces.len()), (8, 6));
    assert!(back.positions.iter().all(|p| p.iter().all(|x| (x.abs() - 1.0 / 3.0).abs() < 1e-15)));
    assert_eq!(most_alike(&back), 1);
}

#[test]
fn triangles_become_hexagons() {
    let mut mesh = flat(8, 8);
    mesh.faces = mesh.faces.iter().flat_map(|f| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]).collect();
    let dual = done(&mesh, "dual").mesh;
    assert_eq!(dual.faces.iter().filter(|face| face.len() == 6).count(), 49);
    assert!((area(&dual) - 64.0).abs() < 1e-12);
}

#[test]
fn diagonal_quads_are_one_for_each_edge() {
    let mesh = flat(5, 3);
    let topology = Topology::new(&mesh);
    let Edited { mesh: diagonal, .. } = done(&mesh, "diagonal");
    assert_eq!(diagonal.faces.len(), topology.edges().len());
    assert_eq!(diagonal.faces.iter().filter(|face| face.len() == 3).count(), 16);
    assert!((area(&diagonal) - 15.0).abs() < 1e-12);
    assert_eq!(diagonal.positions[..24], mesh.positions[..], "what came stays first");
}

#[test]
fn a_strip_that_is_put_in_can_be_taken_out() {
    let mesh = flat(6, 4);
    // Across the edge between columns 2 and 3.
    let Edited { mesh: wider, origins } =
        apply(&mesh, "insert-strip", None, &with_vertices(&[2, 3])).unwrap();
    assert_eq!((wider.faces.len(), wider.positions.len()), (28, 40));
    assert!(wider.faces.iter().all(|face| face.len() == 4));
    assert!((area(&wider) - 24.0).abs() < 1e-12);
    let middle = origins.between.iter().position(|between| between == [2, 3]).unwrap();
    assert_eq!(wider.positions[middle], [2.5, 0.0, 0.0]);
    let ends = with_vertices(&[middle as u32, 3]);
    let Edited { mesh: again, .. } = apply(&wider, "remove-strip", None, &ends).unwrap();
    assert_eq!((again.faces.len(), again.positions.len()), (24, 35));
    assert!((area(&again) - 24.0).abs() < 1e-12);
    // The outermost strip is removed, and the outline stays.
    let Edited { mesh: narrower, .. } =
        apply(&mesh, "remove-strip", None, &with_vertices(&[0, 1])).unwrap();
    assert_eq!(narrower.faces.len(), 20);
    assert!((area(&narrower) - 24.0).abs() < 1e-12);
    // A strip ends at a triangle, which gets an additional corner.
    let mut mixed = flat(3, 1);
    mixed.faces = [&[0, 1, 5, 4][..], &[1, 2, 5], &[2, 6, 5], &[2, 3, 7, 6]].into_iter().collect();
    let cut = apply(&mixed, "insert-strip", None, &with_vertices(&[1, 5])).unwrap().mesh;
    let sizes: Vec<usize> = cut.faces.iter().map(<[u32]>::len).collect();
    assert_eq!(sizes, [4, 4, 4, 3, 4]);
}

#[test]
fn deleted_faces_take_their_own_vertices_along() {
    let mesh = flat(4, 1);
    let picked = Picked { faces: vec![0, 1], ..Picked::default() };
    let Edited { mesh: left, origins } = apply(&mesh, "delete", None, &picked).unwrap();
    assert_eq!((left.faces.len(), left.positions.len()), (2, 6));
    assert_eq!(origins.vertices[..4], [None, None, Some(0), Some(1)]);
    let all = Picked { faces: vec![0, 1, 2, 3], ..Picked::default() };
    assert_eq!(apply(&mesh, "delete", None, &all), Err(OperationError::NothingLeft));
}

#[test]
fn faces_are_merged_and_split() {
    let mesh = flat(3, 3);
    let picked = Picked { faces: vec![4, 5, 1], ..Picked::default() };
    let merged = apply(&mesh, "merge-faces", None, &picked).unwrap();
    assert_eq!(merged.mesh.faces.len(), 7);
    let face = merged.mesh.faces.row(1);
    assert_eq!(face.len(), 8);
    assert_eq!(merged.origins.faces.row(1), [1, 4, 5]);
    for apart in [vec![0, 8], vec![0], vec![0, 1, 2, 3, 5, 6, 7, 8]] {
        let picked = Picked { faces: apart, ..Picked::default() };
        assert!(matches!(
            apply(&mesh, "merge-faces", None, &picked),
            Err(OperationError::Expected(_))
        ));
    }
    let split = apply(&mesh, "split-face", None, &with_vertices(&[5, 0])).unwrap().mesh;
    assert_eq!(split.faces.len(), 10);
    assert_eq!([split.faces.row(0), split.faces.row(1)], [[5, 4, 0], [0, 1, 5]]);
    assert!(apply(&mesh, "split-face", None, &with_vertices(&[0, 1])).is_err(), "neighbours");
}

#[test]
fn vertices_are_welded_merged_and_snapped() {
    let mut soup = flat(2, 1);
    soup.positions.push([1.0 + 1e-3, 0.0, 0.0]);
    soup.faces = [[0, 1, 4, 3], [6, 2, 5, 4]].into_iter().collect();
    let Edited { mesh: welded, origins } =
        apply(&soup, "weld", Some(&[0.01]), &Picked::default()).unwrap();
    assert_eq!(welded.positions.len(), 6);
    assert_eq!(origins.vertices[6], Some(1));
    assert_eq!(Topology::new(&welded).boundary_loops().len(), 1);
    assert!(apply(&soup, "weld", Some(&[1e-4]), &Picked::default()).is_err());
    // Places that are odd multiples of the distance.
    let mut row = flat(1, 1);
    row.positions.iter_mut().flatten().for_each(|x| *x *= 0.3);
    row.positions.push(row.positions[1]);
    row.faces.push(&[1, 4, 3]);
    let row = apply(&row, "weld", Some(&[0.1]), &Picked::default()).unwrap();
    assert_eq!(row.origins.vertices[4], Some(1));
    let one = apply(&welded, "merge-vertices", None, &with_vertices(&[0, 3])).unwrap().mesh;
    assert_eq!(one.positions[0], [0.0, 0.5, 0.0]);
    assert_eq!(one.faces.row(0).len(), 3);
    let mesh = grid(2, 2, |i, j| [f64::from(i) + 0.04, f64::from(j) - 0.04, 0.3]);
    let snapped = apply(&mesh, "snap", Some(&[0.25]), &with_vertices(&[4])).unwrap().mesh;
    assert_eq!(snapped.positions[4], [1.0, 1.0, 0.25]);
    assert_eq!(snapped.positions[5], mesh.positions[5]);
}

#[test]
fn patches_are_joined_along_their_seam_only() {
    // Two patches with vertices of their own along x = 1, and a loose vertex on one of them.
    let mut mesh = flat(1, 2);
    mesh.positions
        .extend([1.0, 2.0].into_iter().flat_map(|x| [0.0, 1.0, 2.0].map(|y| [x, y, 0.0])));
    mesh.positions.push([1.0, 1.0, 0.0]);
    let seam: Vec<u32> = (6..9).collect();
    mesh.faces.push(&[seam[0], 9, 10, seam[1]]);
    mesh.faces.push(&[seam[1], 10, 11, seam[2]]);
    let Edited { mesh: joined, origins } = done(&mesh, "join");
    assert_eq!(joined.positions.len(), 10);
    assert_eq!(Topology::new(&joined).boundary_loops().len(), 1);
    let places = |v: u32| mesh.positions[v as usize];
    for v in seam {
        let to = origins.vertices[v as usize].unwrap();
        assert_eq!(joined.positions[to as usize], places(v));
    }
    // The patches are apart at rest, and held together now.
    let apart =
        |v: usize| if v < 6 { mesh.positions[v] } else { mesh.positions[v].map(|x| x + 5.0) };
    let rest: Vec<Point> = (0..mesh.positions.len()).map(apart).collect();
    let topology = Topology::new(&mesh);
    let task = Task {
        mesh: &mesh,
        rest: &rest,
        topology: &topology,
        up: [0.0, 0.0, 1.0],
        sizes: &[],
        vertices: &[],
        faces: &[],
    };
    assert_eq!(MeshOperation::of("join").unwrap().apply(&task).unwrap().mesh, joined);
    let again = apply(&joined, "join", None, &Picked::default()).unwrap_err().to_string();
    assert!(again.contains("boundary vertices that lie on each other"), "{again}");
}

/// Defaults in small units, or of large models, were beyond the limits.
#[test]
fn a_length_as_the_edges_is_within_the_limits_in_any_unit() {
    for unit in [1e-15, 1.0, 1e15] {
        let mut mesh = flat(2, 2);
        mesh.positions.iter_mut().flatten().for_each(|x| *x *= unit);
        let nothing = Picked::default();
        let extruded = apply(&mesh, "extrude", Some(&[unit, 0.0]), &nothing);
        assert_eq!(extruded.expect("a length as its edges").mesh.faces.len(), 12);
        apply(&mesh, "snap", Some(&[0.7 * unit]), &nothing).expect("a step below its edges");
    }
    let refused = apply(&flat(2, 2), "extrude", Some(&[1e51, 0.0]), &Picked::default());
    let words = refused.expect_err("too far out").to_string();
    assert!(words.starts_with("Outward: expected a length from 0 to 1e50, found 1"), "{words}");
}

#[test]
fn each_has_a_sentence_and_sizes_within_their_limits() {
    for operation in MESH_OPERATIONS {
        assert!(operation.summary.ends_with('.') && !operation.label.is_empty());
        for Size { id, label, of, default, least, most } in operation.sizes {
            assert!(least <= default && default <= most, "{id}");
            assert!(!label.is_empty() && (*of != SizeOf::Degrees || *most <= 180.0));
        }
    }
}

#[test]
fn curves_and_groups_go_along() {
    let mut mesh = flat(4, 2);
    mesh.curves.push(&[5, 6, 7, 8, 9]);
    let text = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\ng left\nf 1 2 5 4\ng right\nf 2 3 6 5\n";
    let named = read("groups.obj", text.as_bytes()).unwrap().mesh;
    let cut = done(&named, "triangles").mesh;
    assert_eq!(cut.groups[1].faces, [2, 3]);
    let picked = Picked { faces: vec![0], ..Picked::default() };
    let left = apply(&named, "delete", None, &picked).unwrap().mesh;
    assert_eq!(
        (left.groups.len(), &*left.groups[0].name, &left.groups[0].faces[..]),
        (1, "right", &[0][..])
    );
    let wider = apply(&mesh, "insert-strip", None, &with_vertices(&[5, 6])).unwrap().mesh;
    assert_eq!(wider.curves.row(0).len(), 6, "the curve gets the vertex on its edge");
    let merged = apply(&mesh, "merge-vertices", None, &with_vertices(&[5, 6])).unwrap().mesh;
    assert_eq!(merged.curves.row(0).len(), 4);
}

/// On real meshes every operation gives a sound mesh, and the dual of a dual has the original
/// faces.
#[test]
fn real_meshes_go_through_every_operation() {
    let names = [
        "bunny_poly.obj",
        "compas_hypar.obj",
        "halftunnel.off",
        "cmc1.obj",
        "hemisphere.obj",
        "igloo.obj",
    ];
    for mesh in names.into_iter().filter_map(shared::mesh) {
        let corners = mesh.faces.row(mesh.faces.len() / 2);
        let picked =
            Picked { vertices: corners[..2].to_vec(), faces: vec![mesh.faces.len() as u32 / 2] };
        for operation in MESH_OPERATIONS {
            check(&mesh, operation.id, &picked);
            check(&mesh, operation.id, &Picked::default());
        }
        let cut = apply(&mesh, "triangles", None, &Picked::default());
        let cut = cut.map_or(mesh, |cut| cut.mesh);
        let topology = Topology::new(&cut);
        let refined = Subdivision { scheme: Scheme::Loop, levels: 1, keep: 75.0 };
        assert!(refined.apply(&cut, &topology).is_ok());
    }
}
