//! PLY and STL, the order of an OBJ file, and the table of formats.

use super::operations::{apply, done, with_vertices};
use shape_up::mesh::{
    Edited, ElementKind, FILE_FORMATS, FileFormat, Mesh, ProblemKind, Ragged, Read, read,
    write_obj, write_ply, write_stl,
};

fn ok(name: &str, bytes: impl AsRef<[u8]>) -> Read {
    read(name, bytes.as_ref()).unwrap_or_else(|error| panic!("{error}"))
}

fn refused(name: &str, bytes: impl AsRef<[u8]>) -> String {
    read(name, bytes.as_ref()).expect_err("it is refused").to_string()
}

/// A prism of two quads, a triangle and a pentagon, with a polyline.
fn prism() -> Mesh {
    let text = "v 0 0 0.1\nv 1 0 0\nv 1 1 0\nv 0 1 -0\nv 0.3 0.7 1e-3\nv 2 0 0\nv 2 1 0.25\n\
        f 1 2 3 4\nf 2 6 7 3\nf 4 3 5\nf 1 2 6 7 5\nl 1 2 3\n";
    ok("prism.obj", text).mesh
}

const PLY: &str = "ply\nformat ascii 1.0\ncomment units: mm\nobj_info made by hand\n\
    element vertex 4\nproperty float x\nproperty float y\nproperty uchar red\nproperty double z\n\
    element material 1\nproperty int shine\n\
    element face 2\nproperty list uchar int vertex_indices\nproperty uchar flag\n\
    element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n\
    0 0 255 0\n1 0 255 0\n1 1 0 0.5\n0 1 0 0\n7\n4 0 1 2 3 9\n3 0 1 2 9\n0 2\n";

#[test]
fn ply_as_text_has_its_vertices_faces_and_edges() {
    let Read { mesh, problems, notes, .. } = ok("a.ply", PLY);
    assert_eq!(
        mesh.positions,
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.0]]
    );
    assert_eq!(mesh.faces, Ragged::from_iter([&[0, 1, 2, 3][..], &[0, 1, 2]]));
    assert_eq!(mesh.curves, Ragged::from_iter([[0, 2]]));
    assert!(problems.iter().all(|problem| problem.line.is_some()), "{problems:?}");
    assert_eq!(notes, ["ignored: red of vertex, element material, flag of face"]);
    // The name says nothing: the content does. Line ends may be of Windows, and a mark of UTF-8 before.
    assert_eq!(ok("a", PLY.replace('\n', "\r\n")).mesh, mesh);
    assert_eq!(ok("a.ply", format!("\u{feff}{PLY}")).mesh, mesh);
}

/// The same as [`PLY`], binary.
fn binary_ply(is_little: bool) -> Vec<u8> {
    let (head, _) = PLY.split_once("end_header\n").unwrap();
    let name = if is_little { "binary_little_endian" } else { "binary_big_endian" };
    let mut out = (head.replace("ascii", name) + "end_header\n").into_bytes();
    let mut push = |mut bytes: Vec<u8>| {
        if !is_little {
            bytes.reverse();
        }
        out.extend(bytes);
    };
    for (x, y, red, z) in
        [(0f32, 0f32, 255u8, 0f64), (1.0, 0.0, 255, 0.0), (1.0, 1.0, 0, 0.5), (0.0, 1.0, 0, 0.0)]
    {
        push(x.to_le_bytes().to_vec());
        push(y.to_le_bytes().to_vec());
        push(vec![red]);
        push(z.to_le_bytes().to_vec());
    }
    push(7i32.to_le_bytes().to_vec());
    for face in [&[0i32, 1, 2, 3][..], &[0, 1, 2]] {
        push(vec![face.len() as u8]);
        face.iter().for_each(|v| push(v.to_le_bytes().to_vec()));
        push(vec![9]);
    }
    [0i32, 2].iter().for_each(|v| push(v.to_le_bytes().to_vec()));
    out
}

