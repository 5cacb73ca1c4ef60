//! The report on one page of A4: the shape as it is looked at, its plan, the build check with limits and histograms,
//! a bill of materials, and the link that opens the model. The numbers are those of [`BuildReport`].
//!
//! | file | holds |
//! |---|---|
//! | `mark` | words, shapes and links on a page |
//! | `helvetica` | how wide words are, and where lines of them break |
//! | `words` | numbers as people read them |
//! | `picture` | the shape in parallel projection, and its plan |
//! | `histogram` | how the values behind a number are spread |
//! | `bill` | what has to be bought and made |
//! | `page` | what is where on the page |
//! | `pdf` | the page as PDF |
//! | `svg` | the page as SVG, to be looked at and printed |
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
