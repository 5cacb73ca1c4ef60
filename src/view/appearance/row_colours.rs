//! The colours of the rows of constraints, and which of them each face and each vertex has.

use crate::view::model::{ViewError, check_length};

/// Maximum number of colours: indices into the palette are bytes, and 0 is no colour.
pub const MOST_COLOURS: usize = 255;

/// Fraction of its colour that is mixed into the material of a face, so that shape stays readable.
pub const STRENGTH: f32 = 0.36;

/// A palette and indices into it; initially nothing has a colour.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RowColours {
    /// For each face 0, or an index into the palette plus one; empty if no face has a colour.
    pub faces: Vec<u8>,
    /// The same for each vertex.
    pub vertices: Vec<u8>,
    /// sRGB, components from 0 to 1.
    pub palette: Vec<[f32; 3]>,
}

impl RowColours {
    /// Creates the colours from indices per face (#F) and per vertex (#V), 0 for none, and the
    /// palette, #colours by 3. Empty indices mean no colours.
    ///
    /// # Errors
    /// Arrays that do not fit together, or an index outside the palette.
    pub fn new(
        faces: Vec<u8>,
        vertices: Vec<u8>,
        palette: &[f32],
        (vertex_count, face_count): (usize, usize),
    ) -> Result<RowColours, ViewError> {
        let (palette, rest) = palette.as_chunks::<3>();
        if !rest.is_empty() || palette.len() > MOST_COLOURS {
            let (got, expected) = (palette.len() * 3 + rest.len(), palette.len().min(MOST_COLOURS));
            return Err(ViewError::Length { what: "palette", got, expected: expected * 3 });
        }
        for (what, colours, expected) in [
            ("colours of faces", &faces, face_count),
            ("colours of vertices", &vertices, vertex_count),
        ] {
            if !colours.is_empty() {
                check_length(what, colours.len(), expected)?;
            }
            if let Some(&colour) =
                colours.iter().find(|&&colour| usize::from(colour) > palette.len())
            {
                let count = palette.len() + 1;
                return Err(ViewError::Index { what, index: u32::from(colour), count });
            }
        }
        Ok(RowColours { faces, vertices, palette: palette.to_vec() })
    }

    /// Returns the vertices that have a colour, each with its index.
    pub fn dots(&self) -> impl Iterator<Item = (u32, u8)> + '_ {
        (0..).zip(self.vertices.iter().copied()).filter(|&(_, colour)| colour > 0)
    }
}

/// Returns a palette as RGBA bytes for indices below `count`, 0 for none; opacity is [`STRENGTH`].
pub fn texels(palette: &[[f32; 3]], count: usize) -> Vec<u8> {
    let mut texels = vec![0; count * 4];
    for (texel, colour) in texels.chunks_exact_mut(4).skip(1).zip(palette) {
        for (byte, part) in texel.iter_mut().zip(colour.iter().chain([&STRENGTH])) {
            *byte = (part * 255.0).round() as u8;
        }
    }
    texels
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_come_out_as_they_went_in() {
        let palette = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        let colours = RowColours::new(vec![2, 0], vec![0, 1, 0, 2], &palette, (4, 2)).unwrap();
        assert_eq!(colours.dots().collect::<Vec<_>>(), [(1, 1), (3, 2)]);
        assert_eq!(
            texels(&colours.palette, 4),
            [0, 0, 0, 0, 255, 0, 0, 92, 0, 0, 255, 92, 0, 0, 0, 0]
        );
        assert!(RowColours::new(vec![], vec![], &[], (4, 2)).is_ok());
    }

    #[test]
    fn what_does_not_fit_is_refused_by_name() {
        let refused = |faces: &[u8], vertices: &[u8], palette: &[f32]| {
            RowColours::new(faces.to_vec(), vertices.to_vec(), palette, (3, 2))
                .unwrap_err()
                .to_string()
        };
        let red = [1.0, 0.0, 0.0];
        assert_eq!(refused(&[1], &[], &red), "colours of faces: 1 entries, expected 2");
        assert_eq!(
            refused(&[], &[0, 0, 2], &red),
            "colours of vertices: found 2, expected an index below 2"
        );
        assert_eq!(refused(&[], &[], &red[..2]), "palette: 2 entries, expected 0");
        assert_eq!(refused(&[], &[], &[0.5; 256 * 3]), "palette: 768 entries, expected 765");
    }
}
