//! New panels along the lines of curvature of the copy, for
//! [`crate::web::worker::Solver::take_panels`].

use super::model_copy::ModelCopy;
use crate::quads::RemeshStage;
use crate::session::{BoundaryForecast, LayoutSettings, PanelLayout, PanelLayouts};
use crate::web::thrown;
use crate::web::values::{AsIs, Js, flat, indices, plain, plains, read};
use js_sys::{Float64Array, Function, Uint32Array};
use serde::Serialize;
use tsify::Tsify;
use wasm_bindgen::prelude::*;

/// Panels on the surface, to draw and to take.
#[derive(Serialize, Tsify)]
pub struct LaidOut {
    #[serde(flatten)]
    layout: PanelLayout,
    /// `#V by 3`.
    positions: AsIs<Float64Array>,
    /// Panel `k` has the corners from `offsets[k]` to `offsets[k + 1]` of `indices`.
    offsets: AsIs<Uint32Array>,
    indices: AsIs<Uint32Array>,
    /// Points of lines over the surface, `#points by 3`.
    points: AsIs<Float64Array>,
    /// Line `k` has the points from `ends[k]` to `ends[k + 1]`.
    ends: AsIs<Uint32Array>,
}

/// The place of a refusal.
#[derive(Serialize, Tsify)]
pub struct RefusedAt {
    /// Points of a line over the surface around it, `#points by 3`.
    points: AsIs<Float64Array>,
    /// The vertices of the mesh around it.
    vertices: AsIs<Uint32Array>,
}

#[wasm_bindgen]
impl ModelCopy {
    /// Lays out panels along the lines of curvature beside the faces `kept`, which stay as they are, and
    /// tells what is being done. Curvature, fields and maps are kept with the copy.
    #[wasm_bindgen(js_name = layOutPanels)]
    pub fn lay_out_panels(
        &mut self,
        settings: Js<LayoutSettings>,
        kept: &[u32],
    ) -> Result<Js<LaidOut>, JsValue> {
        let settings = read(settings)?;
        let told = self.told.clone();
        let layouts = self.panel_layouts(kept)?;
        let layout = layouts.lay_out(&settings, &mut telling(&told)).map_err(thrown)?;
        plain(&LaidOut::of(layout))
    }

    /// What such panels come to with each choice at the boundary; empty if the surface is closed.
    #[wasm_bindgen(js_name = panelsAtBoundaries)]
    pub fn panels_at_boundaries(
        &mut self,
        settings: Js<LayoutSettings>,
        kept: &[u32],
    ) -> Result<Vec<Js<BoundaryForecast>>, JsValue> {
        let settings = read(settings)?;
        let told = self.told.clone();
        let layouts = self.panel_layouts(kept)?;
        plains(&layouts.at_boundaries(&settings, &mut telling(&told)))
    }

    /// The place of the last refusal of panels; undefined if it has none.
    #[wasm_bindgen(js_name = panelsRefusedAt)]
    pub fn panels_refused_at(&self) -> Result<Option<Js<RefusedAt>>, JsValue> {
        let place = self.layouts.as_ref().and_then(PanelLayouts::refused_at);
        let refused = place.map(|place| RefusedAt {
            points: AsIs(flat(&place.ring)),
            vertices: indices(&place.around),
        });
        refused.as_ref().map(plain).transpose()
    }
}

impl ModelCopy {
    /// The layouts beside these faces.
    fn panel_layouts(&mut self, kept: &[u32]) -> Result<&mut PanelLayouts, JsValue> {
        if self.layouts.as_ref().is_some_and(|layouts| layouts.kept() != kept) {
            self.layouts = None;
        }
        Ok(match &mut self.layouts {
            Some(layouts) => layouts,
            none => none.insert(self.session.panel_layouts(kept).map_err(thrown)?),
        })
    }
}

/// Tells each stage once, in words.
fn telling(told: &Function) -> impl FnMut(RemeshStage) {
    let mut last = "";
    move |stage| {
        if last != stage.words() {
            last = stage.words();
            // That nobody listens changes nothing.
            let _ = told.call1(&JsValue::NULL, &last.into());
        }
    }
}

impl LaidOut {
    fn of(layout: PanelLayout) -> LaidOut {
        let faces = &layout.mesh.faces;
        let mut ends = vec![0];
        ends.extend(layout.lines.iter().scan(0, |end, line| {
            *end += line.len() as u32;
            Some(*end)
        }));
        LaidOut {
            positions: AsIs(flat(&layout.mesh.positions)),
            offsets: indices(faces.offsets()),
            indices: indices(faces.indices()),
            points: AsIs(flat(&layout.lines.concat())),
            ends: indices(&ends),
            layout,
        }
    }
}
