//! `shape-up new`: makes a mesh to start from.

use crate::cli::words::{MESHES, Word, Words};
use crate::cli::{Failure, input, output};
use shape_up::generate::{NEW_KINDS, NewKind, Plan, SpanCurve, fill, loft};
use shape_up::mesh::Mesh;
use shape_up::scene::{UnitsAndUp, Up};
use shape_up::words;
use std::path::{Path, PathBuf};

/// `shape-up new`.
#[derive(Debug, PartialEq)]
pub(in crate::cli) struct New {
    from: From,
    units: Option<String>,
    out: Option<PathBuf>,
}

/// The source of the mesh.
#[derive(Debug, PartialEq)]
enum From {
    /// The id of a kind, and its sizes in order.
    Kind(&'static str, Vec<f64>),
    /// The file of a plan.
    Plan(PathBuf),
    /// Curves of a file.
    Span(Span),
}

/// `new loft` and `new fill`.
#[derive(Debug, PartialEq)]
struct Span {
    file: PathBuf,
    /// The number of curves.
    count: usize,
    /// One curve for `fill`, two for `loft`, if they were named.
    curves: Option<Vec<usize>>,
    /// The size of a panel.
    size: Option<f64>,
}

/// The default size of a panel, relative to the length of the first curve.
const PANEL: f64 = 0.05;

/// Parses the arguments: the kind, then the options, which depend on the kind.
pub(in crate::cli) fn parse(mut words: Words) -> Result<New, String> {
    let known = || {
        NEW_KINDS.iter().map(|kind| kind.id).collect::<Vec<_>>().join(", ")
            + " or plan, loft, fill FILE"
    };
    let Some(Word::File(id)) = words.next()? else {
        return Err(format!("new needs a kind first: {}", known()));
    };
    let id = id.to_string_lossy();
    match &*id {
        "plan" => return parse_plan(words),
        "loft" => return parse_span(words, "new loft", 2),
        "fill" => return parse_span(words, "new fill", 1),
        _ => {}
    }
    let kind = NewKind::of(&id).ok_or_else(|| format!("new makes {}, found `{id}`", known()))?;
    let mut sizes = kind.defaults();
    let (mut units, mut out) = (None, None);
    while let Some(word) = words.next()? {
        let name = match word {
            Word::Option(name) => name,
            Word::File(file) => {
                return Err(format!("new does not take `{}`", file.to_string_lossy()));
            }
        };
        let size = kind.sizes.iter().position(|size| name.strip_prefix("--") == Some(size.id));
        match (name.as_str(), size) {
            ("--units", _) => units = Some(words.text(&name)?),
            ("--out", _) => out = Some(words.mesh(&name, MESHES)?),
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
    let (mut units, mut out, mut file) = (None, None, None);
    while let Some(name) = words.option(&mut file)? {
        match name.as_str() {
            "--units" => units = Some(words.text(&name)?),
            "--out" => out = Some(words.mesh(&name, MESHES)?),
            _ => return Err(format!("new plan takes --units, --out, found `{name}`")),
        }
    }
    let file = file.ok_or("new plan needs the file of a plan")?;
    Ok(New { from: From::Plan(file), units, out })
}

fn parse_span(mut words: Words, name: &str, count: usize) -> Result<New, String> {
    let (mut units, mut out, mut file) = (None, None, None);
    let (mut curves, mut size) = (None, None);
    while let Some(option) = words.option(&mut file)? {
        match option.as_str() {
            "--units" => units = Some(words.text(&option)?),
            "--out" => out = Some(words.mesh(&option, MESHES)?),
            "--size" => size = Some(words.positive(&option)?),
            "--curves" => {
                let list = words.text(&option)?;
                let numbers: Result<Vec<usize>, _> = list.split(',').map(str::parse).collect();
                let numbers = numbers.ok().filter(|numbers| numbers.len() == count);
                curves = Some(numbers.ok_or_else(|| {
                    let count = words::count(count, "number", "numbers");
                    format!("--curves needs {count}, found `{list}`")
                })?);
            }
            _ => {
                let takes = "--curves, --size, --units, --out";
                return Err(format!("{name} takes {takes}, found `{option}`"));
            }
        }
    }
    let file = file.ok_or_else(|| format!("{name} needs a file with curves or faces"))?;
    Ok(New { from: From::Span(Span { file, count, curves, size }), units, out })
}

/// Makes the mesh and writes it to the file, or to standard output.
pub(in crate::cli) fn make(command: &New) -> Result<(), Failure> {
    let (mesh, frame) = mesh(&command.from)?;
    let frame = UnitsAndUp { units: command.units.clone(), up: None }.or(frame);
    let path = command.out.as_deref();
    let (file, remark) = output::mesh_file(path.unwrap_or(Path::new("")), &mesh, &frame);
    let Some(path) = path else {
        return output::print(&String::from_utf8_lossy(&file));
    };
    output::write(&[(path, file)])?;
    let vertices = words::count(mesh.positions.len(), "vertex", "vertices");
    let faces = words::count(mesh.faces.len(), "face", "faces");
    let note = remark.map_or_else(String::new, |remark| format!("note: {remark}\n"));
    output::print(&format!("{}: {vertices}, {faces}\n{note}", path.display()))
}

/// The mesh, and its unit and up axis: those of the file of its curves, if it has one.
fn mesh(from: &From) -> Result<(Mesh, UnitsAndUp), Failure> {
    let metres = UnitsAndUp { units: Some("m".to_owned()), up: Some(Up::Z) };
    match from {
        From::Kind(id, sizes) => {
            let kind = NewKind::of(id).expect("it was found when it was read");
            let mesh = kind.mesh(sizes);
            let mesh = mesh.map_err(|error| Failure::Input(format!("new {id}: {error}")))?;
            Ok((mesh, metres))
        }
        From::Plan(file) => {
            let text = String::from_utf8_lossy(&input::bytes(file)?).into_owned();
            let plan = Plan::from_json(&text).and_then(|plan| plan.mesh());
            let mesh =
                plan.map_err(|error| Failure::Input(format!("{}: {error}", file.display())))?;
            Ok((mesh, metres))
        }
        From::Span(Span { file, count, curves, size }) => {
            let (read, _, stated) = input::read_mesh(file)?;
            let known = SpanCurve::all(&read.mesh);
            let closed = known.iter().position(SpanCurve::is_closed).unwrap_or(0);
            let usual = if *count == 1 { vec![closed] } else { vec![0, 1] };
            let curves = curves.as_ref().unwrap_or(&usual);
            let up = stated.up.unwrap_or_else(|| UnitsAndUp::guess_up(&read.mesh));
            let lengths = SpanCurve::labels(&known);
            let made = curves.iter().map(|&number| SpanCurve::of(&known, number));
            let made = made.collect::<Result<Vec<_>, _>>().and_then(|asked| {
                let size = size.unwrap_or_else(|| PANEL * lengths[curves[0]].length);
                match asked[..] {
                    [first, second] => loft(first, second, size, up.direction()),
                    _ => fill(asked[0], size, up.direction()),
                }
            });
            let mesh =
                made.map_err(|error| Failure::Input(format!("{}: {error}", file.display())))?;
            // A file that does not say leaves it open, unless the surface would be taken otherwise.
            let is_said = stated.up.is_some() || UnitsAndUp::guess_up(&mesh) != up;
            Ok((mesh, UnitsAndUp { up: is_said.then_some(up), ..stated }))
        }
    }
}
