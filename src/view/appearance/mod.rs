//! Colours of faces, lines and dots.
//!
//! | file | holds |
//! |---|---|
//! | `face_values` | values, selections and highlights of faces, edges and vertices, and their colours |
//! | `colour_map` | perceptually uniform colour maps |
//! | `colour_scale` | from a value to a position on the map |
//! | `bands` | bands of values, and the lines between them |
//! | `row_colours` | a colour for each row of constraints |
//! | `palette` | colours and widths of lines and dots, for both themes |
//! | `round_length` | round lengths: 1, 2 or 5 times a power of ten |

pub mod bands;
pub mod colour_map;
pub mod colour_scale;
pub mod face_values;
pub mod palette;
pub mod round_length;
pub mod row_colours;

pub use bands::{Bands, Seam, seams};
pub use colour_map::{ColourMap, MapChoice, TEXELS};
pub use colour_scale::ColourScale;
pub use face_values::{Appearance, FaceColour};
pub use palette::{
    Colour, DARK, DOT_KINDS, Dot, DotKind, LIGHT, LINE_KINDS, LineKind, Palette, Stroke,
};
pub use round_length::round_down;
pub use row_colours::RowColours;
