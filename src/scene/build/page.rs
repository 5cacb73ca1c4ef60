//! The pages of a PDF: their sizes, and how many of them a sheet is printed on.

use serde::{Deserialize, Serialize};

/// The pages of a PDF.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Page {
    /// The size of the sheets.
    #[default]
    Sheet,
    /// 210 x 297 mm.
    A4,
    /// 297 x 420 mm.
    A3,
}

impl Page {
    /// Its shorter and its longer side in mm; none for the size of the sheet.
    pub fn size(self) -> Option<[f64; 2]> {
        match self {
            Page::Sheet => None,
            Page::A4 => Some([210.0, 297.0]),
            Page::A3 => Some([297.0, 420.0]),
        }
    }

    /// The unprintable margin of a page, in mm.
    pub(crate) const FREE: f64 = 5.0;
    /// Height of the line with words and a ruler below a part of a sheet, in mm.
    pub(crate) const LINE: f64 = 4.0;
    /// Overlap of neighbouring pages, in mm.
    pub(crate) const OVERLAP: f64 = 10.0;

    /// The lower left and the upper right corner, in mm, of what a page of this width and height shows
    /// of a sheet that is on several.
    pub(crate) fn frame([width, height]: [f64; 2]) -> [[f64; 2]; 2] {
        [[Self::FREE, Self::FREE + Self::LINE], [width - Self::FREE, height - Self::FREE]]
    }
}

/// The pages that a sheet is printed on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tiling {
    /// Width and height of each page in mm.
    pub(crate) page: [f64; 2],
    /// Number of pages along the width and the height of the sheet; none if one shows all of it.
    pub(crate) counts: Option<[u32; 2]>,
}

impl Tiling {
    /// The pages of this shorter and longer side in mm, portrait or landscape, whichever needs fewer;
    /// by default one page of the size of the sheet.
    pub(crate) fn of(sheet: [f64; 2], page: Option<[f64; 2]>) -> Tiling {
        let Some([short, long]) = page else { return Tiling { page: sheet, counts: None } };
        let both = [[short, long], [long, short]];
        // A sheet and a page of the same standard size agree up to rounding.
        let holds = |page: &[f64; 2]| (0..2).all(|k| sheet[k] <= page[k] + 0.1);
        if let Some(page) = both.into_iter().find(holds) {
            return Tiling { page, counts: None };
        }
        let [upright, across] = both.map(|page| {
            let [low, high] = Page::frame(page);
            let counts = [0, 1].map(|k| {
                let shown = high[k] - low[k];
                let more = (sheet[k] - shown) / (shown - Page::OVERLAP);
                if more > 0.0 { (more.ceil() as u32).saturating_add(1) } else { 1 }
            });
            Tiling { page, counts: Some(counts) }
        });
        if upright.count() <= across.count() { upright } else { across }
    }

    /// The number of pages.
    pub(crate) fn count(&self) -> u64 {
        self.counts.map_or(1, |counts| counts.map(u64::from).iter().product())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_of_the_size_of_a_page_is_on_one() {
        let count = |sheet, page: Page| Tiling::of(sheet, page.size()).count();
        assert_eq!([[210.0, 297.0], [297.0, 210.0]].map(|sheet| count(sheet, Page::A4)), [1; 2]);
        assert_eq!(count([420.0, 297.0], Page::A4), 4);
        assert_eq!(count([5000.0, 5000.0], Page::Sheet), 1);
    }
}
