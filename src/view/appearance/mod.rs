//! Colours of faces, lines and dots.

pub mod bands;
pub mod colour_map;
pub mod face_values;
pub mod palette;
pub mod row_colours;
pub mod value_axis;
pub mod value_spread;

pub use bands::Bands;
pub use colour_map::{ColourMap, TEXELS};
pub use face_values::{Appearance, FaceColour};
pub use palette::{
    Colour, DARK, DOT_KINDS, Dot, DotKind, LIGHT, LINE_KINDS, LineKind, Palette, Stroke,
};
pub use row_colours::RowColours;
pub use value_axis::{ColourScale, ValueAxis};
pub use value_spread::{Bars, Coloured, RangeChoice, ValueSpread};
