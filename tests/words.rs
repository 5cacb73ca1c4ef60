//! Words for readers. The cases are read by a test of the page too, which calls them by its module.

use serde_json::Value;
use shape_up::words::{self, MeasureUnit, TypedLength};

#[derive(serde::Deserialize)]
struct Case {
    of: String,
    given: Vec<Value>,
    words: String,
}

#[test]
fn numbers_lengths_and_counts_are_worded_as_in_the_table_of_cases() {
    let cases: Vec<Case> = serde_json::from_str(include_str!("data/words.json")).unwrap();
    for Case { of, given, words: expected } in cases {
        let first = given[0].as_f64();
        let number = first.unwrap_or(f64::NAN);
        let text = |at: usize| given[at].as_str().unwrap();
        let other = |at: usize| given.get(at).map_or(number, |value| value.as_f64().unwrap());
        let found = match &*of {
            "number" => words::number(number),
            "brief" => words::brief(number),
            "length" => words::length_like(number, text(1), other(2)),
            "limit" => words::limit(number, text(1)),
            "displacement" => {
                let by = [0, 1, 2].map(|axis| given[0][axis].as_f64().unwrap());
                words::displacement(by, text(1), other(2))
            }
            "measured" => MeasureUnit::of(text(1)).unwrap().in_words(number, text(2), other(3)),
            "part" => words::part(number),
            "signedPart" => words::signed_part(number),
            "ratio" => words::ratio(number),
            "duration" => words::duration(number),
            "coordinate" => words::coordinate(number, other(1) as usize),
            "powerOfTen" => words::power_of_ten(number),
            "megabytes" => words::megabytes(number),
            "count" => words::count(number as usize, text(1), text(2)),
            "groupDigits" => words::group_digits(number as usize),
            _ => panic!("no such words: {of}"),
        };
        assert_eq!(found, expected, "{of} of {given:?}");
    }
    let unbounded = [words::number(f64::NAN), words::ratio(f64::NAN), words::ratio(f64::INFINITY)];
    assert_eq!(unbounded, ["–", "–", "∞"]);
}

#[test]
fn lengths_are_read_as_people_type_them() {
    let read = |text: &str, units: &str| {
        TypedLength::read(text, units).map(|typed| (typed.by, typed.length))
    };
    assert_eq!(read("1.5", ""), Ok((false, 1.5)));
    assert_eq!(read(" 1,5 ", "m"), Ok((false, 1.5)));
    assert_eq!(read("1 / 4", "m"), Ok((false, 0.25)));
    assert_eq!(read("20 CM", "m"), Ok((false, 0.2)));
    assert_eq!(read("-.5", "m"), Ok((false, -0.5)));
    assert_eq!(read("+-0.5", "m"), Ok((true, -0.5)));
    assert_eq!(read("+ 3mm", "mm"), Ok((true, 3.0)));
    assert_eq!(read("−2e-3", ""), Ok((false, -0.002)));
    assert_eq!(read("1E−2m", "cm"), Ok((false, 1.0)));
    assert_eq!(read(&words::group_digits(1_234_567), ""), Ok((false, 1_234_567.0)));
    assert_eq!(read("12 500.5 mm", "m"), Ok((false, 12.5005)));
    for text in [
        "",
        "far",
        "1/0",
        "1e",
        "e5",
        "1e999",
        "1.2.3",
        "1 20",
        "1.5 200",
        "1234 567",
        ".",
        "2 m2",
        "--1",
        "1/-2",
        "inf",
        "5 furlongs",
    ] {
        let refused = read(text, "m").unwrap_err().to_string();
        assert_eq!(refused, format!("“{text}” is not a length. Expected 1.5, 1/3 or +0.5."));
    }
    // A unit means nothing on a mesh without one.
    let refused = read("20cm", "").unwrap_err().to_string();
    assert_eq!(refused, "“20cm” is not a number. Expected 1.5, 1/3 or +0.5.");
}

#[test]
fn lengths_in_a_table_have_one_unit_and_as_many_decimals() {
    let words = |lengths: &[f64], units: &str| {
        let words::ComparedLengths { lengths, unit } = words::compared_lengths(lengths, units);
        (lengths.join(" "), unit)
    };
    assert_eq!(
        words(&[5.0, 3.0, -4.0, -1e-9], "m"),
        ("5.0000 3.0000 −4.0000 0.0000".into(), "m".into())
    );
    assert_eq!(words(&[0.05, -0.03], "m"), ("50.000 −30.000".into(), "mm".into()));
    assert_eq!(words(&[123_456.0], ""), ("123456".into(), String::new()));
    assert_eq!(words(&[0.0], "m"), ("0.0000".into(), "mm".into()));
}

#[test]
fn coordinates_have_as_many_decimals_as_their_mesh_needs() {
    let decimals = [20.0, 2e-6, 1e9, 0.0, f64::NAN].map(words::decimals_for);
    assert_eq!(decimals, [4, 11, 0, 3, 3]);
}

#[test]
fn an_energy_below_the_rounding_of_coordinates_is_zero() {
    assert_eq!([1e-23, 1e-21].map(|energy| words::energy_or_zero(energy, 10.0)), [0.0, 1e-21]);
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
    let areas = [words::area(1.234e6), words::area_of(2e4, "cm"), words::area_of(2.0, "ft")];
    assert_eq!(areas, ["1.23 m²", "2.00 m²", "2.00 ft²"]);
    assert_eq!(words::area_of(2.0, ""), "2.00");
    assert_eq!(
        ["", "°", "m²"].map(|unit| words::number_in(5.0, unit)),
        ["5.00", "5.00°", "5.00 m²"]
    );
}

#[test]
fn a_range_may_be_open_at_each_end() {
    let range = |from, to| words::range_in(from, to, "m");
    let ranges = [range(None, None), range(None, Some(5.0)), range(Some(3.0), None)];
    assert_eq!(ranges, ["any", "up to 5.00 m", "from 3.00 m"]);
    assert_eq!(words::range_in(Some(80.0), Some(100.0), "°"), "80.0 to 100°");
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
    assert_eq!([-1e-9, -0.06].map(words::rough_degrees), ["0.0°", "−0.1°"]);
    assert_eq!(words::rough_length(0.0142, "m"), "14 mm");
    assert_eq!([3.64, 49.2, 1e-9].map(words::degrees), ["3.64°", "49.2°", "0°"]);
}

#[test]
fn a_number_is_rounded_as_it_is_written() {
    let rounded = [0.1234, 98_765.0, -2.7e-7, 0.0].map(|value| words::rounded(value, 2));
    assert_eq!(rounded, [0.12, 99_000.0, -2.7e-7, 0.0]);
    // In the middle of two numbers, the larger one, on both sides of zero.
    let middle = [0.125, -0.125, 106.25].map(|value| words::rounded(value, 2));
    assert_eq!(middle, [0.13, -0.13, 110.0]);
    assert_eq!(words::rounded(106.25, 4), 106.3);
}

#[test]
fn lists_end_with_the_number_of_the_others() {
    let names = ["A", "B", "C"].map(str::to_owned);
    assert_eq!(words::and_more(&names, 3), "A, B, C");
    assert_eq!(words::and_more(&names, 2), "A, B and 1 more");
    assert_eq!(words::sentence("panel P3 is flat"), "Panel P3 is flat");
}
