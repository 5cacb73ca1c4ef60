//! The appearance of a face: its value on the colour map, the colour of the row of constraints that
//! acts on it, whether it is selected, and whether it is a member of the highlighted constraint.
//! Four bytes per face.

use super::bands::Bands;
use super::colour_map::{ColourMap, texel};
use super::row_colours::RowColours;
use super::value_axis::ColourScale;
use crate::view::model::{ViewError, check_indices, check_length};

/// The meaning of the colour of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaceColour {
    /// The material.
    Plain,
    /// A row of constraints: the index of its colour, from 1 on.
    Row(u8),
    /// A value: its texel on the map of all values, or of both signs.
    Value(u8),
    /// A value beyond the tolerance: its texel on the map of such values.
    Beyond(u8),
    /// The value is NaN.
    NoValue,
}

impl FaceColour {
    /// Returns bytes 0 and 1 of the look of a face.
    fn bytes(self) -> [u8; 2] {
        match self {
            FaceColour::Plain => [0, 0],
            FaceColour::Row(colour) => [colour, 64],
            FaceColour::Value(texel) => [texel, 127],
            FaceColour::Beyond(texel) => [texel, 191],
            FaceColour::NoValue => [0, 255],
        }
    }
}

/// Values and marks of the faces and vertices.
#[derive(Clone, Debug, Default)]
pub struct Appearance {
    /// The numbers of vertices and faces.
    counts: (usize, usize),
    /// Values of the faces and their scale, or none for the plain material.
    values: Option<(Vec<f32>, ColourScale)>,
    /// #V, of which each face has the largest as its value; none without vertex values.
    corners: Option<Vec<f32>>,
    in_bands: bool,
    /// The map to use when all values have colours, and the value about which it diverges, if it does.
    map: ColourMap,
    middle: Option<f32>,
    bands: Option<Bands>,
    /// Selected vertices.
    pub selected_vertices: Vec<u32>,
    /// Selected edges, by their vertices.
    pub selected_edges: Vec<[u32; 2]>,
    /// The edges along which a paper model is cut, by their vertices.
    pub seams: Vec<[u32; 2]>,
    selected_faces: Vec<u32>,
    tinted_vertices: Vec<u32>,
    tinted_faces: Vec<u32>,
    /// The colour of tinted faces and vertices, three components from 0 to 1.
    pub tint_colour: [f32; 3],
    /// Colours of the rows of constraints; values take precedence.
    pub rows: RowColours,
}

impl Appearance {
    /// The plain material on as many vertices and faces.
    pub fn new(counts: (usize, usize)) -> Appearance {
        Appearance { counts, ..Appearance::default() }
    }

    /// Colours faces by `values` (#F) on a scale; `None` restores the plain material.
    ///
    /// # Errors
    /// A wrong number of values.
    pub fn set_values(
        &mut self,
        values: Option<Vec<f32>>,
        scale: ColourScale,
    ) -> Result<(), ViewError> {
        if let Some(values) = &values {
            check_length("face values", values.len(), self.counts.1)?;
        }
        self.values = values.map(|values| (values, scale));
        self.update_bands();
        Ok(())
    }

    /// Chooses the map to use when all values have colours; one that diverges does so about `middle`,
    /// and is [`ColourMap::Viridis`] without it.
    pub fn set_map(&mut self, map: ColourMap, middle: Option<f32>) {
        (self.map, self.middle) = (map, middle);
    }

    /// Shows values in bands, or continuously.
    pub fn set_in_bands(&mut self, in_bands: bool) {
        self.in_bands = in_bands;
        self.update_bands();
    }

    /// Sets the values of the vertices (#V) of which each face has the largest. Bands then run
    /// through the faces.
    ///
    /// # Errors
    /// A wrong number of values.
    pub fn set_corners(&mut self, corners: Option<Vec<f32>>) -> Result<(), ViewError> {
        if let Some(corners) = &corners {
            check_length("corner values", corners.len(), self.counts.0)?;
        }
        self.corners = corners;
        Ok(())
    }

