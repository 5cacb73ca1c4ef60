//! JSON as text: fields, objects, lists with one item per line.

use crate::mesh::{Decimal, Point};

pub(super) fn field(key: &str, value: String) -> String {
    format!("{}: {value}", text(key))
}

pub(super) fn object(fields: Vec<String>) -> String {
    format!("{{ {} }}", fields.join(", "))
}

/// One item per line.
pub(super) fn lines(open: char, items: Vec<String>, close: char) -> String {
    if items.is_empty() {
        return format!("{open}{close}");
    }
    format!("{open}\n    {}\n  {close}", items.join(",\n    "))
}

/// Rows in as few lines as are good to read: what a scene holds is long, not deep.
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

/// The shortest decimal that reads back to the same bits.
pub(super) fn number(value: f64) -> String {
    if value.is_finite() { Decimal(value).to_string() } else { "null".to_owned() }
}

/// A JSON string.
pub(super) fn text(value: &str) -> String {
    serde_json::Value::from(value).to_string()
}
