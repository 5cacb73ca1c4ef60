//! Trials that do not change the session.
//!
//! | file | holds |
//! |---|---|
//! | `exact_trial` | the cost of exactness |
//! | `suggestions` | edits that help if constraints are not met |
//! | `better_press` | presses for panels that end better |

mod better_press;
mod exact_trial;
mod suggestions;

pub use better_press::{BetterPress, BetterPresses, VerdictReport};
pub use exact_trial::{Cost, ExactOffer, ExactShape, ExactTrial};
pub use suggestions::{Suggestion, Suggestions};
