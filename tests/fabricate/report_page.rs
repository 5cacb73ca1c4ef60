//! The report as a document: the numbers of the card, pictures, and the link.

use super::build;
use super::identities::revolution;
use crate::support::grid::grid;
use roxmltree::{Document, Node, ParsingOptions};
use shape_up::fabricate::ReportView;
use shape_up::mesh::Mesh;
use shape_up::scene::{BuildSettings, Product};

const LINK: &str = "https://example.org/#scene=(a)&b=1";

fn view() -> ReportView {
    let (title, link) = ("Roof (\u{e4}) <1> & \"2\"".to_owned(), LINK.to_owned());
    ReportView { title, z_up: true, camera: Some([0.5, 0.6]), link }
}

fn page(mesh: &Mesh, settings: &BuildSettings) -> String {
    build(mesh, settings).report_page(&view())
}

fn parsed(page: &str) -> Document<'_> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(page, options).expect("it is XML")
}

fn all<'a>(document: &'a Document<'a>, tag: &'a str) -> impl Iterator<Item = Node<'a, 'a>> {
    document.descendants().filter(move |node| node.has_tag_name(tag))
}

/// What is read on the page, one piece of text each.
fn words(document: &Document<'_>) -> Vec<String> {
    let body = all(document, "body").next().unwrap();
    let texts = body.descendants().filter(Node::is_text);
    let texts = texts.map(|node| node.text().unwrap().to_owned());
    texts.filter(|text| !text.trim().is_empty()).collect()
}

#[test]
fn a_valley_is_scored_along_its_whole_length_though_it_is_drawn_as_dashes() {
    for up in [-1.0, 1.0] {
        let fold = grid(2, 1, |i, j| [f64::from(i), f64::from(j), up * f64::from((i % 2) as u8)]);
        let product = Product::Paper;
        let own = BuildSettings { product, tab: 0.0, scale: 10.0, ..BuildSettings::default() };
        let page = page(&fold, &own);
        let words = words(&parsed(&page));
        let item = words.iter().position(|text| text == "Length of scores").unwrap();
        assert_eq!(words[item + 1], "100 mm", "{up}");
    }
}

