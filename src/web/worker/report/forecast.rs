//! The forecast for panels of one shape, in words.

use crate::scene::{Forecast, MeshRemedy};
use serde::Serialize;

/// How far making panels of one shape will move the mesh.
#[derive(Serialize, tsify::Tsify)]
#[tsify(missing_as_null)]
pub(crate) struct ForecastWords {
    words: String,
    /// A change of the mesh that would reduce the move.
    remedy: Option<MeshRemedy>,
}

impl ForecastWords {
    pub(crate) fn of(forecast: &Forecast) -> ForecastWords {
        ForecastWords { words: forecast.words(), remedy: forecast.remedy() }
    }
}
