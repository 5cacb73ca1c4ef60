//! Formatting JSON: fields, objects, lists with one item per line.

use crate::mesh::{Decimal, Point};

pub(super) fn field(key: &str, value: String) -> String {
    format!("{}: {value}", text(key))
}

pub(super) fn object(fields: Vec<String>) -> String {
    format!("{{ {} }}", fields.join(", "))
}

pub(super) fn lines(open: char, items: Vec<String>, close: char) -> String {
    if items.is_empty() {
        return format!("{open}{close}");
    }
    format!("{open}\n    {}\n  {close}", items.join(",\n    "))
}

/// Formats rows with as many per line as are readable, since scenes have long flat lists.
pub(super) fn rows(rows: impl Iterator<Item = String>, indent: &str) -> String {
    let mut text = String::from("[");
    let mut width = 0;
    for (i, row) in rows.enumerate() {
        if i > 0 {
            text.push(',');
        }
        if i == 0 || width + row.len() > 96 {
            text.push_str(&format!("\n{indent}    "));
            width = 0;
        } else {
            text.push(' ');
        }
        width += row.len() + 2;
        text.push_str(&row);
    }
    text.push_str(&format!("\n{indent}  ]"));
    text
}

pub(super) fn points(points: &[Point]) -> String {
    let items: Vec<_> = points.iter().map(point).collect();
    format!("[{}]", items.join(", "))
}

pub(super) fn point(point: &Point) -> String {
    let [x, y, z] = point.map(number);
    format!("[{x}, {y}, {z}]")
}

/// Formats a number as the shortest decimal that reads back to the same bits; `null` if not finite.
pub(super) fn number(value: f64) -> String {
    if value.is_finite() { Decimal(value).to_string() } else { "null".to_owned() }
}

pub(super) fn text(value: &str) -> String {
    serde_json::Value::from(value).to_string()
}
