//! Reading a mesh file: every spelling of a mesh gives the same mesh, nothing is lost silently, and
//! messages give the position and the reason.

use shape_up::mesh::{
    ElementKind, GroupKeyword, Mesh,
    ProblemKind::{self, *},
    Ragged, Read, read,
};

fn ok(name: &str, bytes: impl AsRef<[u8]>) -> Read {
    read(name, bytes.as_ref()).unwrap_or_else(|error| panic!("{error}"))
}

fn refused(name: &str, bytes: impl AsRef<[u8]>) -> String {
    let read = read(name, bytes.as_ref());
    read.expect_err("the file is at fault").to_string()
}

fn kinds(read: &Read) -> Vec<(ProblemKind, usize, Option<usize>)> {
    read.problems.iter().map(|problem| (problem.kind, problem.count, problem.line)).collect()
}

fn rows(ragged: &Ragged) -> Vec<Vec<u32>> {
    ragged.iter().map(<[u32]>::to_vec).collect()
}

/// Four vertices, a quad and a closed polyline in a group.
const SQUARE: &str =
    "# square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\ng roof\nf 1 2 3 4\nl 1 2 3 1\n";

#[test]
fn line_ends_encodings_and_continuations_make_no_difference() {
    let square = ok("square.obj", SQUARE);
    assert_eq!(square.problems, []);
    assert_eq!(rows(&square.mesh.faces), [[0, 1, 2, 3]]);
    assert_eq!(rows(&square.mesh.curves), [[0, 1, 2, 0]]);
    let utf16: Vec<u16> = format!("\u{FEFF}{SQUARE}").encode_utf16().collect();
    let spellings: [Vec<u8>; 10] = [
        SQUARE.replace('\n', "\r\n").into(),
        SQUARE.replace('\n', "\r").into(),
        SQUARE.trim_end().into(),
        SQUARE.replace(' ', "\t  ").into(),
        SQUARE.replace("2 3 4", "2 \\\n 3\\  \r\n4").into(),
        SQUARE.replace("# square", "# C:\\models\\").into(),
        SQUARE.replace("1 2 3 4", "-4 -3 -2 -1 # a comment").into(),
        [b"\xEF\xBB\xBF# a name in Latin-1: D\xE4cher\n", SQUARE.as_bytes()].concat(),
        utf16.iter().flat_map(|unit| unit.to_le_bytes()).collect(),
        utf16.iter().flat_map(|unit| unit.to_be_bytes()).collect(),
    ];
    for bytes in spellings {
        let text = String::from_utf8_lossy(&bytes).into_owned();
        assert_eq!(ok("square.obj", bytes).mesh, square.mesh, "{text:?}");
    }
}

#[test]
fn the_format_is_told_by_extension_else_by_content() {
    let off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let medit = "MeshVersionFormatted 1\nVertices 1\n0 0 0 0\n";
    for (name, text) in [("a.OFF", off), ("a.b.off", off), ("noext", off), ("a.txt", off)] {
        assert_eq!(ok(name, text).mesh.positions.len(), 3, "{name}");
    }
    assert_eq!(ok("scan.medit", medit).mesh.positions.len(), 1);
    assert_eq!(ok("square", SQUARE).mesh.positions.len(), 4);
    for bytes in [&b"ISO-10303-21;\nHEADER;\n"[..], b"; FBX 7.3.0 project file\n"] {
        let message = refused("cube.step", bytes);
        assert!(message.contains(".obj") && message.contains(".off"), "{message}");
    }
}

