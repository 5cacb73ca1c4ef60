//! The line drawing of a model as SVG, for print.
//!
//! | file | holds |
//! |---|---|
//! | `line_drawing` | visible lines in ink |
//! | `circles` | the fitted circles |

mod circles;
pub mod line_drawing;
