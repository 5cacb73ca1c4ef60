//! Every mesh file of foreign origin: what is read, the messages, and what is refused. The files
//! are beside the project; if they are absent, these tests report that they are skipped.

use std::path::PathBuf;

use shape_up::mesh::{
    ElementKind, GroupKeyword, Mesh,
    ProblemKind::{self, *},
    Read, read, write_obj,
};

/// Files of a folder beside the project, sorted by name.
fn files(folder: &str) -> Vec<(String, PathBuf)> {
    let Some(folder) = crate::support::shared::path(folder) else { return Vec::new() };
    let entries = std::fs::read_dir(folder).expect("the folder can be listed");
    let mut files: Vec<_> = entries
        .map(|entry| entry.expect("the folder can be listed").path())
        .filter(|path| {
            path.is_file() && path.extension().is_some_and(|extension| extension != "md")
        })
        .map(|path| (path.file_name().unwrap_or_default().to_string_lossy().into_owned(), path))
        .collect();
    files.sort();
    files
}

fn read_file((name, path): &(String, PathBuf)) -> Result<Read, String> {
    read(name, &std::fs::read(path).expect("the file can be read")).map_err(|e| e.to_string())
}

/// Expected result for an awkward file. By default there is nothing in any field.
#[derive(Clone, Copy, Default)]
struct Expected {
    file: &'static str,
    vertices: usize,
    faces: usize,
    curves: usize,
    /// Statement, name, number of faces and of curves.
    groups: &'static [(&'static str, &'static str, usize, usize)],
    /// Kind, count, first line.
    problems: &'static [(ProblemKind, usize, usize)],
    notes: &'static [&'static str],
    /// The error message if the file is refused.
    refused: &'static str,
}

