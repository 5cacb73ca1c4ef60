//! Reads and writes PLY (Turk, <https://paulbourke.net/dataformats/ply/>), as text or binary: vertices,
//! polygons, and edges as curves. Other elements and properties are named and ignored.

use super::builder::{MeshBuilder, ReadError};
use super::lines::decode;
use super::number::{Numbering, coordinate, of_number, whole};
use super::stream::Stream;
use crate::mesh::{ElementKind, Mesh, Point, ProblemKind};
use crate::words::count;
use std::borrow::Cow;

/// Whether a file is one, by its first bytes.
pub(super) fn is_one(bytes: &[u8]) -> bool {
    let bytes = unmarked(bytes);
    bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r") || bytes.starts_with(b"ply ")
}

/// The part of a file that is text: of a binary one, its header.
pub(super) fn text(bytes: &[u8]) -> &[u8] {
    const END: &[u8] = b"end_header";
    let end = bytes.windows(END.len()).position(|word| word == END);
    match end {
        Some(end) if bytes.contains(&0) => &bytes[..end + END.len()],
        _ => bytes,
    }
}

/// The bytes after the mark of UTF-8, which editors put before a text.
fn unmarked(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes)
}

pub(super) fn read(bytes: &[u8]) -> Result<MeshBuilder, ReadError> {
    let bytes = unmarked(bytes);
    let (header, length) = header(bytes)?;
    let rest = &bytes[length..];
    let text = if header.binary.is_none() { decode(rest) } else { Cow::default() };
    let mut body = match header.binary {
        Some(is_little) => Body::Binary { rest, is_little },
        None => Body::Text { words: Stream::new(&text), before: header.lines },
    };
    let mut builder = MeshBuilder::default();
    let mut ignored: Vec<String> = Vec::new();
    for element in &header.elements {
        element.read(&mut body, &mut builder)?;
        ignored.extend(element.ignored());
    }
    builder.notes.extend(body.rest()?);
    builder.settle(Numbering::ZeroBased);
    if !ignored.is_empty() {
        builder.notes.push(format!("ignored: {}", ignored.join(", ")));
    }
    Ok(builder)
}

/// The type of a number.
#[derive(Clone, Copy)]
enum Type {
    Signed(usize),
    Unsigned(usize),
    Float(usize),
}

impl Type {
    fn of(word: &str) -> Option<Type> {
        Some(match word {
            "char" | "int8" => Type::Signed(1),
            "short" | "int16" => Type::Signed(2),
            "int" | "int32" => Type::Signed(4),
            "uchar" | "uint8" => Type::Unsigned(1),
            "ushort" | "uint16" => Type::Unsigned(2),
            "uint" | "uint32" => Type::Unsigned(4),
            "float" | "float32" => Type::Float(4),
            "double" | "float64" => Type::Float(8),
            _ => return None,
        })
    }
}

struct Property {
    name: String,
    /// The type of the number of values of a list; none for a single value.
    list: Option<Type>,
    of: Type,
}

struct Element {
    name: String,
    count: usize,
    properties: Vec<Property>,
}

struct Header {
    /// Whether numbers are little endian; none for text.
    binary: Option<bool>,
    elements: Vec<Element>,
    /// Number of its lines.
    lines: usize,
}

/// Reads the header; returns it with its length in bytes.
fn header(bytes: &[u8]) -> Result<(Header, usize), ReadError> {
    let mut header = Header { binary: None, elements: Vec::new(), lines: 0 };
    let mut format = None;
    let mut at = 0;
    // If its first line ends in CR alone, LF after CR is the first binary number.
    let first = bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(0);
    let is_cr_alone = bytes[first..].starts_with(b"\r") && bytes.get(first + 1) != Some(&b'\n');
    loop {
        let rest = &bytes[at..];
        let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let end =
            end.ok_or_else(|| ReadError::whole("the file ends where `end_header` was expected"))?;
        let line = decode(&rest[..end]);
        at += end + 1;
        if !is_cr_alone && rest[end..].starts_with(b"\r\n") {
            at += 1;
        }
        header.lines += 1;
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        let fault = |message: &str| ReadError::at(Some(header.lines), message);
        match words[..] {
            ["ply"] | ["comment" | "obj_info", ..] | [] => {}
            ["format", name, ..] => {
                format = Some(name.to_owned());
                header.binary = match name {
                    "ascii" => None,
                    "binary_little_endian" => Some(true),
                    "binary_big_endian" => Some(false),
                    _ => {
                        return Err(fault(
                            "expected the format ascii, binary_little_endian or binary_big_endian",
                        ));
                    }
                };
            }
            ["element", name, count] => {
                let count = count.parse().map_err(|_| fault("expected the number of elements"))?;
                header.elements.push(Element {
                    name: name.to_owned(),
                    count,
                    properties: Vec::new(),
                });
            }
            ["property", ref how @ .., name] => {
                let types: Option<(Option<Type>, Type)> = match how[..] {
                    ["list", count, of] => Type::of(count).map(Some).zip(Type::of(of)),
                    [of] => Type::of(of).map(|of| (None, of)),
                    _ => None,
                };
                let types = types.ok_or_else(|| fault("expected a type of numbers and a name"))?;
                let last = header.elements.last_mut();
                let element =
                    last.ok_or_else(|| fault("expected an element before its properties"))?;
                let (list, of) = types;
                element.properties.push(Property { name: name.to_owned(), list, of });
            }
            ["end_header"] => break,
            _ => return Err(fault("expected a line of a PLY header")),
        }
    }
    match format {
        Some(_) => Ok((header, at)),
        None => Err(ReadError::whole("the header has no `format`")),
    }
}