#[test]
fn binary_ply_is_the_same_mesh_in_either_order_of_bytes() {
    let text = ok("a.ply", PLY);
    for is_little in [true, false] {
        let bytes = binary_ply(is_little);
        let found = ok("a.ply", &bytes);
        assert_eq!(found.mesh, text.mesh);
        assert_eq!(found.notes, text.notes);
        for end in [bytes.len() - 1, bytes.len() - 30, bytes.len() - 60] {
            let found = refused("a.ply", &bytes[..end]);
            assert!(found.starts_with("a.ply: the file ends where "), "{found}");
        }
        // More than the header says is not a part of it; a line end is nothing.
        assert_eq!(ok("a.ply", [&bytes[..], b"\n"].concat()).notes, text.notes);
        let found = ok("a.ply", [&bytes[..], b"4\0\0\0"].concat());
        assert_eq!(found.mesh, text.mesh);
        assert_eq!(found.notes[0], "ignored: 4 bytes after the last element");
        // The header of a binary file is text.
        let at = bytes.windows(5).position(|word| word == b"float").unwrap();
        let found = refused("a.ply", [&bytes[..at], b"halfs", &bytes[at + 5..]].concat());
        assert!(found.starts_with("a.ply:6: `property halfs x`: expected a type"), "{found}");
    }
}

#[test]
fn a_number_after_a_header_of_lines_that_end_in_cr_may_begin_like_lf() {
    // The first byte of the first coordinate, 10, was taken for the rest of the line end.
    let head = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n\
        property float y\nproperty float z\nend_header\n";
    let x = f32::from_bits(0x3F80_000A);
    let numbers = [x, 0.0, 0.0].map(f32::to_le_bytes).concat();
    for end in ["\n", "\r", "\r\n"] {
        let bytes = [head.replace('\n', end).as_bytes(), &numbers].concat();
        assert_eq!(ok("a.ply", bytes).mesh.positions, [[f64::from(x), 0.0, 0.0]], "{end:?}");
    }
    // Some writers end the last line of a header otherwise than the first.
    let mixed = head.replace("end_header\n", "end_header\r\n");
    let found = ok("a.ply", [mixed.as_bytes(), &numbers].concat()).mesh;
    assert_eq!(found.positions, [[f64::from(x), 0.0, 0.0]]);
}

#[test]
fn ply_that_is_wrong_is_refused_with_its_line() {
    for (from, to, message) in [
        ("format ascii 1.0\n", "", "a.ply: the header has no `format`"),
        (
            "format ascii",
            "format binary",
            "a.ply:2: `format binary 1.0`: expected the format ascii",
        ),
        ("property float x", "property number x", "a.ply:6: `property number x`: expected a type"),
        ("end_header\n", "end\n", "a.ply:18: `end`: expected a line of a PLY header"),
        ("4 0 1 2 3 9", "-4 0 1 2 3 9", "a.ply:24: `-4 0 1 2 3 9`: expected the length of a list"),
        ("ply\n", "plain\n", "a.ply: this is no PLY file"),
        // Rows have other values than the header says, or there are more of them.
        (
            "property uchar red\n",
            "",
            "a.ply:24: `3 0 1 2 9`: the file goes on after its last element",
        ),
        (
            "element edge 1",
            "element edge 0",
            "a.ply:26: `0 2`: the file goes on after its last element",
        ),
    ] {
        let found = refused("a.ply", PLY.replacen(from, to, 1));
        assert!(found.starts_with(message), "{found}");
    }
    let none = "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n\
        property float z\nend_header\n";
    assert_eq!(refused("a.ply", none), "a.ply: the file has no vertices: expected at least one");
    assert!(refused("a.obj", "g a\n").contains("at least one, such as `v 0 0 0` in OBJ"));
    let found = ok("a.ply", PLY.replace("3 0 1 2 9", "3 0 1 8 9"));
    assert_eq!(found.problems[0].kind, ProblemKind::CornerOutOfRange(ElementKind::Face));
    assert_eq!(found.problems[0].line, Some(25));
    let found = ok("a.ply", PLY.replace("1 0 255 0", "nan 0 255 0"));
    assert_eq!(found.mesh.unplaced, [1]);
    assert_eq!((found.problems[0].line, &*found.problems[0].text), (Some(20), "nan 0 255 0"));
}

