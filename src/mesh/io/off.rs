//! Reads OFF, the format of Geomview (<http://www.geomview.org/docs/html/OFF.html>): a header, the
//! numbers of vertices, faces and edges, then the vertices and the faces. The colours, normals and
//! texture coordinates of the variants `COFF`, `NOFF` and `STOFF` are ignored.

use super::builder::MeshBuilder;
use super::builder::ReadError;
use super::number::Numbering;
use super::stream::Stream;
use crate::mesh::ElementKind;
use crate::words;

/// The first word of a file.
pub(crate) struct Header<'a> {
    /// The vertex attributes besides the position.
    variant: &'a str,
    /// The number of vertices if it directly follows the word, as in `OFF8`; else empty.
    glued: &'a str,
}

impl<'a> Header<'a> {
    pub(crate) fn parse(word: &'a str) -> Option<Self> {
        let (variant, glued) = word.split_once("OFF")?;
        let is_header = variant.chars().all(|c| "STCN4n".contains(c))
            && glued.chars().all(|c| c.is_ascii_digit());
        is_header.then_some(Header { variant, glued })
    }
}

pub(crate) fn read(text: &str) -> Result<MeshBuilder, ReadError> {
    let mut stream = Stream::new(text);
    let vertices = vertex_count(&mut stream)?;
    let faces = stream.count("the number of faces")?;
    // The number of edges, which nobody needs.
    if !stream.drop_line() {
        stream.drop_lone_number();
    }

    let mut builder = MeshBuilder::default();
    let vertex_rests = stream.vertices(vertices, 3, false, &mut builder)?;
    let mut face_rests = 0;
    for face in 1..=faces {
        let corners =
            stream.count(format_args!("the number of corners of face {face} of {faces}"))?;
        let what = format_args!("a corner of face {face} of {faces}");
        face_rests +=
            usize::from(stream.element(ElementKind::Face, corners, false, what, &mut builder)?);
    }
    if let Some(word) = stream.word() {
        let vertices = words::count(vertices, "vertex", "vertices");
        let faces = words::count(faces, "face", "faces");
        let message = format!("the header says {vertices} and {faces}, but `{word}` follows them");
        return Err(stream.fault(message));
    }

    if vertex_rests > 0 {
        let vertices = words::count(vertex_rests, "vertex", "vertices");
        builder.notes.push(format!("extra numbers of {vertices} ignored"));
    }
    if face_rests > 0 {
        let faces = words::count(face_rests, "face", "faces");
        builder.notes.push(format!("colours of {faces} ignored"));
    }
    let numbering = match counts_from_one(&builder, vertices) {
        true => Numbering::OneBased,
        false => Numbering::ZeroBased,
    };
    if matches!(numbering, Numbering::OneBased) {
        builder.notes.push(
            "faces number vertices from one, although OFF counts from zero; read that way"
                .to_owned(),
        );
    }
    builder.settle(numbering);
    Ok(builder)
}

/// Reads the header, which may be missing, and the number of vertices.
fn vertex_count(stream: &mut Stream<'_>) -> Result<usize, ReadError> {
    const WHAT: &str = "the number of vertices";
    let word = stream.expect("`OFF`")?;
    let is_digits = |word: &str| word.bytes().all(|byte| byte.is_ascii_digit());
    let Some(header) = Header::parse(word) else {
        let count = word.parse().ok().filter(|_| is_digits(word));
        return count.ok_or_else(|| stream.fault(format!("expected `OFF`, found `{word}`")));
    };
    if header.variant.contains(['4', 'n']) {
        let message = format!("the vertices of `{word}` are not three-dimensional: expected `OFF`");
        return Err(stream.fault(message));
    }
    if header.glued.is_empty() {
        return stream.count(WHAT);
    }
    header.glued.parse().map_err(|_| stream.fault(format!("expected {WHAT}, found `{word}`")))
}

/// Whether the faces number vertices from one, against the format: vertex 0 is never used, and the
/// vertex past the end is.
fn counts_from_one(builder: &MeshBuilder, vertices: usize) -> bool {
    let extent = builder
        .deferred_corners()
        .fold((i32::MAX, i32::MIN), |(low, high), number| (low.min(number), high.max(number)));
    extent.0 >= 1 && usize::try_from(extent.1) == Ok(vertices)
}
