//! Sheets larger than a page of paper, tiled: pages overlap by 10 mm and have a frame to cut along.

use crate::scene::{Page, Tiling};

/// A page with a part of a sheet.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::fabricate) struct Tile {
    /// Its width and height in mm.
    pub(in crate::fabricate) page: [f64; 2],
    /// The point of the sheet at its lower left corner.
    pub(in crate::fabricate) origin: [f64; 2],
    /// Its column and row, and how many there are; none if the page shows the whole sheet.
    pub(in crate::fabricate) place: Option<[[u32; 2]; 2]>,
}

/// The pages of a sheet, column by column from the lower left; see [`Tiling::of`].
pub(in crate::fabricate) fn tiles(sheet: [f64; 2], page: Option<[f64; 2]>) -> Vec<Tile> {
    let Tiling { page, counts } = Tiling::of(sheet, page);
    let Some(counts) = counts else {
        return vec![Tile { page, origin: [0.0; 2], place: None }];
    };
    let [low, high] = Page::frame(page);
    let mut all = Vec::new();
    for column in 0..counts[0] {
        for row in 0..counts[1] {
            let place = [column, row];
            let origin =
                [0, 1].map(|k| f64::from(place[k]) * (high[k] - low[k] - Page::OVERLAP) - low[k]);
            all.push(Tile { page, origin, place: Some([place, counts]) });
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_of_a_sheet_is_on_a_page_and_a_sheet_that_fits_is_on_one() {
        for sheet in [[420.0, 297.0], [600.0, 400.0], [1200.0, 600.0], [150.0, 500.0]] {
            let all = tiles(sheet, Some([210.0, 297.0]));
            assert!(all.len() > 1);
            for point in [
                [0.0, 0.0],
                sheet,
                [0.37 * sheet[0], 0.61 * sheet[1]],
                [200.0_f64.min(sheet[0]), 287.0],
            ] {
                let shows = |tile: &Tile| {
                    let [low, high] = Page::frame(tile.page);
                    (0..2).all(|k| {
                        let at = point[k] - tile.origin[k];
                        at >= low[k] - 1e-9 && at <= high[k] + 1e-9
                    })
                };
                assert!(all.iter().any(shows), "{sheet:?} {point:?}");
            }
        }
        assert_eq!(tiles([420.0, 297.0], Some([210.0, 297.0])).len(), 4);
        let [own] = &tiles([420.0, 297.0], Some([297.0, 420.0]))[..] else { panic!("it fits") };
        assert_eq!((own.page, own.origin), ([420.0, 297.0], [0.0, 0.0]));
    }
}
