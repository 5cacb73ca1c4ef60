//! The file formats of models: what is read, what is written, and what is left out.

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
    /// Whether only the page reads and writes it, not the command line.
    pub on_page_only: bool,
}

const NONE: FileFormat = FileFormat {
    endings: &[],
    name: "",
    reads: "",
    writes: "",
    leaves_out: "",
    on_page_only: false,
};

/// Every format that hosts know of, those that are read first.
pub const FILE_FORMATS: &[FileFormat] = &[
    FileFormat {
        endings: &["obj"],
        name: "Wavefront OBJ",
        reads: "vertices, polygons, polylines, groups, objects, material names",
        writes: "the same, in the order and with the statements of the file; flat maps",
        leaves_out: "texture coordinates, normals, colours, curved surfaces",
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
        writes: "vertices, triangles, quads, tetrahedra (command line)",
        leaves_out: "binary files; larger polygons, curves and groups when written",
        ..NONE
    },
    FileFormat {
        endings: &["ply"],
        name: "PLY",
        reads: "vertices, polygons, edges; text and binary",
        writes: "vertices, polygons, edges of curves; binary, in double precision",
        leaves_out: "colours, normals, triangle strips; groups and tetrahedra when written",
        ..NONE
    },
    FileFormat {
        endings: &["stl"],
        name: "STL",
        reads: "triangles, joined where their corners are equal; text and binary",
        writes: "polygons as triangles; binary, in single precision, or text where that is too little",
        leaves_out: "everything else",
        ..NONE
    },
    FileFormat {
        endings: &["3dm"],
        name: "Rhino",
        reads: "meshes, polylines, instances of blocks, layers",
        writes: "meshes, polylines, layers, parts to build",
        leaves_out: "surfaces and solids: convert them with Rhino's Mesh command",
        on_page_only: true,
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

    /// Whether it is the format of a mesh that the reader of mesh files reads.
    pub fn is_mesh(&self) -> bool {
        !self.reads.is_empty() && !self.on_page_only && self.endings != ["json"]
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
