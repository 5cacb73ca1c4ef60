//! Sheets: parts with their lines and names, laid out beside each other.

mod arrow;
mod beside_edge;
mod bitmap;
mod cells;
mod clearance;
mod disc_label;
mod label;
mod layout;
mod lettering;
mod nest;
mod part;
mod shelf;
mod text_box;
mod tiles;
mod waste;

pub use disc_label::{SlotName, label_disc};
pub use label::{Inscription, Labels, label};
pub use layout::{Layout, Sheet, lay_out};
pub(super) use lettering::upright;
pub use lettering::{height_within, in_capitals, strokes, text_width};
pub use part::{CutPart, Hole, NamePlace, Place, Role, SheetSize, circle};
pub(super) use tiles::{Tile, tiles};
pub use waste::Waste;
