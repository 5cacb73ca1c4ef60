//! Word stream for the formats that give the number of rows: OFF, Medit and PLY in text.

use super::builder::MeshBuilder;
use super::builder::ReadError;
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
    /// How many numbers were left on a line when they were last counted, with how many words followed
    /// since: to count those of a long line for each of its rows would take the square of them.
    counted: Option<(usize, usize)>,
}

impl<'a> Stream<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        Stream { lines: lines(text), words: words(""), line: 0, counted: None }
    }

    pub(crate) fn word(&mut self) -> Option<&'a str> {
        loop {
            if let Some(word) = self.words.next() {
                self.counted = self.counted.map(|(left, taken)| (left, taken + 1));
                return Some(word);
            }
            let (number, text) = self.lines.next()?;
            (self.line, self.words, self.counted) = (number, words(text), None);
        }
    }

    /// Returns the next word; `what` describes it in the error at the end of the file.
    pub(crate) fn expect(&mut self, what: impl Display) -> Result<&'a str, ReadError> {
        let end = || ReadError::whole(format!("the file ends where {what} was expected"));
        self.word().ok_or_else(end)
    }

    pub(crate) fn count(&mut self, what: impl Display) -> Result<usize, ReadError> {
        let word = self.expect(&what)?;
        word.parse().map_err(|_| self.fault(format!("expected {what}, found `{word}`")))
    }

    /// The number of the line of the last word.
    pub(crate) fn line(&self) -> usize {
        self.line
    }

    pub(crate) fn fault(&self, message: String) -> ReadError {
        ReadError::at(Some(self.line), message)
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
        match if is_packed { self.numbers_left() } else { 0 } {
            0 if is_packed && self.words.clone().next().is_none() => {
                self.drop_lone_number();
                false
            }
            rest if rest % (width + 1) == 1 => self.word().is_some(),
            _ => self.drop_line(),
        }
    }

    /// How many numbers follow on the line, before anything else.
    fn numbers_left(&mut self) -> usize {
        let is_number = |word: &&str| word.parse::<f64>().is_ok();
        let count = || self.words.clone().take_while(is_number).count();
        // Those after a word are counted anew.
        let known = self.counted.filter(|(left, taken)| taken <= left);
        let (left, taken) = known.unwrap_or_else(|| (count(), 0));
        self.counted = Some((left, taken));
        left - taken
    }

    /// Appends `count` vertices of `dimension` coordinates (two or three), skipping what follows each
    /// as in [`Stream::element`]; returns the number of those with a rest.
    pub(crate) fn vertices(
        &mut self,
        count: usize,
        dimension: usize,
        is_packed: bool,
        builder: &mut MeshBuilder,
    ) -> Result<usize, ReadError> {
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
    ) -> Result<bool, ReadError> {
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
