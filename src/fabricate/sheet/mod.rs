//! Sheets: parts with their lines and names, laid out beside each other.
//!
//! | file | holds |
//! |---|---|
//! | `part` | a part to be cut: outline, engraved lines, its panels |
//! | `lettering` | single-line letters |
//! | `text_box` | the rectangle around a text or a hole |
//! | `label` | names and an arrow inside an outline |
//! | `waste` | names beside parts that have no room for them |
//! | `place` | the position of a part, and the order in which parts are laid out |
//! | `layout` | layout of parts on sheets |
//! | `shelf` | parts in rows, each upright or upside down |
//! | `tiles` | sheets larger than a page, divided into pages |
//! | `clearance` | clearance between two parts |

mod clearance;
mod label;
mod layout;
mod lettering;
mod part;
mod place;
mod shelf;
mod text_box;
mod tiles;
mod waste;

pub(super) use label::upright;
pub use label::{Inscription, Labels, label};
pub use layout::{Layout, Sheet, lay_out};
pub use lettering::{strokes, text_width};
pub use part::{CutPart, Hole, NamePlace, Role};
pub use place::{Place, SheetSize};
pub(super) use tiles::{FREE, OVERLAP, Tile, tiles};
pub use waste::Waste;