/// What is left of the file.
enum Body<'a> {
    Text {
        words: Stream<'a>,
        /// Number of lines of the header.
        before: usize,
    },
    Binary {
        rest: &'a [u8],
        is_little: bool,
    },
}

/// A value as it is in the file.
#[derive(Clone, Copy)]
enum Value<'a> {
    Word(&'a str),
    Number(f64),
}

impl Value<'_> {
    fn coordinate(self) -> (f64, Option<ProblemKind>) {
        match self {
            Value::Word(word) => coordinate(word),
            Value::Number(x) => of_number(x),
        }
    }

    fn whole(self) -> Option<i32> {
        match self {
            Value::Word(word) => whole(word),
            Value::Number(x) => (x.fract() == 0.0).then_some(x as i32),
        }
    }
}

impl<'a> Body<'a> {
    /// Reads a value; `what` describes it in the error at the end of the file.
    fn value(&mut self, of: Type, what: std::fmt::Arguments<'_>) -> Result<Value<'a>, ReadError> {
        match self {
            Body::Text { words, .. } => words.expect(what).map(Value::Word),
            Body::Binary { rest, is_little } => {
                let (Type::Signed(size) | Type::Unsigned(size) | Type::Float(size)) = of;
                let Some((own, after)) = rest.split_at_checked(size) else {
                    return Err(ReadError::whole(format!(
                        "the file ends where {what} was expected"
                    )));
                };
                *rest = after;
                let mut bytes = [0; 8];
                bytes[..size].copy_from_slice(own);
                if !*is_little {
                    bytes[..size].reverse();
                }
                let bits = u64::from_le_bytes(bytes);
                let unused = 64 - 8 * size as u32;
                Ok(Value::Number(match of {
                    Type::Signed(_) => ((bits << unused) as i64 >> unused) as f64,
                    Type::Unsigned(_) => bits as f64,
                    Type::Float(4) => f64::from(f32::from_bits(bits as u32)),
                    Type::Float(_) => f64::from_bits(bits),
                }))
            }
        }
    }

    /// Says what follows the last element, if anything. Text that goes on was not understood: its
    /// values are not those of the header.
    fn rest(&mut self) -> Result<Option<String>, ReadError> {
        match self {
            Body::Text { words, before } => match words.word() {
                None => Ok(None),
                Some(_) => Err(ReadError::at(
                    Some(*before + words.line()),
                    "the file goes on after its last element, expected as many elements and \
                     values as in its header",
                )),
            },
            Body::Binary { rest, .. } => {
                let is_blank = rest.iter().all(|byte| byte.is_ascii_whitespace() || *byte == 0);
                let bytes = count(rest.len(), "byte", "bytes");
                Ok((!is_blank).then(|| format!("ignored: {bytes} after the last element")))
            }
        }
    }

    /// The line of the last value; none in a binary file.
    fn line(&self) -> Option<usize> {
        match self {
            Body::Text { words, before } => Some(before + words.line()),
            Body::Binary { .. } => None,
        }
    }
}

impl Element {
    /// The place of a property of one of these names.
    fn place(&self, names: &[&str]) -> Option<usize> {
        self.properties.iter().position(|property| names.contains(&&*property.name))
    }

