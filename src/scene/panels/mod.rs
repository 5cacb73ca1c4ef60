//! One shape for all panels of a mesh.
//!
//! | file | holds |
//! |---|---|
//! | `request` | the shapes on offer, the request for one of them, changes of the mesh that help |
//! | `forecast` | forecast of how far the mesh will move |

mod forecast;
mod request;

pub use forecast::{Forecast, ForecastOfKind, HowFar};
pub(crate) use request::all_faces;
pub use request::{
    MeshSuggestion, PanelOffer, is_mostly_triangles, offers_new_panels, panel_adjective,
    panel_offers, panel_suggestion, problem_suggestion,
};
