//! Trials that do not change the session.
//!
//! | file | holds |
//! |---|---|
//! | `exact_trial` | the cost of exactness |
//! | `remedies` | edits that help if constraints are not met |
//! | `suggestions` | presses for panels that end better |

mod exact_trial;
mod remedies;
mod suggestions;

pub use exact_trial::{Cost, ExactOffer, ExactShape, ExactTrial};
pub use remedies::{Remedies, Remedy};
pub use suggestions::{Suggestion, Suggestions};
