//! The file formats of models: what is read, what is written, and what is left out.

use crate::mesh::{Mesh, Ragged};
use crate::words::count;
use std::collections::BTreeSet;

/// A part of a mesh that not every format can store.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshPart {
    /// Vertices of no face and no curve.
    LoneVertices,
    /// Faces of more than four corners.
    LargeFaces,
    /// [`Mesh::curves`].
    Curves,
    /// Curves of more than one segment, where each segment is kept for itself.
    Polylines,
    /// [`Mesh::groups`].
    Groups,
    /// [`Mesh::tets`].
    Tetrahedra,
    /// [`Mesh::untouched`].
    FacesWithHoles,
}

impl MeshPart {
    /// One and many of them.
    fn words(self) -> [&'static str; 2] {
        match self {
            MeshPart::LoneVertices => ["vertex without a face", "vertices without a face"],
            MeshPart::LargeFaces => {
                ["face of more than four corners", "faces of more than four corners"]
            }
            MeshPart::Curves => ["curve", "curves"],
            MeshPart::Polylines => ["whole polyline", "whole polylines"],
            MeshPart::Groups => ["group", "groups"],
            MeshPart::Tetrahedra => ["tetrahedron", "tetrahedra"],
            MeshPart::FacesWithHoles => ["face with a hole", "faces with holes"],
        }
    }

    /// The number of them in a mesh.
    fn count(self, mesh: &Mesh) -> usize {
        match self {
            MeshPart::LoneVertices => {
                let used = [&mesh.faces, &mesh.untouched, &mesh.curves].map(Ragged::indices);
                mesh.positions.len() - used.into_iter().flatten().collect::<BTreeSet<_>>().len()
            }
            MeshPart::LargeFaces => mesh.faces.iter().filter(|face| face.len() > 4).count(),
            MeshPart::Curves => mesh.curves.len(),
            MeshPart::Polylines => mesh.curves.iter().filter(|curve| curve.len() > 2).count(),
            MeshPart::Groups => mesh.groups.len(),
            MeshPart::Tetrahedra => mesh.tets.len(),
            MeshPart::FacesWithHoles => mesh.untouched.len(),
        }
    }
}

/// A file format of models.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FileFormat {
    /// Endings of file names, without the dot.
    pub endings: &'static [&'static str],
    /// Its name.
    pub name: &'static str,
    /// What is read; empty if it is not read.
    pub reads: &'static str,
    /// What is written; empty if it is not written.
    pub writes: &'static str,
    /// What is left out, or what to do instead.
    pub leaves_out: &'static str,
    /// The parts of a mesh that it cannot store.
    #[serde(skip)]
    pub lacks: &'static [MeshPart],
    /// Whether unit and up axis are stated in its files.
    #[serde(skip)]
    pub states_frame: bool,
    /// Whether only the page reads and writes it, not the command line.
    pub on_page_only: bool,
}

const NONE: FileFormat = FileFormat {
    endings: &[],
    name: "",
    reads: "",
    writes: "",
    leaves_out: "",
    lacks: &[],
    states_frame: false,
    on_page_only: false,
};

/// Every format that hosts know of, those that are read first.
pub const FILE_FORMATS: &[FileFormat] = &[
    FileFormat {
        endings: &["obj"],
        name: "Wavefront OBJ",
        reads: "vertices, polygons, polylines, groups, objects, material names",
        writes: "the same, in the order and with the statements of the file; flat maps",
        leaves_out: "texture coordinates, normals, colours, curved surfaces; tetrahedra when written",
        lacks: &[MeshPart::Tetrahedra],
        states_frame: true,
        ..NONE
    },
    FileFormat {
        endings: &["off"],
        name: "OFF",
        reads: "vertices, polygons",
        leaves_out: "colours, normals",
        ..NONE
    },
    FileFormat {
        endings: &["mesh"],
        name: "Medit",
        reads: "vertices, triangles, quads, tetrahedra, edges",
        writes: "vertices, triangles, quads, tetrahedra, edges of curves (command line)",
        leaves_out: "binary; faces of more than four corners, faces with holes, groups, whole polylines when written",
        lacks: &[
            MeshPart::LargeFaces,
            MeshPart::Polylines,
            MeshPart::Groups,
            MeshPart::FacesWithHoles,
        ],
        ..NONE
    },
    FileFormat {
        endings: &["ply"],
        name: "PLY",
        reads: "vertices, polygons, edges; text and binary",
        writes: "vertices, polygons, edges of curves; binary, in double precision",
        leaves_out: "colours, normals, triangle strips; groups, tetrahedra and whole polylines when written",
        lacks: &[MeshPart::Groups, MeshPart::Tetrahedra, MeshPart::Polylines],
        states_frame: true,
        ..NONE
    },
    FileFormat {
        endings: &["stl"],
        name: "STL",
        reads: "triangles, joined where their corners are equal; text and binary",
        writes: "polygons as triangles; binary, in single precision, or text where that is too little",
        leaves_out: "everything else, as vertices without a face, curves, groups and tetrahedra",
        lacks: &[MeshPart::LoneVertices, MeshPart::Curves, MeshPart::Groups, MeshPart::Tetrahedra],
        ..NONE
    },
    FileFormat {
        endings: &["3dm"],
        name: "Rhino",
        reads: "meshes, polylines, instances of blocks, layers",
        writes: "meshes, polylines, layers, parts to build",
        leaves_out: "surfaces and solids: convert them with Rhino's Mesh command",
        on_page_only: true,
        ..NONE
    },
    FileFormat {
        endings: &["json"],
        name: "Scene",
        reads: "everything",
        writes: "everything",
        ..NONE
    },
    FileFormat {
        endings: &["glb", "gltf"],
        name: "glTF",
        writes: "parts to build (.glb)",
        leaves_out: "not read: export OBJ or PLY instead",
        ..NONE
    },
    FileFormat {
        endings: &[
            "fbx", "dae", "3ds", "blend", "skp", "dwg", "dxf", "step", "stp", "iges", "igs", "ifc",
        ],
        name: "Other programs",
        leaves_out: "not read: export a mesh as OBJ or PLY instead",
        ..NONE
    },
];

