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

const fn unit(symbol: &'static str, metres: f64, rhino: &'static str) -> LengthUnit {
    LengthUnit { symbol, metres, rhino }
}

/// The units that hosts offer, in order. Scenes may use others, which are shown unchanged. A copy
/// of this table for the page is in `www/ui/units.ts`.
pub const UNITS: [LengthUnit; 5] = [
    unit("m", 1.0, "Meters"),
    unit("cm", 0.01, "Centimeters"),
    unit("mm", 0.001, "Millimeters"),
    unit("ft", 0.3048, "Feet"),
    unit("in", 0.0254, "Inches"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_has_the_same_units() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/www/ui/units.ts");
        let mut module = "/** The units of length. `src/scene/units.rs` is their table, and its test writes this file:\n \
            * `UPDATE=1 cargo test --lib units`. */\nexport const UNITS = [\n"
            .to_owned();
        for LengthUnit { symbol, metres, rhino } in UNITS {
            module += &format!("  {{ symbol: '{symbol}', metres: {metres}, rhino: '{rhino}' }},\n");
        }
        module += "];\n";
        if std::env::var_os("UPDATE").is_some() {
            std::fs::write(path, &module).expect("it can be written");
        }
        assert_eq!(std::fs::read_to_string(path).expect("it is there"), module, "see UPDATE");
    }
}
