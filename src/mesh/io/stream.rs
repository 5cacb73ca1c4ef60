//! The rows of the formats that say how many follow: OFF and Medit.

use std::fmt::Display;
use std::str::SplitAsciiWhitespace;

use super::builder::MeshBuilder;
use super::lines::{Lines, lines, words};
use super::number::whole;
use super::outcome::ReadFault;
use crate::mesh::ElementKind;

/// The words of a file across its lines.
pub(crate) struct Stream<'a> {
    lines: Lines<'a>,
    words: SplitAsciiWhitespace<'a>,
    line: usize,
}

impl<'a> Stream<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        Stream { lines: lines(text), words: words(""), line: 0 }
    }

    /// The next word.
    pub(crate) fn word(&mut self) -> Option<&'a str> {
        loop {
            if let Some(word) = self.words.next() {
                return Some(word);
            }
            let (number, text) = self.lines.next()?;
            (self.line, self.words) = (number, words(text));
        }
    }

    /// The next word, which is to be `what`.
    pub(crate) fn expect(&mut self, what: impl Display) -> Result<&'a str, ReadFault> {
        let end = || ReadFault::whole(format!("the file ends where {what} was expected"));
        self.word().ok_or_else(end)
    }

    /// The next word as a number of things.
    pub(crate) fn count(&mut self, what: impl Display) -> Result<usize, ReadFault> {
        let word = self.expect(&what)?;
        word.parse().map_err(|_| self.fault(format!("expected {what}, found `{word}`")))
    }

    /// A fault of the line at hand.
    pub(crate) fn fault(&self, message: String) -> ReadFault {
        ReadFault { line: Some(self.line), message }
    }

    /// Leaves out the rest of the line; tells whether there was any.
    pub(crate) fn drop_line(&mut self) -> bool {
        std::mem::replace(&mut self.words, words("")).next().is_some()
    }

    /// Appends `count` vertices of `dimension` coordinates (two or three), each with the rest of its
    /// line left out; returns how many lines had a rest.
    pub(crate) fn vertices(
        &mut self,
        count: usize,
        dimension: usize,
        builder: &mut MeshBuilder,
    ) -> Result<usize, ReadFault> {
        let mut rests = 0;
        for vertex in 1..=count {
            let mut coordinates = ["0"; 3];
            for coordinate in &mut coordinates[..dimension] {
                *coordinate = self.expect(format_args!("vertex {vertex} of {count}"))?;
            }
            builder.vertex(coordinates, self.line);
            rests += usize::from(self.drop_line());
        }
        Ok(rests)
    }

    /// Keeps an element of so many corners in the draft; `what` names it. It may run over lines;
    /// the rest of its last line is left out. Tells whether there was any.
    pub(crate) fn element(
        &mut self,
        element: ElementKind,
        corners: usize,
        what: impl Display,
        builder: &mut MeshBuilder,
    ) -> Result<bool, ReadFault> {
        let mut first_line = None;
        for _ in 0..corners {
            let word = self.expect(&what)?;
            first_line.get_or_insert(self.line);
            builder.defer_corner(whole(word));
        }
        builder.defer_element(element, first_line.unwrap_or(self.line));
        Ok(self.drop_line())
    }
}
