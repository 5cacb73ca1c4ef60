//! One shape for all panels of a mesh.
//!
//! | file | holds |
//! |---|---|
//! | `request` | the shapes on offer, and the request for one of them |
//! | `remedy` | changes of the mesh that help |
//! | `forecast` | forecast of how far the mesh will move |

mod forecast;
mod remedy;
mod request;

pub use forecast::{Forecast, ForecastOfKind, HowFar};
pub use remedy::{MeshRemedy, panel_remedy};
pub(crate) use request::all_faces;
pub use request::{PanelOffer, panel_offers};
