//! Helvetica, which every PDF viewer has, so that files embed no font: the widths of its letters
//! (Adobe's font metrics), and line breaking.

/// Widths in thousandths of the font size, from the space to the tilde.
const WIDTHS: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584,
];

/// The width of a line of text in a font of this size.
pub(super) fn width(words: &str, size: f64) -> f64 {
    let thousandths = words.chars().map(|letter| {
        let place = (letter as usize).checked_sub(' ' as usize);
        match letter {
            '\u{b0}' => 400,
            '\u{b1}' | '\u{d7}' => 584,
            '\u{b2}' => 333,
            _ => place.and_then(|place| WIDTHS.get(place)).copied().unwrap_or(556),
        }
    });
    f64::from(thousandths.map(u32::from).sum::<u32>()) * size / 1000.0
}

/// The longest prefix that is no wider than `most`.
pub(super) fn fitting(words: &str, size: f64, most: f64) -> &str {
    let mut ends = words.char_indices().map(|(at, letter)| at + letter.len_utf8());
    let mut fits = 0;
    while let Some(end) = ends.next().filter(|&end| width(&words[..end], size) <= most) {
        fits = end;
    }
    &words[..fits]
}

/// Breaks text into lines no wider than `most`, at spaces, or within words that are wider.
pub(super) fn lines(words: &str, size: f64, most: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut rest = words.trim();
    while !rest.is_empty() {
        let fits = fitting(rest, size, most);
        let end = match rest[fits.len()..].chars().next() {
            None | Some(' ') => fits.len(),
            // A single letter that is too wide gets its own line.
            Some(letter) if fits.is_empty() => letter.len_utf8(),
            Some(_) => fits.rfind(' ').unwrap_or(fits.len()),
        };
        lines.push(rest[..end].to_owned());
        rest = rest[end..].trim_start();
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_keep_all_letters_and_are_narrow_enough() {
        let words = "around a hole an axis is turned by 12.34\u{b0}, averyveryverylongwordwithoutanyspace end";
        let found = lines(words, 3.0, 30.0);
        assert!(found.len() > 3 && found.iter().all(|line| width(line, 3.0) <= 30.0), "{found:?}");
        let letters = |text: &str| text.replace(' ', "");
        assert_eq!(letters(&found.concat()), letters(words));
        assert_eq!(lines("", 3.0, 30.0), Vec::<String>::new());
        assert_eq!(lines("WWW", 3.0, 0.1), ["W", "W", "W"]);
    }
}
