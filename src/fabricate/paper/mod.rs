//! Paper models: panels laid flat side by side as strips and nets, folded along their edges, and
//! glued with tabs that are hidden behind the neighbour.
//!
//! | file | holds |
//! |---|---|
//! | `facet` | flat facets in mm and the joints between them; a panel that is not flat is creased |
//! | `strip` | the order in which joints are folded: along strips, or by their fold angle |
//! | `overlap` | whether convex polygons overlap |
//! | `motion` | motions of the plane |
//! | `net` | facets placed in the plane, piece by piece |
//! | `tab` | hidden tabs, where they have room |
//! | `tab_name` | the name on a tab |
//! | `grow` | growth of pieces by folded joints |
//! | `model` | the model: pieces with their tabs |
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

pub(super) use drawn::FLAT;
pub use drawn::{MissingNames, drawn, write_names};
pub use facet::{Facet, Joint};
pub use model::{JointKind, PaperModel, PaperSize};
pub use motion::Motion;
pub use net::{OutlineSide, PaperNet};
pub use tab::Tab;
