//! Plots suggested for some examples: hosts show a button for each, and need not know the examples.

use serde::Serialize;

/// A suggested plot of an example.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Suggestion {
    /// The label of the button.
    pub label: &'static str,
    /// The id of the plot that the button opens.
    pub plot: &'static str,
}

const ANGLES: Suggestion = Suggestion { label: "Angles before and after", plot: "angles" };

/// The suggestions for the example `id`.
pub fn suggestions(id: &str) -> &'static [Suggestion] {
    match id {
        "fig-07-quality" => &[ANGLES],
        _ => &[],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example::EXAMPLES;

    #[test]
    fn every_suggestion_is_of_an_example() {
        let offered = EXAMPLES.iter().map(|example| suggestions(example.id).len()).sum::<usize>();
        assert_eq!(offered, 1);
    }
}
