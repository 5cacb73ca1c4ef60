//! PDF 1.5 at 1:1: a page for each sheet, mm as units, a layer for each role that viewers can switch, a ruler of
//! 100 mm, and the wish not to be scaled when it is printed.

use super::drawing::{Drawing, DrawnLine};
use super::number::places;
use crate::fabricate::sheet::{Role, strokes, text_width};

/// Points of PDF in a mm.
const POINTS: f64 = 72.0 / 25.4;
/// The height of the words beside the ruler, in mm.
const WORDS: f64 = 2.0;

/// Writes all sheets as pages.
pub fn pdf(drawings: &[Drawing]) -> String {
    let layers = Role::ALL.len();
    // Objects: catalogue, list of pages, layers, then a page and its content for each sheet.
    let first_page = 3 + layers;
    let mut objects: Vec<String> = Vec::new();
    let references = |numbers: &mut dyn Iterator<Item = usize>| {
        numbers.map(|number| format!("{number} 0 R")).collect::<Vec<_>>().join(" ")
    };
    let of_layers = references(&mut (3..first_page));
    objects.push(
        format!(
            "<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> /OCProperties << /OCGs [{of_layers}] /D << /Order [{of_layers}] >> >> >>"
        ),
    );
    let pages = references(&mut (0..drawings.len()).map(|k| first_page + 2 * k));
    objects.push(format!("<< /Type /Pages /Kids [{pages}] /Count {} >>", drawings.len()));
    for role in Role::ALL {
        objects.push(format!("<< /Type /OCG /Name ({}) >>", role.layer()));
    }
    let properties: Vec<String> = (0..layers).map(|k| format!("/L{k} {} 0 R", 3 + k)).collect();
    let properties = properties.join(" ");
    for (k, drawing) in drawings.iter().enumerate() {
        let [width, height] = drawing.size.map(|size| places(size * POINTS, 6));
        let content = first_page + 2 * k + 1;
        objects.push(
            format!(
                "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {width} {height}] /Resources << /Properties << {properties} >> >> /Contents {content} 0 R >>"
            ),
        );
        let stream = page(drawing);
        let length = stream.len();
        objects.push(format!("<< /Length {length} >>\nstream\n{stream}\nendstream"));
    }
    let mut file = "%PDF-1.5
"
    .to_owned();
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

/// The operators of a page.
fn page(drawing: &Drawing) -> String {
    let scale = places(POINTS, 9);
    let mut text = format!("{scale} 0 0 {scale} 0 0 cm\n0.1 w 1 J 1 j\n");
    let ruler = ruler(drawing);
    for (k, role) in Role::ALL.into_iter().enumerate() {
        let own = drawing.lines.iter().filter(|line| line.role == role);
        let of_ruler = ruler.iter().filter(|_| role == Role::Sheet);
        let [r, g, b] = role.rgb().map(|part| places(f64::from(part) / 255.0, 3));
        text += &format!("/OC /L{k} BDC\n{r} {g} {b} RG\n");
        own.chain(of_ruler).for_each(|line| path(&mut text, line));
        text += "EMC\n";
    }
    text
}

fn path(text: &mut String, line: &DrawnLine) {
    for (k, &[x, y]) in line.points.iter().enumerate() {
        let operator = if k == 0 { 'm' } else { 'l' };
        *text += &format!("{} {} {operator}\n", places(x, 6), places(y, 6));
    }
    *text += if line.closed { "s\n" } else { "S\n" };
}

/// A ruler at the upper edge, 100 mm long where the sheet is that wide, with what it is for.
fn ruler(drawing: &Drawing) -> Vec<DrawnLine> {
    let [width, height] = drawing.size;
    let tens = ((width - 10.0) / 10.0).floor().clamp(0.0, 10.0);
    let words = format!("{} MM. PRINT AT 100 %", places(10.0 * tens, 0));
    let y = height - 1.0;
    let mut lines = vec![vec![[5.0, y], [5.0 + 10.0 * tens, y]]];
    for k in 0..=tens as u32 {
        let x = 5.0 + 10.0 * f64::from(k);
        lines.push(vec![[x, y], [x, y - 1.5]]);
    }
    let long = text_width(&words, WORDS);
    let from = 8.0 + 10.0 * tens;
    if from + long < width {
        lines.extend(strokes(&words, WORDS, [from + 0.5 * long, height - 1.8], [1.0, 0.0]));
    }
    let line = |points| {
        let (role, closed, part, panel) = (Role::Sheet, false, String::new(), None);
        DrawnLine { role, points, closed, part, panel }
    };
    lines.into_iter().map(line).collect()
}
