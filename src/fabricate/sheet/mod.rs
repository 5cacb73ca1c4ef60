//! Sheets: parts with their lines and names, laid out beside each other.

mod bitmap;
mod cells;
mod clearance;
mod label;
mod layout;
mod lettering;
mod nest;
mod part;
mod shelf;
mod text_box;
mod tiles;
mod waste;

pub(super) use label::upright;
pub use label::{Inscription, Labels, label};
pub use layout::{Layout, Sheet, lay_out};
pub use lettering::{height_within, strokes, text_width};
pub use part::{CutPart, Hole, NamePlace, Place, Role, SheetSize};
pub(super) use tiles::{Tile, tiles};
pub use waste::Waste;
