//! Selectors: the vertices that the constraints of a scene act on.

use crate::support::meshes::{mixed, wavy};
use proptest::prelude::*;
use shape_up::constraint::{Element, SelectError, Selector, Set, Sets, describe, resolve};
use shape_up::mesh::{Group, GroupKeyword, Mesh, Ragged, Topology};

fn each(element: Element, within: Option<&str>, radius: u32) -> Selector {
    Selector::Each { element, within: within.map(str::to_string), radius }
}

/// The 3 by 3 grid of quads, with an open and a closed curve and two groups:
///
/// ```text
/// 12 13 14 15
///   6  7  8       faces
///  8  9 10 11
///   3  4  5
///  4  5  6  7
///   0  1  2
///  0  1  2  3
/// ```
fn roof() -> Mesh {
    let group = |name: &str, faces: &[u32], curves: &[u32]| Group {
        name: name.to_string(),
        keyword: GroupKeyword::Group,
        faces: faces.to_vec(),
        curves: curves.to_vec(),
    };
    Mesh {
        curves: Ragged::from_iter([vec![0, 5, 10], vec![1, 2, 6, 5, 1]]),
        groups: vec![group("left", &[0, 3, 6], &[]), group("ribs", &[], &[1])],
        ..wavy(3, 3)
    }
}

fn sets() -> Sets {
    let set =
        |vertices: &[u32], faces: &[u32]| Set { vertices: vertices.into(), faces: faces.into() };
    Sets::from([
        ("corner".to_string(), set(&[0, 1, 4, 5], &[])),
        ("skylight".to_string(), set(&[], &[4, 8])),
        ("left".to_string(), set(&[3], &[])),
        ("broken".to_string(), set(&[0, 99], &[])),
        ("no such face".to_string(), set(&[], &[9])),
        ("nothing".to_string(), Set::default()),
    ])
}

fn select(selector: &Selector) -> Result<Vec<Vec<u32>>, SelectError> {
    let mesh = roof();
    let rows = resolve(selector, &mesh, &Topology::new(&mesh), &sets())?;
    Ok(rows.iter().map(<[u32]>::to_vec).collect())
}

fn rows(selector: &Selector) -> Vec<Vec<u32>> {
    select(selector).expect("the selector is valid")
}

#[test]
fn faces_come_in_the_order_of_the_mesh() {
    let all = rows(&each(Element::Face, None, 0));
    assert_eq!(all.len(), 9);
    assert_eq!(all[0], [0, 1, 5, 4]);
    assert_eq!(all[8], [10, 11, 15, 14]);
}

#[test]
fn a_set_with_faces_keeps_those_and_one_with_vertices_the_faces_inside() {
    let skylight = rows(&each(Element::Face, Some("skylight"), 0));
    assert_eq!(skylight, [[5, 6, 10, 9], [10, 11, 15, 14]]);
    assert_eq!(rows(&each(Element::Face, Some("corner"), 0)), [[0, 1, 5, 4]]);
    assert!(rows(&each(Element::Face, Some("nothing"), 0)).is_empty());
}

#[test]
fn a_radius_adds_rings_of_neighbours_after_the_element() {
    let grown = rows(&each(Element::Face, Some("corner"), 1));
    // The curve from 0 through 5 to 10 makes 10 a neighbour of 5.
    assert_eq!(grown, [[0, 1, 5, 4, 2, 6, 8, 9, 10]]);
}

#[test]
fn a_ring_starts_with_its_centre_and_counts_by_it() {
    let rings = rows(&each(Element::Ring, Some("corner"), 1));
    assert_eq!(
        rings,
        [vec![0, 1, 4, 5], vec![1, 0, 2, 5], vec![4, 0, 5, 8], vec![5, 0, 1, 4, 6, 9, 10]]
    );
    assert_eq!(rows(&each(Element::Ring, None, 1)).len(), 16);
    assert_eq!(rows(&each(Element::Ring, None, 2))[0], [0, 1, 4, 5, 2, 6, 8, 9, 10]);
    assert!(rows(&each(Element::Ring, None, 9)).iter().all(|ring| ring.len() == 16));
}

