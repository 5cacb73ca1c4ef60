//! The report of a build as one HTML document, which prints on a page of A4: the shape in the
//! current view, its plan, the build check with limits and histograms, a bill of materials, and a
//! link that opens the model. The numbers come from [`BuildReport`]. The document needs no other
//! file and runs no script.
//!
//! | file | holds |
//! |---|---|
//! | `picture` | the shape in parallel projection, and its plan |
//! | `histogram` | histogram of the values behind a number |
//! | `bill` | the bill of materials |
//! | `page` | the document; its look is in `page.css` |
//!
//! [`BuildReport`]: super::BuildReport

mod bill;
mod histogram;
mod page;
mod picture;

pub use page::ReportView;
