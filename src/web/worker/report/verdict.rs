//! The verdict on the panels, with its words.

use crate::session::{Session, Verdict, VerdictWords};
use serde::Serialize;

/// The verdict on the panels, in numbers and in words.
#[derive(Serialize, tsify::Tsify)]
pub(crate) struct PanelVerdict {
    #[serde(flatten)]
    numbers: Verdict,
    words: VerdictWords,
}

impl PanelVerdict {
    pub(crate) fn of(session: &Session, numbers: Verdict) -> PanelVerdict {
        let words = session.verdict_words(&numbers);
        PanelVerdict { numbers, words }
    }
}
