//! Single-line letters on a grid of 4 by 6: machines engrave the outlines of a font twice, and
//! cutting services do not accept text.

use crate::math::plane::{Point2, rotated};

/// Grid units from one letter to the next.
const ADVANCE: f64 = 6.0;
/// Height of a letter in grid units.
const HEIGHT: f64 = 6.0;
/// Width of a letter in grid units.
const WIDTH: f64 = 4.0;
/// Smallest height of names, in mm: lower ones are not engraved.
pub(super) const LEAST: f64 = 2.0;
/// Sine of the angle by which a nearly vertical text may lean backwards and still read upwards.
const LEANING: f64 = 0.2;

/// The direction or its opposite, such that letters are upright when the part is rotated; nearly
/// vertical text on the sheet reads upwards.
pub(in crate::fabricate) fn upright(along: Point2, turn: Point2) -> Point2 {
    let [c, s] = rotated(along, turn);
    if c < -LEANING || (c <= LEANING && s < 0.0) { along.map(|x| -x) } else { along }
}

/// The strokes of a letter, or of `?` instead of one that has none: pairs of digits are the x and y of
/// points.
fn glyph(letter: char) -> &'static [&'static str] {
    match letter.to_ascii_uppercase() {
        'A' => &["002640", "1333"],
        'B' => &["00063645443303", "3342413000"],
        'C' => &["4536160501103041"],
        'D' => &["00062644422000"],
        'E' => &["46060040", "0333"],
        'F' => &["460600", "0333"],
        'G' => &["45361605011030414323"],
        'H' => &["0006", "4046", "0343"],
        'I' => &["1030", "2026", "1636"],
        'J' => &["4641301001"],
        'K' => &["0006", "460340"],
        'L' => &["060040"],
        'M' => &["0006234640"],
        'N' => &["00064046"],
        'O' => &["100105163645413010"],
        'P' => &["00063645443303"],
        'Q' => &["100105163645413010", "2240"],
        'R' => &["00063645443303", "2340"],
        'S' => &["453616050413334241301001"],
        'T' => &["0646", "2620"],
        'U' => &["060110304146"],
        'V' => &["062046"],
        'W' => &["0610233046"],
        'X' => &["0046", "0640"],
        'Y' => &["062346", "2320"],
        'Z' => &["06460040"],
        '0' => &["100105163645413010", "1135"],
        '1' => &["152620", "1030"],
        '2' => &["05163645440040"],
        '3' => &["05163645443313", "334241301001"],
        '4' => &["30360242"],
        '5' => &["460603334241301001"],
        '6' => &["4536160501103041423303"],
        '7' => &["064610"],
        '8' => &["13334445361605041302011030414233"],
        '9' => &["0110304145361605041343"],
        '-' => &["1333"],
        '+' => &["1333", "2422"],
        '.' => &["2021"],
        ',' => &["2110"],
        ':' => &["2122", "2425"],
        '/' => &["0046"],
        '%' => &["0046", "0616150506", "3141403031"],
        '(' => &["36252130"],
        ')' => &["16252110"],
        '[' => &["36161030"],
        ']' => &["16363010"],
        '_' => &["0040"],
        '#' => &["1016", "3036", "0242", "0444"],
        '&' => &["4014152635340201102042"],
        '\'' => &["2624"],
        '"' => &["1614", "3634"],
        '!' => &["2622", "2021"],
        ' ' => &[],
        _ => &["05163645442322", "2021"],
    }
}

/// Letters of ASCII, each before those instead of which it is written.
const INSTEAD: &str = "A:ÀÁÂÃÄÅĀĂĄ C:ÇĆĈĊČ D:ÐĎĐ E:ÈÉÊËĒĔĖĘĚ G:ĜĞĠĢ H:ĤĦ I:ÌÍÎÏĨĪĬĮİ J:Ĵ K:Ķĸ L:ĹĻĽĿŁ \
    N:ÑŃŅŇŊ O:ÒÓÔÕÖØŌŎŐ R:ŔŖŘ S:ŚŜŞŠȘ T:ŢŤŦȚ U:ÙÚÛÜŨŪŬŮŰŲ W:Ŵ Y:ÝŶŸ Z:ŹŻŽ AE:Æ IJ:Ĳ OE:Œ SS:ẞ TH:Þ \
    X:× 2:² 3:³ -:‐‑–—− ':‘’‚‛ʼ′ \":“”„‟«»″ ...:…";

