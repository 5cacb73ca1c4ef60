//! One shape for all panels of a mesh.
//!
//! | file | holds |
//! |---|---|
//! | `ask` | the shapes on offer, and the request for one of them |
//! | `forecast` | forecast of how far the mesh will move |

mod ask;
mod forecast;

pub use ask::{PanelOffer, panel_offers};
pub use forecast::{Forecast, ForecastOfKind, HowFar};
