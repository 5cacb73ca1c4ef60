//! `shape-up edit`: applies a mesh operation to a scene or a mesh.

use crate::cli::tokens::{Token, Tokens};
use crate::cli::{Failure, input, output, tokens};
use shape_up::mesh::{MESH_OPERATIONS, MeshOperation, Picks};
use shape_up::session::{self, Remeshing, Session};
use shape_up::words;
use std::path::PathBuf;

/// `shape-up edit`.
#[derive(Debug, PartialEq)]
pub(in crate::cli) struct Edit {
    input: PathBuf,
    /// The id of the operation.
    operation: &'static str,
    /// The given sizes, in the order of those of the operation.
    sizes: Vec<Option<f64>>,
    vertices: Vec<u32>,
    faces: Vec<u32>,
    out: Option<PathBuf>,
}

/// Parses the arguments: input, operation, then the options, which depend on the operation.
pub(in crate::cli) fn parse(tokens: &mut Tokens) -> Result<Edit, String> {
    let known = || MESH_OPERATIONS.iter().map(|it| it.id).collect::<Vec<_>>().join(", ");
    let Some(Token::File(input)) = tokens.next()? else {
        return Err("edit needs a scene or a mesh file first".to_owned());
    };
    let input = tokens::input(input)?;
    let Some(Token::File(id)) = tokens.next()? else {
        return Err(format!("edit needs an operation after the file: {}", known()));
    };
    let id = id.to_string_lossy();
    let operation =
        MeshOperation::of(&id).map_err(|_| format!("edit does {}, found `{id}`", known()))?;
    let lists: &[&str] = match operation.picks {
        Picks::Nothing => &[],
        Picks::Faces => &["--faces"],
        Picks::Vertices | Picks::AnyVertices => &["--vertices", "--faces"],
    };
    let mut sizes = vec![None; operation.sizes.len()];
    let (mut vertices, mut faces, mut out) = (Vec::new(), Vec::new(), None);
    while let Some(word) = tokens.next()? {
        let name = match word {
            Token::Option(name) => name,
            Token::File(file) => {
                return Err(format!("edit does not take `{}`", file.to_string_lossy()));
            }
        };
        let size = operation.sizes.iter().position(|size| name.strip_prefix("--") == Some(size.id));
        match (name.as_str(), size) {
            ("--vertices", _) if lists.contains(&&*name) => vertices = tokens.indices(&name)?,
            ("--faces", _) if lists.contains(&&*name) => faces = tokens.indices(&name)?,
            ("--out", _) => out = Some(tokens.mesh_or_scene(&name)?),
            (_, Some(size)) => sizes[size] = Some(tokens.number(&name)?),
            (_, None) => {
                let sizes = operation.sizes.iter().map(|size| format!("--{}", size.id));
                let others = lists.iter().chain(&["--out"]).map(ToString::to_string);
                let takes = sizes.chain(others).collect::<Vec<_>>().join(", ");
                return Err(format!("edit {} takes {takes}, found `{name}`", operation.id));
            }
        }
    }
    Ok(Edit { input, operation: operation.id, sizes, vertices, faces, out })
}

/// Applies the operation and prints the result.
pub(in crate::cli) fn edit(command: &Edit) -> Result<(), Failure> {
    let input::Input { scene, mesh, frame, mut remarks, .. } = input::read(&command.input)?;
    let at_input = input::at(&command.input);
    let mut session = Session::open(scene, mesh).map_err(at_input)?;
    let offered = session.operations();
    let offered = offered.into_iter().find(|offered| offered.operation.id == command.operation);
    let defaults = offered.expect("it was found when it was read").defaults;
    let sizes = command.sizes.iter().zip(defaults);
    // Faces stand for their corners where vertices are taken, as on the page.
    let mesh = session.mesh();
    let known = command.faces.iter().filter(|face| (**face as usize) < mesh.faces.len());
    let corners = known.flat_map(|&face| mesh.faces.row(face as usize)).copied();
    let asked = Remeshing {
        operation: command.operation.to_owned(),
        sizes: sizes.map(|(given, default)| given.unwrap_or(default)).collect(),
        vertices: command.vertices.iter().copied().chain(corners).collect(),
        faces: command.faces.clone(),
    };
    let before = session.mesh().faces.len();
    session.edit(session::Edit::Remesh(asked)).map_err(at_input)?;

    let mesh = session.mesh();
    let mut text = format!(
        "{}: {} became {}, {}\n",
        command.input.display(),
        words::count(before, "face", "faces"),
        words::count(mesh.faces.len(), "face", "faces"),
        words::count(mesh.positions.len(), "vertex", "vertices")
    );
    remarks.extend_from_slice(session.lost());
    let mut files = Vec::new();
    if let Some(path) = &command.out {
        remarks.extend(output::write_changed(path, &session, &frame, &mut files));
    }
    text += &output::notes(&remarks);
    output::write(&files)?;
    output::print(&text)
}
