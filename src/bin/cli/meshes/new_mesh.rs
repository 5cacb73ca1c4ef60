//! `shape-up new`: a mesh to begin with.

use crate::cli::words::{Word, Words};
use crate::cli::{Failure, output};
use shape_up::begin::{NEW_KINDS, NewKind};
use shape_up::mesh::{counted, write_obj};
use shape_up::scene::{UnitsAndUp, Up};
use std::path::{Path, PathBuf};

/// `shape-up new`.
#[derive(Debug, PartialEq)]
pub(in crate::cli) struct New {
    /// The id of the kind.
    kind: &'static str,
    /// In the order of the sizes of the kind.
    sizes: Vec<f64>,
    units: String,
    out: Option<PathBuf>,
}

/// Reads the arguments: the kind comes first, because it says which sizes there are.
pub(in crate::cli) fn parse(mut words: Words) -> Result<New, String> {
    let known = || NEW_KINDS.iter().map(|kind| kind.id).collect::<Vec<_>>().join(", ");
    let Some(Word::File(id)) = words.next()? else {
        return Err(format!("new needs a kind first: {}", known()));
    };
    let id = id.to_string_lossy();
    let kind = NewKind::of(&id).ok_or_else(|| format!("new makes {}, found `{id}`", known()))?;
    let mut sizes = kind.defaults();
    let (mut units, mut out) = ("m".to_owned(), None);
    while let Some(word) = words.next()? {
        let name = match word {
            Word::Option(name) => name,
            Word::File(file) => {
                return Err(format!("new does not take `{}`", file.to_string_lossy()));
            }
        };
        let size = kind.sizes.iter().position(|size| name.strip_prefix("--") == Some(size.id));
        match (name.as_str(), size) {
            ("--units", _) => units = words.text(&name)?,
            ("--out", _) => out = Some(words.mesh(&name, &["obj"])?),
            (_, Some(size)) => sizes[size] = words.not_negative(&name)?,
            (_, None) => {
                let sizes: Vec<_> = kind.sizes.iter().map(|s| format!("--{}", s.id)).collect();
                let sizes = sizes.join(", ");
                return Err(format!("new {} takes {sizes}, found `{name}`", kind.id));
            }
        }
    }
    Ok(New { kind: kind.id, sizes, units, out })
}

/// Writes it to the file, or to standard output.
pub(in crate::cli) fn make(command: &New) -> Result<(), Failure> {
    let at_kind = |error| Failure::Input(format!("new {}: {error}", command.kind));
    let kind = NewKind::of(command.kind).expect("it was found when it was read");
    let mesh = kind.mesh(&command.sizes).map_err(|error| at_kind(error.to_string()))?;
    let text = UnitsAndUp::comments(&command.units, Up::Z) + &write_obj(&mesh, &mesh.positions);
    let Some(path) = &command.out else { return output::print(&text) };
    output::write(&[(path as &Path, text)])?;
    let vertices = counted(mesh.positions.len(), "vertex", "vertices");
    let faces = counted(mesh.faces.len(), "face", "faces");
    output::print(&format!("{}: {vertices}, {faces}\n", path.display()))
}