#[test]
fn a_mesh_comes_back_from_ply_bit_for_bit() {
    let mesh = prism();
    let bytes = write_ply(&mesh, &mesh.positions, &["units: m".to_owned()]);
    let found = ok("prism.ply", &bytes);
    assert_eq!(found.mesh.positions, mesh.positions);
    assert_eq!(found.mesh.faces, mesh.faces);
    // A polyline becomes its edges.
    assert_eq!(found.mesh.curves, Ragged::from_iter([[0, 1], [1, 2]]));
    // A face of more corners than a byte counts.
    let corners: Vec<u32> = (0..300).collect();
    let at = |k: u32| [libm::cos(f64::from(k)), libm::sin(f64::from(k)), 0.0];
    let round = Mesh {
        positions: corners.iter().map(|&k| at(k)).collect(),
        faces: [corners].into_iter().collect(),
        ..Mesh::default()
    };
    assert_eq!(ok("a.ply", write_ply(&round, &round.positions, &[])).mesh.faces, round.faces);
}

const STL: &str = "solid left\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n\
    vertex 1 1 0\nendloop\nendfacet\nendsolid left\nsolid right\nfacet normal 0 0 1\nouter loop\n\
    vertex 0 0 -0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid right\n";

#[test]
fn corners_of_stl_at_one_place_are_one_vertex() {
    let Read { mesh, problems, notes, .. } = ok("a.stl", STL);
    assert_eq!(
        mesh.positions,
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]
    );
    assert_eq!(mesh.faces, Ragged::from_iter([[0, 1, 2], [0, 2, 3]]));
    let groups: Vec<_> = mesh.groups.iter().map(|group| (&*group.name, &*group.faces)).collect();
    assert_eq!(groups, [("left", &[0][..]), ("right", &[1])]);
    assert_eq!(problems, []);
    assert_eq!(notes, ["STL has no common vertices: 6 corners are 4 vertices"]);
    assert_eq!(ok("unnamed", STL).mesh, mesh);
    // Solids of one name are one object.
    let third = STL[..STL.find("solid right").unwrap()].replace("1 1 0", "0 -1 0");
    let Read { mesh, notes, .. } = ok("a.stl", STL.to_owned() + &third);
    let groups: Vec<_> = mesh.groups.iter().map(|group| (&*group.name, &*group.faces)).collect();
    assert_eq!(groups, [("left", &[0, 2][..]), ("right", &[1])]);
    let note = "1 name stands for several groups of the file, which are one group each here: left";
    assert_eq!(notes[0], note);
    // Beside solids without a name, one of a name is an object; one that is the whole mesh is not.
    let Read { mesh, notes, .. } = ok("a.stl", STL.replace("right", ""));
    assert_eq!(mesh.groups.iter().map(|group| &*group.faces).collect::<Vec<_>>(), [[0]]);
    assert_eq!(notes.len(), 1);
    assert_eq!(ok("a.stl", STL.replace("right", "left")).mesh.groups, []);
    // A triangle without a side is said.
    let found = ok("a.stl", STL.replace("vertex 0 1 0", "vertex 1 1 0"));
    assert_eq!(found.problems[0].kind, ProblemKind::TooFewCorners(ElementKind::Face));
    let found = refused("a.stl", STL.split_at(STL.len() - 40).0);
    assert_eq!(found, "a.stl: the file ends within a triangle: it is not whole");
    // Between two triangles it may be whole, or not.
    for end in [STL.rfind("endsolid"), STL.find("endsolid"), STL.rfind("outer")] {
        let notes = ok("a.stl", &STL[..end.unwrap()]).notes;
        assert_eq!(notes[0], "the file does not end with `endsolid`: more may be missing");
    }
}

