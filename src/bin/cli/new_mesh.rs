//! `shape-up new`: makes a mesh to start from.

use crate::cli::tokens::{Token, Tokens};
use crate::cli::{Failure, input, output};
use shape_up::generate::{NEW_KINDS, NewKind, Plan, SpanCurve, fill, loft};
use shape_up::mesh::Mesh;
use shape_up::scene::{UnitsAndUp, Up};
use shape_up::words;
use shape_up::words::UNITS;
use std::path::{Path, PathBuf};

/// `shape-up new`.
#[derive(Debug)]
pub(in crate::cli) struct New {
    from: From,
    units: Option<&'static str>,
    out: Option<PathBuf>,
}

/// The source of the mesh.
#[derive(Debug)]
enum From {
    /// A kind, and its sizes in order.
    Kind(&'static NewKind, Vec<f64>),
    /// The file of a plan.
    Plan(PathBuf),
    /// Curves of a file.
    Span(Span),
}

/// `new loft` and `new fill`.
#[derive(Debug)]
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

/// Parses the arguments: the kind, then a file or the sizes, and the options, which depend on the kind.
pub(in crate::cli) fn parse(tokens: &mut Tokens) -> Result<New, String> {
    let known = || {
        NEW_KINDS.iter().map(|kind| kind.id).collect::<Vec<_>>().join(", ")
            + " or plan, loft, fill FILE"
    };
    let Some(Token::File(id)) = tokens.next()? else {
        return Err(format!("new needs a kind first: {}", known()));
    };
    let id = id.to_string_lossy();
    let unknown = || format!("new makes {}, found `{id}`", known());
    // The kind, or the number of curves.
    let (kind, count) = match &*id {
        "plan" => (None, None),
        "loft" => (None, Some(2)),
        "fill" => (None, Some(1)),
        _ => (Some(NewKind::of(&id).ok_or_else(unknown)?), None),
    };
    let mut sizes = kind.map_or_else(Vec::new, NewKind::defaults);
    let mut own: Vec<String> =
        kind.iter().flat_map(|kind| kind.sizes).map(|size| format!("--{}", size.id)).collect();
    own.extend(count.iter().flat_map(|_| ["--curves", "--size"].map(str::to_owned)));
    let (mut units, mut out, mut file, mut curves, mut size) = (None, None, None, None, None);
    while let Some(name) = tokens.option(&mut file)? {
        match (own.iter().position(|own| *own == name), count, name.as_str()) {
            (Some(k), None, _) => sizes[k] = tokens.not_negative(&name)?,
            (Some(0), Some(count), _) => curves = Some(numbers(&tokens.text(&name)?, count)?),
            (Some(_), Some(_), _) => size = Some(tokens.positive(&name)?),
            (None, _, "--units") => {
                units = Some(tokens.word_of(&name, &UNITS, |unit| unit.symbol)?.symbol);
            }
            (None, _, "--out") => out = Some(tokens.mesh(&name)?),
            (None, ..) => {
                own.extend(["--units", "--out"].map(str::to_owned));
                return Err(format!("new {id} takes {}, found `{name}`", own.join(", ")));
            }
        }
    }
    let from = match (kind, count, file) {
        (Some(_), _, Some(file)) => {
            return Err(format!("new does not take `{}`", file.display()));
        }
        (Some(kind), _, None) => From::Kind(kind, sizes),
        (None, Some(count), Some(file)) => From::Span(Span { file, count, curves, size }),
        (None, None, Some(file)) => From::Plan(file),
        (None, Some(_), None) => return Err(format!("new {id} needs a file with curves or faces")),
        (None, None, None) => return Err(format!("new {id} needs the file of a plan")),
    };
    Ok(New { from, units, out })
}

/// The numbers of as many curves.
fn numbers(list: &str, count: usize) -> Result<Vec<usize>, String> {
    let numbers: Result<Vec<usize>, _> = list.split(',').map(str::parse).collect();
    numbers.ok().filter(|numbers| numbers.len() == count).ok_or_else(|| {
        let count = words::count(count, "number", "numbers");
        format!("--curves needs {count}, found `{list}`")
    })
}

/// Makes the mesh and writes it to the file, or to standard output.
pub(in crate::cli) fn make(command: &New) -> Result<(), Failure> {
    let (mesh, frame) = mesh(&command.from)?;
    let frame = UnitsAndUp { units: command.units.map(str::to_owned), up: None }.or(frame);
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
        From::Kind(kind, sizes) => {
            let fault = |error| Failure::Input(format!("new {}: {error}", kind.id));
            Ok((kind.mesh(sizes).map_err(fault)?, metres))
        }
        From::Plan(file) => {
            let text = String::from_utf8_lossy(&input::bytes(file, "a plan")?).into_owned();
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
