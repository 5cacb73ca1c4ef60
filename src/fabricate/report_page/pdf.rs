//! The page as PDF 1.5. Text is in Helvetica, which every viewer has; other letters become question
//! marks.

use super::mark::{Colour, Mark, Shape, Text};
use crate::fabricate::file::{POINTS, assembled, places, stream};

/// Writes a page of this size in mm.
pub(super) fn pdf(marks: &[Mark], size: [f64; 2]) -> String {
    let scale = places(POINTS, 9);
    let mut content = format!("{scale} 0 0 {scale} 0 0 cm\n1 J 1 j\n");
    let mut links = Vec::new();
    for mark in marks {
        match mark {
            Mark::Text(text) => words(&mut content, text),
            Mark::Shape(shape) => lines(&mut content, shape),
            Mark::Link([low, high], target) => {
                let [a, b, c, d] =
                    [low[0], low[1], high[0], high[1]].map(|at| places(at * POINTS, 2));
                links.push(format!(
                    "<< /Type /Annot /Subtype /Link /Rect [{a} {b} {c} {d}] /Border [0 0 0] /A << /S /URI /URI ({}) >> >>",
                    escaped(target)
                ));
            }
        }
    }
    let [width, height] = size.map(|size| places(size * POINTS, 6));
    let font = |name: &str| {
        format!("<< /Type /Font /Subtype /Type1 /BaseFont /{name} /Encoding /WinAnsiEncoding >>")
    };
    let mut objects = vec![
        "<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>".to_owned(),
        "<< /Type /Pages /Kids [5 0 R] /Count 1 >>".to_owned(),
        font("Helvetica"),
        font("Helvetica-Bold"),
    ];
    let annotations: Vec<_> = (7..7 + links.len()).map(|k| format!("{k} 0 R")).collect();
    objects.push(format!(
        "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {width} {height}] /Resources << /Font << /F0 3 0 R /F1 4 0 R >> >> /Contents 6 0 R /Annots [{}] >>",
        annotations.join(" ")
    ));
    objects.push(stream(&content));
    objects.extend(links);
    assembled(&objects)
}

fn colour(colour: Colour) -> String {
    colour.map(|part| places(f64::from(part) / 255.0, 3)).join(" ")
}

fn words(content: &mut String, Text { at, size, bold, colour: own, words }: &Text) {
    let [x, y] = at.map(|at| places(at, 3));
    *content += &format!(
        "BT {} rg /F{} {} Tf {x} {y} Td ({}) Tj ET\n",
        colour(*own),
        u8::from(*bold),
        places(*size, 3),
        escaped(words)
    );
}

fn lines(content: &mut String, Shape { paths, fill, pen }: &Shape) {
    if let Some(fill) = fill {
        *content += &format!("{} rg\n", colour(*fill));
    }
    if let Some((width, own)) = pen {
        *content += &format!("{} w {} RG\n", places(*width, 3), colour(*own));
    }
    for path in paths {
        for (k, &[x, y]) in path.iter().enumerate() {
            let operator = if k == 0 { 'm' } else { 'l' };
            *content += &format!("{} {} {operator}\n", places(x, 3), places(y, 3));
        }
    }
    *content += match (fill, pen) {
        (Some(_), Some(_)) => "b\n",
        (Some(_), None) => "f\n",
        (None, _) => "S\n",
    };
}

/// Escapes Latin-1 text in `WinAnsi` encoding, with octal codes for non-ASCII.
fn escaped(text: &str) -> String {
    let letter = |letter: char| match letter {
        '(' | ')' | '\\' => format!("\\{letter}"),
        ' '..='~' => letter.to_string(),
        '\u{a0}'..='\u{ff}' => format!("\\{:o}", letter as u32),
        _ => "?".to_owned(),
    };
    text.chars().map(letter).collect()
}
