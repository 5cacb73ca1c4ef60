//! SVG: width, height and viewBox in mm, so that no program guesses the size of a pixel.
//! Coordinates are absolute, without transforms, styles or references, which simple programs
//! ignore. Each layer is a group, as in Inkscape.

use super::drawing::{Drawing, DrawnLine};
use super::places;
use crate::fabricate::sheet::Role;
use crate::math::plane::Point2;

/// Writes a sheet.
pub fn svg(drawing: &Drawing) -> String {
    let [width, height] = drawing.size.map(|size| places(size, 6));
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\">\n<title>{}</title>\n",
        escaped(&drawing.title)
    );
    let pen = places(drawing.pen, 3);
    for role in Role::ALL {
        let mut lines = drawing.lines.iter().filter(|line| line.role == role).peekable();
        if lines.peek().is_none() {
            continue;
        }
        let (layer, [r, g, b]) = (role.layer(), role.rgb());
        text += &format!(
            "<g id=\"{layer}\" inkscape:groupmode=\"layer\" inkscape:label=\"{layer}\" fill=\"none\" stroke=\"#{r:02X}{g:02X}{b:02X}\" stroke-width=\"{pen}\">\n"
        );
        let lines: Vec<_> = lines.collect();
        // The names on a part are one path, which makes the document smaller, and so is its outline.
        for own in lines.chunk_by(|a, b| a.part == b.part) {
            let path = |line: &&DrawnLine| {
                path(&line.points, drawing.size[1]) + if line.closed { "Z" } else { "" }
            };
            let path: String = own.iter().map(path).collect();
            let part = escaped(&own[0].part);
            match role {
                Role::Cut => {
                    text +=
                        &format!("<path id=\"{part}\" d=\"{path}\"><title>{part}</title></path>\n");
                }
                _ => text += &format!("<path d=\"{path}\"/>\n"),
            }
        }
        text += "</g>\n";
    }
    text + "</svg>\n"
}

/// The points of a line as part of a path on a sheet of this height, with y downwards. A single
/// point becomes a line of zero length.
fn path(points: &[Point2], height: f64) -> String {
    let end = if points.len() == 1 { "h0" } else { "" };
    let points = points.iter().enumerate().map(|(k, &[x, y])| {
        let letter = if k == 0 { 'M' } else { 'L' };
        format!("{letter}{},{}", places(x, 6), places(height - y, 6))
    });
    points.collect::<String>() + end
}

/// Escapes text for XML, without control characters, which it must not have.
pub(crate) fn escaped(text: &str) -> String {
    let text: String = text.chars().filter(|c| !c.is_control() || "\t\n\r".contains(*c)).collect();
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
