//! The report on one A4 page: the shape in the current view, its plan, the build check with limits
//! and histograms, a bill of materials, and a link that opens the model. The numbers come from
//! [`BuildReport`].
//!
//! | file | holds |
//! |---|---|
//! | `mark` | text, shapes and links on a page |
//! | `helvetica` | widths of text, and line breaking |
//! | `words` | rounded numbers with units, as text |
//! | `picture` | the shape in parallel projection, and its plan |
//! | `histogram` | histogram of the values behind a number |
//! | `bill` | the bill of materials |
//! | `page` | the layout of the page |
//! | `pdf` | the page as PDF |
//! | `svg` | the page as SVG, for the screen and for printing |
//!
//! [`BuildReport`]: super::BuildReport

mod bill;
mod helvetica;
mod histogram;
mod mark;
mod page;
mod pdf;
mod picture;
mod svg;
mod words;

pub use page::{ReportPage, ReportView};
