//! Panels laid out on one shape, again and again: what a changed wish leaves as it was is kept.

use super::layout::Layout;
use super::{LayoutSettings, PanelLayout};
use crate::mesh::{Mesh, Topology};
use crate::quads::{Boundary, MapOptions, RemeshError, RemeshObserver, Remesher};
use crate::scene::SceneError;
use std::rc::Rc;

/// Panels are cut at the boundary without a wish if they then move at most this fraction as far.
const CUT_MOVES: f64 = 0.5;

/// Layouts of panels on one shape: the shape with its measured curvature, its fields and maps, and the
/// last layout of each choice at the boundary. To be dropped when the shape changes.
pub struct PanelLayouts {
    shape: Mesh,
    units: String,
    has_boundary: bool,
    remesher: Remesher,
    /// The last layouts with what they were asked for: one of each choice at the boundary.
    last: Vec<(MapOptions, Rc<Layout>)>,
}

impl PanelLayouts {
    /// Measures the curvature of a shape; `units` is the symbol of its unit.
    pub(super) fn new(shape: Mesh, units: &str) -> Result<PanelLayouts, SceneError> {
        let remesher = Remesher::new(&shape).map_err(refused)?;
        let has_boundary = !Topology::new(&shape).boundary_loops().is_empty();
        let units = units.to_owned();
        Ok(PanelLayouts { shape, units, has_boundary, remesher, last: Vec::new() })
    }

    /// Lays out panels along the lines of curvature. The result does not depend on what was asked
    /// before.
    ///
    /// # Errors
    /// If panels of this size cannot cover the surface, or if `observer` cancels.
    pub fn lay_out(
        &mut self,
        settings: &LayoutSettings,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<PanelLayout, SceneError> {
        let followed = settings.boundary.unwrap_or(Boundary::Followed);
        let mut layout = self.layout(settings, followed, observer).map_err(refused)?;
        if settings.boundary.is_none() && self.has_boundary && layout.moves_a_lot() {
            // Panels that are cut may move less. What cannot be cut stays followed.
            match self.layout(settings, Boundary::Cut, observer) {
                Err(RemeshError::Cancelled) => return Err(refused(RemeshError::Cancelled)),
                Ok(cut) if cut.move_length() <= CUT_MOVES * layout.move_length() => layout = cut,
                _ => {}
            }
        }
        Ok(layout.shown(&self.shape, &self.units))
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
        let remeshed = self.remesher.remesh(&options, &self.units, observer)?;
        let layout = Rc::new(Layout::new(remeshed, boundary));
        self.last.retain(|(asked, _)| asked.boundary != boundary);
        self.last.push((options, Rc::clone(&layout)));
        Ok(layout)
    }
}

fn refused(error: RemeshError) -> SceneError {
    SceneError { path: String::new(), message: error.to_string() }
}