/// A text in capitals of ASCII: base letters instead of the accented ones of Latin-1 and Latin Extended-A,
/// plain signs instead of typographic ones, and `?` instead of others.
pub fn in_capitals(text: &str) -> String {
    let mut written = String::new();
    let instead = || INSTEAD.split(' ').filter_map(|own| own.split_once(':'));
    for letter in text.chars().flat_map(char::to_uppercase) {
        match instead().find(|(_, others)| others.contains(letter)) {
            Some((base, _)) => written += base,
            None if letter.is_whitespace() => written.push(' '),
            // An accent after its letter.
            None if ('\u{300}'..='\u{36f}').contains(&letter) => {}
            None => written.push(if letter.is_ascii_graphic() { letter } else { '?' }),
        }
    }
    written
}

/// The width of a line of text of this height.
pub fn text_width(text: &str, height: f64) -> f64 {
    let letters = text.chars().count() as f64;
    ((ADVANCE * letters - (ADVANCE - WIDTH)) * height / HEIGHT).max(0.0)
}

/// The largest height up to `tallest` at which a line of text is no longer than `room`.
pub fn height_within(text: &str, tallest: f64, room: f64) -> f64 {
    tallest.min(room / text_width(text, 1.0))
}

/// The strokes of a line of text of this height, centred at `centre`, along the unit vector
/// `along`.
pub fn strokes(text: &str, height: f64, centre: Point2, along: Point2) -> Vec<Vec<Point2>> {
    let unit = height / HEIGHT;
    let left = -0.5 * text_width(text, height);
    let mut all = Vec::new();
    for (k, letter) in text.chars().enumerate() {
        let start = left + k as f64 * ADVANCE * unit;
        for stroke in glyph(letter) {
            let at = |pair: &[u8]| {
                let [x, y] = [pair[0], pair[1]].map(|digit| f64::from(digit - b'0') * unit);
                let [x, y] = rotated([start + x, y - 0.5 * height], along);
                [centre[0] + x, centre[1] + y]
            };
            all.push(stroke.as_bytes().chunks_exact(2).map(at).collect());
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_has_strokes_of_two_points_inside_its_cell_and_its_own_shape() {
        let letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-+.,:/%()[]_#&'\"!?";
        for letter in letters.chars() {
            let found = strokes(&letter.to_string(), 6.0, [2.0, 3.0], [1.0, 0.0]);
            assert!(!found.is_empty(), "{letter}");
            for stroke in &found {
                assert!(stroke.len() >= 2, "{letter}");
                for &[x, y] in stroke {
                    assert!((0.0..=4.0).contains(&x) && (0.0..=6.0).contains(&y), "{letter}");
                }
            }
            let twin =
                letters.chars().find(|&other| other != letter && glyph(other) == glyph(letter));
            assert_eq!(twin, None, "{letter}");
        }
    }

    #[test]
    fn no_letter_of_a_text_is_left_out() {
        for (text, written) in [
            ("Sperrholz für Möbel, groß", "SPERRHOLZ FUR MOBEL, GROSS"),
            ("Łódź [2] – A\u{30a}", "LODZ [2] - A"),
            ("Χαρτί\t3 × 4", "????? 3 X 4"),
            ("Bird’s-eye “GROẞ” 80 g/m²", "BIRD'S-EYE \"GROSS\" 80 G/M2"),
        ] {
            assert_eq!(in_capitals(text), written);
        }
        for letter in ('À'..='ſ').filter(|letter| letter.is_alphabetic()) {
            assert!(!in_capitals(&letter.to_string()).contains('?'), "{letter}");
        }
    }

    #[test]
    fn signs_without_strokes_stay_in_a_text_and_are_drawn_as_question_marks() {
        let ascii: String = (' '..='`').collect();
        assert_eq!(in_capitals(&ascii), ascii);
        let drawn = |text: &str| strokes(text, 6.0, [0.0; 2], [1.0, 0.0]);
        assert_eq!(drawn("A=<é"), drawn("A???"));
        assert!(drawn(" ").is_empty());
    }

    #[test]
    fn text_is_as_wide_as_it_says() {
        let found = strokes("H0H", 3.0, [10.0, 0.0], [0.0, 1.0]);
        let ys = || found.iter().flatten().map(|point| point[1]);
        let (low, high) = (ys().fold(9.0, f64::min), ys().fold(-9.0, f64::max));
        assert!((high - low - text_width("H0H", 3.0)).abs() < 1e-12);
        assert!((high + low).abs() < 1e-12);
    }
}
