//! Comma-separated values (RFC 4180): UTF-8, a header with units, a point as decimal mark.

use super::places;
use std::borrow::Cow;

/// A table that grows by rows.
#[derive(Clone, Debug)]
pub struct Table(String);

impl Table {
    /// A table with these columns.
    pub fn new(columns: &[&str]) -> Table {
        let mut table = Table(String::new());
        table.row(columns.iter().map(|&column| Cell::from(column)));
        table
    }

    /// Appends a row.
    pub fn row<'a>(&mut self, cells: impl IntoIterator<Item = Cell<'a>>) {
        for (k, cell) in cells.into_iter().enumerate() {
            if k > 0 {
                self.0.push(',');
            }
            match cell {
                Cell::Text(text) => self.0 += &text_field(text),
                // In steps of 1e-6 mm, so that sums of areas agree with the areas of the outlines.
                Cell::Number(number) => self.0 += &places(number, 6),
                Cell::Count(count) => self.0 += &count.to_string(),
                Cell::None => {}
            }
        }
        self.0 += "\r\n";
    }

    /// The text of the file.
    pub fn into_text(self) -> String {
        self.0
    }
}

/// A text as a field of CSV: quoted if necessary, and never a formula.
pub fn text_field(text: &str) -> String {
    let text = not_a_formula(text);
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.into_owned(),
    }
}

/// The text, with an apostrophe before it if a spreadsheet would take it as a formula: names in files
/// of others are untrusted.
pub fn not_a_formula(text: &str) -> Cow<'_, str> {
    match text.starts_with(['=', '+', '-', '@', '\t', '\r']) {
        true => format!("'{text}").into(),
        false => text.into(),
    }
}

/// One value of a row.
#[derive(Clone, Copy, Debug)]
pub enum Cell<'a> {
    /// Text, as [`text_field`] writes it.
    Text(&'a str),
    /// A number with a decimal point.
    Number(f64),
    /// A whole number.
    Count(usize),
    /// An empty cell.
    None,
}

impl<'a> From<&'a str> for Cell<'a> {
    fn from(text: &'a str) -> Self {
        Cell::Text(text)
    }
}

impl From<f64> for Cell<'_> {
    fn from(number: f64) -> Self {
        Cell::Number(number)
    }
}

impl From<usize> for Cell<'_> {
    fn from(count: usize) -> Self {
        Cell::Count(count)
    }
}

impl From<Option<f64>> for Cell<'_> {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Cell::None, Cell::Number)
    }
}
