//! Paper models: panels laid flat side by side as strips and nets, folded along their edges, glued with tabs that
//! hide behind the neighbour.
//!
//! | file | holds |
//! |---|---|
//! | `triangles` | a polygon as triangles, shortest diagonals first |
//! | `facet` | flat facets in mm and the joints between them; a panel that is not flat is creased |
//! | `strip` | in which order joints are folded: along strips, or by their fold |
//! | `overlap` | whether convex polygons meet |
//! | `motion` | motions of the plane |
//! | `net` | facets placed in the plane, piece by piece |
//! | `tab` | tabs that have room and are hidden |
//! | `tab_name` | the name on a tab |
//! | `grow` | how pieces grow by folded joints |
//! | `model` | all of it: pieces with their tabs |
//! | `drawn` | a piece as a part to be cut: outline, folds, names |

mod drawn;
mod facet;
mod grow;
mod model;
mod motion;
mod net;
mod overlap;
mod strip;
mod tab;
mod tab_name;
mod triangles;

pub use drawn::{Unnamed, drawn, write_names};
pub use facet::{Facet, Joint};
pub use model::{Glue, PaperModel, PaperSize};
pub use motion::Motion;
pub use net::{OutlineSide, PaperNet};
pub use strip::Pieces;
pub use tab::Tab;