#[test]
fn edges_count_when_both_ends_are_in_the_set() {
    // The curve adds the edge 0 5.
    let edges = rows(&each(Element::Edge, Some("corner"), 0));
    assert_eq!(edges, [[0, 1], [0, 4], [0, 5], [1, 5], [4, 5]]);
}

#[test]
fn curves_are_those_of_the_file_and_the_straight_lines_of_the_grid() {
    let curves = rows(&each(Element::Curve, None, 0));
    assert_eq!(curves[0], [0, 5, 10]);
    // A closed curve does not repeat its vertex.
    assert_eq!(curves[1], [1, 2, 6, 5]);
    assert_eq!(curves.len(), 2 + 4 + 4);
    assert!(curves[2..].iter().all(|line| line.len() == 4));
    // A group of curves selects its curves, and the lines within it.
    assert_eq!(rows(&each(Element::Curve, Some("ribs"), 0)), [[1, 2, 6, 5]]);
}

#[test]
fn polylines_and_edge_lines_can_be_had_apart_and_sets_restrict_both() {
    let polylines = [vec![0, 5, 10], vec![1, 2, 6, 5]];
    assert_eq!(rows(&each(Element::Polyline, None, 0)), polylines);
    let lines = rows(&each(Element::EdgeLine, None, 0));
    assert_eq!(lines.len(), 4 + 4);
    assert_eq!(lines, rows(&each(Element::Curve, None, 0))[2..]);
    // A group of curves selects its curves, a group of faces the lines within it.
    assert_eq!(rows(&each(Element::Polyline, Some("ribs"), 0)), [[1, 2, 6, 5]]);
    assert!(rows(&each(Element::EdgeLine, Some("ribs"), 0)).is_empty());
    let mesh = roof();
    let left = |element| {
        let found =
            resolve(&each(element, Some("left"), 0), &mesh, &Topology::new(&mesh), &Sets::new());
        found.expect("there is such a group").iter().map(<[u32]>::to_vec).collect::<Vec<_>>()
    };
    assert!(left(Element::Polyline).is_empty());
    assert_eq!(left(Element::EdgeLine), [[0, 4, 8, 12], [1, 5, 9, 13]]);
}

/// Both were separate constraints, so the same vertices were pulled twice as much.
#[test]
fn a_polyline_along_an_edge_line_counts_once() {
    let curves = |polylines: &[&[u32]], within: Option<&str>| {
        let mesh = Mesh {
            curves: Ragged::from_iter(polylines),
            groups: vec![Group {
                name: "ribs".to_string(),
                keyword: GroupKeyword::Group,
                faces: Vec::new(),
                curves: vec![0],
            }],
            ..wavy(3, 3)
        };
        let found =
            resolve(&each(Element::Curve, within, 0), &mesh, &Topology::new(&mesh), &sets());
        found.expect("it is valid").iter().map(<[u32]>::to_vec).collect::<Vec<_>>()
    };
    let all_lines = 4 + 4;
    // The same line in either direction: the direction of the file is kept.
    for polyline in [[4, 5, 6, 7], [7, 6, 5, 4]] {
        let found = curves(&[&polyline], None);
        assert_eq!((found.len(), &found[0][..]), (all_lines, &polyline[..]));
        assert!(found[1..].iter().all(|line| line != &[4, 5, 6, 7]));
        assert_eq!(curves(&[&polyline], Some("ribs")), [polyline]);
    }
    // A part of a line is covered by the line, unless the line is not in the group.
    assert_eq!(curves(&[&[5, 6, 7]], None).len(), all_lines);
    assert_eq!(curves(&[&[5, 6, 7], &[4, 5, 6, 7]], None).len(), all_lines);
    assert_eq!(curves(&[&[5, 6, 7]], Some("ribs")), [[5, 6, 7]]);
    // A polyline that turns from line to line covers the lines that it contains whole.
    let turning = curves(&[&[4, 5, 6, 7, 11, 15]], None);
    assert_eq!((turning.len(), &turning[0][..]), (all_lines, &[4, 5, 6, 7, 11, 15][..]));
    // Two lines that only meet, or of which one skips a vertex, do not cover each other.
    assert_eq!(curves(&[&[4, 5, 9]], None).len(), all_lines + 1);
    assert_eq!(curves(&[&[4, 6, 7]], None).len(), all_lines + 1);
}