#[test]
fn what_cannot_be_solved_is_refused_with_the_reason() {
    for (name, bytes, reason) in [
        ("roof.obj", &b""[..], "roof.obj: the file is empty"),
        ("roof.obj", b" \r\n\n", "roof.obj: the file is empty"),
        ("roof.obj", b"f 1 2 3\n", "roof.obj: the file has no vertices: expected at least one"),
        ("roof.obj", b"v nan x inf\n", "roof.obj: no coordinate in the file is a number"),
        ("roof.obj", b"glTF\x02\0\0\0", "roof.obj: this is not a text file"),
        ("roof.off", b"OFF BINARY\n", "roof.off:1: `OFF BINARY`: expected the number of vertices"),
        ("roof.off", b"COFF4\nv", "roof.off:2: `v`: expected the number of faces, found `v`"),
        ("roof.off", b"4OFF\n", "roof.off:1: `4OFF`: the vertices of `4OFF` are not three-dim"),
        ("roof.off", b"v 0 0 0\n", "roof.off:1: `v 0 0 0`: expected `OFF`, found `v`"),
        ("roof.mesh", b"Dimension 4", "roof.mesh:1: `Dimension 4`: expected dimension 2 or 3"),
    ] {
        let message = refused(name, bytes);
        assert!(message.starts_with(reason), "{message}");
    }
}

#[test]
fn counts_that_do_not_fit_are_refused() {
    let off = |counts: &str| format!("OFF\n{counts}\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    for (counts, message) in [
        ("3 2 0", "a.off: the file ends where the number of corners of face 2 of 2 was expected"),
        ("9 1 0", "a.off: the file ends where vertex 5 of 9 was expected"),
        ("2 1 0", "a.off:6: `3 0 1 2`: the header says 2 vertices and 1 face, but `3` follows"),
        ("3 0 0", "a.off:6: `3 0 1 2`: the header says 3 vertices and 0 faces, but `3` follows"),
        ("-3 1 0", "a.off:2: `-3 1 0`: expected the number of vertices, found `-3`"),
        ("3 99999999999999999999 0", "a.off:2: `3 99999999999999999999 0`: expected the number of"),
    ] {
        let found = refused("a.off", off(counts));
        assert!(found.starts_with(message), "{found}");
    }
    let mesh = "MeshVersionFormatted 1\nVertices 2\n0 0 0 0\n1 0 0 0\n2 0 0 0\n";
    let found = refused("a.mesh", mesh);
    assert_eq!(found, "a.mesh:5: `2 0 0 0`: `Vertices` has more rows than its count: found `2`");
    let found = refused("a.mesh", mesh.replace("Vertices 2", "Vertices 4"));
    assert_eq!(found, "a.mesh: the file ends where vertex 4 of 4 was expected");
}

#[test]
fn bad_coordinates_keep_the_numbers_of_vertices() {
    let text = "v 0 0 0\nv nan 1 2\nv 4 x\nv 4 1,5 1e999\nf 1 2 3\nf 2 3 4\n";
    let read = ok("a.obj", text);
    // Bad coordinates are replaced by the middle of the extent: 0 to 4 in x, 0 to 1.5 in y, 0 to 2
    // in z.
    let expected = [[0.0, 0.0, 0.0], [2.0, 1.0, 2.0], [4.0, 0.75, 1.0], [4.0, 1.5, 1.0]];
    assert_eq!(read.mesh.positions, expected);
    assert_eq!(rows(&read.mesh.faces), [[0, 1, 2], [1, 2, 3]]);
    assert_eq!(
        kinds(&read),
        [
            (MalformedCoordinate, 1, Some(3)),
            (NonFiniteCoordinate, 2, Some(2)),
            (DecimalComma, 1, Some(4)),
            (FlippedNeighbour, 1, Some(6)),
        ]
    );
}

#[test]
fn decimal_commas_are_read_and_said() {
    let read = ok("a.obj", "v 0,046 0,78 1,2\nv -1,5e-1 2 3\n");
    assert_eq!(read.mesh.positions, [[0.046, 0.78, 1.2], [-0.15, 2.0, 3.0]]);
    assert_eq!(
        read.problems[0].to_string(),
        "2 vertices with decimal commas, read as decimal points, first at line 1: `v 0,046 0,78 1,2`"
    );
}