    fn update_bands(&mut self) {
        let range = self.values.as_ref().filter(|_| self.in_bands);
        self.bands = range.and_then(|&(_, scale)| Bands::new(scale.axis));
    }

    /// Returns the bands of the values, if they are shown in bands.
    pub fn bands(&self) -> Option<&Bands> {
        self.bands.as_ref()
    }

    /// Returns the band of a face, if each face is in a single band.
    pub fn band_of(&self, face: u32) -> Option<usize> {
        let (values, scale) = self.values.as_ref().filter(|_| self.corners.is_none())?;
        let value = values[face as usize];
        let bands = self.bands.as_ref()?;
        // Values within the tolerance form a band of their own, after the others.
        if scale.is_within(value) { Some(bands.texels.len()) } else { bands.band(value) }
    }

    /// Returns the range in steps from a band limit, if bands run through the faces.
    pub fn corner_steps(&self) -> Option<[f32; 2]> {
        self.corners.as_ref()?;
        Some(self.bands.as_ref()?.range_in_steps())
    }

    /// Returns the value of a vertex in the steps of [`Appearance::corner_steps`], or zero.
    pub fn corner_in_steps(&self, vertex: usize) -> f32 {
        match (&self.bands, &self.corners) {
            (Some(bands), Some(corners)) => bands.in_steps(f64::from(corners[vertex])),
            _ => 0.0,
        }
    }

    /// Returns the tolerance in the steps of [`Appearance::corner_steps`]; zero if there is none.
    pub fn tolerance_in_steps(&self) -> f32 {
        let scale = self.values.as_ref().map(|(_, scale)| scale);
        let tolerance = scale.and_then(|scale| scale.tolerance);
        match (self.corner_steps(), &self.bands, tolerance) {
            (Some(_), Some(bands), Some(tolerance)) => bands.in_steps(f64::from(tolerance)),
            _ => 0.0,
        }
    }

    /// Returns whether faces are coloured by values.
    pub fn has_values(&self) -> bool {
        self.values.is_some()
    }

    /// Returns whether all faces have colours of values; with a tolerance, only those beyond it.
    pub fn has_full_map(&self) -> bool {
        self.has_values() && !matches!(self.map(), ColourMap::Beyond | ColourMap::AroundZero)
    }

    /// Returns the map of the values.
    pub fn map(&self) -> ColourMap {
        match &self.values {
            Some((_, scale)) if scale.is_signed() => ColourMap::AroundZero,
            Some((_, ColourScale { tolerance: Some(_), .. })) => ColourMap::Beyond,
            values => {
                let ColourMap::Diverging(_) = self.map else { return self.map };
                let scale = values.as_ref().map(|(_, scale)| scale);
                let part = scale.and_then(|scale| Some(scale.axis.part(f64::from(self.middle?))));
                part.map_or(ColourMap::Viridis, ColourMap::Diverging)
            }
        }
    }

    /// Sets the selected vertices and faces.
    ///
    /// # Errors
    /// An index out of range.
    pub fn select(&mut self, mut vertices: Vec<u32>, faces: Vec<u32>) -> Result<(), ViewError> {
        check_indices("selected vertices", &vertices, self.counts.0)?;
        check_indices("selected faces", &faces, self.counts.1)?;
        vertices.sort_unstable();
        (self.selected_vertices, self.selected_faces) = (vertices, faces);
        Ok(())
    }

    /// Whether a vertex is selected.
    pub fn is_selected(&self, vertex: u32) -> bool {
        self.selected_vertices.binary_search(&vertex).is_ok()
    }

    /// Marks vertices and faces with a colour.
    ///
    /// # Errors
    /// An index out of range.
    pub fn tint(
        &mut self,
        vertices: Vec<u32>,
        faces: Vec<u32>,
        colour: [f32; 3],
    ) -> Result<(), ViewError> {
        check_indices("tinted vertices", &vertices, self.counts.0)?;
        check_indices("tinted faces", &faces, self.counts.1)?;
        (self.tinted_vertices, self.tinted_faces) = (vertices, faces);
        self.tint_colour = colour;
        Ok(())
    }

