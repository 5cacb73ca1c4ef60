//! Words for readers: the cases that the page's test reads too, and what only Rust words.

use serde_json::{Value, to_value};
use shape_up::session::FACE_MEASURES;
use shape_up::words;

#[derive(serde::Deserialize)]
struct Case {
    of: String,
    given: Vec<Value>,
    words: String,
}

#[test]
fn numbers_are_worded_as_on_the_page() {
    let cases: Vec<Case> = serde_json::from_str(include_str!("data/words.json")).unwrap();
    for Case { of, given, words: expected } in cases {
        let number = given[0].as_f64().unwrap();
        let text = |at: usize| given[at].as_str().unwrap();
        let found = match (&*of, given.len()) {
            ("number", _) => words::number(number),
            ("length", 2) => words::length(number, text(1)),
            ("length", _) => words::length_like(number, text(1), given[2].as_f64().unwrap()),
            ("limit", _) => words::limit(number, text(1)),
            ("value", _) => {
                let is_this = |unit| to_value(unit).is_ok_and(|name| name == given[1]);
                let mut units = FACE_MEASURES.iter().map(|measure| measure.unit);
                let unit = units.find(|&unit| is_this(unit)).unwrap();
                unit.in_words(
                    number,
                    text(2),
                    given.get(3).map_or(number, |like| like.as_f64().unwrap()),
                )
            }
            ("part", _) => words::part(number),
            ("count", _) => words::count(number as usize, text(1), text(2)),
            _ => panic!("no such words: {of}"),
        };
        assert_eq!(found, expected, "{of} of {given:?}");
    }
}

#[test]
fn no_length_in_metres_or_millimetres_is_a_power_of_ten_or_less_than_something() {
    for k in -14..6 {
        let size = 1.234 * 10_f64.powi(k);
        for words in [words::length(size, "m"), words::length_like(size, "m", 3.0)] {
            assert!(!words.contains('e') && !words.contains('<'), "{size}: {words}");
        }
    }
}

#[test]
fn lengths_of_buildings_are_in_mm_up_to_ten_metres() {
    assert_eq!([words::millimetres(9_999.0), words::millimetres(12_345.0)], ["9999 mm", "12.3 m"]);
    assert_eq!([words::millimetres(0.0004), words::millimetres(-0.05)], ["0 mm", "−0.050 mm"]);
    let limits = [200.0, -100.0, 0.5, 25_000.0].map(words::millimetres_limit);
    assert_eq!(limits, ["200 mm", "−100 mm", "0.5 mm", "25 m"]);
    assert_eq!(words::area(1.234e6), "1.23 m²");
}

#[test]
fn what_moved_by_rounding_errors_did_not_move() {
    let moved = |max, mean| words::moved(max, mean, "m", 10.0);
    assert_eq!(moved(4e-7, 1e-8), None);
    assert_eq!(moved(0.21, 0.05).as_deref(), Some("at most 0.210 m, 0.0500 m on average"));
    assert_eq!(moved(0.85, 4.21e-5).as_deref(), Some("at most 0.850 m, 0.042 mm on average"));
    assert_eq!(words::moved(1e-12, 0.0, "", 10.0), None);
    assert!(words::moved(1e-6, 0.0, "", 10.0).is_some());
}

#[test]
fn angles_have_as_many_digits_as_they_are_read_with() {
    assert_eq!([3.64, 49.2, 9.96, 0.0].map(words::rough_degrees), ["3.6°", "49°", "10°", "0.0°"]);
    assert_eq!([3.64, 49.2, 1e-9].map(words::degrees), ["3.64°", "49.2°", "0°"]);
}

#[test]
fn a_number_is_rounded_as_it_is_written() {
    let rounded = [0.1234, 98_765.0, -2.7e-7, 0.0].map(|value| words::rounded(value, 2));
    assert_eq!(rounded, [0.12, 99_000.0, -2.7e-7, 0.0]);
}

#[test]
fn lists_end_with_the_number_of_the_others() {
    let names = ["A", "B", "C"].map(str::to_owned);
    assert_eq!(words::and_more(&names, 3), "A, B, C");
    assert_eq!(words::and_more(&names, 2), "A, B and 1 more");
    assert_eq!(words::sentence("panel P3 is flat"), "Panel P3 is flat");
}
