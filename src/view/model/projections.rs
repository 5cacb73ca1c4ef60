//! The projections of constraints: points near vertices, outlines between points, and arrows.

use super::error::ViewError;
use super::lists::{check_indices, check_length};
use glam::Vec3;

/// Maximum number of points drawn: the table that the shaders read has no room for more.
pub const MOST_POINTS: usize = 1 << 20;

/// A projected point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProjectedPoint {
    /// The vertex of which it is the projection.
    pub vertex: u32,
    /// Displacement from the vertex to the point; relative, to keep its digits far from the origin.
    pub displacement: Vec3,
    /// Index of its colour in the palette, plus one.
    pub colour: u8,
}

/// All projected points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProjectionMarks {
    /// The points.
    pub points: Vec<ProjectedPoint>,
    /// Pairs of points.
    pub outlines: Vec<[u32; 2]>,
    /// sRGB, components from 0 to 1.
    pub palette: Vec<[f32; 3]>,
}

impl ProjectionMarks {
    /// Creates the marks from the vertex of each point, its displacement from the vertex (#points
    /// by 3), the index of its colour plus one, the outlines as pairs of points, and the palette,
    /// #colours by 3. Keeps only the first [`MOST_POINTS`] points.
    ///
    /// # Errors
    /// Arrays that do not fit together, or an index out of range.
    pub fn new(
        vertices: &[u32],
        displacements: &[f32],
        colours: &[u8],
        outlines: &[u32],
        palette: &[f32],
        vertex_count: usize,
    ) -> Result<ProjectionMarks, ViewError> {
        check_indices("projected vertices", vertices, vertex_count)?;
        check_indices("outlines", outlines, vertices.len())?;
        let count = vertices.len();
        for (what, got, expected) in [
            ("displacements of projections", displacements.len(), count * 3),
            ("colours of projections", colours.len(), count),
            ("outlines", outlines.len(), outlines.len() / 2 * 2),
            ("palette", palette.len(), palette.len() / 3 * 3),
        ] {
            check_length(what, got, expected)?;
        }
        let (displacements, _) = displacements.as_chunks::<3>();
        let (outlines, _) = outlines.as_chunks::<2>();
        let (palette, _) = palette.as_chunks::<3>();
        let known = |&&colour: &&u8| colour == 0 || usize::from(colour) > palette.len();
        if let Some(&colour) = colours.iter().find(known) {
            let (what, index, count) = ("colours of projections", u32::from(colour), palette.len());
            return Err(ViewError::Index { what, index, count: count + 1 });
        }
        let points = vertices.iter().zip(displacements).zip(colours);
        let points = points.take(MOST_POINTS).map(|((&vertex, &displacement), &colour)| {
            // A displacement that is not finite becomes zero, which hides its arrow.
            let displacement = Vec3::from(displacement);
            ProjectedPoint {
                vertex,
                displacement: if displacement.is_finite() { displacement } else { Vec3::ZERO },
                colour,
            }
        });
        let inside = |ends: &&[u32; 2]| ends.iter().all(|&end| (end as usize) < MOST_POINTS);
        Ok(ProjectionMarks {
            points: points.collect(),
            outlines: outlines.iter().filter(inside).copied().collect(),
            palette: palette.to_vec(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_keep_their_ways_and_outlines_their_ends() {
        let displacements = [0.0, 0.0, 1.0, f32::NAN, 0.0, 0.0];
        let found =
            ProjectionMarks::new(&[4, 2], &displacements, &[1, 1], &[0, 1], &[0.5; 3], 5).unwrap();
        assert_eq!(found.points[0], ProjectedPoint { vertex: 4, displacement: Vec3::Z, colour: 1 });
        assert_eq!(found.points[1].displacement, Vec3::ZERO);
        assert_eq!(found.outlines, [[0, 1]]);
    }

    #[test]
    fn what_does_not_fit_is_refused_by_name() {
        let refused =
            |vertices: &[u32], displacements: &[f32], colours: &[u8], outlines: &[u32]| {
                ProjectionMarks::new(vertices, displacements, colours, outlines, &[0.5; 3], 5)
                    .unwrap_err()
                    .to_string()
            };
        assert!(refused(&[5], &[0.0; 3], &[1], &[]).starts_with("projected vertices: found 5"));
        assert!(
            refused(&[0], &[0.0; 4], &[1], &[])
                .starts_with("displacements of projections: 4 entries")
        );
        assert!(refused(&[0], &[0.0; 3], &[2], &[]).starts_with("colours of projections: found 2"));
        assert!(refused(&[0], &[0.0; 3], &[1], &[0, 1]).starts_with("outlines: found 1"));
        assert!(refused(&[0], &[0.0; 3], &[1], &[0]).starts_with("outlines: 1 entries"));
    }
}