#[test]
fn a_bad_face_is_skipped_whole_and_the_others_stay() {
    let vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    for (face, kind) in [
        ("f 1 2", TooFewCorners(ElementKind::Face)),
        ("f", TooFewCorners(ElementKind::Face)),
        ("f 1 1 2", TooFewCorners(ElementKind::Face)),
        ("f 1 2 5", CornerOutOfRange(ElementKind::Face)),
        ("f 1 2 -5", CornerOutOfRange(ElementKind::Face)),
        ("f 1 2 99999999999999", CornerOutOfRange(ElementKind::Face)),
        ("f 1 2 0", CornerZero(ElementKind::Face)),
        ("f 1 2 x", MalformedCorner(ElementKind::Face)),
        ("f 1 2 3.0", MalformedCorner(ElementKind::Face)),
        ("f 1,2,3", MalformedCorner(ElementKind::Face)),
        ("f 1 2 /3", MalformedCorner(ElementKind::Face)),
        ("f 1 2 3 1 4", SelfTouchingFace),
        ("l 1", TooFewCorners(ElementKind::Curve)),
        ("l 1 2 9", CornerOutOfRange(ElementKind::Curve)),
        ("face 1 2 3", UnknownStatement),
    ] {
        let read = ok("a.obj", format!("{vertices}g a\nf 1 2 3\n{face}\ng b\nf 3 4 1\n"));
        assert_eq!(rows(&read.mesh.faces), [[0, 1, 2], [2, 3, 0]], "{face}");
        assert_eq!(kinds(&read), [(kind, 1, Some(7))], "{face}");
        assert_eq!(read.mesh.groups[1].faces, [1], "{face}");
        let said = read.problems[0].to_string();
        assert!(
            said.starts_with("1 ") && said.ends_with(&format!(", at line 7: `{face}`")),
            "{said}"
        );
    }
}

#[test]
fn a_corner_twice_in_a_row_is_kept_once() {
    let read = ok("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 2 3\nf 3 2 1 3\nl 1 1 2 1\n");
    assert_eq!(rows(&read.mesh.faces), [[0, 1, 2], [2, 1, 0]]);
    assert_eq!(rows(&read.mesh.curves), [[0, 1, 0]]);
    assert_eq!(
        kinds(&read)[..2],
        [
            (RepeatedCorner(ElementKind::Face), 2, Some(4)),
            (RepeatedCorner(ElementKind::Curve), 1, Some(6)),
        ]
    );
}

#[test]
fn the_first_line_of_a_problem_is_the_least() {
    let points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\n";
    let read = ok("a.obj", points.to_owned() + "f 1 2 3\nf 4 5 6\nf 4 5 6\nf 1 2 3\n");
    assert_eq!(kinds(&read), [(DuplicateFace, 2, Some(9)), (FlippedNeighbour, 6, Some(9))]);
}

#[test]
fn faces_may_come_before_their_vertices_but_count_back_from_their_place() {
    let read = ok("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf -1 -2 -3\nv 2 2 2\nf -1 -2 -3\n");
    assert_eq!(rows(&read.mesh.faces), [[0, 1, 2], [2, 1, 0], [3, 2, 1]]);
}

#[test]
fn groups_overlap_and_continue() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\
        f 1 2 3\no A Roof\ng a b a\nf 1 3 4\nusemtl glass\nf 1 2 4\nl 1 2\n\
        g b\nf 2 3 4\ng\no\nusemtl\nf 1 2 3 4\ng b #2\nl 3 4\ng empty\n";
    let Mesh { groups, .. } = ok("a.obj", text).mesh;
    let groups: Vec<_> = groups
        .iter()
        .map(|group| (group.keyword, &group.name[..], &group.faces[..], &group.curves[..]))
        .collect();
    use GroupKeyword::{Group, Material, Object};
    assert_eq!(
        groups,
        [
            (Object, "A Roof", &[1, 2, 3][..], &[0][..]),
            (Group, "a", &[1, 2], &[0]),
            (Group, "b", &[1, 2, 3], &[0, 1]),
            (Material, "glass", &[2, 3], &[0]),
            (Group, "#2", &[], &[1]),
        ]
    );
}

#[test]
fn curves_of_degree_one_are_polylines() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\n\
        cstype bspline\ndeg 1\ncurv 0 3 1 2 3 1\nparm u 0 0 1 2 3 3\nend\n\
        cstype rat bspline\ndeg 1\ncurv 0 1 -3 -1\nend\n\
        deg 3\ncurv 0 1 1 2 3 1\nend\nsurf 0 1 0 1 1 2 3\nend\np 1 2\n";
    let read = ok("a.obj", text);
    assert_eq!(rows(&read.mesh.curves), [vec![0, 1, 2, 0], vec![0, 2]]);
    assert_eq!(read.problems, []);
    assert_eq!(
        read.notes,
        [
            "2 point elements ignored",
            "1 curve of a degree above one ignored",
            "1 free-form surface ignored"
        ]
    );
}

