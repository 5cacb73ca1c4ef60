//! PDF 1.6 at 1:1: a page per sheet in mm, a layer for each role that viewers can switch on and
//! off, a ruler of 100 mm, and a request to print without scaling.

use super::drawing::{Drawing, DrawnLine};
use super::places;
use crate::fabricate::sheet::{FREE, OVERLAP, Role, Tile, strokes, text_width, tiles};
use crate::math::plane::Point2;
use miniz_oxide::deflate::compress_to_vec_zlib;

/// Points per mm: without a `UserUnit`, the unit of PDF.
const POINTS: f64 = 72.0 / 25.4;
/// Longest side of a page in units of its own (ISO 32000-1, annex C.2), which may be several points.
const LONGEST: f64 = 14_400.0;
/// How hard it is tried to compress, of 10.
const EFFORT: u8 = 4;
/// Height of text beside the ruler, in mm.
const TEXT_HEIGHT: f64 = 2.0;

/// Writes all sheets, each on one page of its size, or on as many of the size `page` (shorter and
/// longer side in mm) as needed.
pub fn pdf(drawings: &[Drawing], page: Option<[f64; 2]>) -> String {
    let layers = Role::ALL.len();
    let references = |numbers: &[usize]| {
        numbers.iter().map(|number| format!("{number} 0 R")).collect::<Vec<_>>().join(" ")
    };
    let of_layers: Vec<usize> = (3..3 + layers).collect();
    let properties: Vec<String> =
        of_layers.iter().enumerate().map(|(k, number)| format!("/L{k} {number} 0 R")).collect();
    let (of_layers, properties) = (references(&of_layers), properties.join(" "));
    // Catalogue, page tree, layers; then for each sheet its content, and three objects for each of
    // its pages.
    let mut objects = vec![
        format!(
            "<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> /OCProperties << /OCGs [{of_layers}] /D << /Order [{of_layers}] >> >> >>"
        ),
        String::new(),
    ];
    for role in Role::ALL {
        objects.push(format!("<< /Type /OCG /Name ({}) >>", role.layer()));
    }
    let mut kids = Vec::new();
    for drawing in drawings {
        objects.push(stream(&content(&drawing.lines)));
        let shared = objects.len();
        for tile in tiles(drawing.size, page) {
            let (before, after) = around(drawing, &tile);
            objects.extend([stream(&before), stream(&after)]);
            let contents = references(&[objects.len() - 1, shared, objects.len()]);
            let unit = user_unit(tile.page);
            let [width, height] = tile.page.map(|size| places(size * POINTS / unit, 6));
            let unit = if unit > 1.0 { format!("/UserUnit {unit} ") } else { String::new() };
            objects.push(
                format!(
                    "<< /Type /Page /Parent 2 0 R {unit}/MediaBox [0 0 {width} {height}] /Resources << /Properties << {properties} >> >> /Contents [{contents}] >>"
                ),
            );
            kids.push(objects.len());
        }
    }
    objects[1] = format!("<< /Type /Pages /Kids [{}] /Count {} >>", references(&kids), kids.len());
    assembled(&objects)
}

/// Points per unit of a page of this size in mm.
fn user_unit([width, height]: [f64; 2]) -> f64 {
    (width.max(height) * POINTS / LONGEST).ceil().max(1.0)
}

