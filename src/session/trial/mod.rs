//! Trials on a copy of the session, which do not disturb it.
//!
//! | file | holds |
//! |---|---|
//! | `exact_trial` | what it would cost to be exact |
//! | `remedies` | changes that help where constraints are not met |

mod exact_trial;
mod remedies;

pub use exact_trial::{ExactOffer, ExactTrial, Price};
pub use remedies::{Remedies, Remedy};