#[test]
fn variants_of_off_give_the_same_mesh() {
    let plain = "OFF\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 2 3 0\n";
    let mesh = ok("a.off", plain).mesh;
    let coloured = plain.replace(" 0\n", " 0 0.5 0.5 0.5 1\n");
    for text in [
        plain.replace("OFF\n", "OFF"),
        plain.replace("OFF\n", "OFF # the header\n\n#\n"),
        plain.replace("OFF\n", ""),
        plain.replace("4 2 5", "4 2"),
        plain.replace("3 0 1 2", "3\n0 1\n2"),
        plain.replace("3 0 1 2", "3 0 1 2 255 0 0"),
        coloured.replace("OFF", "COFF"),
        coloured.replace("OFF", "STCNOFF"),
        plain.replace("3 0 1 2", "3 1 2 3").replace("3 2 3 0", "3 3 4 1"),
    ] {
        assert_eq!(ok("a.off", &text).mesh, mesh, "{text}");
    }
    let from_one = plain.replace("3 0 1 2", "3 1 2 3").replace("3 2 3 0", "3 3 4 1");
    let notes = ok("a.off", from_one).notes;
    assert_eq!(
        notes,
        ["faces number vertices from one, although OFF counts from zero; read that way"]
    );
    let out_of_range = ok("a.off", plain.replace("3 2 3 0", "3 2 3 4"));
    assert_eq!(kinds(&out_of_range)[0], (CornerOutOfRange(ElementKind::Face), 1, Some(8)));
}

#[test]
fn medit_sections_come_in_any_order_and_others_are_skipped() {
    let text = "MeshVersionFormatted\n2\n\nDimension\n3\n\
        Tetrahedra 2\n1 2 3 4 0\n1 2 3 3 0\n\
        Triangles\n1\n1 2 3 7 # a reference\n\
        Normals 2\n0 0 1\n0 nan 1\n\
        Quadrilaterals 1\n1 2 3 4 0\n\
        Edges 1\n1 2 0\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nEnd\nanything\n";
    let read = ok("a.mesh", text);
    let Mesh { positions, faces, curves, tets, .. } = &read.mesh;
    assert_eq!(positions.len(), 4);
    assert_eq!(rows(faces), [vec![0, 1, 2], vec![0, 1, 2, 3]]);
    assert_eq!((rows(curves), &tets[..]), (vec![vec![0, 1]], &[[0, 1, 2, 3]][..]));
    assert_eq!(kinds(&read)[0], (TooFewCorners(ElementKind::Tetrahedron), 1, Some(8)));
    let flat = "MeshVersionFormatted 1\nDimension 2\nVertices 1\n3 4 0\n";
    assert_eq!(ok("a.mesh", flat).mesh.positions, [[3.0, 4.0, 0.0]]);
}

#[test]
fn a_refusal_names_file_line_text_and_what_was_expected() {
    let long = format!("OFF\n1 x{}\n", "y".repeat(500));
    let error = read("roof.off", long.as_bytes()).expect_err("there is no number of faces");
    assert_eq!((error.file.as_str(), error.line), ("roof.off", Some(2)));
    assert!(error.text.len() < 70 && error.text.starts_with("1 xy"), "{}", error.text);
    assert!(error.message.starts_with("expected the number of faces"), "{}", error.message);
}

#[test]
fn solids_that_are_not_read_are_noted() {
    let text = "MeshVersionFormatted 1\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n1 1 1 0\n\
                Hexahedra\n1\n1 2 3 4 1 2 3 4 0\nTriangles 1\n1 2 3 0\nEnd\n";
    let read = ok("a.mesh", text);
    assert_eq!(read.mesh.faces.len(), 1);
    assert_eq!(read.notes, ["Hexahedra ignored: 1, since the only solids read are tetrahedra"]);
}
