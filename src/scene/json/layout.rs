//! The layout of files: one line per constraint, handle and set, and as many points per line as are
//! readable. `serde_json` writes all on one line or each number on its own, with which nobody could
//! read a scene or compare two versions of it.

use crate::mesh::Decimal;
use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};
use std::io;

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
    let mut text = Vec::new();
    file.serialize(&mut Serializer::with_formatter(&mut text, Numbers))
        .expect("keys are strings, and memory takes all that is written");
    let text = String::from_utf8(text).expect("JSON is text");
    let mut layout =
        Layout { rest: &text, out: String::with_capacity(text.len() + text.len() / 4) };
    layout.entries(0, true, false);
    assert!(layout.rest.is_empty(), "all of the document is laid out");
    layout.out.push('\n');
    layout.out
}

struct Numbers;

impl Formatter for Numbers {
    fn write_f64<W: io::Write + ?Sized>(&mut self, to: &mut W, value: f64) -> io::Result<()> {
        write!(to, "{}", Decimal(value))
    }
}

/// Text without white space, as far as it is not laid out yet.
struct Layout<'a> {
    rest: &'a str,
    out: String,
}

impl<'a> Layout<'a> {
    /// Lays out the value of `key`. The lines around it are indented by `indent`; `in_lines` tells
    /// whether the object that has the key is on several lines.
    fn value(&mut self, key: &str, indent: usize, in_lines: bool) {
        let on_lines = LINES.contains(&key);
        match self.rest.as_bytes().first() {
            Some(b'{') => {
                let is_mesh = key == "mesh" && self.rest.starts_with("{\"positions\"");
                self.entries(indent, on_lines || is_mesh, NAMES.contains(&key));
            }
            Some(b'[')
                if self.rest.starts_with("[[")
                    && (ROWS.contains(&key) || (in_lines && ROWS_OF_MESH.contains(&key))) =>
            {
                self.rows(indent);
            }
            Some(b'[') => self.items(indent, on_lines),
            _ => {
                let word = self.word();
                self.out.push_str(word);
            }
        }
    }

    /// Lays out an object; with `named`, its keys are names of users.
    fn entries(&mut self, indent: usize, on_lines: bool, named: bool) {
        self.list('}', indent, on_lines, |layout, inner| {
            let key = layout.word();
            layout.out.push_str(key);
            layout.take(1);
            layout.out.push_str(": ");
            let meaning = if named { "" } else { key.trim_matches('"') };
            layout.value(meaning, inner, on_lines && !named);
        });
    }

    fn items(&mut self, indent: usize, on_lines: bool) {
        self.list(']', indent, on_lines, |layout, inner| layout.value("", inner, false));
    }

    /// Lays out what is between brackets, each on a line of its own or all on one.
    fn list(
        &mut self,
        close: char,
        indent: usize,
        on_lines: bool,
        mut one: impl FnMut(&mut Self, usize),
    ) {
        if self.open(close) {
            return;
        }
        let inner = if on_lines { indent + 2 } else { indent };
        let space = if close == '}' { " " } else { "" };
        let mut is_first = true;
        loop {
            match (on_lines, is_first) {
                (true, _) => self.new_line(inner),
                (false, true) => self.out.push_str(space),
                (false, false) => self.out.push(' '),
            }
            is_first = false;
            one(self, inner);
            if self.take(1) != "," {
                break;
            }
            self.out.push(',');
        }
        match on_lines {
            true => self.new_line(indent),
            false => self.out.push_str(space),
        }
        self.out.push(close);
    }

    /// Lays out an array of arrays of numbers.
    fn rows(&mut self, indent: usize) {
        if self.open(']') {
            return;
        }
        let (mut width, mut is_first) = (0, true);
        loop {
            let length = self.rest.find(']').map_or(self.rest.len(), |end| end + 1);
            let row = self.take(length);
            // A space follows each comma.
            let long = row.len() + row.bytes().filter(|byte| *byte == b',').count();
            if is_first || width + long > WIDTH {
                self.new_line(indent + 2);
                width = 0;
            } else {
                self.out.push(' ');
            }
            is_first = false;
            width += long + 2;
            for (k, number) in row.split(',').enumerate() {
                self.out.push_str(if k > 0 { ", " } else { "" });
                self.out.push_str(number);
            }
            if self.take(1) != "," {
                break;
            }
            self.out.push(',');
        }
        self.new_line(indent);
        self.out.push(']');
    }

    /// Copies the opening bracket, and the closing one if nothing is between them: returns whether.
    fn open(&mut self, close: char) -> bool {
        let is_empty = self.rest[1..].starts_with(close);
        let brackets = self.take(if is_empty { 2 } else { 1 });
        self.out.push_str(brackets);
        is_empty
    }

    fn new_line(&mut self, indent: usize) {
        self.out.push('\n');
        self.out.extend(std::iter::repeat_n(' ', indent));
    }

    fn take(&mut self, length: usize) -> &'a str {
        let (taken, rest) = self.rest.split_at(length);
        self.rest = rest;
        taken
    }

    /// Takes a string, a number or a word.
    fn word(&mut self) -> &'a str {
        let bytes = self.rest.as_bytes();
        if bytes.first() != Some(&b'"') {
            return self.take(bytes.iter().position(|c| b",]}".contains(c)).unwrap_or(bytes.len()));
        }
        let mut end = 1;
        while bytes.get(end).is_some_and(|c| *c != b'"') {
            end += if bytes[end] == b'\\' { 2 } else { 1 };
        }
        self.take((end + 1).min(bytes.len()))
    }
}
