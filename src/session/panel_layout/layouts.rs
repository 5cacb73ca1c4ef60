//! Panels laid out on one shape, again and again: what a changed wish leaves as it was is kept.

use super::layout::Layout;
use super::{BoundaryForecast, LayoutSettings, MarkedPlace, PanelLayout};
use crate::math::Vec3;
use crate::mesh::{Mesh, Surface, Topology};
use crate::quads::{Boundary, MapOptions, RemeshError, RemeshObserver, Remesher};
use crate::scene::SceneError;
use std::cell::OnceCell;
use std::rc::Rc;

/// Panels are cut at the boundary without a wish if they then move at most this fraction as far.
const CUT_MOVES: f64 = 0.5;

/// Radius of the ring around the place of a refusal, relative to the size of the shape.
const RING: f64 = 0.03;

/// Layouts of panels on one shape: the shape with its measured curvature, its fields and maps, and the
/// last layout of each choice at the boundary. To be dropped when the shape changes.
pub struct PanelLayouts {
    shape: Mesh,
    /// The shape without the faces that are left out, with its surface: what lines and places are on.
    shown: OnceCell<(Mesh, Surface)>,
    units: String,
    has_boundary: bool,
    /// The faces that stay as they are.
    kept: Vec<u32>,
    /// From the first question on.
    remesher: Option<Remesher>,
    /// The last layouts with what they were asked for: one of each choice at the boundary.
    last: Vec<(MapOptions, Rc<Layout>)>,
    /// The place of the last refusal.
    refused_at: Option<Vec3<f64>>,
}

impl PanelLayouts {
    /// Layouts on a shape beside some of its faces; `units` is the symbol of its unit.
    pub(super) fn new(shape: Mesh, units: &str, kept: &[u32]) -> PanelLayouts {
        // Faces that stay, or are left out, leave openings.
        let covered = shape.without_faces(&[kept, &shape.faces_left_out(kept)].concat());
        let has_boundary = !Topology::new(&covered).boundary_loops().is_empty();
        PanelLayouts {
            shape,
            shown: OnceCell::new(),
            units: units.to_owned(),
            has_boundary,
            kept: kept.to_vec(),
            remesher: None,
            last: Vec::new(),
            refused_at: None,
        }
    }

    /// The faces that stay as they are.
    pub fn kept(&self) -> &[u32] {
        &self.kept
    }

    /// Lays out panels along the lines of curvature. The result does not depend on what was asked
    /// before.
    ///
    /// # Errors
    /// If panels of this size cannot cover the surface.
    pub fn lay_out(
        &mut self,
        settings: &LayoutSettings,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<PanelLayout, SceneError> {
        self.refused_at = None;
        let layout = self.best(settings, observer).map_err(|error| {
            self.refused_at = error.place();
            SceneError { path: String::new(), message: error.words(&self.units) }
        })?;
        Ok(layout.shown(self.shown(), &self.units, self.kept.len()))
    }

    /// What the panels come to with each choice at the boundary; empty if the surface to be
    /// covered is closed.
    pub fn at_boundaries(
        &mut self,
        settings: &LayoutSettings,
        observer: &mut RemeshObserver<'_>,
    ) -> Vec<BoundaryForecast> {
        if !self.has_boundary {
            return Vec::new();
        }
        let of = |boundary| match self.layout(settings, boundary, observer) {
            Ok(layout) => layout.forecast(&self.units),
            Err(_) => BoundaryForecast { boundary, words: "not possible".to_owned() },
        };
        [Boundary::Followed, Boundary::Cut].map(of).into()
    }

    /// The place of the last refusal, if it has one.
    pub fn refused_at(&self) -> Option<MarkedPlace> {
        let at = self.refused_at?;
        let (shape, surface) = self.shown();
        Some(MarkedPlace::new(at, RING * shape.size(), surface, shape))
    }

    fn shown(&self) -> &(Mesh, Surface) {
        self.shown.get_or_init(|| {
            let shape = self.shape.without_faces(&self.shape.faces_left_out(&self.kept));
            let surface = Surface::of_polygons(&shape.positions, &shape);
            (shape, surface)
        })
    }

    /// The layout that moves less of those with the wished choices at the boundary.
    fn best(
        &mut self,
        settings: &LayoutSettings,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<Rc<Layout>, RemeshError> {
        let wished = settings.boundary.unwrap_or(Boundary::Followed);
        let layout = self.layout(settings, wished, observer)?;
        if settings.boundary.is_some() || !self.has_boundary || layout.hardly_moves() {
            return Ok(layout);
        }
        // Panels that are cut may move less. What cannot be cut stays followed.
        match self.layout(settings, Boundary::Cut, observer) {
            Ok(cut) if cut.move_length() <= CUT_MOVES * layout.move_length() => Ok(cut),
            _ => Ok(layout),
        }
    }

    /// The layout with this choice at the boundary: the last one, if it was asked for the same.
    fn layout(
        &mut self,
        settings: &LayoutSettings,
        boundary: Boundary,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<Rc<Layout>, RemeshError> {
        let options = settings.options(&self.shape, boundary);
        if let Some((_, layout)) = self.last.iter().find(|(asked, _)| *asked == options) {
            return Ok(Rc::clone(layout));
        }
        let remesher = match &mut self.remesher {
            Some(remesher) => remesher,
            none => none.insert(Remesher::beside(&self.shape, &self.kept)?),
        };
        let remeshed = remesher.remesh(&options, &self.units, observer)?;
        let layout = Rc::new(Layout::new(remeshed, boundary));
        self.last.retain(|(asked, _)| asked.boundary != boundary);
        self.last.push((options, Rc::clone(&layout)));
        Ok(layout)
    }
}
