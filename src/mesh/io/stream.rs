//! Word stream for the formats that give the number of rows: OFF and Medit.

use super::builder::MeshBuilder;
use super::builder::ReadFault;
use super::lines::{Lines, lines, words};
use super::number::whole;
use crate::mesh::ElementKind;
use std::fmt::Display;
use std::str::SplitAsciiWhitespace;

/// Stream of the words of a file, across lines.
pub(crate) struct Stream<'a> {
    lines: Lines<'a>,
    words: SplitAsciiWhitespace<'a>,
    line: usize,
}

impl<'a> Stream<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        Stream { lines: lines(text), words: words(""), line: 0 }
    }

    pub(crate) fn word(&mut self) -> Option<&'a str> {
        loop {
            if let Some(word) = self.words.next() {
                return Some(word);
            }
            let (number, text) = self.lines.next()?;
            (self.line, self.words) = (number, words(text));
        }
    }

    /// Returns the next word; `what` describes it in the error at the end of the file.
    pub(crate) fn expect(&mut self, what: impl Display) -> Result<&'a str, ReadFault> {
        let end = || ReadFault::whole(format!("the file ends where {what} was expected"));
        self.word().ok_or_else(end)
    }

    pub(crate) fn count(&mut self, what: impl Display) -> Result<usize, ReadFault> {
        let word = self.expect(&what)?;
        word.parse().map_err(|_| self.fault(format!("expected {what}, found `{word}`")))
    }

    /// The number of the line of the last word.
    pub(crate) fn line(&self) -> usize {
        self.line
    }

    pub(crate) fn fault(&self, message: String) -> ReadFault {
        ReadFault { line: Some(self.line), message }
    }

    /// Skips the rest of the line; returns whether it had any words.
    pub(crate) fn drop_line(&mut self) -> bool {
        std::mem::replace(&mut self.words, words("")).next().is_some()
    }

    /// Skips the next line if it is a whole number and nothing else.
    pub(crate) fn drop_lone_number(&mut self) {
        let mut lines = self.lines.clone();
        let next = lines.find_map(|(_, text)| {
            let mut words = words(text);
            words.next().map(|word| (word, words.next()))
        });
        if let Some((word, None)) = next
            && whole(word).is_some()
        {
            self.lines = lines;
        }
    }

    /// Skips what follows the `width` numbers of a row: the rest of the line or, if `is_packed`, one
    /// number, wherever it is, where rows may share a line. Returns whether there was a rest.
    fn end_row(&mut self, width: usize, is_packed: bool) -> bool {
        match self.words.clone().count() {
            0 if is_packed => {
                self.drop_lone_number();
                false
            }
            rest if is_packed && rest % (width + 1) == 1 => self.words.next().is_some(),
            _ => self.drop_line(),
        }
    }

    /// Appends `count` vertices of `dimension` coordinates (two or three), skipping what follows each
    /// as in [`Stream::element`]; returns the number of those with a rest.
    pub(crate) fn vertices(
        &mut self,
        count: usize,
        dimension: usize,
        is_packed: bool,
        builder: &mut MeshBuilder,
    ) -> Result<usize, ReadFault> {
        let mut rests = 0;
        for vertex in 1..=count {
            let mut coordinates = ["0"; 3];
            for coordinate in &mut coordinates[..dimension] {
                *coordinate = self.expect(format_args!("vertex {vertex} of {count}"))?;
            }
            builder.vertex(coordinates, self.line);
            rests += usize::from(self.end_row(dimension, is_packed));
        }
        Ok(rests)
    }

    /// Defers an element with this number of corners; `what` describes it in errors. It may span
    /// lines; the rest of its last line is skipped or, if `is_packed`, only the number at the end of
    /// the row. Returns whether there was a rest.
    pub(crate) fn element(
        &mut self,
        element: ElementKind,
        corners: usize,
        is_packed: bool,
        what: impl Display,
        builder: &mut MeshBuilder,
    ) -> Result<bool, ReadFault> {
        let mut first_line = None;
        for _ in 0..corners {
            let word = self.expect(&what)?;
            first_line.get_or_insert(self.line);
            builder.defer_corner(whole(word));
        }
        builder.defer_element(element, Some(first_line.unwrap_or(self.line)));
        Ok(self.end_row(corners, is_packed))
    }
}
