//! What a face looks like beside its shape: its value on the colour map, whether it is selected,
//! the colour of the row of constraints that acts on it, whether it is a member of the one that is
//! pointed at. Four bytes per face.

use super::colour_map::texel;
use super::lists::{ViewError, check_indices};
use super::row_colours::RowColours;

/// What the colour of a face stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaceColour {
    /// The material.
    Plain,
    /// A row of constraints: its place among the colours of rows, from 1 on.
    Row(u8),
    /// A value: its texel on the colour map.
    Value(u8),
    /// There should be a value, but it is not a number.
    NoValue,
}

impl FaceColour {
    /// Bytes 0 and 1 of the look of a face.
    fn bytes(self) -> [u8; 2] {
        match self {
            FaceColour::Plain => [0, 0],
            FaceColour::Row(place) => [place, 64],
            FaceColour::Value(texel) => [texel, 127],
            FaceColour::NoValue => [0, 255],
        }
    }
}

/// Values and marks of the faces and vertices.
#[derive(Clone, Debug, Default)]
pub struct Looks {
    /// Per face, or nothing for the plain material.
    values: Option<(Vec<f32>, f32, f32)>,
    /// Selected vertices.
    pub selected_vertices: Vec<u32>,
    /// Selected edges, by their vertices.
    pub selected_edges: Vec<[u32; 2]>,
    selected_faces: Vec<u32>,
    tinted_vertices: Vec<u32>,
    tinted_faces: Vec<u32>,
    /// Colours of the rows of constraints; values go before them.
    pub rows: RowColours,
}

impl Looks {
    /// Colours faces by `values` (#F) between `low` and `high`; `None` is the plain material.
    ///
    /// # Errors
    /// Another number of values than faces.
    pub fn set_values(
        &mut self,
        values: Option<Vec<f32>>,
        low: f32,
        high: f32,
        faces: usize,
    ) -> Result<(), ViewError> {
        if let Some(values) = &values
            && values.len() != faces
        {
            let got = values.len();
            return Err(ViewError::Length { what: "face values", got, expected: faces });
        }
        self.values = values.map(|v| (v, low, high));
        Ok(())
    }

    /// Whether faces are coloured by values.
    pub fn has_values(&self) -> bool {
        self.values.is_some()
    }

    /// Marks vertices and faces as selected, and no others.
    ///
    /// # Errors
    /// An index that names nothing.
    pub fn select(
        &mut self,
        vertices: Vec<u32>,
        faces: Vec<u32>,
        (vertex_count, face_count): (usize, usize),
    ) -> Result<(), ViewError> {
        check_indices("selected vertices", &vertices, vertex_count)?;
        check_indices("selected faces", &faces, face_count)?;
        (self.selected_vertices, self.selected_faces) = (vertices, faces);
        Ok(())
    }

    /// Marks vertices and faces as members of a constraint, and no others.
    ///
    /// # Errors
    /// An index that names nothing.
    pub fn tint(
        &mut self,
        vertices: Vec<u32>,
        faces: Vec<u32>,
        (vertex_count, face_count): (usize, usize),
    ) -> Result<(), ViewError> {
        check_indices("tinted vertices", &vertices, vertex_count)?;
        check_indices("tinted faces", &faces, face_count)?;
        (self.tinted_vertices, self.tinted_faces) = (vertices, faces);
        Ok(())
    }

    /// Marks the same vertices and faces as `other`.
    pub fn mark_as(&mut self, other: &Looks) {
        self.selected_vertices.clone_from(&other.selected_vertices);
        self.selected_faces.clone_from(&other.selected_faces);
        self.tinted_vertices.clone_from(&other.tinted_vertices);
        self.tinted_faces.clone_from(&other.tinted_faces);
    }

    /// Tinted vertices that need a dot: where whole faces are tinted, dots would be noise.
    pub fn tinted_dots(&self) -> &[u32] {
        if self.tinted_faces.is_empty() { &self.tinted_vertices } else { &[] }
    }

    /// What the colour of a face stands for.
    pub fn colour_of(&self, face: usize) -> FaceColour {
        if let Some((values, low, high)) = &self.values {
            return texel(values[face], *low, *high).map_or(FaceColour::NoValue, FaceColour::Value);
        }
        match self.rows.faces.get(face) {
            None | Some(0) => FaceColour::Plain,
            Some(&place) => FaceColour::Row(place),
        }
    }

    /// Per face: texel, kind of colour, selected, tinted; #F by 4 bytes.
    pub fn bytes(&self, faces: usize) -> Vec<u8> {
        let mut bytes = vec![0; faces * 4];
        for (face, look) in bytes.chunks_exact_mut(4).enumerate() {
            look[..2].copy_from_slice(&self.colour_of(face).bytes());
        }
        for &face in &self.selected_faces {
            bytes[face as usize * 4 + 2] = 255;
        }
        for &face in &self.tinted_faces {
            bytes[face as usize * 4 + 3] = 255;
        }
        bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_and_marks_end_in_their_bytes() {
        let mut looks = Looks::default();
        looks.set_values(Some(vec![0.0, f32::NAN, 1.0]), 0.0, 1.0, 3).unwrap();
        looks.select(vec![], vec![2], (0, 3)).unwrap();
        looks.tint(vec![], vec![0], (0, 3)).unwrap();
        assert_eq!(looks.bytes(3), [0, 127, 0, 255, 0, 255, 0, 0, 255, 127, 255, 0]);
        looks.set_values(None, 0.0, 1.0, 3).unwrap();
        assert_eq!(looks.bytes(3)[..4], [0, 0, 0, 255]);
    }

    #[test]
    fn colours_of_rows_are_seen_where_there_are_no_values() {
        let rows = RowColours::new(vec![0, 2], vec![], &[0.5; 6], (3, 2)).unwrap();
        let mut looks = Looks { rows, ..Looks::default() };
        assert_eq!(looks.bytes(2), [0, 0, 0, 0, 2, 64, 0, 0]);
        looks.set_values(Some(vec![0.0, 1.0]), 0.0, 1.0, 2).unwrap();
        assert_eq!(looks.bytes(2), [0, 127, 0, 0, 255, 127, 0, 0]);
    }

    #[test]
    fn marks_on_things_that_do_not_exist_are_refused() {
        let mut looks = Looks::default();
        assert!(looks.set_values(Some(vec![1.0]), 0.0, 1.0, 2).is_err());
        assert!(looks.select(vec![4], vec![], (4, 2)).is_err());
        assert!(looks.tint(vec![], vec![2], (4, 2)).is_err());
    }
}
