//! The PDF of the sheets: pages of their size, tiled to paper, and not more than anybody would glue.

use super::identities::revolution;
use super::paper::{scale, settings};
use super::{build, bytes_of};
use shape_up::fabricate::{Build, BuildFile};
use shape_up::scene::{BuildSettings, Page, Pieces};

#[test]
fn a_pdf_is_tiled_to_the_page() {
    let own = BuildSettings { page: Page::A4, ..settings(Pieces::Nets) };
    let made = build(&revolution(9, 7), &own);
    let files = made.files(true);
    assert!(files.iter().all(|file| BuildFile::is_name_of_one(&file.name)));
    let document = lopdf::Document::load_mem(&bytes_of(&made, "sheets.pdf")).expect("it is PDF");
    // A3 on A4, with overlap and margins.
    assert_eq!(document.get_pages().len(), 4 * made.layout.sheets.len());
    let whole = BuildSettings { sheet: [297.0, 210.0], ..own };
    let made = build(&revolution(9, 7), &whole);
    let document = lopdf::Document::load_mem(&bytes_of(&made, "sheets.pdf")).unwrap();
    assert_eq!(document.get_pages().len(), made.layout.sheets.len());
}

#[test]
fn a_page_has_only_the_lines_that_are_on_it() {
    let own = BuildSettings { page: Page::A4, ..settings(Pieces::Nets) };
    let document =
        lopdf::Document::load_mem(&bytes_of(&build(&revolution(9, 7), &own), "sheets.pdf"))
            .unwrap();
    let pages = document.get_pages();
    let mut counts = Vec::new();
    for page in pages.values() {
        let content = document.get_and_decode_page_content(*page).unwrap();
        let (mut frame, mut origin, mut paths) = (None, [0.0; 2], Vec::<Vec<[f64; 2]>>::new());
        for operation in &content.operations {
            let numbers: Vec<f64> = operation
                .operands
                .iter()
                .filter_map(|one| one.as_float().ok())
                .map(f64::from)
                .collect();
            match (&*operation.operator, &numbers[..]) {
                ("re", &[x, y, width, height]) => frame = Some([[x, y], [x + width, y + height]]),
                ("cm", &[_, _, _, _, x, y]) => origin = [x, y],
                ("m", &[x, y]) => paths.push(vec![[x + origin[0], y + origin[1]]]),
                ("l", &[x, y]) => paths.last_mut().unwrap().push([x + origin[0], y + origin[1]]),
                ("Q", _) => break,
                _ => {}
            }
        }
        let [low, high] = frame.expect("it is clipped");
        for path in &paths {
            let is_on_it = (0..2).all(|k| {
                path.iter().any(|point| point[k] < high[k] + 0.2)
                    && path.iter().any(|point| point[k] > low[k] - 0.2)
            });
            assert!(is_on_it, "{path:?}");
        }
        counts.push(paths.len());
    }
    let whole = BuildSettings { page: Page::Sheet, ..own };
    let all: usize =
        build(&revolution(9, 7), &whole).drawings().iter().map(|own| own.lines.len()).sum();
    // Few lines are on two pages.
    assert!(counts.iter().sum::<usize>() < 2 * all, "{counts:?} of {all}");
}

/// The pages of the sheets of a build: their sizes in mm, as a reader of the file computes them.
fn printed(made: &Build) -> Vec<[f64; 2]> {
    let document = lopdf::Document::load_mem(&bytes_of(made, "sheets.pdf")).expect("it is PDF");
    let number = |object: &lopdf::Object| f64::from(object.as_float().unwrap());
    let pages = document.get_pages();
    let size = |page: &lopdf::ObjectId| {
        let page = document.get_dictionary(*page).unwrap();
        let unit = page.get(b"UserUnit").map_or(1.0, number);
        let edges = page.get(b"MediaBox").unwrap().as_array().unwrap();
        [2, 3].map(|k| {
            let length = number(&edges[k]);
            assert!(length <= 14_400.0, "readers cut larger pages off");
            length * unit * 25.4 / 72.0
        })
    };
    pages.values().map(size).collect()
}

#[test]
fn a_sheet_larger_than_a_page_of_pdf_may_be_has_its_size() {
    for sheet in [[5000.0, 300.0], [6000.0, 300.0], [400.0, 99_000.0]] {
        let own = BuildSettings { sheet, ..settings(Pieces::Nets) };
        let [page] = printed(&build(&revolution(9, 7), &own))[..] else { panic!("one page") };
        assert!((0..2).all(|k| (page[k] - sheet[k]).abs() < 1e-2), "{page:?} {sheet:?}");
    }
}

#[test]
fn more_pages_than_anybody_would_glue_are_not_made() {
    let sheet = [4000.0, 4000.0];
    let mesh = revolution(9, 7);
    // Edges of 2 m.
    let large = scale(&mesh) * 30.0 / 2000.0;
    let own = BuildSettings { sheet, scale: large, page: Page::A4, ..settings(Pieces::Nets) };
    let made = build(&mesh, &own);
    let all = |made: &Build| made.layout.sheets.len();
    let words = |made: &Build| made.card().problems.concat();
    assert!(all(&made) >= 15, "{}", all(&made));
    assert!(words(&made).contains("pages"), "{}", words(&made));
    assert_eq!(printed(&made).len(), all(&made));
    let less = build(&mesh, &BuildSettings { scale: 50.0, ..own });
    assert!(!words(&less).contains("pages"));
    assert!(printed(&less).len() > all(&less));
    // A single sheet of that many pages: a typing error.
    let sheet = [1e5, 1e5];
    let one = build(&mesh, &BuildSettings { sheet, page: Page::A4, ..settings(Pieces::Nets) });
    assert_eq!(all(&one), 1);
    assert!(words(&one).contains("pages"), "{}", words(&one));
    assert_eq!(printed(&one).len(), 1);
}