#[test]
fn boundary_loops_tets_and_groups_are_elements_too() {
    let boundary = rows(&each(Element::Boundary, None, 0));
    assert_eq!(boundary, [[0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4]]);
    assert!(rows(&each(Element::Boundary, Some("corner"), 0)).is_empty());
    assert!(rows(&each(Element::Tet, None, 0)).is_empty());
    let groups = rows(&each(Element::Group, None, 0));
    assert_eq!(groups, [vec![0, 1, 5, 4, 9, 8, 13, 12], vec![1, 2, 6, 5]]);
    let mesh = Mesh { tets: vec![[0, 1, 5, 4], [2, 3, 7, 6]], ..roof() };
    let tets =
        resolve(&each(Element::Tet, Some("corner"), 0), &mesh, &Topology::new(&mesh), &sets());
    assert_eq!(tets, Ok(Ragged::from_iter([[0, 1, 5, 4]])));
}

#[test]
fn corners_stars_and_hinges_come_in_the_order_of_their_meaning() {
    let mesh = wavy(3, 3);
    let of = |mesh: &Mesh, element: Element, within: Option<&str>| {
        let rows = resolve(&each(element, within, 0), mesh, &Topology::new(mesh), &sets());
        rows.expect("it is valid").iter().map(<[u32]>::to_vec).collect::<Vec<_>>()
    };
    let corners = of(&mesh, Element::Corner, None);
    assert_eq!(corners.len(), 4 * 9);
    assert_eq!(corners[..4], [[4, 0, 1], [0, 1, 5], [1, 5, 4], [5, 4, 0]]);
    // The corners of the faces of a set.
    assert_eq!(of(&mesh, Element::Corner, Some("skylight")).len(), 8);
    let stars = of(&mesh, Element::Star, None);
    assert_eq!(stars[0], [5, 1, 4, 9, 6]);
    assert_eq!(stars.iter().map(|star| star[0]).collect::<Vec<_>>(), [5, 6, 9, 10]);
    assert!(of(&mesh, Element::Hinge, None).is_empty(), "quads have none");
    let halves = |f: &[u32]| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]];
    let triangles = Mesh { faces: mesh.faces.iter().flat_map(halves).collect(), ..mesh.clone() };
    let hinges = of(&triangles, Element::Hinge, None);
    assert_eq!(hinges.len(), 9 + 12);
    assert_eq!(hinges[0], [0, 5, 1, 4]);
}

#[test]
fn strips_run_side_by_side_and_count_when_they_lie_in_the_set() {
    let strips = rows(&each(Element::Strip, None, 0));
    assert_eq!(strips.len(), 3 + 3);
    assert_eq!(strips[0], [0, 1, 4, 5, 8, 9, 12, 13]);
    let left = Selector::Each { element: Element::Strip, within: Some("left".into()), radius: 0 };
    let none: Vec<Vec<u32>> = vec![];
    assert_eq!(rows(&left), none, "the set of that name has one vertex");
    let mesh = roof();
    let of_group = resolve(&left, &mesh, &Topology::new(&mesh), &Sets::new());
    assert_eq!(of_group, Ok(Ragged::from_iter([[0, 1, 4, 5, 8, 9, 12, 13]])));
    // A closed strip has each vertex once.
    let tube = Mesh {
        positions: vec![[0.0; 3]; 10],
        faces: (0..5_u32).map(|i| [i, (i + 1) % 5, (i + 1) % 5 + 5, i + 5]).collect(),
        ..Mesh::default()
    };
    let found = resolve(&each(Element::Strip, None, 0), &tube, &Topology::new(&tube), &sets());
    let longest = found.as_ref().expect("it is valid").iter().max_by_key(|row| row.len());
    assert_eq!(longest.expect("there is one").len(), 10);
}

#[test]
fn a_set_of_faces_stands_for_their_vertices() {
    assert_eq!(rows(&Selector::Set("skylight".into())), [[5, 6, 10, 9, 11, 15, 14]]);
    assert_eq!(rows(&Selector::Set("ribs".into())), [[1, 2, 6, 5]]);
}

