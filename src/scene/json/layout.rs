//! The layout of files: one line per constraint, handle and set, and as many points per line as are
//! readable. `serde_json` writes all on one line or each number on its own, with which nobody could
//! read a scene or compare two versions of it. Fingerprints of lessons are of this text.

use crate::mesh::Decimal;
use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};
use std::cell::RefCell;
use std::io::{Result, Write};

/// The keys whose entries or items are on lines of their own.
const LINES: [&str; 7] = ["sets", "constraints", "handles", "goals", "kept", "steps", "groups"];
/// The keys of which the value has names of users for keys: none of these means anything here.
const NAMES: [&str; 2] = ["sets", "groups"];
/// The keys with rows of numbers, and those that are such lists only in a mesh.
const ROWS: [&str; 2] = ["positions", "current"];
const ROWS_OF_MESH: [&str; 3] = ["faces", "curves", "tets"];
/// Greatest length of a line of rows.
const WIDTH: usize = 96;

/// Returns the text of a file, with numbers as the shortest decimals that read back to the same
/// bits.
pub(super) fn laid_out(file: &impl Serialize) -> String {
    let text = Text::default();
    let layout = Layout { text: &text, lists: Vec::new() };
    file.serialize(&mut Serializer::with_formatter(&text, layout))
        .expect("keys are strings, and memory takes all that is written");
    let mut text = String::from_utf8(text.0.into_inner()).expect("JSON is text");
    text.push('\n');
    text
}

/// What is written so far. The serializer adds to it, and the layout also reads it, to break a line
/// before a row that is too long for it.
#[derive(Default)]
struct Text(RefCell<Vec<u8>>);

impl Write for &Text {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        self.0.borrow_mut().write(bytes)
    }
    fn flush(&mut self) -> Result<()> {
        Ok(())
    }
}

struct Layout<'a> {
    text: &'a Text,
    /// The objects and arrays that are not complete yet, from the outermost on.
    lists: Vec<List>,
}

/// An object or an array.
struct List {
    /// Greatest length of a line of several entries or items: 0 if each is on its own, and
    /// [`ONE_LINE`] if all are on the line that the list begins on.
    most: usize,
    /// The indentation of that line.
    indent: usize,
    /// The key of the last entry; empty for items, and for names of users.
    key: String,
    /// Where in the text the last entry or item begins; zero without any.
    start: usize,
    /// The length of the line before it.
    line: usize,
}

const ONE_LINE: usize = usize::MAX;

impl Layout<'_> {
    fn begin(&mut self, bracket: u8) -> Result<()> {
        let mut list = List { most: 0, indent: 0, key: String::new(), start: 0, line: 0 };
        if let Some(List { most, indent, key, .. }) = self.lists.last() {
            let key = &&**key;
            list.most = match () {
                () if LINES.contains(key) => 0,
                () if ROWS.contains(key) || *most == 0 && ROWS_OF_MESH.contains(key) => WIDTH,
                () => ONE_LINE,
            };
            list.indent = indent + if *most == ONE_LINE { 0 } else { 2 };
        }
        self.lists.push(list);
        self.text.0.borrow_mut().write_all(&[bracket])
    }

    /// Begins an entry or an item, which a `space` precedes if it is the first one on the same line.
    fn next(&mut self, first: bool, space: &str) -> Result<()> {
        let list = self.lists.last_mut().expect("it is in a list");
        let mut text = self.text.0.borrow_mut();
        text.extend(if first { space } else { ", " }.bytes());
        list.start = text.len();
        if list.most == 0 || first && list.most < ONE_LINE {
            list.break_line(&mut text);
        }
        Ok(())
    }

    fn end(&mut self, space: &str, bracket: u8) -> Result<()> {
        let list = self.lists.pop().expect("it has begun");
        let mut text = self.text.0.borrow_mut();
        match list.most {
            _ if list.start == 0 => {}
            ONE_LINE => text.extend(space.bytes()),
            _ => text.extend(new_line(list.indent)),
        }
        text.write_all(&[bracket])
    }
}

impl List {
    /// Moves the last entry or item to a new line.
    fn break_line(&mut self, text: &mut Vec<u8>) {
        let space = usize::from(text[self.start - 1] == b' ');
        text.splice(self.start - space..self.start, new_line(self.indent + 2));
        self.start += self.indent + 3 - space;
        self.line = 0;
    }
}

fn new_line(indent: usize) -> impl Iterator<Item = u8> {
    std::iter::once(b'\n').chain(std::iter::repeat_n(b' ', indent))
}

impl Formatter for Layout<'_> {
    fn write_f64<W: Write + ?Sized>(&mut self, to: &mut W, value: f64) -> Result<()> {
        write!(to, "{}", Decimal(value))
    }
    fn begin_array<W: Write + ?Sized>(&mut self, _: &mut W) -> Result<()> {
        self.begin(b'[')
    }
    fn end_array<W: Write + ?Sized>(&mut self, _: &mut W) -> Result<()> {
        self.end("", b']')
    }
    fn begin_array_value<W: Write + ?Sized>(&mut self, _: &mut W, first: bool) -> Result<()> {
        self.next(first, "")
    }
    fn end_array_value<W: Write + ?Sized>(&mut self, _: &mut W) -> Result<()> {
        let list = self.lists.last_mut().expect("an item is in a list");
        let mut text = self.text.0.borrow_mut();
        let length = text.len() - list.start;
        if list.line > 0 && list.line + length > list.most {
            list.break_line(&mut text);
        }
        list.line += length + ", ".len();
        Ok(())
    }
    fn begin_object<W: Write + ?Sized>(&mut self, _: &mut W) -> Result<()> {
        self.begin(b'{')
    }
    fn end_object<W: Write + ?Sized>(&mut self, _: &mut W) -> Result<()> {
        self.end(" ", b'}')
    }
    fn begin_object_key<W: Write + ?Sized>(&mut self, _: &mut W, first: bool) -> Result<()> {
        self.next(first, " ")
    }
    fn end_object_key<W: Write + ?Sized>(&mut self, _: &mut W) -> Result<()> {
        let (list, outer) = self.lists.split_last_mut().expect("a key is in an object");
        let own = outer.last().map_or("", |outer| &outer.key);
        let mut text = self.text.0.borrow_mut();
        if !NAMES.contains(&own) {
            list.key = String::from_utf8_lossy(&text[list.start + 1..text.len() - 1]).into_owned();
        }
        // The path of a mesh file stays on the line.
        if own == "mesh" && list.key == "positions" {
            list.most = 0;
            list.break_line(&mut text);
        }
        Ok(())
    }
    fn begin_object_value<W: Write + ?Sized>(&mut self, to: &mut W) -> Result<()> {
        to.write_all(b": ")
    }
}