#[test]
fn binary_stl_is_read_whatever_its_header_says_and_only_if_it_is_whole() {
    let mesh = prism();
    let mut bytes = write_stl(&mesh, &mesh.positions);
    assert_eq!(bytes.len(), 84 + 50 * 8);
    for header in ["Shape-Up", "solid a "] {
        bytes[..8].copy_from_slice(header.as_bytes());
        let found = ok("a.stl", &bytes);
        assert_eq!((found.mesh.positions.len(), found.mesh.faces.len()), (7, 8));
        let known =
            |p: &[f64; 3]| mesh.positions.iter().any(|q| q.map(|x| f64::from(x as f32)) == *p);
        assert!(found.mesh.positions.iter().all(known));
        assert_eq!(ok("a.stl", [&bytes[..], &[0; 2]].concat()).mesh, found.mesh);
        let found = refused("a.stl", &bytes[..bytes.len() - 1]);
        assert!(found.starts_with("a.stl: the file ends after 7 of 8 triangles"), "{found}");
    }
    assert!(refused("a.stl", "v 0 0 0").starts_with("a.stl: this is no STL file"));
}

#[test]
fn a_polygon_with_a_notch_becomes_triangles_that_cover_it() {
    let text = "v 0 0 0\nv 4 0 0\nv 4 3 0\nv 2 1 0\nv 0 3 0\nf 1 2 3 4 5\n";
    let mesh = ok("a.obj", text).mesh;
    let found = ok("a.stl", write_stl(&mesh, &mesh.positions)).mesh;
    let area = |face: &[u32]| {
        let [a, b, c] = [0, 1, 2].map(|k| found.positions[face[k] as usize]);
        0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    };
    let areas: Vec<f64> = found.faces.iter().map(area).collect();
    assert!(areas.iter().all(|area| *area > 0.0), "{areas:?}");
    assert_eq!(areas.iter().sum::<f64>(), 8.0);
}

#[test]
fn stl_keeps_a_mesh_for_which_single_precision_is_too_little() {
    let mesh = prism();
    for (scale, offset) in [(0.1, 2.7e6), (1e-47, 0.0), (1e39, 0.0)] {
        let placed: Vec<_> = mesh.positions.iter().map(|p| p.map(|x| scale * x + offset)).collect();
        let bytes = write_stl(&mesh, &placed);
        let found = ok("a.stl", &bytes);
        assert_eq!((found.mesh.positions.len(), found.mesh.faces.len()), (7, 8), "{offset}");
        assert!(found.mesh.positions.iter().all(|p| placed.contains(p)), "{offset}");
        assert_eq!(found.notes, ["STL has no common vertices: 24 corners are 7 vertices"]);
    }
}

/// A file with all that a writer without its order would lose.
const FULL: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.2 0.2 0\nv 0.2 0.8 0\nv 0.8 0.8 0\n\
    mtllib roof.mtl\ng empty\no one\ng a\ns 1\nusemtl Wood\\\nf 1 2 3\nl 1 2\ng b\ns off\nf 1 3 4\n\
    g a\nf 1 2 3 4 1 5 6 7 5\nusemtl glass\nf 1 2 4\no one\nl 3 4\ng last\n";

