//! Colours of faces, lines and dots.

pub mod bands;
pub mod colour_map;
pub mod colour_scale;
pub mod face_values;
pub mod palette;
pub mod row_colours;

pub use bands::round_down;
pub use bands::{Bands, Seam, seams};
pub use colour_map::{ColourMap, MapChoice, TEXELS};
pub use colour_scale::ColourScale;
pub use face_values::{Appearance, FaceColour};
pub use palette::{
    Colour, DARK, DOT_KINDS, Dot, DotKind, LIGHT, LINE_KINDS, LineKind, Palette, Stroke,
};
pub use row_colours::RowColours;
