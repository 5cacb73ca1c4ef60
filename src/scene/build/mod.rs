//! What is to be built from the shape: the key `build` of a scene. The room `fabricate` builds it.
//!
//! | file | holds |
//! |---|---|
//! | `settings` | scale, sheet, joint, distance, and their checks |
//! | `edges` | edges of the mesh among them, and their checks |
//! | `presets` | common materials, machines and sheets |
//! | `choice` | the choices among them, such as products and kinds of offsets |
//! | `page` | the pages of a PDF, and how many of them a sheet is printed on |
//! | `declarations` | the declaration of every setting: name, unit, range, products |
//! | `declared` | what is declared of a setting, and the checks that follow from it |

mod choice;
mod declarations;
mod declared;
mod edges;
mod page;
mod presets;
mod settings;

pub use choice::{Dxf, Fold, Join, Names, OffsetKind, Order, Pieces, Product};
pub use declarations::BUILD_SETTINGS;
pub use declared::{BuildForm, BuildGroup, BuildOption, BuildSetting, BuildUnit};
pub(crate) use edges::ordered;
pub use page::Page;
pub(crate) use page::Tiling;
pub use presets::{BUILD_PRESETS, BuildPreset, PresetOf, PresetValues};
pub use settings::{BuildSettings, CheckLimits};
