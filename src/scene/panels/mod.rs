//! The same shape for all panels of a mesh.
//!
//! | file | holds |
//! |---|---|
//! | `ask` | which shapes are offered, and the scene that asks for one |
//! | `forecast` | how far the mesh will move for it, said beforehand |

mod ask;
mod forecast;

pub use ask::{PanelOffer, panel_offers};
pub use forecast::{Forecast, ForecastOfKind, HowFar};
