//! How a view looks, and its setters: colours and marks of faces, theme, switches.

use super::parts::Display;
use super::view_state::ViewState;
use crate::view::appearance::{
    Appearance, Colour, ColourScale, DARK, LIGHT, MapChoice, Palette, RowColours,
};
use crate::view::model::ViewError;

impl ViewState {
    /// Values and marks of faces and vertices.
    pub fn appearance(&self) -> &Appearance {
        &self.look.appearance
    }

    /// The colour of the members of a constraint, three parts from 0 to 1.
    pub fn tint(&self) -> [f32; 3] {
        self.look.tint
    }

    /// The parts of the view that are switched on.
    pub fn display(&self) -> Display {
        self.look.display
    }

    /// Whether the theme is dark.
    pub fn is_dark(&self) -> bool {
        self.look.dark
    }

    /// The colours of the theme.
    pub fn palette(&self) -> &'static Palette {
        if self.look.dark { &DARK } else { &LIGHT }
    }

    /// The colour behind everything.
    pub fn background(&self) -> Colour {
        match self.look.ground {
            Some(grey) => [grey, grey, grey, 1.0],
            None => self.palette().background,
        }
    }

    /// Whether everything is on one grey, as for a picture that is cut out.
    pub fn is_on_plain_ground(&self) -> bool {
        self.look.ground.is_some()
    }

    /// Light or dark.
    pub fn set_dark(&mut self, dark: bool) {
        self.changes.view |= dark != self.look.dark;
        self.look.dark = dark;
    }

    /// A grey behind everything, from 0 (black) to 1 (white), or the colours of the theme.
    pub fn set_ground(&mut self, grey: Option<f32>) {
        self.changes.view |= grey != self.look.ground;
        self.look.ground = grey;
    }

    /// How much of it is seen that what is near keeps light off, from 0 to 1.
    pub fn occlusion(&self) -> f32 {
        self.look.occlusion
    }

    /// Shows so much of it that what is near keeps light off, from 0 (none) to 1.
    pub fn set_occlusion(&mut self, amount: f32) {
        let amount = amount.clamp(0.0, 1.0);
        self.changes.view |= amount != self.look.occlusion;
        self.look.occlusion = amount;
    }

    /// Switches parts of the view on and off.
    pub fn set_display(&mut self, display: Display) {
        self.changes.view |= display != self.look.display;
        self.look.display = display;
    }

    /// Colours faces by `values` (#F) on a scale; none is the plain material.
    ///
    /// # Errors
    /// Another number of values than faces.
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

    /// Takes the values of the vertices (#V) whose greatest those of the faces are; bands go through the
    /// faces then.
    ///
    /// # Errors
    /// Another number of values than vertices.
    pub fn set_corner_values(&mut self, values: Option<Vec<f32>>) -> Result<(), ViewError> {
        let (vertices, _) = self.counts();
        self.look.appearance.set_corners(values, vertices)?;
        self.changes.appearance = true;
        Ok(())
    }

    /// Shows values of faces in bands, or gradually.
    pub fn set_in_bands(&mut self, in_bands: bool) {
        self.look.appearance.set_in_bands(in_bands);
        self.changes.appearance = true;
    }

    /// Chooses the map of values when all of them have colours; see [`MapChoice`].
    ///
    /// # Errors
    /// A name that no map has.
    pub fn set_colour_map(&mut self, name: &str, middle: Option<f32>) -> Result<(), ViewError> {
        self.look.appearance.set_map(MapChoice::named(name, middle)?);
        self.changes.appearance = true;
        Ok(())
    }

    /// Gives faces and vertices the colours of the rows that act on them.
    pub fn set_row_colours(&mut self, rows: RowColours) {
        self.look.appearance.rows = rows;
        (self.changes.appearance, self.changes.marks) = (true, true);
    }

    /// Marks vertices and faces as selected, and no others.
    ///
    /// # Errors
    /// An index that names nothing.
    pub fn select(&mut self, vertices: Vec<u32>, faces: Vec<u32>) -> Result<(), ViewError> {
        let counts = self.counts();
        self.look.appearance.select(vertices, faces, counts)?;
        (self.changes.appearance, self.changes.marks) = (true, true);
        Ok(())
    }

    /// Marks vertices and faces as members of a constraint, in a colour (each part 0 to 1), and no others.
    ///
    /// # Errors
    /// An index that names nothing.
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
}
