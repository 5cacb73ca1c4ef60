//! The order of an OBJ file: which faces, curves and statements follow each other, so that the file
//! can be written as it came.

/// A part of the file.
#[derive(Clone, Debug)]
pub(crate) enum FilePart {
    /// The next faces, this many.
    Faces(u32),
    /// The next curves, this many.
    Curves(u32),
    /// The next faces that are left as they are, this many.
    Untouched(u32),
    /// A statement that groups elements or smooths them, as it is in the file.
    Statement(Box<str>),
}

/// The parts of the OBJ file of a mesh after its vertices, in order; empty for a mesh of another
/// origin. A mesh is the same mesh in whatever order its file is, so all orders are equal.
#[derive(Clone, Debug, Default)]
pub struct FileOrder(Vec<FilePart>);

impl PartialEq for FileOrder {
    fn eq(&self, _: &FileOrder) -> bool {
        true
    }
}

impl FileOrder {
    pub(crate) fn parts(&self) -> &[FilePart] {
        &self.0
    }

    /// Appends a part. Elements of one kind after each other are one part.
    pub(crate) fn push(&mut self, part: FilePart) {
        match (self.0.last_mut(), part) {
            (Some(FilePart::Faces(count)), FilePart::Faces(more))
            | (Some(FilePart::Curves(count)), FilePart::Curves(more))
            | (Some(FilePart::Untouched(count)), FilePart::Untouched(more)) => *count += more,
            (_, part) => self.0.push(part),
        }
    }

    /// Whether it has exactly these numbers of faces, curves and untouched faces.
    pub(crate) fn has(&self, counts: [usize; 3]) -> bool {
        let mut found = [0; 3];
        for part in &self.0 {
            match part {
                FilePart::Faces(count) => found[0] += *count as usize,
                FilePart::Curves(count) => found[1] += *count as usize,
                FilePart::Untouched(count) => found[2] += *count as usize,
                FilePart::Statement(_) => {}
            }
        }
        found == counts
    }
}