#[test]
fn an_obj_file_comes_out_as_it_came() {
    let Read { mesh, notes, .. } = ok("full.obj", FULL);
    assert_eq!(write_obj(&mesh, &mesh.positions), FULL);
    let said = "1 name stands for several groups of the file, which are one group each here: a";
    assert!(notes.iter().any(|note| note == said), "{notes:?}");
    // With other positions too; not if the faces are others.
    let moved: Vec<_> = mesh.positions.iter().map(|p| [p[0] + 1.0, p[1], p[2]]).collect();
    let tail = |text: &str| text.lines().skip(7).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(tail(&write_obj(&mesh, &moved)), tail(FULL));
    let mut other = mesh.clone();
    other.groups.pop();
    let out = write_obj(&other, &other.positions);
    assert!(!out.contains("s off") && out.contains("\nf 1 2 3 4 1 5 6 7 5\n"), "{out}");
}

#[test]
fn an_edit_that_keeps_all_elements_keeps_the_statements_between_them() {
    let mesh = ok("full.obj", FULL).mesh;
    let words = |text: &str| -> Vec<String> {
        let lines = text.lines().filter(|line| !line.starts_with('v'));
        // Of a face, whose corners may have turned, the statement only.
        lines.map(|line| if line.starts_with('f') { "f" } else { line }.to_owned()).collect()
    };
    let after = |mut edited: Edited| {
        edited.origins.carry(&mesh, &mut edited.mesh);
        words(&write_obj(&edited.mesh, &edited.mesh.positions))
    };
    assert_eq!(after(done(&mesh, "flip")), words(FULL));
    // A face becomes an edge.
    let merged = apply(&mesh, "merge-vertices", None, &with_vertices(&[2, 3])).unwrap();
    assert!(!after(merged).contains(&"s off".to_owned()));
}

#[test]
fn a_face_that_visits_a_vertex_twice_is_left_as_it_is_and_its_vertices_are_used() {
    let Read { mesh, problems, .. } = ok("full.obj", FULL);
    assert_eq!(mesh.untouched, Ragged::from_iter([[0, 1, 2, 3, 0, 4, 5, 6, 4]]));
    assert!(problems.iter().all(|problem| problem.kind != ProblemKind::UnusedVertex));
    let said = problems.iter().find(|problem| problem.kind == ProblemKind::SelfTouchingFace);
    assert_eq!(
        said.unwrap().to_string(),
        "1 face with the same vertex at two corners, as around a hole: exported unchanged and, as \
         panels with holes, built, but neither shown nor solved, at line 20: `f 1 2 3 4 1 5 6 7 5`"
    );
    // It was missing from PLY and STL.
    let ply = read("full.ply", &write_ply(&mesh, &mesh.positions, &[])).unwrap().mesh;
    assert_eq!(ply.untouched, mesh.untouched);
    let triangles = |mesh: &Mesh| {
        let stl = read("full.stl", &write_stl(mesh, &mesh.positions)).unwrap().mesh;
        stl.faces.len() + stl.untouched.len()
    };
    // Its coordinates count, too, where single precision is too little.
    let at_site = mesh.positions.iter().map(|p| [p[0] + 2_679_500.13, p[1], p[2]]).collect();
    let alone = Mesh { faces: Ragged::new(), positions: at_site, ..mesh.clone() };
    assert!(write_stl(&alone, &alone.positions).starts_with(b"solid"));
    let without = Mesh { untouched: Ragged::new(), ..mesh.clone() };
    assert_eq!(triangles(&mesh), triangles(&without) + 7);
}

#[test]
fn a_file_that_ends_within_a_line_says_so() {
    let whole = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 4 3 2 1";
    let cut = |text: &str| {
        let found = ok("a.obj", text).problems;
        found.into_iter().find(|problem| problem.kind == ProblemKind::CutOff)
    };
    assert_eq!(cut(whole), None);
    assert_eq!(cut(&format!("{whole}\nf 1 2\n")), None, "a line that is whole and wrong");
    assert_eq!(cut(&format!("{whole}\nf 1 2 3 1 4 2")), None, "a face that is left as it is");
    assert_eq!(cut(&format!("{whole}\nv 1,5 2 3")), None, "a decimal comma");
    for (end, line) in [("\nf 1 2", 7), ("\nf 1 2 3", 7), ("\nv 1 2", 7), ("\nv 1 2 -", 7)] {
        let found = cut(&format!("{whole}{end}")).unwrap_or_else(|| panic!("{end:?} is cut off"));
        let said = found.to_string();
        assert_eq!(found.line, Some(line));
        let words =
            "1 line perhaps cut off by the end of the file: more may be missing, at line 7: ";
        assert!(said.starts_with(words), "{said}");
    }
}