#[test]
fn it_is_a_page_of_a4_that_needs_no_other_file_and_whose_link_opens_the_model() {
    let page = page(&revolution(9, 7), &BuildSettings::default());
    assert!(page.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
    let document = parsed(&page);
    let texts = |tag| all(&document, tag).map(|node| node.text().unwrap()).collect::<Vec<_>>();
    assert_eq!(texts("h1"), ["Roof (\u{e4}) <1> & \"2\""]);
    assert_eq!(texts("title"), ["Report on Roof (\u{e4}) <1> & \"2\""]);
    let [style] = texts("style")[..] else { panic!("there is one") };
    assert!(style.contains("@page {\n  size: A4;") && style.contains("@media print"));
    assert!(!style.contains("url(") && !style.contains("@import"));
    let addresses = document.descendants().flat_map(|node| node.attributes());
    let addresses = addresses.filter(|it| ["href", "src", "style"].contains(&it.name()));
    assert_eq!(addresses.map(|it| it.value()).collect::<Vec<_>>(), [LINK]);
    assert!(all(&document, "script").next().is_none());
    let words = words(&document);
    for shown in [LINK, "Open this model:", "Build check", "Bill of materials"] {
        assert!(words.iter().any(|line| line == shown), "{shown}");
    }
    assert!(words.iter().any(|line| line.starts_with("Shape-Up ")));
}

#[test]
fn a_link_that_is_too_long_to_type_is_not_printed() {
    let made = build(&revolution(9, 7), &BuildSettings::default());
    let link = |link: String| {
        let page = made.report_page(&ReportView { link, ..view() });
        let document = parsed(&page);
        let found = all(&document, "a").next();
        found.map(|node| [node.attribute("href"), node.text()].map(|it| it.unwrap().to_owned()))
    };
    let long = format!("{LINK}{}", "x".repeat(1000));
    let words = "Click to open it; the link is too long to print.".to_owned();
    assert_eq!(link(long.clone()), Some([long, words]));
    // A script is no address of a model, however it is written.
    for wrong in
        ["", "javascript:alert(1)", "JaVaScRiPt://%0Aalert(1)", "\thttps:", "data:text/html,a"]
    {
        assert_eq!(link(wrong.to_owned()), None, "{wrong}");
    }
    assert!(link("HTTPS://example.org".to_owned()).is_some());
}

#[test]
fn its_numbers_are_those_of_the_card() {
    let made = build(&revolution(9, 7), &BuildSettings::default());
    let page = page(&revolution(9, 7), &BuildSettings::default());
    let words = words(&parsed(&page));
    let report = made.report();
    for row in &report.card.check {
        let at = words.iter().position(|line| line == row.label).expect("every row is there");
        let [value, limit, state] = [1, 2, 3].map(|k| &words[at + k]);
        let number = |words: &str| words.split([' ', '\u{b0}']).next().unwrap().parse::<f64>();
        match number(value) {
            // Three digits; metres from 10 m on.
            Ok(found) => {
                let shown = if value.ends_with(" m") { 1000.0 * found } else { found };
                let expected = row.value.unwrap();
                let off = (shown - expected).abs();
                // What is less than a thousandth is 0.
                assert!(off <= 0.006 * expected.abs() || off < 0.001, "{value} {expected}");
            }
            Err(_) => assert!(row.value.is_none_or(|value| value < 0.0), "{value}"),
        }
        assert!(limit.starts_with("≤ ") || limit == "no limit");
        assert_eq!(row.met == Some(true), state == "satisfied", "{state}");
    }
    let sheets = format!("{} of 420 x 297 mm", report.sheets);
    assert!(words.contains(&sheets), "{words:?}");
}

#[test]
fn without_a_material_its_first_line_is_a_sentence_too() {
    let own = BuildSettings { material: String::new(), ..BuildSettings::default() };
    let page = page(&revolution(9, 7), &own);
    let words = words(&parsed(&page));
    assert!(words.iter().any(|line| line.starts_with("At 1:")), "{words:?}");
}

#[test]
fn nothing_leaves_its_picture_whatever_is_made_of_whatever_mesh() {
    let level = |i: u32, j: u32| [f64::from(i), f64::from(j), 0.0];
    let mut folded = grid(6, 5, level);
    folded.positions[9] = [5.0, 4.5, 3.0];
    let flat = grid(3, 3, level);
    let numbers = |text: &str| -> Vec<f64> {
        let parts =
            text.split(|letter: char| letter.is_ascii_alphabetic() || " ,".contains(letter));
        parts.filter(|part| !part.is_empty()).map(|part| part.parse().unwrap()).collect()
    };
    for mesh in [&folded, &flat, &revolution(9, 7)] {
        for product in Product::ALL {
            let settings = BuildSettings { product, scale: 2.0, ..BuildSettings::default() };
            let page = page(mesh, &settings);
            assert!(!page.contains("NaN") && !page.contains("inf"), "{product:?}");
            let document = parsed(&page);
            assert!(words(&document).len() > 30);
            for svg in all(&document, "svg") {
                let [_, _, width, height] = numbers(svg.attribute("viewBox").unwrap())[..] else {
                    panic!("a view box has four numbers")
                };
                let inside = |[x, y]: [f64; 2]| {
                    let is_inside = (0.0..=width).contains(&x) && (0.0..=height).contains(&y);
                    assert!(is_inside, "{product:?}: {x} {y} is not in {width} {height}");
                };
                let shapes = svg.descendants().filter(|node| node.has_tag_name("path"));
                for path in shapes.filter(|path| path.attribute("class") != Some("axis")) {
                    let d = path.attribute("d").unwrap().replace('V', " 0 ");
                    numbers(&d).as_chunks().0.iter().copied().for_each(inside);
                }
                for text in svg.descendants().filter(|node| node.has_tag_name("text")) {
                    inside(
                        ["x", "y"]
                            .map(|key| text.attribute(key).unwrap_or("0").parse::<f64>().unwrap()),
                    );
                }
            }
        }
    }
}

/// Each counted as a node of offset error 0, and thousands hid the others.
#[test]
fn vertices_without_a_panel_are_no_nodes() {
    let mesh = revolution(9, 7);
    let with = |alone: usize| {
        let mut mesh = mesh.clone();
        mesh.positions.extend((0..alone).map(|k| [0.0, 0.0, 1e-3 * k as f64]));
        let settings = BuildSettings { product: Product::Fins, ..BuildSettings::default() };
        let made = build(&mesh, &settings);
        let curve = made.report().frame.expect("there are beams").node_types_curve;
        let page = made.report_page(&view());
        let labels = |node: Node<'_, '_>| node.attribute("aria-label").map(str::to_owned);
        (curve, parsed(&page).descendants().filter_map(labels).collect::<Vec<_>>())
    };
    let (plain, with_points) = (with(0), with(6000));
    assert!(!plain.0.is_empty() && plain.1.iter().any(|label| label.contains(" values from 0")));
    assert_eq!(plain, with_points);
}
