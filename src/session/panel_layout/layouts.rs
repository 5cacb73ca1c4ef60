//! Panels laid out on one shape, again and again: what a changed wish leaves as it was is kept.

use super::layout::Layout;
use super::{BoundaryForecast, LayoutSettings, MarkedPlace, PanelLayout};
use crate::math::Vec3;
use crate::mesh::{Mesh, Surface, Topology};
use crate::quads::{
    Boundary, MapOptions, RemeshError, RemeshNote, RemeshObserver, Remeshed, Remesher,
};
use crate::scene::SceneError;
use std::cell::OnceCell;
use std::rc::Rc;

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

/// The better choice at the boundary, and what came of the other.
struct Best {
    layout: Rc<Layout>,
    /// None if it was not asked for.
    other: Option<Result<Rc<Layout>, RemeshError>>,
}

impl Best {
    /// Says which choice was taken at the boundary, and what the other one comes to; none if one was
    /// wished for, nearly nothing moves, or there is no boundary.
    fn words(&self, units: &str) -> Option<String> {
        let is_cut = self.layout.at_boundary()? == Boundary::Cut;
        Some(match (self.other.as_ref()?, is_cut) {
            (Ok(other), true) if self.layout.covers_more_than(other) => {
                "The panels are cut at the boundary: along it, they would cover less".to_owned()
            }
            (Ok(other), false) if self.layout.covers_more_than(other) => {
                "The panels follow the boundary: cut at it, they would cover less".to_owned()
            }
            (Ok(other), true) => {
                let moves = other.moves(units);
                format!("The panels are cut at the boundary: along it, they would {moves}")
            }
            (Ok(other), false) => {
                let moves = other.moves(units);
                format!("The panels follow the boundary: cut at it, they would {moves}")
            }
            (Err(error), true) => {
                let why = error.words(units);
                format!("The panels are cut at the boundary, since they cannot follow it: {why}")
            }
            (Err(error), false) => {
                let why = error.words(units);
                format!("The panels follow the boundary, since they cannot be cut at it: {why}")
            }
        })
    }
}

impl PanelLayouts {
    /// Layouts on a shape beside some of its faces; `units` is the symbol of its unit.
    pub fn new(shape: Mesh, units: &str, kept: &[u32]) -> PanelLayouts {
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

    /// The shape.
    pub fn shape(&self) -> &Mesh {
        &self.shape
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
        let options = settings.options(&self.shape);
        let best = self.best(&options, settings.boundary, observer).map_err(|error| {
            self.refused_at = error.place();
            SceneError { path: String::new(), message: error.words(&self.units) }
        })?;
        let said = best.words(&self.units);
        Ok(best.layout.shown(self.shown(), &self.units, (self.kept.len(), said)))
    }

    /// The panels of such a layout, for hosts that write them, and what they do at the boundary; none if
    /// the surface is closed. The better choice is taken there unless one is `wished`, and noted.
    ///
    /// # Errors
    /// If panels of this size cannot cover the surface.
    pub fn remesh(
        &mut self,
        options: &MapOptions,
        wished: Option<Boundary>,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<(Remeshed, Option<Boundary>), RemeshError> {
        let best = self.best(options, wished, observer)?;
        let mut remeshed = best.layout.remeshed.clone();
        let said = best.words(&self.units);
        remeshed.notes.extend(said.map(|words| RemeshNote { words, places: Vec::new() }));
        Ok((remeshed, best.layout.at_boundary()))
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
        let options = settings.options(&self.shape);
        let of = |boundary| match self.layout(&options, boundary, observer) {
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

    /// The layout with the wished choice at the boundary; without a wish, that with the better one, or
    /// the only possible one. Better is first of all the one that covers more.
    fn best(
        &mut self,
        options: &MapOptions,
        wished: Option<Boundary>,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<Best, RemeshError> {
        let first = self.layout(options, wished.unwrap_or_default(), observer);
        let staying = self.remesher.as_ref().map_or(0, Remesher::staying);
        let is_enough = first
            .as_ref()
            .is_ok_and(|layout| layout.is_enough() && layout.remeshed.staying <= staying);
        if wished.is_some() || !self.has_boundary || is_enough {
            return Ok(Best { layout: first?, other: None });
        }
        match (first, self.layout(options, Boundary::Cut, observer)) {
            (Err(error), Err(_)) => Err(error),
            // It was asked for only because it could cover more.
            (Ok(layout), cut)
                if layout.is_enough()
                    && !cut.as_ref().is_ok_and(|cut| cut.covers_more_than(&layout)) =>
            {
                Ok(Best { layout, other: None })
            }
            (Ok(layout), Ok(cut)) if cut.is_better_than(&layout) => {
                Ok(Best { layout: cut, other: Some(Ok(layout)) })
            }
            (Ok(layout), cut) => Ok(Best { layout, other: Some(cut) }),
            (followed, Ok(layout)) => Ok(Best { layout, other: Some(followed) }),
        }
    }

    /// The layout with this choice at the boundary: the last one, if it was asked for the same.
    fn layout(
        &mut self,
        options: &MapOptions,
        boundary: Boundary,
        observer: &mut RemeshObserver<'_>,
    ) -> Result<Rc<Layout>, RemeshError> {
        let options = MapOptions { boundary, ..*options };
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