#[test]
fn a_set_goes_before_a_group_of_the_same_name() {
    assert_eq!(rows(&Selector::Set("left".into())), [[3]]);
}

#[test]
fn a_list_of_vertices_is_one_constraint_without_repetitions() {
    assert_eq!(rows(&Selector::Vertices([7, 3, 7, 0].into())), [[7, 3, 0]]);
}

#[test]
fn what_the_mesh_does_not_have_is_named() {
    let unknown = SelectError::UnknownSet("eaves".into());
    assert_eq!(select(&Selector::Set("eaves".into())), Err(unknown.clone()));
    assert_eq!(select(&each(Element::Face, Some("eaves"), 0)), Err(unknown.clone()));
    assert_eq!(
        unknown.to_string(),
        "`eaves` is neither a set of the scene nor a group of the mesh"
    );
    assert_eq!(select(&Selector::Vertices([0, 16].into())), Err(SelectError::VertexOutOfRange(16)));
    assert_eq!(select(&Selector::Set("broken".into())), Err(SelectError::VertexOutOfRange(99)));
    let no_face = select(&each(Element::Face, Some("no such face"), 0));
    assert_eq!(no_face, Err(SelectError::FaceOutOfRange(9)));
}

#[test]
fn selectors_are_described_in_words() {
    let cases = [
        (each(Element::Face, None, 0), "each face"),
        (each(Element::Face, Some("eaves"), 0), "each face of eaves"),
        (each(Element::Face, None, 2), "each face with 2 rings of neighbours"),
        (each(Element::Ring, None, 1), "each vertex with its neighbours"),
        (each(Element::Strip, None, 0), "each strip of faces"),
        (each(Element::Strip, Some("eaves"), 0), "each strip of faces of eaves"),
        (each(Element::Ring, Some("eaves"), 2), "each vertex of eaves with 2 rings of neighbours"),
        (Selector::Set("eaves".into()), "the vertices of eaves"),
        (Selector::Vertices((0..12).collect()), "12 vertices"),
        (Selector::Vertices([4].into()), "1 vertex"),
    ];
    for (selector, words) in cases {
        assert_eq!(describe(&selector), words);
    }
}

#[test]
fn elements_have_ids_and_words_of_their_own() {
    let mut words: Vec<&str> = Element::ALL.iter().map(|element| element.id()).collect();
    words.extend(Element::ALL.iter().filter_map(|element| element.word_for_all()));
    words.sort_unstable();
    let all = words.len();
    words.dedup();
    // "boundary" is both one loop and all loops.
    assert_eq!(words.len(), all - 1);
    assert!(Element::ALL.iter().all(|element| !element.label().is_empty()));
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(64))]

    #[test]
    fn rows_are_distinct_vertices_and_restriction_only_takes_away(
        mesh in mixed(),
        chosen in prop::collection::vec(any::<prop::sample::Index>(), 0..20),
        radius in 0_u32..3,
    ) {
        let topology = Topology::new(&mesh);
        let vertices: Vec<u32> =
            chosen.iter().map(|index| index.index(mesh.positions.len()) as u32).collect();
        let sets = Sets::from([("some".to_string(), Set { vertices: vertices.clone().into(), ..Set::default() })]);
        for element in Element::ALL {
            let of = |within: Option<&str>, radius| {
                let rows = resolve(&each(element, within, radius), &mesh, &topology, &sets);
                rows.expect("the names are known").iter().map(<[u32]>::to_vec).collect::<Vec<_>>()
            };
            let (all, some, grown) = (of(None, 0), of(Some("some"), 0), of(Some("some"), radius));
            let expected: Vec<Vec<u32>> =
                all.iter().filter(|row| row.iter().all(|v| vertices.contains(v))).cloned().collect();
            prop_assert_eq!(&some, &expected);
            prop_assert_eq!(grown.len(), some.len());
            for (row, own) in grown.iter().zip(&some) {
                prop_assert_eq!(&row[..own.len()], &own[..]);
                let mut distinct = row.clone();
                distinct.sort_unstable();
                distinct.dedup();
                prop_assert_eq!(distinct.len(), row.len());
            }
        }
    }
}
