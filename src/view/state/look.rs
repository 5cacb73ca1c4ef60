//! How a view looks: colours and marks of faces, theme, switches.

use super::parts::Display;
use crate::view::appearance::Appearance;

/// Colours, marks, theme and switches.
#[derive(Debug)]
pub(super) struct Look {
    pub(super) appearance: Appearance,
    /// The colour of the members of a constraint, three parts from 0 to 1.
    pub(super) tint: [f32; 3],
    pub(super) display: Display,
    pub(super) dark: bool,
    /// White behind everything, for figures, instead of the theme's colour.
    pub(super) white: bool,
}

impl Default for Look {
    fn default() -> Self {
        Look {
            appearance: Appearance::default(),
            tint: [0.2, 0.7, 0.3],
            display: Display { edges: true, ..Display::default() },
            dark: false,
            white: false,
        }
    }
}
