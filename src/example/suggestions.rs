//! Views suggested for some examples: hosts show a button for each, and need not know the examples.

use serde::Serialize;

/// A suggested view of an example.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Suggestion {
    /// The label of the button.
    pub label: &'static str,
    /// The view that the button opens.
    pub shows: Shows,
}

/// A view that a host can show.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub enum Shows {
    /// Two pictures side by side: left and right.
    Split([SplitSide; 2]),
    /// A plot, by its id.
    Plot(&'static str),
}

/// One of two pictures side by side.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct SplitSide {
    /// The id of the measure that colours its faces.
    pub measure: &'static str,
    /// Whether to show the original instead of the current shape.
    pub original: bool,
}

const fn before_and_after(measure: &'static str) -> Shows {
    Shows::Split([SplitSide { measure, original: true }, SplitSide { measure, original: false }])
}

/// The two errors of Fig. 5.
const BOTH_ERRORS: Suggestion = Suggestion {
    label: "e_p beside e_c",
    shows: Shows::Split([
        SplitSide { measure: "e-p", original: false },
        SplitSide { measure: "e-c", original: false },
    ]),
};
const PLANARITY: Suggestion =
    Suggestion { label: "Before and after", shows: before_and_after("e-p") };
const CIRCULARITY: Suggestion =
    Suggestion { label: "Before and after", shows: before_and_after("e-c") };
const ANGLES: Suggestion =
    Suggestion { label: "Angles before and after", shows: Shows::Plot("angles") };

/// The suggestions for the example `id`.
pub fn suggestions(id: &str) -> &'static [Suggestion] {
    match id {
        "fig-05-planar" => &[PLANARITY, BOTH_ERRORS],
        "fig-05-circular" | "fig-05-mixed" => &[CIRCULARITY, BOTH_ERRORS],
        "fig-07-quality" => &[ANGLES],
        _ => &[],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::example::EXAMPLES;
    use crate::session::FACE_MEASURES;

    #[test]
    fn examples_offer_known_measures() {
        let mut offered = 0;
        for example in EXAMPLES {
            for suggestion in suggestions(example.id) {
                offered += 1;
                if let Shows::Split(sides) = suggestion.shows {
                    let is_known =
                        |side: &SplitSide| FACE_MEASURES.iter().any(|m| m.id == side.measure);
                    assert!(sides.iter().all(is_known), "{}", example.id);
                }
            }
        }
        assert_eq!(offered, 7, "every one is of an example");
    }
}
