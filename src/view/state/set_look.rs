//! Setters of how a view looks: colours and marks of faces, theme, switches.

use super::ViewState;
use super::parts::Display;
use crate::view::appearance::{Appearance, Colour, DARK, LIGHT, Palette};

impl ViewState {
    /// Returns the values and marks of faces and vertices.
    pub fn appearance(&self) -> &Appearance {
        &self.look.appearance
    }

    /// Returns which parts of the view are switched on.
    pub fn display(&self) -> Display {
        self.look.display
    }

    /// Returns whether the theme is dark.
    pub fn is_dark(&self) -> bool {
        self.look.dark
    }

    /// Returns the colours of the theme.
    pub fn palette(&self) -> &'static Palette {
        if self.look.dark { &DARK } else { &LIGHT }
    }

    /// Returns the background colour.
    pub fn background(&self) -> Colour {
        match self.look.background {
            Some(grey) => [grey, grey, grey, 1.0],
            None => self.palette().background,
        }
    }

    /// Returns whether the background is plain grey, as for a picture that is cut out.
    pub fn has_plain_background(&self) -> bool {
        self.look.background.is_some()
    }

    /// Selects the light or the dark theme.
    pub fn set_dark(&mut self, dark: bool) {
        self.changes.view |= dark != self.look.dark;
        self.look.dark = dark;
    }

    /// Sets a grey background, from 0 (black) to 1 (white), or the background of the theme.
    pub fn set_background(&mut self, grey: Option<f32>) {
        self.changes.view |= grey != self.look.background;
        self.look.background = grey;
    }

    /// Returns the strength of the ambient occlusion, from 0 (none) to 1.
    pub fn occlusion(&self) -> f32 {
        self.look.occlusion
    }

    /// Sets the strength of the ambient occlusion, from 0 (none) to 1.
    pub fn set_occlusion(&mut self, amount: f32) {
        let amount = amount.clamp(0.0, 1.0);
        self.changes.view |= amount != self.look.occlusion;
        self.look.occlusion = amount;
    }

    /// Switches parts of the view on and off.
    pub fn set_display(&mut self, display: Display) {
        self.changes.view |= display != self.look.display;
        self.look.display = display;
        self.keep_reach();
    }

    /// Returns the values of faces and their colours, to be changed.
    pub fn appearance_mut(&mut self) -> &mut Appearance {
        self.changes.appearance = true;
        &mut self.look.appearance
    }

    /// Returns the marks of faces and vertices, to be changed: other dots and lines may be drawn then.
    pub fn marks_mut(&mut self) -> &mut Appearance {
        self.changes.marks = true;
        self.appearance_mut()
    }

    /// Copies the marks of faces and the map of `model`, if they have changed.
    pub fn follow_marks(&mut self, model: &ViewState) {
        if model.changes.appearance {
            self.appearance_mut().mark_as(&model.look.appearance);
        }
    }
}
