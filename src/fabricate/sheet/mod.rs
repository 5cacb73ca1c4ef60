//! Sheets: parts with their lines and names, laid out beside each other.
//!
//! | file | holds |
//! |---|---|
//! | `part` | a part to be cut: outline, engraved lines, what it was |
//! | `lettering` | single-line letters |
//! | `label` | names and an arrow inside an outline, where they fit |
//! | `layout` | parts in shelves on as many sheets as it takes |

mod label;
mod layout;
mod lettering;
mod part;

pub(super) use label::upright;
pub use label::{Labels, label};
pub use layout::{Layout, Order, Place, Sheet, SheetSize, lay_out};
pub use lettering::{strokes, text_width};
pub use part::{CutPart, Role};
