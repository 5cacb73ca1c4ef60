//! PDF 1.6 at 1:1: a page per sheet in mm, a layer for each role that viewers can switch on and
//! off, a ruler of 20 to 100 mm where it has room, and a request to print without scaling.

use super::drawing::{Drawing, DrawnLine};
use super::page_marks::{longest_ruler, marks};
use super::places;
use crate::fabricate::boxes::meet;
use crate::fabricate::sheet::{Role, Tile, tiles};
use crate::math::plane::{Point2, bounds};
use crate::scene::Page;
use miniz_oxide::deflate::compress_to_vec_zlib;

/// Points per mm: without a `UserUnit`, the unit of PDF.
const POINTS: f64 = 72.0 / 25.4;
/// Longest side of a page in units of its own (ISO 32000-1, annex C.2), which may be several points.
const LONGEST: f64 = 14_400.0;
/// How hard it is tried to compress, of 10.
const EFFORT: u8 = 4;

/// Writes all sheets, each on one page of its size, or on as many of the size `page` (shorter and
/// longer side in mm) as needed.
pub fn pdf(drawings: &[Drawing], page: Option<[f64; 2]>) -> Vec<u8> {
    let layers = Role::ALL.len();
    let references = |numbers: &[usize]| {
        numbers.iter().map(|number| format!("{number} 0 R")).collect::<Vec<_>>().join(" ")
    };
    let of_layers: Vec<usize> = (3..3 + layers).collect();
    let properties: Vec<String> =
        of_layers.iter().enumerate().map(|(k, number)| format!("/L{k} {number} 0 R")).collect();
    let (of_layers, properties) = (references(&of_layers), properties.join(" "));
    // Catalogue, page tree, layers; then the content of each page, and the page.
    let mut objects = vec![
        format!(
            "<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> /OCProperties << /OCGs [{of_layers}] /D << /Order [{of_layers}] >> >> >>"
        )
        .into_bytes(),
        Vec::new(),
    ];
    for role in Role::ALL {
        objects.push(format!("<< /Type /OCG /Name ({}) >>", role.layer()).into_bytes());
    }
    let mut kids = Vec::new();
    for drawing in drawings {
        for tile in tiles(drawing.size, page) {
            objects.push(stream(&shown(drawing, &tile)));
            let content = objects.len();
            let unit = user_unit(tile.page);
            let [width, height] = tile.page.map(|size| places(size * POINTS / unit, 6));
            let unit = if unit > 1.0 { format!("/UserUnit {unit} ") } else { String::new() };
            objects.push(
                format!(
                    "<< /Type /Page /Parent 2 0 R {unit}/MediaBox [0 0 {width} {height}] /Resources << /Properties << {properties} >> >> /Contents {content} 0 R >>"
                )
                .into_bytes(),
            );
            kids.push(objects.len());
        }
    }
    let (count, kids) = (kids.len(), references(&kids));
    objects[1] = format!("<< /Type /Pages /Kids [{kids}] /Count {count} >>").into_bytes();
    assembled(&objects)
}

/// Points per unit of a page of this size in mm.
fn user_unit([width, height]: [f64; 2]) -> f64 {
    (width.max(height) * POINTS / LONGEST).ceil().max(1.0)
}

/// The operators that draw some lines, layer by layer.
fn content(lines: &[&DrawnLine]) -> String {
    let mut text = String::new();
    for (k, role) in Role::ALL.into_iter().enumerate() {
        let mut own = lines.iter().filter(|line| line.role == role).peekable();
        if own.peek().is_none() {
            continue;
        }
        let [r, g, b] = role.rgb().map(|part| places(f64::from(part) / 255.0, 3));
        text += &format!("/OC /L{k} BDC\n{r} {g} {b} RG\n");
        own.for_each(|line| path(&mut text, line));
        text += "EMC\n";
    }
    text
}

/// The operators of a page of a sheet: its unit, the lines that are on it, clipped if the sheet is on
/// several, and its marks.
fn shown(drawing: &Drawing, tile: &Tile) -> String {
    let scale = places(POINTS / user_unit(tile.page), 9);
    let mut text = format!("{scale} 0 0 {scale} 0 0 cm\n{} w 1 J 1 j\n", places(drawing.pen, 3));
    let marks = match tile.place {
        None => {
            text += &content(&drawing.lines.iter().collect::<Vec<_>>());
            longest_ruler(&drawing.free)
        }
        Some([place, counts]) => {
            let [low, high] = Page::frame(tile.page);
            let [x, y] = tile.origin.map(|at| places(-at, 6));
            let [left, bottom] = low.map(|at| places(at, 6));
            let [width, height] = [0, 1].map(|k| places(high[k] - low[k], 6));
            text += &format!("q {left} {bottom} {width} {height} re W n\n1 0 0 1 {x} {y} cm\n");
            // A line is as wide as the pen.
            let of_sheet =
                |corner: Point2, by: f64| [0, 1].map(|k| corner[k] + tile.origin[k] + by);
            let frame = [of_sheet(low, -drawing.pen), of_sheet(high, drawing.pen)];
            let is_on_it = |line: &&DrawnLine| meet(bounds(line.points.iter().copied()), frame);
            text += &content(&drawing.lines.iter().filter(is_on_it).collect::<Vec<_>>());
            text += "Q\n";
            marks(&drawing.name, tile.page, place, counts)
        }
    };
    let marks: Vec<_> = marks.into_iter().map(DrawnLine::of_sheet).collect();
    text + &content(&marks.iter().collect::<Vec<_>>())
}

fn path(text: &mut String, line: &DrawnLine) {
    for (k, &[x, y]) in line.points.iter().enumerate() {
        let operator = if k == 0 { 'm' } else { 'l' };
        *text += &format!("{} {} {operator}\n", places(x, 6), places(y, 6));
    }
    *text += if line.closed { "s\n" } else { "S\n" };
}

/// Makes a stream object, such as the content of a page, compressed.
fn stream(text: &str) -> Vec<u8> {
    let data = compress_to_vec_zlib(text.as_bytes(), EFFORT);
    let head = format!("<< /Filter /FlateDecode /Length {} >>\nstream\n", data.len());
    [head.as_bytes(), &data, b"\nendstream"].concat()
}

/// The file, with the cross-reference table of the objects, which are numbered from one; the first
/// is the catalogue. The comment in the second line says that the file is binary (ISO 32000-1, 7.5.2).
fn assembled(objects: &[Vec<u8>]) -> Vec<u8> {
    let mut file = b"%PDF-1.6\n%\xE2\xE3\xCF\xD3\n".to_vec();
    let mut starts = Vec::new();
    for (object, number) in objects.iter().zip(1..) {
        starts.push(file.len());
        file.extend(format!("{number} 0 obj\n").into_bytes());
        file.extend(object);
        file.extend(b"\nendobj\n");
    }
    let table = file.len();
    let count = objects.len() + 1;
    let mut end = format!("xref\n0 {count}\n0000000000 65535 f \n");
    for start in starts {
        end += &format!("{start:010} 00000 n \n");
    }
    end += &format!("trailer\n<< /Size {count} /Root 1 0 R >>\nstartxref\n{table}\n%%EOF\n");
    file.extend(end.into_bytes());
    file
}
