//! Reading a file that the user opens: a mesh with its new scene, or a scene with its mesh.

use crate::mesh::{Mesh, Read, ReadError, Weld, read};
use crate::scene::{MeshSource, Pose, Scene, SceneError, Target, UnitsAndUp};
use std::path::Path;

/// Reads the files that the user opens.
#[derive(Default)]
pub struct FileReader {
    /// Files that the next scene refers to, by their paths in it.
    beside: Vec<(String, Vec<u8>)>,
}

/// A file that was read.
pub struct OpenedFile {
    /// The scene, whose mesh is `mesh`.
    pub scene: Scene,
    /// The mesh; welded if its faces had their own copies of vertices.
    pub mesh: Mesh,
    /// How it was welded, if it was.
    pub weld: Option<Weld>,
    /// Problems and notes of the mesh reader; its mesh is empty.
    pub diagnostics: Read,
    /// Which of unit and axis the file does not state.
    pub guessed: Guessed,
}

/// Properties that a file does not state, so that they are guesses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Guessed {
    /// The unit of length.
    pub units: bool,
    /// The vertical axis.
    pub up: bool,
}

impl FileReader {
    /// Adds a file for the next scene, by its path in the scene: see [`named_files`].
    pub fn add_file(&mut self, path: &str, bytes: Vec<u8>) {
        self.beside.push((path.to_owned(), bytes));
    }

    /// Reads the file `name`: a mesh, or a scene (`.json`) with the files added before. A mesh has the
    /// unit and axis of `frame` if its file states none; it is welded if its faces have their own copies
    /// of vertices, unless it shall stay `unwelded`.
    ///
    /// # Errors
    /// The problem of the file, with its name and the line or the JSON path.
    pub fn read(
        &mut self,
        name: &str,
        bytes: &[u8],
        frame: UnitsAndUp,
        unwelded: bool,
    ) -> Result<OpenedFile, ReadError> {
        // Those that were added are for this file, also if it is refused.
        let files = std::mem::take(self);
        if is_scene(name) {
            let scene = OpenedFile::scene_in(bytes);
            let scene = scene.map_err(|error| fault(name, error.to_string()))?;
            return files.scene_with_files(name, scene);
        }
        let stated = UnitsAndUp::stated(bytes).or(frame);
        Ok(OpenedFile::of_mesh(name, read(name, bytes)?, stated, unwelded))
    }

    /// Inserts the files added before into the scene of the file `name`.
    ///
    /// # Errors
    /// If one was not added, or the problem of one, with its name beside that of the scene.
    pub fn scene_with_files(self, name: &str, mut scene: Scene) -> Result<OpenedFile, ReadError> {
        let named = |path: &str| {
            let (_, bytes) =
                self.beside.iter().find(|(other, _)| other == path).ok_or_else(|| {
                    fault(name, format!("it needs the mesh file {path}: open both files together"))
                })?;
            let full = Path::new(name).with_file_name(path);
            Ok::<_, ReadError>((read(&full.to_string_lossy(), bytes)?, UnitsAndUp::stated(bytes)))
        };
        let (mut source, own) =
            match std::mem::replace(&mut scene.mesh, MeshSource::File(String::new())) {
                MeshSource::Inline(mesh) => {
                    let read = Read { mesh: *mesh, ..Read::default() };
                    (read, UnitsAndUp::default())
                }
                MeshSource::File(path) => {
                    let (source, stated) = named(&path)?;
                    scene.mesh = MeshSource::File(path);
                    stated.clone().complete(&mut scene);
                    (source, stated)
                }
            };
        let of_scene = |error: SceneError| fault(name, error.to_string());
        let second = |path: &str| {
            let (read, stated) = named(path)?;
            stated.check_second(path, &own, &scene).map_err(of_scene)?;
            Ok::<_, ReadError>(read)
        };
        let target = scene.closeness.file_to_read().map(second).transpose()?;
        let pose = match &scene.pose {
            Some(Pose::File(path)) => {
                Some(Pose::of(path, second(path)?, &source.mesh).map_err(of_scene)?)
            }
            _ => None,
        };
        if let Some(target) = target {
            scene.closeness.target = Some(Target::Mesh(target.mesh.into()));
        }
        scene.pose = pose.or(scene.pose);
        let mesh = std::mem::take(&mut source.mesh);
        // The indices in a scene refer to its mesh as it is, so nothing is welded.
        Ok(OpenedFile { scene, mesh, weld: None, diagnostics: source, guessed: Guessed::default() })
    }
}

