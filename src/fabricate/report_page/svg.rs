//! The page as SVG, for the screen and for printing. Text has the same width as in the PDF in any
//! font.

use super::helvetica::width;
use super::mark::{Colour, Mark, Shape, Text};
use crate::fabricate::file::{escaped, path, places};

/// Writes a page of this size in mm.
pub(super) fn svg(marks: &[Mark], [wide, high]: [f64; 2]) -> String {
    let [w, h] = [wide, high].map(|size| places(size, 6));
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}mm\" height=\"{h}mm\" viewBox=\"0 0 {w} {h}\" font-family=\"Helvetica, Arial, sans-serif\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n"
    );
    for mark in marks {
        text += &match mark {
            Mark::Text(own) => words(own, high),
            Mark::Shape(shape) => lines(shape, high),
            Mark::Link([low, up], target) => {
                let [x, y, w, h] =
                    [low[0], high - up[1], up[0] - low[0], up[1] - low[1]].map(|at| places(at, 3));
                format!(
                    "<a href=\"{}\"><rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" fill=\"transparent\"/></a>\n",
                    escaped(target)
                )
            }
        };
    }
    text + "</svg>\n"
}

fn hex([r, g, b]: Colour) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn words(Text { at, size, bold, colour, words }: &Text, high: f64) -> String {
    let [x, y, size_of_font] = [at[0], high - at[1], *size].map(|at| places(at, 3));
    // The widths of bold letters are unknown here, and nothing is beside them.
    let look = match bold {
        true => "font-weight=\"bold\"".to_owned(),
        false => format!("textLength=\"{}\"", places(width(words, *size), 3)),
    };
    format!(
        "<text x=\"{x}\" y=\"{y}\" font-size=\"{size_of_font}\" {look} fill=\"{}\">{}</text>\n",
        hex(*colour),
        escaped(words)
    )
}

fn lines(Shape { paths, fill, pen }: &Shape, high: f64) -> String {
    let end = if fill.is_some() { "Z" } else { "" };
    let d: String = paths.iter().map(|own| path(own, high) + end).collect();
    let fill = fill.map_or("none".to_owned(), hex);
    let pen = pen.map_or(String::new(), |(width, own)| {
        format!(" stroke=\"{}\" stroke-width=\"{}\"", hex(own), places(width, 3))
    });
    format!("<path d=\"{d}\" fill=\"{fill}\"{pen}/>\n")
}
