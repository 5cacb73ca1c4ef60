//! Sheets: parts with their lines and names, laid out beside each other.
//!
//! | file | holds |
//! |---|---|
//! | `part` | a part to be cut: outline, engraved lines, what it was |
//! | `lettering` | single-line letters |
//! | `label` | names and an arrow inside an outline, where they fit |
//! | `waste` | names beside parts that have no room for them |
//! | `place` | where a part is, and in which order parts are laid out |
//! | `layout` | sheets with parts, and where each part is |
//! | `shelf` | parts in rows, each on its feet or on its head |
//! | `clearance` | how near two parts may come to each other |

mod clearance;
mod label;
mod layout;
mod lettering;
mod part;
mod place;
mod shelf;
mod waste;

pub(super) use label::upright;
pub use label::{Inscription, Labels, label};
pub use layout::{Layout, Sheet, lay_out};
pub use lettering::{strokes, text_width};
pub use part::{CutPart, Hole, NamePlace, Role};
pub use place::{Order, Place, SheetSize};
pub use waste::Waste;