/// The error of a whole file.
fn fault(name: &str, message: String) -> ReadError {
    ReadError { file: name.to_owned(), line: None, text: String::new(), message }
}

impl OpenedFile {
    /// Makes the scene of a mesh file that was read; `stated` are the unit and axis that are known. Its
    /// mesh is welded, unless it shall stay `unwelded`.
    pub fn of_mesh(name: &str, mut source: Read, stated: UnitsAndUp, unwelded: bool) -> OpenedFile {
        let guessed = Guessed { units: stated.units.is_none(), up: stated.up.is_none() };
        let mut scene = Scene::opened(name);
        let units = || UnitsAndUp::guess_units(&source.mesh).to_owned();
        scene.units = stated.units.unwrap_or_else(units);
        scene.up = stated.up.unwrap_or_else(|| UnitsAndUp::guess_up(&source.mesh));
        let weld = if unwelded { None } else { source.weld() };
        let mesh = std::mem::take(&mut source.mesh);
        OpenedFile { scene, mesh, weld, diagnostics: source, guessed }
    }

    /// Parses a scene.
    ///
    /// # Errors
    /// If the file is no scene: the JSON path, what is wrong and what was expected.
    pub fn scene_in(bytes: &[u8]) -> Result<Scene, SceneError> {
        let text = std::str::from_utf8(bytes).map_err(|_| SceneError {
            path: String::new(),
            message: "not a text file, expected a scene in UTF-8".to_owned(),
        })?;
        Scene::from_json(text)
    }
}

/// Whether a file name is that of a scene rather than a mesh.
pub fn is_scene(name: &str) -> bool {
    name.to_ascii_lowercase().ends_with(".json")
}

