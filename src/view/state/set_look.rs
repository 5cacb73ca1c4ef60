//! Setters of how a view looks: colours and marks of faces, theme, switches.

use super::ViewState;
use super::parts::Display;
use crate::view::appearance::{
    Appearance, Colour, ColourMap, ColourScale, DARK, LIGHT, Palette, RowColours,
};
use crate::view::model::ViewError;

impl ViewState {
    /// Returns the values and marks of faces and vertices.
    pub fn appearance(&self) -> &Appearance {
        &self.look.appearance
    }

    /// Returns the colour of marked members of a constraint, three components from 0 to 1.
    pub fn tint(&self) -> [f32; 3] {
        self.look.tint
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

    /// Colours faces by `values` (#F) on a scale; `None` restores the plain material.
    ///
    /// # Errors
    /// A wrong number of values.
    pub fn set_face_values(
        &mut self,
        values: Option<Vec<f32>>,
        scale: ColourScale,
    ) -> Result<(), ViewError> {
        let (_, faces) = self.counts();
        self.look.appearance.set_values(values, scale, faces)?;
        self.changes.appearance = true;
        Ok(())
    }

    /// Sets the values of the vertices (#V) of which each face has the largest. Bands then run
    /// through the faces.
    ///
    /// # Errors
    /// A wrong number of values.
    pub fn set_corner_values(&mut self, values: Option<Vec<f32>>) -> Result<(), ViewError> {
        let (vertices, _) = self.counts();
        self.look.appearance.set_corners(values, vertices)?;
        self.changes.appearance = true;
        Ok(())
    }

    /// Shows values of faces in bands, or continuously.
    pub fn set_in_bands(&mut self, in_bands: bool) {
        self.look.appearance.set_in_bands(in_bands);
        self.changes.appearance = true;
    }

    /// Sets the colour map for values on all faces; see [`ColourMap::named`].
    ///
    /// # Errors
    /// An unknown name of a map.
    pub fn set_colour_map(&mut self, name: &str, middle: Option<f32>) -> Result<(), ViewError> {
        self.look.appearance.set_map(ColourMap::named(name)?, middle);
        self.changes.appearance = true;
        Ok(())
    }

    /// Colours faces and vertices by the rows of constraints that act on them.
    pub fn set_row_colours(&mut self, rows: RowColours) {
        self.look.appearance.rows = rows;
        (self.changes.appearance, self.changes.marks) = (true, true);
    }

    /// Sets the selected vertices and faces.
    ///
    /// # Errors
    /// An index out of range.
    pub fn select(&mut self, vertices: Vec<u32>, faces: Vec<u32>) -> Result<(), ViewError> {
        let counts = self.counts();
        self.look.appearance.select(vertices, faces, counts)?;
        (self.changes.appearance, self.changes.marks) = (true, true);
        Ok(())
    }

    /// Marks vertices and faces with a colour, whose components are from 0 to 1.
    ///
    /// # Errors
    /// An index out of range.
    pub fn set_tint(
        &mut self,
        vertices: Vec<u32>,
        faces: Vec<u32>,
        colour: [f32; 3],
    ) -> Result<(), ViewError> {
        let counts = self.counts();
        self.look.appearance.tint(vertices, faces, counts)?;
        self.look.tint = colour;
        (self.changes.appearance, self.changes.marks) = (true, true);
        Ok(())
    }

    /// Copies marks and tint of `model`, if they have changed.
    pub fn follow_marks(&mut self, model: &ViewState) {
        if model.changes.appearance {
            self.look.appearance.mark_as(&model.look.appearance);
            self.look.tint = model.look.tint;
            self.changes.appearance = true;
        }
    }
}
