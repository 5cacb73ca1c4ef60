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