#[test]
fn the_table_has_what_is_read_and_written() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let off = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
    let medit = "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n\
        Quadrilaterals\n1\n1 2 3 4 0\nEnd\n";
    let mesh = ok("a.obj", square).mesh;
    for format in FILE_FORMATS {
        for ending in format.endings {
            assert_eq!(
                FileFormat::of_name(&format!("a.b.{}", ending.to_uppercase())),
                Some(format)
            );
        }
        assert!(!format.leaves_out.is_empty() || format.endings == ["json"]);
        let name = format!("a.{}", format.endings[0]);
        let bytes = match format.endings[0] {
            "off" => off.into(),
            "mesh" => medit.into(),
            "ply" => write_ply(&mesh, &mesh.positions, &[]),
            "stl" => write_stl(&mesh, &mesh.positions),
            _ => square.as_bytes().to_vec(),
        };
        if format.is_mesh() {
            assert_eq!(ok(&name, bytes).mesh.positions.len(), 4, "{name}");
        }
    }
    let table = FileFormat::table();
    assert!(table.contains(" PLY, .ply\n   read: vertices, polygons, edges; text and binary\n"));
    let message = refused("a.xyz", "1 2 3");
    assert_eq!(
        message,
        "a.xyz: the format is not known; expected a file in the format .obj, .off, .mesh, .ply or .stl"
    );
}

#[test]
fn off_and_medit_are_read_however_their_numbers_are_laid_on_lines() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 2.0]];
    let rows = |start: &str, between: &str, end: &str| {
        let row = |c: &[f64; 3]| format!("{} {} {}{end}", c[0], c[1], c[2]);
        start.to_owned() + &corners.iter().map(row).collect::<Vec<_>>().join(between)
    };
    // The number of edges on its own line was taken for the first coordinate.
    let off = rows("OFF\n4 1\n4\n", "\n", "") + "\n4 0 1 2 3\n";
    let apart = rows("OFF\n4\n1\n# edges\n\n4\n", "\n", "") + "\n4 0 1 2 3\n";
    // Every second vertex was lost, or what followed was shifted by a reference.
    let head = "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n";
    let faces = "\nTriangles\n2\n1 2 3 0 1 3 4 0\nEnd\n";
    let usual = "\nTriangles\n2\n1 2 3 0\n1 3 4\n0\nEnd\n";
    let medit = [
        rows(head, "\n", " 0") + usual,
        rows(head, " ", " 0") + faces,
        rows(head, "\n", "\n0") + faces,
        // Without references, and with more numbers than the format has.
        rows(head, "\n", "") + "\nTriangles\n2\n1 2 3\n1 3 4\nEnd\n",
        rows(head, "\n", " 0 7") + usual,
        rows(head, " ", " 0") + &faces.replace('\n', " "),
    ];
    let files = [("a.off", off), ("b.off", apart)].into_iter();
    for (name, text) in files.chain(medit.map(|text| ("c.mesh", text))) {
        let read = read(name, text.as_bytes()).expect("it is a mesh");
        assert_eq!(read.mesh.positions, corners, "{text}");
        let sizes: usize = read.mesh.faces.iter().map(<[u32]>::len).sum();
        assert_eq!(sizes, if name == "c.mesh" { 6 } else { 4 }, "{text}");
        assert!(read.notes.is_empty() && read.problems.is_empty(), "{text}");
    }
}
