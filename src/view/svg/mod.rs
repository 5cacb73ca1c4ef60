//! Pictures as SVG: for a page that cannot draw yet, and for print.
//!
//! | file | holds |
//! |---|---|
//! | `picture` | the still picture with which the page starts |
//! | `circles` | its fitted circles |
//! | `line_drawing` | visible lines in ink, for print |
//! | `thumbnail` | small pictures for the gallery |
//! | `light` | the shaded colour of a face |

mod circles;
pub mod light;
pub mod line_drawing;
pub mod picture;
pub mod thumbnail;
