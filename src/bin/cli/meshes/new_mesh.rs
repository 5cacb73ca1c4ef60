//! `shape-up new`: a mesh to begin with.

use crate::cli::words::{Word, Words};
use crate::cli::{Failure, input, output};
use shape_up::begin::{NEW_KINDS, NewKind, Plan};
use shape_up::mesh::{Mesh, counted, write_obj};
use shape_up::scene::{UnitsAndUp, Up};
use std::path::{Path, PathBuf};

/// `shape-up new`.
#[derive(Debug, PartialEq)]
pub(in crate::cli) struct New {
    from: From,
    units: String,
    out: Option<PathBuf>,
}

/// What the mesh is made from.
#[derive(Debug, PartialEq)]
enum From {
    /// The id of a kind, and sizes in the order of its own.
    Kind(&'static str, Vec<f64>),
    /// The file of a plan.
    Plan(PathBuf),
}

/// Reads the arguments: the kind comes first, because it says which sizes there are.
pub(in crate::cli) fn parse(mut words: Words) -> Result<New, String> {
    let known =
        || NEW_KINDS.iter().map(|kind| kind.id).collect::<Vec<_>>().join(", ") + " or plan FILE";
    let Some(Word::File(id)) = words.next()? else {
        return Err(format!("new needs a kind first: {}", known()));
    };
    let id = id.to_string_lossy();
    if id == "plan" {
        return parse_plan(words);
    }
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
    Ok(New { from: From::Kind(kind.id, sizes), units, out })
}

fn parse_plan(mut words: Words) -> Result<New, String> {
    let (mut units, mut out, mut file) = ("m".to_owned(), None, None);
    while let Some(name) = words.option(&mut file)? {
        match name.as_str() {
            "--units" => units = words.text(&name)?,
            "--out" => out = Some(words.mesh(&name, &["obj"])?),
            _ => return Err(format!("new plan takes --units, --out, found `{name}`")),
        }
    }
    let file = file.ok_or("new plan needs the file of a plan")?;
    Ok(New { from: From::Plan(file), units, out })
}

/// Writes it to the file, or to standard output.
pub(in crate::cli) fn make(command: &New) -> Result<(), Failure> {
    let mesh = mesh(&command.from)?;
    let text = UnitsAndUp::comments(&command.units, Up::Z) + &write_obj(&mesh, &mesh.positions);
    let Some(path) = &command.out else { return output::print(&text) };
    output::write(&[(path as &Path, text)])?;
    let vertices = counted(mesh.positions.len(), "vertex", "vertices");
    let faces = counted(mesh.faces.len(), "face", "faces");
    output::print(&format!("{}: {vertices}, {faces}\n", path.display()))
}

fn mesh(from: &From) -> Result<Mesh, Failure> {
    match from {
        From::Kind(id, sizes) => {
            let kind = NewKind::of(id).expect("it was found when it was read");
            kind.mesh(sizes).map_err(|error| Failure::Input(format!("new {id}: {error}")))
        }
        From::Plan(file) => {
            let text = String::from_utf8_lossy(&input::bytes(file)?).into_owned();
            let plan = Plan::from_json(&text).and_then(|plan| plan.mesh());
            plan.map_err(|error| Failure::Input(format!("{}: {error}", file.display())))
        }
    }
}
