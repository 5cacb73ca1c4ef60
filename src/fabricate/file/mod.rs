//! Sheets and lists as files. Everything is in mm of the sheet, with y upwards except in SVG.
//!
//! | file | holds |
//! |---|---|
//! | `drawing` | the lines of a sheet by their roles |
//! | `svg` | SVG: mm, one path per part, no transforms |
//! | `picture` | a sheet as the page shows it: one path per layer |
//! | `dxf` | DXF: R2000, or R12 for old machines |
//! | `pdf` | PDF 1:1, a page per sheet or tiled, with layers and a ruler |
//! | `csv` | tables of panels, edges, nodes, types, and a summary |
//! | `glb` | binary glTF: the parts in space |
//! | `number` | numbers as text |

mod csv;
mod drawing;
mod dxf;
mod glb;
mod number;
mod pdf;
mod picture;
mod svg;

pub use csv::{Cell, Table};
pub use drawing::{Drawing, DrawnLine};
pub use dxf::dxf;
pub use glb::{GlbPart, glb};
pub(super) use number::places;
pub use pdf::pdf;
pub use picture::{PictureLayer, SheetPicture, picture};
pub(crate) use svg::escaped;
pub use svg::svg;