    /// The places of the properties that are used, and the kind of element.
    fn used(&self) -> Option<(Option<ElementKind>, Vec<usize>)> {
        let places = |names: &[&str]| {
            names.iter().map(|name| self.place(&[name])).collect::<Option<Vec<_>>>()
        };
        match &*self.name {
            "vertex" => Some((None, places(&["x", "y", "z"])?)),
            "face" => {
                let corners = self.place(&["vertex_indices", "vertex_index"])?;
                Some((Some(ElementKind::Face), vec![corners]))
            }
            "edge" => Some((Some(ElementKind::Curve), places(&["vertex1", "vertex2"])?)),
            _ => None,
        }
    }

    /// Names what is ignored of it, if anything.
    fn ignored(&self) -> Option<String> {
        let Some((_, used)) = self.used() else {
            return (self.count > 0).then(|| format!("element {}", self.name));
        };
        let others = self.properties.iter().enumerate().filter(|(place, _)| !used.contains(place));
        let names: Vec<&str> = others.map(|(_, property)| &*property.name).collect();
        (!names.is_empty()).then(|| format!("{} of {}", names.join(" "), self.name))
    }

    fn read(&self, body: &mut Body<'_>, builder: &mut MeshBuilder) -> Result<(), ReadError> {
        let Element { name, count, properties } = self;
        if properties.is_empty() {
            return Ok(());
        }
        let used = self.used();
        let mut values: Vec<Vec<Value<'_>>> = vec![Vec::new(); properties.len()];
        for index in 1..=*count {
            let mut line = None;
            for (values, property) in values.iter_mut().zip(properties) {
                let what = format_args!("{name} {index} of {count}");
                values.clear();
                let mut length = Some(1);
                if let Some(of) = property.list {
                    length = body.value(of, what)?.whole().filter(|length| *length >= 0);
                    line = line.or(body.line());
                }
                let length = length.ok_or_else(|| {
                    let message = format!("expected the length of a list in {name} {index}");
                    ReadError::at(body.line(), message)
                })?;
                for _ in 0..length {
                    values.push(body.value(property.of, what)?);
                    line = line.or(body.line());
                }
            }
            match &used {
                Some((None, places)) => {
                    let at = |axis: usize| values[places[axis]].first();
                    let missing = (f64::NAN, Some(ProblemKind::MalformedCoordinate));
                    let place =
                        [0, 1, 2].map(|axis| at(axis).map_or(missing, |value| value.coordinate()));
                    builder.vertex_of(place, line);
                }
                Some((Some(kind), places)) => {
                    let corners = places.iter().flat_map(|&place| &values[place]);
                    corners.for_each(|value| builder.defer_corner(value.whole()));
                    builder.defer_element(*kind, line);
                }
                None => {}
            }
        }
        Ok(())
    }
}

/// Returns the mesh at other positions (`#V by 3`) as a binary PLY file in double precision. Curves
/// become edges; tetrahedra and groups are left out. `comments` are lines of the header.
pub fn write_ply(mesh: &Mesh, positions: &[Point], comments: &[String]) -> Vec<u8> {
    let edges: Vec<[u32; 2]> = mesh
        .curves
        .iter()
        .flat_map(|curve| curve.windows(2).map(|ends| [ends[0], ends[1]]))
        .collect();
    let longest = mesh.all_faces().map(<[u32]>::len).max().unwrap_or(0);
    let is_short = longest <= usize::from(u8::MAX);
    let mut head = "ply\nformat binary_little_endian 1.0\n".to_owned();
    comments.iter().for_each(|comment| head.push_str(&format!("comment {comment}\n")));
    head.push_str(&format!("element vertex {}\n", positions.len()));
    ["x", "y", "z"].iter().for_each(|axis| head.push_str(&format!("property double {axis}\n")));
    let length = if is_short { "uchar" } else { "uint" };
    head.push_str(&format!(
        "element face {}\nproperty list {length} int vertex_indices\n",
        mesh.all_faces().count()
    ));
    if !edges.is_empty() {
        let count = edges.len();
        head.push_str(&format!(
            "element edge {count}\nproperty int vertex1\nproperty int vertex2\n"
        ));
    }
    let mut out = (head + "end_header\n").into_bytes();
    positions.as_flattened().iter().for_each(|x| out.extend(x.to_le_bytes()));
    for face in mesh.all_faces() {
        match is_short {
            true => out.push(face.len() as u8),
            false => out.extend((face.len() as u32).to_le_bytes()),
        }
        face.iter().for_each(|v| out.extend(v.to_le_bytes()));
    }
    edges.as_flattened().iter().for_each(|v| out.extend(v.to_le_bytes()));
    out
}