    /// Copies the marks of faces and the map of `other`, for a view without dots.
    pub fn mark_as(&mut self, other: &Appearance) {
        (self.map, self.middle) = (other.map, other.middle);
        self.selected_faces.clone_from(&other.selected_faces);
        self.tinted_faces.clone_from(&other.tinted_faces);
        self.tint_colour = other.tint_colour;
    }

    /// Returns the tinted vertices that need a dot; none if whole faces are tinted.
    pub fn tinted_dots(&self) -> &[u32] {
        if self.tinted_faces.is_empty() { &self.tinted_vertices } else { &[] }
    }

    /// Returns the meaning of the colour of a face.
    pub fn colour_of(&self, face: usize) -> FaceColour {
        if let Some((values, scale)) = &self.values {
            let value = values[face];
            let texel = match &self.bands {
                _ if value.is_nan() => None,
                Some(bands) => bands.band(value).map(|band| bands.texels[band]),
                None => Some(texel(scale.axis.part(f64::from(value)))),
            };
            return match texel {
                None => FaceColour::NoValue,
                Some(_) if scale.is_within(value) => FaceColour::Plain,
                Some(texel) if self.map() == ColourMap::Beyond => FaceColour::Beyond(texel),
                Some(texel) => FaceColour::Value(texel),
            };
        }
        match self.rows.faces.get(face) {
            None | Some(0) => FaceColour::Plain,
            Some(&colour) => FaceColour::Row(colour),
        }
    }

    /// Returns texel, kind of colour, selected and tinted for each face; #F by 4 bytes.
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
    use crate::view::appearance::ValueAxis;

    const UNIT: ColourScale = ColourScale {
        axis: ValueAxis { low: 0.0, high: 1.0, logarithmic: false },
        tolerance: None,
    };

    #[test]
    fn within_the_tolerance_faces_keep_the_material() {
        let mut appearance = Appearance::new((1, 5));
        let scale = ColourScale { tolerance: Some(0.2), ..ColourScale::linear(0.2, 1.0) };
        appearance.set_values(Some(vec![0.1, 0.2, 0.21, 1.0, f32::NAN]), scale).unwrap();
        let colours = [0, 1, 2, 3, 4].map(|face| appearance.colour_of(face));
        assert_eq!(colours[..2], [FaceColour::Plain, FaceColour::Plain]);
        assert_eq!(colours[3..], [FaceColour::Beyond(255), FaceColour::NoValue]);
        assert!(matches!(colours[2], FaceColour::Beyond(_)));
        assert!(appearance.has_values() && !appearance.has_full_map());
        assert_eq!(appearance.bytes(5)[12..14], [255, 191]);
        // A line separates values within the tolerance from the first band beyond it.
        appearance.set_in_bands(true);
        assert_eq!(appearance.band_of(0), appearance.band_of(1));
        assert_ne!(appearance.band_of(1), appearance.band_of(2));
        assert_eq!(appearance.colour_of(1), FaceColour::Plain);
        appearance.set_corners(Some(vec![0.2])).unwrap();
        assert_eq!(appearance.tolerance_in_steps(), appearance.corner_in_steps(0));
    }

    #[test]
    fn a_diverging_map_turns_where_its_middle_is_in_the_range() {
        let mut appearance = Appearance::new((0, 1));
        assert_eq!(appearance.map(), ColourMap::Viridis);
        appearance.set_map(ColourMap::Diverging(0.5), Some(2.5));
        appearance.set_values(Some(vec![1.0]), ColourScale::linear(0.0, 10.0)).unwrap();
        assert_eq!(appearance.map(), ColourMap::Diverging(0.25));
        assert!(appearance.has_full_map());
        // Values within a tolerance keep the material, whatever the map.
        let scale = ColourScale { tolerance: Some(2.5), ..ColourScale::linear(2.5, 10.0) };
        appearance.set_values(Some(vec![1.0]), scale).unwrap();
        assert_eq!(appearance.map(), ColourMap::Beyond);
    }

