//! What is tried on a copy of the session, beside whatever is done to it.
//!
//! | file | holds |
//! |---|---|
//! | `exact_trial` | what it would cost to be exact |
//! | `remedies` | changes that help where constraints are not met |
//! | `unfolding` | a tolerance within which no face is folded |

mod exact_trial;
mod remedies;
mod unfolding;

pub use exact_trial::{ExactOffer, ExactTrial, Price};
pub use remedies::{Remedies, Remedy};
pub use unfolding::{Unfolded, Unfolding};