fn awkward() -> Vec<Expected> {
    let cube = Expected { vertices: 8, faces: 6, ..Expected::default() };
    let none = Expected::default();
    vec![
        Expected {
            file: "assimp_box_UTF16BE.obj",
            groups: &[("o", "1", 6, 0), ("usemtl", "Default", 6, 0)],
            ..cube
        },
        Expected {
            file: "assimp_box_longline.obj",
            faces: 5,
            groups: &[("o", "1", 5, 0), ("usemtl", "Defauli", 5, 0)],
            problems: &[(SelfTouchingFace, 1, 24)],
            ..cube
        },
        Expected {
            file: "assimp_box_without_lineending.obj",
            groups: &[("o", "1", 6, 0), ("usemtl", "Default", 6, 0)],
            ..cube
        },
        Expected {
            // A ring as one polygon: a slit joins its inner and outer outline.
            file: "assimp_concave_polygon.obj",
            vertices: 64,
            problems: &[(SelfTouchingFace, 1, 77)],
            notes: &["66 normal indices ignored"],
            ..none
        },
        Expected {
            file: "assimp_number_formats.obj",
            vertices: 15,
            faces: 1,
            problems: &[(MalformedCoordinate, 6, 11), (UnusedVertex, 12, 4)],
            notes: &["3 vertices lie exactly on an earlier one, first at line 4"],
            ..none
        },
        Expected { file: "assimp_point_cloud.obj", vertices: 3, ..none },
        Expected {
            file: "assimp_testline.obj",
            vertices: 8,
            curves: 6,
            groups: &[("usemtl", "Default", 0, 6)],
            ..none
        },
        Expected {
            file: "assimp_testmixed.obj",
            curves: 6,
            groups: &[("usemtl", "Default", 6, 6)],
            notes: &["24 point elements ignored"],
            ..cube
        },
        Expected {
            file: "cgal_non_manifold_face_graph.off",
            vertices: 24,
            faces: 11,
            notes: &["3 vertices lie exactly on an earlier one, first at line 9"],
            ..none
        },
        Expected {
            file: "compas_boxes.obj",
            vertices: 192,
            faces: 48,
            groups: &[
                ("g", "Group02", 6, 0),
                ("g", "Group03", 6, 0),
                ("g", "Group04", 6, 0),
                ("g", "Group05", 6, 0),
                ("g", "Group06", 6, 0),
                ("g", "Group07", 6, 0),
                ("g", "Group08", 6, 0),
                ("g", "Group01", 6, 0),
            ],
            // Where boxes touch, two faces lie on each other.
            problems: &[(UnjoinedVertex, 70, 9)],
            notes: &["95 vertices lie exactly on an earlier one, first at line 14"],
            ..none
        },
        Expected {
            file: "compas_faces_reversed.obj",
            vertices: 36,
            faces: 25,
            problems: &[(FlippedNeighbour, 10, 40)],
            ..none
        },
        Expected {
            file: "compas_lines.obj",
            vertices: 80,
            curves: 40,
            notes: &["44 vertices lie exactly on an earlier one, first at line 11"],
            ..none
        },
        Expected {
            file: "tinyobj_cube-vertexcol.obj",
            groups: &[
                ("g", "front", 1, 0),
                ("g", "cube", 6, 0),
                ("usemtl", "white", 4, 0),
                ("g", "back", 1, 0),
                ("g", "right", 1, 0),
                ("usemtl", "red", 1, 0),
                ("g", "top", 1, 0),
                ("g", "left", 1, 0),
                ("usemtl", "green", 1, 0),
                ("g", "bottom", 1, 0),
            ],
            notes: &["8 weights or colours of vertices ignored"],
            ..cube
        },
        Expected {
            file: "tinyobj_invalid-face-definition.obj",
            vertices: 8,
            problems: &[(TooFewCorners(ElementKind::Face), 2, 15)],
            ..none
        },
        Expected {
            file: "tinyobj_issue-140-zero-face-idx.obj",
            vertices: 4,
            faces: 1,
            groups: &[("usemtl", "main", 1, 0)],
            problems: &[(CornerZero(ElementKind::Face), 1, 16), (UnusedVertex, 1, 6)],
            notes: &["4 texture indices ignored", "4 normal indices ignored"],
            ..none
        },
        Expected {
            file: "tinyobj_issue-161-inconsistent-f.obj",
            faces: 12,
            groups: &[("o", "cube", 12, 0), ("g", "cube", 12, 0), ("usemtl", "cube", 12, 0)],
            notes: &["33 texture indices ignored"],
            ..cube
        },
        Expected {
            file: "tinyobj_issue-235-usemtl-then-o.obj",
            faces: 2,
            groups: &[
                ("o", "Plane.001", 1, 0),
                ("usemtl", "None", 1, 0),
                ("o", "Plane", 1, 0),
                ("usemtl", "None1", 1, 0),
            ],
            problems: &[(UnusedVertex, 2, 5)],
            notes: &["6 normal indices ignored"],
            ..cube
        },
        Expected {
            file: "tinyobj_leading-decimal-dot-issue-201.obj",
            vertices: 3,
            faces: 1,
            groups: &[("o", "Test", 1, 0), ("usemtl", "default", 1, 0)],
            ..none
        },
        Expected {
            // The group `front_wall` has no face: its only one is commented out.
            file: "tinyobj_no_material.obj",
            vertices: 76,
            faces: 18,
            groups: &[
                ("o", "floor", 3, 0),
                ("o", "light", 1, 0),
                ("o", "ceiling", 1, 0),
                ("o", "back_wall", 1, 0),
                ("o", "green_wall", 1, 0),
                ("o", "red_wall", 1, 0),
                ("o", "short_block", 5, 0),
                ("o", "tall_block", 5, 0),
            ],
            problems: &[(UnusedVertex, 4, 50), (UnjoinedVertex, 44, 43)],
            notes: &["3 vertices lie exactly on an earlier one, first at line 51"],
            ..none
        },
        Expected {
            file: "tinyobj_test-nan.obj",
            vertices: 76,
            faces: 18,
            groups: &[
                ("o", "floor", 3, 0),
                ("usemtl", "white", 15, 0),
                ("o", "light", 1, 0),
                ("usemtl", "light", 1, 0),
                ("o", "ceiling", 1, 0),
                ("o", "back_wall", 1, 0),
                ("o", "green_wall", 1, 0),
                ("usemtl", "green", 1, 0),
                ("o", "red_wall", 1, 0),
                ("usemtl", "red", 1, 0),
                ("o", "short_block", 5, 0),
                ("o", "tall_block", 5, 0),
            ],
            problems: &[
                (NonFiniteCoordinate, 4, 12),
                (UnusedVertex, 4, 57),
                (UnjoinedVertex, 40, 51),
            ],
            notes: &["3 vertices lie exactly on an earlier one, first at line 59"],
            ..none
        },
        Expected {
            file: "tobj_invalid_index.obj",
            vertices: 6,
            faces: 1,
            groups: &[("o", "Triangle1", 1, 0)],
            problems: &[(CornerOutOfRange(ElementKind::Face), 1, 12), (UnusedVertex, 3, 4)],
            ..none
        },
        Expected {
            file: "tobj_lines.obj",
            vertices: 3,
            curves: 3,
            groups: &[("o", "Lines", 0, 3)],
            ..none
        },
        Expected { file: "trimesh_comments.off", notes: &["colours of 6 faces ignored"], ..cube },
        Expected {
            file: "trimesh_empty.obj",
            refused: "trimesh_empty.obj: the file has no vertices: expected at least one, \
                      such as `v 0 0 0` in OBJ",
            ..none
        },
        Expected { file: "trimesh_face_in_group_name.obj", vertices: 1, ..none },
        Expected {
            file: "trimesh_joined_tetrahedra.obj",
            vertices: 5,
            faces: 8,
            groups: &[("o", "bottom", 4, 0)],
            problems: &[(DuplicateFace, 1, 32), (NonManifoldEdge, 3, 32)],
            notes: &["24 normal indices ignored"],
            ..none
        },
        Expected {
            file: "trimesh_negative_indices.obj",
            notes: &["24 texture indices ignored", "24 normal indices ignored"],
            ..cube
        },
        Expected { file: "trimesh_whitespace.off", notes: &["colours of 6 faces ignored"], ..cube },
    ]
}

