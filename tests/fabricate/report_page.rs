//! The report page: the numbers of the card on one page of A4, with the link.

use super::build;
use super::identities::revolution;
use crate::support::grid::grid;
use shape_up::fabricate::{BuildSettings, Product, ReportPage, ReportView};
use shape_up::mesh::Mesh;

const LINK: &str = "https://example.org/#scene=(a)&b=1";

fn view() -> ReportView {
    let (title, link) = ("Roof (\u{e4}) <1>".to_owned(), LINK.to_owned());
    ReportView { title, z_up: true, camera: Some([0.5, 0.6]), link }
}

fn page(mesh: &Mesh, settings: &BuildSettings) -> (ReportPage, Vec<String>) {
    let page = build(mesh, settings).report_page(&view());
    let document = roxmltree::Document::parse(&page.svg).expect("it is XML");
    let words = document.descendants().filter(|node| node.has_tag_name("text"));
    let words = words.map(|node| node.text().unwrap_or_default().to_owned()).collect();
    (page, words)
}

#[test]
fn it_is_one_page_of_a4_whose_words_are_those_on_the_screen_and_whose_link_opens_the_model() {
    let (page, words) = page(&revolution(9, 7), &BuildSettings::default());
    assert!(page.pdf.is_ascii());
    let document = lopdf::Document::load_mem(page.pdf.as_bytes()).expect("it is PDF");
    let pages = document.get_pages();
    assert_eq!(pages.len(), 1);
    let own = document.get_dictionary(pages[&1]).unwrap();
    let media = own.get(b"MediaBox").and_then(lopdf::Object::as_array).unwrap();
    let [width, height] = [2, 3].map(|k| media[k].as_float().unwrap() * 25.4 / 72.0);
    assert!((width - 210.0).abs() < 1e-3 && (height - 297.0).abs() < 1e-3);
    let annotations = document.get_page_annotations(pages[&1]).unwrap();
    let [link] = &annotations[..] else { panic!("there is one") };
    let action = link.get(b"A").and_then(lopdf::Object::as_dict).unwrap();
    assert_eq!(action.get(b"URI").and_then(lopdf::Object::as_str).unwrap(), LINK.as_bytes());
    let content = document.get_and_decode_page_content(pages[&1]).unwrap();
    let shown = content.operations.iter().filter(|operation| operation.operator == "Tj");
    let shown: Vec<String> = shown
        .map(|operation| operation.operands[0].as_str().unwrap())
        .map(|bytes| bytes.iter().map(|&byte| char::from(byte)).collect())
        .collect();
    assert_eq!(shown, words);
    assert!(words.iter().any(|line| line == "Roof (\u{e4}) <1>"));
    assert!(words.iter().any(|line| line == LINK));
}

#[test]
fn its_numbers_are_those_of_the_card() {
    let made = build(&revolution(9, 7), &BuildSettings::default());
    let (_, words) = page(&revolution(9, 7), &BuildSettings::default());
    let report = made.report();
    for row in &report.check {
        let at = words.iter().position(|line| line == row.label).expect("every row is there");
        let [value, limit, state] = [1, 2, 3].map(|k| &words[at + k]);
        let number = |words: &str| words.split([' ', '\u{b0}']).next().unwrap().parse::<f64>();
        match number(value) {
            // Three digits; metres from 10 m on.
            Ok(found) => {
                let shown = if value.ends_with(" m") { 1000.0 * found } else { found };
                let expected = row.value.unwrap();
                assert!((shown - expected).abs() <= 0.006 * expected.abs(), "{value} {expected}");
            }
            Err(_) => assert!(row.value.is_none_or(|value| value < 0.01), "{value}"),
        }
        assert!(limit.starts_with("limit "));
        assert_eq!(row.met == Some(true), state == "met", "{state}");
    }
    let sheets = format!("{} of 420 x 297 mm", report.sheets);
    assert!(words.contains(&sheets), "{words:?}");
}

#[test]
fn nothing_leaves_the_page_whatever_is_made_of_whatever_mesh() {
    let level = |i: u32, j: u32| [f64::from(i), f64::from(j), 0.0];
    let mut folded = grid(6, 5, level);
    folded.positions[9] = [5.0, 4.5, 3.0];
    let flat = grid(3, 3, level);
    for mesh in [&folded, &flat, &revolution(9, 7)] {
        for product in Product::ALL {
            let settings = BuildSettings { product, scale: 2.0, ..BuildSettings::default() };
            let (page, words) = page(mesh, &settings);
            assert!(!page.svg.contains("NaN") && !page.svg.contains("inf"), "{product:?}");
            assert!(words.len() > 30);
            let document = roxmltree::Document::parse(&page.svg).unwrap();
            for node in document.descendants().filter(|node| node.has_tag_name("text")) {
                let at = |key: &str| node.attribute(key).unwrap_or("0").parse::<f64>().unwrap();
                assert!(at("x") >= 0.0 && at("x") + at("textLength") <= 200.0);
                assert!(at("y") > 5.0 && at("y") < 292.0);
            }
        }
    }
}