/// Returns the files that a scene refers to, its mesh, a target surface and a pose: where the scene
/// names each, as a JSON path, and its path.
pub fn named_files(scene: &Scene) -> impl Iterator<Item = (&'static str, &str)> {
    let mesh = match &scene.mesh {
        MeshSource::File(path) => Some(path.as_str()),
        MeshSource::Inline(_) => None,
    };
    let pose = match &scene.pose {
        Some(Pose::File(path)) => Some(path.as_str()),
        _ => None,
    };
    let target = scene.closeness.file_to_read();
    let named = [("mesh.file", mesh), ("closeness.to.mesh.file", target), ("pose.file", pose)];
    named.into_iter().filter_map(|(place, path)| Some((place, path?)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Up;

    /// Two squares with separate copies of the vertices of their common edge.
    const APART: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\n\
                         f 1 2 3 4\nf 5 6 7 8\n";

    fn read_as(text: &str, frame: UnitsAndUp, unwelded: bool) -> OpenedFile {
        let read = FileReader::default().read("two.obj", text.as_bytes(), frame, unwelded);
        read.expect("it is a mesh")
    }

    /// Reads a scene for which a reader has its files.
    fn read_scene(mut reader: FileReader, bytes: &[u8]) -> Result<OpenedFile, ReadError> {
        reader.read("a.JSON", bytes, UnitsAndUp::default(), false)
    }

    #[test]
    fn a_mesh_is_welded_unless_it_shall_stay_apart() {
        let read = |unwelded| read_as(APART, UnitsAndUp::default(), unwelded);
        assert_eq!([true, false].map(|it| read(it).mesh.positions.len()), [8, 6]);
    }

    #[test]
    fn a_scene_without_a_unit_has_that_which_its_mesh_file_states() {
        // Built as metres, its parts were three times too large.
        let read = |units: &str| {
            let mut reader = FileReader::default();
            reader.add_file("two.obj", format!("# units: ft\n{APART}").into_bytes());
            let head = r#""format": "shape-up-scene", "version": 1, "mesh": { "file": "two.obj" }"#;
            let text = format!("{{ {head} {units} }}");
            read_scene(reader, text.as_bytes()).expect("it is a scene").scene.units
        };
        assert_eq!((&*read(""), &*read(r#", "units": "cm""#)), ("ft", "cm"));
    }

    #[test]
    fn what_a_file_states_goes_before_the_default_and_that_before_a_guess() {
        let feet = || UnitsAndUp { units: Some("ft".to_owned()), up: None };
        let opened = read_as(APART, feet(), false);
        assert_eq!(opened.scene.units, "ft");
        assert_eq!(opened.guessed, Guessed { units: false, up: true });
        let opened = read_as(&format!("# units: mm\n# up: y\n{APART}"), feet(), false);
        assert_eq!((opened.scene.units.as_str(), opened.scene.up), ("mm", Up::Y));
        assert_eq!(opened.guessed, Guessed::default());
    }

    #[test]
    fn a_scene_keeps_its_vertices_and_needs_its_mesh_file() {
        let scene =
            r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "two.obj" } }"#;
        let mut reader = FileReader::default();
        reader.add_file("two.obj", APART.as_bytes().to_vec());
        let opened = read_scene(reader, scene.as_bytes()).expect("both are there");
        assert_eq!((opened.mesh.positions.len(), opened.weld.is_none()), (8, true));
        let message = |bytes: &[u8]| {
            let refused = read_scene(FileReader::default(), bytes).map(|_| ());
            refused.expect_err("something is missing").to_string()
        };
        assert_eq!(
            message(scene.as_bytes()),
            "a.JSON: it needs the mesh file two.obj: open both files together"
        );
        assert_eq!(message(&[0xff]), "a.JSON: not a text file, expected a scene in UTF-8");
        // A file of the same name that was added for a scene that is none was read instead.
        let mut reader = FileReader::default();
        let mut read_with = |mesh: &str, bytes: &[u8]| {
            reader.add_file("two.obj", mesh.as_bytes().to_vec());
            reader.read("a.json", bytes, UnitsAndUp::default(), false)
        };
        assert!(read_with("v 0 0 0\n", b"{").is_err());
        let opened = read_with(APART, scene.as_bytes()).expect("both are there");
        assert_eq!(opened.mesh.positions.len(), 8);
    }

    #[test]
    fn another_surface_and_another_pose_come_from_files_beside_the_scene() {
        let scene = |pose: &str| {
            format!(
                r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "two.obj" }},
                     "units": "m", "pose": {{ "file": "{pose}" }}, "weights": {{ "close": 1 }},
                     "closeness": {{ "to": {{ "mesh": {{ "file": "far/other.obj" }} }} }} }}"#
            )
        };
        let other = "v 0 0 1\nv 1 0 1\nv 1 1 1\nf 1 2 3\n";
        let raised = APART.replace(" 0\n", " 2\n");
        let with_units = |pose: &str, units: [&str; 3]| {
            let mut reader = FileReader::default();
            let files = [("two.obj", APART), ("raised.obj", &raised), ("far/other.obj", other)];
            for ((path, text), units) in files.into_iter().zip(units) {
                reader.add_file(path, format!("{units}{text}").into_bytes());
            }
            read_scene(reader, scene(pose).as_bytes())
        };
        let opened = |pose: &str| with_units(pose, [""; 3]);
        let whole = OpenedFile::scene_in(scene("raised.obj").as_bytes()).expect("it is one");
        let named = named_files(&whole).map(|(_, path)| path);
        assert!(named.eq(["two.obj", "far/other.obj", "raised.obj"]));
        let OpenedFile { scene, .. } = opened("raised.obj").expect("all are there");
        assert!(scene.closeness.target.is_some_and(|target| target.mesh().is_some()));
        let pose = scene.pose.expect("it has one");
        assert_eq!(pose.positions().map(|positions| positions[1]), Some([1.0, 0.0, 2.0]));
        let refused = |pose: &str| opened(pose).map(|_| ()).expect_err("it is no pose").to_string();
        assert_eq!(
            refused("far/other.obj"),
            "a.JSON: pose: far/other.obj is not a pose of the model: it has 3 vertices and 1 face, \
             expected the 8 vertices and 2 faces of the model, in their order"
        );
        assert!(refused("none.obj").contains("needs the mesh file none.obj"));
        // It was read as if it were in the unit of the scene.
        let refused =
            with_units("raised.obj", ["", "", "# units: mm\n"]).err().map(|e| e.to_string());
        let words = "a.JSON: far/other.obj states the unit mm, expected that of the model, m";
        assert!(refused.is_some_and(|refused| refused.starts_with(words)));
        // The scene says of all of them that they are in metres.
        assert!(with_units("raised.obj", ["# units: mm\n"; 3]).is_ok());
        // One that states more, or less, than the mesh was refused for what it states like the mesh.
        for stated in [
            ["# up: y\n", "", "# units: m\n# up: y\n"],
            ["# units: mm\n# up: y\n", "# units: mm\n", "# up: y\n"],
            ["", "# up: y\n", "# units: m\n# up: y\n"],
        ] {
            assert!(with_units("raised.obj", stated).is_ok(), "{stated:?}");
        }
        assert!(with_units("raised.obj", ["# up: z\n", "", "# up: y\n"]).is_err());
    }
}
