//! OFF, the format of Geomview (<http://www.geomview.org/docs/html/OFF.html>): a header, the numbers
//! of vertices, faces and edges, then the vertices and the faces. Its variants with colours (`COFF`),
//! normals (`NOFF`) and texture coordinates (`STOFF`) are read without those.

use super::builder::Draft;
use super::number::Numbering;
use super::outcome::Fault;
use super::stream::Stream;
use crate::mesh::{Element, counted};

/// The first word of a file.
pub(crate) struct Header<'a> {
    /// What each vertex has beside its position.
    variant: &'a str,
    /// The number of vertices, where it is glued to the word as in `OFF8`.
    glued: &'a str,
}

impl<'a> Header<'a> {
    /// The header that a word is, if it is one.
    pub(crate) fn parse(word: &'a str) -> Option<Self> {
        let (variant, glued) = word.split_once("OFF")?;
        let is_header = variant.chars().all(|c| "STCN4n".contains(c))
            && glued.chars().all(|c| c.is_ascii_digit());
        is_header.then_some(Header { variant, glued })
    }
}

pub(crate) fn read(text: &str) -> Result<Draft, Fault> {
    let mut stream = Stream::new(text);
    let vertices = vertex_count(&mut stream)?;
    let faces = stream.count("the number of faces")?;
    stream.drop_line();

    let mut draft = Draft::default();
    let vertex_rests = stream.vertices(vertices, 3, &mut draft)?;
    let mut face_rests = 0;
    for face in 1..=faces {
        let corners =
            stream.count(format_args!("the number of corners of face {face} of {faces}"))?;
        let what = format_args!("a corner of face {face} of {faces}");
        face_rests += usize::from(stream.element(Element::Face, corners, what, &mut draft)?);
    }
    if let Some(word) = stream.word() {
        let vertices = counted(vertices, "vertex", "vertices");
        let faces = counted(faces, "face", "faces");
        let message = format!("the header says {vertices} and {faces}, but after them is `{word}`");
        return Err(stream.fault(message));
    }

    if vertex_rests > 0 {
        let vertices = counted(vertex_rests, "vertex", "vertices");
        draft.notes.push(format!("further numbers of {vertices} ignored"));
    }
    if face_rests > 0 {
        let faces = counted(face_rests, "face", "faces");
        draft.notes.push(format!("colours of {faces} ignored"));
    }
    let numbering = match counts_from_one(&draft, vertices) {
        true => Numbering::OneBased,
        false => Numbering::ZeroBased,
    };
    if matches!(numbering, Numbering::OneBased) {
        draft.notes.push("the faces count vertices from one, unlike OFF: read so".to_owned());
    }
    draft.settle(numbering);
    Ok(draft)
}

/// Reads the header, which may be missing, and the number of vertices.
fn vertex_count(stream: &mut Stream<'_>) -> Result<usize, Fault> {
    const WHAT: &str = "the number of vertices";
    let word = stream.expect("`OFF`")?;
    let is_digits = |word: &str| word.bytes().all(|byte| byte.is_ascii_digit());
    let Some(header) = Header::parse(word) else {
        let count = word.parse().ok().filter(|_| is_digits(word));
        return count.ok_or_else(|| stream.fault(format!("expected `OFF`, found `{word}`")));
    };
    if header.variant.contains(['4', 'n']) {
        let message =
            format!("`{word}` has vertices of other than three dimensions: expected `OFF`");
        return Err(stream.fault(message));
    }
    if header.glued.is_empty() {
        return stream.count(WHAT);
    }
    header.glued.parse().map_err(|_| stream.fault(format!("expected {WHAT}, found `{word}`")))
}

/// Whether some program has written its own numbering from one: vertex 0 is never used, and the
/// vertex past the end is.
fn counts_from_one(draft: &Draft, vertices: usize) -> bool {
    let extent = draft
        .deferred_corners()
        .fold((i32::MAX, i32::MIN), |(low, high), number| (low.min(number), high.max(number)));
    extent.0 >= 1 && usize::try_from(extent.1) == Ok(vertices)
}
