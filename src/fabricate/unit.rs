//! The unit of the mesh: a wrong one makes every part wrong, so an unknown one is refused.

use super::fault::Fault;
use crate::words::{LengthUnit, UNITS};

/// The unit of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct LengthInMetres {
    /// Symbol, such as `m`.
    pub symbol: String,
    /// Length in metres.
    pub metres: f64,
}

impl LengthInMetres {
    /// The unit with this symbol; metres for an empty one, of a file that has no unit.
    ///
    /// # Errors
    /// If it is none of [`UNITS`].
    pub fn of(symbol: &str) -> Result<LengthInMetres, Fault> {
        let unit = if symbol.is_empty() { Some(UNITS[0]) } else { LengthUnit::of(symbol) };
        let unit = unit.ok_or_else(|| Fault::unknown_unit(symbol))?;
        Ok(LengthInMetres { symbol: unit.symbol.to_owned(), metres: unit.metres })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_that_is_not_known_is_no_metre() {
        assert_eq!(LengthInMetres::of("in").map(|unit| unit.metres), Ok(0.0254));
        assert_eq!(LengthInMetres::of("").map(|unit| unit.symbol), Ok("m".to_owned()));
        for symbol in ["inches", "M", "km", " m"] {
            let fault = LengthInMetres::of(symbol).unwrap_err();
            assert!(
                fault.0.contains(symbol) && fault.0.contains("m or cm or mm or ft or in"),
                "{fault}"
            );
        }
    }
}