#[test]
fn every_awkward_file_is_read_as_it_should_be_or_refused() {
    let expected = awkward();
    let files = files("meshes/awkward");
    assert!(files.is_empty() || files.len() >= expected.len(), "a file of the table is gone");
    for file in files {
        let name = &file.0;
        let row = expected.iter().find(|row| row.file == name);
        let row = row.unwrap_or_else(|| panic!("{name} is not in the table of this test"));
        let read = match read_file(&file) {
            Ok(read) => read,
            Err(message) => {
                assert_eq!(message, row.refused);
                continue;
            }
        };
        assert_eq!(row.refused, "", "{name} was read");
        let Mesh { positions, faces, curves, tets, groups, .. } = &read.mesh;
        assert_eq!(
            (positions.len(), faces.len(), curves.len(), tets.len()),
            (row.vertices, row.faces, row.curves, 0),
            "{name}"
        );
        let groups: Vec<_> = groups
            .iter()
            .map(|group| {
                let statement = match group.keyword {
                    GroupKeyword::Object => "o",
                    GroupKeyword::Group => "g",
                    GroupKeyword::Material => "usemtl",
                };
                (statement, &group.name[..], group.faces.len(), group.curves.len())
            })
            .collect();
        assert_eq!(groups, row.groups, "{name}");
        let problems: Vec<_> = read
            .problems
            .iter()
            .map(|problem| (problem.kind, problem.count, problem.line.unwrap_or_default()))
            .collect();
        assert_eq!(problems, row.problems, "{name}");
        assert_eq!(read.notes, row.notes, "{name}");
    }
}

#[test]
fn every_sound_file_is_read_whole_and_without_problems() {
    let counts = [
        ("M2_eq_quad2.obj", 920, 871, 0),
        ("botanic-garden-bubble-0.obj", 1121, 1076, 0),
        ("bunny_poly.obj", 6922, 6920, 0),
        ("camelhead.off", 11381, 22704, 0),
        ("chebyshev_sphere.obj", 441, 400, 0),
        ("cmc1.obj", 272, 240, 0),
        ("compas_faces_big.obj", 4900, 4761, 0),
        ("compas_hypar.obj", 81, 64, 0),
        ("compas_tubemesh.obj", 200, 171, 0),
        ("decimated-knight.off", 502, 1000, 0),
        ("gc_dodecahedron_poly.obj", 20, 12, 0),
        ("halftunnel.off", 831, 784, 0),
        ("hemisphere.obj", 2051, 4000, 0),
        ("horse_quad.obj", 2400, 2398, 0),
        ("igloo.obj", 2129, 4096, 0),
        ("inspired_mesh.obj", 2244, 4288, 0),
        ("octopus-low.mesh", 452, 898, 1140),
        ("pillow_1.obj", 1369, 1296, 0),
        ("rhombitruncated_cubeoctahedron.off", 52, 26, 0),
        ("trimesh_quadknot.obj", 1440, 1440, 0),
    ];
    for file in files("meshes") {
        let Read { mesh, problems, .. } = read_file(&file).expect("a sound file is read");
        assert_eq!(problems, [], "{}", file.0);
        let found = (mesh.positions.len(), mesh.faces.len(), mesh.tets.len());
        match counts.iter().find(|row| row.0 == file.0) {
            Some(&(_, vertices, faces, tets)) => {
                assert_eq!(found, (vertices, faces, tets), "{}", file.0);
            }
            None => assert!(found.0 > 0 && found.1 > 0, "{}", file.0),
        }
    }
}

#[test]
fn every_file_that_is_read_is_the_same_after_it_is_written() {
    for file in files("meshes").into_iter().chain(files("meshes/awkward")) {
        let Ok(Read { mesh, .. }) = read_file(&file) else { continue };
        let text = write_obj(&mesh, &mesh.positions);
        let again = read("again.obj", text.as_bytes()).expect("what we write is read").mesh;
        // What is a guess is a number in the file.
        assert_eq!(again, Mesh { tets: Vec::new(), unplaced: Vec::new(), ..mesh }, "{}", file.0);
    }
}
