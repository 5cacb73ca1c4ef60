//! Units of length. The coordinates of a mesh are never converted: the unit determines how lengths
//! are shown, and lengths that the user types with another unit are converted to that of the mesh.

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthUnit {
    /// Its symbol, as in scene files.
    pub symbol: &'static str,
    /// Its length in metres.
    pub metres: f64,
    /// Its name among the unit systems of Rhino.
    pub rhino: &'static str,
}

impl LengthUnit {
    /// The unit with this symbol, if hosts offer it.
    pub fn of(symbol: &str) -> Option<LengthUnit> {
        UNITS.into_iter().find(|unit| unit.symbol == symbol)
    }
}

const fn unit(symbol: &'static str, metres: f64, rhino: &'static str) -> LengthUnit {
    LengthUnit { symbol, metres, rhino }
}

/// The units that hosts offer, in order. Scenes may use others, which are shown unchanged.
pub const UNITS: [LengthUnit; 5] = [
    unit("m", 1.0, "Meters"),
    unit("cm", 0.01, "Centimeters"),
    unit("mm", 0.001, "Millimeters"),
    unit("ft", 0.3048, "Feet"),
    unit("in", 0.0254, "Inches"),
];