    #[test]
    fn values_and_marks_end_in_their_bytes() {
        let mut appearance = Appearance::new((0, 3));
        appearance.set_values(Some(vec![0.0, f32::NAN, 1.0]), UNIT).unwrap();
        appearance.select(vec![], vec![2]).unwrap();
        appearance.tint(vec![], vec![0], [0.0; 3]).unwrap();
        assert_eq!(appearance.bytes(3), [0, 127, 0, 255, 0, 255, 0, 0, 255, 127, 255, 0]);
        appearance.set_values(None, UNIT).unwrap();
        assert_eq!(appearance.bytes(3)[..4], [0, 0, 0, 255]);
    }

    #[test]
    fn in_bands_values_of_one_band_look_alike() {
        let mut appearance = Appearance::new((3, 4));
        let to_ten = ColourScale::linear(0.0, 10.0);
        appearance.set_values(Some(vec![0.1, 1.9, 2.1, f32::NAN]), to_ten).unwrap();
        assert_ne!(appearance.colour_of(0), appearance.colour_of(1));
        appearance.set_in_bands(true);
        assert_eq!(appearance.colour_of(0), appearance.colour_of(1));
        assert_ne!(appearance.colour_of(1), appearance.colour_of(2));
        assert_eq!(appearance.colour_of(3), FaceColour::NoValue);
        assert_eq!([0, 2, 3].map(|face| appearance.band_of(face)), [Some(0), Some(1), None]);
        assert_eq!(appearance.corner_steps(), None);
        assert!(appearance.set_corners(Some(vec![0.0; 2])).is_err());
        appearance.set_corners(Some(vec![0.0, 2.0, f32::NAN])).unwrap();
        let [begins, ends] = appearance.corner_steps().unwrap();
        assert_eq!((ends - begins, appearance.corner_in_steps(1)), (5.0, begins + 1.0));
        assert_eq!(appearance.corner_in_steps(2), begins);
        assert_eq!(appearance.band_of(0), None);
    }

    #[test]
    fn values_of_both_signs_lie_around_the_middle_of_a_map_of_their_own() {
        let mut appearance = Appearance::new((0, 4));
        let scale = ColourScale::linear(-2.0, 2.0);
        appearance.set_values(Some(vec![-2.0, 0.0, 5.0, f32::NAN]), scale).unwrap();
        let colours = [0, 1, 2, 3].map(|face| appearance.colour_of(face));
        let [low, middle, high] = [0, 128, 255].map(FaceColour::Value);
        assert_eq!(colours, [low, middle, high, FaceColour::NoValue]);
        assert_eq!(appearance.map(), ColourMap::AroundZero);
        // Its edges are not those of a full map.
        assert!(!appearance.has_full_map());
    }

    #[test]
    fn colours_of_rows_are_seen_where_there_are_no_values() {
        let rows = RowColours::new(vec![0, 2], vec![], &[0.5; 6], (3, 2)).unwrap();
        let mut appearance = Appearance { rows, ..Appearance::new((3, 2)) };
        assert_eq!(appearance.bytes(2), [0, 0, 0, 0, 2, 64, 0, 0]);
        appearance.set_values(Some(vec![0.0, 1.0]), UNIT).unwrap();
        assert_eq!(appearance.bytes(2), [0, 127, 0, 0, 255, 127, 0, 0]);
    }

    #[test]
    fn marks_on_things_that_do_not_exist_are_refused() {
        let mut appearance = Appearance::new((4, 2));
        assert!(appearance.set_values(Some(vec![1.0]), UNIT).is_err());
        assert!(appearance.select(vec![4], vec![]).is_err());
        assert!(appearance.tint(vec![], vec![2], [0.0; 3]).is_err());
    }
}