/// The operators that draw some lines, layer by layer.
fn content(lines: &[DrawnLine]) -> String {
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

/// The operators before and after the content of a sheet on one of its pages: unit, clipping
/// rectangle, ruler, and cutting marks.
fn around(drawing: &Drawing, tile: &Tile) -> (String, String) {
    let scale = places(POINTS / user_unit(tile.page), 9);
    let mut before = format!("{scale} 0 0 {scale} 0 0 cm\n{} w 1 J 1 j\n", places(drawing.pen, 3));
    let mut lines = ruler(tile.page);
    let mut after = String::new();
    if let Some([place, counts]) = tile.place {
        let [width, height] = tile.page.map(|size| size - 2.0 * FREE);
        let [x, y] = tile.origin.map(|at| places(-at, 6));
        before += &format!(
            "q {FREE} {FREE} {} {} re W n\n1 0 0 1 {x} {y} cm\n",
            places(width, 6),
            places(height, 6)
        );
        after += "Q\n";
        lines.extend(marks(drawing, tile.page, place, counts));
    }
    let lines: Vec<_> = lines.into_iter().map(DrawnLine::of_sheet).collect();
    (before, after + &content(&lines))
}

/// The frame along which a page is cut, ticks where the next page begins, and the number of the
/// page.
fn marks(
    drawing: &Drawing,
    page: [f64; 2],
    [column, row]: [u32; 2],
    [columns, rows]: [u32; 2],
) -> Vec<Vec<Point2>> {
    let [right, top] = page.map(|size| size - FREE);
    let mut lines =
        vec![vec![[FREE, FREE], [right, FREE], [right, top], [FREE, top], [FREE, FREE]]];
    let tick = 4.0;
    if column + 1 < columns {
        let x = right - OVERLAP;
        lines.extend([vec![[x, FREE], [x, FREE + tick]], vec![[x, top - tick], [x, top]]]);
    }
    if row + 1 < rows {
        let y = top - OVERLAP;
        lines.extend([vec![[FREE, y], [FREE + tick, y]], vec![[right - tick, y], [right, y]]]);
    }
    let words = format!(
        "{}, COLUMN {} OF {columns}, ROW {} OF {rows} FROM BELOW",
        drawing.name,
        column + 1,
        row + 1
    );
    let centre = [FREE + 0.5 * text_width(&words, TEXT_HEIGHT), 0.5 * FREE];
    lines.extend(strokes(&words, TEXT_HEIGHT, centre, [1.0, 0.0]));
    lines
}

fn path(text: &mut String, line: &DrawnLine) {
    for (k, &[x, y]) in line.points.iter().enumerate() {
        let operator = if k == 0 { 'm' } else { 'l' };
        *text += &format!("{} {} {operator}\n", places(x, 6), places(y, 6));
    }
    *text += if line.closed { "s\n" } else { "S\n" };
}

/// A ruler at the upper edge of a page with an instruction, 100 mm long if the page is wide enough.
fn ruler([width, height]: [f64; 2]) -> Vec<Vec<Point2>> {
    let tens = ((width - 10.0) / 10.0).floor().clamp(0.0, 10.0);
    let words = format!("{} MM. PRINT AT 100 %", places(10.0 * tens, 0));
    let y = height - 1.0;
    let mut lines = vec![vec![[5.0, y], [5.0 + 10.0 * tens, y]]];
    for k in 0..=tens as u32 {
        let x = 5.0 + 10.0 * f64::from(k);
        lines.push(vec![[x, y], [x, y - 1.5]]);
    }
    let long = text_width(&words, TEXT_HEIGHT);
    let from = 8.0 + 10.0 * tens;
    if from + long < width {
        lines.extend(strokes(&words, TEXT_HEIGHT, [from + 0.5 * long, height - 1.8], [1.0, 0.0]));
    }
    lines
}

/// Makes a stream object, such as the content of a page: compressed, and written as text, as all
/// files of a build are.
fn stream(text: &str) -> String {
    let data = ascii85(&compress_to_vec_zlib(text.as_bytes(), EFFORT));
    format!(
        "<< /Filter [/ASCII85Decode /FlateDecode] /Length {} >>\nstream\n{data}\nendstream",
        data.len()
    )
}

/// Four bytes as five digits to the base 85 (Adobe, *PostScript Language Reference*, 3.13.3), in lines.
fn ascii85(bytes: &[u8]) -> String {
    const LINE: usize = 20;
    let mut text = String::with_capacity(bytes.len() / 4 * 5 + bytes.len() / 80 + 8);
    for (group, bytes) in bytes.chunks(4).enumerate() {
        if group > 0 && group % LINE == 0 {
            text.push('\n');
        }
        let mut four = [0; 4];
        four[..bytes.len()].copy_from_slice(bytes);
        let number = u32::from_be_bytes(four);
        if number == 0 && bytes.len() == 4 {
            text.push('z');
            continue;
        }
        // Of a group that is not whole, one digit more than it has bytes.
        let digits = (0..5).rev().map(|place| number / 85_u32.pow(place) % 85);
        text.extend(digits.take(bytes.len() + 1).map(|digit| char::from(b'!' + digit as u8)));
    }
    text + "~>"
}

/// The file, with the cross-reference table of the objects, which are numbered from one; the first
/// is the catalogue.
fn assembled(objects: &[String]) -> String {
    let mut file = "%PDF-1.6\n".to_owned();
    let mut starts = Vec::new();
    for (object, number) in objects.iter().zip(1..) {
        starts.push(file.len());
        file += &format!("{number} 0 obj\n{object}\nendobj\n");
    }
    let table = file.len();
    let count = objects.len() + 1;
    file += &format!("xref\n0 {count}\n0000000000 65535 f \n");
    for start in starts {
        file += &format!("{start:010} 00000 n \n");
    }
    file + &format!("trailer\n<< /Size {count} /Root 1 0 R >>\nstartxref\n{table}\n%%EOF\n")
}

#[cfg(test)]
mod tests {
    use super::ascii85;

    #[test]
    fn bytes_are_written_as_digits_to_the_base_85() {
        let known =
            [("", ""), ("sure.", "F*2M7/c"), ("Ma", "9jn"), ("Man", "9jqo"), ("Man ", "9jqo^")];
        for (bytes, digits) in known {
            assert_eq!(ascii85(bytes.as_bytes()), format!("{digits}~>"));
        }
        assert_eq!(ascii85(&[0; 7]), "z!!!!~>");
        assert_eq!(ascii85(&[1; 84]).lines().map(str::len).collect::<Vec<_>>(), [100, 7]);
    }
}