impl FileFormat {
    /// The format of a file, by the ending of its name.
    pub fn of_name(name: &str) -> Option<&'static FileFormat> {
        let (_, ending) = name.rsplit_once('.')?;
        let is_it = |known: &&str| known.eq_ignore_ascii_case(ending);
        FILE_FORMATS.iter().find(|format| format.endings.iter().any(is_it))
    }

    /// Counts each kind of parts of a mesh that it cannot store, in words.
    pub fn cannot_store(&self, mesh: &Mesh) -> Vec<String> {
        let parts = self.lacks.iter().map(|part| (part.count(mesh), part.words()));
        let parts = parts.filter(|(number, _)| *number > 0);
        parts.map(|(number, [one, many])| count(number, one, many)).collect()
    }

    /// Whether it is the format of a mesh that the reader of mesh files reads.
    pub fn is_mesh(&self) -> bool {
        !self.reads.is_empty() && !self.on_page_only && self.endings != ["json"]
    }

    /// The endings of the mesh files that are written, without the dot.
    pub fn written_meshes() -> Vec<&'static str> {
        let written = FILE_FORMATS.iter().filter(|it| it.is_mesh() && !it.writes.is_empty());
        written.map(|format| format.endings[0]).collect()
    }

    /// One line for each format, in columns.
    pub fn table() -> String {
        let line = |format: &FileFormat| {
            let endings: Vec<String> = format.endings.iter().map(|one| format!(".{one}")).collect();
            let host = if format.on_page_only { " (page)" } else { "" };
            let parts =
                [("read", format.reads), ("written", format.writes), ("not", format.leaves_out)];
            let said = parts.iter().filter(|(_, words)| !words.is_empty());
            let said: Vec<String> = said.map(|(what, words)| format!("{what}: {words}")).collect();
            format!(" {}, {}{host}\n   {}", format.name, endings.join(" "), said.join("\n   "))
        };
        FILE_FORMATS.iter().map(line).collect::<Vec<_>>().join("\n")
    }
}

/// The endings of mesh files, for messages: `.obj, .off or .stl`.
pub(crate) fn mesh_endings() -> String {
    let formats = FILE_FORMATS.iter().filter(|format| format.is_mesh());
    let mut endings: Vec<String> =
        formats.map(|format| format!(".{}", format.endings[0])).collect();
    let last = endings.pop().unwrap_or_default();
    format!("{} or {last}", endings.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_format_lacks_is_said_where_formats_are_listed() {
        for format in FILE_FORMATS {
            for part in format.lacks {
                let [_, many] = part.words();
                assert!(format.leaves_out.contains(many), "{}: {many}", format.name);
            }
        }
        let mesh = Mesh {
            positions: vec![[0.0; 3]; 6],
            faces: [[0, 1, 2, 3, 4]].into_iter().collect(),
            curves: [&[0, 5][..], &[5, 0, 1]].into_iter().collect(),
            untouched: [[0, 1, 2, 1], [2, 3, 4, 3]].into_iter().collect(),
            ..Mesh::default()
        };
        let said = |name: &str| {
            FileFormat::of_name(name).expect("it is known").cannot_store(&mesh).join(", ")
        };
        assert_eq!(
            said("a.mesh"),
            "1 face of more than four corners, 1 whole polyline, 2 faces with holes"
        );
        assert_eq!(said("a.ply"), "1 whole polyline");
        // Points of curves are lost with these.
        assert_eq!(said("a.stl"), "2 curves");
    }
}
