//! A mesh that is written as OBJ and read again is the same, bit for bit.

use proptest::collection::{hash_set, vec};
use proptest::prelude::*;
use shape_up::mesh::{Group, GroupKeyword, Mesh, Point, Ragged, read, write_obj};

/// Any finite number, including subnormal numbers and negative zero.
fn number() -> impl Strategy<Value = f64> {
    use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO, -1e3..1e3]
}

/// Groups of an element: at most one `o`, any `g`, at most one `usemtl`.
type Membership = (Option<usize>, Vec<bool>, Option<usize>);

const OBJECTS: [&str; 3] = ["part.001", "two words", "#1"];
const GROUPS: [&str; 4] = ["front", "cube", "D\u{e4}cher\u{a0}S\u{fc}d", "#eaves"];
const MATERIALS: [&str; 2] = ["white", "C:\\glass.png"];

fn membership() -> impl Strategy<Value = Membership> {
    (
        prop::option::of(0..OBJECTS.len()),
        vec(any::<bool>(), GROUPS.len()),
        prop::option::of(0..MATERIALS.len()),
    )
}

/// Groups of faces, then of curves, for these memberships, in the order of a file.
fn groups(faces: &[Membership], curves: &[Membership]) -> Vec<Group> {
    use GroupKeyword::{Group as Named, Material, Object};
    let names = OBJECTS.iter().map(|name| (Object, *name));
    let names = names.chain(GROUPS.iter().map(|name| (Named, *name)));
    let names = names.chain(MATERIALS.iter().map(|name| (Material, *name)));
    let members = |keyword, name: &str, elements: &[Membership]| -> Vec<u32> {
        let is_in = |(object, named, material): &Membership| match keyword {
            Object => object.is_some_and(|i| OBJECTS[i] == name),
            Named => (0..named.len()).any(|i| named[i] && GROUPS[i] == name),
            Material => material.is_some_and(|i| MATERIALS[i] == name),
        };
        (0..).zip(elements).filter(|(_, element)| is_in(element)).map(|(index, _)| index).collect()
    };
    let mut groups: Vec<Group> = names
        .map(|(keyword, name)| Group {
            name: name.to_owned(),
            keyword,
            faces: members(keyword, name, faces),
            curves: members(keyword, name, curves),
        })
        .filter(|group| !group.faces.is_empty() || !group.curves.is_empty())
        .collect();
    let first = |members: &[u32]| members.first().copied().unwrap_or(u32::MAX);
    groups.sort_by_key(|group| (first(&group.faces), first(&group.curves), group.keyword));
    groups
}

fn mesh() -> impl Strategy<Value = Mesh> {
    vec([number(), number(), number()], 8..40).prop_flat_map(|positions| {
        let vertex = 0..positions.len() as u32;
        let face = hash_set(vertex.clone(), 3..=8).prop_map(Vec::from_iter);
        let curve = (hash_set(vertex, 2..=6), any::<bool>()).prop_map(|(vertices, closed)| {
            let mut curve = Vec::from_iter(vertices);
            curve.extend(closed.then_some(curve[0]));
            curve
        });
        let faces = vec((face, membership()), 0..30);
        let curves = vec((curve, membership()), 0..8);
        (Just(positions), faces, curves).prop_map(|(positions, faces, curves)| {
            let (faces, face_members): (Vec<_>, Vec<_>) = faces.into_iter().unzip();
            let (curves, curve_members): (Vec<_>, Vec<_>) = curves.into_iter().unzip();
            Mesh {
                positions,
                faces: Ragged::from_iter(faces),
                curves: Ragged::from_iter(curves),
                tets: Vec::new(),
                groups: groups(&face_members, &curve_members),
                ..Mesh::default()
            }
        })
    })
}

fn bits(positions: &[Point]) -> Vec<[u64; 3]> {
    positions.iter().map(|p| p.map(f64::to_bits)).collect()
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(256))]

    #[test]
    fn what_is_written_reads_back_bit_for_bit(mesh in mesh()) {
        let text = write_obj(&mesh, &mesh.positions);
        let again = read("mesh.obj", text.as_bytes()).expect("what we write is read").mesh;
        prop_assert_eq!(bits(&again.positions), bits(&mesh.positions));
        prop_assert_eq!(&again, &mesh);
        prop_assert_eq!(write_obj(&again, &again.positions), text);
    }

    #[test]
    fn numbers_are_short(x in number()) {
        let mesh = Mesh { positions: vec![[x; 3]], ..Mesh::default() };
        let text = write_obj(&mesh, &mesh.positions);
        let word = text.split_ascii_whitespace().nth(1).expect("a vertex has coordinates");
        prop_assert_eq!(word.parse().map(f64::to_bits), Ok(x.to_bits()));
        // At most 17 digits, a sign, the leading zeros of 0.00001 and the point, or an exponent.
        prop_assert!(word.len() <= 25, "{}", word);
    }
}

#[test]
fn positions_are_the_ones_given() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\no roof\nf 1 2 3\nl 1 2 3 1\n";
    let mesh = read("roof.obj", text.as_bytes()).expect("the file is sound").mesh;
    assert_eq!(write_obj(&mesh, &mesh.positions), text);
    let moved = [[0.1, -2.5e-7, 1e16], [1.0, 1e300, -0.0], [0.00001, 123456.789, 5e-324]];
    assert_eq!(
        write_obj(&mesh, &moved),
        "v 0.1 -2.5e-7 1e16\nv 1 1e300 -0\nv 0.00001 123456.789 5e-324\n\
         o roof\nf 1 2 3\nl 1 2 3 1\n"
    );
}

#[test]
fn names_that_obj_cannot_hold_stay_in_their_line() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let mut mesh = read("roof.obj", text.as_bytes()).expect("the file is sound").mesh;
    for (keyword, name, expected) in [
        (GroupKeyword::Group, "north\nroof", "north_roof"),
        (GroupKeyword::Group, " a  b\t", "a_b"),
        (GroupKeyword::Group, "C:\\", "C:"),
        (GroupKeyword::Object, "north\r\nroof\\", "north roof"),
    ] {
        let group = Group { name: name.to_owned(), keyword, faces: vec![0], curves: vec![] };
        mesh.groups = vec![group];
        let text = write_obj(&mesh, &mesh.positions);
        let again = read("roof.obj", text.as_bytes()).expect("what we write is read").mesh;
        mesh.groups[0].name = expected.to_owned();
        assert_eq!(again, mesh, "{text}");
    }
}
